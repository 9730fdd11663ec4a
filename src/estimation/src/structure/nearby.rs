//! Residuals near an explanation that is known exactly, by the cheap integration with its error there corrected.
//!
//! Derivatives are reused from there as far as they are known.
//!
//! What is compared in an iteration differs in little from where it begins, and so does the error of the integration
//! (a defect correction: Stetter, Numer. Math. 29, 1978).

use crate::hypothesis::{Hypothesis, Residual};
use crate::refit::Refit;
use crate::samples::Test;
use crate::sensitivity::Accuracy;
use dashpot_core::element;
use nalgebra::DMatrix;

/// Where a round begins.
pub struct Nearby<'a> {
    /// What the cheap integration is off there, weighted.
    off: Residual,
    /// The cheap integration.
    accuracy: Accuracy,
    /// The derivatives there.
    jacobian: &'a DMatrix<f64>,
}

impl<'a> Nearby<'a> {
    /// At a refitted explanation; `None` where it makes no finite force.
    pub fn new(hypothesis: &Hypothesis, at: &'a Refit, tests: &[Test]) -> Option<Nearby<'a>> {
        // Where the explanation has a series spring, the correction holds what one step a sample misses of it.
        let has_series = hypothesis.base.is_on(element!("series_compliance"));
        let accuracy = if has_series { Accuracy::Derivatives } else { Accuracy::Cheap };
        let off = &at.residual - hypothesis.residual_by(accuracy, tests, &at.theta)?;
        Some(Nearby { off, accuracy, jacobian: &at.jacobian })
    }

    /// Weighted residuals of an explanation that extends it.
    pub fn residual(&self, hypothesis: &Hypothesis, tests: &[Test], theta: &[f64]) -> Option<Residual> {
        Some(hypothesis.residual_by(self.accuracy, tests, theta)? + &self.off)
    }

    /// Derivatives of an explanation that extends it: over its fresh numbers by differences from the residuals there, over
    /// the others as they were.
    pub fn jacobian(
        &self,
        hypothesis: &Hypothesis,
        tests: &[Test],
        theta: &[f64],
        residual: &Residual,
    ) -> Option<DMatrix<f64>> {
        let first = self.jacobian.ncols();
        let mut jacobian = DMatrix::zeros(residual.len(), theta.len());
        jacobian.columns_mut(0, first).copy_from(self.jacobian);
        for k in first..theta.len() {
            let column = hypothesis.column(theta, residual, k, |theta| self.residual(hypothesis, tests, theta))?;
            jacobian.set_column(k, &column);
        }
        Some(jacobian)
    }
}
