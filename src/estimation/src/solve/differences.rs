//! Derivatives by finite differences, for residuals that supply no derivatives.

use super::{Bounds, Problem};
use nalgebra::DMatrix;

/// Relative step. At the cube root of the rounding unit, the errors due to rounding and curvature are equal.
const STEP: f64 = 6e-6;
/// Smallest assumed magnitude of a parameter, so that a parameter of zero also has a step.
const SMALLEST: f64 = 1e-3;

/// Computes central differences of the residuals of one block at `x`, where they are `middle`. A difference is one-sided at
/// a bound, or if the model is invalid on one side. Returns `None` if the model is invalid on both sides for a parameter.
pub(super) fn central(
    (problem, block): (&dyn Problem, usize),
    (x, middle): (&[f64], &[f64]),
    bounds: &Bounds,
) -> Option<DMatrix<f64>> {
    let residuals = |x: &[f64]| problem.prepare(x)?.residuals(block);
    let mut jacobian = DMatrix::zeros(middle.len(), x.len());
    for i in 0..x.len() {
        let h = STEP * x[i].abs().max(SMALLEST);
        let at = |moved: f64| {
            let mut near = x.to_vec();
            near[i] = moved;
            let inside = moved >= bounds.low[i] && moved <= bounds.high[i];
            inside.then(|| residuals(&near)).flatten().filter(|r| r.iter().all(|v| v.is_finite()))
        };
        let (up, down) = (at(x[i] + h), at(x[i] - h));
        let width = (x[i] + h) - (x[i] - h);
        let (high, low, width) = match (&up, &down) {
            (Some(up), Some(down)) => (up.as_slice(), down.as_slice(), width),
            (Some(up), None) => (up.as_slice(), middle, (x[i] + h) - x[i]),
            (None, Some(down)) => (middle, down.as_slice(), x[i] - (x[i] - h)),
            (None, None) => return None,
        };
        for r in 0..middle.len() {
            jacobian[(r, i)] = (high[r] - low[r]) / width;
        }
    }
    Some(jacobian)
}
