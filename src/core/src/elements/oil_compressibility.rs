//! Compressibility of the oil column between piston and valves.

use crate::dual::Real;
use crate::elements::{Describe, Prepare};
use crate::fault::Fault;
use crate::parameter::own::own;
use crate::parameter::{Parameter, View};

/// F_h = k_o q, ℓ dq/dt = u − w, F_d(w) = F_h: the valves see the velocity w that the oil column leaves of the piston's u.
///
/// ℓ is the length of the column relative to that at x = 0. The rebound chamber gets shorter with extension: ℓ = 1 − λ x.
/// With two chambers the one under pressure yields: ℓ = 1 − λ x tanh(F_h/F_c), longer on the compression stroke.
///
/// In compression k_o is r_o times that in rebound: in a twin tube the oil below the piston, which the rod's area loads
/// alone, yields more to the force than that above it.
///
/// Cylinder expansion is in it: 1/k_o = 1/k_oil + 1/k_tube, and no test on a rig can tell the two apart. The series
/// compliance differs from both in that springs on the mass pass through it but not through the oil.
#[derive(Clone, Copy, Debug)]
pub struct OilCompressibility {
    /// 1/k_o in rebound, and in compression.
    compliance: [f64; 2],
    shortening: f64,
    has_two_chambers: bool,
}

/// F_c, N.
const CHANGES: f64 = 50.0;
/// Least ℓ.
const SHORTEST: f64 = 0.1;

impl Describe for OilCompressibility {
    const MEANING: &'static str =
        "compressibility of the oil column (with the expansion of the cylinder) before the valves";
    const PARAMETERS: &'static [Parameter] = &[
        Parameter::scalar(
            "oil_stiffness",
            "N/m",
            &[3e6],
            (2e4, 1e9),
            "stiffness of the oil column at x = 0, cylinder expansion included, k_o",
        ),
        Parameter::scalar(
            "oil_shortening",
            "1/m",
            &[0.0],
            (-50.0, 50.0),
            "one over the length of the column at x = 0, lambda; 0: the same stiffness at every place",
        ),
        Parameter::choice(
            "oil_chambers",
            &["rebound", "both"],
            "whose column yields: that of the rebound chamber, or that of the chamber under pressure",
        ),
        Parameter::scalar(
            "oil_compression",
            "-",
            &[1.0],
            (0.01, 100.0),
            "stiffness of the column in compression, as a share of that in rebound, r_o",
        ),
    ];
}

impl Prepare for OilCompressibility {
    /// Ten times stiffer than most oil: hardly noticed beside the air it then carries.
    const OFF: Self = OilCompressibility { compliance: [1.0 / 3e7; 2], shortening: 0.0, has_two_chambers: false };

    fn prepare(p: &View<Self>) -> Result<Self, Fault> {
        Ok(OilCompressibility {
            compliance: [
                1.0 / p.number(own!("oil_stiffness")),
                1.0 / (p.number(own!("oil_stiffness")) * p.number(own!("oil_compression"))),
            ],
            shortening: p.number(own!("oil_shortening")),
            has_two_chambers: p.number(own!("oil_chambers")) == 1.0,
        })
    }
}

impl OilCompressibility {
    /// 1/k_o of the chamber that stands under pressure; `side` is the force, or the deflection, which has its sign.
    #[inline(always)]
    pub(crate) fn compliance(&self, side: f64) -> f64 {
        let [rebound, compression] = self.compliance;
        if side < 0.0 { compression } else { rebound }
    }

    /// Whether the column is as stiff on the one side as on the other.
    pub(crate) fn is_even(&self) -> bool {
        let [rebound, compression] = self.compliance;
        rebound == compression
    }

    /// Whether the place matters.
    #[inline(always)]
    pub(crate) fn has_length(&self) -> bool {
        self.shortening != 0.0
    }

    /// ℓ.
    #[inline(always)]
    pub(crate) fn length<R: Real>(&self, x: R, force: R) -> R {
        let away = x * self.shortening;
        let away = if self.has_two_chambers { away * (force * (1.0 / CHANGES)).tanh() } else { away };
        let length = (-away).plus(1.0);
        if length.value() > SHORTEST { length } else { R::constant(SHORTEST) }
    }
}
