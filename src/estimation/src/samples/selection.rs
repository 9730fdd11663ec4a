//! Selection of the tests of a very large campaign that a fit uses.
//!
//! Every test costs about the same time. Beyond a few hundred tests, further tests rarely contain a new motion, so a
//! selection represents all of them. The selection includes every kind of motion in turn, and is spread over the whole
//! campaign.

use dashpot_records::{Record, SettingPattern};
use std::collections::BTreeMap;

/// Largest number of tests in a fit.
///
/// With this number, a fit to a campaign of 8,000 tests takes 34 s of processor time. With all tests, it takes more
/// than 115 s. The time is proportional to the number of tests. A test matrix has some dozens of kinds of motion, so a
/// smaller number would omit some of them.
pub const MOST_TESTS: usize = 240;
/// Number of bins of amplitude and of peak velocity per octave. Tests of one nominal motion are in one or two bins.
const PER_OCTAVE: f64 = 2.0;
/// Number of bins of the mean displacement over the range of the campaign.
const MEANS: f64 = 8.0;
/// Largest factor by which bins are widened to merge kinds. Kinds that differ otherwise, such as with and without
/// cycles, never merge.
const WIDEST: f64 = 1024.0;
/// Widths of the bins of temperature, K, and of side force, N.
const TEMPERATURE: f64 = 10.0;
const SIDE_FORCE: f64 = 50.0;

/// Number of bins of a setting that changes within a test, over the range of the campaign.
const SETTINGS: f64 = 4.0;

/// Kind of motion of a test.
///
/// It consists of the bins of amplitude, peak velocity, mean displacement, temperature and side force, and a flag for a
/// test without cycles. For a changing setting, it also contains a flag for steps, and the lowest and highest value.
type Kind = (i64, i64, i64, i64, i64, bool, Option<(bool, i64, i64)>);

/// Ranges of the campaign that are divided into bins.
struct Ranges {
    mean: (f64, f64),
    setting: (f64, f64),
}

/// Returns the smallest and the largest value.
fn extremes(values: impl Iterator<Item = f64>) -> (f64, f64) {
    values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)))
}

/// Returns the bin of a channel's mean for bins of the given width, or 0 if the channel is missing.
fn bin(channel: Option<&Vec<f64>>, width: f64) -> i64 {
    channel.filter(|c| !c.is_empty()).map_or(0, |c| (c.iter().sum::<f64>() / c.len() as f64 / width).round() as i64)
}

/// Returns the bin of a value in a range with `bins` bins. A range below `least` counts as `least`.
fn bin_of_range(value: f64, (low, high): (f64, f64), bins: f64, least: f64) -> i64 {
    (bins * (value - low) / (high - low).max(least)).round() as i64
}

/// Returns the kind of a test in bins that are `wide` times as wide as those of the constants of this module.
fn kind(record: &Record, ranges: &Ranges, wide: f64) -> Kind {
    let octaves = |value: f64| (PER_OCTAVE / wide * libm::log2(value.max(1e-9))).round() as i64;
    let setting = record.setting_signal.as_ref().map(|signal| {
        let [low, high] = signal.range.map(|value| bin_of_range(value, ranges.setting, SETTINGS / wide, 1e-9));
        (signal.pattern == SettingPattern::Steps, low, high)
    });
    (
        octaves(record.amplitude),
        octaves(record.peak_velocity),
        bin_of_range(record.mean_displacement, ranges.mean, MEANS / wide, 1e-3),
        bin(record.temperature.as_ref(), wide * TEMPERATURE),
        bin(record.side_force.as_ref(), wide * SIDE_FORCE),
        record.cycles.is_empty(),
        setting,
    )
}

/// Selects the indices of the tests that a fit uses, in increasing order. Returns `None` if the fit uses all of them.
pub fn select(records: &[&Record]) -> Option<Vec<usize>> {
    select_at_most(records, MOST_TESTS)
}

/// Selects the indices of at most `most` tests, from every kind of motion, in increasing order. Returns `None` if there
/// are no more than `most` tests.
pub fn select_at_most(records: &[&Record], most: usize) -> Option<Vec<usize>> {
    if records.len() <= most {
        return None;
    }
    let ranges = Ranges {
        mean: extremes(records.iter().map(|r| r.mean_displacement)),
        setting: extremes(records.iter().filter_map(|r| r.setting_signal.as_ref()).flat_map(|of| of.range)),
    };
    let sort = |wide: f64| {
        let mut kinds: BTreeMap<Kind, Vec<usize>> = BTreeMap::new();
        for (place, record) in records.iter().enumerate() {
            kinds.entry(kind(record, &ranges, wide)).or_default().push(place);
        }
        kinds
    };
    // If there are more kinds than selected tests, use wider bins, so that every kind is represented.
    let mut wide = 1.0;
    let mut kinds = sort(wide);
    while kinds.len() > most && wide < WIDEST {
        wide *= 2.0;
        kinds = sort(wide);
    }
    // Select one test of each kind in turn up to the limit. Rare kinds come first, so that each is represented.
    let mut kinds: Vec<Vec<usize>> = kinds.into_values().collect();
    kinds.sort_by_key(|places| (places.len(), places[0]));
    let mut counts = vec![0; kinds.len()];
    let mut left = most;
    while left > 0 {
        for (count, places) in counts.iter_mut().zip(&kinds) {
            if left > 0 && *count < places.len() {
                *count += 1;
                left -= 1;
            }
        }
    }
    let spread = |(places, count): (&Vec<usize>, &usize)| -> Vec<usize> {
        (0..*count).map(|k| places[k * places.len() / count]).collect()
    };
    let mut selected: Vec<usize> = kinds.iter().zip(&counts).flat_map(spread).collect();
    selected.sort_unstable();
    Some(selected)
}

/// Returns the largest number of tests at each of `settings` settings in the fit of an adjustable damper.
///
/// The total is twice the number in an ordinary fit. A test matrix has some dozens of kinds of motion, and the limit
/// retains them at each setting.
pub fn most_at_setting(settings: usize) -> usize {
    2 * MOST_TESTS / settings.max(1)
}

/// Largest number of tests with a changing setting for the identification of an actuator. Each test is simulated over
/// its full length, with short steps during the responses of the valve.
pub const MOST_CHANGING: usize = 24;

#[cfg(test)]
mod tests {
    use super::*;
    use dashpot_records::SettingSignal;

    fn record(amplitude: f64, peak_velocity: f64, mean_displacement: f64) -> Record {
        Record { amplitude, peak_velocity, mean_displacement, cycles: vec![0..1, 1..2], ..Record::default() }
    }

    #[test]
    fn every_kind_of_motion_is_selected_and_repetitions_are_not() {
        let mut records: Vec<Record> = (0..8000).map(|k| record(0.01, 0.1 * f64::from(1 + k % 3), 0.0)).collect();
        records[4321] = record(0.05, 0.3, 0.0);
        records[77] = record(0.01, 0.1, 0.03);
        let refs: Vec<&Record> = records.iter().collect();
        let selected = select(&refs).unwrap();
        assert_eq!(selected.len(), MOST_TESTS);
        assert!(selected.is_sorted() && selected.contains(&4321) && selected.contains(&77));
        for velocity in [0.1, 0.2, 0.3] {
            let of_it: Vec<usize> =
                selected.iter().copied().filter(|k| (records[*k].peak_velocity - velocity).abs() < 1e-9).collect();
            assert!(of_it.len() >= 79, "{velocity}: {}", of_it.len());
            // The selection spans the campaign from the first tests to the last ones.
            assert!(of_it[0] < 100 && of_it[of_it.len() - 1] > 7800, "{of_it:?}");
        }
        assert_eq!(select(&refs[..MOST_TESTS]), None);
    }

    #[test]
    fn steps_between_all_levels_are_selected() {
        let mut records: Vec<Record> = (0..300).map(|_| record(0.01, 0.1, 0.0)).collect();
        for (k, of) in records.iter_mut().enumerate() {
            let (low, high) = [(0.0, 1.6), (0.0, 0.4), (1.2, 1.6)][usize::from(k % 50 == 7) + usize::from(k == 157)];
            let values: Vec<f64> = (0..40).map(|i| if i < 20 { low } else { high }).collect();
            of.setting_signal = Some(SettingSignal::new("current", "A", &values));
        }
        let refs: Vec<&Record> = records.iter().collect();
        let selected = select_at_most(&refs, MOST_CHANGING).unwrap();
        assert_eq!(selected.len(), MOST_CHANGING);
        for k in [7, 57, 107, 157, 207, 257] {
            assert!(selected.contains(&k), "{k}: {selected:?}");
        }
        // The selection also works if the number of tests is below the number of kinds.
        assert_eq!(select_at_most(&refs, 2).unwrap().len(), 2);
    }

    #[test]
    fn more_kinds_of_motion_than_tests_are_seen_over_their_whole_range() {
        // The campaign has 400 kinds, 40 speeds at each of 10 amplitudes, and one further kind with half of all tests.
        let octaves = |k: i32| libm::exp2(f64::from(k) / 2.0);
        let records: Vec<Record> = (0..2000)
            .map(|k| record(0.001 * octaves(k % 10), 1e-4 * octaves(k / 10 % 40), 0.0))
            .chain((0..2000).map(|_| record(0.1, 200.0, 0.0)))
            .collect();
        let refs: Vec<&Record> = records.iter().collect();
        let selected = select(&refs).unwrap();
        assert_eq!(selected.len(), MOST_TESTS);
        assert!(selected.iter().any(|k| *k >= 2000), "the most common kind is missing");
        let speeds = || selected.iter().map(|k| records[*k].peak_velocity);
        // The bins are twice as wide, so a speed half an octave from an end represents that end.
        assert!(speeds().any(|v| v < 1.5e-4));
        assert!(speeds().any(|v| v > 1e-4 * octaves(38) && v < 1e-4 * octaves(40)));
    }
}
