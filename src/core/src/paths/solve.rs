//! The one scalar equation of a stage or an instant: which velocity w of the oil answers R(w, F_d(w)) = 0.

use crate::dual::Dual;
use crate::elements::Elements;

/// Most rounds; two are common, and each narrows a bracket once there is one.
const ROUNDS: usize = 40;
/// Householder steps inside a piece of the FV curve: the rounds mend what they leave.
const STEPS: usize = 3;

/// Relative distance that counts as beside.
const NEAR: f64 = 1e-2;

/// Finds w from a guess.
///
/// In each round R is linearised in w and f apart; the FV curve then answers a w + F_d(w) = r exactly, knees and all.
/// R rises with both (where rounding or a switching element has it otherwise the slopes `least` stand in), so the answer
/// of each round lies on the right side of the last, and a bracket closes over those that do not settle.
pub fn oil_velocity(
    e: &Elements,
    guess: f64,
    least: [f64; 2],
    tolerance: f64,
    residual: impl Fn(Dual<2>, Dual<2>) -> Dual<2>,
) -> f64 {
    let mut w = guess;
    let (mut low, mut high) = (f64::NEG_INFINITY, f64::INFINITY);
    for _ in 0..ROUNDS {
        let curve = e.fv_curve.at(w);
        let r = residual(Dual::along(w, 0), Dual::along(curve.value, 1));
        if r.value > 0.0 {
            high = w;
        } else if r.value < 0.0 {
            low = w;
        } else {
            break;
        }
        let (by_w, by_curve) = (r.slope(0).max(least[0]), r.slope(1).max(least[1]));
        let a = by_w / by_curve;
        let (mut next, _) = e.fv_curve.solve::<STEPS>(a, a * w + curve.value - r.value / by_curve);
        // Beside the answer, where the curve was solved as well as its own steps can, Newton's step is closer.
        if (next - w).abs() <= NEAR * (1e-3 + w.abs()) {
            next = w - r.value / (by_w + by_curve * curve.slope);
        }
        if !(next > low && next < high) {
            next = if low.is_finite() && high.is_finite() {
                0.5 * (low + high)
            } else {
                // Rounding beside a steep place: the plain Newton step.
                w - r.value / (by_w + by_curve * curve.slope)
            };
        }
        let moved = (next - w).abs();
        w = next;
        if moved <= tolerance * (1e-3 + w.abs()) {
            break;
        }
    }
    w
}
