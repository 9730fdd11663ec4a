//! Bounded, robust least squares for one explanation, with little more than one run of the model per step.
//!
//! To compare explanations the Jacobian is taken once and then kept up by Broyden's rank-one update (Math. Comp. 19, 1965),
//! since those that a diagnosis compares differ by two or three numbers from one whose Jacobian is known. The likely ones are
//! then refitted with a Jacobian of their own in every step. Steps are Marquardt's, the loss is Huber's.

use super::cancel;
use super::hypothesis::{Hypothesis, Residual};
use super::samples::Test;
use crate::sensitivity::Accuracy;
use nalgebra::{DMatrix, DVector, Dyn, Matrix, Storage};

/// Weighted residual beyond which a sample counts linearly.
pub const HUBER: f64 = 4.0;

/// How hard to try.
#[derive(Debug, Clone, Copy)]
pub struct Effort {
    /// Most steps.
    pub steps: usize,
    /// Relative fall of the cost at which it has ended.
    pub tolerance: f64,
    /// Whether the Jacobian is taken anew after every step that succeeds.
    pub renews: bool,
    /// How exactly it is taken.
    pub derivatives: Accuracy,
}

impl Effort {
    /// To see which explanations are worth more.
    pub const LOOK: Effort = Effort { steps: 4, tolerance: 2e-3, renews: false, derivatives: Accuracy::Cheap };
    /// To compare explanations.
    pub const COMPARE: Effort = Effort { steps: 10, tolerance: 2e-3, renews: false, derivatives: Accuracy::Cheap };
    /// To judge the likely ones.
    pub const JUDGE: Effort = Effort { steps: 8, tolerance: 1e-3, renews: true, derivatives: Accuracy::Single };
    /// For the result.
    pub const FINE: Effort = Effort { steps: 20, tolerance: 1e-4, renews: true, derivatives: Accuracy::Single };
}

/// Where a refit ended.
#[derive(Debug, Clone)]
pub struct Refit {
    /// The numbers.
    pub theta: Vec<f64>,
    /// Weighted residuals.
    pub residual: Residual,
    /// Derivatives of the computed forces, weighted; approximate where it was updated.
    pub jacobian: DMatrix<f64>,
    /// Sum of the losses, twice (a χ² where no sample is far off), samples discounted for their correlation.
    pub chi2: f64,
    /// The same with the cost of leaving the priors.
    pub cost: f64,
}

impl Refit {
    /// An explanation as it stands at `theta`.
    pub fn at(hypothesis: &Hypothesis, theta: Vec<f64>, residual: Residual, jacobian: DMatrix<f64>) -> Refit {
        let chi2 = chi2(&residual);
        let cost = chi2 + prior_cost(hypothesis, &theta);
        Refit { theta, residual, jacobian, chi2, cost }
    }
}

/// χ² of residuals under Huber's loss.
///
/// The allowed error of a sample is already that of correlated noise, so a sum over all samples counts each piece of
/// information once.
pub fn chi2(residual: &Residual) -> f64 {
    residual
        .iter()
        .map(|r| {
            let size = r.abs();
            if size <= HUBER { r * r } else { HUBER * (2.0 * size - HUBER) }
        })
        .sum()
}

/// What leaving the expected values costs.
pub fn prior_cost(hypothesis: &Hypothesis, theta: &[f64]) -> f64 {
    hypothesis
        .numbers
        .iter()
        .zip(theta)
        .filter_map(|(n, t)| n.prior.map(|(mean, deviation)| ((t - mean) / deviation).powi(2)))
        .sum()
}

/// Refits an explanation from `start`; with the Jacobian there if it is known. `None` where it makes no finite force.
pub fn refit(
    hypothesis: &Hypothesis,
    tests: &[Test],
    start: &[f64],
    jacobian: Option<DMatrix<f64>>,
    effort: Effort,
) -> Option<Refit> {
    refit_by(hypothesis, tests, start, jacobian, effort, &|theta| hypothesis.residual(tests, theta))
}

/// The same with residuals of one's choice.
pub fn refit_by(
    hypothesis: &Hypothesis,
    tests: &[Test],
    start: &[f64],
    jacobian: Option<DMatrix<f64>>,
    effort: Effort,
    residual_at: &dyn Fn(&[f64]) -> Option<Residual>,
) -> Option<Refit> {
    if cancel::asked() {
        return None;
    }
    let n = start.len();
    let bounds: Vec<(f64, f64)> = hypothesis.numbers.iter().map(|n| n.bounds).collect();
    let mut theta: Vec<f64> = start.iter().zip(&bounds).map(|(t, (low, high))| t.clamp(*low, *high)).collect();
    let mut residual = residual_at(&theta)?;
    let mut chi = chi2(&residual);
    let mut cost = chi + prior_cost(hypothesis, &theta);
    let mut fresh = jacobian.is_none();
    let mut jacobian = match jacobian {
        Some(known) => known,
        None => hypothesis.jacobian(effort.derivatives, tests, &theta)?,
    };
    let mut damping = 1e-3;
    let mut step_number = 0;
    while step_number < effort.steps && !cancel::asked() {
        step_number += 1;
        let (mut hessian, mut gradient) = normal(&jacobian, &residual);
        for (i, number) in hypothesis.numbers.iter().enumerate() {
            if let Some((mean, deviation)) = number.prior {
                hessian[(i, i)] += 1.0 / (deviation * deviation);
                gradient[i] -= (theta[i] - mean) / (deviation * deviation);
            }
        }
        let free: Vec<usize> = (0..n)
            .filter(|i| {
                let (low, high) = bounds[*i];
                let held = (theta[*i] <= low && gradient[*i] < 0.0) || (theta[*i] >= high && gradient[*i] > 0.0);
                !held && hessian[(*i, *i)] > 0.0
            })
            .collect();
        if free.is_empty() {
            break;
        }
        let root: Vec<f64> = free.iter().map(|i| hessian[(*i, *i)].sqrt()).collect();
        let matrix = DMatrix::from_fn(free.len(), free.len(), |a, b| {
            if a == b { 1.0 + damping } else { hessian[(free[a], free[b])] / (root[a] * root[b]) }
        });
        let right = DVector::from_fn(free.len(), |a, _| gradient[free[a]] / root[a]);
        let Some(step) = matrix.cholesky().map(|c| c.solve(&right)) else {
            damping *= 10.0;
            continue;
        };
        let mut tried = theta.clone();
        for (a, i) in free.iter().enumerate() {
            let (low, high) = bounds[*i];
            tried[*i] = (theta[*i] + step[a] / root[a]).clamp(low, high);
        }
        let found = residual_at(&tried);
        let moved = DVector::from_fn(n, |i, _| (tried[i] - theta[i]) / hypothesis.numbers[i].step);
        if let Some(there) = &found {
            // Broyden's update, in units of typical steps: the Jacobian agrees with what was just seen.
            let length = moved.norm_squared();
            if length > 0.0 {
                let change = &residual - there;
                let mut missed = change;
                for i in 0..n {
                    missed.axpy(-(tried[i] - theta[i]), &jacobian.column(i), 1.0);
                }
                for i in 0..n {
                    let share = moved[i] / (length * hypothesis.numbers[i].step);
                    if share != 0.0 {
                        jacobian.column_mut(i).axpy(share, &missed, 1.0);
                    }
                }
            }
        }
        let tried_cost = found.as_ref().map_or(f64::INFINITY, |r| chi2(r) + prior_cost(hypothesis, &tried));
        if tried_cost < cost {
            let fall = (cost - tried_cost) / cost.max(1e-300);
            theta = tried;
            residual = found?;
            chi = chi2(&residual);
            cost = tried_cost;
            damping = (damping * 0.2).max(1e-9);
            // A known Jacobian may be stale: calm counts once it was taken here.
            if fall < effort.tolerance && (fresh || !effort.renews) {
                break;
            }
            if effort.renews {
                jacobian = hypothesis.jacobian(effort.derivatives, tests, &theta)?;
                fresh = true;
            }
        } else {
            if moved.norm() < 1e-7 {
                break;
            }
            if !fresh && damping > 1e-2 && effort.renews {
                jacobian = hypothesis.jacobian(effort.derivatives, tests, &theta)?;
                fresh = true;
                damping = 1e-3;
                continue;
            }
            damping *= 6.0;
            if damping > 1e5 {
                break;
            }
        }
    }
    Some(Refit { theta, residual, jacobian, chi2: chi, cost })
}

/// Products of all columns of a matrix with each other.
pub fn gram<S: Storage<f64, Dyn, Dyn>>(columns: &Matrix<f64, Dyn, Dyn, S>) -> DMatrix<f64> {
    // A product of matrices is computed in blocks; `tr_mul` goes by columns and takes several times as long.
    columns.transpose() * columns
}

/// Square roots of Huber's weights.
pub fn weights(residual: &Residual) -> Vec<f64> {
    residual.iter().map(|r| if r.abs() <= HUBER { 1.0 } else { (HUBER / r.abs()).sqrt() }).collect()
}

/// Normal equations under Huber's weights.
fn normal(jacobian: &DMatrix<f64>, residual: &Residual) -> (DMatrix<f64>, DVector<f64>) {
    let weights = weights(residual);
    let mut weighted = jacobian.clone();
    for mut column in weighted.column_iter_mut() {
        for (value, w) in column.iter_mut().zip(&weights) {
            *value *= w;
        }
    }
    let right = DVector::from_fn(residual.len(), |i, _| residual[i] * weights[i]);
    (gram(&weighted), weighted.tr_mul(&right))
}
