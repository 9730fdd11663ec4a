//! The samples that a diagnosis looks at: the mean cycle of every test, and how far noise lets it be trusted.
//!
//! Averaging over cycles at equal phase takes most of the noise out and leaves the damper in. A long test is cut into a
//! few stretches first, so that what changes while it runs (heating, drift) stays visible from stretch to stretch.

use crate::identification::segment::Segment;
use crate::motion::{Motion, smooth};
use crate::records::Record;
use dashpot_core::Input;
use rayon::prelude::*;

/// Most samples of a mean cycle.
const PER_CYCLE: usize = 120;
/// Most samples of a test without cycles.
const PER_ROAD: usize = 1000;
/// Share of a cycle over which the force is averaged at most: a wider window would blur the knee.
const WINDOW: f64 = 1.0 / 400.0;
/// Time that the motion runs ahead of the scored samples, s, so that what the damper remembers is its own.
const LEAD_IN: f64 = 0.15;
/// The same as shares of a cycle, at least and at most.
const LEAD_IN_CYCLES: (f64, f64) = (0.12, 1.5);
/// Duration from which a test is cut into stretches, s, the fewest cycles of one, and the most of them.
const LONG: f64 = 20.0;
const STRETCH_CYCLES: usize = 3;
const MOST_STRETCHES: usize = 4;
/// Error that is allowed whatever the noise: no curve through a dozen points is better than this share of the largest
/// force.
const FORM: f64 = 0.002;
/// Share of the change from sample to sample that a small error of time or velocity makes.
const TIMING: f64 = 0.05;
/// Share of the cases in which such an error puts a sample on the other side of a jump between its neighbours: friction that
/// turns over within a sample.
const ACROSS: f64 = 0.02;

/// One test, or one stretch of a long one.
#[derive(Debug, Clone)]
pub struct Test {
    /// Place of its record in the list given.
    pub record: usize,
    /// Motion and mean measured force; `scale` is the typical allowed error.
    pub segment: Segment,
    /// Allowed error of every scored sample, N: noise of the mean, form, timing.
    pub allowed: Vec<f64>,
    /// Noise of one sample of the mean, N.
    pub mean_noise: f64,
    /// Independent samples that one scored sample stands for: 1 for white noise.
    pub independence: f64,
    /// Growth of the force from cycle to cycle, as a share of it, in standard deviations.
    pub growth: f64,
    /// Independent deviations from which the noise was estimated.
    pub noise_freedom: f64,
    /// Frequency, Hz; 0 without cycles.
    pub frequency: f64,
    /// Middle of the stretch on the campaign's clock, s.
    pub clock: f64,
}

impl Test {
    /// Number of scored samples.
    pub fn count(&self) -> usize {
        self.segment.force.len() - self.segment.from
    }

    /// Number of independent ones among them.
    pub fn independent_count(&self) -> f64 {
        self.count() as f64 * self.independence
    }

    /// The scored inputs.
    pub fn inputs(&self) -> &[Input] {
        &self.segment.input[self.segment.from..]
    }

    /// The scored forces.
    pub fn forces(&self) -> &[f64] {
        &self.segment.force[self.segment.from..]
    }
}

/// Makes the tests of all records, in their order.
pub fn tests(records: &[&Record]) -> Vec<Test> {
    let of_each: Vec<Vec<Test>> = records.par_iter().enumerate().map(|(place, r)| of_record(place, r)).collect();
    of_each.into_iter().flatten().collect()
}

fn of_record(place: usize, record: &Record) -> Vec<Test> {
    let motion = smooth(record);
    let cycles = record.cycles.len();
    if cycles == 0 {
        return vec![road(place, record, &motion)];
    }
    let end = |k: usize| record.cycles[k].end.min(record.time.len() - 1);
    let duration = record.time[end(cycles - 1)] - record.time[record.cycles[0].start];
    let stretches = if duration >= LONG { (cycles / STRETCH_CYCLES).clamp(1, MOST_STRETCHES) } else { 1 };
    (0..stretches)
        .map(|k| {
            let range = k * cycles / stretches..(k + 1) * cycles / stretches;
            mean_cycle(place, record, &motion, &record.cycles[range])
        })
        .collect()
}

/// When the displacement rises through its mean near a sample: cycles are cut at samples, and a mean cycle needs better.
fn crossing(time: &[f64], motion: &Motion, mean: f64, index: usize) -> f64 {
    let step = if index > 0 { time[index] - time[index - 1] } else { time[1] - time[0] };
    let ahead = (mean - motion.displacement[index]) / motion.velocity[index];
    // Beside the crossing the displacement is as good as straight; anything far off is no crossing.
    if ahead.abs() <= 2.0 * step { time[index] + ahead } else { time[index] }
}

/// A channel at a time: on a cubic through the four samples around it, so that a coarsely sampled flank keeps its shape.
fn at(time: &[f64], values: &[f64], t: f64) -> f64 {
    let n = time.len();
    let right = time.partition_point(|x| *x <= t).clamp(1, n - 1);
    let first = right.saturating_sub(2).min(n.saturating_sub(4));
    let around = first..(first + 4).min(n);
    // Lagrange's form; beyond the ends it holds the last value.
    let t = t.clamp(time[0], time[n - 1]);
    around
        .clone()
        .map(|i| {
            let weight: f64 = around.clone().filter(|j| *j != i).map(|j| (t - time[j]) / (time[i] - time[j])).product();
            weight * values[i]
        })
        .sum()
}

/// Share of a sample within which a time counts as that of the sample.
const AT_SAMPLE: f64 = 0.02;
/// How many times steeper than beside it, and above the noise, the force must run between two samples to be a jump.
const STEEPER: f64 = 3.0;

/// Whether a time lies between two samples between which the force jumps: nothing can be interpolated there.
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

/// Fewest cycles whose differences tell the noise of their mean.
const REPEATS: usize = 3;
/// Share of the largest deviations that steep places make, not noise, and the variance that normal noise keeps when those
/// are cut.
const STEEP: f64 = 0.02;
const KEPT: f64 = 0.964;

/// What cycles tell by how they differ.
struct Repeat {
    /// Noise of their mean.
    mean_noise: f64,
    /// Share of independent samples.
    independence: f64,
    /// Growth of the force from cycle to cycle, as a share of it, in standard deviations.
    growth: f64,
}

/// From how cycles differ from their mean at equal phase: whatever the colour of the noise.
fn repeat(bounds: &[(f64, f64)], mean: &[(f64, f64)], force: impl Fn(f64) -> f64) -> Option<Repeat> {
    let count = mean.len();
    if bounds.len() < REPEATS || count < 16 {
        return None;
    }
    let deviations: Vec<Vec<f64>> =
        bounds.iter().map(|(a, b)| mean.iter().map(|(phase, m)| force(a + (b - a) * phase) - m).collect()).collect();
    let mut sizes: Vec<f64> = deviations.iter().flatten().map(|d| d.abs()).collect();
    sizes.sort_by(f64::total_cmp);
    let limit = sizes[((1.0 - STEEP) * (sizes.len() - 1) as f64) as usize];
    let near = |d: f64| d.clamp(-limit, limit);
    let product = |lag: usize| {
        let of = |d: &Vec<f64>| (lag..count).map(|k| near(d[k]) * near(d[k - lag])).sum::<f64>();
        deviations.iter().map(of).sum::<f64>() / ((count - lag) * deviations.len()) as f64
    };
    let variance = product(0);
    if variance <= 0.0 {
        return None;
    }
    // Geyer's initial positive sequence (Stat. Sci. 7, 1992), as far as a quarter of a cycle.
    let mut stands_for = 1.0;
    for lag in 1..count / 4 {
        let correlation = product(lag) / variance;
        if correlation < 0.05 {
            break;
        }
        stands_for += 2.0 * correlation;
    }
    let n = bounds.len() as f64;
    // The deviations are from the cycles' own mean, which takes its share of them.
    Some(Repeat {
        mean_noise: (variance / KEPT / (n - 1.0)).sqrt(),
        independence: 1.0 / stands_for,
        growth: growth(&deviations, mean, stands_for),
    })
}

/// Growth of the force from cycle to cycle in standard deviations, from each cycle's own gain on the mean one.
fn growth(deviations: &[Vec<f64>], mean: &[(f64, f64)], stands_for: f64) -> f64 {
    let middle = mean.iter().map(|m| m.1).sum::<f64>() / mean.len() as f64;
    let shape: Vec<f64> = mean.iter().map(|m| m.1 - middle).collect();
    let square: f64 = shape.iter().map(|f| f * f).sum::<f64>().max(1e-300);
    let gains: Vec<f64> =
        deviations.iter().map(|d| d.iter().zip(&shape).map(|(d, f)| d * f).sum::<f64>() / square).collect();
    let left: f64 = deviations
        .iter()
        .zip(&gains)
        .flat_map(|(d, g)| d.iter().zip(&shape).map(move |(d, f)| (d - g * f).powi(2)))
        .sum::<f64>();
    let n = gains.len() as f64;
    let of_gain = stands_for * left / ((n - 1.0) * mean.len() as f64 * square);
    let place = |k: usize| k as f64 - 0.5 * (n - 1.0);
    let places: f64 = (0..gains.len()).map(|k| place(k).powi(2)).sum();
    let slope = gains.iter().enumerate().map(|(k, g)| place(k) * g).sum::<f64>() / places;
    slope / (of_gain / places).sqrt().max(1e-300)
}

/// Variance of the mean of `count` neighbours in units of one sample's, for noise whose autocorrelation falls off
/// geometrically.
fn mean_variance(count: usize, lag1: f64) -> f64 {
    let n = count as f64;
    let sum: f64 = (1..count).map(|k| (n - k as f64) * lag1.powi(k as i32)).sum();
    (n + 2.0 * sum) / (n * n)
}

/// Where in a cycle its mean is taken: at the samples of the middle one, as far as `count` of them. Where others are sampled
/// alike nothing has to be interpolated, which across friction that turns over would give any force between.
fn phases(time: &[f64], cycles: &[std::ops::Range<usize>], bounds: &[(f64, f64)], count: usize) -> Vec<f64> {
    let middle = cycles.len() / 2;
    let (range, (a, b)) = (&cycles[middle], bounds[middle]);
    let phase = |k: usize| (time[(range.start + k * range.len() / count).min(time.len() - 1)] - a) / (b - a);
    // The crossings that bound a cycle are not its first and last sample: what lies beyond a whole turn was there before.
    let end = phase(0) + 1.0 - 0.5 / range.len() as f64;
    let mut last = f64::NEG_INFINITY;
    (0..count)
        .map(phase)
        .filter(|p| *p < end && *p > std::mem::replace(&mut last, *p))
        .map(|p| p.rem_euclid(1.0))
        .collect()
}

fn mean_cycle(place: usize, record: &Record, motion: &Motion, cycles: &[std::ops::Range<usize>]) -> Test {
    let time = &record.time;
    let last = time.len() - 1;
    let in_cycle = cycles[cycles.len() / 2].len().max(1);
    let count = in_cycle.min(PER_CYCLE);
    let averaged = ((in_cycle as f64 * WINDOW) as usize / 2) * 2 + 1;
    let crossing = |index: usize| crossing(time, motion, record.mean_displacement, index.min(last));
    let bounds: Vec<(f64, f64)> = cycles.iter().map(|c| (crossing(c.start), crossing(c.end))).collect();
    let period = bounds.iter().map(|(a, b)| b - a).sum::<f64>() / bounds.len() as f64;
    let mean = |values: &[f64], phase: f64| {
        // A record may be cut a part of a sample inside its first or last cycle.
        let inside = || bounds.iter().map(|(a, b)| a + phase * (b - a)).filter(|t| (time[0]..=time[last]).contains(t));
        match inside().count() {
            0 => at(time, values, bounds[0].0 + phase * (bounds[0].1 - bounds[0].0)),
            count => inside().map(|t| at(time, values, t)).sum::<f64>() / count as f64,
        }
    };
    let phases = phases(time, cycles, &bounds, count);
    let count = phases.len();
    let force_at = |phase: f64| {
        let half = (averaged / 2) as i64;
        let per = 1.0 / in_cycle as f64;
        (-half..=half).map(|k| mean(&record.force, phase + k as f64 * per)).sum::<f64>() / averaged as f64
    };
    // Where another cycle's samples lie on either side of a jump, the sample of the middle one stands alone.
    let middle = bounds[bounds.len() / 2];
    let alone: Vec<bool> =
        phases.iter().map(|phase| bounds.iter().any(|(a, b)| across_a_jump(record, a + phase * (b - a)))).collect();
    let side = |phase: f64| record.side_force.as_ref().map_or(0.0, |c| mean(c, phase));
    let temperature = |phase: f64| record.temperature.as_ref().map_or(20.0, |c| mean(c, phase));
    let cycle: Vec<(Input, f64)> = phases
        .iter()
        .zip(&alone)
        .map(|(phase, alone)| {
            let phase = *phase;
            let input = Input {
                displacement: Some(mean(&motion.displacement, phase)),
                velocity: mean(&motion.velocity, phase),
                side_force: side(phase),
                temperature: temperature(phase),
            };
            let own = middle.0 + phase * (middle.1 - middle.0);
            (input, if *alone { at(time, &record.force, own) } else { force_at(phase) })
        })
        .collect();
    let (least, most) = LEAD_IN_CYCLES;
    let lead = (((LEAD_IN / period).clamp(least, most) * count as f64) as usize).max(2);
    let turned = |k: usize| (k + 2 * count - lead % count) % count;
    let (input, force) = (0..lead + count).map(|k| cycle[turned(k)]).unzip();
    let dt = (0..lead + count)
        .map(|k| {
            let (here, before) = (phases[turned(k)], phases[(turned(k) + count - 1) % count]);
            period * (here - before).rem_euclid(1.0)
        })
        .collect();
    let mean_of: Vec<(f64, f64)> = phases.iter().zip(&cycle).map(|(phase, c)| (*phase, c.1)).collect();
    let Repeat { mean_noise, independence, growth } = repeat(&bounds, &mean_of, |t| {
        let half = (averaged / 2) as i64;
        let per = period / in_cycle as f64;
        (-half..=half).map(|k| at(time, &record.force, t + k as f64 * per)).sum::<f64>() / averaged as f64
    })
    .unwrap_or_else(|| {
        let lag1 = record.noise.lag1.clamp(0.0, 0.99);
        let apart = (in_cycle as f64 / count as f64).max(1.0);
        let mean_noise = record.noise.force_rms * (mean_variance(averaged, lag1) / bounds.len() as f64).sqrt();
        Repeat { mean_noise, independence: independence(lag1.powf(apart)), growth: 0.0 }
    });
    let (begin, end) = (bounds[0].0, bounds[bounds.len() - 1].1);
    let cycles = bounds.len() as f64;
    let of_mean: Vec<f64> = alone.iter().map(|alone| if *alone { cycles } else { 1.0 }).collect();
    let of_scored = (lead..lead + count).map(|k| of_mean[turned(k)]).collect::<Vec<f64>>();
    finish(
        Test {
            record: place,
            segment: segment(record, dt, input, force, lead),
            allowed: Vec::new(),
            mean_noise,
            independence,
            growth,
            noise_freedom: (bounds.len() as f64 - 1.0).max(1.0) * count as f64 * independence,
            frequency: 1.0 / period,
            clock: 0.5 * (begin + end),
        },
        &of_scored,
        true,
    )
}

fn road(place: usize, record: &Record, motion: &Motion) -> Test {
    let n = record.time.len();
    let stride = n.div_ceil(PER_ROAD).max(1);
    let picks: Vec<usize> = (0..n).step_by(stride).collect();
    let lead = (picks.len() / 20).max(1);
    let dt = std::iter::once(0.0).chain(picks.windows(2).map(|w| record.time[w[1]] - record.time[w[0]])).collect();
    let (input, force) = picks
        .iter()
        .map(|i| {
            let input = Input {
                displacement: Some(motion.displacement[*i]),
                velocity: motion.velocity[*i],
                side_force: record.side_force.as_ref().map_or(0.0, |c| c[*i]),
                temperature: record.temperature.as_ref().map_or(20.0, |c| c[*i]),
            };
            (input, record.force[*i])
        })
        .unzip();
    let lag1 = record.noise.lag1.clamp(0.0, 0.99);
    finish(
        Test {
            record: place,
            segment: segment(record, dt, input, force, lead),
            allowed: Vec::new(),
            mean_noise: record.noise.force_rms,
            independence: independence(lag1.powi(stride as i32)),
            growth: 0.0,
            noise_freedom: n as f64 * independence(lag1),
            frequency: 0.0,
            clock: 0.5 * (record.time[0] + record.time[n - 1]),
        },
        &[],
        false,
    )
}

/// Share of independent samples among samples whose neighbours correlate so.
fn independence(lag: f64) -> f64 {
    (1.0 - lag) / (1.0 + lag)
}

fn segment(record: &Record, dt: Vec<f64>, input: Vec<Input>, force: Vec<f64>, from: usize) -> Segment {
    let top = force.iter().fold(0.0f64, |m, f| m.max(f.abs()));
    Segment {
        name: record.name.clone(),
        dt,
        input,
        force,
        from,
        scale: 1.0,
        top,
        peak_velocity: record.peak_velocity,
        amplitude: record.amplitude,
    }
}

/// Sets the allowed errors; `variance` is that of each sample's noise in units of the mean's, 1 where there is none.
fn finish(mut test: Test, variance: &[f64], periodic: bool) -> Test {
    let noise = test.mean_noise.powi(2) / test.independence;
    let form = (FORM * test.segment.top).powi(2);
    let base = noise + form;
    let scored = test.forces();
    let n = scored.len();
    let allowed: Vec<f64> = (0..n)
        .map(|i| {
            let at = |k: usize| {
                // Two before to two after.
                let place = i + k;
                if periodic { scored[(place + n - 2) % n] } else { scored[place.saturating_sub(2).min(n - 1)] }
            };
            let half = 0.5 * (at(3) - at(1));
            let beside = (at(1) - at(0)).abs() + (at(4) - at(3)).abs();
            let jump = (half.abs() - 0.5 * beside - test.mean_noise).max(0.0);
            let own = noise * variance.get(i).unwrap_or(&1.0) + form;
            (own + (TIMING * half).powi(2) + ACROSS * jump * jump).sqrt().max(1e-6)
        })
        .collect();
    test.segment.scale = base.sqrt().max(1e-6);
    test.allowed = allowed;
    test
}

#[cfg(test)]
mod unit {
    use super::*;

    #[test]
    fn a_mean_cycle_is_taken_once_round_at_measured_samples() {
        let time: Vec<f64> = (0..400).map(|k| 1e-3 * f64::from(k)).collect();
        let cycles = [0..100, 100..200, 200..300];
        // Crossings a little off the samples, and a cycle that is shorter than its samples.
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
