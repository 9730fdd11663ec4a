//! Refit of one hypothesis to the tests, at little more than the cost of one model run for each step.
//!
//! For a comparison, the Jacobian is computed once and then updated ([`Derivatives::Kept`]). The compared hypotheses
//! differ by two or three parameters from a hypothesis with a known Jacobian. The likely hypotheses are then refitted
//! with a new Jacobian in every step.

use super::hypothesis::{Hypothesis, Number, Residual};
use super::samples::Test;
use crate::sensitivity::Accuracy;
use crate::solve::{Bounds, Derivatives, Loss, Options, Prior, Residuals, Rows, solve_knowing};
use nalgebra::DMatrix;

/// Weighted residual beyond which the loss of a sample is linear (Huber).
pub const HUBER: f64 = 4.0;
const LOSS: Loss = Loss::Huber(HUBER);

/// Limits of the cost of a refit.
#[derive(Debug, Clone, Copy)]
pub struct Effort {
    /// Largest number of steps.
    pub steps: usize,
    /// Relative decrease of the cost by a further step below which the refit ends.
    pub tolerance: f64,
    /// Whether the Jacobian is computed again after every successful step.
    pub renews: bool,
    /// Accuracy of the integration for the Jacobian.
    pub derivatives: Accuracy,
    /// Accuracy of the integration for the residuals.
    pub residuals: Accuracy,
}

impl Effort {
    /// Effort for the selection of hypotheses for longer refits.
    pub const SCREEN: Effort = Effort {
        steps: 4,
        tolerance: 2e-3,
        renews: false,
        derivatives: Accuracy::Derivatives,
        residuals: Accuracy::Single,
    };
    /// Effort to compare hypotheses.
    pub const COMPARE: Effort = Effort { steps: 10, ..Effort::SCREEN };
    /// Effort for the evaluation of the likely hypotheses.
    pub const JUDGE: Effort = Effort { steps: 8, tolerance: 1e-3, renews: true, ..Effort::SCREEN };
    /// Effort for the final result.
    pub const FINE: Effort =
        Effort { steps: 20, tolerance: 1e-4, renews: true, derivatives: Accuracy::Fine, residuals: Accuracy::Fine };
}

/// Result of a refit.
#[derive(Debug, Clone)]
pub struct Refit {
    /// Values of the free parameters.
    pub theta: Vec<f64>,
    /// Weighted residuals.
    pub residual: Residual,
    /// Weighted derivatives of the computed forces; approximate after an update.
    pub jacobian: DMatrix<f64>,
    /// Twice the sum of the losses (χ² if there are no outliers). The allowed errors account for the correlation of
    /// samples.
    pub chi2: f64,
    /// χ² plus the cost of the distances from the priors.
    pub cost: f64,
}

impl Refit {
    /// Makes a refit of a hypothesis at `theta` from its residual and Jacobian, without iterating.
    pub fn from_point(hypothesis: &Hypothesis, theta: Vec<f64>, residual: Residual, jacobian: DMatrix<f64>) -> Refit {
        let chi2 = chi2(&residual);
        let cost = chi2 + prior_cost(hypothesis, &theta);
        Refit { theta, residual, jacobian, chi2, cost }
    }
}

/// Computes χ² of residuals under Huber's loss.
///
/// The allowed error of a sample already accounts for the correlation of the noise, so the sum over all samples does
/// not count information twice.
pub fn chi2(residual: &Residual) -> f64 {
    residual.iter().map(|r| 2.0 * LOSS.evaluate(*r).0).sum()
}

/// Computes the cost of the distances from the priors: the sum of their squares, in standard deviations.
pub fn prior_cost(hypothesis: &Hypothesis, theta: &[f64]) -> f64 {
    hypothesis
        .numbers
        .iter()
        .zip(theta)
        .filter_map(|(n, t)| n.prior.map(|(mean, deviation)| ((t - mean) / deviation).powi(2)))
        .sum()
}

/// A hypothesis with its tests and a function for its residuals. The samples of all tests are one block of the solver.
struct RefitProblem<'a> {
    hypothesis: &'a Hypothesis,
    tests: &'a [Test],
    derivatives: Accuracy,
    residual_at: &'a (dyn Fn(&[f64]) -> Option<Residual> + Sync),
}

impl Residuals for RefitProblem<'_> {
    type At = Vec<f64>;

    fn prepare(&self, theta: &[f64]) -> Option<Vec<f64>> {
        Some(theta.to_vec())
    }

    /// Computes the residuals as computed minus measured: the derivatives of the residuals are then those of the
    /// computed forces.
    fn residuals(&self, _: usize, theta: &Vec<f64>) -> Option<Vec<f64>> {
        let residual = (self.residual_at)(theta)?;
        Some(residual.iter().map(|r| -r).collect())
    }

    fn jacobian(&self, _: usize, theta: &Vec<f64>) -> Option<DMatrix<f64>> {
        self.hypothesis.jacobian(self.derivatives, self.tests, theta)
    }
}

/// Levenberg-Marquardt damping of the first step. It is small, because the start is near the result of the previous
/// refit.
const DAMPING: f64 = 1e-3;

/// Makes the options of the least-squares solver for some free parameters.
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

/// Refits a hypothesis from `start`, with the Jacobian at the start if it is known. Returns `None` if the model gives
/// no finite force.
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

/// Refits with residuals from a given function. Returns `None` if the function gives no finite residuals.
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
    let problem = RefitProblem { hypothesis, tests, derivatives: effort.derivatives, residual_at };
    let (low, high) = hypothesis.numbers.iter().map(|n| n.bounds).unzip();
    let options = options(&hypothesis.numbers, effort);
    let mut found = solve_knowing(&problem, start, jacobian.map(|j| vec![j]), &Bounds { low, high }, &options);
    let Rows { residual, jacobian } = found.rows.pop()?;
    found.cost.is_finite().then(|| Refit::from_point(hypothesis, found.x, -residual, jacobian))
}

/// Computes the square roots of Huber's weights of the residuals.
pub fn weights(residual: &Residual) -> Vec<f64> {
    residual.iter().map(|r| LOSS.evaluate(*r).1.sqrt()).collect()
}
