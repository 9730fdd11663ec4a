//! Bounded, robust, nonlinear least squares for any residuals: one Levenberg–Marquardt for the whole project.
//!
//! - Marquardt's scaling by the columns of the Jacobian (SIAM J. Appl. Math. 11, 1963) and Nielsen's damping, which follows
//!   the ratio of the fall to the fall predicted (IMM-REP-1999-05, 1999).
//! - A step follows the curvature of the residuals by one more evaluation (geodesic acceleration, Transtrum & Sethna,
//!   arXiv:1201.5885, 2012): narrow curved valleys, the rule where friction meets a steep curve, are walked in tens of steps
//!   instead of thousands.
//! - Linear systems are solved by orthogonal factors, never by squared (normal) equations: half the digits would go there.
//!   Blocks are reduced to their triangular factors one by one and stacked in their order, so a result does not depend
//!   on the number of threads.
//! - Bounds by projection: a number at a bound whose gradient points outwards is held for that step.
//! - Huber's loss by reweighting (Ann. Math. Stat. 35, 1964); Gaussian priors as further rows.
//! - A fit has ended where the share of the cost that a full linear step could still take away is below the tolerance
//!   (the relative offset of Bates & Watts, Technometrics 23, 1981), not where one damped step happened to be short.

mod differences;
// Its tables of data stay tables.
#[cfg(test)]
#[rustfmt::skip]
mod nist;

use super::cancel;
use nalgebra::{DMatrix, DVector};
use rayon::prelude::*;

/// Something to be made small: weighted residuals (model less measurement over its error) in one or more blocks.
pub trait Residuals: Sync {
    /// Number of blocks: one a test, so that tests are computed side by side.
    fn blocks(&self) -> usize {
        1
    }

    /// Weighted residuals of one block; `None` where the numbers make no model.
    fn residuals(&self, block: usize, x: &[f64]) -> Option<Vec<f64>>;

    /// Residuals of one block and their exact derivatives, one column a number; `None` where there are none: central
    /// differences are taken then.
    fn jacobian(&self, _block: usize, _x: &[f64]) -> Option<(Vec<f64>, DMatrix<f64>)> {
        None
    }
}

/// The range of every number.
#[derive(Debug, Clone, PartialEq)]
pub struct Bounds {
    /// Lowest values.
    pub low: Vec<f64>,
    /// Highest values.
    pub high: Vec<f64>,
}

impl Bounds {
    /// No bound on any of `n` numbers.
    pub fn none(n: usize) -> Self {
        Self { low: vec![f64::NEG_INFINITY; n], high: vec![f64::INFINITY; n] }
    }
}

/// What is known of a number before the data: a Gaussian.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Prior {
    /// Its middle.
    pub mean: f64,
    /// Its standard deviation, in the unit of the number.
    pub spread: f64,
}

/// What one weighted residual costs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Loss {
    /// Half its square.
    Squares,
    /// Half its square up to this size, linear beyond: single wild samples do not pull.
    Huber(f64),
}

impl Loss {
    /// Cost of one residual, and the weight that stays on its square.
    fn of(self, r: f64) -> (f64, f64) {
        match self {
            Loss::Huber(knee) if r.abs() > knee => (knee * (r.abs() - 0.5 * knee), knee / r.abs()),
            _ => (0.5 * r * r, 1.0),
        }
    }
}

/// How a solution is looked for.
#[derive(Debug, Clone, PartialEq)]
pub struct Options {
    /// Most steps tried, accepted or not.
    pub steps: usize,
    /// Share of the cost that may be left to gain at the end.
    pub tolerance: f64,
    /// Loss of a residual.
    pub loss: Loss,
    /// What is known of the numbers: empty, or one entry a number.
    pub priors: Vec<Option<Prior>>,
}

impl Default for Options {
    fn default() -> Self {
        Self { steps: 200, tolerance: 1e-8, loss: Loss::Squares, priors: Vec::new() }
    }
}

/// Where a search ended.
#[derive(Debug, Clone, PartialEq)]
pub struct Solution {
    /// The numbers.
    pub x: Vec<f64>,
    /// Sum of the losses and half the squares of the priors; infinite where the start makes no model.
    pub cost: f64,
    /// Whether it ended by itself, not by the number of steps.
    pub converged: bool,
    /// Steps tried.
    pub steps: usize,
}

/// Residuals and derivatives at one point, reduced to as many rows as there are numbers.
struct Linear {
    cost: f64,
    /// Triangular factor of the weighted Jacobian.
    factor: DMatrix<f64>,
    /// Weighted residuals in the same rotated rows.
    right: DVector<f64>,
    /// The rows before they were rotated, by block.
    blocks: Vec<Rows>,
}

/// One block at one point.
struct Rows {
    /// Loss of its residuals.
    cost: f64,
    /// Roots of the weights that the loss leaves.
    weights: Vec<f64>,
    /// Weighted derivatives.
    jacobian: DMatrix<f64>,
    /// Weighted residuals.
    right: DVector<f64>,
}

/// One block with its triangular factor and its rotated residuals.
type Reduced = (Rows, DMatrix<f64>, DVector<f64>);

/// Rotates rows of Jacobian and residual until no more rows are left than numbers.
fn reduce(jacobian: DMatrix<f64>, residual: DVector<f64>) -> (DMatrix<f64>, DVector<f64>) {
    let n = jacobian.ncols();
    if jacobian.nrows() <= n {
        return (jacobian, residual);
    }
    let qr = jacobian.qr();
    let mut right = residual;
    qr.q_tr_mul(&mut right);
    (qr.r(), right.rows(0, n).into_owned())
}

/// What a search works on.
struct Search<'a, R> {
    problem: &'a R,
    bounds: &'a Bounds,
    options: &'a Options,
}

impl<R: Residuals> Search<'_, R> {
    /// The priors' own rows: number, weight, residual.
    fn prior_rows(&self, x: &[f64]) -> Vec<(usize, f64, f64)> {
        let row = |(i, prior): (usize, &Option<Prior>)| prior.map(|p| (i, 1.0 / p.spread, (x[i] - p.mean) / p.spread));
        self.options.priors.iter().enumerate().filter_map(row).collect()
    }

    fn prior_cost(&self, x: &[f64]) -> f64 {
        self.prior_rows(x).iter().map(|(.., r)| 0.5 * r * r).sum()
    }

    /// Infinite where the numbers make no model or no finite residual.
    fn cost(&self, x: &[f64]) -> f64 {
        let costs: Vec<f64> = (0..self.problem.blocks())
            .into_par_iter()
            .map(|block| match self.problem.residuals(block, x) {
                Some(residuals) => residuals.iter().map(|r| self.options.loss.of(*r).0).sum(),
                None => f64::INFINITY,
            })
            .collect();
        let sum = costs.iter().sum::<f64>() + self.prior_cost(x);
        if sum.is_finite() { sum } else { f64::INFINITY }
    }

    fn linear(&self, x: &[f64]) -> Option<Linear> {
        let n = x.len();
        let parts: Vec<Option<Reduced>> = (0..self.problem.blocks())
            .into_par_iter()
            .map(|block| {
                let (residuals, mut jacobian) = match self.problem.jacobian(block, x) {
                    Some(exact) => exact,
                    None => differences::central(self.problem, block, x, self.bounds)?,
                };
                let mut right = DVector::from_vec(residuals);
                let mut cost = 0.0;
                let mut weights = vec![1.0; right.len()];
                for i in 0..right.len() {
                    let (loss, weight) = self.options.loss.of(right[i]);
                    cost += loss;
                    if weight < 1.0 {
                        weights[i] = weight.sqrt();
                        right[i] *= weights[i];
                        jacobian.row_mut(i).scale_mut(weights[i]);
                    }
                }
                let finite = right.iter().chain(jacobian.iter()).all(|v| v.is_finite());
                let (factor, rotated) = if finite { reduce(jacobian.clone(), right.clone()) } else { return None };
                Some((Rows { cost, weights, jacobian, right }, factor, rotated))
            })
            .collect();
        let parts: Vec<_> = parts.into_iter().collect::<Option<_>>()?;
        let priors = self.prior_rows(x);
        let rows = parts.iter().map(|p| p.1.nrows()).sum::<usize>() + priors.len();
        let (mut factor, mut right) = (DMatrix::zeros(rows, n), DVector::zeros(rows));
        let (mut row, mut cost) = (0, self.prior_cost(x));
        for (block, part, residual) in &parts {
            cost += block.cost;
            factor.view_mut((row, 0), part.shape()).copy_from(part);
            right.rows_mut(row, part.nrows()).copy_from(residual);
            row += part.nrows();
        }
        for (i, weight, residual) in priors {
            factor[(row, i)] = weight;
            right[row] = residual;
            row += 1;
        }
        let (factor, right) = reduce(factor, right);
        let blocks = parts.into_iter().map(|p| p.0).collect();
        cost.is_finite().then_some(Linear { cost, factor, right, blocks })
    }

    /// Gradient of half the residuals' curvature along a step, from one more evaluation on the way; `None` where that
    /// makes no model.
    fn bend(&self, x: &[f64], at: &Linear, step: &DVector<f64>) -> Option<DVector<f64>> {
        let probe: Vec<f64> = x.iter().zip(step.iter()).map(|(x, s)| x + PROBE * s).collect();
        let inside = (0..x.len()).all(|i| probe[i] >= self.bounds.low[i] && probe[i] <= self.bounds.high[i]);
        if !inside {
            return None;
        }
        let parts: Vec<Option<DVector<f64>>> = at
            .blocks
            .par_iter()
            .enumerate()
            .map(|(block, rows)| {
                let ahead = self.problem.residuals(block, &probe)?;
                let straight = &rows.jacobian * step;
                let bend = DVector::from_fn(ahead.len(), |i, _| {
                    ((ahead[i] * rows.weights[i] - rows.right[i]) / PROBE - straight[i]) / PROBE
                });
                Some(rows.jacobian.tr_mul(&bend))
            })
            .collect();
        let parts: Vec<_> = parts.into_iter().collect::<Option<_>>()?;
        let sum = parts.into_iter().reduce(|a, b| a + b)?;
        sum.iter().all(|v| v.is_finite()).then_some(sum)
    }
}

/// Damping at the start, of columns scaled to length 1.
const FIRST_DAMPING: f64 = 1.0;
/// What is left of the length of a column after a step that shortened it. 1 would be Moré's (Lect. Notes Math. 630, 1978), 0
/// Marquardt's.
const FADE: f64 = 0.5;
/// Damping below which a step is the full linear one in every digit that counts.
const LEAST_DAMPING: f64 = 1e-16;
/// Part of a step at which the curvature of the residuals is looked at.
const PROBE: f64 = 0.1;
/// Longest correction for curvature, over the step itself; beyond, the residuals are not a parabola along the step.
const MOST_BEND: f64 = 0.5;
/// Share of the cost that no longer shows in its sum.
const ROUNDING: f64 = 1e-15;
/// Accepted steps, one after the other, that gain less than the tolerance before a search gives up on the rest: in
/// directions that the data leave open the linear step promises gains that never come.
const QUIET: usize = 4;

/// Minimises from `start`, which is moved inside the bounds first.
pub fn solve(problem: &impl Residuals, start: &[f64], bounds: &Bounds, options: &Options) -> Solution {
    let search = Search { problem, bounds, options };
    let n = start.len();
    let mut x: Vec<f64> = (0..n).map(|i| start[i].clamp(bounds.low[i], bounds.high[i])).collect();
    let mut end = Solution { x: x.clone(), cost: f64::INFINITY, converged: false, steps: 0 };
    if cancel::asked() {
        return end;
    }
    let Some(mut at) = search.linear(&x) else { return end };
    end.cost = at.cost;
    let (mut damping, mut growth, mut quiet) = (FIRST_DAMPING, 2.0, 0);
    let (mut arrived, mut first) = (false, true);
    // Where a number stops mattering its column fades, and a step measured by the column alone would leave for the flat far
    // away; columns therefore fade slowly.
    let mut lengths = vec![0.0f64; n];
    while end.steps < options.steps && !cancel::asked() {
        let gradient = at.factor.tr_mul(&at.right);
        for (length, column) in lengths.iter_mut().zip(at.factor.column_iter()) {
            *length = (FADE * *length).max(column.norm());
        }
        let free: Vec<usize> = (0..n)
            .filter(|i| {
                let outwards =
                    (x[*i] <= bounds.low[*i] && gradient[*i] > 0.0) || (x[*i] >= bounds.high[*i] && gradient[*i] < 0.0);
                !outwards && lengths[*i] > 0.0
            })
            .collect();
        let k = free.len();
        let rows = at.factor.nrows();
        let scaled = DMatrix::from_fn(rows, k, |r, c| at.factor[(r, free[c])] / lengths[free[c]]);
        let left = {
            let qr = scaled.clone().qr();
            let mut rotated = at.right.clone();
            qr.q_tr_mul(&mut rotated);
            0.5 * rotated.rows(0, k.min(rows)).norm_squared()
        };
        if k == 0 || left <= options.tolerance * at.cost {
            end.converged = true;
            // A last full step is free of charge where it helps: the criterion speaks of where it started from.
            arrived = true;
            if k == 0 {
                break;
            }
            damping = LEAST_DAMPING;
        }
        // Steps from the same point with more and more damping, until one falls.
        let accepted = loop {
            if end.steps >= options.steps {
                break None;
            }
            end.steps += 1;
            let stacked = DMatrix::from_fn(rows + k, k, |r, c| {
                if r < rows {
                    scaled[(r, c)]
                } else if r - rows == c {
                    damping.sqrt()
                } else {
                    0.0
                }
            });
            let qr = stacked.qr();
            let mut right = DVector::zeros(rows + k);
            right.rows_mut(0, rows).copy_from(&-&at.right);
            qr.q_tr_mul(&mut right);
            let triangle = qr.r();
            let solved = triangle.solve_upper_triangular(&right.rows(0, k).into_owned());
            let spread = |step: &DVector<f64>| {
                let mut all = DVector::zeros(n);
                for (c, i) in free.iter().enumerate() {
                    all[*i] = step[c] / lengths[*i];
                }
                all
            };
            let step = solved.as_ref().map_or_else(|| DVector::zeros(n), spread);
            let inside = |to: &DVector<f64>| -> Vec<f64> {
                (0..n).map(|i| (x[i] + to[i]).clamp(bounds.low[i], bounds.high[i])).collect()
            };
            let mut tried = inside(&step);
            let moved = DVector::from_fn(n, |i, _| tried[i] - x[i]);
            let length = |v: &[f64]| v.iter().zip(&lengths).map(|(v, l)| (v * l).powi(2)).sum::<f64>().sqrt();
            if first {
                let reach = length(&x);
                if reach > 0.0 && length(moved.as_slice()) > reach {
                    damping *= 4.0;
                    continue;
                }
                first = false;
            }
            if let Some(bend) = search.bend(&x, &at, &step) {
                let scaled_bend = DVector::from_fn(k, |c, _| -bend[free[c]] / lengths[free[c]]);
                let correction = triangle
                    .tr_solve_upper_triangular(&scaled_bend)
                    .and_then(|half| triangle.solve_upper_triangular(&half))
                    .map(|c| spread(&c));
                if let Some(correction) = correction {
                    if length(correction.as_slice()) <= MOST_BEND * length(step.as_slice()) {
                        tried = inside(&(&step + correction));
                    }
                }
            }
            let predicted = 0.5 * (at.right.norm_squared() - (&at.right + &at.factor * &moved).norm_squared());
            let cost = search.cost(&tried);
            if cost < at.cost {
                let ratio = if predicted > 0.0 { (at.cost - cost) / predicted } else { 0.0 };
                damping = (damping * (1.0 - (2.0 * ratio - 1.0).powi(3)).clamp(1.0 / 3.0, 2.0)).max(LEAST_DAMPING);
                growth = 2.0;
                break Some((tried, cost));
            }
            let size = |v: &[f64]| v.iter().map(|a| a * a).sum::<f64>().sqrt();
            if arrived || predicted.abs() <= ROUNDING * at.cost || moved.norm() <= ROUNDING * size(&x) {
                // Nothing that arithmetic could still show.
                end.converged = true;
                break None;
            }
            damping = (damping * growth).max(LEAST_DAMPING);
            growth *= 2.0;
        };
        let Some((tried, cost)) = accepted else { break };
        quiet = if at.cost - cost <= options.tolerance * at.cost { quiet + 1 } else { 0 };
        x = tried;
        (end.x, end.cost) = (x.clone(), cost);
        if arrived || cost == 0.0 || quiet >= QUIET {
            end.converged = true;
            break;
        }
        match search.linear(&x) {
            Some(next) => at = next,
            None => break,
        }
    }
    end
}

/// Minimises from every start and keeps the lowest cost, the first of equals. `None` without starts.
pub fn solve_from(
    problem: &impl Residuals,
    starts: &[Vec<f64>],
    bounds: &Bounds,
    options: &Options,
) -> Option<Solution> {
    let ends: Vec<Solution> = starts.par_iter().map(|start| solve(problem, start, bounds, options)).collect();
    ends.into_iter().reduce(|best, next| if next.cost < best.cost { next } else { best })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A function given as a closure.
    struct Of<F>(F);

    impl<F: Fn(&[f64]) -> Vec<f64> + Sync> Residuals for Of<F> {
        fn residuals(&self, _: usize, x: &[f64]) -> Option<Vec<f64>> {
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
        // A Jacobian that is singular at the solution.
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
        // Without the bound the minimum is (1, 1); with x0 <= 0.5 it is (0.5, 0.25).
        let rosenbrock = Of(|x: &[f64]| vec![10.0 * (x[1] - x[0] * x[0]), 1.0 - x[0]]);
        let bounds = Bounds { low: vec![-2.0, -2.0], high: vec![0.5, 2.0] };
        let found = solve(&rosenbrock, &[-1.2, 1.0], &bounds, &Options::default());
        near(&found.x, &[0.5, 0.25], 1e-6);
        assert!(found.converged && found.x[0] <= 0.5);
        // A start outside is moved in, and a number leaves its bound when the data want it to.
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
        // Five good samples against one pull of 1.5: sum of (x - v)/0.1 over five equals 1.5.
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
        // Two valleys; only the right one reaches zero.
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
            fn residuals(&self, _: usize, x: &[f64]) -> Option<Vec<f64>> {
                (x[0] > 0.0).then(|| vec![x[0].ln() - 1.0])
            }
        }
        near(&solve(&Root, &[20.0], &Bounds::none(1), &Options::default()).x, &[1f64.exp()], 1e-7);
        let lost = solve(&Root, &[-1.0], &Bounds::none(1), &Options::default());
        assert!(lost.cost.is_infinite() && !lost.converged);
    }

    #[test]
    fn many_blocks_and_one_block_give_the_same() {
        struct Blocks(usize);
        impl Residuals for Blocks {
            fn blocks(&self) -> usize {
                self.0
            }
            fn residuals(&self, block: usize, x: &[f64]) -> Option<Vec<f64>> {
                let of = |i: usize| {
                    let t = i as f64 / 10.0;
                    x[0] * (-x[1] * t).exp() - 3.0 * (-0.7 * t).exp() - 0.01 * (9.0 * t).sin()
                };
                Some((0..60).filter(|i| i % self.0 == block).map(of).collect())
            }
        }
        let of = |blocks| solve(&Blocks(blocks), &[1.0, 1.0], &Bounds::none(2), &Options::default()).x;
        near(&of(1), &of(7), 1e-9);
        assert_eq!(of(7), of(7));
    }
}
