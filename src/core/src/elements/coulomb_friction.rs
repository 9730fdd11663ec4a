//! Coulomb friction (Jonnalagadda & Vyas, KTH 2020, equation 3.1).

use crate::element::{Force, OperatingPoint, Prepare, Response};
use crate::fault::Fault;
use crate::math::tanh;
use crate::schema::own::own;
use crate::schema::{Describe, Parameter, View};

/// Coulomb friction with the force F = F_s tanh(K v). F_s is the friction force at high speed, N, v the velocity, m/s,
/// and K, s/m, the steepness of the change of sign.
#[derive(Clone, Copy, Debug)]
pub struct CoulombFriction {
    level: f64,
    steepness: f64,
}

impl Describe for CoulombFriction {
    const MEANING: &'static str = "Coulomb friction: dry friction of constant magnitude, F_s tanh(K v)";
    const PARAMETERS: &'static [Parameter] = &[
        Parameter::scalar("coulomb_force", "N", &[40.0], (0.0, 1e4), "magnitude of the friction force, F_s"),
        Parameter::scalar(
            "coulomb_steepness",
            "s/m",
            &[2000.0],
            (1.0, 1e5),
            "steepness of the sign change at zero velocity, K",
        ),
    ];
}

impl Prepare for CoulombFriction {
    const OFF: Self = CoulombFriction { level: 0.0, steepness: 1.0 };

    fn prepare(p: &View<Self>) -> Result<Self, Fault> {
        Ok(CoulombFriction { level: p.number(own!("coulomb_force")), steepness: p.number(own!("coulomb_steepness")) })
    }
}

impl Force for CoulombFriction {
    #[inline(always)]
    fn force(&self, at: &OperatingPoint) -> Response {
        smooth_sign(self.level, self.steepness, at.velocity)
    }
}

/// Computes `level` · tanh(`steepness` · `v`), N, with its derivatives: the law of dry friction that several elements
/// use. `v` is the velocity, m/s, and `steepness` is in s/m.
#[inline(always)]
pub fn smooth_sign(level: f64, steepness: f64, v: f64) -> Response {
    let t = tanh(steepness * v);
    Response { force: level * t, d_force_d_x: 0.0, d_force_d_v: level * steepness * (1.0 - t * t) }
}
