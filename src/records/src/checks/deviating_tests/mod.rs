//! Finds tests whose forces contradict the other tests of the campaign at similar velocities, and explains them.
//!
//! The tests of a campaign at one setting are of one damper, so they have similar forces at equal velocities,
//! regardless of their strokes. Heat, mounts, stops and free play change the force by tens of percent.
//!
//! The largest set of tests that agree is the reference of a setting. Two explanations of a test that deviates from it
//! compete:
//!
//! - A wrong unit of force, displacement, velocity or time changes the force by the ratio of two units.
//! - With the label of another setting, the forces are those of the reference of that setting.
//!
//! Labels that count the settings from the other end are found first, for all tests of a motion together. They are
//! corrected before the comparisons above.
//!
//! A wrong label is reported unless the residual with a wrong unit is smaller by [`AS_LIKELY`]. A wrong unit rejects
//! the campaign. A wrong label adds a note, which also names a unit that would explain the forces.
//!
//! | Module | Contents |
//! |---|---|
//! | [`reference`] | the reference of a setting |
//! | [`unit`] | another unit of a channel |
//! | [`mirrored`] | labels that count from the other end of the settings |
//! | [`label`] | the label of another setting |

mod label;
mod mirrored;
mod reference;
mod unit;

use self::label::Labels;
use self::reference::{Reference, agree, largest_agreeing};
use self::unit::{WrongUnit, find_wrong_unit};
use super::force_levels::{Levels, levels, velocity};
use super::plausibility::shows_noise_alone;
use crate::data::record::{Note, Record};
use crate::error::{FilesUnit, PlausibilityError, RecordError, name_several};
use crate::messages::phrases;
use crate::numbers::{median, sample_time};
use crate::options::Options;
use crate::quantities::channel::Channel;
use crate::quantities::reading::digits;
use crate::quantities::setting_value::{Setting, setting_in_words};
use crate::quantities::unit::Unit;
use crate::tuning::deviating_tests::{AS_LIKELY, FEWEST, OFF, SAME_MOTION};
use dashpot_messages::Sentence;
use std::collections::{BTreeMap, HashMap};

/// Units and options with which a test was read.
#[derive(Debug)]
pub(crate) struct Reading<'a> {
    /// Units in which the channels of the test were read.
    pub units: Vec<(Channel, Unit)>,
    /// The user's options for the file of the test.
    pub options: &'a Options,
}

/// A test with its force levels.
struct Seen<'a> {
    record: &'a Record,
    reading: &'a Reading<'a>,
    levels: Levels,
    /// Index of the stated setting. The test is compared at another setting if its label counts from the other end.
    stated: usize,
}

impl Seen<'_> {
    fn unit(&self, channel: Channel) -> Option<Unit> {
        self.reading.units.iter().find(|(c, _)| *c == channel).map(|(_, unit)| *unit)
    }

    /// Returns whether another test has the same motion: about equal amplitude and peak velocity.
    fn has_motion_of(&self, other: &Seen<'_>) -> bool {
        let near = |a: f64, b: f64| (a - b).abs() <= SAME_MOTION * a.abs();
        near(self.record.amplitude, other.record.amplitude)
            && near(self.record.peak_velocity, other.record.peak_velocity)
    }

    fn step(&self) -> f64 {
        sample_time(&self.record.time).max(1e-12)
    }
}

/// Rejects a campaign if some of its files likely use another unit than they state. A unit given by the user counts as
/// correct. Adds notes about tests that likely have the label of another setting, and about single tests whose forces
/// differ by more than a damper changes them.
pub(crate) fn check(
    records: &[Record],
    readings: &HashMap<String, Reading<'_>>,
    notes: &mut Vec<Note>,
) -> Result<(), RecordError> {
    let seen: Vec<Seen<'_>> = records
        .iter()
        // Neither a wrong unit nor a wrong label explains a force that consists of noise. The plausibility check
        // reports that case.
        .filter(|record| !shows_noise_alone(record))
        .filter_map(|record| {
            let levels: Levels = levels(record, |_| true).into_iter().filter(|(_, l)| l.against > 0.0).collect();
            Some(Seen { record, reading: readings.get(&record.source)?, levels, stated: 0 })
        })
        .filter(|seen| !seen.levels.is_empty())
        .collect();
    let mut settings = by_setting(seen);
    let mirror = mirrored::mirror(&settings);
    correct_mirrored(&mut settings, &mirror);
    let settings = settings;
    let references: Vec<Option<Reference<'_>>> = settings
        .iter()
        .map(|tests| {
            let agreeing = largest_agreeing(tests);
            (agreeing.len() >= 2).then(|| Reference::new(agreeing.iter().map(|&i| &tests[i]).collect()))
        })
        .collect();
    let labels = Labels::new(&settings, &references);
    let mut wrong: BTreeMap<(usize, usize), Labeled<'_>> = BTreeMap::new();
    let mut unlike: Vec<(&Seen<'_>, f64)> = Vec::new();
    for (own, tests) in settings.iter().enumerate() {
        for test in tests.iter().filter(|test| test.stated != own) {
            wrong.entry((test.stated, own)).or_default().tests.push(test);
        }
        let Some(reference) = &references[own] else { continue };
        let mut units: BTreeMap<(Channel, Unit, Vec<Unit>), Vec<&Seen<'_>>> = BTreeMap::new();
        for (place, test) in tests.iter().enumerate() {
            let agrees = reference.tests.iter().any(|own| std::ptr::eq(*own, test));
            let unit = if agrees { None } else { find_wrong_unit(test, reference) };
            // A label that counts from the other end explains the forces already.
            let label = if test.stated == own { labels.find_wrong(own, place) } else { None };
            match (unit, label) {
                (unit, Some(label)) if unit.as_ref().is_none_or(|unit| label.left < unit.left + AS_LIKELY) => {
                    let labeled = wrong.entry((own, label.fitting)).or_default();
                    labeled.tests.push(test);
                    labeled.unit = labeled.unit.take().or(unit);
                }
                (Some(unit), _) => {
                    units.entry((unit.channel, unit.written, unit.likely)).or_default().push(test);
                }
                (None, _) if agrees => (),
                (None, _) => unlike.extend(factor_to_others(test, tests, reference).map(|factor| (test, factor))),
            }
        }
        refuse_units(units, reference, records.len())?;
    }
    notes.extend(label_note(wrong.into_iter().collect(), &settings, &mirror, records.len()));
    notes.extend(unlike_note(&unlike));
    Ok(())
}

/// Returns the factor between the forces of a test and those of the reference at equal velocities.
///
/// Returns `None` if a damper may cause it (below [`OFF`]), or if any other of the `tests` at this setting has similar
/// forces: these may then be of another setting. Much shorter strokes are not compared, and a unit of force that the
/// user gave counts as correct.
fn factor_to_others(test: &Seen<'_>, tests: &[Seen<'_>], reference: &Reference<'_>) -> Option<f64> {
    let is_given = test.reading.options.units.contains_key(&Channel::Force);
    let mut off = reference.deviations(test, 1.0, 1.0);
    if is_given || off.len() < FEWEST || !reference.are_as_short(test, test.record.amplitude) {
        return None;
    }
    let factor = median(&mut off);
    let is_alone = || tests.iter().all(|other| std::ptr::eq(other, test) || !agree(&test.levels, &other.levels));
    (factor.abs() > OFF && is_alone()).then(|| libm::exp(factor))
}

/// Returns a note about tests whose forces are those of the others times a factor that no wrong unit or label explains.
fn unlike_note(unlike: &[(&Seen<'_>, f64)]) -> Option<Note> {
    let far = |factor: f64| libm::log(factor).abs();
    let (test, factor) = unlike.iter().max_by(|a, b| far(a.1).total_cmp(&far(b.1)))?;
    let tests: Vec<String> = unlike.iter().map(|(test, _)| test.record.source.clone()).collect();
    let text = Sentence::from(phrases::FORCES_UNLIKE)
        .with_sentence("tests", name_several(&tests))
        .with("test", &test.record.name)
        .with("factor", digits(*factor, 2));
    Some(Note { kind: "unlike", text })
}

/// Tests that state one setting but have the forces of another setting.
#[derive(Default)]
struct Labeled<'a> {
    tests: Vec<&'a Seen<'a>>,
    /// Another unit that would also explain the forces of one of the tests, if there is one.
    unit: Option<WrongUnit>,
}

/// Groups the tests by the setting of an adjustable damper, in ascending order. Leaves out tests whose setting changes.
///
/// The reference of a setting holds tests of this setting alone, because the forces at two settings may differ by the
/// ratio of two units.
fn by_setting(seen: Vec<Seen<'_>>) -> Vec<Vec<Seen<'_>>> {
    let mut groups: Vec<Vec<Seen<'_>>> = Vec::new();
    for test in seen.into_iter().filter(|test| test.record.setting_signal.is_none()) {
        let is_own = |group: &&mut Vec<Seen<'_>>| match (&group[0].record.setting, &test.record.setting) {
            (Some(a), Some(b)) => a.is_same(b),
            (None, None) => true,
            _ => false,
        };
        match groups.iter_mut().find(is_own) {
            Some(group) => group.push(test),
            None => groups.push(vec![test]),
        }
    }
    let value = |group: &Vec<Seen<'_>>| group[0].record.setting.as_ref().map_or(f64::NEG_INFINITY, |of| of.value);
    groups.sort_by(|a, b| value(a).total_cmp(&value(b)));
    for (stated, group) in groups.iter_mut().enumerate() {
        group.iter_mut().for_each(|test| test.stated = stated);
    }
    groups
}

/// Moves each test whose label counts from the other end to the setting that its forces indicate. The last test of a
/// setting is not moved, so that every setting has a test.
fn correct_mirrored(settings: &mut [Vec<Seen<'_>>], mirror: &[Option<usize>]) {
    let mut moved = mirrored::mirrored_tests(settings, mirror);
    moved.sort_unstable();
    let mut taken = Vec::new();
    // Iterate from the last test to the first, so that the indices of earlier tests stay valid.
    for (setting, place) in moved.into_iter().rev() {
        if let Some(to) = mirror[setting]
            && settings[setting].len() > 1
        {
            taken.push((to, settings[setting].remove(place)));
        }
    }
    for (to, test) in taken.into_iter().rev() {
        settings[to].push(test);
    }
}

/// Rejects tests of one damper at one setting that likely use another unit. `all` is the number of tests read.
fn refuse_units(
    found: BTreeMap<(Channel, Unit, Vec<Unit>), Vec<&Seen<'_>>>,
    reference: &Reference<'_>,
    all: usize,
) -> Result<(), RecordError> {
    let Some(((channel, written, likely), tests)) = found.into_iter().max_by_key(|(_, tests)| tests.len()) else {
        return Ok(());
    };
    // The error reports the values of the deviating test with the largest force.
    let most = |test: &Seen<'_>| test.levels.values().map(|l| l.against).fold(0.0, f64::max);
    let Some(shown) = tests.iter().max_by(|a, b| most(a).total_cmp(&most(b))) else { return Ok(()) };
    let Some((level, other)) = reference.closest_levels(shown) else { return Ok(()) };
    Err(PlausibilityError::FilesUnit(Box::new(FilesUnit {
        has_setting: shown.record.setting.is_some(),
        tests: tests.iter().map(|t| t.record.source.clone()).collect(),
        others: reference.tests.iter().map(|t| t.record.source.clone()).collect(),
        all,
        shown: shown.record.name.clone(),
        at: (velocity(level), shown.levels[&level].against),
        expected: (velocity(other), libm::exp(reference.curve[&other])),
        channel,
        written,
        likely,
    }))
    .into())
}

/// Returns a note about tests that likely have the label of another setting. `found` holds them by the indices of the
/// stated setting and of the setting with their forces. `mirror` is the index of each setting counted from the other
/// end, and `all` the number of tests read.
fn label_note(
    found: Vec<((usize, usize), Labeled<'_>)>,
    settings: &[Vec<Seen<'_>>],
    mirror: &[Option<usize>],
    all: usize,
) -> Option<Note> {
    let setting = |index: usize| -> Option<&Setting> { settings[index][0].record.setting.as_ref() };
    let name = &setting(found.first()?.0.0)?.name;
    let in_words = |index: usize| setting(index).map_or(String::new(), |of| setting_in_words(of.value, &of.unit));
    let groups = found.iter().map(|((stated, fitting), labeled)| {
        let tests: Vec<String> = labeled.tests.iter().map(|test| test.record.source.clone()).collect();
        let group = Sentence::from(phrases::LABEL_GROUP)
            .with_sentence("tests", name_several(&tests))
            .with("stated", in_words(*stated))
            .with("fitting", in_words(*fitting));
        match &labeled.unit {
            Some(unit) => Sentence::from(phrases::LABEL_GROUP_OR_UNIT)
                .with_sentence("group", group)
                .with_names("likely", &unit.likely, phrases::OR)
                .with("written", unit.written),
            None => group,
        }
    });
    let count: usize = found.iter().map(|(_, labeled)| labeled.tests.len()).sum();
    let is_mirrored = found.len() > 1 && found.iter().all(|((stated, fitting), _)| mirror[*stated] == Some(*fitting));
    let advice = if is_mirrored { phrases::LABELS_MIRRORED } else { phrases::LABELS_CHECK };
    let text = Sentence::from(phrases::LABELS_DEVIATE)
        .with("count", count)
        .with("all", all)
        .with("name", name)
        .with_sentence("groups", Sentence::list(groups.collect(), phrases::SEMICOLON))
        .with_sentence("advice", Sentence::from(advice).with("name", name));
    Some(Note { kind: "label", text })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fixtures::{Random, sine_record};

    /// Makes sine tests of (amplitude, m, peak velocity, m/s). `strength` multiplies the damping force of a damper with
    /// gas, friction and a mount that reduces the force of short strokes.
    fn campaign(strength: f64, tests: &[(f64, f64)]) -> Vec<Record> {
        let mut random = Random::new(7);
        let test = |(k, &(amplitude, speed)): (usize, &(f64, f64))| {
            // The damper is up to 30 % softer with warm oil, and softer in short strokes.
            let warm = 1.0 - 0.3 * random.uniform();
            let share = amplitude / (amplitude + 3e-4);
            let law = |v: f64| strength * if v > 0.0 { 1.6 * libm::pow(v, 0.8) } else { -0.8 * libm::pow(-v, 0.8) };
            sine_record(k, amplitude, speed, |_, v| warm * share * law(v) + 25.0 * libm::tanh(v / 0.002) - 180.0)
        };
        tests.iter().enumerate().map(test).collect()
    }

    const PLAN: [(f64, f64); 9] = [
        (0.025, 0.052),
        (0.025, 0.131),
        (0.025, 0.262),
        (0.025, 0.524),
        (0.01, 0.002),
        (0.01, 0.131),
        (0.01, 0.262),
        (0.002, 0.052),
        (0.0005, 0.131),
    ];

    fn times(record: &mut Record, channel: Channel, factor: f64) {
        let scale = |values: &mut Vec<f64>, by: f64| values.iter_mut().for_each(|v| *v *= by);
        match channel {
            Channel::Force => scale(&mut record.force, factor),
            Channel::Time => {
                scale(&mut record.time, factor);
                scale(&mut record.velocity, 1.0 / factor);
                record.peak_velocity /= factor;
            }
            _ => {
                scale(&mut record.displacement, factor);
                scale(&mut record.velocity, factor);
                record.amplitude *= factor;
                record.peak_velocity *= factor;
            }
        }
    }

    fn said(records: &[Record], options: &Options) -> String {
        let units = vec![
            (Channel::Time, Unit::Second),
            (Channel::Displacement, Unit::Millimetre),
            (Channel::Force, Unit::Newton),
        ];
        let readings = records.iter().map(|r| (r.source.clone(), Reading { units: units.clone(), options })).collect();
        let mut notes = Vec::new();
        let checked = check(records, &readings, &mut notes);
        checked.map_or_else(|e| e.to_string(), |()| notes.iter().map(|note| note.text.to_string()).collect())
    }

    /// Makes tests of an adjustable damper at the settings `values`. An increase of the setting by one multiplies the
    /// damping force by `ratio`. `label` returns the label of a test from its setting and its index among the tests of
    /// this setting.
    fn adjustable(ratio: f64, values: &[f64], label: impl Fn(f64, usize) -> f64) -> Vec<Record> {
        let at = |value: f64| {
            let tests = campaign(450.0 * libm::pow(ratio, value), &PLAN[..6]);
            let label = &label;
            tests.into_iter().enumerate().map(move |(i, mut record)| {
                record.force.iter_mut().for_each(|f| *f += 180.0);
                let value = label(value, i);
                let name = format!("{value} {} {i}", record.name);
                let setting = Setting { name: "clicks".into(), unit: String::new(), value };
                Record { source: name.clone(), name, setting: Some(setting), ..record }
            })
        };
        values.iter().copied().flat_map(at).collect()
    }

    #[test]
    fn labels_of_another_setting_are_told_from_wrong_units() {
        let values = [0.0, 1.0, 2.0, 3.0, 4.0];
        let options = Options::default();
        assert_eq!(said(&adjustable(1.8, &values, |value, _| value), &options), "");
        // One test at the hardest setting has the label of the softest one.
        let one =
            said(&adjustable(1.8, &values, |value, i| if (value, i) == (4.0, 3) { 0.0 } else { value }), &options);
        assert!(one.contains("1 of 30 tests") && one.contains("(label 0, forces of 4)"), "{one}");
        assert!(!one.contains("counted from the other end"), "{one}");
        // Tests that state no setting have no label. A file in another unit among them is still found.
        let mut partly = adjustable(1.8, &values, |value, i| if (value, i) == (4.0, 3) { 0.0 } else { value });
        partly[6..12].iter_mut().for_each(|record| record.setting = None);
        assert!(said(&partly, &options).contains("(label 0, forces of 4)"), "{}", said(&partly, &options));
        times(&mut partly[8], Channel::Force, 0.1);
        let message = said(&partly, &options);
        assert!(message.contains("daN or kgf written as N") && !message.contains("label "), "{message}");
        // At the second ratio, the forces at the two ends of the settings differ by a factor of ten, like newton and
        // decanewton.
        for ratio in [1.8, libm::pow(10.0, 0.25)] {
            let labels = |value: f64, i: usize| if i % 3 == 2 { 4.0 - value } else { value };
            let mirrored = said(&adjustable(ratio, &values, labels), &options);
            let groups = ["(label 0, forces of 4)", "(label 1, forces of 3)", "(label 4, forces of 0)"];
            assert!(groups.iter().all(|group| mirrored.contains(group)), "{mirrored}");
            assert!(mirrored.contains("counted from the other end"), "{mirrored}");
        }
    }

    #[test]
    fn tests_of_one_damper_pass_whatever_their_strokes_and_heat() {
        for strength in [100.0, 1000.0, 10_000.0] {
            assert_eq!(said(&campaign(strength, &PLAN), &Options::default()), "");
        }
        // The forces at two unstated settings differ by a factor of four and a half. The gas force is equal.
        let mut records = campaign(2000.0, &PLAN);
        for record in campaign(450.0, &PLAN) {
            records.push(Record {
                name: format!("soft {}", record.name),
                source: format!("soft {}", record.source),
                ..record
            });
        }
        assert_eq!(said(&records, &Options::default()), "");
    }

    /// Checks a damper whose springs shift the mean force at the ends of long strokes. The factor of the last file is that
    /// of no unit.
    #[test]
    fn one_file_among_many_with_another_factor_is_seen_although_springs_shift_the_mean_force() {
        let damper = || {
            let mut records = campaign(1000.0, &PLAN);
            for record in &mut records {
                let sprung = record.force.iter().zip(&record.displacement).map(|(f, x)| f + 2e5 * x * x);
                record.force = sprung.collect();
            }
            records
        };
        assert_eq!(said(&damper(), &Options::default()), "");
        let with = |place: usize, factor: f64| {
            let mut records = damper();
            times(&mut records[place], Channel::Force, factor);
            said(&records, &Options::default())
        };
        for place in 0..4 {
            let message = with(place, 1e-3);
            assert!(message.contains("kN written as N"), "{place}: {message}");
        }
        let message = with(2, 0.17);
        assert!(message.contains("0.17 times those of the other tests") || message.contains("0.16 times"), "{message}");
    }

    /// Checks a semi-active damper without gas. The forces at its settings differ by a typical ratio of two units. A
    /// file in kN is found by comparison with the tests at its own setting.
    #[test]
    fn settings_are_told_by_their_own_tests() {
        let at = |value: f64| {
            let setting = crate::quantities::setting_value::Setting { name: "current".into(), unit: "A".into(), value };
            campaign(450.0 * libm::pow(4.45, value), &PLAN[..6]).into_iter().map(move |mut record| {
                record.force.iter_mut().for_each(|f| *f += 180.0);
                let name = format!("{value} {}", record.name);
                Record { source: name.clone(), name, setting: Some(setting.clone()), ..record }
            })
        };
        let mut records: Vec<Record> = [0.0, 0.5, 1.0].into_iter().flat_map(at).collect();
        assert_eq!(said(&records, &Options::default()), "");
        times(&mut records[8], Channel::Force, 1e-3);
        let found = said(&records, &Options::default());
        assert!(found.contains("0.5 t2") && found.contains("speaks for kN written as N"), "{found}");
    }

    /// Checks settings whose forces differ by 57 % from end to end, with tests that repeat within 2 %. The labels of
    /// two of six motions count from the other end.
    #[test]
    fn labels_of_little_difference_are_seen_by_the_scatter() {
        let options = Options::default();
        let measured = |label: &dyn Fn(f64, usize) -> f64, share: &dyn Fn(usize) -> f64| {
            let mut random = Random::new(3);
            let mut records = Vec::new();
            for value in [0.0, 1.0, 2.0, 3.0, 4.0] {
                let strength = 1000.0 * libm::pow(1.12, value);
                for (i, &(amplitude, speed)) in PLAN[..6].iter().enumerate() {
                    let scale = strength * share(i) * (1.0 + 0.02 * (random.uniform() - 0.5));
                    let law = |v: f64| if v > 0.0 { 1.6 * libm::pow(v, 0.8) } else { -0.8 * libm::pow(-v, 0.8) };
                    let mut record =
                        sine_record(i, amplitude, speed, |_, v| scale * law(v) + 5.0 * libm::tanh(v / 0.002));
                    let stated = label(value, i);
                    record.name = format!("{stated} {} {i}", record.name);
                    record.source = record.name.clone();
                    record.setting = Some(Setting { name: "clicks".into(), unit: String::new(), value: stated });
                    records.push(record);
                }
            }
            said(&records, &options)
        };
        assert_eq!(measured(&|value, _| value, &|_| 1.0), "");
        let mirrored = measured(&|value, i| if [1, 3].contains(&i) { 4.0 - value } else { value }, &|_| 1.0);
        assert!(mirrored.contains("(label 0, forces of 4)") && mirrored.contains("from the other end"), "{mirrored}");
        // A motion that deviates alike at every setting has the right labels.
        assert_eq!(measured(&|value, _| value, &|i| if i == 3 { 0.7 } else { 1.0 }), "");
    }

    /// Checks campaigns in which the labels of up to half of the motions count from the other end. The forces at the
    /// ends of the settings differ by a factor of 1.7 or of 10, which is also the ratio of two units.
    #[test]
    fn motions_counted_from_the_other_end_are_named_up_to_half_of_them() {
        let values = [2.0, 6.0, 14.0, 18.0];
        for ratio in [libm::pow(1.7, 1.0 / 16.0), libm::pow(10.0, 1.0 / 16.0)] {
            // Motion 4 shares no velocity with the others, so its labels cannot be judged. In the last case, half of
            // the motions count from each end, and those without the first motion are named.
            for (wrong, all) in [(&[2][..], 6), (&[0, 3], 6), (&[3, 5], 6), (&[2, 3], 4)] {
                let labels = |value: f64, i: usize| if wrong.contains(&i) { 20.0 - value } else { value };
                let mut records = adjustable(ratio, &values, labels);
                records.retain(|record| (0..all).any(|i| record.name.ends_with(&format!(" {i}"))));
                let mirrored = said(&records, &Options::default());
                let count = format!("{} of {} tests", 4 * wrong.len(), 4 * all);
                assert!(mirrored.contains(&count), "{wrong:?} at {ratio}: {mirrored}");
                assert!(mirrored.contains("counted from the other end"), "{wrong:?} at {ratio}: {mirrored}");
                let is_named = |i: usize| mirrored.contains(&format!("t{i} {i}"));
                assert!((0..6).all(|i| is_named(i) == wrong.contains(&i)), "{wrong:?} at {ratio}: {mirrored}");
            }
            assert_eq!(said(&adjustable(ratio, &values, |value, _| value), &Options::default()), "");
        }
    }

    #[test]
    fn a_file_in_another_unit_is_named_with_the_unit() {
        for (channel, factor, likely) in [
            (Channel::Force, 1e-3, "speaks for kN written as N"),
            (Channel::Force, 0.1, "speaks for daN or kgf written as N"),
            (Channel::Force, 1.0 / 4.448, "speaks for lbf written as N"),
            (Channel::Displacement, 1.0 / 25.4, "speaks for in written as mm"),
            (Channel::Displacement, 0.1, "speaks for cm written as mm"),
            (Channel::Time, 1e3, "speaks for ms written as s"),
        ] {
            for at in [2, 3, 6] {
                let mut records = campaign(1500.0, &PLAN);
                times(&mut records[at], channel, factor);
                let message = said(&records, &Options::default());
                assert!(
                    message.contains(likely) && message.contains(&format!("t{at}.csv")),
                    "{channel} {factor} {at}: {message}"
                );
                assert!(message.contains(&format!("--unit {channel}=")), "{message}");
                let mut insisted = Options::default();
                insisted.units.insert(channel, if channel == Channel::Force { Unit::Newton } else { Unit::Millimetre });
                if channel == Channel::Force {
                    assert_eq!(said(&records, &insisted), "", "{factor}");
                }
            }
        }
    }

    #[test]
    fn where_half_of_them_are_off_both_are_named() {
        for from in [0, 4, 5] {
            let mut records = campaign(1500.0, &PLAN);
            records[from..].iter_mut().for_each(|r| times(r, Channel::Force, 1e-3));
            let message = said(&records, &Options::default());
            if from == 0 {
                // The plausibility check finds a unit that is wrong in all files.
                assert_eq!(message, "");
            } else {
                assert!(message.contains("t1.csv") && message.contains("t6.csv"), "{message}");
            }
        }
    }

    #[test]
    fn a_unit_that_no_damper_explains_may_leave_a_residual() {
        // The damper of the file with another unit is firmer than the others by 70 %.
        let named = |channel: Channel, factor: f64| {
            let mut records = campaign(1500.0, &PLAN);
            times(&mut records[2], channel, factor);
            times(&mut records[2], Channel::Force, 1.7);
            said(&records, &Options::default())
        };
        let minutes = named(Channel::Time, 1.0 / 60.0);
        assert!(minutes.contains("speaks for min written as s"), "{minutes}");
        assert_eq!(named(Channel::Displacement, 1.0 / 25.4), "");
    }
}
