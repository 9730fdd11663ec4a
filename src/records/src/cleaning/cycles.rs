//! Finds the whole cycles of a periodic test in its displacement.
//!
//! A cycle runs from one upward crossing of the mean to the next. The mean is local, midway between the neighboring
//! turning points, so that a slow drift has no effect. Turning points count only if the motion between them exceeds a
//! threshold, so that noise has no effect. The frequency may vary, because some drives have no speed control. Cycles
//! whose stroke or period differs from the rest (run-up, run-down, a pause) are excluded.

use super::drift::time_mean;
use crate::data::cycle::Cycle;
use crate::numbers::restrict;
use crate::numbers::{median, quantile, range, sample_time};
use crate::signal::noise::difference_noise;
use crate::tuning::cycles::{END_TOLERANCE, LIKENESS, LONELY, TOLERANCE, WIGGLE};

/// Number of phases at which the shapes of cycles are compared.
const PHASES: usize = 64;

/// Finds the whole cycles. Returns an empty list if the motion is not periodic.
pub(crate) fn find(time: &[f64], displacement: &[f64]) -> Vec<Cycle> {
    let whole = range(displacement);
    if displacement.len() < 8 || whole == 0.0 {
        return Vec::new();
    }
    let noise = difference_noise(displacement);
    let floor = (8.0 * noise).max(1e-3 * whole);
    // The rig may have moved to its start position before the test. The stroke of the test is then a small part of the
    // whole range, so its cycles require a smaller threshold.
    let mut threshold = 0.3 * whole;
    for _ in 0..7 {
        if threshold < floor {
            break;
        }
        let cycles = find_with(time, displacement, threshold, noise);
        if !cycles.is_empty() {
            return cycles;
        }
        threshold *= 0.4;
    }
    Vec::new()
}

fn find_with(time: &[f64], x: &[f64], threshold: f64, noise: f64) -> Vec<Cycle> {
    let candidates = candidates(time, x, threshold);
    if candidates.is_empty() {
        return candidates;
    }
    let stroke = |c: &Cycle| c.stroke();
    let (typical_stroke, stroke_tolerance) = typical(&candidates, stroke, TOLERANCE.0);
    // Noise scatters the strokes of equal cycles, so the tolerance is at least six standard deviations of the noise.
    let stroke_tolerance = stroke_tolerance.max(6.0 * noise / typical_stroke);
    let (typical_period, period_tolerance) = typical(&candidates, Cycle::period, TOLERANCE.0);
    let accepted: Vec<Cycle> = candidates
        .iter()
        .copied()
        .filter(|c| (c.stroke() / typical_stroke - 1.0).abs() <= stroke_tolerance)
        .filter(|c| (c.period() / typical_period - 1.0).abs() <= period_tolerance)
        .filter(|c| {
            let span = &time[c.start..c.end];
            let hole = span.windows(2).map(|w| w[1] - w[0]).fold(0.0, f64::max);
            span.len() >= 8 && hole < 0.15 * c.period()
        })
        .collect();
    // Run-up and run-down take one or two cycles each. Most of the other cycles must be alike.
    let run_up = 4.min(candidates.len().saturating_sub(accepted.len()));
    if accepted.is_empty() || 2 * accepted.len() < candidates.len() - run_up / 2 {
        return Vec::new();
    }
    let covered: f64 = accepted.iter().map(Cycle::period).sum();
    if covered < 0.1 * (time[time.len() - 1] - time[0]) {
        return Vec::new();
    }
    // A road motion also contains swings of similar size and duration. They are cycles only if their shapes are
    // similar.
    let shapes: Vec<[f64; PHASES]> = accepted.iter().map(|c| shape(time, x, c)).collect();
    let mut likeness: Vec<f64> = shapes
        .windows(2)
        .map(|pair| pair[0].iter().zip(&pair[1]).map(|(a, b)| a * b).sum::<f64>() / PHASES as f64)
        .collect();
    if !likeness.is_empty() && median(&mut likeness) < LIKENESS {
        return Vec::new();
    }
    let mut cycles = refine(time, x, accepted);
    if drop_run_up(&mut cycles, noise) {
        cycles = refine(time, x, cycles);
    }
    if stand_alone(time, x, &cycles, noise) { cycles } else { Vec::new() }
}

/// Returns whether the cycles suffice for a test. One or two cycles must have the shape of a test cycle. Two cycles
/// must also agree in stroke and period.
fn stand_alone(time: &[f64], x: &[f64], cycles: &[Cycle], noise: f64) -> bool {
    let looks_made = |c: &Cycle| {
        // A road profile has more turning points. A cycle of a drive has one stroke in each direction.
        let turns = turning_points(&x[c.start..c.end], (WIGGLE * c.stroke()).max(8.0 * noise)).len();
        turns <= 4 && fundamental_share(time, x, c) >= LONELY
    };
    match cycles {
        [one, other] => {
            let tolerance = TOLERANCE.0 + 6.0 * noise / one.stroke();
            let alike = |a: f64, b: f64| (a / b - 1.0).abs() <= tolerance;
            alike(one.stroke(), other.stroke())
                && alike(one.period(), other.period())
                && looks_made(one)
                && looks_made(other)
        }
        [one] => looks_made(one),
        _ => true,
    }
}

/// Removes first and last cycles that the end of a run-up or run-down distorts. Returns whether any were removed.
fn drop_run_up(cycles: &mut Vec<Cycle>, noise: f64) -> bool {
    let before = cycles.len();
    let (stroke, stroke_tolerance) = typical(cycles, Cycle::stroke, END_TOLERANCE);
    let (period, period_tolerance) = typical(cycles, Cycle::period, END_TOLERANCE);
    let stroke_tolerance = stroke_tolerance.max(6.0 * noise / stroke);
    let bent = |c: &Cycle| {
        (c.stroke() / stroke - 1.0).abs() > stroke_tolerance || (c.period() / period - 1.0).abs() > period_tolerance
    };
    while cycles.len() > 2 && cycles.first().is_some_and(bent) {
        cycles.remove(0);
    }
    while cycles.len() > 2 && cycles.last().is_some_and(bent) {
        cycles.pop();
    }
    cycles.len() < before
}

/// Moves the crossings to the mean of the found cycles. The first estimate is the mean between turning points, which
/// run-up and run-down shift at the first and last crossing.
fn refine(time: &[f64], x: &[f64], mut cycles: Vec<Cycle>) -> Vec<Cycle> {
    let means: Vec<f64> = cycles.iter().map(|c| time_mean(time, x, c.start, c.end)).collect();
    let joined = |k: usize| k > 0 && k < cycles.len() && cycles[k - 1].end == cycles[k].start;
    // Mean displacement at the start or at the end of cycle k: the mean of the two cycles that join there, else
    // extrapolated.
    let level = |k: usize, at_end: bool| {
        let (before, after) = if at_end { (k, k + 1) } else { (k.wrapping_sub(1), k) };
        if joined(after) {
            0.5 * (means[before] + means[after])
        } else if at_end && joined(k) {
            means[k] + 0.5 * (means[k] - means[k - 1])
        } else if !at_end && joined(k + 1) {
            means[k] + 0.5 * (means[k] - means[k + 1])
        } else {
            means[k]
        }
    };
    let step = sample_time(time);
    let moved = |index: usize, at: f64, level: f64, cycle: &Cycle| -> (usize, f64) {
        let quarter = (cycle.end - cycle.start) / 4;
        let (low, high) = (index.saturating_sub(quarter), (index + quarter).min(x.len() - 1));
        // Find the sample before the crossing, close to the first estimate.
        let beside = index.min(x.len() - 1);
        let near = if x[beside] >= level {
            (low..beside).rev().find(|&i| x[i] < level).unwrap_or(beside)
        } else {
            (beside + 1..=high).find(|&i| x[i] >= level).map_or(beside, |i| i - 1)
        };
        match crossing_time(time, x, near, level, 0.15 * cycle.stroke(), low..=high) {
            Some(at) if at >= time[0] - 1.5 * step && at <= time[x.len() - 1] + 1.5 * step => {
                (time.partition_point(|&t| t < at - 0.1 * step), at)
            }
            _ => (index, at),
        }
    };
    let mut refined: Vec<Cycle> = Vec::with_capacity(cycles.len());
    for (k, cycle) in cycles.iter().enumerate() {
        let (start, start_time) = match refined.last() {
            Some(before) if joined(k) => (before.end, before.end_time),
            _ => moved(cycle.start, cycle.start_time, level(k, false), cycle),
        };
        let (end, end_time) = moved(cycle.end, cycle.end_time, level(k, true), cycle);
        refined.push(Cycle { start, end, start_time, end_time, ..*cycle });
    }
    let sound = refined.iter().all(|c| c.end > c.start + 4 && c.end_time > c.start_time)
        && refined.windows(2).all(|pair| pair[0].end <= pair[1].start);
    if sound {
        cycles = refined;
    }
    cycles
}

/// Returns the median of a quantity and its relative tolerance, which is at least `least` and at most the upper limit
/// of [`TOLERANCE`].
fn typical(cycles: &[Cycle], of: impl Fn(&Cycle) -> f64, least: f64) -> (f64, f64) {
    let centre = median(&mut cycles.iter().map(&of).collect::<Vec<_>>());
    let scatter = 1.4826 * median(&mut cycles.iter().map(|c| (of(c) - centre).abs()).collect::<Vec<_>>());
    (centre, restrict(4.0 * scatter / centre, least, TOLERANCE.1))
}

/// Returns the intervals between successive upward crossings of the level midway between the turning points. These
/// candidates for cycles are not checked for similarity. Successive turning points differ by more than `threshold`.
pub(super) fn candidates(time: &[f64], x: &[f64], threshold: f64) -> Vec<Cycle> {
    let turns = turning_points(x, threshold);
    let crossings = crossings(time, x, &turns);
    crossings
        .windows(2)
        .filter(|pair| pair[1].0 > pair[0].0)
        .map(|pair| {
            let ((start, start_time), (end, end_time)) = (pair[0], pair[1]);
            let inside = &x[start..end];
            // If spikes have been removed, the extremes are those of the motion. While a record is split into tests, a
            // spike may still change the extremes.
            let (low, high) = inside.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), &v| (l.min(v), h.max(v)));
            Cycle { start, end, start_time, end_time, low, high }
        })
        .collect()
}

/// Finds the turning points of a signal: alternating minima and maxima that differ by more than `threshold`. The first
/// and the last index may be ends of the record instead.
pub(crate) fn turning_points(x: &[f64], threshold: f64) -> Vec<usize> {
    let mut turns = Vec::new();
    let (mut low, mut high) = (0, 0);
    // 1 while rising, −1 while falling, 0 before the first swing.
    let mut direction = 0;
    for (i, &v) in x.iter().enumerate() {
        if v < x[low] {
            low = i;
        }
        if v > x[high] {
            high = i;
        }
        if direction >= 0 && x[high] - v > threshold {
            turns.push(high);
            direction = -1;
            low = i;
        } else if direction <= 0 && v - x[low] > threshold {
            turns.push(low);
            direction = 1;
            high = i;
        }
    }
    match direction {
        1 => turns.push(high),
        -1 => turns.push(low),
        _ => {}
    }
    turns
}

/// Finds the sample index and time of the upward crossing of every rising flank.
fn crossings(time: &[f64], x: &[f64], turns: &[usize]) -> Vec<(usize, f64)> {
    let step = sample_time(time);
    let mut crossings = Vec::new();
    for k in 0..turns.len().saturating_sub(1) {
        let (low, high) = (turns[k], turns[k + 1]);
        if x[low] >= x[high] {
            continue;
        }
        let (first, last) = (k == 0, k + 2 == turns.len());
        // The level is midway between the turns around the flank. A flank at an end of the record has no turning point
        // at that end.
        let before = (k > 0).then(|| 0.5 * (x[low] + 0.5 * (x[turns[k - 1]] + x[high])));
        let after = turns.get(k + 2).map(|&next| 0.5 * (x[high] + 0.5 * (x[low] + x[next])));
        let mean = match (before, after) {
            _ if first && last => continue,
            (_, Some(_)) if first => 0.5 * (x[high] + x[turns[k + 2]]),
            (Some(_), _) if last => 0.5 * (x[low] + x[turns[k - 1]]),
            (Some(before), Some(after)) => 0.5 * (before + after),
            _ => continue,
        };
        let flank = low..=high;
        // The standstill before the first flank or after the last flank may lie at the level of the crossing. Use the
        // crossing closest to the motion.
        let below = if last {
            flank.clone().find(|&i| x[i] >= mean).map(|i| i.saturating_sub(1).max(low))
        } else {
            flank.clone().rev().find(|&i| x[i] < mean)
        };
        let near = below.unwrap_or(if last { high } else { low });
        let band = 0.15 * (x[high] - x[low]);
        let Some(at) = crossing_time(time, x, near, mean, band, low..=high) else {
            continue;
        };
        // If a record begins or ends at a crossing, the computed crossing may be one sample outside the record. It is
        // accepted up to one and a half time steps outside.
        if at < time[low] - 1.5 * step || at > time[high] + 1.5 * step {
            continue;
        }
        // A crossing within a tenth of a step after a sample is assigned to that sample.
        let index = time.partition_point(|&t| t < at - 0.1 * step);
        crossings.push((index, at));
    }
    crossings
}

/// Computes the time, s, at which the displacement crosses `level`, m, near sample `near`. The method is a
/// straight-line fit to the samples of the flank within `band`, m, of the level. Returns `None` if the fit does not
/// rise or has one sample.
///
/// Interpolation between only two samples would add their noise to the crossing time.
fn crossing_time(
    time: &[f64],
    x: &[f64],
    near: usize,
    level: f64,
    band: f64,
    flank: std::ops::RangeInclusive<usize>,
) -> Option<f64> {
    let (low, high) = (*flank.start(), *flank.end());
    let reach = ((high - low) / 4).max(2);
    let inside = |i: usize| (x[i] - level).abs() <= band;
    let from = (near.saturating_sub(reach).max(low)..=near).rev().take_while(|&i| inside(i)).last().unwrap_or(near);
    let to =
        (near..=(near + reach).min(high)).skip(1).take_while(|&i| inside(i)).last().unwrap_or((near + 1).min(high));
    if to <= from {
        return None;
    }
    let count = (to - from + 1) as f64;
    let centre = time[from..=to].iter().sum::<f64>() / count;
    let middle = x[from..=to].iter().sum::<f64>() / count;
    let (mut sxt, mut stt) = (0.0, 0.0);
    for i in from..=to {
        sxt += (time[i] - centre) * (x[i] - middle);
        stt += (time[i] - centre).powi(2);
    }
    let slope = sxt / stt;
    (slope > 0.0).then(|| centre + (level - middle) / slope)
}

/// Returns the shape of a cycle at equally spaced phases, without its mean and scaled to a root mean square of one.
fn shape(time: &[f64], x: &[f64], cycle: &Cycle) -> [f64; PHASES] {
    let mut shape = [0.0; PHASES];
    for (k, value) in shape.iter_mut().enumerate() {
        let at = cycle.start_time + cycle.period() * (k as f64 + 0.5) / PHASES as f64;
        let after = restrict(time.partition_point(|&t| t <= at), 1, time.len() - 1);
        let weight = (at - time[after - 1]) / (time[after] - time[after - 1]);
        *value = x[after - 1] + weight * (x[after] - x[after - 1]);
    }
    let mean = shape.iter().sum::<f64>() / PHASES as f64;
    let scale = (shape.iter().map(|v| (v - mean).powi(2)).sum::<f64>() / PHASES as f64).sqrt();
    shape.map(|v| (v - mean) / scale)
}

/// Returns the fraction of a cycle's variance that is due to its fundamental.
fn fundamental_share(time: &[f64], x: &[f64], cycle: &Cycle) -> f64 {
    let span = cycle.start..cycle.end;
    let mean = x[span.clone()].iter().sum::<f64>() / span.len() as f64;
    let (mut c, mut s, mut total) = (0.0, 0.0, 0.0);
    for i in span.clone() {
        let phase = std::f64::consts::TAU * (time[i] - cycle.start_time) / cycle.period();
        let value = x[i] - mean;
        c += value * libm::cos(phase);
        s += value * libm::sin(phase);
        total += value * value;
    }
    2.0 * (c * c + s * s) / (span.len() as f64 * total)
}

/// Returns a peak of the absolute values that is robust against single noisy samples.
///
/// The peak is the median over the cycles of the 99th percentile in each cycle. For a sine, it is 0.01 % smaller than
/// the amplitude. Without cycles, the peak is the 99.5th percentile of all values.
pub(crate) fn robust_peak(values: &[f64], cycles: &[Cycle]) -> f64 {
    let peak = |span: &[f64]| quantile(&mut span.iter().map(|v| v.abs()).collect::<Vec<_>>(), 0.99);
    if cycles.is_empty() {
        return quantile(&mut values.iter().map(|v| v.abs()).collect::<Vec<_>>(), 0.995);
    }
    median(&mut cycles.iter().map(|c| peak(&values[c.start..c.end])).collect::<Vec<_>>())
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use dashpot_test_support::drawn;
    use proptest::prelude::*;

    use super::*;
    use crate::fixtures::{Random, SineTest};

    #[test]
    fn rest_run_up_and_run_down_are_no_cycles() {
        for cycles_made in [1, 2, 3, 10] {
            let test = SineTest { cycles: cycles_made, ..SineTest::default() };
            let samples = test.samples();
            let cycles = find(&samples.time, samples.displacement.as_ref().unwrap());
            assert_eq!(cycles.len(), cycles_made);
            for (k, cycle) in cycles.iter().enumerate() {
                let start = test.steady_from() + (k as f64 - 0.37 / 200.0) * test.period();
                assert!((cycle.start_time - start).abs() < 0.01 * test.period(), "{k}: {} {start}", cycle.start_time);
                assert!((cycle.stroke() - 0.1).abs() < 1e-4);
            }
        }
    }

    #[test]
    fn a_record_that_is_whole_cycles_already_keeps_them_all() {
        for n in [1000, 1001] {
            let time: Vec<f64> = (0..n).map(|i| f64::from(i) / 200.0).collect();
            let x: Vec<f64> = time.iter().map(|t| libm::sin(TAU * t)).collect();
            let cycles = find(&time, &x);
            assert_eq!(cycles.len(), 5, "{n}");
            assert_eq!((cycles[0].start, cycles[4].end), (0, 1000));
        }
    }

    proptest! {
        #![proptest_config(drawn(60))]
        #[test]
        fn wandering_frequency_and_mean_and_noise_do_no_harm(
            seed in 0..1000_u64,
            frequency in 0.006..20.0_f64,
            wander in 0.0..0.03_f64,
            drift in -0.01..0.01_f64,
            noise in 0.0..0.02_f64,
        ) {
            let mut random = Random::new(seed);
            let per_cycle = 150.0;
            let time: Vec<f64> = (0..1800).map(|i| f64::from(i) / per_cycle / frequency).collect();
            // Phase in cycles. The test has 12 cycles. The frequency varies by `wander`.
            let phase: Vec<f64> = time.iter().map(|t| {
                let cycles = t * frequency;
                cycles + wander * (cycles / 2.0).sin() * 2.0
            }).collect();
            let x: Vec<f64> = phase.iter().map(|p| (TAU * p).sin() + drift * p + noise * random.normal()).collect();
            let cycles = find(&time, &x);
            prop_assert!(cycles.len() >= 10, "{} cycles", cycles.len());
            for pair in cycles.windows(2) {
                prop_assert_eq!(pair[0].end, pair[1].start);
            }
            for cycle in &cycles {
                let p = phase[cycle.start];
                prop_assert!((p - p.round()).abs() < 0.02, "starts at phase {p}");
            }
        }

        #[test]
        fn a_road_is_not_periodic(seed in 0..1000_u64, samples in 1600..8000_u32) {
            let mut random = Random::new(seed);
            let time: Vec<f64> = (0..samples).map(|i| f64::from(i) * 2.5e-3).collect();
            let waves: Vec<(f64, f64, f64)> = (0..30)
                .map(|k| (0.5 * 1.15_f64.powi(k), TAU * random.uniform(), 0.5 + random.uniform()))
                .collect();
            let x: Vec<f64> = time.iter()
                .map(|t| waves.iter().map(|(f, phase, a)| a / f * (TAU * f * t + phase).sin()).sum())
                .collect();
            let cycles = find(&time, &x);
            prop_assert!(cycles.is_empty(), "{} cycles of {:.2} s, strokes {:.3?} of {:.3}", cycles.len(), cycles[0].period(), cycles.iter().map(Cycle::stroke).collect::<Vec<_>>(), range(&x));
        }
    }

    #[test]
    fn a_small_sine_after_a_long_way_to_its_start_is_found() {
        let time: Vec<f64> = (0..3000).map(|i| f64::from(i) / 200.0).collect();
        let x: Vec<f64> =
            time.iter().map(|t| if *t < 5.0 { -0.1 + 0.03 * t } else { 0.05 + 0.004 * libm::sin(TAU * t) }).collect();
        let cycles = find(&time, &x);
        assert!((9..=10).contains(&cycles.len()), "{}", cycles.len());
        assert!(cycles.iter().all(|c| (c.stroke() - 0.008).abs() < 1e-4));
    }

    #[test]
    fn turning_points_alternate_and_ignore_small_motion() {
        let x = [0.0, 1.0, 0.9, 2.0, 0.0, 0.1, -1.0, 3.0, 2.9];
        assert_eq!(turning_points(&x, 0.5), [0, 3, 6, 7]);
        assert!(turning_points(&[1.0; 5], 0.5).is_empty());
    }

    #[test]
    fn the_peak_is_not_set_by_one_sample() {
        let mut x: Vec<f64> = (0..1000).map(|i| libm::sin(TAU * f64::from(i) / 1000.0)).collect();
        x[500] = 40.0;
        assert!((robust_peak(&x, &[]) - 1.0).abs() < 1e-3);
    }

    #[test]
    fn a_lone_cycle_has_no_reversal_within_a_stroke() {
        // One cycle of a sine whose first stroke goes back by `depth`, relative to the stroke, for eight samples.
        let stands = |depth: f64| {
            let reversal = (0..8).map(|k| -2.0 * depth * if k < 4 { f64::from(k + 1) } else { f64::from(7 - k) } / 4.0);
            let sine = |i: i32| libm::sin(TAU * (f64::from(i) + 0.5) / 800.0);
            let middle = sine(50);
            let x: Vec<f64> =
                (0..=50).map(sine).chain(reversal.map(|back| middle + back)).chain((51..800).map(sine)).collect();
            let n = x.len();
            let time: Vec<f64> = (0..n).map(|i| i as f64 / n as f64).collect();
            let cycle = Cycle { start: 0, end: n, start_time: 0.0, end_time: 1.0, low: -1.0, high: 1.0 };
            stand_alone(&time, &x, &[cycle], 0.0)
        };
        assert!(stands(0.0) && stands(0.007) && !stands(0.015));
    }
}
