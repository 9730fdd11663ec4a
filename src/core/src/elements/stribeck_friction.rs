//! Stribeck friction: a break-away peak that falls to the Coulomb friction.
//!
//! Source: Jonnalagadda & Vyas, KTH 2020, equations 3.3–3.7.

use crate::element::{Force, OperatingPoint, Prepare, Response};
use crate::elements::coulomb_friction::smooth_sign;
use crate::fault::Fault;
use crate::math::{exp_below_bound, power};
use crate::schema::own::own;
use crate::schema::{Describe, Parameter, View};

/// Stribeck friction in two forms.
///
/// *Simplified* (equations 3.5–3.7 of the source, without the v² term, which is the element `viscous_friction`): `F =
/// √(2e) (F_brk − F_c) exp(−(v/v_st)²) v/v_st + F_c tanh(v/v_coul)`, `v_st = √2 v_brk`, `v_coul = v_brk/10`. F_brk is
/// about the peak force, at the break-away velocity v_brk, and F_c the friction at high velocity.
///
/// *Full*: equations 3.3–3.4 of the source cannot be correct as printed. This form is therefore the generalized
/// Stribeck curve of Armstrong-Hélouvry (Automatica 30, 1994) with the parameters of the source and a smooth rise: `F =
/// sign(v) [F_s + (F_t − F_s) exp(−(|v|/V_s)^a)] tanh(c (|v|/V_fs)^d)`. F_t is the peak force and F_s the friction at
/// high velocity. V_s is the velocity scale of the fall, and a its exponent. c is the steepness of the rise, and d its
/// exponent. The force comes near F_t at the break-away velocity V_fs. At velocities far above V_s it approaches F_s.
///
/// The source is Jonnalagadda & Vyas, KTH 2020.
#[derive(Clone, Copy, Debug)]
pub enum StribeckFriction {
    /// The simplified form.
    Simplified {
        /// Derivative of the peak term at rest, √(2e) (F_brk − F_c)/v_st, N s/m.
        peak: f64,
        /// One over the Stribeck velocity, 1/v_st, s/m.
        per_stribeck: f64,
        /// Friction F_c at high velocity, N.
        coulomb: f64,
        /// Steepness of the change of sign, 1/v_coul, s/m.
        steepness: f64,
    },
    /// The full form.
    Full {
        /// Friction F_s at high velocity, N.
        coulomb: f64,
        /// Peak force above the friction at high velocity, F_t − F_s, N.
        excess: f64,
        /// One over the velocity scale of the fall, 1/V_s, s/m.
        per_stribeck: f64,
        /// Exponent a of the fall.
        fall: f64,
        /// One over the break-away velocity, 1/V_fs, s/m.
        per_breakaway: f64,
        /// Steepness c of the rise.
        rise: f64,
        /// Exponent d of the rise.
        rise_power: f64,
    },
}

impl Describe for StribeckFriction {
    const MEANING: &'static str = "Stribeck friction: dry friction with a breakaway peak";
    const PARAMETERS: &'static [Parameter] = &[
        Parameter::choice("stribeck_form", &["simplified", "full"], "form of the Stribeck curve"),
        Parameter::scalar("stribeck_breakaway_force", "N", &[50.0], (0.0, 1e4), "breakaway force (peak), F_brk or F_t"),
        Parameter::scalar(
            "stribeck_coulomb_force",
            "N",
            &[40.0],
            (0.0, 1e4),
            "Coulomb friction force beyond the peak, F_c or F_s",
        ),
        Parameter::scalar(
            "stribeck_breakaway_velocity",
            "m/s",
            &[0.005],
            (1e-5, 1.0),
            "velocity at the breakaway peak, v_brk or V_fs",
        ),
        Parameter::scalar(
            "stribeck_velocity",
            "m/s",
            &[0.01],
            (1e-5, 5.0),
            "full form: Stribeck velocity, the scale of the decrease after the peak, V_s",
        ),
        Parameter::scalar(
            "stribeck_fall",
            "-",
            &[2.0],
            (1.0, 4.0),
            "full form: exponent of the decrease after the peak, a (1 Tustin, 2 Gauss)",
        ),
        Parameter::scalar(
            "stribeck_rise",
            "-",
            &[3.0],
            (0.1, 20.0),
            "full form: steepness of the rise to the peak, c; large: the peak reaches F_t",
        ),
        Parameter::scalar(
            "stribeck_rise_power",
            "-",
            &[1.0],
            (1.0, 4.0),
            "full form: exponent of the rise to the peak, d",
        ),
    ];
}

impl Prepare for StribeckFriction {
    const OFF: Self = StribeckFriction::Simplified { peak: 0.0, per_stribeck: 1.0, coulomb: 0.0, steepness: 1.0 };

    fn prepare(p: &View<Self>) -> Result<Self, Fault> {
        let (breakaway, coulomb, v) = (
            p.number(own!("stribeck_breakaway_force")),
            p.number(own!("stribeck_coulomb_force")),
            p.number(own!("stribeck_breakaway_velocity")),
        );
        if p.number(own!("stribeck_form")) == 1.0 {
            return Ok(StribeckFriction::Full {
                coulomb,
                excess: breakaway - coulomb,
                per_stribeck: 1.0 / p.number(own!("stribeck_velocity")),
                fall: p.number(own!("stribeck_fall")),
                per_breakaway: 1.0 / v,
                rise: p.number(own!("stribeck_rise")),
                rise_power: p.number(own!("stribeck_rise_power")),
            });
        }
        /// √(2e) with Euler's number e.
        const SQRT_2E: f64 = 2.331_643_981_597_124;
        let per_stribeck = core::f64::consts::FRAC_1_SQRT_2 / v;
        Ok(StribeckFriction::Simplified {
            peak: SQRT_2E * (breakaway - coulomb) * per_stribeck,
            per_stribeck,
            coulomb,
            steepness: 10.0 / v,
        })
    }
}

/// Smallest exponent x at which e^-x is neglected: e^-40 is 4e-18, a small part of the rounding error of 1.
const BELOW_ROUNDING: f64 = 40.0;

impl StribeckFriction {
    /// Computes force and derivatives of the full form at velocity `v`, m/s. Not inlined, because its two powers take
    /// many times as long as the simplified form.
    #[cold]
    #[inline(never)]
    fn full(&self, v: f64) -> Response {
        let StribeckFriction::Full { coulomb, excess, per_stribeck, fall, per_breakaway, rise, rise_power } = *self
        else {
            return Response::NONE;
        };
        let speed = v.abs();
        let (r, q) = (speed * per_stribeck, speed * per_breakaway);
        let fallen = power(r, fall);
        let bump = excess * exp_below_bound(-fallen);
        let d_bump =
            if speed > 0.0 { -bump * fall * fallen / speed } else { derivative_at_rest(-bump * per_stribeck, fall) };
        let risen = rise * power(q, rise_power);
        let sign = smooth_sign(1.0, 1.0, risen);
        let d_risen =
            if speed > 0.0 { rise_power * risen / speed } else { derivative_at_rest(rise * per_breakaway, rise_power) };
        let level = coulomb + bump;
        Response {
            force: (level * sign.force).copysign(v) * if level < 0.0 { -1.0 } else { 1.0 },
            d_force_d_x: 0.0,
            d_force_d_v: d_bump * sign.force + level * sign.d_force_d_v * d_risen,
        }
    }
}

impl Force for StribeckFriction {
    #[inline(always)]
    fn force(&self, at: &OperatingPoint) -> Response {
        let v = at.velocity;
        match *self {
            StribeckFriction::Simplified { peak, per_stribeck, coulomb, steepness } => {
                let r = v * per_stribeck;
                let square = r * r;
                // At velocities far above the break-away velocity, as in most strokes, the exponentials of the peak and
                // of tanh are below the rounding error.
                if square > BELOW_ROUNDING {
                    return far_above(coulomb, v);
                }
                near_breakaway(peak, square, coulomb, steepness, v)
            }
            StribeckFriction::Full { .. } => self.full(v),
        }
    }

    #[inline(always)]
    fn at_once(&self, at: &OperatingPoint) -> Option<Response> {
        match *self {
            StribeckFriction::Simplified { .. } => Some(self.force(at)),
            StribeckFriction::Full { .. } => None,
        }
    }
}

/// Computes the simplified form at velocities far above the break-away velocity, where its exponentials vanish: ± the
/// Coulomb friction.
#[inline(always)]
fn far_above(coulomb: f64, v: f64) -> Response {
    Response { force: coulomb.copysign(v), d_force_d_x: 0.0, d_force_d_v: 0.0 }
}

/// Computes the simplified form where its exponentials matter; `square` is (v/v_st)² with the Stribeck velocity v_st.
#[inline(always)]
fn near_breakaway(peak: f64, square: f64, coulomb: f64, steepness: f64, v: f64) -> Response {
    let bump = peak * exp_below_bound(-square);
    let level = smooth_sign(coulomb, steepness, v);
    Response {
        force: bump * v + level.force,
        d_force_d_x: 0.0,
        d_force_d_v: bump * (1.0 - 2.0 * square) + level.d_force_d_v,
    }
}

/// Returns the derivative of `scale · s^p` with respect to s at s = 0, for p ≥ 1.
fn derivative_at_rest(scale: f64, p: f64) -> f64 {
    if p == 1.0 { scale } else { 0.0 }
}
