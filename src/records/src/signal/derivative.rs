//! Derives a missing motion channel: velocity from displacement, or displacement from velocity.

use nalgebra::{Matrix4, Vector4};

use super::smoothing::channel_noise;
use crate::numbers::{quantum, restrict, sample_time};
use crate::tuning::derivative::{LONGER, REACH, SAME};

/// Number of samples on each side of the center of the shortest window: the smallest with a degree of freedom for a
/// cubic.
const SHORTEST: usize = 2;

/// Properties of the filter with which a derivative was computed.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Filter {
    /// Number of samples in the largest window.
    pub points: usize,
    /// Length of the largest window, s.
    pub window: f64,
    /// Frequency at which the derivative with the largest window is attenuated by 3 dB, Hz. Half the sampling rate if
    /// the attenuation stays smaller.
    pub bandwidth: f64,
    /// Fraction of the samples with a shorter window, because the motion turns within the longest one.
    pub shorter: f64,
}

/// Computes the velocity with local cubics (Savitzky and Golay 1964).
///
/// At every sample, a cubic is fitted by least squares to the window centered on the sample, and its slope is the
/// velocity. A symmetric window causes no phase shift. The fit uses the true times, so uneven sampling causes no error.
///
/// `window` is the longest window, s. It has at least five samples unless the record is shorter. At the ends of the
/// record, the window is one-sided. If the motion turns within the window, as at the corners of a triangular motion, a
/// cubic would round the corner and overshoot. The sample then has the longest window whose slope agrees with the
/// slopes of all shorter windows within their noise. This is the intersection of confidence intervals of Goldenshluger
/// and Nemirovski (Math. Methods Stat. 6, 1997). Even the shortest window may contain the corner; [`limited`] removes
/// the overshoot of its cubic.
pub(crate) fn differentiate(time: &[f64], displacement: &[f64], window: f64) -> (Vec<f64>, Filter) {
    let n = time.len();
    let step = sample_time(time);
    let longest = ((0.5 * window / step).round() as usize).clamp(2, REACH).min(n.saturating_sub(1) / 2).max(1);
    let noise = displacement_noise(displacement);
    let (mut low, mut high) = (vec![f64::NEG_INFINITY; n], vec![f64::INFINITY; n]);
    let mut velocity = vec![0.0; n];
    // Number of samples on each side of the center of the window that gives the velocity, for each sample.
    let mut chosen = vec![0; n];
    // Whether the slopes of all windows so far agree, for each sample.
    let mut agree = vec![true; n];
    // Weights of the longest window.
    let mut last = Vec::new();
    for reach in reaches(longest) {
        let Slopes { slopes, gains, weights } = slopes(time, displacement, reach);
        for i in 0..n {
            if !agree[i] {
                continue;
            }
            let spread = SAME * noise * gains[i];
            (low[i], high[i]) = (low[i].max(slopes[i] - spread), high[i].min(slopes[i] + spread));
            agree[i] = low[i] <= high[i];
            if agree[i] {
                (velocity[i], chosen[i]) = (slopes[i], reach);
            }
        }
        last = weights;
    }
    // A single window has no other to disagree with. A corner in it shows by its residuals alone.
    let unseen = if longest <= SHORTEST { (SAME * noise).powi(2) } else { f64::INFINITY };
    for i in 0..n {
        let least = if agree[i] { unseen } else { 0.0 };
        if least.is_finite() {
            velocity[i] = limited((time, displacement), i, chosen[i], velocity[i], least);
        }
    }
    let shorter = agree.iter().filter(|same| !**same).count() as f64 / n.max(1) as f64;
    let window = 2.0 * longest as f64 * step;
    (velocity, Filter { points: 2 * longest + 1, window, bandwidth: bandwidth(&last, step), shorter })
}

/// Limits the slope `cubic`, m/s, of a cubic if its window contains a corner of the motion. The window has `reach`
/// samples on each side of the sample `at`.
///
/// A cubic across a corner overshoots by up to a sixth of the velocity step. The half of the window without the corner
/// is then a straight line, and its residual variance is smaller than that of the cubic. In this case, the slope is
/// limited to the range of the slopes of both halves. A window without a corner keeps the slope of its cubic, and so
/// does one whose cubic has a residual variance of at most `least`, m².
fn limited((time, displacement): (&[f64], &[f64]), at: usize, reach: usize, cubic: f64, least: f64) -> f64 {
    if at < reach || at + reach >= time.len() || reach < 2 {
        return cubic;
    }
    let fit = |window: std::ops::RangeInclusive<usize>, order| {
        let (t, x) = (&time[window.clone()], &displacement[window.clone()]);
        polynomial(t, x, at - window.start(), order)
    };
    let (Some(whole), Some(before), Some(after)) =
        (fit(at - reach..=at + reach, 3), fit(at - reach..=at, 1), fit(at..=at + reach, 1))
    else {
        return cubic;
    };
    if whole.variance > least && before.variance.min(after.variance) < whole.variance {
        restrict(cubic, before.slope.min(after.slope), before.slope.max(after.slope))
    } else {
        cubic
    }
}

/// Returns the numbers of samples on each side of the center of successive windows, up to the `longest`.
fn reaches(longest: usize) -> impl Iterator<Item = usize> {
    let next = move |reach: &usize| (*reach < longest).then(|| ((LONGER * *reach as f64).ceil() as usize).min(longest));
    std::iter::successors(Some(longest.min(SHORTEST)), next)
}

/// Returns the standard deviation of the white noise of a displacement channel, m. If most samples equal their
/// neighbor, it is at least that of the quantization.
///
/// In a motion by more than the resolution in each sample, the smallest step is the motion itself. The noise of the
/// channel then contains the quantization error.
fn displacement_noise(displacement: &[f64]) -> f64 {
    let repeated = displacement.windows(2).filter(|pair| pair[0] == pair[1]).count();
    let resolution = if 2 * repeated > displacement.len() { quantum(displacement) } else { 0.0 };
    // The quantization error has a variance of a twelfth of the squared step.
    channel_noise(displacement).max(resolution / 12f64.sqrt())
}

/// Slopes of the cubics over windows of one length, with the same number of samples on both sides.
struct Slopes {
    slopes: Vec<f64>,
    /// Standard deviation of each slope relative to that of the noise, 1/s. It is larger at the ends of the record,
    /// where windows are one-sided.
    gains: Vec<f64>,
    /// Weights of a window that is not at an end of the record.
    weights: Vec<f64>,
}

fn slopes(time: &[f64], displacement: &[f64], reach: usize) -> Slopes {
    let (n, step) = (time.len(), sample_time(time));
    let uniform = (0..=2 * reach).map(|i| i as f64 * step).collect::<Vec<_>>();
    let weights = slope_weights(&uniform, reach);
    let gain = |weights: &[f64]| weights.iter().map(|w| w * w).sum::<f64>().sqrt();
    let (mut velocity, mut gains) = (vec![0.0; n], vec![gain(&weights); n]);
    for i in 0..n {
        let from = i.saturating_sub(reach);
        let to = (i + reach).min(n - 1);
        let centred = to - from == 2 * reach;
        let even = centred && {
            let start = time[i] - reach as f64 * step;
            // Files round the time stamps. Deviations below 0.02 steps hardly change the slope of a cubic.
            (from..=to).all(|k| (time[k] - start - (k - from) as f64 * step).abs() < 0.02 * step)
        };
        velocity[i] = if even {
            weights.iter().zip(&displacement[from..=to]).map(|(w, x)| w * (x - displacement[i])).sum()
        } else {
            let own = slope_weights(&time[from..=to], i - from);
            gains[i] = gain(&own);
            own.iter().zip(&displacement[from..=to]).map(|(w, x)| w * (x - displacement[i])).sum()
        };
    }
    Slopes { slopes: velocity, gains, weights }
}

/// Returns the powers 0 to `order` of the scaled time `u`. The higher powers are 0.
fn powers(u: f64, order: usize) -> Vector4<f64> {
    let mut row = Vector4::new(1.0, u, u * u, u * u * u);
    for k in order + 1..4 {
        row[k] = 0.0;
    }
    row
}

/// Least-squares polynomial of the displacements in a window.
struct Polynomial {
    /// Slope at the sample for which the window was chosen, m/s.
    slope: f64,
    /// Sum of squared residuals divided by the degrees of freedom, m².
    variance: f64,
}

/// Fits a polynomial of the degree `order` to displacements, m, at the times `time`, s. Its slope is that at the sample
/// `at`. Returns `None` without a degree of freedom.
fn polynomial(time: &[f64], displacement: &[f64], at: usize, order: usize) -> Option<Polynomial> {
    let freedom = time.len().checked_sub(order + 1).filter(|freedom| *freedom > 0)?;
    let scale = (time[time.len() - 1] - time[0]) / 2.0;
    let row = |t: f64| powers((t - time[at]) / scale, order);
    let (mut normal, mut right) = (Matrix4::zeros(), Vector4::zeros());
    for (&t, x) in time.iter().zip(displacement) {
        normal += row(t) * row(t).transpose();
        right += row(t) * (x - displacement[at]);
    }
    for k in order + 1..4 {
        normal[(k, k)] = 1.0;
    }
    let solution = normal.lu().solve(&right)?;
    let residual = |t: f64, x: f64| x - displacement[at] - row(t).dot(&solution);
    let squares: f64 = time.iter().zip(displacement).map(|(&t, x)| residual(t, *x).powi(2)).sum();
    Some(Polynomial { slope: solution[1] / scale, variance: squares / freedom as f64 })
}

/// Computes the weights, 1/s, of the values at the times `time`, s, for the derivative of their least-squares cubic at
/// the sample `at`.
///
/// If there are too few values, the polynomial is a parabola or a line.
fn slope_weights(time: &[f64], at: usize) -> Vec<f64> {
    let scale = (time[time.len() - 1] - time[0]) / 2.0;
    let order = (time.len() - 1).min(3);
    let powers = |t: f64| powers((t - time[at]) / scale, order);
    let mut normal = Matrix4::zeros();
    for &t in time {
        let row = powers(t);
        normal += row * row.transpose();
    }
    for k in order + 1..4 {
        normal[(k, k)] = 1.0;
    }
    let slope = Vector4::new(0.0, 1.0, 0.0, 0.0);
    match normal.lu().solve(&slope) {
        Some(coefficients) => time.iter().map(|&t| powers(t).dot(&coefficients) / scale).collect(),
        None => vec![0.0; time.len()],
    }
}

/// Returns the frequency, Hz, at which a symmetric differentiator is 3 dB below the true derivative, at most half the
/// sampling rate. `step` is the sampling interval, s.
fn bandwidth(weights: &[f64], step: f64) -> f64 {
    let reach = weights.len() / 2;
    let nyquist = 0.5 / step;
    let gain = |f: f64| {
        let omega = std::f64::consts::TAU * f;
        weights.iter().enumerate().map(|(k, w)| w * libm::sin(omega * (k as f64 - reach as f64) * step)).sum::<f64>()
            / omega
    };
    let count = 400;
    (1..=count)
        .map(|k| nyquist * f64::from(k) / f64::from(count))
        .find(|&f| gain(f) < std::f64::consts::FRAC_1_SQRT_2)
        .unwrap_or(nyquist)
}

/// Integrates a velocity, m/s, to a displacement, m, from the position `initial`, m.
///
/// If the samples are evenly spaced, the method is the cubic through the four samples around every step. Otherwise, it
/// is the trapezoidal rule. At twenty samples per cycle of a sine, the error of trapezoids is 0.8 % of the amplitude,
/// that of the cubic 0.02 %.
pub(crate) fn integrate(time: &[f64], velocity: &[f64], initial: f64) -> Vec<f64> {
    let n = time.len();
    let mut x = initial;
    let mut displacement = Vec::with_capacity(n);
    displacement.extend((n > 0).then_some(initial));
    for i in 1..n {
        let step = time[i] - time[i - 1];
        let mut mean = 0.5 * (velocity[i] + velocity[i - 1]);
        if i >= 2 && i + 1 < n {
            let (before, after) = (time[i - 1] - time[i - 2], time[i + 1] - time[i]);
            if (before - step).abs() < 0.05 * step && (after - step).abs() < 0.05 * step {
                // Mean velocity of the step from v1 to v2, with the cubic through v0 to v3: (13 (v1 + v2) − v0 − v3) /
                // 24.
                mean = (13.0 * (velocity[i] + velocity[i - 1]) - velocity[i - 2] - velocity[i + 1]) / 24.0;
            }
        }
        x += mean * step;
        displacement.push(x);
    }
    displacement
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use dashpot_test_support::drawn;
    use proptest::prelude::*;

    use super::*;
    use crate::fixtures::Random;

    fn sine(frequency: f64, rate: f64, n: usize) -> (Vec<f64>, Vec<f64>, Vec<f64>) {
        let time: Vec<f64> = (0..n).map(|i| i as f64 / rate).collect();
        let x = time.iter().map(|t| 0.05 * libm::sin(TAU * frequency * t)).collect();
        let v = time.iter().map(|t| 0.05 * TAU * frequency * libm::cos(TAU * frequency * t)).collect();
        (time, x, v)
    }

    #[test]
    fn derivative_of_a_sine_keeps_gain_and_phase() {
        for (frequency, rate) in [(1.0, 100.0), (0.01, 10.0), (10.0, 1000.0)] {
            let (time, x, v) = sine(frequency, rate, (4.0 * rate / frequency) as usize);
            let (derived, filter) = differentiate(&time, &x, 1.0 / (12.0 * frequency));
            let peak = 0.05 * TAU * frequency;
            for i in filter.points..time.len() - filter.points {
                assert!((derived[i] - v[i]).abs() < 2e-4 * peak, "{frequency} Hz at {i}: {} {}", derived[i], v[i]);
            }
            // At the ends of the record, where windows are one-sided, the error is below 1 % of the peak velocity.
            assert!(derived.iter().zip(&v).all(|(a, b)| (a - b).abs() < 1e-2 * peak));
            assert!(filter.bandwidth > 5.0 * frequency, "{filter:?}");
        }
    }

    #[test]
    fn the_stated_bandwidth_is_where_a_sine_loses_three_decibels() {
        let (time, x, _) = sine(1.0, 200.0, 400);
        let (_, filter) = differentiate(&time, &x, 0.1);
        let (time, x, v) = sine(filter.bandwidth, 200.0, 400);
        let derived = slopes(&time, &x, 10).slopes;
        let gain = derived[30..370].iter().zip(&v[30..370]).map(|(a, b)| a * b).sum::<f64>()
            / v[30..370].iter().map(|b| b * b).sum::<f64>();
        assert!((gain - std::f64::consts::FRAC_1_SQRT_2).abs() < 0.02, "{gain}");
    }

    /// Checks the motion of a common friction test, with constant velocity in both directions.
    #[test]
    fn a_triangle_keeps_its_velocity_up_to_its_corners() {
        let (rate, frequency, speed) = (1000.0, 0.31, 0.05);
        let mut noise = 1u64;
        let mut white = || {
            // The sum of twelve uniform numbers is close to a Gaussian.
            (0..12)
                .map(|_| {
                    noise = noise.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
                    (noise >> 11) as f64 / (1u64 << 53) as f64
                })
                .sum::<f64>()
                - 6.0
        };
        let time: Vec<f64> = (0..13_000).map(|i| f64::from(i) / rate).collect();
        let phase = |t: f64| (frequency * t).fract();
        let triangle = |t: f64| speed / frequency * (0.25 - (phase(t) - 0.5).abs());
        let x: Vec<f64> = time.iter().map(|t| triangle(*t) + 2e-6 * white()).collect();
        let (v, filter) = differentiate(&time, &x, 1.0 / (12.0 * frequency));
        let truth = |t: f64| if phase(t) < 0.5 { speed } else { -speed };
        // Largest velocity error, m/s, of the samples that are more than `from` seconds away from a corner.
        let off = |from: f64| {
            let near = |t: f64| (phase(t) - 0.5).abs().min(phase(t)).min(1.0 - phase(t)) / frequency < from;
            time.iter().zip(&v).filter(|(t, _)| !near(**t)).map(|(t, v)| (v - truth(*t)).abs()).fold(0.0, f64::max)
        };
        assert!(off(0.02) < 0.05 * speed && off(0.15) < 0.01 * speed, "{} {}", off(0.02), off(0.15));
        assert!(filter.shorter > 0.02 && filter.shorter < 0.5, "{filter:?}");
        // For a sine with the same noise, nearly all samples have the longest window.
        let x: Vec<f64> = time.iter().map(|t| 0.05 * libm::sin(TAU * frequency * t) + 2e-6 * white()).collect();
        assert!(differentiate(&time, &x, 1.0 / (12.0 * frequency)).1.shorter < 2e-3);
    }

    /// Checks that no sample near a corner is faster than the motion, for sharp and rounded corners at and between
    /// samples, with and without noise.
    #[test]
    fn a_corner_does_not_overshoot() {
        let (speed, half) = (0.4, 0.15);
        for (step, shift, rounding, noise) in [
            (0.002, 0.0, 0.0, 0.0),
            (0.002, 0.001, 0.0, 0.0),
            (0.002, 0.0004, 0.0, 1e-6),
            (0.0005, 0.0001, 0.0, 1e-6),
            (0.005, 0.0, 0.0, 0.0),
            (0.002, 0.0007, 0.005, 0.0),
            (0.0005, 0.0001, 0.005, 1e-6),
            (0.005, 0.002, 0.005, 0.0),
        ] {
            let mut random = Random::new(7);
            let time: Vec<f64> = (0..(0.9 / step) as usize).map(|i| i as f64 * step + shift).collect();
            // A rounded corner is a parabola over the time `rounding`, s.
            let triangle = |t: f64| {
                let phase = (t / half).rem_euclid(2.0);
                let from = half * (phase - phase.round()).abs();
                let bend = if from < 0.5 * rounding { (0.5 * rounding - from).powi(2) / rounding } else { 0.0 };
                let towards = if phase.round() as i64 == 1 { half - from - bend } else { from + bend };
                speed * towards
            };
            let x: Vec<f64> = time.iter().map(|t| triangle(*t) + noise * random.normal()).collect();
            let (v, _) = differentiate(&time, &x, half / 6.0);
            let inside = 3..time.len() - 3;
            let fastest = v[inside].iter().fold(0.0, |most: f64, v| most.max(v.abs()));
            let largest = speed + 4.0 * noise / step;
            assert!(fastest <= 1.03 * largest, "{step} {shift} {rounding} {noise}: {fastest}");
        }
    }

    proptest! {
        #![proptest_config(drawn(256))]
        #[test]
        fn cubics_are_differentiated_exactly_at_uneven_times(
            c in prop::array::uniform4(-1.0..1.0_f64),
            jitter in prop::collection::vec(-0.4..0.4_f64, 40),
        ) {
            let time: Vec<f64> = jitter.iter().enumerate().map(|(i, j)| 0.1 * (i as f64 + j)).collect();
            let x: Vec<f64> = time.iter().map(|t| c[0] + t * (c[1] + t * (c[2] + t * c[3]))).collect();
            let (v, _) = differentiate(&time, &x, 0.8);
            for (t, v) in time.iter().zip(v) {
                let exact = c[1] + t * (2.0 * c[2] + 3.0 * c[3] * t);
                prop_assert!((v - exact).abs() < 1e-8 * (1.0 + exact.abs()), "{v} {exact}");
            }
        }
    }

    #[test]
    fn integration_gives_the_sine_back() {
        let (time, x, v) = sine(1.0, 20.0, 81);
        let integrated = integrate(&time, &v, 0.0);
        assert!(integrated.iter().zip(&x).all(|(a, b)| (a - b).abs() < 5e-3 * 0.05));
        assert_eq!(integrate(&[0.0, 1.0, 3.0], &[1.0, 1.0, 1.0], 2.0), [2.0, 3.0, 5.0]);
        assert!(integrate(&[], &[], 0.0).is_empty());
    }

    #[test]
    fn a_window_holds_a_bounded_number_of_samples() {
        let time: Vec<f64> = (0..2000).map(|i| 1e-3 * f64::from(i)).collect();
        let displacement: Vec<f64> = time.iter().map(|t| libm::sin(*t)).collect();
        assert_eq!(differentiate(&time, &displacement, 10.0).1.points, 501);
    }

    #[test]
    fn windows_grow_by_less_than_half_and_are_few() {
        let reaches: Vec<usize> = reaches(250).collect();
        assert!(
            reaches.windows(2).all(|pair| pair[0] < pair[1] && pair[1] as f64 <= 1.7 * pair[0] as f64),
            "{reaches:?}"
        );
        assert!(reaches[0] == 2 && reaches.last() == Some(&250) && reaches.len() <= 16, "{reaches:?}");
    }
}
