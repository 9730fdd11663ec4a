//! Gas that warms with the damper, so that it pushes the rod out with a larger force.

use crate::element::{Force, OperatingPoint, Prepare, Response};
use crate::fault::Fault;
use crate::schema::own::own;
use crate::schema::{Describe, Parameter, View};

/// Additional gas force F = −c (T − T_0), N, with the growth c, N/K. T is the temperature from the host, and T_0 that
/// at which this force is 0.
///
/// The pressure of an enclosed gas grows with its absolute temperature, 0.34 % per kelvin at 20 °C. The expansion of
/// the oil compresses the gas and doubles the effect in a monotube (Dixon, *The Shock Absorber Handbook*, 2007, ch. 5).
#[derive(Clone, Copy, Debug)]
pub struct GasWarming {
    rate: f64,
    reference: f64,
}

impl Describe for GasWarming {
    const MEANING: &'static str = "gas force that increases with the temperature of the damper";
    const PARAMETERS: &'static [Parameter] = &[
        Parameter::scalar("gas_warming_rate", "N/K", &[0.8], (0.0, 50.0), "increase of the gas force per kelvin, c"),
        Parameter::scalar(
            "gas_warming_reference",
            "degC",
            &[20.0],
            (-60.0, 200.0),
            "temperature at which this element adds no gas force, T_0",
        ),
    ];
}

impl Prepare for GasWarming {
    const OFF: Self = GasWarming { rate: 0.0, reference: 20.0 };

    fn prepare(p: &View<Self>) -> Result<Self, Fault> {
        Ok(GasWarming { rate: p.number(own!("gas_warming_rate")), reference: p.number(own!("gas_warming_reference")) })
    }
}

impl Force for GasWarming {
    #[inline(always)]
    fn force(&self, at: &OperatingPoint) -> Response {
        Response { force: -self.rate * (at.temperature - self.reference), d_force_d_x: 0.0, d_force_d_v: 0.0 }
    }

    #[inline(always)]
    fn at_once(&self, at: &OperatingPoint) -> Option<Response> {
        Some(self.force(at))
    }
}
