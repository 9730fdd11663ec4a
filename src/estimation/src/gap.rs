//! Errors of an explanation, and how much of the gap between model and noise is closed.

use super::heating::Heating;
use super::hypothesis::Hypothesis;
use super::samples::Test;
use super::sensitivity::Accuracy;
use dashpot_records::Record;
use std::sync::Arc;

/// Residuals in N of an explanation on tests of its own choice, integrated this exactly.
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

/// Root mean square; 0 of nothing.
pub fn rms(values: &[f64]) -> f64 {
    (values.iter().map(|v| v * v).sum::<f64>() / values.len().max(1) as f64).sqrt()
}

/// Root mean square over tests of each test's root mean square.
pub fn rms_of_tests(errors: &[Vec<f64>]) -> f64 {
    rms(&errors.iter().map(|e| rms(e)).collect::<Vec<_>>())
}

/// Root mean square error over tests, in units of what each test's noise and form allow.
///
/// So a slow test of small forces counts like a fast one.
pub fn in_noise(tests: &[Test], errors: &[Vec<f64>]) -> f64 {
    rms(&tests.iter().zip(errors).map(|(t, e)| rms(e) / t.segment.scale).collect::<Vec<_>>())
}

/// Residual that noise alone leaves, N.
pub fn noise_alone(tests: &[Test]) -> f64 {
    rms(&tests.iter().map(|t| t.mean_noise / t.segment.scale).collect::<Vec<_>>())
}

/// Share of the gap between model and noise that is closed.
pub fn gap_closed(tests: &[Test], before: &[Vec<f64>], after: &[Vec<f64>]) -> Option<f64> {
    let (before, after, noise) = (in_noise(tests, before), in_noise(tests, after), noise_alone(tests));
    (before > 1.02 * noise).then(|| 1.0 - (after - noise) / (before - noise))
}
