//! How strongly the records speak for an explanation.
//!
//! The form of no model is that of the damper, so an explanation leaves an error of form in every test whose size nobody knows
//! beforehand. Its evidence is the probability of the mean squares that it leaves, with that size averaged over, each test counted as
//! one or two independent samples, less the price of its numbers (Schwarz, Ann. Stat. 6, 1978) and of values that dampers do not
//! show.

use super::decisions::{FORM, MOST_FORM, OWN_FORM};
use dashpot_estimation::hypothesis::Hypothesis;
use dashpot_estimation::implausibility::implausibility;
use dashpot_estimation::refit::{HUBER, Refit};
use dashpot_estimation::samples::Test;
use nalgebra::DVector;

/// What a refitted explanation leaves, and what it costs.
#[derive(Debug, Clone)]
pub struct Weighed {
    /// Mean square of what it leaves of each test, in units of what noise and the form of curves leave.
    pub mean_squares: Vec<f64>,
    /// Numbers beyond those of the base.
    pub numbers: f64,
    /// Price of values that dampers do not show, beyond that of the explanation to which effects are added: an effect earns nothing by
    /// making the rest look more usual, since what is added anywhere gives the rest a little more room.
    pub implausibility: f64,
}

/// Mean square of the residuals of each test, in units of what noise and the form of curves leave there; what is far off counts
/// linearly.
pub fn mean_squares(tests: &[Test], residual: &DVector<f64>) -> Vec<f64> {
    let mut row = 0;
    tests
        .iter()
        .map(|test| {
            let unit = test.unit();
            let (mut sum, mut expected) = (0.0, 0.0);
            for allowed in &test.allowed {
                let size = residual[row].abs();
                sum += if size <= HUBER { size * size } else { HUBER * (2.0 * size - HUBER) };
                expected += (unit / allowed).powi(2);
                row += 1;
            }
            sum / expected.max(1e-300)
        })
        .collect()
}

impl Weighed {
    /// Of a refit; `numbers` counts those beyond the base's, whose own strangeness is `base`.
    pub fn new(hypothesis: &Hypothesis, refit: &Refit, tests: &[Test], numbers: f64, base: f64) -> Weighed {
        Weighed {
            mean_squares: mean_squares(tests, &refit.residual),
            numbers,
            implausibility: (implausibility(hypothesis, &refit.theta) - base).max(0.0),
        }
    }

    /// Mean of the mean squares.
    pub fn mean(&self) -> f64 {
        self.mean_squares.iter().sum::<f64>() / self.mean_squares.len().max(1) as f64
    }

    /// Logarithm of the evidence where the error of form may be of any size; each test counts as `samples` independent ones.
    pub fn log_evidence(&self, samples: f64) -> f64 {
        self.over(samples, MOST_FORM)
    }

    /// The same where it may be no larger than counts as nothing missing: than the form of curves leaves, and of the names that explain
    /// so much mean square already their own forms.
    pub fn log_evidence_of_nothing(&self, samples: f64, named: f64) -> f64 {
        self.over(samples, (FORM * FORM + OWN_FORM * OWN_FORM * named.max(0.0)).sqrt())
    }

    fn over(&self, samples: f64, most: f64) -> f64 {
        let count = samples * self.mean_squares.len() as f64;
        let mean = self.mean();
        let logs: Vec<f64> = (0..=GRID)
            .map(|k| {
                let form = most * (k as f64 / GRID as f64).powi(3);
                let v = 1.0 + form * form;
                -0.5 * count * (libm::log(v) + mean / v)
            })
            .collect();
        log_mean_exp(&logs) - 0.5 * self.numbers * libm::log(count.max(1.0)) - self.implausibility
    }
}

/// Points of the grid of errors of form.
const GRID: usize = 60;

/// Logarithm of the mean of exponentials.
pub fn log_mean_exp(logs: &[f64]) -> f64 {
    let most = logs.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    if most == f64::NEG_INFINITY {
        return most;
    }
    most + libm::log(logs.iter().map(|l| libm::exp(l - most)).sum::<f64>() / logs.len() as f64)
}

/// What noise adds to the χ² of a test.
fn noise_of(test: &Test) -> f64 {
    test.allowed.iter().map(|a| (test.mean_noise / a).powi(2)).sum()
}

/// Expected χ² if nothing but noise were left. A variance estimated from few deviations is too small as often as it is too
/// large, and its inverse is too large in the mean: by ν/(ν − 2).
pub fn noise_chi2(tests: &[Test]) -> f64 {
    tests.iter().map(|t| noise_of(t) * (1.0 + 2.0 / (t.noise_freedom - 2.0).max(4.0))).sum()
}

/// Independent samples of all tests.
pub fn effective_count(tests: &[Test]) -> f64 {
    tests.iter().map(Test::independent_count).sum::<f64>().max(1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn weighed(mean_squares: &[f64], numbers: f64) -> Weighed {
        Weighed { mean_squares: mean_squares.to_vec(), numbers, implausibility: 0.0 }
    }

    #[test]
    fn less_left_is_more_evidence_and_numbers_cost() {
        let (much, little) = (weighed(&[9.0; 30], 0.0), weighed(&[1.1; 30], 1.0));
        assert!(little.log_evidence(1.0) > much.log_evidence(1.0) + 10.0);
        assert!(weighed(&[1.1; 30], 4.0).log_evidence(1.0) < little.log_evidence(1.0) - 4.0);
        // The same in fewer tests says less.
        let gain = |tests: usize| {
            weighed(&vec![1.1; tests], 1.0).log_evidence(1.0) - weighed(&vec![9.0; tests], 0.0).log_evidence(1.0)
        };
        assert!(gain(30) > gain(10) + 5.0);
    }

    #[test]
    fn an_error_within_noise_and_form_is_nothing_and_a_large_one_is_not() {
        let quiet = weighed(&[1.0; 30], 0.0);
        assert!(quiet.log_evidence_of_nothing(2.0, 0.0) > quiet.log_evidence(2.0));
        let loud = weighed(&[4.0; 30], 0.0);
        assert!(loud.log_evidence_of_nothing(2.0, 0.0) < loud.log_evidence(2.0) - 10.0);
        // Of an effect that explained thirty times as much it may be the form.
        assert!(loud.log_evidence_of_nothing(2.0, 90.0) > loud.log_evidence(2.0));
    }

    #[test]
    fn a_mean_of_exponentials_is_one_of_them_where_one_is_by_far_the_largest() {
        assert!((log_mean_exp(&[-1e4, 0.0]) + 2f64.ln()).abs() < 1e-12);
        assert_eq!(log_mean_exp(&[f64::NEG_INFINITY; 2]), f64::NEG_INFINITY);
    }
}
