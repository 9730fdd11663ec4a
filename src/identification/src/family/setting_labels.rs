//! Check of the stated settings against the forces of the tests.

use super::left_out::{count_records, forces_at};
use super::settings::{SettingAxis, SettingRecords};
use crate::phrases;
use dashpot_core::family::Definition;
use dashpot_core::{Params, list};
use dashpot_estimation::family::problem::SettingTests;
use dashpot_estimation::family::structure::FamilyStructure;
use dashpot_estimation::samples::Test;
use dashpot_messages::{Sentence, Template};
use dashpot_records::setting_in_words;

/// Ratio of a test's errors at the stated setting and at another setting above which the label is suspect.
///
/// The assumptions are that one label in a hundred is wrong, and that the residual of a test contains four independent errors. With a ratio
/// of 5, the odds for a wrong label are then 6 to 1 between two settings and even among six settings. With a lower ratio, a correct test
/// with a poor fit would be suspected. Test: `a_test_with_the_label_of_another_setting_is_named`.
pub const LABEL_DOUBT_RATIO: f64 = 5.0;
/// Ratio of the median number of tests per setting to the number of tests at one setting, at and above which [`strays`] checks this
/// setting.
///
/// A wrong label rarely applies to many tests alike, so only settings with few tests are checked. The check costs a simulation of these
/// tests at every setting. Test: `a_test_with_the_label_of_another_setting_is_named`.
const FEW: usize = 3;
/// Ratio of a test's error at another setting to its error at its stated setting below which both settings fit the test equally well.
///
/// The damper at the stated setting was fitted to the test, so its error is small. The error at the stated setting counts as at least 1, in
/// units of noise and form error. A damper that is interpolated or shares its numbers has an error of two to three such units. Test:
/// `a_test_with_the_label_of_another_setting_is_named`.
const AS_WELL: f64 = 3.0;
/// Largest decrease of the damping force over the setting that counts as noise, as a fraction of the range of the damping force. Test:
/// `exchanged_labels_are_found_where_one_exchange_makes_the_force_monotone`.
const FLAT: f64 = 0.02;

/// Returns notes on stated settings that contradict the forces.
pub fn notes(
    best: &FamilyStructure,
    damper: &Definition,
    axis: &SettingAxis,
    sorted: &[SettingRecords],
    settings: &[SettingTests],
) -> Vec<Sentence> {
    let at = |place: usize| setting_in_words(settings[place].value, &axis.unit);
    let note = |template: Template, of: &Suspect| {
        Sentence::from(template)
            .with("test", &sorted[of.stated].records[of.record].name)
            .with("name", &axis.name)
            .with("stated", at(of.stated))
            .with("fitting", at(of.fitting))
    };
    let suspects = suspects(best, settings);
    let suspects = suspects.iter().map(|of| note(phrases::LABEL_SUSPECT, of).with("ratio", format!("{:.0}", of.ratio)));
    let mut notes: Vec<Sentence> = suspects.collect();
    notes.extend(strays(best, settings).iter().map(|of| note(phrases::LABEL_STRAY, of)));
    let sets: Vec<Params> = settings.iter().map(|of| damper.params_at(of.value)).collect();
    if let Some((one, other)) = exchanged_settings(&sets) {
        notes.push(
            Sentence::from(phrases::LABELS_EXCHANGED)
                .with("name", &axis.name)
                .with("one", at(one))
                .with("other", at(other)),
        );
    }
    if let Some([rising, falling]) = opposite_trends(&sets) {
        let speed = |of: f64| format!("{:.0}", 1e3 * of.abs());
        notes.push(
            Sentence::from(phrases::LABELS_OPPOSED)
                .with("name", &axis.name)
                .with_word("direction", if rising > 0.0 { "rebound" } else { "compression" })
                .with("rising", speed(rising))
                .with("falling", speed(falling)),
        );
    }
    notes
}

/// Returns whether values rise throughout, with `sign` 1, or fall throughout, with `sign` −1. A change by up to `flat` in the opposite
/// direction counts as none.
fn goes(values: &[f64], sign: f64, flat: f64) -> bool {
    values.windows(2).all(|pair| sign * (pair[1] - pair[0]) >= -flat)
}

/// Ratio between the forces at the first and the last setting, larger by smaller, above which the force at a velocity has a trend. Test:
/// `tests_counted_from_the_other_end_give_opposite_trends`.
const TREND: f64 = 1.2;
/// Smallest number of points of the FV curve, in one stroke direction, that must have the same trend.
const POINTS: usize = 2;

/// Returns two velocities of the same stroke direction, m/s. Over the settings, the force rises throughout at the first velocity and falls
/// throughout at the second.
///
/// If several velocities have the same trend, the one with the largest ratio of forces is returned. Opposite trends suggest that the labels
/// of some tests were counted from the other end of the settings. Returns `None` for fewer than three settings, or without both trends.
fn opposite_trends(sets: &[Params]) -> Option<[f64; 2]> {
    if sets.len() < 3 {
        return None;
    }
    let velocities = sets[0].list(list!("fv_velocity"));
    let trend = |point: usize| -> f64 {
        let forces: Vec<f64> = sets.iter().map(|set| set.list(list!("fv_force"))[point].abs()).collect();
        let (first, last) = (forces[0], forces[forces.len() - 1]);
        let sign = if last > first { 1.0 } else { -1.0 };
        let flat = FLAT * (last - first).abs();
        let ratio = first.max(last) / first.min(last).max(f64::MIN_POSITIVE);
        if goes(&forces, sign, flat) && ratio > TREND { sign * ratio } else { 0.0 }
    };
    let of_stroke = |stroke: f64| {
        let trends: Vec<(f64, f64)> = (0..velocities.len())
            .filter(|k| stroke * velocities[*k] > 0.0)
            .map(|k| (velocities[k], trend(k)))
            .collect();
        let largest = |sign: f64| {
            let own = || trends.iter().filter(|(_, trend)| sign * trend > 0.0);
            own().nth(POINTS - 1)?;
            own().max_by(|a, b| a.1.abs().total_cmp(&b.1.abs())).map(|(velocity, _)| *velocity)
        };
        Some([largest(1.0)?, largest(-1.0)?])
    };
    of_stroke(1.0).or_else(|| of_stroke(-1.0))
}

/// Record whose forces belong to another setting than the stated one.
#[derive(Debug, PartialEq)]
struct Suspect {
    /// Index of the stated setting in the grid.
    stated: usize,
    /// Index of the record among the records of the stated setting.
    record: usize,
    /// Index, in the grid, of the setting whose damper fits the record.
    fitting: usize,
    /// Ratio of the error at the stated setting to the error at the fitting setting. A fitting error below the median error of all records
    /// counts as that median. In [`strays`], ratio of the smaller error at the neighbors of the stated setting to the error at the fitting
    /// setting.
    ratio: f64,
}

fn suspects(best: &FamilyStructure, settings: &[SettingTests]) -> Vec<Suspect> {
    let Some(own) = (0..settings.len()).map(|place| errors(best, place, &settings[place].tests)).collect() else {
        return Vec::new();
    };
    let own: Vec<Vec<(usize, f64)>> = own;
    let mut all: Vec<f64> = own.iter().flatten().map(|(_, error)| *error).collect();
    all.sort_by(f64::total_cmp);
    // Most labels are right, so the median error is typical of tests at their own setting.
    let Some(typical) = all.get(all.len() / 2).copied() else { return Vec::new() };
    let mut suspects = Vec::new();
    for (stated, errors_there) in own.iter().enumerate() {
        for (record, error) in errors_there.iter().filter(|(_, error)| *error > LABEL_DOUBT_RATIO * typical) {
            let tests: Vec<Test> =
                settings[stated].tests.iter().filter(|test| test.record == *record).cloned().collect();
            let elsewhere = (0..settings.len()).filter(|place| *place != stated);
            let best_fit = elsewhere
                .filter_map(|place| Some((place, errors(best, place, &tests)?.first()?.1)))
                .min_by(|a, b| a.1.total_cmp(&b.1));
            let Some((fitting, other)) = best_fit else { continue };
            let ratio = error / other.max(typical);
            if ratio > LABEL_DOUBT_RATIO {
                suspects.push(Suspect { stated, record: *record, fitting, ratio });
            }
        }
    }
    suspects
}

/// Returns records at a setting with few tests whose forces are those of a setting at least two grid positions away.
///
/// The family was fitted to these few tests at their stated setting, so their error there is small even if the stated setting is wrong.
fn strays(best: &FamilyStructure, settings: &[SettingTests]) -> Vec<Suspect> {
    let count = |of: &SettingTests| count_records(&of.tests);
    let mut sizes: Vec<usize> = settings.iter().map(count).collect();
    sizes.sort_unstable();
    let usual = sizes[sizes.len() / 2];
    let mut strays = Vec::new();
    for (stated, of) in settings.iter().enumerate().filter(|(_, of)| FEW * count(of) <= usual) {
        let mut all: Vec<Vec<(usize, f64)>> = Vec::new();
        for place in 0..settings.len() {
            let Some(own) = errors(best, place, &of.tests) else { return Vec::new() };
            all.push(own);
        }
        for (row, (record, error)) in all[stated].iter().enumerate() {
            let at = |place: usize| all[place][row].1;
            let is_next = |place: usize| place.abs_diff(stated) == 1;
            let apart = (0..settings.len()).filter(|place| *place != stated && !is_next(*place));
            let Some(fitting) = apart.min_by(|a, b| at(*a).total_cmp(&at(*b))) else { continue };
            let nearest = (0..settings.len()).filter(|place| is_next(*place)).map(at).fold(f64::INFINITY, f64::min);
            let ratio = nearest / at(fitting);
            if ratio > LABEL_DOUBT_RATIO && at(fitting) < AS_WELL * error.max(1.0) {
                strays.push(Suspect { stated, record: *record, fitting, ratio });
            }
        }
    }
    strays
}

/// Returns the index of each record and its root mean square error with the damper at a setting. The errors are in units of noise and form
/// error. Returns `None` if an error is not finite.
fn errors(best: &FamilyStructure, place: usize, tests: &[Test]) -> Option<Vec<(usize, f64)>> {
    let (hypothesis, theta) = (&best.hypothesis, &best.refit.theta);
    let params = hypothesis.params_at(theta, place);
    let forces = forces_at(&params, &hypothesis.template, &hypothesis.theta_at(theta, place), tests)?;
    // Sum of squares and number of samples of each record.
    let mut sums: Vec<(usize, f64, usize)> = Vec::new();
    for (test, forces) in tests.iter().zip(&forces) {
        let unit = test.unit().max(f64::MIN_POSITIVE);
        let sum: f64 = test.forces().iter().zip(forces).map(|(a, b)| ((a - b) / unit).powi(2)).sum();
        match sums.iter_mut().find(|(record, ..)| *record == test.record) {
            Some((_, whole, count)) => (*whole, *count) = (*whole + sum, *count + forces.len()),
            None => sums.push((test.record, sum, forces.len())),
        }
    }
    let errors: Vec<(usize, f64)> =
        sums.into_iter().map(|(record, sum, count)| (record, (sum / count.max(1) as f64).sqrt())).collect();
    errors.iter().all(|(_, error)| error.is_finite()).then_some(errors)
}

/// Returns the indices of two settings whose exchange makes the damping force monotonic over the settings.
///
/// Returns `None` for fewer than three settings, if the force is already monotonic, or if no exchange makes it monotonic.
pub fn exchanged_settings(sets: &[Params]) -> Option<(usize, usize)> {
    exchanged(&sets.iter().map(strength).collect::<Vec<_>>())
}

/// Returns the mean magnitude of the forces of the FV curve, N.
fn strength(params: &Params) -> f64 {
    let forces = params.list(list!("fv_force"));
    forces.iter().map(|force| force.abs()).sum::<f64>() / forces.len().max(1) as f64
}

/// Returns the indices of two settings whose exchange makes the damping force monotonic over the setting. Returns `None` for fewer than
/// three settings, if the force is already monotonic, or if no exchange makes it monotonic.
fn exchanged(strengths: &[f64]) -> Option<(usize, usize)> {
    let (least, most) = strengths.iter().fold((f64::INFINITY, 0.0f64), |(a, b), s| (a.min(*s), b.max(*s)));
    let flat = FLAT * (most - least);
    let is_monotone = |all: &[f64]| goes(all, 1.0, flat) || goes(all, -1.0, flat);
    if strengths.len() < 3 || is_monotone(strengths) {
        return None;
    }
    let pairs = (0..strengths.len()).flat_map(|one| (one + 1..strengths.len()).map(move |other| (one, other)));
    let repairs: Vec<(usize, usize)> = pairs
        .filter(|(one, other)| {
            let mut all = strengths.to_vec();
            all.swap(*one, *other);
            is_monotone(&all)
        })
        .collect();
    // Several exchanges may be equally likely: in a row of three settings, either neighbor may be wrong. The function then returns the pair
    // of settings nearest to each other.
    repairs.into_iter().min_by_key(|(one, other)| other - one)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tests_counted_from_the_other_end_give_opposite_trends() {
        let velocities = [-0.5, -0.1, 0.0, 0.05, 0.1, 0.3, 0.6];
        let set = |forces: [f64; 4]| {
            let mut params = Params::new();
            params.set_list(list!("fv_velocity"), &velocities).unwrap();
            let forces = [&[-400.0, -100.0, 0.0][..], &forces].concat();
            params.set_list(list!("fv_force"), &forces).unwrap();
            params
        };
        let right =
            [set([50.0, 100.0, 300.0, 500.0]), set([70.0, 150.0, 400.0, 700.0]), set([99.0, 200.0, 500.0, 900.0])];
        assert_eq!(opposite_trends(&right), None);
        // At the two highest velocities, the labels are counted from the other end.
        let mixed =
            [set([50.0, 100.0, 500.0, 900.0]), set([70.0, 150.0, 400.0, 700.0]), set([99.0, 200.0, 300.0, 500.0])];
        assert_eq!(opposite_trends(&mixed), Some([0.1, 0.6]));
        assert_eq!(opposite_trends(&mixed[..2]), None);
    }

    #[test]
    fn exchanged_labels_are_found_where_one_exchange_makes_the_force_monotone() {
        assert_eq!(exchanged(&[1.0, 3.0, 2.0, 4.0]), Some((1, 2)));
        assert_eq!(exchanged(&[1.0, 2.0, 3.0, 4.0]), None);
        assert_eq!(exchanged(&[4.0, 3.0, 2.99, 1.0]), None);
        // This force truly rises and falls with the setting, so no exchange makes it monotonic.
        assert_eq!(exchanged(&[1.0, 2.0, 4.0, 3.0, 2.5, 1.5]), None);
        // The decrease from 1.01 to 1.00 is small compared with the range of 3, so it counts as noise.
        assert_eq!(exchanged(&[1.0, 1.01, 1.0, 4.0]), None);
    }
}
