//! Allowed error of the model in each sample: noise, form of the FV curve, timing.

use crate::segment::Segment;

/// Allowed error independent of noise, as a fraction of the largest force. Curves through a dozen points have at least
/// this error.
const FORM: f64 = 0.002;
/// Timing error as a fraction of a sample interval.
///
/// The force error is this fraction of the change from sample to sample. If friction reverses within a sample, the
/// force jumps, and this fraction of the samples is on the wrong side of the jump.
const TIMING: f64 = 0.05;

/// Computes the typical allowed error, N: the allowed error of a sample at which the force is constant. `noise` is the
/// noise variance, N². `top` is the largest force, N.
pub fn typical(noise: f64, top: f64) -> f64 {
    (noise + (FORM * top).powi(2)).sqrt().max(1e-6)
}

/// Computes the allowed error of each sample of a mean cycle, N.
///
/// `noise` is the variance of a sample's mean divided by the fraction of independent samples, N². `times` contains a
/// factor on `noise` for each sample. `mean_noise` is the standard deviation of a sample's mean, N. A jump of the force
/// increases the allowed error only by its part above `mean_noise`.
pub fn in_cycle(segment: &Segment, noise: f64, times: &[f64], mean_noise: f64) -> Vec<f64> {
    let n = times.len();
    allowed(segment, noise, mean_noise, |i| times[i], |i, k| (i + k + n - 2) % n)
}

/// Computes the allowed error of each scored sample of a road signal, N. `noise` and `mean_noise` are those of
/// [`in_cycle`].
pub fn on_a_road(segment: &Segment, noise: f64, mean_noise: f64) -> Vec<f64> {
    let n = segment.force.len() - segment.from;
    allowed(segment, noise, mean_noise, |_| 1.0, |i, k| (i + k).saturating_sub(2).min(n - 1))
}

/// Computes the allowed errors, N, of all scored samples. `beside(i, k)` is the index of neighbor k of sample i, from 0
/// (two before) to 4 (two after).
fn allowed(
    segment: &Segment,
    noise: f64,
    mean_noise: f64,
    times: impl Fn(usize) -> f64,
    beside: impl Fn(usize, usize) -> usize,
) -> Vec<f64> {
    let form = (FORM * segment.top).powi(2);
    let scored = &segment.force[segment.from..];
    (0..scored.len())
        .map(|i| {
            let at = |k: usize| scored[beside(i, k)];
            let half = 0.5 * (at(3) - at(1));
            let runs = (at(1) - at(0)).abs() + (at(4) - at(3)).abs();
            let jump = (half.abs() - 0.5 * runs - mean_noise).max(0.0);
            (noise * times(i) + form + (TIMING * half).powi(2) + TIMING * jump * jump).sqrt().max(1e-6)
        })
        .collect()
}
