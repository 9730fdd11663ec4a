//! Splits a record of several tests without a standstill between them. A drive that steps through amplitudes or
//! frequencies writes such records.
//!
//! A lasting jump of stroke or period separates two tests. A sweep, whose cycles change gradually, is one test.

use super::cycles::{self, candidates};
use super::rests::part;
use crate::data::cycle::Cycle;
use crate::data::record::Note;
use crate::data::samples::Samples;
use crate::messages::phrases;
use crate::numbers::{median, range};
use crate::signal::noise::difference_noise;
use crate::tuning::cleaning::FEWEST;
use crate::tuning::settings::{BEFORE, COVERED, JUMPS, SAME, SMALLEST, STAYS};
use dashpot_messages::Sentence;
use std::ops::Range;

/// Returns the setting of the drive for a cycle: the natural logarithms of stroke, m, and period, s.
fn setting(cycle: &Cycle) -> [f64; 2] {
    [libm::log(cycle.stroke()), libm::log(cycle.period())]
}

/// Splits a record into its tests and inserts a note about them before the other notes.
pub(crate) fn split(mut samples: Samples) -> Vec<Samples> {
    let Some(x) = samples.displacement.as_deref().filter(|x| x.iter().all(|x| x.is_finite())) else {
        return vec![samples];
    };
    let noise = difference_noise(x);
    let all = candidates(&samples.time, x, (10.0 * noise).max(SMALLEST * range(x)));
    let found = settings(&all, noise);
    // Each test extends to the middle of the interval between its cycles and those of the next.
    let middle = |k: usize| match k {
        0 => 0,
        k if k == found.len() => x.len(),
        k => (all[found[k - 1].end - 1].end + all[found[k].start].start) / 2,
    };
    let cycles_of = |span: &Range<usize>| cycles::find(&samples.time[span.clone()], &x[span.clone()]);
    let test = |(k, run): (usize, &Range<usize>)| {
        let whole = middle(k)..middle(k + 1);
        // At the ends of the record, standstill and run-down may be longer than the test, so that its cycles are not
        // found. The second choice is therefore the span of the cycles alone.
        let own = all[run.start].start..all[run.end - 1].end;
        [whole, own].into_iter().map(|span| (cycles_of(&span), span)).find(|(cycles, _)| !cycles.is_empty())
    };
    let tests: Option<Vec<(Vec<Cycle>, Range<usize>)>> = found.iter().enumerate().map(test).collect();
    let Some(tests) = tests.filter(|tests| tests.len() > 1 && tests.iter().all(|(_, span)| span.len() >= FEWEST))
    else {
        return vec![samples];
    };
    let count = tests.len();
    samples.notes.insert(0, Note { kind: "rests", text: Sentence::from(phrases::AT_SETTINGS).with("count", count) });
    let tests = tests.into_iter().enumerate();
    tests.map(|(k, (cycles, span))| part(&samples, span, (k, count), &cycles, 0.0)).collect()
}

/// Returns the range of cycles of each setting of the drive. `noise` is the standard deviation of the displacement
/// noise, m. The list is empty if there are fewer than two settings, or if they cover too few of the cycles.
fn settings(all: &[Cycle], noise: f64) -> Vec<Range<usize>> {
    let near = |a: &Cycle, b: [f64; 2]| {
        let [stroke, period] = setting(a);
        (stroke - b[0]).abs() <= SAME + 6.0 * noise / a.stroke() && (period - b[1]).abs() <= SAME
    };
    let typical =
        |cycles: &[Cycle]| [0, 1].map(|k| median(&mut cycles.iter().map(|c| setting(c)[k]).collect::<Vec<_>>()));
    let mut runs: Vec<Range<usize>> = Vec::new();
    let mut start = 0;
    while start < all.len() {
        let mut end = start + 1;
        // Compare with the cycles just before, so that slow variations of the drive are not a new setting.
        while end < all.len() && near(&all[end], typical(&all[end.saturating_sub(BEFORE).max(start)..end])) {
            end += 1;
        }
        if end - start >= STAYS {
            let joined = runs.last().filter(|last| !jumps(&all[(*last).clone()], &all[start..end], noise)).is_some();
            match runs.last_mut() {
                Some(last) if joined => last.end = end,
                _ => runs.push(start..end),
            }
        }
        start = end;
    }
    let covered: usize = runs.iter().map(Range::len).sum();
    if runs.len() < 2 || (covered as f64) < COVERED * all.len() as f64 { Vec::new() } else { runs }
}

/// Returns whether the cycles after a boundary have another setting than those before it.
///
/// Compares the last cycle before with the first cycle after. In a sweep or a slow variation of the drive, these two
/// cycles are similar.
fn jumps(before: &[Cycle], after: &[Cycle], noise: f64) -> bool {
    let scatter = |cycles: &[Cycle], k: usize| {
        let mut steps: Vec<f64> =
            cycles.windows(2).map(|pair| (setting(&pair[1])[k] - setting(&pair[0])[k]).abs()).collect();
        if steps.is_empty() { 0.0 } else { median(&mut steps) }
    };
    let (last, first) = (&before[before.len() - 1], &after[0]);
    (0..2).any(|k| {
        let usual = scatter(before, k).max(scatter(after, k));
        let of_noise = if k == 0 { 6.0 * noise / last.stroke().min(first.stroke()) } else { 0.0 };
        (setting(first)[k] - setting(last)[k]).abs() > SAME.max(JUMPS * usual) + of_noise
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fixtures::{Random, moving};
    use std::f64::consts::TAU;

    /// Makes a motion with the given amplitude, mm, and frequency, Hz, at each time, and splits it into tests.
    fn driven(seconds: f64, at: impl Fn(f64) -> (f64, f64)) -> Vec<Samples> {
        const RATE: f64 = 500.0;
        let (mut phase, mut random) = (0.0, Random::new(5));
        let n = (seconds * RATE) as usize;
        let x = (0..n).map(|i| {
            let (amplitude, frequency) = at(i as f64 / RATE);
            phase += frequency / RATE;
            1e-3 * amplitude * libm::sin(TAU * phase) + 3e-6 * random.normal()
        });
        split(moving(RATE, x.collect()))
    }

    fn names(parts: Vec<Samples>) -> Vec<String> {
        parts.into_iter().map(|part| part.name).collect()
    }

    #[test]
    fn frequencies_and_amplitudes_that_are_stepped_through_are_tests_of_their_own() {
        let frequencies = |t: f64| match t {
            t if t < 20.0 => (25.0, 0.2),
            t if t < 26.0 => (25.0, 1.0),
            t if t < 29.0 => (25.0, 2.0),
            _ => (25.0, 4.0),
        };
        let parts = driven(31.0, frequencies);
        assert_eq!(parts.iter().map(|part| part.time.len()).sum::<usize>(), 15_500, "nothing is left out");
        assert!(parts.iter().all(|part| part.notes[0].kind == "rests"));
        assert_eq!(names(parts), ["long 1 25mm 0.2Hz", "long 2 25mm 1Hz", "long 3 25mm 2Hz", "long 4 25mm 4Hz"]);
        // Real drives change from one amplitude to the next in half a second.
        let steps = |t: f64| (if t % 6.0 > 5.5 { 2.0 * (t % 6.0 - 5.5) } else { 0.0 } + (t / 6.0).floor() + 1.0) * 4.0;
        let found = names(driven(18.0, |t| (steps(t), 3.0)));
        assert_eq!(found, ["long 1 4mm 3Hz", "long 2 8mm 3Hz", "long 3 12mm 3Hz"]);
    }

    #[test]
    fn what_changes_little_by_little_or_all_the_time_is_one_test() {
        for seconds in [20.0, 60.0] {
            // Each of these is one test: a frequency sweep, an amplitude sweep, and a drive whose frequency varies by a
            // tenth.
            assert_eq!(driven(seconds, |t| (10.0, 0.5 * 16f64.powf(t / seconds))).len(), 1);
            assert_eq!(driven(seconds, |t| (2.0 + 20.0 * t / seconds, 3.0)).len(), 1);
            assert_eq!(driven(seconds, |t| (10.0, 2.0 * (1.0 + 0.1 * (TAU * t / 10.0).sin()))).len(), 1);
            // A beat, such as the sum of two sines, is one test.
            assert_eq!(driven(seconds, |t| (10.0 * (1.2 + (TAU * t / 4.0).sin()), 3.0)).len(), 1);
        }
        assert_eq!(driven(10.0, |_| (10.0, 2.0)).len(), 1);
        // Neither a run-up and run-down nor a short disturbance is a test of its own.
        assert_eq!(driven(12.0, |t| (10.0 * t.min(12.0 - t).min(1.0), 2.0)).len(), 1);
        assert_eq!(driven(20.0, |t| (if (10.0..10.4).contains(&t) { 6.0 } else { 10.0 }, 2.0)).len(), 1);
    }

    #[test]
    fn a_small_test_is_found_down_to_a_hundredth_of_the_range() {
        let parts = |small: f64| driven(12.0, |t| (if t < 6.0 { 25.0 } else { small }, 3.0)).len();
        assert_eq!((parts(0.35), parts(0.18)), (2, 1));
    }

    /// Returns cycles with these natural logarithms of the stroke.
    fn cycles_of(strokes: impl IntoIterator<Item = f64>) -> Vec<Cycle> {
        let cycle =
            |stroke: f64| Cycle { start: 0, end: 1, start_time: 0.0, end_time: 1.0, low: 0.0, high: libm::exp(stroke) };
        strokes.into_iter().map(cycle).collect()
    }

    #[test]
    fn a_cycle_is_compared_with_the_three_before_it() {
        // At two settings, the stroke grows by a fraction with each cycle. The median of three cycles lags by two.
        let found = |growth: f64, count: i32| {
            let of = |k: i32| 3.0 * f64::from(k / count) + growth * f64::from(k % count);
            settings(&cycles_of((0..2 * count).map(of)), 0.0)
        };
        assert_eq!(found(0.02, 6), [0..6, 6..12]);
        assert_eq!(found(0.03, 7), [0..6, 7..13]);
    }

    #[test]
    fn a_jump_exceeds_the_scatter_of_the_cycles_by_a_factor_of_five() {
        let separates = |jump: f64| {
            let scattered = |from: f64| cycles_of([0.0, 0.03, 0.0, 0.03, 0.0].map(|scatter| from + scatter));
            jumps(&scattered(0.0), &scattered(jump), 0.0)
        };
        assert!(separates(0.18) && !separates(0.12));
    }
}
