//! How far the records leave the numbers of a refit open.

use super::gram::gram;
use super::hypothesis::Hypothesis;
use super::refit::Refit;
use nalgebra::DMatrix;

/// Standard deviations of the numbers of a refit, widened where more than noise is left.
pub fn deviations(hypothesis: &Hypothesis, refit: &Refit) -> Vec<f64> {
    let excess = excess(refit).sqrt();
    by_noise(hypothesis, refit).into_iter().map(|d| excess * d).collect()
}

/// Covariance of the numbers of a refit, widened where more than noise is left; nothing where some of them are not known at all.
pub fn covariance(hypothesis: &Hypothesis, refit: &Refit) -> Option<DMatrix<f64>> {
    let excess = excess(refit);
    inverse(hypothesis, refit).map(|(inverse, scale)| {
        DMatrix::from_fn(scale.len(), scale.len(), |i, j| excess * inverse[(i, j)] / (scale[i] * scale[j]))
    })
}

/// By how much more than noise is left, as variances; 1 where it is no more.
fn excess(refit: &Refit) -> f64 {
    (refit.chi2 / refit.residual.len().max(1) as f64).max(1.0)
}

/// Standard deviations by noise alone.
pub fn by_noise(hypothesis: &Hypothesis, refit: &Refit) -> Vec<f64> {
    match inverse(hypothesis, refit) {
        Some((inverse, scale)) => (0..scale.len()).map(|i| inverse[(i, i)].max(0.0).sqrt() / scale[i]).collect(),
        None => vec![f64::INFINITY; hypothesis.numbers.len()],
    }
}

/// Inverse of the normal equations in units of their diagonal, and these units.
fn inverse(hypothesis: &Hypothesis, refit: &Refit) -> Option<(DMatrix<f64>, Vec<f64>)> {
    let mut normal = gram(&refit.jacobian);
    let n = normal.nrows();
    for (i, number) in hypothesis.numbers.iter().enumerate() {
        normal[(i, i)] += 1e-12 / (number.step * number.step);
        if let Some((_, deviation)) = number.prior {
            normal[(i, i)] += 1.0 / (deviation * deviation);
        }
    }
    let scale: Vec<f64> = (0..n).map(|i| normal[(i, i)].sqrt().max(1e-150)).collect();
    let scaled = DMatrix::from_fn(n, n, |i, j| normal[(i, j)] / (scale[i] * scale[j]));
    scaled.try_inverse().map(|inverse| (inverse, scale))
}
