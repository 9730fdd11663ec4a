//! Residuals near an explanation that is known exactly: by the cheap integration, corrected by what that is off there.
//!
//! What is compared in a round differs in little from where the round begins, and so does the error of the integration
//! (a defect correction: Stetter, Numer. Math. 29, 1978).

use super::hypothesis::{Hypothesis, Residual};
use super::refit::Refit;
use super::samples::Test;
use crate::identification::sensitivity::Accuracy;

/// What the cheap integration is off where a round begins, weighted.
pub struct Nearby {
    off: Residual,
}

impl Nearby {
    /// At a refitted explanation; `None` where it makes no finite force.
    pub fn new(hypothesis: &Hypothesis, at: &Refit, tests: &[Test]) -> Option<Nearby> {
        Some(Nearby { off: &at.residual - hypothesis.residual_by(Accuracy::Cheap, tests, &at.theta)? })
    }

    /// Weighted residuals of an explanation that extends it.
    pub fn residual(&self, hypothesis: &Hypothesis, tests: &[Test], theta: &[f64]) -> Option<Residual> {
        Some(hypothesis.residual_by(Accuracy::Cheap, tests, theta)? + &self.off)
    }
}
