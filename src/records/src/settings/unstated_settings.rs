//! Detects tests with equal motion but different force.
//!
//! The cause is several dampers in one folder, or one damper at several settings (clicks of an adjuster, current of a
//! valve). One model cannot describe several settings, and a fit to all of them describes none.
//!
//! The forces determine the groups. The order of the settings by force is the same in every motion. A test with another
//! motion belongs to the setting with the most similar forces at common velocities.

use crate::checks::force_levels::{Levels, levels};
use crate::data::record::{Note, Record};
use crate::glob;
use crate::messages::phrases;
use crate::numbers::median;
use dashpot_messages::{Sentence, format_decimals};

/// Largest relative difference of stroke and peak velocity between equal motions. It is also the largest difference of
/// mean position, relative to the amplitude.
///
/// Drives reproduce these values more accurately.
const SAME: f64 = 0.1;
/// Ratio of the damping forces of two tests above which a note reports several settings. Warm oil, a break-in and the
/// scatter of the rig cause differences of a quarter.
const TIMES: f64 = 1.5;
/// Ratios of force at which settings are separated, beginning with the finest. Clicks of an adjuster may differ by less
/// than [`TIMES`]. A fine ratio counts only if it gives the same number of settings in every motion. Warming and wear
/// give different numbers in different motions.
const STEPS: [f64; 4] = [1.12, 1.2, 1.3, TIMES];
/// Smallest ratio of two distances at which a test of another motion is assigned to the nearest setting. The ratio is
/// that of the distance to the second nearest setting to the distance to the nearest. A distance is the absolute
/// natural logarithm of the ratio of the damping forces.
const NEARER: f64 = 2.0;
/// Largest difference of side force, N, and of temperature, K, between equal motions. A larger difference may explain
/// different forces of one damper, so such tests are not compared.
const SIDE_FORCE: f64 = 20.0;
const WARMER: f64 = 40.0;
/// Largest number of names of each setting in a message.
const NAMES: usize = 6;

/// Adds notes about tests with equal motion but different force. `seen` contains the force levels of each test in the
/// middle of its strokes.
pub(crate) fn report(records: &[Record], seen: &[Levels], notes: &mut Vec<Note>) {
    // A note has already named the settings, so no further note is added.
    if notes.iter().any(|note| ["settings", "changing_setting"].contains(&note.kind)) {
        return;
    }
    let motions: Vec<TestConditions> = records.iter().map(TestConditions::of).collect();
    let mut pairs = Vec::new();
    for (i, a) in motions.iter().enumerate() {
        for (j, b) in motions.iter().enumerate() {
            let times = a.is_like(b).then(|| times(&seen[i], &seen[j])).flatten();
            pairs.extend(times.filter(|times| *times > TIMES).map(|times| (times, i, j)));
        }
    }
    let Some((most, i, j)) = pairs.into_iter().max_by(|a, b| a.0.total_cmp(&b.0)) else { return };
    let Settings { settings, open } = Settings::of(records, &motions, seen);
    let names: Vec<&str> = records.iter().map(|record| record.name.as_str()).collect();
    let told = settings.iter().enumerate().map(|(k, tests)| {
        Sentence::from(phrases::SETTING).with("number", k + 1).with_sentence("names", together(&names, tests))
    });
    let open =
        (!open.is_empty()).then(|| Sentence::from(phrases::SETTING_OPEN).with_sentence("names", listed(&names, &open)));
    let belong = (settings.len() > 1).then(|| {
        let belong = Sentence::from(phrases::SETTINGS);
        belong.with_list("settings", told.collect(), phrases::SEMICOLON).with_any("open", open)
    });
    let text = Sentence::from(phrases::OTHER_SETTINGS)
        .with("first", names[i])
        .with("second", names[j])
        .with("times", format_decimals(most, 1))
        .with_any("belong", belong);
    notes.push(Note { kind: "settings", text });
}

/// Formats the names of tests. If there are many, only the first few are named.
fn listed(names: &[&str], tests: &[usize]) -> Sentence {
    let quoted = |i: &usize| Sentence::from(phrases::QUOTED).with("test", names[*i]);
    let named = Sentence::list(tests.iter().take(NAMES).map(quoted).collect(), phrases::COMMA);
    match tests.len().saturating_sub(NAMES) {
        0 => named,
        more => Sentence::from(phrases::AND_MORE).with_sentence("names", named).with("count", more),
    }
}

/// Describes the tests of a setting by a pattern, as for `--exclude`, that matches only these tests. If there is none,
/// uses their names.
pub(crate) fn together(names: &[&str], tests: &[usize]) -> Sentence {
    match pattern(names, tests) {
        Some(pattern) => Sentence::from(phrases::SETTING_ALL).with("name", pattern).with("count", tests.len()),
        None => listed(names, tests),
    }
}

/// Returns the shortest glob pattern that matches the names of `tests` and no others. The pattern contains a part of
/// the name of the first of these tests. Returns `None` if there is no such pattern or only one test.
fn pattern(names: &[&str], tests: &[usize]) -> Option<String> {
    let first: Vec<char> = names[*tests.get(1).and(tests.first())?].chars().collect();
    let is_it =
        |pattern: &String| names.iter().enumerate().all(|(k, name)| glob::matches(pattern, name) == tests.contains(&k));
    let parts = |from: usize, to: usize| first[from..to].iter().collect::<String>();
    // Use whole words and numbers of the name with their neighbors, so that c1 does not match c10, and 4A does not
    // match 0.4A.
    let is_digit = |k: Option<usize>| k.and_then(|k| first.get(k)).is_some_and(char::is_ascii_digit);
    let is_point = |k: usize| ".,".contains(first[k]) && is_digit(k.checked_sub(1)) && is_digit(Some(k + 1));
    let edges: Vec<usize> = (0..=first.len())
        .filter(|&k| {
            let is_word = |k: Option<usize>| {
                k.filter(|k| *k < first.len()).is_some_and(|k| first[k].is_alphanumeric() || is_point(k))
            };
            is_word(k.checked_sub(1)) != is_word(Some(k)) || k == 0 || k == first.len()
        })
        .collect();
    let mut found: Vec<String> = Vec::new();
    for (a, &from) in edges.iter().enumerate() {
        for &to in &edges[a + 1..] {
            let (before, behind) = (if from == 0 { "" } else { "*" }, if to == first.len() { "" } else { "*" });
            let part = parts(from, to);
            // A star that is part of a name would match any text.
            if !part.contains('*') && part.chars().any(char::is_alphanumeric) {
                found.push(format!("{before}{part}{behind}"));
            }
        }
    }
    found.sort_by_key(|pattern| pattern.chars().count());
    found.into_iter().find(is_it)
}

/// Groups of tests with one setting each.
struct Settings {
    /// The tests of each setting, from soft to hard.
    settings: Vec<Vec<usize>>,
    /// Tests whose forces do not determine their setting.
    open: Vec<usize>,
}

impl Settings {
    fn of(records: &[Record], motions: &[TestConditions], seen: &[Levels]) -> Settings {
        // Tests of one motion, each with the natural logarithm of the ratio of its damping force to that of the first
        // test.
        let mut alike: Vec<Vec<(f64, usize)>> = Vec::new();
        for (i, motion) in motions.iter().enumerate() {
            let group = alike.iter_mut().find_map(|group| {
                let (_, first) = *group.first()?;
                let times = if motion.is_like(&motions[first]) { times(&seen[i], &seen[first])? } else { return None };
                Some((group, libm::log(times)))
            });
            match group {
                Some((group, times)) => group.push((times, i)),
                None => alike.push(vec![(0.0, i)]),
            }
        }
        alike.iter_mut().for_each(|group| group.sort_by(|a, b| a.0.total_cmp(&b.0)));
        let parted = |step: f64| -> Vec<Vec<Vec<usize>>> {
            let part = |group: &Vec<(f64, usize)>| {
                group
                    .chunk_by(|a, b| b.0 - a.0 <= libm::log(step))
                    .map(|part| part.iter().map(|t| t.1).collect())
                    .collect()
            };
            alike.iter().map(part).collect()
        };
        let most = |parts: &[Vec<Vec<usize>>]| parts.iter().map(Vec::len).max().unwrap_or(0);
        // Use the finest ratio at which all motions with enough tests show an equal number of settings. Most motions
        // must show this number. With a single motion, the finest ratio would only show scatter.
        let several = alike.iter().filter(|group| group.len() > 1).count();
        let agrees = |parts: &Vec<Vec<Vec<usize>>>| {
            let most = most(parts);
            let count = |group: &Vec<Vec<usize>>| group.iter().map(Vec::len).sum::<usize>();
            let mut with_all = parts.iter().filter(|group| count(group) >= most);
            let as_many = parts.iter().filter(|group| group.len() == most).count();
            most > 1 && 2 * as_many >= several && with_all.all(|group| group.len() == most)
        };
        let finest = usize::from(several < 2);
        let agreed = STEPS[finest..].iter().map(|step| parted(*step)).find(agrees);
        // If no ratio meets the criterion, use the coarsest ratio that separates any tests.
        let coarsest = || STEPS.iter().rev().map(|step| parted(*step)).find(|parts| most(parts) > 1);
        let Some(parts) = agreed.or_else(coarsest) else {
            return Settings { settings: Vec::new(), open: (0..records.len()).collect() };
        };
        let count = most(&parts);
        let mut settings = vec![Vec::new(); count];
        let mut open: Vec<usize> = Vec::new();
        for group in parts {
            if group.len() == count {
                settings.iter_mut().zip(group).for_each(|(setting, mut part)| setting.append(&mut part));
            } else {
                open.extend(group.into_iter().flatten());
            }
        }
        // Assign tests of other motions to the known settings. Each assignment may determine further assignments. Use
        // the forces of the whole stroke, because the middles of the strokes of two motions may have no common
        // velocity.
        open.sort_unstable();
        let whole: Vec<Levels> = records.iter().map(|record| levels(record, |_| true)).collect();
        while let Some((place, setting)) =
            open.iter().enumerate().find_map(|(place, i)| Some((place, nearest(&settings, *i, &whole)?)))
        {
            settings[setting].push(open.remove(place));
        }
        settings.iter_mut().for_each(|setting| setting.sort_unstable());
        Settings { settings, open }
    }
}

/// Returns the index of the setting of a test by its forces at common velocities. Returns `None` unless the test has
/// velocities in common with every setting and is clearly nearest to one.
fn nearest(settings: &[Vec<usize>], test: usize, seen: &[Levels]) -> Option<usize> {
    let mut off: Vec<(f64, usize)> = settings
        .iter()
        .enumerate()
        .filter_map(|(k, tests)| {
            let mut ratios: Vec<f64> =
                tests.iter().filter_map(|other| Some(libm::log(times(&seen[test], &seen[*other])?))).collect();
            (!ratios.is_empty()).then(|| (median(&mut ratios).abs(), k))
        })
        .collect();
    off.sort_by(|a, b| a.0.total_cmp(&b.0));
    let (&(own, k), &(next, _)) = (off.first()?, off.get(1)?);
    (off.len() == settings.len() && next > NEARER * own && next > libm::log(STEPS[0])).then_some(k)
}

/// Mean motion and load of a test: amplitude, m, velocity, m/s, position, m, side force, N, and temperature, °C.
struct TestConditions {
    amplitude: f64,
    peak_velocity: f64,
    is_periodic: bool,
    place: f64,
    side_force: Option<f64>,
    temperature: Option<f64>,
}

impl TestConditions {
    fn of(record: &Record) -> TestConditions {
        let mean = |values: &[f64]| values.iter().filter(|v| v.is_finite()).sum::<f64>() / values.len().max(1) as f64;
        TestConditions {
            amplitude: record.amplitude,
            peak_velocity: record.peak_velocity,
            is_periodic: record.frequency > 0.0,
            place: mean(&record.displacement),
            side_force: record.side_force.as_deref().map(mean),
            temperature: record.temperature.as_deref().map(mean),
        }
    }

    /// Returns whether another test has a similar motion, position, side force and temperature.
    fn is_like(&self, other: &TestConditions) -> bool {
        let alike = |a: f64, b: f64| a > 0.0 && b > 0.0 && (a - b).abs() <= SAME * a.max(b);
        let near = |a: Option<f64>, b: Option<f64>, within: f64| match (a, b) {
            (Some(a), Some(b)) => (a - b).abs() <= within,
            (None, None) => true,
            _ => false,
        };
        alike(self.amplitude, other.amplitude)
            && alike(self.peak_velocity, other.peak_velocity)
            && self.is_periodic == other.is_periodic
            && (self.place - other.place).abs() <= SAME * self.amplitude
            && near(self.side_force, other.side_force, SIDE_FORCE)
            && near(self.temperature, other.temperature, WARMER)
    }
}

/// Returns the median ratio of the damping forces at common velocities. Returns `None` if there are no common
/// velocities.
fn times(a: &Levels, b: &Levels) -> Option<f64> {
    let both = a.iter().filter_map(|(level, a)| Some((a.against, b.get(level)?.against)));
    let mut ratios: Vec<f64> = both.filter(|(a, b)| *a > 0.0 && *b > 0.0).map(|(a, b)| a / b).collect();
    (!ratios.is_empty()).then(|| median(&mut ratios))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::checks::force_levels::in_the_middle;
    use crate::fixtures::sine_record;

    /// Makes four sine tests of each of several dampers. `strengths` are factors on the damping of 1500 N s/m, one for
    /// each damper.
    fn campaign(strengths: &[f64]) -> Vec<Record> {
        let plan = [(0.02, 0.05), (0.02, 0.2), (0.005, 0.2), (0.02, 0.5)];
        let all = strengths.iter().flat_map(|strength| plan.map(|(amplitude, speed)| (*strength, amplitude, speed)));
        let test = |(k, (strength, amplitude, speed)): (usize, (f64, f64, f64))| {
            sine_record(k, amplitude, speed, |_, v| strength * 1500.0 * v + 20.0 * libm::tanh(v / 0.002) - 150.0)
        };
        all.enumerate().map(test).collect()
    }

    fn said(records: &[Record]) -> String {
        let mut notes = Vec::new();
        report(records, &in_the_middle(records), &mut notes);
        notes.iter().map(|n| format!("[{}] {}\n", n.kind, n.text)).collect()
    }

    #[test]
    fn two_settings_in_one_folder_are_told_with_their_tests() {
        let text = said(&campaign(&[1.0, 4.0]));
        assert!(text.starts_with("[settings] ") && text.contains("times"), "{text}");
        // The note names the tests with the large forces and those with the small forces.
        for k in 0..8 {
            assert!(text.contains(&format!("t{k}")), "{k}: {text}");
        }
        assert!(text.contains("1) 't0', 't1', 't2', 't3'; 2) 't4', 't5', 't6', 't7'"), "{text}");
        // One test among many deviates, and the note names it.
        let mut odd = campaign(&[1.0, 1.05, 0.95]);
        odd.push(campaign(&[1.0, 3.0]).pop().unwrap());
        assert!(said(&odd).contains("t7"), "{}", said(&odd));
    }

    /// Makes a campaign with test names that contain the click. The tests are in mixed order.
    fn clicks(strengths: &[f64]) -> Vec<Record> {
        let mut records = campaign(strengths);
        for (k, record) in records.iter_mut().enumerate() {
            record.name = format!("s{}_c{}", k % 4, 9 + k / 4);
        }
        records.sort_by(|a, b| a.name.cmp(&b.name));
        records
    }

    #[test]
    fn clicks_that_are_close_are_told_apart_and_by_what_their_names_share() {
        let text = said(&clicks(&[1.0, 1.25, 1.6, 2.0, 2.5]));
        for (k, click) in [(1, 9), (2, 10), (3, 11), (4, 12), (5, 13)] {
            assert!(text.contains(&format!("{k}) all of '*c{click}' (4)")), "{k} {click}: {text}");
        }
        assert!(!text.contains("does not tell"), "{text}");
        // Warm oil in a single motion is not a separate setting.
        let mut warm = clicks(&[1.0, 3.0]);
        let odd = warm.iter().position(|r| r.name == "s1_c9").unwrap();
        let mut again = warm[odd].clone();
        again.name = "again_c9".into();
        again.force.iter_mut().for_each(|f| *f *= 0.85);
        warm.push(again);
        let text = said(&warm);
        assert!(text.contains("1) all of '*c9' (5); 2) all of '*c10' (4)"), "{text}");
    }

    #[test]
    fn a_test_of_another_motion_belongs_where_its_forces_are() {
        let mut records = clicks(&[1.0, 1.6, 2.6]);
        let odd = |strength: f64, speed: f64| {
            sine_record(99, 0.033, speed, |_, v| strength * 1500.0 * v + 20.0 * libm::tanh(v / 0.002) - 150.0)
        };
        let named = |name: &str, record: Record| Record { name: name.into(), ..record };
        records.push(named("odd_c10", odd(1.6, 0.45)));
        records.push(named("between", odd(2.05, 0.45)));
        records.push(named("fast", odd(1.0, 8.0)));
        let text = said(&records);
        assert!(text.contains("2) all of '*c10' (5)"), "{text}");
        assert!(text.contains("of 'between', 'fast' the force does not tell it"), "{text}");
    }

    #[test]
    fn one_damper_that_scatters_or_is_loaded_from_the_side_is_one() {
        assert_eq!(said(&campaign(&[1.0, 1.2, 0.9])), "");
        let mut loaded = campaign(&[1.0, 2.0]);
        for (k, record) in loaded.iter_mut().enumerate() {
            record.side_force = Some(vec![if k < 4 { 0.0 } else { 800.0 }; record.time.len()]);
        }
        assert_eq!(said(&loaded), "");
    }
}
