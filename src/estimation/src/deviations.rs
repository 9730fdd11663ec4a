//! How far the records leave the numbers of a refit open.

use super::gram::gram;
use super::hypothesis::{Hypothesis, Number};
use super::refit::Refit;
use super::samples::Test;
use nalgebra::{DMatrix, DVector};
use rayon::prelude::*;

/// Covariance in the sandwich form (White, Econometrica 48, 1980), with how well each number is determined.
///
/// The noise of every test comes from its own residual, discounted for the correlation of its samples, so that form errors widen the
/// intervals. A number is determined apart from all others and from its prior: 1 fully, 0 not at all.
pub fn sandwich(hypothesis: &Hypothesis, refit: &Refit, tests: &[Test]) -> Option<(DMatrix<f64>, Vec<f64>)> {
    let mut first = 0;
    let blocks: Vec<(DMatrix<f64>, Vec<f64>)> = tests
        .iter()
        .map(|test| {
            let (from, count) = (first, test.count());
            first += count;
            let rows = refit.jacobian.rows(from, count).into_owned();
            (rows, refit.residual.rows(from, count).iter().copied().collect())
        })
        .collect();
    let precision =
        |number: &Number| number.prior.map_or(1e-12 / (number.step * number.step), |(_, sd)| 1.0 / (sd * sd));
    robust_covariance(&blocks, &hypothesis.numbers.iter().map(precision).collect::<Vec<_>>())
}

/// Covariance of free numbers in the sandwich form, and how well each is determined: see [`sandwich`].
///
/// A block holds derivatives and weighted residuals of one test; `precisions` are those of the priors.
pub fn robust_covariance(blocks: &[(DMatrix<f64>, Vec<f64>)], precisions: &[f64]) -> Option<(DMatrix<f64>, Vec<f64>)> {
    let n = precisions.len();
    let parts: Vec<(DMatrix<f64>, f64)> = blocks
        .par_iter()
        .map(|(rows, residual)| {
            let variance = residual.iter().map(|r| r * r).sum::<f64>() / residual.len().max(1) as f64;
            (gram(rows), (variance * correlation_factor(residual)).max(1.0))
        })
        .collect();
    let (mut hessian, mut meat) = (DMatrix::zeros(n, n), DMatrix::zeros(n, n));
    for (part, variance) in &parts {
        hessian += part;
        meat += part * *variance;
    }
    let information: Vec<f64> = (0..n).map(|i| hessian[(i, i)]).collect();
    for (i, precision) in precisions.iter().enumerate() {
        hessian[(i, i)] += precision;
        meat[(i, i)] += precision;
    }
    let scale: Vec<f64> = (0..n).map(|i| hessian[(i, i)].sqrt().max(1e-150)).collect();
    let scaled = DMatrix::from_fn(n, n, |i, j| hessian[(i, j)] / (scale[i] * scale[j]));
    let inverse = scaled.try_inverse()?;
    let determined = (0..n).map(|i| (information[i] / (scale[i] * scale[i])) / inverse[(i, i)].max(1.0)).collect();
    let bread = DMatrix::from_fn(n, n, |i, j| inverse[(i, j)] / (scale[i] * scale[j]));
    Some((&bread * meat * &bread, determined))
}

/// How far each free number moves where a number that is considered and not estimated is off by 1.
///
/// A block holds derivatives of one test; `considered` are the derivatives of its residuals over that number. This is the term that a consider
/// parameter adds to an estimate (Bierman, Factorization Methods for Discrete Sequential Estimation, 1977, VIII).
pub fn considered_shift(
    blocks: &[(DMatrix<f64>, Vec<f64>)],
    precisions: &[f64],
    considered: &[Vec<f64>],
) -> Option<DVector<f64>> {
    let n = precisions.len();
    let (mut hessian, mut right) = (DMatrix::zeros(n, n), DVector::zeros(n));
    for ((rows, _), column) in blocks.iter().zip(considered) {
        hessian += gram(rows);
        right -= rows.tr_mul(&DVector::from_column_slice(column));
    }
    for (i, precision) in precisions.iter().enumerate() {
        hessian[(i, i)] += precision;
    }
    let scale: Vec<f64> = (0..n).map(|i| hessian[(i, i)].sqrt().max(1e-150)).collect();
    let scaled = DMatrix::from_fn(n, n, |i, j| hessian[(i, j)] / (scale[i] * scale[j]));
    let found = scaled.cholesky()?.solve(&DVector::from_fn(n, |i, _| right[i] / scale[i]));
    Some(DVector::from_fn(n, |i, _| found[i] / scale[i]))
}

/// Number of samples that equal one independent sample: the integrated autocorrelation of the residual.
///
/// The sum ends where it first falls below noise (Geyer's initial positive sequence, Stat. Sci. 7, 1992).
fn correlation_factor(residual: &[f64]) -> f64 {
    let n = residual.len();
    let variance: f64 = residual.iter().map(|r| r * r).sum();
    if n < 8 || variance <= 0.0 {
        return 1.0;
    }
    let lag = |k: usize| (0..n - k).map(|i| residual[i] * residual[i + k]).sum::<f64>() / variance;
    let mut sum = 1.0;
    let noise = 2.0 / (n as f64).sqrt();
    for k in 1..n / 2 {
        let r = lag(k);
        if r < noise {
            break;
        }
        sum += 2.0 * r;
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn samples_of_a_slow_residual_stand_for_few() {
        let slow: Vec<f64> = (0..400).map(|k| libm::sin(0.03 * f64::from(k))).collect();
        let noise: Vec<f64> =
            (0..400u32).map(|k| f64::from(k.wrapping_mul(2_654_435_761) >> 16) / 65_536.0 - 0.5).collect();
        assert!(correlation_factor(&noise) < 2.0 && correlation_factor(&slow) > 20.0);
    }
}
