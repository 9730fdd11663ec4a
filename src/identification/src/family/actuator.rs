//! Identification of the actuator of a damper family from tests in which the setting changes.

use super::TEMPERATURE;
use super::interpolation_error::InterpolationError;
use super::left_out::SettingReport;
use crate::intervals::{Estimate, Standing, Z};
use crate::phrases;
use crate::validation::SHORTEST_LEVEL;
use dashpot_core::family::axis::{ENTRIES, index_of};
use dashpot_core::family::{Axis, Definition};
use dashpot_estimation::deviations::{considered_shift, grouped_covariance, robust_covariance};
use dashpot_estimation::family::actuator::{ActuatorContext, ActuatorRefit, REST_ENTRY, axis_with};
use dashpot_estimation::family::actuator_search::{ActuatorSearch, search_actuator};
use dashpot_estimation::family::command_time::SPREAD;
use dashpot_estimation::family::structure::FamilyStructure;
use dashpot_estimation::samples::{self, Test};
use dashpot_estimation::structure::alternatives::Part;
use dashpot_messages::Sentence;
use dashpot_records::{Record, is_same_setting, setting_in_words};
use serde::Serialize;

/// Ratio of root mean square to mean absolute value of a normally distributed error.
const RMS_OF_MEAN: f64 = 1.25;
/// Factor on the nearest known second derivative of the force over the setting, in the first and last interval of the grid. It applies to
/// the standard deviation of an interpolated force. The bound of [`InterpolationError`] uses the factor 2 instead.
///
/// The figures of the physical valve in the book were computed with a factor of 1.5 (`prove_semi_active 4 3040000`).
const AT_END: f64 = 1.5;
/// Width of the interval of a time, s, above which a note advises further tests. The value is the lag of a fast valve, so records with a
/// wider interval do not distinguish fast and slow valves. With a smaller width, the note would also appear where the times are accurate
/// enough for a simulation.
const VAGUE: f64 = 0.01;
/// Ratio of the posterior to the prior standard deviation of a number below which the number counts as identified.
const NARROWED: f64 = 0.7;

/// Decision on one part of an actuator, with the probability of the part.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct ActuatorDecision {
    /// Name: `lag`, `lag_each_way`, `dead_time`, `rate_limit` or `hysteresis`.
    pub name: &'static str,
    /// Whether the model has the part.
    pub is_present: bool,
    /// Probability that the valve has the part.
    pub probability: f64,
}

impl ActuatorDecision {
    /// Returns whether the records leave open if the valve has the part: the odds are at most three to one.
    pub fn is_undecided(&self) -> bool {
        (0.25..=0.75).contains(&self.probability)
    }
}

/// Actuator identified from records.
#[derive(Debug, Clone, Serialize)]
pub struct ActuatorFit {
    /// Numbers of the actuator with their 95 % intervals. A number that rising and falling settings share appears once for each direction.
    pub estimates: Vec<Estimate>,
    /// Decision on each part of the actuator.
    pub parts: Vec<ActuatorDecision>,
    /// Names of the tests from which the actuator was identified.
    pub tests: Vec<String>,
}

/// Adds the family's error at constant settings to the noise and the allowed errors of tests, as an independent error. This error is
/// `fraction` of the largest force of each test.
fn with_form_error(tests: Vec<Test>, fraction: f64) -> Vec<Test> {
    let weighed = |mut test: Test| {
        let form = fraction * test.segment.top;
        test.mean_noise = libm::hypot(test.mean_noise, form);
        test.allowed.iter_mut().for_each(|allowed| *allowed = libm::hypot(*allowed, form));
        test
    };
    tests.into_iter().map(weighed).collect()
}

/// Identifies the actuator of the damper family `damper`, and writes the actuator into the axis of this family.
///
/// `records` are the tests with a changing setting, and `reports` the errors of the family at each constant setting. `progress` receives
/// the completed fraction, 0 to 1. Returns `None` if there are no such tests, if no start value gives finite forces, or if the axis rejects
/// a number.
pub fn identify_actuator(
    damper: &mut Definition,
    family: &FamilyStructure,
    reports: &[SettingReport],
    records: &[&Record],
    progress: &(dyn Fn(f64) + Sync),
) -> Option<ActuatorFit> {
    if records.is_empty() {
        return None;
    }
    let percent = reports.iter().map(|of| of.family.error_percent).sum::<f64>() / reports.len().max(1) as f64;
    let tests = with_form_error(samples::tests(records), RMS_OF_MEAN * percent / 100.0);
    let sample_time = |test: &Test| {
        let time = &records[test.record].time;
        time.last().zip(time.first()).map_or(0.0, |(last, first)| (last - first) / (time.len() - 1).max(1) as f64)
    };
    let sample_times: Vec<f64> = tests.iter().map(sample_time).collect();
    let rig = &family.hypothesis.template;
    let rig_theta = family.hypothesis.theta_at(&family.refit.theta, 0);
    let context = ActuatorContext {
        definition: damper,
        rig,
        rig_theta: &rig_theta,
        tests: &tests,
        sample_times: &sample_times,
        gap_spreads: &interpolation_errors(damper, reports),
    };
    let ActuatorSearch { best, parts, alternatives, without_errors_between, timing } =
        search_actuator(&context, progress)?;
    let axis = axis_with(&damper.axis, &best.numbers, &best.theta)?;
    damper.axis = axis;
    let decision = |of: &dashpot_estimation::family::actuator_search::ActuatorPart| ActuatorDecision {
        name: of.name,
        is_present: of.is_present,
        probability: 1.0 / (1.0 + libm::exp(-of.log_odds / TEMPERATURE)),
    };
    let groups = groups_of_steps(&tests);
    let mut known = estimates(&best, &timing, damper, ways_of(records));
    hold_errors_of_steps(&mut known, &best, &groups);
    let others: Vec<(f64, Vec<Estimate>)> = alternatives
        .iter()
        .map(|(difference, refit)| {
            (libm::exp(difference / TEMPERATURE), estimates(refit, &timing, damper, ways_of(records)))
        })
        .collect();
    if let Some(without) = without_errors_between {
        hold_effect_of_interpolation(&mut known, &estimates(&without, &timing, damper, ways_of(records)));
    }
    known.iter_mut().for_each(|estimate| mix_interval(estimate, &others));
    Some(ActuatorFit {
        estimates: known,
        parts: parts.iter().map(decision).collect(),
        tests: records.iter().map(|record| record.name.clone()).collect(),
    })
}

/// Returns, for each test, the group index of each scored sample. Over all tests, the samples after steps from one setting to another form
/// one group.
///
/// A step counts if the new setting lasts at least [`SHORTEST_LEVEL`]. All other samples of a test form one group. The model has the same
/// error at all steps of a group, so the errors within a group are correlated.
fn groups_of_steps(tests: &[Test]) -> Vec<Vec<usize>> {
    let mut kinds: Vec<(u64, u64, usize)> = Vec::new();
    let mut group_of = |kind: (u64, u64, usize)| {
        kinds.iter().position(|known| *known == kind).unwrap_or_else(|| {
            kinds.push(kind);
            kinds.len() - 1
        })
    };
    let of_test = |(index, test): (usize, &Test)| {
        let segment = &test.segment;
        let settings = segment.setting.as_deref().unwrap_or(&[]);
        let mut groups = vec![group_of((0, 0, index + 1)); segment.force.len()];
        let changes: Vec<usize> = (1..settings.len()).filter(|k| settings[*k] != settings[k - 1]).collect();
        for (place, change) in changes.iter().enumerate() {
            let end = changes.get(place + 1).copied().unwrap_or(settings.len());
            let level = segment.dt.get(*change..end.min(segment.dt.len())).map_or(0.0, |dt| dt.iter().sum());
            if level >= SHORTEST_LEVEL {
                let group = group_of((settings[change - 1].to_bits(), settings[*change].to_bits(), 0));
                groups.iter_mut().take(end).skip(*change).for_each(|own| *own = group);
            }
        }
        groups.split_off(segment.from)
    };
    tests.iter().enumerate().map(of_test).collect()
}

/// Widens the intervals of an actuator's numbers until they contain the intervals for correlated errors within `groups`. In a group, all
/// steps are between the same two settings.
///
/// Such errors arise if the force between two settings, or the response of the valve, has another form in the damper than in the model.
/// Averaging over many steps does not reduce them.
fn hold_errors_of_steps(known: &mut [Estimate], refit: &ActuatorRefit, groups: &[Vec<usize>]) {
    let Some(covariance) = grouped_covariance(&refit.blocks, &refit.precisions(), groups) else { return };
    for (place, number) in refit.numbers.iter().enumerate() {
        let half = Z * covariance[(place, place)].max(0.0).sqrt();
        let (low, high) = number.bounds;
        let at = |moved: f64| number.value(dashpot_records::restrict(refit.theta[place] + moved, low, high));
        for estimate in known.iter_mut().filter(|estimate| number.entries.contains(&estimate.name)) {
            estimate.widen([at(-half), at(half)]);
        }
    }
}

/// Widens each interval until it contains the estimate plus and minus the effect of errors of the interpolated force. The effect is the
/// difference between the estimate with these errors and the estimate `without` them.
///
/// A moving valve passes settings between those of the grid, where no record shows the force. The records determine the errors of this
/// force only together with the time constants of the valve, and these errors are bounded. So the intervals from the covariance alone would
/// be too narrow.
fn hold_effect_of_interpolation(known: &mut [Estimate], without: &[Estimate]) {
    for estimate in known {
        let Some(other) = without.iter().find(|other| other.name == estimate.name) else { continue };
        let effect = (other.value - estimate.value).abs();
        // Time constants and widths of the hysteresis are not negative. Both ends of the interval are therefore restricted to the bounds of
        // the parameter.
        let end = |moved: f64| within_bounds(estimate.name, estimate.value + moved);
        estimate.widen([end(-effect), end(effect)]);
    }
}

/// Estimates the standard deviation of the interpolated force midway between each pair of grid neighbors, as a fraction of a test's largest
/// force. It is the error at the [left-out settings](SettingReport::left_out) in excess of the family's own error at these settings. A
/// moving valve passes the settings between grid values, so a wrong force there would appear as a wrong response time.
fn interpolation_errors(damper: &Definition, reports: &[SettingReport]) -> Vec<f64> {
    let errors = InterpolationError::new(damper);
    let difference = |place: usize| {
        let setting = damper.axis.grid().get(place)?;
        let report = reports.iter().find(|report| is_same_setting(report.setting, *setting))?;
        let squared = report.left_out?.error_percent.powi(2) - report.family.error_percent.powi(2);
        Some(RMS_OF_MEAN * squared.max(0.0).sqrt() / 100.0)
    };
    let midway = |pair: &[f64]| errors.of_differences(0.5 * (pair[0] + pair[1]), AT_END, difference);
    // A grid of two settings has no inner setting that can be left out, so its interpolation error counts as zero. A note states this.
    damper.axis.grid().windows(2).map(|pair| midway(pair).unwrap_or(0.0)).collect()
}

/// Returns whether the setting rises in some record, and whether it falls in some record.
fn ways_of(records: &[&Record]) -> [bool; 2] {
    let values = |record: &&Record| record.setting_signal.as_ref().map(|signal| signal.values.clone());
    let all: Vec<Vec<f64>> = records.iter().filter_map(values).collect();
    let has = |is_own: fn(&[f64]) -> bool| all.iter().any(|values| values.windows(2).any(is_own));
    [has(|pair| pair[1] > pair[0]), has(|pair| pair[1] < pair[0])]
}

/// Estimates the numbers of an actuator with their intervals; the list is empty if the covariance cannot be computed. `timing` contains the
/// derivatives of the residuals with respect to the instant of the command within a sampling interval. The intervals include the
/// uncertainty of that instant. If the setting never changes in one direction, the number of that direction is not identified, even if both
/// directions share it.
fn estimates(
    refit: &ActuatorRefit,
    timing: &[Vec<f64>],
    damper: &Definition,
    [rises, falls]: [bool; 2],
) -> Vec<Estimate> {
    let precisions = refit.precisions();
    let Some((covariance, _)) = robust_covariance(&refit.blocks, &precisions) else { return Vec::new() };
    // The instant of the command has the same error at all steps, so averaging over steps does not reduce its effect.
    let shift = considered_shift(&refit.blocks, &precisions, timing);
    let unit = damper.axis.unit();
    let mut all = Vec::new();
    for (place, number) in refit.numbers.iter().enumerate() {
        let of_instant = shift.as_ref().map_or(0.0, |shift| SPREAD * shift[place]);
        let deviation = (covariance[(place, place)].max(0.0) + of_instant * of_instant).sqrt();
        let (low, high) = number.bounds;
        let at = |z: f64| number.value(dashpot_records::restrict(refit.theta[place] + z * deviation, low, high));
        let is_at_bound = refit.theta[place] <= low || refit.theta[place] >= high;
        let standing = match deviation < NARROWED * number.prior.1 {
            false => Standing::NotIdentified,
            true if is_at_bound && at(0.0) != 0.0 => Standing::AtBound,
            true => Standing::Identified,
        };
        for name in number.entries {
            let was_seen = (rises || !name.ends_with("_up")) && (falls || !name.ends_with("_down"));
            let standing = if was_seen { standing.clone() } else { Standing::NotIdentified };
            let is_identified = standing != Standing::NotIdentified;
            let Some(entry) = index_of(name.as_bytes()).and_then(|index| ENTRIES.get(index)) else { continue };
            all.push(Estimate {
                name: entry.name,
                index: None,
                value: number.value(refit.theta[place]),
                low: is_identified.then(|| at(-Z)),
                high: is_identified.then(|| at(Z)),
                unit: entry_unit(entry.unit, unit),
                from: phrases::CHANGING_SETTING.into(),
                standing,
            });
        }
    }
    all
}

/// Mixes an interval with the intervals of `others`, the alternative actuators that the records do not rule out, by their weights. A number
/// that an alternative lacks is 0 in this alternative.
fn mix_interval(estimate: &mut Estimate, others: &[(f64, Vec<Estimate>)]) {
    let name = estimate.name;
    let part = |weight: f64, of: Option<&Estimate>| {
        let value = of.map_or(0.0, |of| of.value);
        // An alternative in which the number has no interval gets no weight. If the number is the position in the hysteresis, an
        // alternative without hysteresis gets no weight either, because the number has no meaning there.
        let is_open = of.map_or(name == REST_ENTRY, |of| of.low.is_none());
        let weight = if is_open { 0.0 } else { weight };
        let end = |end: fn(&Estimate) -> Option<f64>| of.and_then(end).unwrap_or(value);
        Part { weight, value, ends: [end(|of| of.low), end(|of| of.high)] }
    };
    estimate.mix(others.iter().map(|(weight, all)| part(*weight, all.iter().find(|of| of.name == name))));
    // The mixed interval is that of a normal distribution, which may extend beyond the bounds of the number.
    // An end of a millionth of the value is a bound of zero that the mixture misses by its rounding.
    let rounded = |end: f64| if end.abs() < 1e-6 * estimate.value.abs() { 0.0 } else { end };
    estimate.low = estimate.low.map(|end| within_bounds(name, rounded(end)));
    estimate.high = estimate.high.map(|end| within_bounds(name, end));
}

/// Restricts a value to the bounds of a number of the axis.
fn within_bounds(name: &str, value: f64) -> f64 {
    let entry = index_of(name.as_bytes()).and_then(|index| ENTRIES.get(index));
    entry.map_or(value, |entry| dashpot_records::restrict(value, entry.bounds.0, entry.bounds.1))
}

/// Returns the unit of a number of the axis. In the table [`ENTRIES`], `*` stands for the unit of the setting, which the user chooses. Only
/// A and V are known here; any other unit gives an empty text.
fn entry_unit(unit: &'static str, of_setting: &str) -> &'static str {
    match (unit, of_setting) {
        ("*", "A") => "A",
        ("*/s", "A") => "A/s",
        ("*", "V") => "V",
        ("*/s", "V") => "V/s",
        ("*" | "*/s", _) => "",
        (unit, _) => unit,
    }
}

/// Returns remarks on the actuator for the engineer. `name` is the name of the setting, and `axis` has its measured values.
pub fn notes(fit: &ActuatorFit, name: &str, axis: &Axis) -> Vec<Sentence> {
    let mut notes = Vec::new();
    if let ([low, high], false) = (axis.grid(), fit.estimates.is_empty()) {
        let note = Sentence::from(phrases::ACTUATOR_TWO_SETTINGS).with("setting", name);
        notes.push(note.with("low", *low).with("high", setting_in_words(*high, axis.unit())));
    }
    let is_vague = |e: &&Estimate| e.unit == "s" && e.high.zip(e.low).is_some_and(|(high, low)| high - low > VAGUE);
    let vague: Vec<&str> = fit.estimates.iter().filter(is_vague).map(|e| e.name).collect();
    if !vague.is_empty() {
        let note = Sentence::from(phrases::ACTUATOR_VAGUE).with_names("names", vague, phrases::COMMA);
        notes.push(note.with("width", 1e3 * VAGUE).with("setting", name));
    }
    let open: Vec<&str> =
        fit.estimates.iter().filter(|e| e.standing == Standing::NotIdentified).map(|e| e.name).collect();
    if fit.estimates.is_empty() {
        notes.push(Sentence::from(phrases::NO_ACTUATOR).with("setting", name).with("count", fit.tests.len()));
    }
    if !open.is_empty() {
        notes.push(Sentence::from(phrases::ACTUATOR_OPEN).with_names("names", open, phrases::COMMA));
    }
    notes
}

#[cfg(test)]
mod tests {
    use super::*;

    fn fitted(high: f64) -> ActuatorFit {
        let time = Estimate {
            name: "lag_up",
            index: None,
            value: 8e-3,
            low: Some(6e-3),
            high: Some(high),
            unit: "s",
            from: Sentence::from(phrases::COMMA),
            standing: Standing::Identified,
        };
        ActuatorFit { estimates: vec![time], parts: Vec::new(), tests: vec![String::from("steps")] }
    }

    #[test]
    fn a_time_with_a_wide_interval_comes_with_the_tests_that_narrow_it() {
        let mut axis = Axis::NONE;
        axis.set_grid(&[0.0, 0.6, 1.2]).unwrap();
        let told = |high: f64| notes(&fitted(high), "current", &axis);
        assert!(told(9e-3).is_empty());
        let [note] = &told(22e-3)[..] else { panic!("one note is expected") };
        let text = note.to_string();
        assert!(
            text.contains("lag_up uncertain by more than 10 ms") && text.contains("Add steps of the current"),
            "{text}"
        );
    }
}
