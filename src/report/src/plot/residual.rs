//! Residuals of the force, averaged over all tests, over velocity and over the time since the last reversal of motion.

use super::axes::{Axis, Marks, Plane, Scale, Series};
use super::palette::Role;
use crate::words::Words;
use dashpot_diagnosis::TestOutcome;

/// Number of velocity bins of a mean residual, for compression and rebound together.
const VELOCITY_BINS: usize = 30;
/// Number of bins per decade of the time since the last reversal of motion.
const PER_DECADE: f64 = 5.0;
/// Smallest number of samples in a bin whose mean residual is shown.
const FEWEST: usize = 8;

/// One sample of a test, with its residuals.
#[derive(Debug, Clone, Copy)]
pub struct Sample {
    /// Displacement, m.
    pub displacement: f64,
    /// Velocity, m/s.
    pub velocity: f64,
    /// Residual before the improvement: measured minus computed force, N.
    pub before: f64,
    /// Residual after the improvement: measured minus computed force, N.
    pub after: f64,
    /// Noise of the force in the test of this sample, N.
    pub noise: f64,
    /// Whether the speed, the magnitude of the velocity, rises.
    pub speeding_up: bool,
    /// Time since the last change of the velocity's sign, s; `None` for a test without cycles.
    pub since_reversal: Option<f64>,
}

/// Returns all samples at which the model has a finite force, both before and after the improvement.
pub fn samples(tests: &[TestOutcome]) -> Vec<Sample> {
    tests.iter().flat_map(of_test).filter(|s| s.before.is_finite() && s.after.is_finite()).collect()
}

fn of_test(test: &TestOutcome) -> Vec<Sample> {
    let curves = &test.curves;
    let (n, velocity) = (curves.measured.len(), &curves.velocity);
    let periodic = curves.frequency > 0.0;
    let before = |i: usize| {
        if i > 0 {
            i - 1
        } else if periodic {
            n - 1
        } else {
            0
        }
    };
    let after = |i: usize| {
        if i + 1 < n {
            i + 1
        } else if periodic {
            0
        } else {
            i
        }
    };
    let step = if periodic { 1.0 / (curves.frequency * n as f64) } else { 0.0 };
    let since = |i: usize| {
        let same = |k: usize| velocity[(i + n - k) % n] * velocity[i] > 0.0;
        let steps = (1..n).find(|k| !same(*k)).filter(|_| periodic)?;
        // The sign of the velocity changed between the samples `steps` and `steps − 1` before sample `i`. Interpolate the time of the zero
        // linearly.
        let (old, new) = (velocity[(i + n - steps) % n].abs(), velocity[(i + n - steps + 1) % n].abs());
        Some(step * (steps as f64 - 1.0 + new / (old + new).max(f64::MIN_POSITIVE)))
    };
    (0..n)
        .map(|i| Sample {
            displacement: curves.displacement[i],
            velocity: velocity[i],
            before: curves.measured[i] - curves.before[i],
            after: curves.measured[i] - curves.after[i],
            noise: test.noise_n,
            speeding_up: velocity[after(i)].abs() >= velocity[before(i)].abs(),
            since_reversal: since(i),
        })
        .collect()
}

/// Number of samples in a bin, and sums over these samples.
#[derive(Debug, Clone, Copy, Default)]
struct Bin {
    count: usize,
    before: f64,
    after: f64,
    noise: f64,
}

/// Averages the three quantities `of` a sample over bins of the quantity `over`. The bins have equal widths on the scale of the axis.
/// Returns center and means of each bin, without bins of fewer than [`FEWEST`] samples.
fn binned(
    samples: &[Sample],
    bins: usize,
    axis: &Axis,
    over: impl Fn(&Sample) -> Option<f64>,
    of: impl Fn(&Sample) -> [f64; 3],
) -> Vec<(f64, [f64; 3])> {
    let mut sums = vec![Bin::default(); bins];
    for sample in samples {
        let Some(place) = over(sample).map(|value| axis.place(value)) else { continue };
        if !(0.0..=1.0).contains(&place) {
            continue;
        }
        let bin = &mut sums[((place * bins as f64) as usize).min(bins - 1)];
        let [before, after, noise] = of(sample);
        bin.count += 1;
        bin.before += before;
        bin.after += after;
        bin.noise += noise;
    }
    let (low, high) = (axis.scale.position(axis.low), axis.scale.position(axis.high));
    let middle = |k: usize| axis.scale.back(low + (k as f64 + 0.5) / bins as f64 * (high - low));
    sums.iter()
        .enumerate()
        .filter(|(_, bin)| bin.count >= FEWEST)
        .map(|(k, bin)| (middle(k), [bin.before, bin.after, bin.noise].map(|sum| sum / bin.count as f64)))
        .collect()
}

/// Makes an axis of velocity in mm/s that covers all samples and magnifies low velocities.
pub fn velocity_axis(samples: &[Sample], words: &Words) -> Axis {
    let top = samples.iter().map(|s| 1e3 * s.velocity.abs()).fold(1e-3, f64::max);
    Axis { scale: Scale::Root, ..Axis::exactly(words.axis_velocity, -top, top) }
}

fn draw([title, y]: [&str; 2], x: Axis, means: &[(f64, [f64; 3])], noise: bool, words: &Words) -> String {
    let line = |role, label, k: usize| Series {
        role,
        label,
        lines: vec![means.iter().map(|(place, of)| [*place, of[k]]).collect()],
        marks: Marks::Both,
    };
    let mut series = vec![line(Role::Before, words.before, 0), line(Role::Model, words.after, 1)];
    if noise {
        series.insert(0, line(Role::Shadow, words.noise_alone, 2));
    }
    let shown = if noise { 0..3 } else { 0..2 };
    let values = means.iter().flat_map(|(_, of)| of[shown.clone()].iter().copied()).chain([0.0]);
    Plane { title: title.into(), x, y: Axis::around(y, values), series }.draw(words)
}

/// Draws the root mean square residual over velocity, before and after the improvement, with the noise.
pub fn size_over_velocity(samples: &[Sample], words: &Words) -> String {
    let axis = velocity_axis(samples, words);
    let squares = |s: &Sample| [s.before, s.after, s.noise].map(|v| v * v);
    let mut means = binned(samples, VELOCITY_BINS, &axis, |s| Some(1e3 * s.velocity), squares);
    means.iter_mut().for_each(|(_, of)| *of = of.map(f64::sqrt));
    draw([words.plot_left_size, words.axis_residual_rms], axis, &means, true, words)
}

/// Draws the mean residual over velocity, for rising or for falling speed.
pub fn mean_over_velocity(samples: &[Sample], speeding_up: bool, words: &Words) -> String {
    let axis = velocity_axis(samples, words);
    let some: Vec<Sample> = samples.iter().filter(|s| s.speeding_up == speeding_up).copied().collect();
    let means = binned(&some, VELOCITY_BINS, &axis, |s| Some(1e3 * s.velocity), |s| [s.before, s.after, s.noise]);
    let title = if speeding_up { words.plot_left_up } else { words.plot_left_down };
    draw([title, words.axis_residual], axis, &means, false, words)
}

/// Draws the mean residual over the time since the last change of the velocity's sign. Returns `None` if no test has cycles.
///
/// The drawn residual is positive if the damper resists more than the model, in both directions.
pub fn mean_since_reversal(samples: &[Sample], words: &Words) -> Option<String> {
    let times = || samples.iter().filter_map(|s| s.since_reversal).filter(|t| *t > 0.0).map(|t| 1e3 * t);
    let (low, high) = times().fold((f64::MAX, f64::MIN), |(l, h), t| (l.min(t), h.max(t)));
    // The time axis begins at 0.1 ms or later, because even the fastest tests have no samples closer to the reversal.
    let low = low.max(0.1);
    if low * 1.001 >= high {
        return None;
    }
    let axis = Axis { scale: Scale::Logarithmic, ..Axis::exactly(words.axis_since_reversal, low, high) };
    let bins = ((libm::log10(high / low) * PER_DECADE).ceil() as usize).max(2);
    let sense = |s: &Sample| [s.before, s.after, s.noise].map(|v| v * s.velocity.signum());
    let means = binned(samples, bins, &axis, |s| s.since_reversal.map(|t| 1e3 * t), sense);
    Some(draw([words.plot_left_reversal, words.axis_resistance], axis, &means, false, words))
}

#[cfg(test)]
mod tests {
    use super::super::before_after::tests::outcome;
    use super::*;
    use crate::words::EN;

    #[test]
    fn samples_know_when_the_motion_turned() {
        let all = samples(&[outcome("a", false)]);
        assert_eq!(all.len(), 100);
        // One cycle takes 1 s; the velocity changes sign at 0.25 s and 0.75 s.
        for (i, sample) in all.iter().enumerate() {
            let time = (i as f64 + 0.5) / 100.0;
            let since = (time + 0.25).rem_euclid(0.5);
            assert!(
                (sample.since_reversal.unwrap() - since).abs() < 1e-3,
                "{time}: {:?} {since}",
                sample.since_reversal
            );
            assert_eq!(sample.speeding_up, since < 0.25, "{time}");
            assert!((sample.before.abs() - 20.0).abs() < 1e-9 && (sample.after.abs() - 1.0).abs() < 1e-9);
        }
    }

    #[test]
    fn means_keep_the_sense_of_resistance() {
        let all = samples(&[outcome("a", false)]);
        let axis = Axis { scale: Scale::Logarithmic, ..Axis::exactly("ms", 1.0, 1000.0) };
        let sense = |s: &Sample| [s.before, s.after, s.noise].map(|v| v * s.velocity.signum());
        let means = binned(&all, 6, &axis, |s| s.since_reversal.map(|t| 1e3 * t), sense);
        assert!(means.len() >= 2);
        assert!(means.iter().all(|(_, of)| (of[0] - 20.0).abs() < 1e-9 && (of[1] - 1.0).abs() < 1e-9), "{means:?}");
    }

    #[test]
    fn without_cycles_there_is_no_reversal_to_count_from() {
        let mut road = outcome("road", false);
        road.curves.frequency = 0.0;
        let all = samples(&[road]);
        assert!(mean_since_reversal(&all, &EN).is_none());
        for text in [size_over_velocity(&all, &EN), mean_over_velocity(&all, true, &EN), size_over_velocity(&[], &EN)] {
            assert!(!text.contains("NaN") && !text.contains("inf"));
        }
    }

    #[test]
    fn what_a_model_could_not_answer_is_left_out() {
        let mut lost = outcome("lost", true);
        lost.curves.after.fill(f64::NAN);
        assert!(samples(&[lost]).is_empty());
    }
}
