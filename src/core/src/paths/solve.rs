//! The one scalar equation of a stage or an instant: which velocity w of the oil answers R(w, F_d(w)) = 0.

use crate::elements::Elements;

/// Most rounds; two are common, and each narrows a bracket once there is one.
const ROUNDS: usize = 40;
/// Householder steps inside a piece of the FV curve: the rounds mend what they leave.
const STEPS: usize = 2;

/// Relative distance within which Newton's step is taken, and in how many rounds at most: beyond them the steps go to
/// and fro, and every other one halves the bracket.
const NEAR: f64 = 1e-2;
const PATIENCE: usize = 4;

/// R and its slopes over w and over F_d.
#[derive(Clone, Copy, Debug)]
pub struct Residual {
    /// R.
    pub value: f64,
    /// ∂R/∂w.
    pub by_w: f64,
    /// ∂R/∂F_d.
    pub by_curve: f64,
}

/// Finds w from a guess. `tolerance` is the relative step that is the last: its own error is of the square.
///
/// In each round R is linearised in w and f apart; the FV curve then answers a w + F_d(w) = r, knees and all. R rises
/// with both (where rounding or a switching element has it otherwise the slopes `least` stand in), so the answer of each
/// round lies on the right side of the last, and a bracket closes over those that do not settle.
#[inline(always)]
pub fn oil_velocity(
    e: &Elements,
    guess: f64,
    least: [f64; 2],
    tolerance: f64,
    residual: impl Fn(f64, f64) -> Residual,
) -> f64 {
    let mut w = guess;
    let (mut low, mut high) = (f64::NEG_INFINITY, f64::INFINITY);
    for round in 0..ROUNDS {
        let curve = e.fv_curve.at(w);
        let r = residual(w, curve.value);
        if r.value > 0.0 {
            high = w;
        } else if r.value < 0.0 {
            low = w;
        } else {
            break;
        }
        let by_w = if r.by_w > least[0] { r.by_w } else { least[0] };
        let by_curve = if r.by_curve > least[1] { r.by_curve } else { least[1] };
        let newton = w - r.value / (by_w + by_curve * curve.slope);
        if (newton - w).abs() <= tolerance * (1e-3 + w.abs()) {
            return newton;
        }
        let mut next = newton;
        // Beside the answer, where the curve was solved as well as its own steps can, Newton's step is closer.
        if round >= PATIENCE || (newton - w).abs() > NEAR * (1e-3 + w.abs()) {
            let per = 1.0 / by_curve;
            let a = by_w * per;
            (next, _) = e.fv_curve.solve::<STEPS>(a, a * w + curve.value - r.value * per);
        }
        // The laws of air and valves are steepest at rest and level out to both sides: from there the steps do not swing.
        if round >= 2 && next * w < 0.0 {
            next = 0.0;
        }
        let bracketed = low.is_finite() && high.is_finite();
        if !(next > low && next < high) {
            // Rounding beside a steep place: halves, or the plain Newton step.
            next = if bracketed { 0.5 * (low + high) } else { newton };
        } else if round >= PATIENCE && round % 2 == 0 && bracketed {
            next = 0.5 * (low + high);
        }
        w = next;
    }
    w
}
