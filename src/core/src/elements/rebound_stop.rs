//! Rebound (top-out) stop: the end of the rebound stroke.

use crate::element::{Force, OperatingPoint, Prepare, Response};
use crate::elements::end_stop::EndStop;
use crate::fault::Fault;
use crate::schema::own::own;
use crate::schema::{Describe, Parameter, View};

/// Rebound stop with the force F = P(x, v), N, which pulls the rod in. P is the law of [`EndStop`], x the displacement,
/// m, and v the velocity, m/s.
#[derive(Clone, Copy, Debug)]
pub struct ReboundStop(EndStop);

impl Describe for ReboundStop {
    const MEANING: &'static str = "rebound stop at the end of the rebound stroke, rubber or hydraulic";
    const PARAMETERS: &'static [Parameter] = &[
        Parameter::scalar(
            "rebound_stop_clearance",
            "m",
            &[0.05],
            (0.0, 1.0),
            "extension from x = 0 to first contact with the stop",
        ),
        Parameter::scalar(
            "rebound_stop_stiffness",
            "N/m",
            &[100000.0],
            (0.0, 1e7),
            "stiffness of the stop at first contact",
        ),
        Parameter::scalar(
            "rebound_stop_progression",
            "m",
            &[0.02],
            (1e-3, 1.0),
            "deflection of the stop at which its spring force is twice the linear force",
        ),
        Parameter::scalar(
            "rebound_stop_loss",
            "-",
            &[0.15],
            (0.0, 0.9),
            "fraction of the spring force lost on loading, and again on unloading",
        ),
        Parameter::scalar(
            "rebound_stop_damping",
            "N s/m",
            &[0.0],
            (0.0, 1e6),
            "hydraulic damping coefficient on loading, at the deflection of the progression",
        ),
        Parameter::choice(
            "rebound_stop_flow",
            &["gap", "orifice"],
            "hydraulic force proportional to the speed (gap) or to its square (orifice), equal at 1 m/s",
        ),
    ];
}

impl Prepare for ReboundStop {
    const OFF: Self = ReboundStop(EndStop::OFF);

    fn prepare(p: &View<Self>) -> Result<Self, Fault> {
        Ok(ReboundStop(EndStop {
            clearance: p.number(own!("rebound_stop_clearance")),
            stiffness: p.number(own!("rebound_stop_stiffness")),
            per_progression: 1.0 / p.number(own!("rebound_stop_progression")),
            loss: p.number(own!("rebound_stop_loss")),
            damping: p.number(own!("rebound_stop_damping")),
            is_orifice: p.number(own!("rebound_stop_flow")) == 1.0,
        }))
    }
}

impl Force for ReboundStop {
    fn force(&self, at: &OperatingPoint) -> Response {
        self.0.push(at.displacement, at.velocity)
    }
}
