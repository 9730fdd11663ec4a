//! Frequency-selective damping: fast strokes are damped less than slow ones of the same speed.

use crate::dual::Real;
use crate::elements::{Describe, Prepare};
use crate::fault::Fault;
use crate::parameter::{Parameter, View};
use crate::paths::bypass::{law, per_stated};

/// Three forms.
///
/// *Filter*: F_h = (1 − a) F + a p, τ dp/dt = F − p: the share a follows with a lag.
///
/// *Stroke*: a bypass that closes while a control chamber fills within a stroke: F_h = F (1 − a (1 − y)),
/// τ dz/dt = tanh(w/u_0) − z, y = smooth step of z tanh(w/u_0) from 0 to 1. After a reversal z is of the other stroke's
/// sign, so the bypass is open until z has changed over.
///
/// *Bypass*: oil flows past the valves while the control chamber of the stroke fills, as a velocity q_s (1 − y) r(F_h)/r(1 kN)
/// with the law r of a passage that is laminar below F_l (see [`crate::paths::bypass`]), y = z tanh(F_h/F_0) where that is positive, τ dz/dt = tanh(F_h/F_0) − z; the chamber of
/// the other stroke empties through a check valve ten times as fast.
#[derive(Clone, Copy, Debug)]
pub struct FrequencySelectiveDamping {
    is_stroke: bool,
    pub(crate) is_bypass: bool,
    flow: f64,
    laminar: f64,
    per_force: f64,
    share: f64,
    pub(crate) per_time: f64,
    per_velocity: f64,
}

impl Describe for FrequencySelectiveDamping {
    const MEANING: &'static str = "damping that is weaker in fast strokes than in slow ones of the same speed";
    const PARAMETERS: &'static [Parameter] = &[
        Parameter::choice(
            "fsd_form",
            &["filter", "stroke", "bypass"],
            "lagging share, share that returns within each stroke, or flow beside the valves that ends within each stroke",
        ),
        Parameter::scalar("fsd_share", "-", &[0.3], (0.0, 0.9), "share of the force that fast strokes lose, a"),
        Parameter::scalar("fsd_time", "s", &[0.05], (1e-3, 10.0), "time that tells fast from slow, tau"),
        Parameter::scalar(
            "fsd_velocity",
            "m/s",
            &[0.02],
            (1e-3, 1.0),
            "stroke form: speed that fills the control chamber, u_0",
        ),
        Parameter::scalar(
            "fsd_flow",
            "m/s",
            &[0.2],
            (0.0, 10.0),
            "bypass form: piston velocity that flows past at a hydraulic force of 1 kN, q_s",
        ),
        Parameter::scalar(
            "fsd_force",
            "N",
            &[50.0],
            (1.0, 1e4),
            "bypass form: hydraulic force that fills the control chamber, F_0",
        ),
        Parameter::scalar(
            "fsd_laminar_force",
            "N",
            &[20.0],
            (1.0, 1e5),
            "bypass form: hydraulic force below which its flow is laminar, F_l",
        ),
    ];
}

impl Prepare for FrequencySelectiveDamping {
    const OFF: Self = FrequencySelectiveDamping {
        is_stroke: false,
        is_bypass: false,
        flow: 0.0,
        laminar: 1.0,
        per_force: 1.0,
        share: 0.0,
        per_time: 1.0,
        per_velocity: 1.0,
    };

    fn prepare(p: &View) -> Result<Self, Fault> {
        Ok(FrequencySelectiveDamping {
            is_stroke: p.number(0) == 1.0,
            is_bypass: p.number(0) == 2.0,
            flow: p.number(4) * per_stated(p.number(6)),
            laminar: p.number(6),
            per_force: 1.0 / p.number(5),
            share: p.number(1),
            per_time: 1.0 / p.number(2),
            per_velocity: 1.0 / p.number(3),
        })
    }
}

/// How much faster the chamber of the other stroke empties.
const EMPTIES: f64 = 10.0;

impl FrequencySelectiveDamping {
    /// Bypass form: what z is drawn to.
    #[inline(always)]
    pub(crate) fn towards<R: Real>(&self, force: R) -> R {
        (force * self.per_force).tanh()
    }

    /// Bypass form: rate of z, 1/s.
    #[inline(always)]
    pub(crate) fn fills<R: Real>(&self, force: R, z: R) -> R {
        let towards = self.towards(force);
        let empties = if towards.value() * z.value() < 0.0 { EMPTIES } else { 1.0 };
        (towards - z * empties) * self.per_time
    }

    /// Bypass form: z after an implicit stage that is `known` at its start.
    #[inline(always)]
    pub(crate) fn filled<R: Real>(&self, force: R, known: R, g: f64) -> R {
        let towards = self.towards(force);
        let per = g * self.per_time;
        // The sign of z is that of the sum, whichever chamber it is.
        let sum = known + towards * per;
        let empties = if towards.value() * sum.value() < 0.0 { EMPTIES } else { 1.0 };
        sum * (1.0 / (1.0 + per * empties))
    }

    /// Bypass form: flow, m/s.
    #[inline(always)]
    pub(crate) fn passes<R: Real>(&self, force: R, z: R) -> R {
        let closed = z * self.towards(force);
        let open = law(force, self.laminar) * self.flow;
        if closed.value() <= 0.0 { open } else { open - open * closed }
    }

    /// What the state is drawn to: F, or tanh(w/u_0).
    #[inline(always)]
    pub(crate) fn target<R: Real>(&self, force: R, w: R) -> R {
        if self.is_stroke { (w * self.per_velocity).tanh() } else { force }
    }

    /// F_h at a state.
    #[inline(always)]
    pub(crate) fn force<R: Real>(&self, force: R, w: R, state: R) -> R {
        if !self.is_stroke {
            return force * (1.0 - self.share) + state * self.share;
        }
        let along = state * (w * self.per_velocity).tanh();
        let at = along.value();
        let closed = if at <= 0.0 {
            R::constant(0.0)
        } else if at >= 1.0 {
            R::constant(1.0)
        } else {
            along * along * (-(along * 2.0)).plus(3.0)
        };
        force * (closed * self.share).plus(1.0 - self.share)
    }
}
