//! Air in the oil: a soft stroke after every reversal, until the force has pressed the bubbles together.

use crate::elements::{Describe, Prepare};
use crate::fault::Fault;
use crate::parameter::{Parameter, View};
use crate::paths::soft_gap::SoftGap;

/// q(F) = F/k_o + d_a F/(|F| + F_a) for the oil column of `oil_compressibility`; k_o is 3e7 N/m where that is off.
#[derive(Clone, Copy, Debug)]
pub struct Aeration(pub(crate) SoftGap);

impl Describe for Aeration {
    const MEANING: &'static str = "air in the oil: the oil column is soft while the force is small";
    const PARAMETERS: &'static [Parameter] = &[
        Parameter::scalar(
            "aeration_stroke",
            "m",
            &[3e-4],
            (0.0, 5e-3),
            "stroke that the air takes up to each side, d_a",
        ),
        Parameter::scalar(
            "aeration_force",
            "N",
            &[150.0],
            (1.0, 1e4),
            "force at which half of that stroke is taken, F_a",
        ),
    ];
}

impl Prepare for Aeration {
    const OFF: Self = Aeration(SoftGap::CLOSED);

    fn prepare(p: &View) -> Result<Self, Fault> {
        Ok(Aeration(SoftGap { gap: p.number(0), softness: p.number(1) }))
    }
}
