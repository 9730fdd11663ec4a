//! Bounded, robust, nonlinear least squares for any residuals. It is the only Levenberg–Marquardt solver of the
//! project.
//!
//! - Marquardt's scaling by the columns of the Jacobian (SIAM J. Appl. Math. 11, 1963) and Nielsen's damping, which
//!   depends on the ratio of the actual to the predicted reduction (IMM-REP-1999-05, 1999).
//! - A step may account for the curvature of the residuals by one more evaluation (geodesic acceleration, Transtrum &
//!   Sethna, arXiv:1201.5885, 2012). Narrow curved valleys, common for friction with a steep curve, then require tens
//!   of steps instead of thousands.
//! - If a Jacobian costs many model runs and only a ranking of hypotheses is required, Broyden's rank-one update (Math.
//!   Comp. 19, 1965) replaces its computation. Columns of zeros remain zero (Schubert, Math. Comp. 24, 1970).
//! - The residuals are grouped in blocks, for example one for each test. The rows of each block are reduced to a
//!   triangular factor (see [`reduce()`]) and stacked in their order. Therefore, a result does not depend on the number
//!   of threads.
//! - Bounds apply by projection. If a parameter is at a bound and its descent direction points outward, it is fixed for
//!   that step.
//! - Huber's loss uses reweighting (Ann. Math. Stat. 35, 1964). Gaussian priors are further rows.
//! - A fit has converged when a full linear step would reduce the cost by less than a relative tolerance (Bates &
//!   Watts, Technometrics 23, 1981). The length of a damped step is no criterion, because damping alone makes it short.

mod differences;
mod reduce;
// `rustfmt` must not reformat the data tables of this module.
#[cfg(test)]
#[rustfmt::skip]
mod nist;

use super::cancel;
use dashpot_records::restrict;
use nalgebra::{DMatrix, DVector};
use rayon::prelude::*;
use reduce::reduce;

/// A least-squares problem: weighted residuals in one or more blocks. A residual is model minus measurement, divided by
/// the error.
pub trait Residuals: Sync {
    /// Data that all blocks share for one parameter vector, for example a model or the parameters themselves.
    type At: Sync;

    /// Prepares the shared data, or returns `None` if the parameters are not a valid model.
    fn prepare(&self, x: &[f64]) -> Option<Self::At>;

    /// Returns the number of blocks. With one block for each test, tests are computed in parallel.
    fn blocks(&self) -> usize {
        1
    }

    /// Returns whether the residuals of a block come from measurements, which may contain outliers. The [`Loss`] of the
    /// options applies only to such blocks. The loss of any other block is half the sum of its squares.
    fn is_measured(&self, _block: usize) -> bool {
        true
    }

    /// Computes the weighted residuals of one block, or returns `None` if the parameters are not a valid model.
    fn residuals(&self, block: usize, at: &Self::At) -> Option<Vec<f64>>;

    /// Computes the derivatives of one block's residuals, one column for each parameter. If the result is `None`, the
    /// solver uses central differences.
    fn jacobian(&self, _block: usize, _at: &Self::At) -> Option<DMatrix<f64>> {
        None
    }
}

/// Object-safe form of [`Residuals`], so that the search is compiled only once for all types.
trait Problem: Sync {
    fn prepare(&self, x: &[f64]) -> Option<Box<dyn Point + '_>>;
    fn blocks(&self) -> usize;
    fn is_measured(&self, block: usize) -> bool;
}

/// Residuals and derivatives of a [`Problem`] at one point.
trait Point: Sync {
    fn residuals(&self, block: usize) -> Option<Vec<f64>>;
    fn jacobian(&self, block: usize) -> Option<DMatrix<f64>>;
}

impl<R: Residuals> Problem for R {
    fn prepare(&self, x: &[f64]) -> Option<Box<dyn Point + '_>> {
        let at = Residuals::prepare(self, x)?;
        Some(Box::new(There { problem: self, at }))
    }

    fn blocks(&self) -> usize {
        Residuals::blocks(self)
    }

    fn is_measured(&self, block: usize) -> bool {
        Residuals::is_measured(self, block)
    }
}

struct There<'a, R: Residuals> {
    problem: &'a R,
    at: R::At,
}

impl<R: Residuals> Point for There<'_, R> {
    fn residuals(&self, block: usize) -> Option<Vec<f64>> {
        self.problem.residuals(block, &self.at)
    }

    fn jacobian(&self, block: usize) -> Option<DMatrix<f64>> {
        self.problem.jacobian(block, &self.at)
    }
}

/// Bounds of every parameter.
#[derive(Debug, Clone, PartialEq)]
pub struct Bounds {
    /// Lowest value of each parameter.
    pub low: Vec<f64>,
    /// Highest value of each parameter.
    pub high: Vec<f64>,
}

impl Bounds {
    /// Returns infinite bounds for `n` parameters.
    pub fn none(n: usize) -> Self {
        Self { low: vec![f64::NEG_INFINITY; n], high: vec![f64::INFINITY; n] }
    }

    fn inside(&self, x: &[f64]) -> Vec<f64> {
        x.iter().enumerate().map(|(i, x)| restrict(*x, self.low[i], self.high[i])).collect()
    }
}

/// Gaussian prior of a parameter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Prior {
    /// Mean of the prior.
    pub mean: f64,
    /// Standard deviation of the prior, in the unit of the parameter.
    pub spread: f64,
}

/// Loss function of a weighted residual.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Loss {
    /// Half the square of the residual.
    Squares,
    /// Half the square of the residual up to the given size, linear beyond it. Limits the influence of outliers.
    Huber(f64),
}

impl Loss {
    /// Computes the cost of one residual, and its weight in iteratively reweighted least squares.
    pub fn evaluate(self, r: f64) -> (f64, f64) {
        match self {
            Loss::Huber(knee) if r.abs() > knee => (knee * (r.abs() - 0.5 * knee), knee / r.abs()),
            _ => (0.5 * r * r, 1.0),
        }
    }
}

/// Source of the derivatives of a step.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Derivatives {
    /// Computed after every accepted step. Steps account for the curvature (geodesic acceleration).
    Accelerated,
    /// Computed after every accepted step.
    Fresh,
    /// Computed once, then updated by Broyden's formula after every step, including rejected steps.
    Kept,
}

/// Options of the solver.
#[derive(Debug, Clone, PartialEq)]
pub struct Options {
    /// Largest number of steps, including rejected steps.
    pub steps: usize,
    /// Relative decrease of the cost by a further step below which the search has converged.
    pub tolerance: f64,
    /// Loss of a residual.
    pub loss: Loss,
    /// Priors of the parameters: empty, or one entry for each parameter.
    pub priors: Vec<Option<Prior>>,
    /// Source of the derivatives.
    pub derivatives: Derivatives,
    /// Levenberg–Marquardt damping of the first step, for columns scaled to length 1. It is 1 for an arbitrary start,
    /// and small for a good start.
    pub damping: f64,
    /// Number of successive accepted steps with a relative gain of at most the tolerance after which a search ends.
    ///
    /// Without this criterion, a search may not converge if the data do not determine a direction. In such a direction,
    /// the linear step predicts gains that do not occur.
    pub quiet: usize,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            steps: 200,
            tolerance: 1e-8,
            loss: Loss::Squares,
            priors: Vec::new(),
            derivatives: Derivatives::Accelerated,
            damping: 1.0,
            quiet: 4,
        }
    }
}

/// Residuals and derivatives of one block, without the weights of the loss.
#[derive(Debug, Clone, PartialEq)]
pub struct Rows {
    /// Residuals.
    pub residual: DVector<f64>,
    /// Derivatives of the residuals.
    pub jacobian: DMatrix<f64>,
}

/// Result of a search.
#[derive(Debug, Clone, PartialEq)]
pub struct Solution {
    /// Parameters at the lowest cost that the search found.
    pub x: Vec<f64>,
    /// Sum of the losses and of half the squares of the priors. Infinite if the start is not a valid model, or if the
    /// work was canceled before the first step.
    pub cost: f64,
    /// Whether the search converged within the largest number of steps.
    pub converged: bool,
    /// Number of trial steps.
    pub steps: usize,
    /// Residuals at the solution, by block, with the last known derivatives. The derivatives may belong to the previous
    /// point or be updated by Broyden's formula.
    pub rows: Vec<Rows>,
}

/// Linear least-squares problem at one point, reduced to at most one row for each parameter.
struct Linear {
    /// Triangular factor of the weighted Jacobian.
    factor: DMatrix<f64>,
    /// Weighted residuals, rotated with the rows of the factor.
    right: DVector<f64>,
}

/// Problem, bounds and options of a search.
struct Search<'a> {
    problem: &'a dyn Problem,
    bounds: &'a Bounds,
    options: &'a Options,
}

impl Search<'_> {
    /// Returns the rows of the priors: parameter index, weight, residual.
    fn prior_rows(&self, x: &[f64]) -> Vec<(usize, f64, f64)> {
        let row = |(i, prior): (usize, &Option<Prior>)| prior.map(|p| (i, 1.0 / p.spread, (x[i] - p.mean) / p.spread));
        self.options.priors.iter().enumerate().filter_map(row).collect()
    }

    fn loss(&self, block: usize) -> Loss {
        if self.problem.is_measured(block) { self.options.loss } else { Loss::Squares }
    }

    /// Computes the cost of residuals and of the priors at `x`. It is infinite if a residual is not finite.
    fn cost<'r>(&self, x: &[f64], residuals: impl IntoIterator<Item = &'r DVector<f64>>) -> f64 {
        let priors = self.prior_rows(x).iter().map(|(.., r)| 0.5 * r * r).sum::<f64>();
        let of = |(block, residual): (usize, &DVector<f64>)| {
            let loss = self.loss(block);
            residual.iter().map(|r| loss.evaluate(*r).0).sum::<f64>()
        };
        let each = residuals.into_iter().enumerate().map(of);
        let sum = each.sum::<f64>() + priors;
        if sum.is_finite() { sum } else { f64::INFINITY }
    }

    fn residuals(&self, at: &dyn Point) -> Option<Vec<DVector<f64>>> {
        let of = |block| at.residuals(block).map(DVector::from_vec);
        let all: Vec<Option<_>> = (0..self.problem.blocks()).into_par_iter().map(of).collect();
        all.into_iter().collect()
    }

    /// Computes the residuals of all blocks at `x`, and their derivatives unless `jacobian` contains them. Returns
    /// `None` if residuals or derivatives are missing or not finite.
    fn first_rows(&self, x: &[f64], jacobian: Option<Vec<DMatrix<f64>>>) -> Option<Vec<Rows>> {
        let at = self.problem.prepare(x)?;
        let residuals = self.residuals(&*at)?;
        let jacobians = match jacobian {
            Some(known) => known,
            None => self.jacobians(&*at, x, &residuals.iter().collect::<Vec<_>>())?,
        };
        let join = |(residual, jacobian)| Rows { residual, jacobian };
        Some(residuals.into_iter().zip(jacobians).map(join).collect())
    }

    /// Computes the derivatives of known residuals. Returns `None` if a residual or a derivative is missing or not finite.
    fn jacobians(&self, at: &dyn Point, x: &[f64], residuals: &[&DVector<f64>]) -> Option<Vec<DMatrix<f64>>> {
        let of = |(block, residual): (usize, &&DVector<f64>)| {
            let jacobian = match at.jacobian(block) {
                Some(exact) => exact,
                None => differences::central((self.problem, block), (x, residual.as_slice()), self.bounds)?,
            };
            residual.iter().chain(jacobian.iter()).all(|v| v.is_finite()).then_some(jacobian)
        };
        let all: Vec<Option<_>> = residuals.par_iter().enumerate().map(of).collect();
        all.into_iter().collect()
    }

    /// Computes the square roots of the weights of a block's residuals under the loss. Returns `None` if all are 1.
    fn weights(&self, block: usize, residual: &DVector<f64>) -> Option<DVector<f64>> {
        let loss @ Loss::Huber(_) = self.loss(block) else { return None };
        let roots = residual.map(|r| loss.evaluate(r).1.sqrt());
        roots.iter().any(|w| *w < 1.0).then_some(roots)
    }

    fn linear(&self, x: &[f64], rows: &[Rows]) -> Linear {
        let n = x.len();
        let parts: Vec<(DMatrix<f64>, DVector<f64>)> = rows
            .par_iter()
            .enumerate()
            .map(|(place, block)| match self.weights(place, &block.residual) {
                None => reduce(&block.jacobian, &block.residual),
                Some(weights) => {
                    let mut jacobian = block.jacobian.clone();
                    for mut column in jacobian.column_iter_mut() {
                        column.component_mul_assign(&weights);
                    }
                    reduce(&jacobian, &block.residual.component_mul(&weights))
                }
            })
            .collect();
        let priors = self.prior_rows(x);
        let count = parts.iter().map(|p| p.0.nrows()).sum::<usize>() + priors.len();
        let (mut factor, mut right) = (DMatrix::zeros(count, n), DVector::zeros(count));
        let mut row = 0;
        for (part, residual) in &parts {
            factor.view_mut((row, 0), part.shape()).copy_from(part);
            right.rows_mut(row, part.nrows()).copy_from(residual);
            row += part.nrows();
        }
        for (i, weight, residual) in priors {
            factor[(row, i)] = weight;
            right[row] = residual;
            row += 1;
        }
        let (factor, right) = reduce(&factor, &right);
        Linear { factor, right }
    }

    /// Computes the gradient due to the curvature of the residuals along a step: the product of the transposed Jacobian
    /// and half the second directional derivative. The second derivative comes from one further evaluation. Returns
    /// `None` if the evaluated point is outside the bounds or not a valid model, or if the gradient is not finite.
    fn bend(&self, x: &[f64], rows: &[Rows], step: &DVector<f64>) -> Option<DVector<f64>> {
        let probe: Vec<f64> = x.iter().zip(step.iter()).map(|(x, s)| x + PROBE * s).collect();
        if self.bounds.inside(&probe) != probe {
            return None;
        }
        let ahead = self.residuals(&*self.problem.prepare(&probe)?)?;
        let parts: Vec<DVector<f64>> = rows
            .par_iter()
            .zip(&ahead)
            .enumerate()
            .map(|(place, (block, ahead))| {
                let straight = &block.jacobian * step;
                let mut bend = ((ahead - &block.residual) / PROBE - straight) / PROBE;
                if let Some(weights) = self.weights(place, &block.residual) {
                    bend.component_mul_assign(&weights);
                    bend.component_mul_assign(&weights);
                }
                block.jacobian.tr_mul(&bend)
            })
            .collect();
        let sum = parts.into_iter().reduce(|a, b| a + b)?;
        sum.iter().all(|v| v.is_finite()).then_some(sum)
    }
}

/// Smallest ratio of a stored length of a Jacobian column to its previous value. The value 1 is Moré's rule (Lect.
/// Notes Math. 630, 1978), and 0 is Marquardt's rule.
const FADE: f64 = 0.5;
/// Smallest damping of a search. With this damping, a step differs from the full linear step only by rounding.
const LEAST_DAMPING: f64 = 1e-16;
/// Fraction of a step at which the curvature of the residuals is evaluated.
const PROBE: f64 = 0.1;
/// Largest ratio of the correction for curvature to the step. A larger correction is ignored, because the residuals are
/// then not parabolic along the step.
const MOST_BEND: f64 = 0.5;
/// Relative rounding error of the cost, which is a sum.
const ROUNDING: f64 = 1e-15;

/// Minimizes the cost from `start`, which is first clamped to the bounds.
pub fn solve<R: Residuals>(problem: &R, start: &[f64], bounds: &Bounds, options: &Options) -> Solution {
    solve_knowing(problem, start, None, bounds, options)
}

/// Minimizes the cost from `start`. The derivatives at the start may be known, one matrix for each block.
pub fn solve_knowing<R: Residuals>(
    problem: &R,
    start: &[f64],
    jacobian: Option<Vec<DMatrix<f64>>>,
    bounds: &Bounds,
    options: &Options,
) -> Solution {
    search(problem, start, jacobian, bounds, options)
}

/// Point that a search has reached, with the linear problem there.
struct Iterate {
    x: Vec<f64>,
    cost: f64,
    rows: Vec<Rows>,
    linear: Linear,
    /// Lengths of the columns of the Jacobian, which scale a step.
    ///
    /// If a parameter loses its influence, its column becomes short. If the column alone scaled the step, the step would
    /// be very long and end in a flat region. Therefore, the stored lengths decrease slowly.
    lengths: Vec<f64>,
    damping: f64,
    /// Factor on the damping after the next rejected step.
    growth: f64,
    /// Number of accepted steps in succession that reduced the cost by no more than the tolerance.
    quiet: usize,
}

/// Evaluated step of a search.
struct Step {
    /// Full linear step within the bounds, without the correction for curvature.
    straight: DVector<f64>,
    to: Vec<f64>,
    /// Reduction of the cost that the linear problem predicts.
    predicted: f64,
    /// Cost at the end of the step. It is infinite where the residuals are not finite.
    cost: f64,
}

impl Iterate {
    fn update_lengths(&mut self) {
        for (length, column) in self.lengths.iter_mut().zip(self.linear.factor.column_iter()) {
            *length = (FADE * *length).max(column.norm());
        }
    }

    /// Returns the length of a step in the scale of the columns.
    fn scaled_length(&self, step: &[f64]) -> f64 {
        step.iter().zip(&self.lengths).map(|(v, l)| (v * l).powi(2)).sum::<f64>().sqrt()
    }

    /// Returns the point at the end of a step, clamped to the bounds.
    fn inside(&self, step: &DVector<f64>, bounds: &Bounds) -> Vec<f64> {
        bounds.inside(&self.x.iter().zip(step).map(|(x, step)| x + step).collect::<Vec<_>>())
    }

    fn difference(&self, to: &[f64]) -> DVector<f64> {
        DVector::from_fn(self.x.len(), |i, _| to[i] - self.x[i])
    }

    /// Returns whether a step can change neither the cost nor the point beyond rounding.
    fn is_nothing(&self, step: &Step) -> bool {
        let size = |v: &[f64]| v.iter().map(|a| a * a).sum::<f64>().sqrt();
        step.predicted.abs() <= ROUNDING * self.cost || step.straight.norm() <= ROUNDING * size(&self.x)
    }

    /// Moves to the end of a step that reduces the cost.
    fn accept(&mut self, step: Step, residuals: Vec<DVector<f64>>, tolerance: f64) {
        let reduction = self.cost - step.cost;
        let ratio = if step.predicted > 0.0 { reduction / step.predicted } else { 0.0 };
        self.damping = (self.damping * (1.0 - (2.0 * ratio - 1.0).powi(3)).clamp(FASTEST, 2.0)).max(LEAST_DAMPING);
        self.growth = 2.0;
        self.quiet = if reduction <= tolerance * self.cost { self.quiet + 1 } else { 0 };
        (self.x, self.cost) = (step.to, step.cost);
        for (rows, residual) in self.rows.iter_mut().zip(residuals) {
            rows.residual = residual;
        }
    }

    /// Increases the damping after a step that does not reduce the cost.
    fn reject(&mut self) {
        self.damping = (self.damping * self.growth).max(LEAST_DAMPING);
        self.growth *= 2.0;
    }
}

fn search(
    problem: &dyn Problem,
    start: &[f64],
    jacobian: Option<Vec<DMatrix<f64>>>,
    bounds: &Bounds,
    options: &Options,
) -> Solution {
    let search = Search { problem, bounds, options };
    let x = bounds.inside(start);
    let mut end = Solution { x: x.clone(), cost: f64::INFINITY, converged: false, steps: 0, rows: Vec::new() };
    if cancel::asked() {
        return end;
    }
    let Some(mut now) = search.begin(x, jacobian) else { return end };
    // `moved_on`: whether a step was accepted since the column lengths were last updated. `first`: whether no step was
    // evaluated yet, because every step so far was longer than the parameter vector.
    let (mut moved_on, mut first) = (true, true);
    while end.steps < options.steps && now.cost.is_finite() && !cancel::asked() {
        if std::mem::take(&mut moved_on) {
            now.update_lengths();
        }
        let system = System::new(&now.linear, &now.x, bounds, &now.lengths);
        let arrived = system.left <= options.tolerance * now.cost;
        if arrived {
            end.converged = true;
            // The criterion applies to the point before the step, so one further step without damping is tried.
            now.damping = LEAST_DAMPING;
        }
        if system.free.is_empty() {
            end.converged = true;
            break;
        }
        end.steps += 1;
        let (step, triangle) = system.step(now.damping);
        let to = now.inside(&step, bounds);
        let straight = now.difference(&to);
        if first && !arrived {
            let reach = now.scaled_length(&now.x);
            if reach > 0.0 && now.scaled_length(straight.as_slice()) > reach {
                now.damping *= 4.0;
                continue;
            }
            first = false;
        }
        let to = search.bent_end(&now, &system, (&step, &triangle)).unwrap_or(to);
        let Linear { factor, right } = &now.linear;
        let predicted = 0.5 * (right.norm_squared() - (right + factor * &straight).norm_squared());
        let there = problem.prepare(&to).and_then(|at| search.residuals(&*at).map(|residuals| (at, residuals)));
        let cost = there.as_ref().map_or(f64::INFINITY, |(_, residuals)| search.cost(&to, residuals));
        let step = Step { straight, to, predicted, cost };
        if let (Derivatives::Kept, Some((_, residuals))) = (options.derivatives, &there) {
            let moved = now.difference(&step.to);
            keep_up(&mut now.rows, residuals, &moved, &now.lengths);
        }
        match there.filter(|_| step.cost < now.cost) {
            Some((at, residuals)) => {
                now.accept(step, residuals, options.tolerance);
                moved_on = true;
                if arrived || now.cost == 0.0 || now.quiet >= options.quiet {
                    end.converged = true;
                    break;
                }
                if search.renew(&mut now, &*at).is_none() {
                    break;
                }
            }
            None if arrived || now.is_nothing(&step) => {
                // No further reduction beyond the tolerance or beyond rounding is possible.
                end.converged = true;
                break;
            }
            None => {
                now.reject();
                if options.derivatives == Derivatives::Kept {
                    // The updated derivatives contain the information of the rejected step, so the linear problem
                    // changes.
                    now.linear = search.linear(&now.x, &now.rows);
                }
            }
        }
    }
    (end.x, end.cost, end.rows) = (now.x, now.cost, now.rows);
    end
}

impl Search<'_> {
    /// Evaluates the start. Returns `None` if residuals or derivatives are missing or not finite there.
    fn begin(&self, x: Vec<f64>, jacobian: Option<Vec<DMatrix<f64>>>) -> Option<Iterate> {
        let rows = self.first_rows(&x, jacobian)?;
        let cost = self.cost(&x, rows.iter().map(|r| &r.residual));
        let linear = self.linear(&x, &rows);
        let lengths = vec![0.0f64; x.len()];
        Some(Iterate { x, cost, rows, linear, lengths, damping: self.options.damping, growth: 2.0, quiet: 0 })
    }

    /// Returns the end of a step that is corrected for the curvature of the residuals.
    ///
    /// Returns `None` if the options do not ask for the correction, if it cannot be computed, or if it is large. `step`
    /// is the linear step with the triangular factor of its system.
    fn bent_end(
        &self,
        now: &Iterate,
        system: &System,
        (step, triangle): (&DVector<f64>, &DMatrix<f64>),
    ) -> Option<Vec<f64>> {
        if self.options.derivatives != Derivatives::Accelerated {
            return None;
        }
        let bend = self.bend(&now.x, &now.rows, step)?;
        let correction = system.against(&bend, triangle)?;
        let is_small = now.scaled_length(correction.as_slice()) <= MOST_BEND * now.scaled_length(step.as_slice());
        is_small.then(|| now.inside(&(step + correction), self.bounds))
    }

    /// Computes the derivatives and the linear problem after an accepted step. Returns `None` if they are not finite. The
    /// derivatives of the previous point then stay.
    fn renew(&self, now: &mut Iterate, at: &dyn Point) -> Option<()> {
        if self.options.derivatives != Derivatives::Kept {
            let residuals: Vec<&DVector<f64>> = now.rows.iter().map(|rows| &rows.residual).collect();
            let jacobians = self.jacobians(at, &now.x, &residuals)?;
            for (rows, jacobian) in now.rows.iter_mut().zip(jacobians) {
                rows.jacobian = jacobian;
            }
        }
        now.linear = self.linear(&now.x, &now.rows);
        Some(())
    }
}

/// Smallest factor by which an accepted step changes the damping. It applies if the actual reduction of the cost is
/// close to the predicted one, or larger.
const FASTEST: f64 = 1.0 / 3.0;

/// The linear problem in the parameters without an active bound, with columns scaled to length 1.
struct System<'a> {
    right: &'a DVector<f64>,
    free: Vec<usize>,
    scaled: DMatrix<f64>,
    lengths: &'a [f64],
    /// Reduction of the cost by a full linear step.
    left: f64,
}

impl<'a> System<'a> {
    fn new(linear: &'a Linear, x: &[f64], bounds: &Bounds, lengths: &'a [f64]) -> Self {
        let gradient = linear.factor.tr_mul(&linear.right);
        let free: Vec<usize> = (0..x.len())
            .filter(|i| {
                let outwards =
                    (x[*i] <= bounds.low[*i] && gradient[*i] > 0.0) || (x[*i] >= bounds.high[*i] && gradient[*i] < 0.0);
                !outwards && lengths[*i] > 0.0
            })
            .collect();
        let (rows, k) = (linear.factor.nrows(), free.len());
        let scaled = DMatrix::from_fn(rows, k, |r, c| linear.factor[(r, free[c])] / lengths[free[c]]);
        let mut rotated = linear.right.clone();
        scaled.clone().qr().q_tr_mul(&mut rotated);
        let left = 0.5 * rotated.rows(0, k.min(rows)).norm_squared();
        Self { right: &linear.right, free, scaled, lengths, left }
    }

    /// Expands a scaled step of the free parameters to all parameters.
    fn spread(&self, step: &DVector<f64>) -> DVector<f64> {
        let mut all = DVector::zeros(self.lengths.len());
        for (c, i) in self.free.iter().enumerate() {
            all[*i] = step[c] / self.lengths[*i];
        }
        all
    }

    /// Computes the damped step, and the triangular factor of its linear system.
    fn step(&self, damping: f64) -> (DVector<f64>, DMatrix<f64>) {
        let (rows, k) = self.scaled.shape();
        let stacked = DMatrix::from_fn(rows + k, k, |r, c| {
            if r < rows {
                self.scaled[(r, c)]
            } else if r - rows == c {
                damping.sqrt()
            } else {
                0.0
            }
        });
        let qr = stacked.qr();
        let mut right = DVector::zeros(rows + k);
        right.rows_mut(0, rows).copy_from(&-self.right);
        qr.q_tr_mul(&mut right);
        let triangle = qr.r();
        let solved = triangle.solve_upper_triangular(&right.rows(0, k).into_owned());
        (solved.map_or_else(|| DVector::zeros(self.lengths.len()), |step| self.spread(&step)), triangle)
    }

    /// Computes the correction of a step that cancels a gradient. Returns `None` if the linear system is singular.
    fn against(&self, gradient: &DVector<f64>, triangle: &DMatrix<f64>) -> Option<DVector<f64>> {
        let scaled = DVector::from_fn(self.free.len(), |c, _| -gradient[self.free[c]] / self.lengths[self.free[c]]);
        let half = triangle.tr_solve_upper_triangular(&scaled)?;
        triangle.solve_upper_triangular(&half).map(|c| self.spread(&c))
    }
}

/// Applies Broyden's update: afterward, the derivatives predict exactly the residuals after the last step. The change
/// is the smallest possible if every parameter is scaled by its column length. A parameter whose column in a block is
/// zero does not influence this block, so the column remains zero.
fn keep_up(rows: &mut [Rows], there: &[DVector<f64>], moved: &DVector<f64>, lengths: &[f64]) {
    for (block, there) in rows.iter_mut().zip(there) {
        let is_zero = |i: usize| block.jacobian.column(i).iter().all(|v| *v == 0.0);
        let share = |i: usize| if is_zero(i) { 0.0 } else { moved[i] * lengths[i] * lengths[i] };
        let shares = DVector::from_fn(moved.len(), |i, _| share(i));
        let size = shares.dot(moved);
        if size <= 0.0 {
            continue;
        }
        let missed = there - &block.residual - &block.jacobian * moved;
        if missed.iter().all(|v| v.is_finite()) {
            block.jacobian.ger(1.0 / size, &missed, &shares, 1.0);
        }
    }
}

/// Minimizes the cost from every start and returns the solution with the lowest cost. Of equal solutions, returns the
/// first. Returns `None` if there are no starts.
pub fn solve_from<R: Residuals>(
    problem: &R,
    starts: &[Vec<f64>],
    bounds: &Bounds,
    options: &Options,
) -> Option<Solution> {
    ends_from(problem, starts, bounds, options)
        .into_iter()
        .reduce(|best, next| if next.cost < best.cost { next } else { best })
}

fn ends_from(problem: &dyn Problem, starts: &[Vec<f64>], bounds: &Bounds, options: &Options) -> Vec<Solution> {
    starts.par_iter().map(|start| search(problem, start, None, bounds, options)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Least-squares problem whose residuals are given as a closure.
    struct Of<F>(F);

    impl<F: Fn(&[f64]) -> Vec<f64> + Sync> Residuals for Of<F> {
        type At = Vec<f64>;
        fn prepare(&self, x: &[f64]) -> Option<Vec<f64>> {
            Some(x.to_vec())
        }
        fn residuals(&self, _: usize, x: &Vec<f64>) -> Option<Vec<f64>> {
            Some((self.0)(x))
        }
    }

    fn near(got: &[f64], wanted: &[f64], by: f64) {
        for (a, b) in got.iter().zip(wanted) {
            assert!((a - b).abs() <= by, "{got:?} is not {wanted:?}");
        }
    }

    #[test]
    fn a_line_is_found_in_one_step() {
        let line = Of(|x: &[f64]| [0.0f64, 1.0, 2.0, 3.0].iter().map(|t| x[0] + x[1] * t - (2.0 - 3.0 * t)).collect());
        let found = solve(&line, &[0.0, 0.0], &Bounds::none(2), &Options::default());
        near(&found.x, &[2.0, -3.0], 1e-9);
        assert!(found.converged);
    }

    #[test]
    fn rosenbrock_powell_and_wood_end_at_their_minima() {
        let rosenbrock = Of(|x: &[f64]| vec![10.0 * (x[1] - x[0] * x[0]), 1.0 - x[0]]);
        near(&solve(&rosenbrock, &[-1.2, 1.0], &Bounds::none(2), &Options::default()).x, &[1.0, 1.0], 1e-6);
        // The Jacobian is singular at the solution.
        let powell = Of(|x: &[f64]| {
            vec![
                x[0] + 10.0 * x[1],
                5f64.sqrt() * (x[2] - x[3]),
                (x[1] - 2.0 * x[2]).powi(2),
                10f64.sqrt() * (x[0] - x[3]).powi(2),
            ]
        });
        near(&solve(&powell, &[3.0, -1.0, 0.0, 1.0], &Bounds::none(4), &Options::default()).x, &[0.0; 4], 1e-3);
        let wood = Of(|x: &[f64]| {
            vec![
                10.0 * (x[1] - x[0] * x[0]),
                1.0 - x[0],
                90f64.sqrt() * (x[3] - x[2] * x[2]),
                1.0 - x[2],
                10f64.sqrt() * (x[1] + x[3] - 2.0),
                (x[1] - x[3]) / 10f64.sqrt(),
            ]
        });
        near(&solve(&wood, &[-3.0, -1.0, -3.0, -1.0], &Bounds::none(4), &Options::default()).x, &[1.0; 4], 1e-6);
    }

    #[test]
    fn a_bound_holds_and_the_rest_is_the_best_beside_it() {
        // Without the bound, the minimum is (1, 1). With x0 <= 0.5, it is (0.5, 0.25).
        let rosenbrock = Of(|x: &[f64]| vec![10.0 * (x[1] - x[0] * x[0]), 1.0 - x[0]]);
        let bounds = Bounds { low: vec![-2.0, -2.0], high: vec![0.5, 2.0] };
        let found = solve(&rosenbrock, &[-1.2, 1.0], &bounds, &Options::default());
        near(&found.x, &[0.5, 0.25], 1e-6);
        assert!(found.converged && found.x[0] <= 0.5);
        // A start outside the bounds is clamped, and a parameter leaves its bound if the data require it.
        let found = solve(&rosenbrock, &[0.7, -7.0], &bounds, &Options::default());
        near(&found.x, &[0.5, 0.25], 1e-6);
        let wide = Bounds { low: vec![0.0, 0.0], high: vec![9.0, 9.0] };
        near(&solve(&rosenbrock, &[0.0, 0.0], &wide, &Options::default()).x, &[1.0, 1.0], 1e-6);
    }

    #[test]
    fn a_wild_sample_does_not_pull_with_hubers_loss() {
        let values = [1.0, 1.1, 0.9, 1.05, 0.95, 50.0];
        let mean = Of(|x: &[f64]| values.iter().map(|v| (x[0] - v) / 0.1).collect());
        let squares = solve(&mean, &[0.0], &Bounds::none(1), &Options::default());
        near(&squares.x, &[values.iter().sum::<f64>() / 6.0], 1e-9);
        let options = Options { loss: Loss::Huber(1.5), ..Options::default() };
        // Five good samples balance the limited influence of the outlier, 1.5. The sum of (x - v)/0.1 over the five
        // samples equals 1.5.
        near(&solve(&mean, &[0.0], &Bounds::none(1), &options).x, &[1.0 + 0.15 / 5.0], 1e-4);
    }

    #[test]
    fn a_prior_and_a_measurement_meet_at_their_weighted_mean_and_an_open_number_stays_at_its_prior() {
        let one = Of(|x: &[f64]| vec![(x[0] - 4.0) / 2.0, 0.0 * x[1]]);
        let priors = vec![Some(Prior { mean: 1.0, spread: 1.0 }), Some(Prior { mean: -3.0, spread: 5.0 })];
        let found = solve(&one, &[0.0, 0.0], &Bounds::none(2), &Options { priors, ..Options::default() });
        near(&found.x, &[(4.0 / 4.0 + 1.0) / (1.0 / 4.0 + 1.0), -3.0], 1e-9);
    }

    #[test]
    fn the_lowest_of_several_starts_is_kept() {
        // There are local minima near x = 2 and near x = −2. The cost is zero only at x = 2.
        let valleys = Of(|x: &[f64]| vec![(x[0] * x[0] - 4.0) * 0.5, 0.1 * (x[0] - 2.0)]);
        let left = solve(&valleys, &[-3.0], &Bounds::none(1), &Options::default());
        assert!(left.x[0] < 0.0);
        let best = solve_from(&valleys, &[vec![-3.0], vec![3.0]], &Bounds::none(1), &Options::default()).unwrap();
        near(&best.x, &[2.0], 1e-6);
        assert_eq!(solve_from(&valleys, &[], &Bounds::none(1), &Options::default()), None);
    }

    #[test]
    fn numbers_that_make_no_model_are_walked_around_and_a_hopeless_start_is_told() {
        struct Root;
        impl Residuals for Root {
            type At = f64;
            fn prepare(&self, x: &[f64]) -> Option<f64> {
                (x[0] > 0.0).then_some(x[0])
            }
            fn residuals(&self, _: usize, x: &f64) -> Option<Vec<f64>> {
                Some(vec![x.ln() - 1.0])
            }
        }
        near(&solve(&Root, &[20.0], &Bounds::none(1), &Options::default()).x, &[libm::exp(1f64)], 1e-7);
        let lost = solve(&Root, &[-1.0], &Bounds::none(1), &Options::default());
        assert!(lost.cost.is_infinite() && !lost.converged);
    }

    #[test]
    fn a_search_that_ends_at_a_point_without_derivatives_keeps_its_residuals_there() {
        struct OnceDifferentiable;
        impl Residuals for OnceDifferentiable {
            type At = f64;
            fn prepare(&self, x: &[f64]) -> Option<f64> {
                Some(x[0])
            }
            fn residuals(&self, _: usize, x: &f64) -> Option<Vec<f64>> {
                Some(vec![x * x - 4.0])
            }
            fn jacobian(&self, _: usize, x: &f64) -> Option<DMatrix<f64>> {
                Some(DMatrix::from_element(1, 1, if *x == 8.0 { 16.0 } else { f64::NAN }))
            }
        }
        let found = solve(&OnceDifferentiable, &[8.0], &Bounds::none(1), &Options::default());
        assert!(found.x[0] < 8.0 && !found.converged);
        near(found.rows[0].residual.as_slice(), &[found.x[0] * found.x[0] - 4.0], 1e-12);
        assert_eq!(found.rows[0].jacobian[(0, 0)], 16.0);
    }

    #[test]
    fn many_blocks_and_one_block_give_the_same() {
        struct Blocks(usize);
        impl Residuals for Blocks {
            type At = Vec<f64>;
            fn prepare(&self, x: &[f64]) -> Option<Vec<f64>> {
                Some(x.to_vec())
            }
            fn blocks(&self) -> usize {
                self.0
            }
            fn residuals(&self, block: usize, x: &Vec<f64>) -> Option<Vec<f64>> {
                let of = |i: usize| {
                    let t = i as f64 / 10.0;
                    x[0] * libm::exp(-x[1] * t) - 3.0 * libm::exp(-0.7 * t) - 0.01 * libm::sin(9.0 * t)
                };
                Some((0..60).filter(|i| i % self.0 == block).map(of).collect())
            }
        }
        let of = |blocks| solve(&Blocks(blocks), &[1.0, 1.0], &Bounds::none(2), &Options::default()).x;
        near(&of(1), &of(7), 1e-9);
        assert_eq!(of(7), of(7));
    }

    #[test]
    fn derivatives_kept_up_lead_where_fresh_ones_do_and_may_start_from_wrong_ones() {
        let curve = Of(|x: &[f64]| {
            (0..30)
                .map(|i| f64::from(i) / 10.0)
                .map(|t| x[0] * libm::exp(-x[1] * t) - 3.0 * libm::exp(-0.7 * t))
                .collect()
        });
        let kept = Options { derivatives: Derivatives::Kept, damping: 1e-3, steps: 60, ..Options::default() };
        let found = solve(&curve, &[2.0, 1.0], &Bounds::none(2), &kept);
        near(&found.x, &[3.0, 0.7], 1e-4);
        // Start with derivatives that are 10 % too large.
        let wrong = solve(&curve, &[2.0, 1.0], &Bounds::none(2), &Options { steps: 0, ..kept.clone() });
        let known = vec![1.1 * &wrong.rows[0].jacobian];
        let found = solve_knowing(&curve, &[2.0, 1.0], Some(known), &Bounds::none(2), &kept);
        near(&found.x, &[3.0, 0.7], 1e-4);
        assert!(found.rows[0].residual.norm() < 1e-3);
    }
}
