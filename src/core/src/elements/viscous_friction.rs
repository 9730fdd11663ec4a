//! Viscous friction that grows with the square of velocity (Jonnalagadda & Vyas, KTH 2020, equation 3.2, term F_v).

use crate::element::{Force, OperatingPoint, Prepare, Response};
use crate::fault::Fault;
use crate::schema::own::own;
use crate::schema::{Describe, Parameter, View};

/// Viscous friction with the force F = F_v v|v|, odd in the velocity v, m/s; F_v is a coefficient, N s²/m².
///
/// Equation 3.5 of the source (Jonnalagadda & Vyas, KTH 2020) has v² without a sign. In compression that force would
/// drive the motion instead of resisting it.
#[derive(Clone, Copy, Debug)]
pub struct ViscousFriction {
    coefficient: f64,
}

impl Describe for ViscousFriction {
    const MEANING: &'static str = "viscous friction, quadratic in the velocity, F_v v|v|";
    const PARAMETERS: &'static [Parameter] = &[Parameter::scalar(
        "viscous_coefficient",
        "N s^2/m^2",
        &[10.0],
        (0.0, 1e5),
        "friction coefficient, F_v of F_v v|v|",
    )];
}

impl Prepare for ViscousFriction {
    const OFF: Self = ViscousFriction { coefficient: 0.0 };

    fn prepare(p: &View<Self>) -> Result<Self, Fault> {
        Ok(ViscousFriction { coefficient: p.number(own!("viscous_coefficient")) })
    }
}

impl Force for ViscousFriction {
    #[inline(always)]
    fn force(&self, at: &OperatingPoint) -> Response {
        let (v, speed) = (at.velocity, at.velocity.abs());
        Response { force: self.coefficient * v * speed, d_force_d_x: 0.0, d_force_d_v: 2.0 * self.coefficient * speed }
    }

    #[inline(always)]
    fn at_once(&self, at: &OperatingPoint) -> Option<Response> {
        Some(self.force(at))
    }
}
