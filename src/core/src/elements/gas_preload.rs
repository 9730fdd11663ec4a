//! Constant gas force that pushes the rod out (Jonnalagadda & Vyas, KTH 2020, chapter 3: identified from a slow test).

use crate::element::{Force, OperatingPoint, Prepare, Response};
use crate::fault::Fault;
use crate::schema::own::own;
use crate::schema::{Describe, Parameter, View};

/// Constant gas force F = −F_gas, N: a positive F_gas pushes the rod out, so F is negative, because tension is
/// positive.
#[derive(Clone, Copy, Debug)]
pub struct GasPreload {
    push: f64,
}

impl Describe for GasPreload {
    const MEANING: &'static str = "constant gas force";
    const PARAMETERS: &'static [Parameter] =
        &[Parameter::scalar("gas_force", "N", &[80.0], (-1e4, 1e4), "gas force, positive when it pushes the rod out")];
}

impl Prepare for GasPreload {
    const OFF: Self = GasPreload { push: 0.0 };

    fn prepare(p: &View<Self>) -> Result<Self, Fault> {
        Ok(GasPreload { push: p.number(own!("gas_force")) })
    }
}

impl Force for GasPreload {
    #[inline(always)]
    fn force(&self, _: &OperatingPoint) -> Response {
        Response { force: -self.push, d_force_d_x: 0.0, d_force_d_v: 0.0 }
    }

    #[inline(always)]
    fn at_once(&self, at: &OperatingPoint) -> Option<Response> {
        Some(self.force(at))
    }
}
