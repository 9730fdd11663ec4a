//! Frequency-selective damping: at equal speed, strokes of high frequency are damped less than strokes of low
//! frequency.

use crate::dual::Real;
use crate::element::Prepare;
use crate::elements::passage::{law, per_stated};
use crate::fault::Fault;
use crate::schema::own::own;
use crate::schema::{Describe, Parameter, View};

/// Frequency-selective damping, which changes the force F, N, of the FV curve to F_h, in three forms. F is relative to
/// the force at standstill, which the element does not change. w is the velocity of the oil at the valves, m/s, and τ a
/// time constant, s.
///
/// *Filter*: F_h = (1 − a) F + a p, τ dp/dt = F − p. The fraction a of the force lags; p is its state, N.
///
/// *Stroke*: a bypass closes while a control chamber fills within a stroke: F_h = F (1 − a (1 − y)), τ dz/dt =
/// tanh(w/u_0) − z. z is the signed filled fraction of the chamber, and u_0 the speed that fills it. y, the smooth step
/// function of z tanh(w/u_0), rises from 0 to 1. After a reversal z still has the sign of the previous stroke. The
/// bypass is therefore open until z changes sign.
///
/// *Bypass*: oil bypasses the valves while the control chamber of the stroke fills. The flow, as a piston velocity, is
/// q_s (1 − y) r(F_h)/r(1 kN), so q_s is that at 1 kN. The law r is that of a passage with laminar flow below F_l (see
/// [`crate::paths::bypass`]). The filled fraction of the current stroke's chamber is y = |z|. It satisfies τ dz/dt =
/// tanh(F_h/F_0) (1 − |z|): a higher pressure fills the chamber faster, up to a few F_0. The chamber of the other
/// stroke empties through a check valve in τ/10. Both chambers also empty at the rate 10/(1 + (20 F_h/F_0)²)/τ, because
/// a low pressure cannot keep them full. At F_h = 0.3 F_0 a chamber stays half full.
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
    const MEANING: &'static str =
        "frequency-selective damping: lower damping at high than at low stroke frequency, at equal speed";
    const PARAMETERS: &'static [Parameter] = &[
        Parameter::choice(
            "fsd_form",
            &["filter", "stroke", "bypass"],
            "fraction of the force that lags, fraction that builds up within each stroke, or bypass flow that ends within each stroke",
        ),
        Parameter::scalar("fsd_share", "-", &[0.3], (0.0, 0.9), "fraction of the force lost at high frequency, a")
            .in_form("fsd_form", &["filter", "stroke"]),
        Parameter::scalar(
            "fsd_time",
            "s",
            &[0.05],
            (1e-3, 10.0),
            "time constant of the lag, or of filling the control chamber, tau",
        ),
        Parameter::scalar(
            "fsd_velocity",
            "m/s",
            &[0.02],
            (1e-3, 1.0),
            "stroke form: speed above which the control chamber fills at its full rate, u_0",
        )
        .in_form("fsd_form", &["stroke"]),
        Parameter::scalar(
            "fsd_flow",
            "m/s",
            &[0.2],
            (0.0, 10.0),
            "bypass form: bypass flow at a hydraulic force of 1 kN, as a piston velocity, q_s",
        )
        .in_form("fsd_form", &["bypass"]),
        Parameter::scalar(
            "fsd_force",
            "N",
            &[50.0],
            (1.0, 1e4),
            "bypass form: hydraulic force above which the control chamber fills at its full rate, F_0",
        )
        .in_form("fsd_form", &["bypass"]),
        Parameter::scalar(
            "fsd_laminar_force",
            "N",
            &[20.0],
            (1.0, 1e5),
            "bypass form: hydraulic force below which the bypass flow is laminar, F_l",
        )
        .in_form("fsd_form", &["bypass"]),
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

    fn prepare(p: &View<Self>) -> Result<Self, Fault> {
        Ok(FrequencySelectiveDamping {
            is_stroke: p.number(own!("fsd_form")) == 1.0,
            is_bypass: p.number(own!("fsd_form")) == 2.0,
            flow: p.number(own!("fsd_flow")) * per_stated(p.number(own!("fsd_laminar_force"))),
            laminar: p.number(own!("fsd_laminar_force")),
            per_force: 1.0 / p.number(own!("fsd_force")),
            share: p.number(own!("fsd_share")),
            per_time: 1.0 / p.number(own!("fsd_time")),
            per_velocity: 1.0 / p.number(own!("fsd_velocity")),
        })
    }
}

/// Ratio of the rate at which the chamber of the other stroke empties to the largest rate at which a chamber fills.
const EMPTIES: f64 = 10.0;
/// Hydraulic force, as a fraction of `fsd_force`, at which a control chamber empties at half the largest rate.
const IDLE: f64 = 0.05;

impl FrequencySelectiveDamping {
    /// Returns whether the state is a force, N, as in the filter form, instead of a filled fraction.
    pub(crate) fn holds_force(&self) -> bool {
        !self.is_stroke && !self.is_bypass
    }

    /// Returns the range of the state. In the stroke and bypass forms, it is −1 with a full compression chamber, and 1
    /// with a full rebound chamber. In the filter form, the state is a force without limits.
    #[inline(always)]
    pub(crate) fn range(&self) -> (f64, f64) {
        if self.holds_force() { (f64::NEG_INFINITY, f64::INFINITY) } else { (-1.0, 1.0) }
    }

    /// Computes tanh(F_h/F_0) of the bypass form: τ times the rate at which an empty control chamber fills under the
    /// force F_h.
    #[inline(always)]
    fn grows<R: Real>(&self, force: R) -> R {
        (force * self.per_force).tanh()
    }

    /// Computes the coefficient of −z in τ dz/dt for the bypass form, with the filled fraction z and the time constant
    /// τ. `force` is the hydraulic force F_h, N, and `grows` is tanh(F_h/F_0). Only the sign of `z` matters.
    #[inline(always)]
    fn falls<R: Real>(&self, force: R, grows: R, z: R) -> R {
        let size = grows.abs();
        if grows.value() * z.value() < 0.0 {
            return size.plus(EMPTIES);
        }
        let of_idle = force * (self.per_force * (1.0 / IDLE));
        size + (of_idle * of_idle).plus(1.0).inverse() * EMPTIES
    }

    /// Computes the filled fraction z in the steady state under a constant hydraulic force, N, for the bypass form.
    #[inline(always)]
    pub(crate) fn equilibrium(&self, force: f64) -> f64 {
        let grows = self.grows(force);
        grows / self.falls(force, grows, force)
    }

    /// Computes dz/dt, 1/s, of the filled fraction `z` in the bypass form; `force` is the hydraulic force, N.
    #[inline(always)]
    pub(crate) fn fills<R: Real>(&self, force: R, z: R) -> R {
        let grows = self.grows(force);
        (grows - z * self.falls(force, grows, z)) * self.per_time
    }

    /// Computes the filled fraction z after an implicit stage of the bypass form: z − g dz/dt equals `known`. `force`
    /// is the hydraulic force, N, and `g` the weight of dz/dt in the stage, s.
    #[inline(always)]
    pub(crate) fn filled<R: Real>(&self, force: R, known: R, g: f64) -> R {
        let per = g * self.per_time;
        let grows = self.grows(force);
        // Whichever control chamber fills, the filled fraction z has the sign of this sum.
        let sum = known + grows * per;
        sum * (self.falls(force, grows, sum) * per).plus(1.0).inverse()
    }

    /// Computes the flow that bypasses the valves in the bypass form, as a piston velocity in m/s. `force` is the
    /// hydraulic force, N, and `z` the filled fraction of the chambers.
    #[inline(always)]
    pub(crate) fn passes<R: Real>(&self, force: R, z: R) -> R {
        let open = law(force, self.laminar) * self.flow;
        let closed = if force.value() < 0.0 { -z } else { z };
        if closed.value() <= 0.0 { open } else { open - open * closed }
    }

    /// Returns the value toward which the state relaxes. It is the FV force `force`, N, in the filter form, and
    /// tanh(w/u_0) in the stroke form. `w` is the oil velocity, m/s, and u_0 the parameter `fsd_velocity`.
    #[inline(always)]
    pub(crate) fn target<R: Real>(&self, force: R, w: R) -> R {
        if self.is_stroke { (w * self.per_velocity).tanh() } else { force }
    }

    /// Computes the force F_h, N, of the filter or stroke form. `force` is the FV force, N, and `w` the velocity of the
    /// oil at the valves, m/s.
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_chamber_fills_under_any_lasting_force_and_empties_at_rest() {
        let bypass = FrequencySelectiveDamping { per_force: 1.0 / 300.0, per_time: 20.0, ..Prepare::OFF };
        for force in [-2000.0, -300.0, 300.0, 2000.0] {
            let z = bypass.equilibrium(force);
            assert!(z * force.signum() > 0.95, "{force}: {z}");
            // An implicit step of 1e9 s ends at the steady state, where the state derivative is 0.
            assert!((bypass.filled(force, 0.0, 1e9) - z).abs() < 1e-6);
            assert!(bypass.fills(force, z).abs() < 1e-12);
            // A larger force fills the chamber faster.
            assert!(bypass.fills(force, 0.0).abs() > bypass.fills(0.5 * force, 0.0).abs());
            // The chamber of the other stroke empties faster than a chamber fills.
            assert!(bypass.fills(force, -z).abs() > 5.0 * bypass.fills(force, 0.0).abs());
        }
        assert_eq!(bypass.equilibrium(0.0), 0.0);
        assert!(bypass.fills(0.0, 1.0) < -100.0);
    }
}
