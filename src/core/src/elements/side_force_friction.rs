//! Friction that grows with side force (Jonnalagadda & Vyas, KTH 2020, section 4.2).

use crate::element::{Force, OperatingPoint, Prepare, Response};
use crate::elements::coulomb_friction::smooth_sign;
use crate::fault::Fault;
use crate::schema::own::own;
use crate::schema::{Describe, Parameter, View};

/// Side-force friction with the force F = k_avg |F_side| tanh(K v).
///
/// k_avg is the friction coefficient, F_side the side force, N, and v the velocity, m/s. K, s/m, is the steepness of
/// the change of sign.
#[derive(Clone, Copy, Debug)]
pub struct SideForceFriction {
    coefficient: f64,
    steepness: f64,
}

impl Describe for SideForceFriction {
    const MEANING: &'static str = "dry friction proportional to the side force on the rod";
    const PARAMETERS: &'static [Parameter] = &[
        Parameter::scalar(
            "side_force_coefficient",
            "-",
            &[0.05],
            (0.0, 2.0),
            "friction coefficient: friction force over side force, k_avg",
        ),
        Parameter::scalar(
            "side_force_steepness",
            "s/m",
            &[2000.0],
            (1.0, 1e5),
            "steepness of the sign change at zero velocity, K",
        ),
    ];
}

impl Prepare for SideForceFriction {
    const OFF: Self = SideForceFriction { coefficient: 0.0, steepness: 1.0 };

    fn prepare(p: &View<Self>) -> Result<Self, Fault> {
        Ok(SideForceFriction {
            coefficient: p.number(own!("side_force_coefficient")),
            steepness: p.number(own!("side_force_steepness")),
        })
    }
}

impl Force for SideForceFriction {
    #[inline(always)]
    fn force(&self, at: &OperatingPoint) -> Response {
        smooth_sign(self.coefficient * at.side_force.abs(), self.steepness, at.velocity)
    }
}
