//! Compressibility of the oil column between piston and valves.

use crate::elements::{Describe, Prepare};
use crate::fault::Fault;
use crate::parameter::{Parameter, View};

/// F_h = k_o q, dq/dt = u − w, F_d(w) = F_h: the valves see the velocity w that the oil column leaves of the piston's u.
///
/// Cylinder expansion is in it: 1/k_o = 1/k_oil + 1/k_tube, and no test on a rig can tell the two apart. The series
/// compliance differs from both in that springs on the mass pass through it but not through the oil.
#[derive(Clone, Copy, Debug)]
pub struct OilCompressibility {
    /// 1/k_o.
    pub(crate) compliance: f64,
}

impl Describe for OilCompressibility {
    const MEANING: &'static str =
        "compressibility of the oil column (with the expansion of the cylinder) before the valves";
    const PARAMETERS: &'static [Parameter] = &[Parameter::scalar(
        "oil_stiffness",
        "N/m",
        &[3e6],
        (1e5, 1e9),
        "stiffness of the oil column, cylinder expansion included, k_o",
    )];
}

impl Prepare for OilCompressibility {
    /// Ten times stiffer than most oil: hardly noticed beside the air it then carries.
    const OFF: Self = OilCompressibility { compliance: 1.0 / 3e7 };

    fn prepare(p: &View) -> Result<Self, Fault> {
        Ok(OilCompressibility { compliance: 1.0 / p.number(0) })
    }
}
