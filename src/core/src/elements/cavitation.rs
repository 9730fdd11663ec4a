//! Cavitation: the gas pressure limits the force of one stroke, and the void that opens has to be closed again.

use crate::dual::Real;
use crate::elements::{Describe, Prepare};
use crate::fault::Fault;
use crate::parameter::{Parameter, View};

/// Towards the capped side (p = σ F_h, σ = 1 for rebound, −1 for compression) the oil carries no more than the cap C:
/// what the driven stroke exceeds opens a void, of depth e as a stroke.
///
/// ```text
/// u = w + dq/dt + σ de/dt
/// de/dt = R(p − T)/r − R(T − p)/r · e/(e + e_0)
/// T = C while the driven end moves in the capped direction; κ C on its return while there is a void
/// ```
///
/// R is a ramp and r a resistance so small that the force keeps to T within a hundredth of C at 1 m/s. While a void
/// lasts the valves pass what the pressure T drives through them, so it closes by flow and by motion. κ = 1 is a void
/// behind which the gas keeps pushing, κ = 0 one on whose return the rod moves freely.
#[derive(Clone, Copy, Debug)]
pub struct Cavitation {
    /// C.
    cap: f64,
    /// σ.
    pub(crate) sign: f64,
    /// 1 − κ.
    lost: f64,
    /// 1/r.
    per_resistance: f64,
}

/// r is C over so many metres per second.
const SLACK: f64 = 100.0;
/// The ramp sets in over this share of C.
const ROUNDING: f64 = 2e-3;
/// Speed of the driven end over which T changes, m/s.
const TURNING: f64 = 3e-3;
/// e_0: a void smaller than this, m, closes more slowly.
const CLOSED: f64 = 1e-5;

const FORCE: usize = 0;
const SIDE: usize = 1;
const RETURN: usize = 2;

impl Describe for Cavitation {
    const MEANING: &'static str =
        "cavitation: the hydraulic force of one stroke is capped, and a void remains to be closed";
    const PARAMETERS: &'static [Parameter] = &[
        Parameter::scalar("cavitation_force", "N", &[1500.0], (10.0, 1e6), "largest hydraulic force of that stroke, C"),
        Parameter::choice("cavitation_side", &["compression", "rebound"], "stroke whose force is capped"),
        Parameter::scalar(
            "cavitation_return",
            "-",
            &[0.0],
            (0.0, 1.0),
            "share of the cap that stays on the return while the void closes: 1 gas pushes on, 0 dead stroke",
        ),
    ];
}

impl Prepare for Cavitation {
    const OFF: Self = Cavitation { cap: 1.0, sign: 1.0, lost: 0.0, per_resistance: 0.0 };

    fn prepare(p: &View) -> Result<Self, Fault> {
        let cap = p.number(FORCE);
        let sign = if p.number(SIDE) == 1.0 { 1.0 } else { -1.0 };
        Ok(Cavitation { cap, sign, lost: 1.0 - p.number(RETURN), per_resistance: SLACK / cap })
    }
}

/// A void is never less than closed.
#[inline(always)]
fn opened<R: Real>(void: R) -> R {
    if void.value() > 0.0 { void } else { R::constant(0.0) }
}

/// e/(e + e_0).
#[inline(always)]
fn share_open<R: Real>(void: R) -> R {
    let e = opened(void);
    e * e.plus(CLOSED).inverse()
}

impl Cavitation {
    /// p − T: how far the force is beyond what the void lets stand; `velocity` is that of the driven end.
    #[inline(always)]
    fn excess<R: Real>(&self, force: R, velocity: R, void: R) -> R {
        let returning = (-(velocity * (self.sign / TURNING)).tanh()).plus(1.0) * (0.5 * self.lost);
        let threshold = (-(returning * share_open(void))).plus(1.0) * self.cap;
        force * self.sign - threshold
    }

    /// R(x)/r, smooth.
    #[inline(always)]
    fn ramp<R: Real>(&self, x: R) -> R {
        let width = ROUNDING * self.cap;
        let at = x.value();
        let ramp = if at <= 0.0 {
            R::constant(0.0)
        } else if at < width {
            x * x * (0.5 / width)
        } else {
            x.plus(-0.5 * width)
        };
        ramp * self.per_resistance
    }

    /// de/dt at a hydraulic force.
    #[inline(always)]
    pub(crate) fn rate<R: Real>(&self, force: R, velocity: R, void: R) -> R {
        let excess = self.excess(force, velocity, void);
        self.ramp(excess) - self.ramp(-excess) * share_open(void)
    }

    /// The void at the end of an implicit stage that is `known` at its start: e − g de/dt = E.
    #[inline(always)]
    pub(crate) fn stage<R: Real>(&self, force: R, velocity: R, known: R, g: f64) -> R {
        let excess = self.excess(force, velocity, known);
        if excess.value() >= 0.0 {
            return known + self.ramp(excess) * g;
        }
        if known.value() <= 0.0 {
            return known;
        }
        // e² + (e_0 − E + g R/r) e = E e_0
        let half = ((self.ramp(-excess) * g - known).plus(CLOSED)) * 0.5;
        let product = known * CLOSED;
        let root = (half * half + product).sqrt();
        if half.value() > 0.0 { product * (half + root).inverse() } else { root - half }
    }
}
