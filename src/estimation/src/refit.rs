//! One explanation refitted to the tests, with little more than one run of the model per step.
//!
//! To compare explanations the Jacobian is taken once and then kept up ([`Derivatives::Kept`]), since those that a diagnosis compares
//! differ by two or three numbers from one whose Jacobian is known. The likely ones are then refitted with a Jacobian of
//! their own in every step.

use super::hypothesis::{Hypothesis, Number, Residual};
use super::samples::Test;
use crate::sensitivity::Accuracy;
use crate::solve::{Bounds, Derivatives, Loss, Options, Prior, Residuals, Rows, solve_knowing};
use nalgebra::DMatrix;

/// Weighted residual beyond which a sample counts linearly.
pub const HUBER: f64 = 4.0;
const LOSS: Loss = Loss::Huber(HUBER);

/// How hard to try.
#[derive(Debug, Clone, Copy)]
pub struct Effort {
    /// Most steps.
    pub steps: usize,
    /// Share of the cost that may be left to gain.
    pub tolerance: f64,
    /// Whether the Jacobian is taken anew after every step that succeeds.
    pub renews: bool,
    /// How exactly it is taken.
    pub derivatives: Accuracy,
    /// How the residuals are integrated.
    pub residuals: Accuracy,
}

impl Effort {
    /// To screen which explanations are worth more.
    pub const SCREEN: Effort = Effort {
        steps: 4,
        tolerance: 2e-3,
        renews: false,
        derivatives: Accuracy::Derivatives,
        residuals: Accuracy::Single,
    };
    /// To compare explanations.
    pub const COMPARE: Effort = Effort { steps: 10, ..Effort::SCREEN };
    /// To judge the likely ones.
    pub const JUDGE: Effort = Effort { steps: 8, tolerance: 1e-3, renews: true, ..Effort::SCREEN };
    /// For the result.
    pub const FINE: Effort =
        Effort { steps: 20, tolerance: 1e-4, renews: true, derivatives: Accuracy::Fine, residuals: Accuracy::Fine };
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
    /// χ² with the cost of leaving the priors.
    pub cost: f64,
}

impl Refit {
    /// An explanation as it stands at `theta`.
    pub fn from_point(hypothesis: &Hypothesis, theta: Vec<f64>, residual: Residual, jacobian: DMatrix<f64>) -> Refit {
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
    residual.iter().map(|r| 2.0 * LOSS.evaluate(*r).0).sum()
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

/// An explanation of some tests, with residuals of one's choice: all tests are one block.
struct Problem<'a> {
    hypothesis: &'a Hypothesis,
    tests: &'a [Test],
    derivatives: Accuracy,
    residual_at: &'a (dyn Fn(&[f64]) -> Option<Residual> + Sync),
}

impl Residuals for Problem<'_> {
    type At = Vec<f64>;

    fn prepare(&self, theta: &[f64]) -> Option<Vec<f64>> {
        Some(theta.to_vec())
    }

    /// Computed less measured: the sign in which the derivatives of the computed forces are those of the residuals.
    fn residuals(&self, _: usize, theta: &Vec<f64>) -> Option<Vec<f64>> {
        let residual = (self.residual_at)(theta)?;
        Some(residual.iter().map(|r| -r).collect())
    }

    fn jacobian(&self, block: usize, theta: &Vec<f64>) -> Option<(Vec<f64>, DMatrix<f64>)> {
        let residual = self.residuals(block, theta)?;
        Some((residual, self.hypothesis.jacobian(self.derivatives, self.tests, theta)?))
    }
}

/// Damping of the first step: a start is near where the refit before it ended.
const DAMPING: f64 = 1e-3;

/// Options of the least squares for some free numbers.
pub fn options(numbers: &[Number], effort: Effort) -> Options {
    Options {
        steps: effort.steps,
        tolerance: effort.tolerance,
        loss: LOSS,
        priors: numbers.iter().map(|n| n.prior.map(|(mean, spread)| Prior { mean, spread })).collect(),
        derivatives: if effort.renews { Derivatives::Fresh } else { Derivatives::Kept },
        damping: DAMPING,
        quiet: 1,
    }
}

/// Refits an explanation from `start`; with the Jacobian there if it is known. `None` where it makes no finite force.
pub fn refit(
    hypothesis: &Hypothesis,
    tests: &[Test],
    start: &[f64],
    jacobian: Option<DMatrix<f64>>,
    effort: Effort,
) -> Option<Refit> {
    refit_by(hypothesis, tests, start, jacobian, effort, &|theta| {
        hypothesis.residual_by(effort.residuals, tests, theta)
    })
}

/// Refits with residuals of one's choice.
pub fn refit_by(
    hypothesis: &Hypothesis,
    tests: &[Test],
    start: &[f64],
    jacobian: Option<DMatrix<f64>>,
    effort: Effort,
    residual_at: &(dyn Fn(&[f64]) -> Option<Residual> + Sync),
) -> Option<Refit> {
    if hypothesis.numbers.is_empty() {
        let residual = residual_at(&[])?;
        let jacobian = DMatrix::zeros(residual.len(), 0);
        return Some(Refit::from_point(hypothesis, Vec::new(), residual, jacobian));
    }
    let problem = Problem { hypothesis, tests, derivatives: effort.derivatives, residual_at };
    let (low, high) = hypothesis.numbers.iter().map(|n| n.bounds).unzip();
    let options = options(&hypothesis.numbers, effort);
    let mut found = solve_knowing(&problem, start, jacobian.map(|j| vec![j]), &Bounds { low, high }, &options);
    let Rows { residual, jacobian } = found.rows.pop()?;
    found.cost.is_finite().then(|| Refit::from_point(hypothesis, found.x, -residual, jacobian))
}

/// Square roots of Huber's weights.
pub fn weights(residual: &Residual) -> Vec<f64> {
    residual.iter().map(|r| LOSS.evaluate(*r).1.sqrt()).collect()
}
