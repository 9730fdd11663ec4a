//! Bounded, weighted, robust least squares: Levenberg–Marquardt on the segments of a fit.
//!
//! Marquardt's scaling (SIAM J. Appl. Math. 11, 1963) on the unknowns that are not held at a bound, Huber's loss by
//! reweighting (Ann. Math. Stat. 35, 1964). Segments are summed in their order, so the result does not depend on the
//! number of threads.

use super::cancel;
use super::priors::in_search;
use super::segment::Segment;
use super::sensitivity::{Accuracy, Run};
use super::unknowns::Unknowns;
use nalgebra::{DMatrix, DVector};
use rayon::prelude::*;

/// Weighted residual beyond which a sample counts linearly, not squared.
const HUBER: f64 = 3.0;

/// How hard to try.
#[derive(Debug, Clone, Copy)]
pub struct Effort {
    /// Most accepted or refused steps.
    pub steps: usize,
    /// Relative fall of the cost at which a fit has ended.
    pub tolerance: f64,
    /// How exactly the model is integrated.
    pub accuracy: Accuracy,
}

impl Effort {
    /// To compare variants.
    pub const ROUGH: Effort = Effort { steps: 8, tolerance: 1e-3, accuracy: Accuracy::Cheap };
    /// For the result.
    pub const FINE: Effort = Effort { steps: 60, tolerance: 1e-7, accuracy: Accuracy::Full };
}

/// Where a fit ended.
#[derive(Debug, Clone)]
pub struct Solution {
    /// The unknowns.
    pub theta: Vec<f64>,
    /// Half the sum of the losses.
    pub cost: f64,
    /// Whether it ended by itself.
    pub converged: bool,
}

/// Cost and normal equations at one point.
struct Normal {
    cost: f64,
    hessian: DMatrix<f64>,
    gradient: DVector<f64>,
}

/// Loss of one weighted residual and the weight it leaves on its square.
fn huber(r: f64) -> (f64, f64) {
    let size = r.abs();
    if size <= HUBER { (0.5 * r * r, 1.0) } else { (HUBER * (size - 0.5 * HUBER), HUBER / size) }
}

fn cost_of(segment: &Segment, forces: &[f64]) -> f64 {
    let scale = 1.0 / segment.scale;
    (segment.from..segment.force.len()).map(|i| huber((forces[i] - segment.force[i]) * scale).0).sum()
}

/// What leaving the usual costs, half the sum of squares, with its slope and curvature over each unknown.
fn prior(unknowns: &Unknowns, theta: &[f64]) -> (f64, Vec<(f64, f64)>) {
    let mut cost = 0.0;
    let each = unknowns.list.iter().zip(theta).map(|(unknown, value)| match in_search(unknown) {
        Some((mean, deviation)) => {
            let off = (value - mean) / deviation;
            cost += 0.5 * off * off;
            (off / deviation, 1.0 / (deviation * deviation))
        }
        None => (0.0, 0.0),
    });
    let each = each.collect();
    (cost, each)
}

/// Cost of a parameter vector; infinite where it makes no model or no finite force.
fn cost(segments: &[&Segment], unknowns: &Unknowns, theta: &[f64], accuracy: Accuracy, held: f64) -> f64 {
    let Some(run) = Run::new(unknowns, theta, accuracy) else { return f64::INFINITY };
    let costs: Vec<f64> = segments.par_iter().map(|s| cost_of(s, &run.forces(s))).collect();
    let sum: f64 = costs.iter().sum::<f64>() + held * prior(unknowns, theta).0;
    if sum.is_finite() { sum } else { f64::INFINITY }
}

fn normal(segments: &[&Segment], unknowns: &Unknowns, theta: &[f64], accuracy: Accuracy, held: f64) -> Option<Normal> {
    let run = Run::new(unknowns, theta, accuracy)?;
    let n = theta.len();
    let parts: Vec<Normal> = segments
        .par_iter()
        .map(|segment| {
            let (forces, rows) = run.jacobian(segment, unknowns, theta);
            let scale = 1.0 / segment.scale;
            let count = segment.force.len() - segment.from;
            let mut weighted = DMatrix::zeros(n, count);
            let mut residual = DVector::zeros(count);
            for k in 0..count {
                let i = segment.from + k;
                let r = (forces[i] - segment.force[i]) * scale;
                let w = huber(r).1.sqrt();
                residual[k] = r * w;
                weighted.set_column(k, &(rows.column(i) * (scale * w)));
            }
            Normal {
                cost: cost_of(segment, &forces),
                hessian: &weighted * weighted.transpose(),
                gradient: &weighted * residual,
            }
        })
        .collect();
    let mut sum = Normal { cost: 0.0, hessian: DMatrix::zeros(n, n), gradient: DVector::zeros(n) };
    for part in &parts {
        sum.cost += part.cost;
        sum.hessian += &part.hessian;
        sum.gradient += &part.gradient;
    }
    let (cost, each) = prior(unknowns, theta);
    sum.cost += held * cost;
    for (i, (slope, curvature)) in each.into_iter().enumerate() {
        sum.gradient[i] += held * slope;
        sum.hessian[(i, i)] += held * curvature;
    }
    sum.cost.is_finite().then_some(sum)
}

/// Independent samples of a test where what is left of it is no noise: the error of a model's form is alike all through a test.
const SAMPLES_OF_FORM: f64 = 2.0;

/// How much more what is usual weighs than beside samples that are all independent: once where noise is all that is left at the start, and
/// up to as many times as there are samples to an independent one where it is form.
fn held(segments: &[&Segment], unknowns: &Unknowns, theta: &[f64], accuracy: Accuracy) -> f64 {
    let count: usize = segments.iter().map(|s| s.force.len() - s.from).sum();
    let per_test = count as f64 / segments.len().max(1) as f64;
    let mean_square = 2.0 * cost(segments, unknowns, theta, accuracy, 0.0) / count.max(1) as f64;
    let of_form = if mean_square.is_finite() { (1.0 - 1.0 / mean_square.max(1.0)).max(0.0) } else { 0.0 };
    let independent = (per_test / SAMPLES_OF_FORM).max(1.0);
    (1.0 - of_form) + of_form * independent * mean_square.clamp(1.0, MOST_FORM)
}

/// Mean square, in units of what is allowed, beyond which a misfit says no more: the start was bad, not the form.
const MOST_FORM: f64 = 30.0;

/// Minimises from `start`.
pub fn solve(segments: &[&Segment], unknowns: &Unknowns, start: &[f64], effort: Effort) -> Solution {
    let (low, high) = unknowns.bounds();
    let n = start.len();
    let mut theta: Vec<f64> = (0..n).map(|i| start[i].clamp(low[i], high[i])).collect();
    let mut best = Solution { cost: f64::INFINITY, theta: theta.clone(), converged: false };
    if cancel::asked() {
        return best;
    }
    let held = held(segments, unknowns, &theta, effort.accuracy);
    let Some(mut at) = normal(segments, unknowns, &theta, effort.accuracy, held) else { return best };
    best.cost = at.cost;
    let mut damping = 1e-3;
    for _ in 0..effort.steps {
        if cancel::asked() {
            break;
        }
        let free: Vec<usize> = (0..n)
            .filter(|i| {
                let held =
                    (theta[*i] <= low[*i] && at.gradient[*i] > 0.0) || (theta[*i] >= high[*i] && at.gradient[*i] < 0.0);
                !held && at.hessian[(*i, *i)] > 0.0
            })
            .collect();
        if free.is_empty() {
            best.converged = true;
            break;
        }
        let diagonal: Vec<f64> = free.iter().map(|i| at.hessian[(*i, *i)]).collect();
        let matrix = DMatrix::from_fn(free.len(), free.len(), |a, b| {
            let scaled = at.hessian[(free[a], free[b])] / (diagonal[a] * diagonal[b]).sqrt();
            if a == b { 1.0 + damping } else { scaled }
        });
        let right = DVector::from_fn(free.len(), |a, _| -at.gradient[free[a]] / diagonal[a].sqrt());
        let Some(step) = matrix.cholesky().map(|c| c.solve(&right)) else {
            damping *= 10.0;
            continue;
        };
        let mut tried = theta.clone();
        for (a, i) in free.iter().enumerate() {
            tried[*i] = (theta[*i] + step[a] / diagonal[a].sqrt()).clamp(low[*i], high[*i]);
        }
        let tried_cost = cost(segments, unknowns, &tried, effort.accuracy, held);
        if tried_cost < at.cost {
            let fall = (at.cost - tried_cost) / at.cost.max(1e-300);
            theta = tried;
            damping = (damping * 0.2).max(1e-12);
            best = Solution { theta: theta.clone(), cost: tried_cost, converged: fall < effort.tolerance };
            if best.converged {
                break;
            }
            match normal(segments, unknowns, &theta, effort.accuracy, held) {
                Some(next) => at = next,
                None => break,
            }
        } else {
            // A step that no longer changes anything has arrived.
            let small = free.iter().all(|i| (tried[*i] - theta[*i]).abs() <= 1e-9 * (theta[*i].abs() + 1e-6));
            if small || damping > 1e8 {
                best.converged = true;
                break;
            }
            damping *= 5.0;
        }
    }
    // Costs of different fits are compared without what is usual, whose weight differs.
    if best.cost.is_finite() {
        best.cost = cost(segments, unknowns, &best.theta, effort.accuracy, 1.0);
    }
    best
}

/// Share of the full information that stays when a test is left out which alone determines a parameter: without it
/// the prediction of that test would be arbitrary.
const RIDGE: f64 = 1e-3;

/// Mean square of each test's weighted residual as predicted from all other tests: the refit without the test is
/// linearised about the common solution (exact for linear least squares; Cook & Weisberg, *Residuals and Influence in
/// Regression*, 1982), so one pass serves all tests.
pub fn left_out_errors(segments: &[&Segment], unknowns: &Unknowns, theta: &[f64]) -> Vec<f64> {
    let Some(run) = Run::new(unknowns, theta, Accuracy::Cheap) else { return vec![f64::INFINITY; segments.len()] };
    let parts: Vec<(DMatrix<f64>, DVector<f64>)> = segments
        .par_iter()
        .map(|segment| {
            let (forces, rows) = run.jacobian(segment, unknowns, theta);
            let count = segment.force.len() - segment.from;
            let rows = rows.columns(segment.from, count) / segment.scale;
            let residual = DVector::from_fn(count, |k, _| {
                (forces[segment.from + k] - segment.force[segment.from + k]) / segment.scale
            });
            (rows, residual)
        })
        .collect();
    let n = theta.len();
    let mut hessian = DMatrix::zeros(n, n);
    let own: Vec<DMatrix<f64>> = parts.par_iter().map(|(rows, _)| rows * rows.transpose()).collect();
    for part in &own {
        hessian += part;
    }
    parts
        .par_iter()
        .zip(&own)
        .map(|((rows, residual), own)| {
            let mut others = &hessian - own;
            for i in 0..n {
                others[(i, i)] += RIDGE * hessian[(i, i)] + 1e-300;
            }
            let moved = others.cholesky().map(|c| c.solve(&(rows * residual)));
            let predicted = match moved {
                Some(moved) => residual + rows.transpose() * moved,
                None => residual.clone(),
            };
            predicted.norm_squared() / predicted.len().max(1) as f64
        })
        .collect()
}

/// Covariance of the unknowns at a solution: the sandwich form, with the noise of every test taken from its own
/// residual and its samples discounted for their correlation, so that model error widens the intervals too.
///
/// Returns the covariance and, for each unknown, how well it is determined apart from all others (1: fully, 0: not).
pub fn covariance(
    segments: &[&Segment],
    unknowns: &Unknowns,
    theta: &[f64],
    accuracy: Accuracy,
) -> Option<(DMatrix<f64>, Vec<f64>)> {
    let run = Run::new(unknowns, theta, accuracy)?;
    let n = theta.len();
    let parts: Vec<(DMatrix<f64>, f64)> = segments
        .par_iter()
        .map(|segment| {
            let (forces, rows) = run.jacobian(segment, unknowns, theta);
            let count = segment.force.len() - segment.from;
            let residual: Vec<f64> =
                (segment.from..segment.force.len()).map(|i| (forces[i] - segment.force[i]) / segment.scale).collect();
            let variance = residual.iter().map(|r| r * r).sum::<f64>() / count.max(1) as f64;
            let scored = rows.columns(segment.from, count) / segment.scale;
            (&scored * scored.transpose(), variance * correlation_factor(&residual))
        })
        .collect();
    let mut hessian = DMatrix::zeros(n, n);
    let mut meat = DMatrix::zeros(n, n);
    for (part, variance) in &parts {
        hessian += part;
        meat += part * *variance;
    }
    let scale: Vec<f64> = (0..n).map(|i| hessian[(i, i)].sqrt().max(1e-150)).collect();
    let scaled = DMatrix::from_fn(n, n, |i, j| hessian[(i, j)] / (scale[i] * scale[j]));
    let eigen = scaled.symmetric_eigen();
    let largest = eigen.eigenvalues.amax();
    // Directions that the data does not see at all are cut off here and named by the caller.
    let inverse_values = eigen.eigenvalues.map(|v| if v > 1e-12 * largest { 1.0 / v } else { 1e12 / largest });
    let vectors = &eigen.eigenvectors;
    let inverse = vectors * DMatrix::from_diagonal(&inverse_values) * vectors.transpose();
    let determined = (0..n).map(|i| 1.0 / inverse[(i, i)].max(1.0)).collect();
    let bread = DMatrix::from_fn(n, n, |i, j| inverse[(i, j)] / (scale[i] * scale[j]));
    Some((&bread * meat * &bread, determined))
}

/// How many samples stand for one independent sample: the sum of the residual's autocorrelation up to where it first
/// falls below noise (Geyer's initial positive sequence, Stat. Sci. 7, 1992).
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
