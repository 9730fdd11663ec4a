//! Errors of a hypothesis, and the fraction of its error above the noise that a change of the model removes.

use super::heating::Heating;
use super::hypothesis::Hypothesis;
use super::samples::Test;
use super::sensitivity::Accuracy;
use dashpot_records::Record;
use std::sync::Arc;

/// Computes the residuals of a hypothesis in each test, N, measured minus computed, with an integration of the given
/// accuracy. Returns `None` if the model gives no finite force.
pub fn errors(
    accuracy: Accuracy,
    hypothesis: &Hypothesis,
    theta: &[f64],
    records: &[&Record],
    tests: &[Test],
) -> Option<Vec<Vec<f64>>> {
    let mut own = hypothesis.clone();
    if own.heating.is_some() {
        own.heating = Some(Arc::new(Heating::new(records, tests)));
    }
    let forces = own.forces_by(&own.model_by(accuracy, theta)?, tests, theta)?;
    Some(tests.iter().zip(&forces).map(|(t, f)| t.forces().iter().zip(f).map(|(m, f)| m - f).collect()).collect())
}

/// Computes the root mean square of values, in their unit, or 0 for an empty list.
pub fn rms(values: &[f64]) -> f64 {
    (values.iter().map(|v| v * v).sum::<f64>() / values.len().max(1) as f64).sqrt()
}

/// Computes the root mean square over tests of the root mean square error of each test, in the unit of `errors`.
pub fn rms_of_tests(errors: &[Vec<f64>]) -> f64 {
    rms(&errors.iter().map(|e| rms(e)).collect::<Vec<_>>())
}

/// Computes the root mean square error over tests, in units of each test's typical allowed error. `errors` are in N.
///
/// In these units, a slow test with small forces has the same weight as a fast test.
pub fn in_noise(tests: &[Test], errors: &[Vec<f64>]) -> f64 {
    rms(&tests.iter().zip(errors).map(|(t, e)| rms(e) / t.segment.scale).collect::<Vec<_>>())
}

/// Computes the root mean square residual that noise alone causes, in the units of [`in_noise`].
pub fn noise_alone(tests: &[Test]) -> f64 {
    rms(&tests.iter().map(|t| t.mean_noise / t.segment.scale).collect::<Vec<_>>())
}

/// Computes the fraction of the error above the noise that a change of the model removes. `before` and `after` are the
/// errors, N, before and after the change. Returns `None` if the error before the change is at most 2 % above the
/// noise.
pub fn gap_closed(tests: &[Test], before: &[Vec<f64>], after: &[Vec<f64>]) -> Option<f64> {
    let (before, after, noise) = (in_noise(tests, before), in_noise(tests, after), noise_alone(tests));
    (before > 1.02 * noise).then(|| 1.0 - (after - noise) / (before - noise))
}
