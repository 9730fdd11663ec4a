//! Valve hysteresis: a blow-off valve that opens late and closes late.

use crate::dual::Real;
use crate::elements::{Describe, Prepare};
use crate::fault::Fault;
use crate::parameter::{Parameter, View};

/// F_h = F (1 + η (y_∞(F) − y)), τ dy/dt = S((|F| − F_0 + Δ (2y − 1))/b) − y, y_∞ = S((|F| − F_0)/b).
///
/// y is the valve's opening, S = ½ (1 + tanh) its characteristic. The FV curve holds the opening y_∞; a valve that is
/// behind it makes the force larger while it opens, and smaller while it closes. It opens at F_0 + Δ and closes at
/// F_0 − Δ however slow the motion.
///
/// *Play*: the valve stands where a force p had it, F_h = F exp(η S((|F| − F_0)/b) (F − p) sgn(F) / (|F| + |p|)). p follows F
/// with a play of P beyond which it takes the time τ: τ dp/dt = ⟨|F − p| − P |F|/(|F| + P)⟩ sgn(F − p). A valve so steep that
/// a small change of its opening takes much flow has a large η.
#[derive(Clone, Copy, Debug)]
pub struct ValveHysteresis {
    has_play: bool,
    play: f64,
    share: f64,
    middle: f64,
    half_width: f64,
    per_width: f64,
    pub(crate) per_time: f64,
}

/// Most rounds in which opening and what it feeds back on itself are brought together.
const ROUNDS: usize = 4;
/// P_0, N.
const SOFT: f64 = 10.0;
/// What a round may leave of the last so that three, and two, rounds do.
const SHRINKS: [f64; 2] = [0.06, 2e-3];

impl Describe for ValveHysteresis {
    const MEANING: &'static str = "blow-off valve that opens late and closes late: more force while speed rises";
    const PARAMETERS: &'static [Parameter] = &[
        Parameter::scalar(
            "valve_hysteresis_share",
            "-",
            &[0.15],
            (0.0, 3.0),
            "share of the force that lateness adds, eta",
        ),
        Parameter::scalar("valve_opening_force", "N", &[600.0], (1.0, 1e5), "force at which the valve opens"),
        Parameter::scalar(
            "valve_closing_ratio",
            "-",
            &[0.85],
            (0.3, 1.0),
            "force at which it closes over that at which it opens; 1: the time alone makes it late",
        ),
        Parameter::scalar("valve_time", "s", &[2e-3], (1e-4, 1.0), "time in which it moves, tau"),
        Parameter::scalar("valve_width", "N", &[100.0], (10.0, 1e5), "force over which it opens, b"),
        Parameter::choice(
            "valve_form",
            &["opening", "play"],
            "one opening that comes and goes late, or a valve that lags at every opening",
        ),
        Parameter::scalar("valve_play", "N", &[0.0], (0.0, 1e4), "play form: force that the valve does not follow, P"),
    ];
}

impl Prepare for ValveHysteresis {
    const OFF: Self = ValveHysteresis {
        has_play: false,
        play: 0.0,
        share: 0.0,
        middle: 0.0,
        half_width: 0.0,
        per_width: 1.0,
        per_time: 1.0,
    };

    fn prepare(p: &View) -> Result<Self, Fault> {
        let has_play = p.number(5) == 1.0;
        let (opens, closes) = (p.number(1), if has_play { p.number(1) } else { p.number(1) * p.number(2) });
        Ok(ValveHysteresis {
            has_play,
            play: p.number(6),
            share: p.number(0),
            middle: 0.5 * (opens + closes),
            half_width: 0.5 * (opens - closes),
            per_width: 1.0 / p.number(4),
            per_time: 1.0 / p.number(3),
        })
    }
}

/// S.
#[inline(always)]
fn opening<R: Real>(x: R) -> R {
    (x.tanh().plus(1.0)) * 0.5
}

impl ValveHysteresis {
    /// Play form: ⟨y⟩ sgn(F − p) at the end of a stage that p begins at, y = |F − p| − P |F|/(|F| + P); `per` is g/τ, and
    /// ⟨y⟩ = y²/(y + P_0) sets in softly.
    #[inline(always)]
    fn beyond<R: Real>(&self, force: R, p: R, per: f64) -> R {
        let behind = force - p;
        let size = force.abs();
        let play = size * size.plus(self.play + 1e-9).inverse() * self.play;
        let y = behind.abs() - play;
        if y.value() <= 0.0 {
            return R::constant(0.0);
        }
        // x = y − (g/τ) ⟨x⟩: what is left of y when the stage ends.
        let half = y.plus(-SOFT) * 0.5;
        let root = (half * half + y * ((1.0 + per) * SOFT)).sqrt();
        let left = (half + root) * (1.0 / (1.0 + per));
        let moved = left * left * left.plus(SOFT).inverse();
        if behind.value() < 0.0 { -moved } else { moved }
    }

    /// What the opening `y`, or the force where the valve stands, is drawn to.
    #[inline(always)]
    pub(crate) fn target<R: Real>(&self, force: R, y: R) -> R {
        if self.has_play {
            return y + self.beyond(force, y, 0.0);
        }
        let pressed = force.abs() + y * (2.0 * self.half_width);
        opening(pressed.plus(-self.middle - self.half_width) * self.per_width)
    }

    /// The opening at the end of an implicit stage that is `known` at its start; always inside 0 to 1. In the play form the
    /// force where the valve stands.
    #[inline(always)]
    pub(crate) fn stage<R: Real>(&self, force: R, known: R, g: f64) -> R {
        let per = g * self.per_time;
        let divide = 1.0 / (1.0 + per);
        if self.has_play {
            return known + self.beyond(force, known, per) * per;
        }
        // The characteristic is nowhere steeper than ½.
        let shrinks = self.half_width * self.per_width * per * divide;
        let spared = SHRINKS.iter().filter(|enough| shrinks < **enough).count();
        let rounds = if shrinks > 0.0 { ROUNDS - spared } else { 1 };
        let mut y = known;
        for _ in 0..rounds {
            y = (known + self.target(force, y) * per) * divide;
        }
        y
    }

    /// F_h at an opening.
    #[inline(always)]
    pub(crate) fn force<R: Real>(&self, force: R, y: R) -> R {
        let steady = opening(force.abs().plus(-self.middle) * self.per_width);
        if self.has_play {
            let size = force.abs();
            let lag = if force.value() < 0.0 { y - force } else { force - y };
            return force * (lag * (size + y.abs()).plus(1.0).inverse() * steady * self.share).exp();
        }
        force * ((steady - y) * self.share).plus(1.0)
    }
}
