//! The one scalar equation of a stage or an instant: which velocity w of the oil answers R(w, F_d(w)) = 0.

use super::Paths;
use crate::curve::Value;
use crate::tables::{ForceLaw, Tables};

/// Most rounds; two are common. Past [`PATIENCE`] every other one takes four tenths of what is left at least, so that the
/// bracket has shrunk by nine orders when they end.
pub const ITERATIONS: usize = 96;
/// Householder steps inside a piece of the FV curve: the rounds mend what they leave.
const STEPS: usize = 2;

/// Relative distance within which Newton's step is used, and in how many iterations at most.
///
/// Beyond them the steps oscillate, and every other one halves the bracket.
const NEAR: f64 = 1e-2;
const PATIENCE: usize = 12;
/// Rounds after which steps across standstill stop there.
const REST: usize = 3;
/// Relative step at which Newton's method has begun to settle.
const SETTLED: f64 = 1e-4;

/// What R may leave for the straight step, as a relative change of the velocity of the mass alone. Where the curve is steep and
/// the oil behind it soft, a hardly visible step in w is a long one of the mass: straight on over a knee it would throw it.
const STRAIGHT: f64 = 1e-4;

/// Most halves of the velocity in which the middle of a bracket is sought: as many as its digits tell apart. So many are taken
/// only where the curve rises by half the bracket within rounding.
const HALVES: usize = 64;

/// Share of the derivative by which a step was found that has to be the equation's own for the straight step to be taken.
const OWN: f64 = 0.5;

/// R and its derivatives over w and over F_d.
#[derive(Clone, Copy, Debug)]
pub struct Residual {
    /// R.
    pub value: f64,
    /// ∂R/∂w.
    pub by_w: f64,
    /// ∂R/∂F_d.
    pub by_curve: f64,
}

/// R, and what else is found on the way to it.
pub trait Equation {
    /// What is found beside R.
    type Seen;
    /// R at a velocity and the force of the FV curve there; puts what is found beside it where that is kept.
    fn evaluate(&self, w: f64, curve: f64, seen: &mut Self::Seen) -> Residual;
}

impl<F: Fn(f64, f64) -> Residual> Equation for F {
    type Seen = ();
    #[inline(always)]
    fn evaluate(&self, w: f64, curve: f64, _: &mut ()) -> Residual {
        self(w, curve)
    }
}

/// The answer: R was looked at beside it, and `step` leads from there to it.
pub struct Found {
    /// Where R was looked at last.
    pub w: f64,
    /// What is left to the answer, so short that all goes straight.
    pub step: f64,
    /// The FV curve there.
    pub curve: Value,
}

impl Found {
    /// w.
    pub fn root(&self) -> f64 {
        self.w + self.step
    }
}

/// One end of the bracket: a velocity and the FV curve's force there.
#[derive(Clone, Copy)]
struct End {
    w: f64,
    curve: f64,
}

/// Finds w from a guess in at most so many iterations ([`ITERATIONS`]; with none the guess is the root).
///
/// Leaves in `seen` the result of the last evaluation of R. `tolerance` is the relative size of the last step: its
/// error is of its square.
///
/// In each round R is linearised in w and f apart; the FV curve then answers a w + F_d(w) = r, knees and all. R rises
/// with both (where rounding or a switching element has it otherwise the derivatives `least` stand in), so the answer of each
/// round lies on the right side of the last, and a bracket closes over those that do not settle.
///
/// # Why it always ends at an answer
/// R is continuous and changes its sign: it follows the velocity of the mass (or the piston), which without end follows w.
/// Steps that do not settle are replaced by halves of the bracket, in the measure a w + F_d(w) in which neither a steep nor a
/// level piece of the curve is long. No answer leaves the bracket: the straight step that is left at the end is held
/// inside, so that a derivative is never carried beyond the places where R was looked at.
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
        // Newton's steps shrink by their squares, so the next would be about step³/last².
        let short = r.value.abs() <= STRAIGHT * scale * by_w;
        let settled = size <= SETTLED * scale && size * (size * size) <= tolerance * (last * last) * (SETTLED * scale);
        if short && (size <= tolerance * scale || settled) || round == rounds {
            let inside = w + step > low.w && w + step < high.w;
            // Only where the equation's own derivatives lead: where it falls, as behind a friction that falls with speed, those that
            // stand in for them have all else that goes straight on by that step thrown far off.
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
        // Beside the answer, where the curve was solved as well as its own steps can, Newton's step is closer.
        if round >= PATIENCE || size > NEAR * scale {
            (next, _) = e.fv_curve.solve::<STEPS>(a, a * w + curve.value - r.value / by_curve);
        }
        // The laws of air and valves are steepest at rest and level out to both sides: from there the steps do not swing.
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

/// The middle of a bracket; while one end is open, twice as far out in every round.
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

/// Where the measure a w + F_d(w) is in the middle of a bracket, within a tenth of it.
///
/// The curve's own steps do not lead there in a piece that is level at one end and a thousand times steeper than a in the
/// mean, and a middle that lies at the same end in every round closes no bracket.
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
