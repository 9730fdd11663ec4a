//! Log evidence of a structure: the probability of the records under the structure, without prior odds.
//!
//! No model has exactly the form of the damper, so every structure has a form error in every test. The size of this
//! error differs from test to test by orders of magnitude, but is similar in all samples of one test. The root mean
//! square of a test's form error therefore counts as [`OBSERVATIONS`] observations. The form errors are exponentially
//! distributed. Their scale is common to all tests and is estimated with the structure. The likelihood is this scale to
//! the power of minus the number of observations. A sum of squares over the tests would let the worst test alone
//! determine the result. A sum of logarithms over the tests would tolerate any error in one test. A residual below the
//! noise has no further effect, and [`FORM`] limits the gain close to the noise. Each free parameter costs half the
//! logarithm of the number of tests (Schwarz, Ann. Stat. 6, 1978), and a rare value costs its negative log prior.

use super::component::weight;
use crate::hypothesis::{Free, Hypothesis, Number};
use crate::log_prior::negative_log_prior;
use crate::prior_set::PriorSet;
use crate::refit::HUBER;
use crate::samples::Test;
use crate::scale::Scale;
use nalgebra::DVector;

/// Mean square form error that every test is assumed to have at least, relative to the mean square of noise and curve
/// discretization. With a smaller value, reports contain effects that explain only the discretization of the FV curve.
/// With a larger value, effects below the noise are lost.
const FORM: f64 = 0.3;
/// Number of observations of the form error in a test. A mean cycle shows more than one feature, but its features are
/// correlated with those of neighboring tests. With a larger value, reports contain effects that explain only a small
/// fraction of the error. With a smaller value, effects that act in few tests are lost.
const OBSERVATIONS: f64 = 1.5;

/// Residual statistics of a structure.
#[derive(Debug, Clone)]
pub struct Evidence {
    /// Mean square residual of each test, relative to the mean square of noise and curve discretization.
    pub mean_squares: Vec<f64>,
    /// Number of tests that each test represents.
    pub weights: Vec<f64>,
    /// Number of free parameters. Weakly determined parameters count half.
    pub numbers: f64,
    /// Negative log prior of the parameter values.
    pub negative_log_prior: f64,
    /// Reduction of the log cost of parameters that are better known for this damper than for other dampers.
    pub relief: f64,
}

/// Computes the mean square residual of samples of a test, relative to that of its noise and curve discretization.
/// `unit` is the root mean square of both, N. Residuals beyond [`HUBER`] count linearly.
///
/// Each sample is a pair: its residual divided by the allowed error, and its allowed error, N.
pub fn mean_square(unit: f64, samples: impl Iterator<Item = (f64, f64)>) -> f64 {
    let (mut sum, mut expected) = (0.0, 0.0);
    for (residual, allowed) in samples {
        let size = residual.abs();
        sum += if size <= HUBER { size * size } else { HUBER * (2.0 * size - HUBER) };
        expected += (unit / allowed).powi(2);
    }
    sum / expected.max(1e-300)
}

/// Computes the mean square residual of each test, relative to that of noise and curve discretization.
pub fn mean_squares(tests: &[Test], residual: &DVector<f64>) -> Vec<f64> {
    let mut rows = residual.iter().copied();
    let of_test = |test: &Test| mean_square(test.unit(), rows.by_ref().zip(test.allowed.iter().copied()));
    tests.iter().map(of_test).collect()
}

/// Computes the reduction of a parameter's cost, in log odds, if the parameter is better known for this damper than for
/// other dampers. `per_number` is the cost without this knowledge.
pub fn relief(number: &Number, priors: &PriorSet, scale: Scale, per_number: f64) -> f64 {
    match &number.free {
        Free::Model(unknown) => priors.relief(unknown, scale, weight(&number.free) * per_number),
        _ => 0.0,
    }
}

impl Evidence {
    /// Computes the evidence from residuals at `theta`. `numbers` is the count of free parameters, with weakly
    /// determined ones as half.
    pub fn new(
        hypothesis: &Hypothesis,
        theta: &[f64],
        residual: &DVector<f64>,
        tests: &[Test],
        numbers: f64,
    ) -> Evidence {
        let mean_squares = mean_squares(tests, residual);
        let weights: Vec<f64> = tests.iter().map(|t| t.weight).collect();
        let (scale, per_number) = (Scale::from_params(&hypothesis.base), per_number(weights.iter().sum()));
        let relief = |number| relief(number, &hypothesis.priors, scale, per_number);
        Evidence {
            mean_squares,
            weights,
            numbers,
            negative_log_prior: negative_log_prior(hypothesis, theta),
            relief: hypothesis.numbers.iter().map(relief).sum(),
        }
    }

    /// Returns the number of tests that the records represent.
    fn count(&self) -> f64 {
        self.weights.iter().sum()
    }

    /// Computes the mean of the tests' mean square residuals, relative to noise and curve discretization.
    pub fn mean(&self) -> f64 {
        self.mean_squares.iter().zip(&self.weights).map(|(square, weight)| square * weight).sum::<f64>()
            / self.count().max(1.0)
    }

    /// Computes the log likelihood of the residuals, up to a constant that all structures share.
    pub fn log_likelihood(&self) -> f64 {
        let whole = self.count();
        let of = |(square, weight): (&f64, &f64)| weight * (FORM + (square - 1.0).max(0.0)).sqrt();
        let scale = self.mean_squares.iter().zip(&self.weights).map(of).sum::<f64>() / whole.max(1.0);
        -OBSERVATIONS * whole * libm::log(scale)
    }

    /// Computes the cost of one free parameter, in log odds: half the logarithm of the number of tests. With few tests,
    /// it is 1, the mean gain of a parameter by chance (Akaike, IEEE Trans. Autom. Control 19, 1974).
    pub fn per_number(&self) -> f64 {
        per_number(self.count())
    }

    /// Computes the log evidence: the log likelihood minus the costs of the free parameters and of their values.
    pub fn log_evidence(&self) -> f64 {
        self.log_likelihood() - self.numbers * self.per_number() + self.relief - self.negative_log_prior
    }
}

/// Computes the cost of one free parameter, in log odds, for a number of tests.
fn per_number(tests: f64) -> f64 {
    (0.5 * libm::log(tests.max(1.0))).max(1.0)
}

/// Computes the logarithm of the mean of exponentials.
pub fn log_mean_exp(logs: &[f64]) -> f64 {
    log_sum_exp(logs) - libm::log(logs.len().max(1) as f64)
}

/// Computes the logarithm of the sum of exponentials.
pub fn log_sum_exp(logs: &[f64]) -> f64 {
    let most = logs.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    if most == f64::NEG_INFINITY {
        return most;
    }
    most + libm::log(logs.iter().map(|l| libm::exp(l - most)).sum::<f64>())
}

/// Computes the χ² that noise adds to a test: the sum of squared ratios of the noise to the allowed errors, over the
/// scored samples.
fn noise_of(test: &Test) -> f64 {
    test.allowed.iter().map(|a| (test.mean_noise / a).powi(2)).sum()
}

/// Computes the expected χ² of noise alone. If a variance is estimated from ν deviations, its inverse is too large by a
/// factor of ν/(ν − 2) on average.
pub fn noise_chi2(tests: &[Test]) -> f64 {
    tests.iter().map(|t| noise_of(t) * (1.0 + 2.0 / (t.noise_freedom - 2.0).max(4.0))).sum()
}

/// Computes the number of independent samples of all tests.
pub fn effective_count(tests: &[Test]) -> f64 {
    tests.iter().map(Test::independent_count).sum::<f64>().max(1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn evidence(mean_squares: &[f64], numbers: f64) -> Evidence {
        let weights = vec![1.0; mean_squares.len()];
        Evidence { mean_squares: mean_squares.to_vec(), weights, numbers, negative_log_prior: 0.0, relief: 0.0 }
    }

    #[test]
    fn a_smaller_residual_is_more_evidence_and_numbers_cost() {
        let (much, little) = (evidence(&[9.0; 30], 0.0), evidence(&[1.1; 30], 1.0));
        assert!(little.log_evidence() > much.log_evidence() + 10.0);
        assert!(evidence(&[1.1; 30], 4.0).log_evidence() < little.log_evidence() - 4.0);
        let gain = |tests: usize| {
            evidence(&vec![1.1; tests], 1.0).log_evidence() - evidence(&vec![9.0; tests], 0.0).log_evidence()
        };
        assert!(gain(30) > gain(10) + 5.0);
    }

    #[test]
    fn a_residual_within_noise_cannot_be_improved() {
        assert_eq!(evidence(&[1.0; 30], 0.0).log_evidence(), evidence(&[0.5; 30], 0.0).log_evidence());
    }

    #[test]
    fn one_wild_test_hides_no_gain_in_the_others_and_is_not_overlooked() {
        let with = |bulk: f64, wild: f64| {
            let mut all = vec![bulk; 30];
            all[0] = wild;
            evidence(&all, 0.0).log_evidence()
        };
        assert!(with(1.0, 50.0) > with(1.5, 50.0) + 10.0);
        assert!(with(1.5, 1.5) > with(1.5, 50.0) + 5.0);
    }

    #[test]
    fn a_mean_of_exponentials_is_dominated_by_the_largest() {
        assert!((log_mean_exp(&[-1e4, 0.0]) + 2f64.ln()).abs() < 1e-12);
        assert_eq!(log_mean_exp(&[f64::NEG_INFINITY; 2]), f64::NEG_INFINITY);
    }
}
