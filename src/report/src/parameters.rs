//! The parameters of a model as a table: values, intervals, sources and assumptions.

use super::blocks::{Block, Column, Section, Table};
use crate::cells::Cell;
use crate::numbers::{digits, typographic, with_unit};
use crate::words::Words;

use dashpot_core::Params;
use dashpot_core::list;
use dashpot_core::parameter::{self, Shape};
use dashpot_diagnosis::Diagnosis;
use dashpot_estimation::prior_set::PriorSet;
use dashpot_estimation::priors;
use dashpot_identification::model_file::{Interval, ModelFile};
use dashpot_identification::{Estimate, Fit, Standing};
use dashpot_records::{Reading, reading_unit};

/// A row of the table, for one parameter of a model.
#[derive(Debug, Clone, PartialEq)]
pub struct ParameterRow {
    /// Name of the parameter in the model file.
    pub name: String,
    /// Value, in `unit`.
    pub value: f64,
    /// Unit of the value and its interval.
    pub unit: String,
    /// Lower end of the value's 95 % interval, if known.
    pub low: Option<f64>,
    /// Upper end of the value's 95 % interval, if known.
    pub high: Option<f64>,
    /// Source of the value: identified, measured, default, given.
    pub source: String,
    /// Remark in the last column of the table, unless `assumed` replaces it.
    pub remark: Remark,
    /// Assumption and its source, for a value that the data could not determine.
    pub assumed: Option<String>,
}

/// Remark on a parameter in a table.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Remark {
    /// Meaning of the parameter with this name.
    Meaning(&'static str),
    /// Velocity of a force in the FV table, m/s.
    AtVelocity(f64),
    /// Displacement of a force in the lookup spring, m.
    AtDisplacement(f64),
    /// No remark.
    Nothing,
}

impl Remark {
    fn of(name: &str) -> Remark {
        parameter::find(name).map_or(Remark::Nothing, |row| Remark::Meaning(row.parameter.name))
    }

    /// Formats the remark as text.
    fn said(self, words: &Words) -> String {
        match self {
            Remark::Meaning(name) => words.meaning_of_parameter(name).to_owned(),
            Remark::AtVelocity(v) => {
                words.fill(words.parameter_at, &[("place", &words.number(&format!("{} mm/s", digits(1e3 * v, 4))))])
            }
            Remark::AtDisplacement(x) => {
                words.fill(words.parameter_at, &[("place", &words.number(&format!("{} mm", digits(1e3 * x, 4))))])
            }
            Remark::Nothing => String::new(),
        }
    }
}

/// Formats the assumption about a parameter that the data could not determine, and its source. If the element of the parameter is disabled,
/// the text states the reason `why` instead.
pub fn assumed(name: &str, value: f64, params: &Params, why: Option<&str>, words: &Words) -> String {
    assumed_by(name, value, (params, &PriorSet::default()), why, words)
}

/// Formats the assumption about a parameter of a damper that has its own priors.
fn assumed_by(name: &str, value: f64, (params, own): (&Params, &PriorSet), why: Option<&str>, words: &Words) -> String {
    let Some(row) = parameter::find(name).filter(|row| !matches!(row.parameter.shape, Shape::List(_))) else {
        return words.not_identified.to_owned();
    };
    if !row.element().is_none_or(|element| params.is_on(element)) {
        return match why {
            Some(why) => words.fill(words.not_identified_off, &[("why", why)]),
            None => words.not_identified.to_owned(),
        };
    }
    let is = |other: f64| (value - other).abs() <= 1e-9 * other.abs();
    let prior = priors::PRIORS.iter().find(|prior| *prior.number.row() == row);
    let median = prior.map(|prior| prior.distribution.center());
    let of_damper = own.rows().iter().find(|own| *own.number.row() == row);
    // A value that is neither a prior's center nor the default comes from the fit. It is a compromise between the prior and weak evidence
    // in the records.
    let source = match (prior, median) {
        _ if of_damper.is_some_and(|own| (value / own.center() - 1.0).abs() < NEAR) => {
            words.fill(words.assumed_dimensions, &[("source", of_damper.map_or("", |own| own.facts()))])
        }
        (Some(prior), Some(median)) if is(median) => words.fill(words.assumed_usual, &[("source", prior.citation())]),
        _ if row.parameter.default.first().is_some_and(|default| is(*default)) => words.assumed_default.to_owned(),
        _ => words.assumed_held.to_owned(),
    };
    let value = words.number(&with_unit(value, row.parameter.unit));
    words.fill(words.not_identified_assumed, &[("value", &value), ("source", &source)])
}

/// Builds the table of parameters. Returns `None` without parameters.
pub fn section(parameters: &[ParameterRow], words: &Words) -> Option<Section> {
    if parameters.is_empty() {
        return None;
    }
    let rows = parameters
        .iter()
        .map(|row| {
            // The row has the same digits and the same unit as the notes on this parameter.
            let [low, high] = [row.low, row.high].map(|end| end.unwrap_or(f64::NAN));
            let reading = Reading::new(row.value, low, high, &row.unit);
            let (factor, _) = reading_unit(row.value, &row.unit);
            let cell = |number: f64, text: &str| Cell::number(factor * number, |_| typographic(text));
            let known = |end: Option<f64>, text: &str| end.map_or_else(|| "".into(), |end| cell(end, text));
            vec![
                row.name.as_str().into(),
                cell(row.value, &reading.value),
                reading.unit.as_str().into(),
                known(row.low, &reading.low),
                known(row.high, &reading.high),
                row.source.as_str().into(),
                row.assumed.clone().map_or_else(|| row.remark.said(words), |assumed| assumed).into(),
            ]
        })
        .collect();
    let columns = vec![
        Column::words(words.col_name),
        Column::figures(words.col_value),
        Column::words(words.col_unit),
        Column::figures(words.col_low),
        Column::figures(words.col_high),
        Column::words(words.col_source),
        Column::words(words.col_note),
    ];
    let table = Table { caption: words.parameters_range.to_owned(), columns, rows, sortable: false };
    Some(Section::new("parameters", words.parameters_section, vec![Block::Table(table)]))
}

/// Lists the parameters of the enabled elements of a model file, with the results of its fit.
pub fn of_model(model: &ModelFile, words: &Words) -> Vec<ParameterRow> {
    let id = &model.identification;
    let mut rows = Vec::new();
    for row in parameter::table().filter(|row| row.element().is_some() && model.params.counts(row)) {
        let p = row.parameter;
        let values = model.params.get(&row);
        let interval = id.intervals.get(p.name);
        let missing = id.not_identified.iter().any(|n| n == p.name);
        match (p.shape, interval) {
            (Shape::Choice(_), _) => continue,
            (Shape::Scalar, interval) => {
                let (low, high) = match interval {
                    Some(Interval::Number([low, high])) => (Some(*low), Some(*high)),
                    _ => (None, None),
                };
                // A default value without a result of the fit usually belongs to a form of the element that is not selected, so it is
                // omitted.
                if low.is_none() && !missing && values == p.default {
                    continue;
                }
                rows.push(ParameterRow {
                    name: p.name.to_owned(),
                    value: values[0],
                    unit: p.unit.to_owned(),
                    low,
                    high,
                    // A value that no test determines has no source in the fit.
                    source: id
                        .sources
                        .get(p.name)
                        .filter(|_| !missing)
                        .map_or_else(String::new, |kept| words.say_kept(kept, &id.messages)),
                    remark: Remark::Meaning(p.name),
                    assumed: missing.then(|| assumed(p.name, values[0], &model.params, None, words)),
                });
            }
            (Shape::List(_), Some(Interval::List(pairs))) => {
                for (k, (value, [low, high])) in values.iter().zip(pairs).enumerate() {
                    let place = |list| model.params.list(list).get(k).copied();
                    let at = if row == *list!("fv_force").row() {
                        place(list!("fv_velocity")).map(Remark::AtVelocity)
                    } else if row == *list!("spring_force").row() {
                        place(list!("spring_displacement")).map(Remark::AtDisplacement)
                    } else {
                        None
                    };
                    rows.push(ParameterRow {
                        name: format!("{}[{k}]", p.name),
                        value: *value,
                        unit: p.unit.to_owned(),
                        low: Some(*low),
                        high: Some(*high),
                        source: String::new(),
                        remark: at.unwrap_or(Remark::Nothing),
                        assumed: None,
                    });
                }
            }
            (Shape::List(_), _) => {}
        }
    }
    rows
}

/// Lists the parameters that a fit estimated.
pub fn of_fit(fit: &Fit, words: &Words) -> Vec<ParameterRow> {
    let row = |e: &Estimate| ParameterRow {
        name: e.index.map_or_else(|| e.name.to_owned(), |k| format!("{}[{k}]", e.name)),
        // A parameter that the records do not determine has no value.
        value: if e.standing == Standing::NotIdentified { f64::NAN } else { e.value },
        source: if e.standing == Standing::NotIdentified { String::new() } else { words.say(&e.from) },
        assumed: assumed_of_damper(e, (&fit.params, &fit.priors), words),
        ..of_estimate(e)
    };
    fit.estimates.iter().map(row).collect()
}

/// Lists the parameters of the improved model of a diagnosis.
pub fn of_diagnosis(found: &Diagnosis, words: &Words) -> Vec<ParameterRow> {
    let added = |name: &str| found.findings.iter().find(|f| !f.of_the_rig && f.parameters.contains_key(name));
    let row = |e: &Estimate| ParameterRow {
        source: match added(e.name) {
            _ if e.standing == Standing::NotIdentified => String::new(),
            Some(finding) => words.fill(words.source_added, &[("effect", finding.effect)]),
            None => words.source_refitted.to_owned(),
        },
        assumed: assumed_of_damper(e, (&found.improved, &found.priors), words),
        ..of_estimate(e)
    };
    found.estimates.iter().map(row).collect()
}

fn of_estimate(e: &Estimate) -> ParameterRow {
    ParameterRow {
        name: e.name.to_owned(),
        value: e.value,
        unit: e.unit.to_owned(),
        low: e.low,
        high: e.high,
        source: String::new(),
        remark: Remark::of(e.name),
        assumed: None,
    }
}

/// Largest relative distance of a value from the center of a damper's own prior at which the prior counts as its source.
const NEAR: f64 = 0.1;

/// Formats the assumption about an estimate that the data could not determine. Returns `None` for an estimate that the data determined.
pub fn assumed_of(e: &Estimate, params: &Params, words: &Words) -> Option<String> {
    assumed_of_damper(e, (params, &PriorSet::default()), words)
}

/// Formats the assumption about an estimate of a damper that has its own priors.
pub fn assumed_of_damper(e: &Estimate, of: (&Params, &PriorSet), words: &Words) -> Option<String> {
    // The fit estimates also an undetermined point of a curve, and the interval of the point shows the uncertainty. So the text states no
    // assumption.
    if e.index.is_some() {
        return (e.standing == Standing::NotIdentified).then(|| words.not_identified.to_owned());
    }
    let why = words.say(&e.from);
    (e.standing == Standing::NotIdentified).then(|| assumed_by(e.name, e.value, of, Some(&why), words))
}

#[cfg(test)]
mod tests {
    use super::{assumed, of_model};
    use crate::words::EN;
    use dashpot_core::number;
    use dashpot_core::{Params, element};
    use dashpot_identification::model_file::of_text;

    #[test]
    fn only_identified_numbers_have_source_tests_and_only_acting_ones_are_listed() {
        let text = "format = 1\nelements = [\"fv_curve\", \"gas_preload\", \"coulomb_friction\"]\nfv_rebound_c1 = 5393\n\
             gas_force = 99\ncoulomb_force = 42\n[identification]\nnot_identified = [\"gas_force\"]\n\
             [identification.intervals]\ncoulomb_force = [40, 44]\n\
             [identification.sources]\ngas_force = \"small strokes 63 %\"\ncoulomb_force = \"small strokes 63 %\"\n";
        let rows = of_model(&of_text(text, "m.toml".as_ref()).unwrap(), &EN);
        let source = |name: &str| rows.iter().find(|row| row.name == name).map(|row| row.source.as_str());
        assert_eq!(source("coulomb_force"), Some("small strokes 63 %"));
        assert_eq!(source("gas_force"), Some(""));
        assert_eq!(source("fv_rebound_c1"), None);
        let piecewise = text.replace("fv_rebound_c1", "fv_form = \"piecewise\"\nfv_rebound_c1");
        let rows = of_model(&of_text(&piecewise, "m.toml".as_ref()).unwrap(), &EN);
        assert!(rows.iter().any(|row| row.name == "fv_rebound_c1"));
    }

    #[test]
    fn what_was_assumed_has_its_source() {
        let mut params = Params::new();
        params.enable(element!("gas_spring"), true);
        let usual = assumed("gas_stiffness", 1000.0, &params, None, &EN);
        assert!(usual.contains("assumed 1.000\u{a0}N/mm, what dampers show ("), "{usual}");
        let default = params.number(number!("internal_mass"));
        let told = assumed("internal_mass", default, &params, None, &EN);
        assert!(told.contains("the default of the model") || told.contains("what dampers show"), "{told}");
        let left = assumed("gas_stiffness", 1234.5, &params, None, &EN);
        assert!(left.contains("the records do not determine it"), "{left}");
        params.enable(element!("gas_spring"), false);
        let off = assumed("gas_stiffness", 1000.0, &params, Some("no test shows it"), &EN);
        assert_eq!(off, "not identified: its element is off (no test shows it)");
    }
}
