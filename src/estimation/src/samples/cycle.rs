//! The mean of a test's cycles.

use super::noise::{Repeat, independence, mean_variance, repeat};
use super::{Test, allowed, lead_in, segment};
use dashpot_core::Input;
use dashpot_records::Record;
use dashpot_records::restrict;
use dashpot_records::smoothing::Motion;
use std::ops::Range;

/// Largest number of samples of a mean cycle.
const PER_CYCLE: usize = 120;
/// Largest fraction of a cycle over which the force is averaged. A wider window would smooth the knee of the FV curve.
const WINDOW: f64 = 1.0 / 400.0;

/// Returns the time, s, at which the displacement rises through its `mean` near a sample. Cycles are cut at samples,
/// but a mean cycle requires a more accurate time.
fn crossing(time: &[f64], motion: &Motion, mean: f64, index: usize) -> f64 {
    let step = if index > 0 { time[index] - time[index - 1] } else { time[1] - time[0] };
    let ahead = (mean - motion.displacement[index]) / motion.velocity[index];
    // Near the crossing, the displacement is almost linear. A computed time that is more than two samples away is not a
    // crossing.
    if ahead.abs() <= 2.0 * step { time[index] + ahead } else { time[index] }
}

/// Interpolates a channel at a time by a cubic through the four nearest samples, so that a coarsely sampled steep part
/// retains its shape.
fn at(time: &[f64], values: &[f64], t: f64) -> f64 {
    let n = time.len();
    let right = restrict(time.partition_point(|x| *x <= t), 1, n - 1);
    let first = right.saturating_sub(2).min(n.saturating_sub(4));
    let around = first..(first + 4).min(n);
    // The cubic has Lagrange's form. Beyond the ends of the record, the value at the nearest end applies.
    let t = restrict(t, time[0], time[n - 1]);
    around
        .clone()
        .map(|i| {
            let weight: f64 = around.clone().filter(|j| *j != i).map(|j| (t - time[j]) / (time[i] - time[j])).product();
            weight * values[i]
        })
        .sum()
}

/// Largest distance, as a fraction of a sample interval, at which a time counts as the time of a sample.
const AT_SAMPLE: f64 = 0.02;
/// Ratio of a force change to the changes in the neighboring intervals plus the noise, above which the change is a
/// jump.
const STEEPER: f64 = 3.0;

/// Returns whether the force jumps between the two samples around a time. Interpolation is invalid there.
fn across_a_jump(record: &Record, t: f64) -> bool {
    let (time, force) = (&record.time, &record.force);
    let right = time.partition_point(|x| *x <= t);
    if right < 2 || right + 1 >= time.len() {
        return false;
    }
    let left = right - 1;
    let share = (t - time[left]) / (time[right] - time[left]);
    if !(AT_SAMPLE..=1.0 - AT_SAMPLE).contains(&share) {
        return false;
    }
    let rise = |k: usize| (force[k + 1] - force[k]).abs();
    rise(left) > STEEPER * (0.5 * (rise(left - 1) + rise(right)) + record.noise.force_rms)
}

/// Returns the phases, 0 to 1, at which the mean of a cycle is computed: those of at most `count` samples of the middle
/// cycle.
///
/// If the other cycles have samples at equal phases, their forces need no interpolation. Interpolation across a
/// friction reversal would give an arbitrary force between the forces before and after the reversal.
fn phases(time: &[f64], cycles: &[Range<usize>], bounds: &[(f64, f64)], count: usize) -> Vec<f64> {
    let middle = cycles.len() / 2;
    let (range, (a, b)) = (&cycles[middle], bounds[middle]);
    let phase = |k: usize| (time[(range.start + k * range.len() / count).min(time.len() - 1)] - a) / (b - a);
    // The crossings that bound a cycle are not exactly at samples. Samples beyond a full cycle would repeat the first
    // samples.
    let end = phase(0) + 1.0 - 0.5 / range.len() as f64;
    let mut last = f64::NEG_INFINITY;
    (0..count)
        .map(phase)
        .filter(|p| *p < end && *p > std::mem::replace(&mut last, *p))
        .map(|p| p.rem_euclid(1.0))
        .collect()
}

/// Computes the mean of `value` at an odd number `averaged` of points around its argument 0. The distance between
/// points is `apart`.
fn window(averaged: usize, apart: f64, value: impl Fn(f64) -> f64) -> f64 {
    let half = (averaged / 2) as i64;
    (-half..=half).map(|k| value(k as f64 * apart)).sum::<f64>() / averaged as f64
}

pub fn mean_cycle(place: usize, record: &Record, motion: &Motion, cycles: &[Range<usize>]) -> Test {
    let time = &record.time;
    let last = time.len() - 1;
    let in_cycle = cycles[cycles.len() / 2].len().max(1);
    let averaged = ((in_cycle as f64 * WINDOW) as usize / 2) * 2 + 1;
    let crossing = |index: usize| crossing(time, motion, record.mean_displacement, index.min(last));
    let bounds: Vec<(f64, f64)> = cycles.iter().map(|c| (crossing(c.start), crossing(c.end))).collect();
    let period = bounds.iter().map(|(a, b)| b - a).sum::<f64>() / bounds.len() as f64;
    let mean = |values: &[f64], phase: f64| {
        // A record may begin a fraction of a sample after the start of its first cycle, or end before the end of its
        // last cycle.
        let inside = || bounds.iter().map(|(a, b)| a + phase * (b - a)).filter(|t| (time[0]..=time[last]).contains(t));
        match inside().count() {
            0 => at(time, values, bounds[0].0 + phase * (bounds[0].1 - bounds[0].0)),
            count => inside().map(|t| at(time, values, t)).sum::<f64>() / count as f64,
        }
    };
    let phases = phases(time, cycles, &bounds, in_cycle.min(PER_CYCLE));
    let count = phases.len();
    // If the force of any cycle jumps at a phase, use only the sample of the middle cycle.
    let (from, to) = bounds[bounds.len() / 2];
    let alone: Vec<bool> =
        phases.iter().map(|phase| bounds.iter().any(|(a, b)| across_a_jump(record, a + phase * (b - a)))).collect();
    let optional =
        |channel: &Option<Vec<f64>>, phase: f64, none: f64| channel.as_ref().map_or(none, |c| mean(c, phase));
    let cycle: Vec<(Input, f64)> = phases
        .iter()
        .zip(&alone)
        .map(|(&phase, alone)| {
            let input = Input {
                displacement: Some(mean(&motion.displacement, phase)),
                velocity: mean(&motion.velocity, phase),
                side_force: optional(&record.side_force, phase, 0.0),
                temperature: optional(&record.temperature, phase, 20.0),
            };
            let force = if *alone {
                at(time, &record.force, from + phase * (to - from))
            } else {
                window(averaged, 1.0 / in_cycle as f64, |beside| mean(&record.force, phase + beside))
            };
            (input, force)
        })
        .collect();
    let lead = lead_in::initial_length(period, count);
    // The scored samples are one cycle, beginning at the first phase. The motion before them is the end of the same
    // cycle.
    let turned = |k: usize| (k + 2 * count - lead % count) % count;
    let places = lead_in::places(lead, count);
    let (input, force) = places.iter().map(|k| cycle[turned(*k)]).unzip();
    let apart = |before: usize, here: usize| period * (phases[turned(here)] - phases[turned(before)]).rem_euclid(1.0);
    let dt = std::iter::once(0.0).chain(places.windows(2).map(|pair| apart(pair[0], pair[1]))).collect();
    let lead = places.len() - count;
    let mean_of: Vec<(f64, f64)> = phases.iter().zip(&cycle).map(|(phase, c)| (*phase, c.1)).collect();
    let Repeat { mean_noise, independence, growth } = repeat(&bounds, &mean_of, |t| {
        window(averaged, period / in_cycle as f64, |beside| at(time, &record.force, t + beside))
    })
    .unwrap_or_else(|| {
        let lag1 = record.noise.lag1.clamp(0.0, 0.99);
        let apart = (in_cycle as f64 / count as f64).max(1.0);
        let mean_noise = record.noise.force_rms * (mean_variance(averaged, lag1) / bounds.len() as f64).sqrt();
        Repeat { mean_noise, independence: independence(libm::pow(lag1, apart)), growth: 0.0 }
    });
    let cycles = bounds.len() as f64;
    let noise = mean_noise.powi(2) / independence;
    let clock = record.clock_s + 0.5 * (bounds[0].0 + bounds[bounds.len() - 1].1);
    let segment = segment(record, clock, dt, input, force, lead, noise);
    let times: Vec<f64> = alone.iter().map(|alone| if *alone { cycles } else { 1.0 }).collect();
    Test {
        record: place,
        allowed: allowed::in_cycle(&segment, noise, &times, mean_noise),
        segment,
        mean_noise,
        independence,
        growth,
        noise_freedom: (cycles - 1.0).max(1.0) * count as f64 * independence,
        frequency: 1.0 / period,
        weight: 1.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_mean_cycle_is_taken_once_round_at_measured_samples() {
        let time: Vec<f64> = (0..400).map(|k| 1e-3 * f64::from(k)).collect();
        let cycles = [0..100, 100..200, 200..300];
        // The crossings are slightly before or after samples. One cycle is shorter than its samples.
        for (from, to) in [(0.1, 0.2), (0.1004, 0.1991), (0.0996, 0.2003), (0.1, 0.1975)] {
            let bounds = [(from - 0.1, to - 0.1), (from, to), (from + 0.1, to + 0.1)];
            for count in [100, 40] {
                let phases = phases(&time, &cycles, &bounds, count);
                assert!(phases.len() > 9 * count / 10);
                let n = phases.len();
                let steps: Vec<f64> = (0..n).map(|k| (phases[(k + 1) % n] - phases[k]).rem_euclid(1.0)).collect();
                assert!((steps.iter().sum::<f64>() - 1.0).abs() < 1e-9, "{from} {to}: more than once round");
                for phase in &phases {
                    let sample = 1e3 * (from + phase * (to - from));
                    let turn = 1e3 * (to - from);
                    let off = [sample, sample - turn].map(|s| (s - s.round()).abs()).into_iter().fold(1.0, f64::min);
                    assert!(off < 1e-6, "{phase} is no sample");
                }
            }
        }
    }
}
