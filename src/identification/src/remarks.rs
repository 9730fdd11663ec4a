//! Remarks about the numbers of a model file: numbers of an element that is off, missing numbers, and numbers changed since the fit.

use crate::fit_tables::Identification;
use crate::phrases;
use dashpot_core::Params;
use dashpot_core::parameter::{self, Element, Row};
use dashpot_messages::Sentence;

/// Reports the parameters that a file specifies although their element is off, with a sentence for each element.
///
/// `specified` contains the indices of the parameters in the file. `params` is the damper from the same file.
pub fn idle(specified: &[usize], params: &Params) -> Vec<Sentence> {
    let mut of: Vec<(&str, Vec<&str>)> = Vec::new();
    for row in parameter::table().filter(|row| specified.contains(&row.index)) {
        let Some(element) = row.element().filter(|element| !params.is_on(*element)) else { continue };
        match of.last_mut() {
            Some((name, rows)) if *name == element.name() => rows.push(row.parameter.name),
            _ => of.push((element.name(), vec![row.parameter.name])),
        }
    }
    of.into_iter()
        .map(|(element, rows)| {
            Sentence::from(phrases::IDLE).with("element", element).with_names("names", rows, phrases::COMMA)
        })
        .collect()
}

/// Reports the missing numbers of enabled elements, with a sentence for each element. Missing numbers have their defaults.
///
/// A file may omit numbers of an element. The element is reported if the file omits all of them, or a number that the fit estimated.
pub fn on_defaults(specified: &[usize], params: &Params, known: &Identification) -> Vec<Sentence> {
    let is_known = |name: &str| {
        let is_open = |open: &String| open.split(['[', '@']).next() == Some(name);
        known.intervals.contains_key(name)
            || known.intervals_over_setting.contains_key(name)
            || known.not_identified.iter().any(is_open)
    };
    let of_element = |element: Element| {
        let rows: Vec<Row> =
            parameter::table().filter(|row| row.element() == Some(element) && params.counts(row)).collect();
        let is_missing = |row: &&Row| !specified.contains(&row.index);
        let gives_none = rows.iter().all(|row| is_missing(&row));
        let missing: Vec<&str> = rows
            .iter()
            .filter(is_missing)
            .map(|row| row.parameter.name)
            .filter(|name| gives_none || is_known(name))
            .collect();
        (!missing.is_empty()).then(|| {
            Sentence::from(phrases::ON_DEFAULTS).with("element", element.name()).with_names(
                "names",
                missing,
                phrases::COMMA,
            )
        })
    };
    Element::all().filter(|element| params.is_on(*element)).filter_map(of_element).collect()
}

/// Reports the numbers that lie outside the interval from their fit, because they were changed since the fit. Returns `None` without such
/// numbers.
pub fn edited(names: &[String]) -> Option<Sentence> {
    let named = Sentence::from(phrases::EDITED).with_names("names", names.iter().map(String::as_str), phrases::COMMA);
    (!names.is_empty()).then_some(named)
}

#[cfg(test)]
mod tests {
    use crate::model_file::{ModelFile, of_text};

    fn of(text: &str) -> ModelFile {
        of_text(&format!("format = 1\n{text}"), "m.toml".as_ref()).unwrap()
    }

    #[test]
    fn an_element_without_any_number_and_a_number_that_the_fit_knows_are_missed() {
        let friction = "elements = [\"coulomb_friction\"]\n";
        let all = of(friction).notes();
        assert!(all.len() == 1 && all[0].contains("coulomb_force, coulomb_steepness"), "{all:?}");
        assert_eq!(of(&format!("{friction}coulomb_force = 40\n")).notes(), Vec::<String>::new());
        let fitted =
            format!("{friction}coulomb_force = 40\n[identification.intervals]\ncoulomb_steepness = [200, 300]\n");
        let one = of(&fitted).notes();
        assert!(one.len() >= 1 && one[0].contains("coulomb_steepness") && !one[0].contains("coulomb_force"), "{one:?}");
    }

    #[test]
    fn a_number_outside_its_interval_is_not_the_one_of_the_fit() {
        let text = |gas: f64, force: f64| {
            format!(
                "elements = [\"fv_curve\", \"gas_preload\"]\nfv_velocity = [-1.0, 0.0, 1.0]\nfv_force = [-600.0, 0.0, {force}]\n\
                 gas_force = {gas}\n[identification.intervals]\ngas_force = [90.0, 110.0]\n\
                 fv_force = [[-610.0, -590.0], [0.0, 0.0], [1290.0, 1310.0]]\n[identification.sources]\ngas_force = \"slow tests 90 %\"\n"
            )
        };
        let own = of(&text(100.0, 1300.0));
        assert!(own.edited.is_empty() && own.notes().is_empty() && !own.was_changed());
        let gas = of(&text(500.0, 1300.0));
        assert_eq!(gas.edited, ["gas_force"]);
        assert!(gas.was_changed() && !gas.identification.intervals.contains_key("gas_force"));
        assert!(gas.identification.sources.is_empty() && gas.notes()[0].contains("gas_force"));
        let point = of(&text(100.0, 1700.0));
        assert_eq!(point.edited, ["fv_force[2]"]);
        let crate::model_file::Interval::List(ends) = &point.identification.intervals["fv_force"] else { panic!() };
        assert!(ends[2][0].is_nan() && ends[0] == [-610.0, -590.0]);
    }
}
