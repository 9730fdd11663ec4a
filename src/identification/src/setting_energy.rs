//! Quantities of a damper that may do work on the host when its setting changes: energy stores, and forces at rest.

use crate::phrases;
use dashpot_core::family::Definition;
use dashpot_core::parameter::{self, Element, Number};
use dashpot_core::{Model, element, list, number};
use dashpot_messages::Sentence;
use dashpot_records::{Reading, setting_in_words};

/// Largest variation of a quantity over the settings that counts as rounding, as a fraction of the quantity. For a force, it is a fraction
/// of the largest force of the FV curve, or of the quantity if that is larger.
///
/// Interpolation between the points of a curve has rounding errors of 1e-16. With a larger limit, a preload that a user wrote into the file
/// could be ignored.
///
/// Test: `a_force_of_the_curve_at_rest_is_found`.
const ROUNDING: f64 = 1e-9;

/// Describes each quantity through which a change of the setting may do work on the host, with its range over the settings. The list is
/// empty if every change only affects how much energy the damper dissipates.
///
/// The quantities are numbers of energy stores and of forces at rest, and the force of the FV curve at zero velocity. The lagging force of
/// frequency-selective damping is another one.
pub fn energy_sources(damper: &Definition) -> Vec<Sentence> {
    let mut sources: Vec<Sentence> = damper
        .axis
        .stores_energy()
        .filter_map(|number| {
            let row = number.row();
            let values = damper.axis.values(number)?;
            let is_on = row.element().is_some_and(|element| damper.params.is_on(element)) && damper.params.counts(row);
            if !is_on {
                return None;
            }
            range(damper, values, row.parameter.unit).map(|range| {
                Sentence::from(phrases::ENERGY_OF_NUMBER).with("name", row.parameter.name).with_sentence("range", range)
            })
        })
        .collect();
    let at_rest = range(damper, &forces_at_rest(damper), "N");
    sources.extend(at_rest.map(|range| Sentence::from(phrases::ENERGY_AT_REST).with_sentence("range", range)));
    if stores_lagging_force(damper) {
        let text = Sentence::from(phrases::ENERGY_OF_LAG);
        sources.push(text.with("element", element!("frequency_selective_damping").name()));
    }
    sources
}

/// Returns a sentence about the numbers through which a change of the setting may do work on the host, or `None` without such numbers.
pub fn energy_remark(damper: &Definition) -> Option<Sentence> {
    let sources = energy_sources(damper);
    let name = if damper.axis.name().is_empty() { "setting" } else { damper.axis.name() };
    let text = Sentence::from(phrases::FAMILY_STORES).with("setting", name);
    (!sources.is_empty()).then(|| text.with_list("sources", sources, phrases::SEMICOLON))
}

/// Returns the force of the FV curve at zero velocity, N, at each setting of the grid. The list is empty if the curve is off or does not
/// depend on the setting.
fn forces_at_rest(damper: &Definition) -> Vec<f64> {
    let varies = damper.axis.has_forces() || has_varying_number(damper, element!("fv_curve"));
    if !varies || !damper.params.is_on(element!("fv_curve")) {
        return Vec::new();
    }
    let at = |setting: &f64| Some(Model::new(&damper.params_at(*setting)).ok()?.elements().paths.fv_curve.at_zero());
    damper.axis.grid().iter().filter_map(at).collect()
}

/// Describes the range of a quantity over the grid, with its settings. Returns `None` if the values are equal except for [`ROUNDING`].
fn range(damper: &Definition, values: &[f64], unit: &'static str) -> Option<Sentence> {
    let all = || damper.axis.grid().iter().copied().zip(values.iter().copied());
    let low = all().min_by(|a, b| a.1.total_cmp(&b.1))?;
    let high = all().max_by(|a, b| a.1.total_cmp(&b.1))?;
    let largest = damper.params.list(list!("fv_force")).iter().fold(0.0, |most: f64, force| most.max(force.abs()));
    let scale = if unit == "N" { largest.max(high.1.abs()) } else { high.1.abs().max(low.1.abs()) };
    if high.1 - low.1 <= ROUNDING * scale {
        return None;
    }
    let at = |setting: f64| setting_in_words(setting, damper.axis.unit());
    let value = |value: f64| Reading::single(value, unit).with_unit();
    let text = Sentence::from(phrases::ENERGY_RANGE).with("low", value(low.1)).with("low_at", at(low.0));
    Some(text.with("high", value(high.1)).with("high_at", at(high.0)))
}

/// Returns whether the lagging force, a state of frequency-selective damping, depends on the setting.
///
/// In the filter form, frequency-selective damping adds a fraction of the lagging FV force. After a change to a soft setting, this fraction
/// decays with the time constant of the lag, and may push the damper.
fn stores_lagging_force(damper: &Definition) -> bool {
    let element = element!("frequency_selective_damping");
    let is_filter = damper.params.is_on(element) && damper.params.number(number!("fsd_form")) == 0.0;
    // These elements change the FV force before it lags.
    let before = [element, element!("fv_curve"), element!("position_dependent_damping"), element!("temperature_fade")];
    let varies = |of: &Element| damper.params.is_on(*of) && has_varying_number(damper, *of);
    is_filter && (damper.axis.has_forces() || before.iter().any(varies))
}

/// Returns whether a number of an element depends on the setting.
fn has_varying_number(damper: &Definition, element: Element) -> bool {
    let varies = |number: Number| damper.axis.values(number).is_some();
    parameter::table().filter(|row| row.element() == Some(element)).any(|row| Number::try_from(row).is_ok_and(varies))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model_file::{ModelFile, family_of_text};

    /// Reads a damper over a current from its elements and further lines.
    fn read(elements: &str, lines: &str) -> ModelFile {
        let text = format!(
            "format = 1\nelements = [\"fv_curve\", {elements}]\nsetting = [0.0, 1.0, 2.0]\nsetting_name = \"current\"\nsetting_unit = \"A\"\n\
             fv_velocity = [-1.0, 0.0, 1.0]\n{lines}"
        );
        family_of_text(&text, "m.toml".as_ref()).unwrap()
    }

    fn remark(elements: &str, lines: &str) -> Option<String> {
        energy_remark(&read(elements, lines).definition()).map(|text| text.to_string())
    }

    const FORCES: &str = "fv_force = [[-500.0, 0.0, 900.0], [-700.0, 0.0, 1500.0], [-900.0, 0.0, 2500.0]]\n";

    #[test]
    fn what_only_dissipates_is_no_source_and_what_stores_is_named_with_its_range() {
        let friction = "coulomb_force = [20.0, 30.0, 45.0]\ncoulomb_steepness = 200.0\n";
        assert_eq!(remark("\"coulomb_friction\"", &format!("{FORCES}{friction}")), None);
        let presliding = format!("{FORCES}presliding_force = [38.0, 900.0, 500.0]\n");
        let text = remark("\"presliding_friction\"", &presliding).unwrap();
        assert!(
            text.contains("a change of current") && text.contains("presliding_force 38.00 N at 0 A to 900.0 N at 1 A"),
            "{text}"
        );
        // Equal values, and a number of an element that is off, change nothing.
        assert_eq!(remark("\"presliding_friction\"", &presliding.replace("900.0, 500.0", "38.0, 38.0")), None);
        assert_eq!(remark("\"coulomb_friction\"", &format!("{presliding}{friction}")), None);
    }

    #[test]
    fn a_force_of_the_curve_at_rest_is_found() {
        let curve = |rest: [f64; 3]| {
            let [a, b, c] = rest;
            format!("fv_force = [[-500.0, {a:?}, 900.0], [-700.0, {b:?}, 1500.0], [-900.0, {c:?}, 2500.0]]\n")
        };
        let on = "\"series_compliance\"";
        let text = remark(on, &curve([100.0, 150.0, 300.0])).unwrap();
        assert!(text.contains("zero velocity, 100.0 N at 0 A to 300.0 N at 2 A"), "{text}");
        assert_eq!(remark(on, &curve([100.0; 3])), None, "a constant force at rest is a preload");
        assert!(remark(on, &curve([0.0, 0.0, 0.1])).is_some());
        // Without a point at zero velocity, the curve is interpolated there.
        let lines = "fv_force = [[-500.0, 100.0, 900.0], [-500.0, 100.0, 900.0], [-500.0, 400.0, 900.0]]\n";
        let mut shifted = read(on, lines);
        shifted.params.set_list(list!("fv_velocity"), &[-1.0, 0.25, 1.0]).unwrap();
        let text = energy_remark(&shifted.definition()).unwrap().to_string();
        assert!(text.contains(" at 0 A to ") && text.contains(" at 2 A"), "{text}");
    }

    #[test]
    fn a_force_that_lags_behind_the_curve_is_stored() {
        let on = "\"series_compliance\", \"frequency_selective_damping\"";
        let form = |form: &str| format!("{FORCES}fsd_form = \"{form}\"\n");
        assert!(remark(on, &form("filter")).unwrap().contains("frequency_selective_damping"));
        assert_eq!(remark(on, &form("stroke")), None);
    }

    #[test]
    fn the_remark_is_on_files_that_no_fit_made() {
        let gas = format!("{FORCES}gas_force = [80.0, 85.0, 95.0]\n");
        let on = "\"gas_preload\"";
        let remarks = |lines: &str| read(on, lines).remarks().iter().map(ToString::to_string).collect::<Vec<String>>();
        assert!(remarks(&gas).iter().any(|text| text.contains("gas_force 80.00 N at 0 A to 95.00 N at 2 A")));
        let fitted = |low: f64| {
            format!(
                "{gas}[identification.intervals_over_setting]\ngas_force = [[{low:?}, 90.0], [80.0, 90.0], [90.0, 99.0]]\n"
            )
        };
        assert!(!remarks(&fitted(75.0)).iter().any(|text| text.contains("may do work")), "the fit has its own note");
        // The file of a fit also gets the remark if a number was changed since the fit.
        assert!(remarks(&fitted(85.0)).iter().any(|text| text.contains("may do work")));
    }
}
