//! Residuals near a refitted hypothesis, from the low-accuracy integration and a correction of its error at that
//! hypothesis.
//!
//! Known derivatives of the refitted hypothesis are reused.
//!
//! Within an iteration of the search, the compared hypotheses differ little from the refitted one. Their integration
//! errors are therefore similar, and one correction serves all (a defect correction: Stetter, Numer. Math. 29, 1978).

use crate::hypothesis::{Hypothesis, Residual};
use crate::refit::Refit;
use crate::samples::Test;
use crate::sensitivity::Accuracy;
use dashpot_core::element;
use nalgebra::DMatrix;

/// Refitted hypothesis at which an iteration begins, with the error of its low-accuracy integration.
pub struct Nearby<'a> {
    /// Weighted residuals of the refit minus the residuals by the low-accuracy integration at the refitted parameters.
    off: Residual,
    /// Accuracy of the low-accuracy integration.
    accuracy: Accuracy,
    /// Derivatives of the weighted residuals with respect to the refitted parameters.
    jacobian: &'a DMatrix<f64>,
}

impl<'a> Nearby<'a> {
    /// Computes the correction at a refitted hypothesis. Returns `None` if the model gives no finite force.
    pub fn new(hypothesis: &Hypothesis, at: &'a Refit, tests: &[Test]) -> Option<Nearby<'a>> {
        // With a series spring, one substep per sample suffices instead of two, because the correction contains the
        // error of the substep.
        let has_series = hypothesis.base.is_on(element!("series_compliance"));
        let accuracy = if has_series { Accuracy::Derivatives } else { Accuracy::Cheap };
        let off = &at.residual - hypothesis.residual_by(accuracy, tests, &at.theta)?;
        Some(Nearby { off, accuracy, jacobian: &at.jacobian })
    }

    /// Computes the corrected weighted residuals of a hypothesis that extends the refitted one by further parameters.
    /// Returns `None` if the model gives no finite force.
    pub fn residual(&self, hypothesis: &Hypothesis, tests: &[Test], theta: &[f64]) -> Option<Residual> {
        Some(hypothesis.residual_by(self.accuracy, tests, theta)? + &self.off)
    }

    /// Computes derivatives of the weighted residuals of a hypothesis that extends the refitted one. Finite differences
    /// give the columns of its new parameters. The other columns are those of the refit. Returns `None` if the model
    /// gives no finite force.
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
