//! The scalar equation of a stage or an instant, R(w, F_d(w)) = 0, for the oil velocity w at the valves; F_d is the FV
//! curve.

use super::Paths;
use crate::curve::Value;
use crate::tables::{ForceLaw, Tables};

/// Largest number of iterations for the oil velocity; usually two suffice. After [`PATIENCE`] iterations, every other
/// iteration shortens the bracket by at least four tenths. At the end, the bracket is shorter by nine orders of
/// magnitude.
pub const ITERATIONS: usize = 96;
/// Number of Householder steps inside a piece of the FV curve. The iterations correct the error of these steps.
const STEPS: usize = 2;

/// Largest Newton step, relative to the oil velocity, that the iteration uses. Instead of a larger step, it solves the
/// linearized equation with the whole FV curve, including the knees.
const NEAR: f64 = 1e-2;
/// Number of iterations after which the steps probably oscillate, so that every other iteration bisects the bracket.
const PATIENCE: usize = 12;
/// Number of iterations after which a step of the oil velocity that would change its sign ends at zero velocity.
const REST: usize = 3;
/// Size of a step, relative to the oil velocity, below which Newton's method is assumed to converge quadratically.
const SETTLED: f64 = 1e-4;

/// Largest residual R of the stage equation at which [`oil_velocity`] accepts a linear last step. R is divided by its
/// derivative with respect to the oil velocity w, and is relative to w.
///
/// With a steep curve and soft oil, a small step in w causes a large step of the mass. A linear step across a knee
/// would then cause a large error.
const STRAIGHT: f64 = 1e-4;

/// Largest number of bisections in [`middle`]: the number of binary digits of a velocity. All are necessary only if
/// half of the FV curve's rise over the bracket lies within a rounding error of the velocity.
const HALVES: usize = 64;

/// Smallest ratio of two derivatives at which [`oil_velocity`] accepts a linear last step.
///
/// It is the ratio of the exact derivative of the residual R with respect to the oil velocity to the derivative that
/// the iteration uses.
const OWN: f64 = 0.5;

/// Residual R of the equation for the oil velocity w, and its derivatives with respect to w and the FV force F_d.
#[derive(Clone, Copy, Debug)]
pub struct Residual {
    /// Residual R: 0 at the solution.
    pub value: f64,
    /// Derivative of R with respect to the oil velocity w at constant FV force.
    pub by_w: f64,
    /// Derivative of R with respect to the FV force F_d at constant oil velocity.
    pub by_curve: f64,
}

/// An equation R(w, F_d) = 0 for the oil velocity w with the FV force F_d(w), and the further results of its
/// evaluation.
pub trait Equation {
    /// Further results of an evaluation, besides the residual.
    type Seen;
    /// Evaluates the residual R at the oil velocity `w`, m/s, and the FV curve's force there, `curve`, N. Stores the
    /// further results in `seen`.
    fn evaluate(&self, w: f64, curve: f64, seen: &mut Self::Seen) -> Residual;
}

impl<F: Fn(f64, f64) -> Residual> Equation for F {
    type Seen = ();
    #[inline(always)]
    fn evaluate(&self, w: f64, curve: f64, _: &mut ()) -> Residual {
        self(w, curve)
    }
}

/// The solution for the oil velocity: the last evaluated velocity plus the remaining `step`.
pub struct Found {
    /// Oil velocity of the last evaluation of the equation, m/s.
    pub w: f64,
    /// Remaining step to the solution, m/s, short enough to be linear.
    pub step: f64,
    /// Force of the FV curve at `w`, N, and its derivative.
    pub curve: Value,
}

impl Found {
    /// Returns the solution, the oil velocity, m/s.
    pub fn root(&self) -> f64 {
        self.w + self.step
    }
}

/// One end of the bracket of the oil velocity: a velocity, m/s, and the FV curve's force there, N.
#[derive(Clone, Copy)]
struct End {
    w: f64,
    curve: f64,
}

/// Finds the oil velocity w, m/s, with R(w, F_d(w)) = 0 from a guess; F_d is the FV curve. With 0 `rounds`, the guess
/// is the solution.
///
/// `rounds` is the largest number of iterations, usually [`ITERATIONS`].
/// `seen` receives the further results of the last evaluation of R. `tolerance` is the relative size of the last step.
/// The remaining error is about the square of this step.
///
/// Each iteration linearizes R in w and in F_d separately. It then solves a w + F_d(w) = r with the FV curve and all
/// its knees. R increases with w and with F_d. If a rounding error or a switching element makes R decrease, the
/// derivatives `least` are used instead. Therefore each solution lies on the correct side of the previous solution, and
/// the bracket shrinks even if the iterations oscillate.
///
/// # Convergence
/// R is continuous and changes its sign, because the velocity of the mass (or the piston) in R grows with w without
/// bound. Steps that do not converge are replaced by bisections of the bracket. The bisections use the measure a w +
/// F_d(w), in which steep pieces and horizontal pieces of the curve are short. No iterate leaves the bracket. The
/// linear last step also stays inside, so no derivative is extrapolated beyond the evaluated velocities.
#[inline(always)]
pub fn oil_velocity<Q: Equation>(
    e: &Paths<impl Tables>,
    guess: f64,
    rounds: usize,
    least: [f64; 2],
    tolerance: f64,
    equation: &Q,
    seen: &mut Q::Seen,
) -> Found {
    let mut w = guess;
    let mut low = End { w: f64::NEG_INFINITY, curve: 0.0 };
    let mut high = End { w: f64::INFINITY, curve: 0.0 };
    let mut last = 0.0;
    let mut round = 0;
    loop {
        let curve = e.fv_curve.evaluate(w);
        let r = equation.evaluate(w, curve.value, seen);
        let by_w = if r.by_w > least[0] { r.by_w } else { least[0] };
        let by_curve = if r.by_curve > least[1] { r.by_curve } else { least[1] };
        let step = -r.value / (by_w + by_curve * curve.derivative);
        let (size, scale) = (step.abs(), 1e-3 + w.abs());
        // Newton steps decrease quadratically, so the next step would be about step³/last², where last is the previous
        // step.
        let short = r.value.abs() <= STRAIGHT * scale * by_w;
        let settled = size <= SETTLED * scale && size * (size * size) <= tolerance * (last * last) * (SETTLED * scale);
        if short && (size <= tolerance * scale || settled) || round == rounds {
            let inside = w + step > low.w && w + step < high.w;
            // Accept the linear step only with the exact derivatives of the equation. Where the residual R decreases,
            // for example because friction decreases with speed, the derivatives `least` replace the exact ones. A
            // linear extrapolation of the other quantities would then have a large error.
            let own = r.by_w + r.by_curve * curve.derivative > OWN * (by_w + by_curve * curve.derivative);
            let step = if inside && own && round < rounds { step } else { 0.0 };
            return Found { w, step, curve };
        }
        let here = End { w, curve: curve.value };
        if r.value > 0.0 {
            high = here;
        } else {
            low = here;
        }
        let newton = w + step;
        let mut next = newton;
        let a = by_w / by_curve;
        // Far from the solution, the linearized equation is solved with the whole FV curve. Near the solution, a Newton
        // step has a smaller error than `solve`.
        if round >= PATIENCE || size > NEAR * scale {
            (next, _) = e.fv_curve.solve::<STEPS>(a, a * w + curve.value - r.value / by_curve);
        }
        // The laws of air and valves are steepest at zero velocity and less steep on both sides, so steps from there do
        // not oscillate.
        if round >= REST && next * w < 0.0 {
            next = 0.0;
        }
        let inside = next > low.w && next < high.w;
        if !inside || round >= PATIENCE && round % 2 == 0 {
            next = between(e, a, low, high, next, round);
        }
        last = (next - w).abs();
        w = next;
        round += 1;
    }
}

/// Returns an oil velocity inside a bracket: that of [`middle`], or `next` if an end of the bracket is infinite.
///
/// From iteration [`PATIENCE`] on, with one infinite end, returns a point beyond the finite end instead. Its distance
/// from that end is the distance of the end from zero velocity, plus 1 mm/s.
#[cold]
#[inline(never)]
fn between(e: &Paths<impl Tables>, a: f64, low: End, high: End, next: f64, round: usize) -> f64 {
    match (low.w.is_finite(), high.w.is_finite()) {
        (true, true) => middle(e, a, low, high),
        (true, false) if round >= PATIENCE => low.w + (low.w.abs() + 1e-3),
        (false, true) if round >= PATIENCE => high.w - (high.w.abs() + 1e-3),
        _ => next,
    }
}

/// Finds the velocity w at which a w + F_d(w) is the mean of its values at both ends of a bracket. F_d is the FV curve,
/// and `a` the ratio of the residual's derivatives with respect to w and F_d, N s/m. The tolerance is a tenth of the
/// difference of these values.
///
/// Householder steps fail in a piece that is horizontal at one end but on average a thousand times steeper than `a`.
/// Their result would lie at the same end in every iteration and would not shrink the bracket.
fn middle(e: &Paths<impl Tables>, a: f64, low: End, high: End) -> f64 {
    let sum = a * (low.w + high.w) + low.curve + high.curve;
    let near = 0.2 * (a * (high.w - low.w) + (high.curve - low.curve));
    let (mut at, mut value) = e.fv_curve.solve::<STEPS>(a, 0.5 * sum);
    let (mut left, mut right) = (low.w, high.w);
    for _ in 0..HALVES {
        let off = 2.0 * (a * at + value.value) - sum;
        if at > low.w && at < high.w && off.abs() <= near {
            break;
        }
        if at > left && at < right {
            if off > 0.0 {
                right = at;
            } else {
                left = at;
            }
        }
        at = 0.5 * (left + right);
        value = e.fv_curve.evaluate(at);
    }
    at
}
