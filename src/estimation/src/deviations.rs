//! Uncertainty of the parameters of a refit.

use super::gram::gram;
use super::hypothesis::{Free, Hypothesis, Number, Residual};
use super::refit::Refit;
use super::samples::Test;
use crate::sensitivity::Accuracy;
use crate::unknowns::Unknown;
use dashpot_records::restrict;
use nalgebra::{DMatrix, DVector};
use rayon::prelude::*;
use std::collections::BTreeMap;

/// Computes the covariance of the free parameters in the sandwich form (White, Econometrica 48, 1980), and the degree
/// of determination of each parameter.
///
/// The noise of every test comes from its own residual, which includes the form error of the model, and accounts for
/// the correlation of its samples. Form errors thus widen the intervals.
///
/// The degree of determination states how far the records alone determine a parameter: 1 means fully, 0 means not at
/// all. Correlation with other parameters reduces it, and the prior does not contribute to it.
///
/// A small change of a parameter may move a jump of the force from one sample to the next. The linearization is then
/// not valid. The standard deviation of such a parameter is therefore widened according to the nonlinear force.
///
/// Returns `None` if the Hessian is singular.
pub fn sandwich(hypothesis: &Hypothesis, refit: &Refit, tests: &[Test]) -> Option<(DMatrix<f64>, Vec<f64>)> {
    sandwich_of(hypothesis, refit, tests, &|theta| hypothesis.residual_by(Accuracy::Derivatives, tests, theta))
}

/// Computes the [`sandwich`] covariance with the residuals of the function `residual_at`. Returns `None` if the Hessian
/// is singular.
pub(crate) fn sandwich_of(
    hypothesis: &Hypothesis,
    refit: &Refit,
    tests: &[Test],
    residual_at: &(dyn Fn(&[f64]) -> Option<Residual> + Sync),
) -> Option<(DMatrix<f64>, Vec<f64>)> {
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
    let precisions: Vec<f64> = hypothesis.numbers.iter().map(precision).collect();
    let (mut covariance, determined) = robust_covariance(&blocks, &precisions)?;
    let stretches = stretches(hypothesis, refit, residual_at, &covariance, &precisions);
    for (i, j) in (0..precisions.len()).flat_map(|i| (0..precisions.len()).map(move |j| (i, j))) {
        covariance[(i, j)] *= stretches[i] * stretches[j];
    }
    Some((covariance, determined))
}

/// Number of standard deviations at which the linearization is compared with the nonlinear force. The ends of a 95 %
/// interval are about this far from the estimate.
const END: f64 = 2.0;
/// Ratio of the squared change of the force to its linearized value below which the force counts as nearly constant. If
/// the force is only nonlinear, its change reaches at least half of the linearized change within the interval. The
/// ratio is then at least a quarter. If the force jumps between two samples, its change is much smaller.
const FLAT: f64 = 0.25;
/// Largest factor by which a standard deviation is widened. The search for the factor ends there.
const FARTHEST: f64 = 1024.0;

/// Computes, for each parameter, the factor on its standard deviation at which the squared change of the force reaches
/// [`FLAT`] times the linearized one.
///
/// The other parameters change with the parameter, according to their correlation. The parameter is both increased and
/// decreased, and the smaller change of the force determines the factor. The factor is at least 1. It is 1 for the
/// parameters of curves, and for all parameters if the forces at the refit are not finite.
fn stretches(
    hypothesis: &Hypothesis,
    refit: &Refit,
    residual_at: &(dyn Fn(&[f64]) -> Option<Residual> + Sync),
    covariance: &DMatrix<f64>,
    precisions: &[f64],
) -> Vec<f64> {
    let Some(here) = residual_at(&refit.theta) else { return vec![1.0; refit.theta.len()] };
    let of_number = |k: usize| {
        // The force is nearly linear in the forces at the points of a curve, so the linearization needs no check.
        let is_of_curve = matches!(
            hypothesis.numbers[k].free,
            Free::Curve(_) | Free::Model(Unknown::Rise { .. } | Unknown::Entry(..))
        );
        let deviation = covariance[(k, k)].max(0.0).sqrt();
        if is_of_curve || !(deviation > 0.0 && deviation.is_finite()) {
            return 1.0;
        }
        let direction = covariance.column(k) * (END / deviation);
        // A prior acts as a measurement of the parameter, so its term is added to the squared change.
        let by_prior: f64 = direction.iter().zip(precisions).map(|(by, precision)| precision * by * by).sum();
        let by_tangent = (&refit.jacobian * &direction).norm_squared() + by_prior;
        let change = |factor: f64| -> Option<f64> {
            let (low, high) = hypothesis.numbers[k].bounds;
            let beyond = refit.theta[k] + factor * direction[k];
            if beyond < low || beyond > high {
                return None;
            }
            let theta: Vec<f64> = hypothesis
                .numbers
                .iter()
                .zip(&refit.theta)
                .zip(direction.iter())
                .map(|((number, at), by)| restrict(at + factor * by, number.bounds.0, number.bounds.1))
                .collect();
            residual_at(&theta).map(|there| (there - &here).norm_squared() + factor * factor * by_prior)
        };
        let on_side = |side: f64| stretch(FLAT * by_tangent, &|factor| change(side * factor));
        on_side(1.0).max(on_side(-1.0))
    };
    (0..refit.theta.len()).into_par_iter().map(of_number).collect()
}

/// Finds the factor, between 1 and [`FARTHEST`], at which the squared change of the force reaches `least`, by doubling
/// and logarithmic interpolation. If the parameter reaches a bound, returns the first factor beyond the bound.
fn stretch(least: f64, change: &dyn Fn(f64) -> Option<f64>) -> f64 {
    let (mut factor, mut last) = (1.0, None);
    while factor < FARTHEST {
        let Some(squared) = change(factor) else { return factor };
        match last {
            None if squared >= least => return factor,
            Some(before) if squared >= least => {
                let before = f64::max(before, 1e-9 * least);
                return 0.5 * factor * libm::exp2(libm::log(least / before) / libm::log(squared / before));
            }
            _ => last = Some(squared),
        }
        factor *= 2.0;
    }
    factor
}

/// Computes the covariance of free parameters in the sandwich form, and the degree of determination of each.
///
/// A block contains derivatives and weighted residuals of one test; `precisions` are the reciprocal variances of the
/// priors. [`sandwich`] explains both results. Returns `None` if the Hessian is singular.
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
    let inverse = Inverse::new(&hessian)?;
    let Inverse { scaled, scale } = &inverse;
    let determined = (0..n).map(|i| (information[i] / (scale[i] * scale[i])) / scaled[(i, i)].max(1.0)).collect();
    let bread = inverse.matrix();
    Some((&bread * meat * &bread, determined))
}

/// Computes the covariance of free parameters from groups of samples. Errors may be correlated in any way within a
/// group, but not between groups (Liang & Zeger, Biometrika 73, 1986).
///
/// A block contains derivatives and weighted residuals of one test, `precisions` the reciprocal variances of the
/// priors, and `groups` the group of each sample. Returns `None` for fewer than two groups, or if the Hessian is
/// singular.
pub fn grouped_covariance(
    blocks: &[(DMatrix<f64>, Vec<f64>)],
    precisions: &[f64],
    groups: &[Vec<usize>],
) -> Option<DMatrix<f64>> {
    let n = precisions.len();
    let mut hessian = DMatrix::zeros(n, n);
    let mut gradients: BTreeMap<usize, DVector<f64>> = BTreeMap::new();
    for ((rows, residual), own) in blocks.iter().zip(groups) {
        hessian += gram(rows);
        for (row, (residual, group)) in residual.iter().zip(own).enumerate() {
            let gradient = gradients.entry(*group).or_insert_with(|| DVector::zeros(n));
            gradient.axpy(*residual, &rows.row(row).transpose(), 1.0);
        }
    }
    precisions.iter().enumerate().for_each(|(i, precision)| hessian[(i, i)] += precision);
    let bread = Inverse::new(&hessian)?.matrix();
    let count = gradients.len() as f64;
    if count < 2.0 {
        return None;
    }
    let mut covariance = DMatrix::zeros(n, n);
    for gradient in gradients.values() {
        let shift = &bread * gradient;
        covariance.ger(count / (count - 1.0), &shift, &shift, 1.0);
    }
    Some(covariance)
}

/// Inverse of a Hessian with a unit diagonal, and the scales that give it this diagonal.
struct Inverse {
    scaled: DMatrix<f64>,
    scale: Vec<f64>,
}

impl Inverse {
    /// Inverts a Hessian. Returns `None` if it is singular.
    fn new(hessian: &DMatrix<f64>) -> Option<Inverse> {
        let (scaled, scale) = to_unit_diagonal(hessian);
        Some(Inverse { scaled: scaled.try_inverse()?, scale })
    }

    /// Returns the inverse of the unscaled Hessian.
    fn matrix(&self) -> DMatrix<f64> {
        let (n, Inverse { scaled, scale }) = (self.scale.len(), self);
        DMatrix::from_fn(n, n, |i, j| scaled[(i, j)] / (scale[i] * scale[j]))
    }
}

/// Scales rows and columns of a Hessian by the square roots of its diagonal, so that parameters of all units are
/// comparable. Also returns these square roots.
fn to_unit_diagonal(hessian: &DMatrix<f64>) -> (DMatrix<f64>, Vec<f64>) {
    let n = hessian.nrows();
    let scale: Vec<f64> = (0..n).map(|i| hessian[(i, i)].sqrt().max(1e-150)).collect();
    (DMatrix::from_fn(n, n, |i, j| hessian[(i, j)] / (scale[i] * scale[j])), scale)
}

/// Computes the shift of each free parameter for a unit error of a considered parameter, which is not estimated.
///
/// A block contains derivatives of one test; `considered` contains the derivatives of its residuals with respect to the
/// considered parameter. The shift times the standard deviation of the considered parameter is the error that this
/// parameter adds to an estimate. The source is Bierman, Factorization Methods for Discrete Sequential Estimation,
/// 1977, VIII. Returns `None` if the Hessian is not positive definite.
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
    let (scaled, scale) = to_unit_diagonal(&hessian);
    let found = scaled.cholesky()?.solve(&DVector::from_fn(n, |i, _| right[i] / scale[i]));
    Some(DVector::from_fn(n, |i, _| found[i] / scale[i]))
}

/// Computes the number of samples that contain the information of one independent sample: the integrated
/// autocorrelation time of the residual, in samples.
///
/// The sum ends where the autocorrelation first falls below its standard error of noise, 2/√n for n samples (after
/// Geyer's initial positive sequence, Stat. Sci. 7, 1992).
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
    fn errors_that_groups_share_widen_a_mean_and_independent_ones_do_not() {
        // The estimate is the mean of 40 samples in 8 groups. The errors first are equal within each group, then
        // alternate from sample to sample.
        let rows = DMatrix::from_element(40, 1, 1.0);
        let groups = vec![(0..40).map(|k| k / 5).collect::<Vec<usize>>()];
        let deviation = |residual: Vec<f64>| {
            grouped_covariance(&[(rows.clone(), residual)], &[0.0], &groups).unwrap()[(0, 0)].sqrt()
        };
        let shared = deviation((0..40).map(|k| if k / 5 % 2 == 0 { 1.0 } else { -1.0 }).collect());
        assert!((shared - (8.0f64 * 25.0 * 8.0 / 7.0).sqrt() / 40.0).abs() < 1e-12, "{shared}");
        assert!(deviation((0..40).map(|k| if k % 2 == 0 { 1.0 } else { -1.0 }).collect()) < 0.3 * shared);
        let one = [vec![0; 40]];
        assert_eq!(grouped_covariance(&[(rows.clone(), vec![1.0; 40])], &[0.0], &one), None);
    }

    #[test]
    fn a_deviation_is_stretched_where_the_force_changes_less_than_its_tangent() {
        // The linearization is valid for a proportional force, and for a squared change of 0.3 times the linearized
        // one. The factor is then 1.
        assert_eq!(stretch(FLAT, &|factor| Some(factor * factor)), 1.0);
        assert_eq!(stretch(FLAT, &|factor| Some(0.3 * factor * factor)), 1.0);
        // The squared change is proportional to the factor, because a larger factor makes the force jump at more
        // samples.
        for slope in [1e-3, 0.02, 0.1] {
            assert!((stretch(FLAT, &|factor| Some(slope * factor)) * slope / FLAT - 1.0).abs() < 1e-9, "{slope}");
        }
        // A parameter without an effect gets the largest factor. A parameter that reaches its bound between factors 2
        // and 4 gets 4.
        assert_eq!(stretch(FLAT, &|_| Some(0.0)), FARTHEST);
        assert_eq!(stretch(FLAT, &|factor| (factor < 3.0).then_some(0.0)), 4.0);
    }

    #[test]
    fn samples_of_a_slow_residual_stand_for_few() {
        let slow: Vec<f64> = (0..400).map(|k| libm::sin(0.03 * f64::from(k))).collect();
        let noise: Vec<f64> =
            (0..400u32).map(|k| f64::from(k.wrapping_mul(2_654_435_761) >> 16) / 65_536.0 - 0.5).collect();
        assert!(correlation_factor(&noise) < 2.0 && correlation_factor(&slow) > 20.0);
    }
}
