//! Frequency-selective damping: fast strokes are damped less than slow ones of the same speed.

use crate::dual::Real;
use crate::elements::{Describe, Prepare};
use crate::fault::Fault;
use crate::parameter::{Parameter, View};

/// Two forms.
///
/// *Filter*: F_h = (1 − a) F + a p, τ dp/dt = F − p: the share a follows with a lag.
///
/// *Stroke*: a bypass that closes while a control chamber fills within a stroke: F_h = F (1 − a (1 − y)),
/// τ dz/dt = tanh(w/u_0) − z, y = smooth step of z tanh(w/u_0) from 0 to 1. After a reversal z is of the other stroke's
/// sign, so the bypass is open until z has changed over.
#[derive(Clone, Copy, Debug)]
pub struct FrequencySelectiveDamping {
    is_stroke: bool,
    share: f64,
    pub(crate) per_time: f64,
    per_velocity: f64,
}

impl Describe for FrequencySelectiveDamping {
    const MEANING: &'static str = "damping that is weaker in fast strokes than in slow ones of the same speed";
    const PARAMETERS: &'static [Parameter] = &[
        Parameter::choice("fsd_form", &["filter", "stroke"], "lagging share, or bypass that closes within each stroke"),
        Parameter::scalar("fsd_share", "-", &[0.3], (0.0, 0.9), "share of the force that fast strokes lose, a"),
        Parameter::scalar("fsd_time", "s", &[0.05], (1e-3, 10.0), "time that tells fast from slow, tau"),
        Parameter::scalar(
            "fsd_velocity",
            "m/s",
            &[0.02],
            (1e-3, 1.0),
            "stroke form: speed that fills the control chamber, u_0",
        ),
    ];
}

impl Prepare for FrequencySelectiveDamping {
    const OFF: Self = FrequencySelectiveDamping { is_stroke: false, share: 0.0, per_time: 1.0, per_velocity: 1.0 };

    fn prepare(p: &View) -> Result<Self, Fault> {
        Ok(FrequencySelectiveDamping {
            is_stroke: p.number(0) == 1.0,
            share: p.number(1),
            per_time: 1.0 / p.number(2),
            per_velocity: 1.0 / p.number(3),
        })
    }
}

impl FrequencySelectiveDamping {
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
