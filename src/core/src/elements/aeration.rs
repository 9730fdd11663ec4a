//! Air in the oil: the oil column is soft after every reversal, until the force has compressed the bubbles.

use crate::element::Prepare;
use crate::elements::soft_gap::SoftGap;
use crate::fault::Fault;
use crate::schema::own::own;
use crate::schema::{Describe, Parameter, View};

/// Air in the oil column, which deflects under a force F, N, by q(F) = F/k_o + d F/(|F| + F_a), m.
///
/// k_o is the stiffness of `oil_compressibility`, or 3e7 N/m if that element is off. d is the stroke that the air
/// yields, half of it at the force F_a. The air is in the chamber under pressure. Its stroke is d = d_a in rebound and
/// r_a d_a in compression.
#[derive(Clone, Copy, Debug)]
pub struct Aeration {
    rebound: SoftGap,
    compression: SoftGap,
}

impl Describe for Aeration {
    const MEANING: &'static str = "free air in the oil: low stiffness of the oil column at small forces";
    const PARAMETERS: &'static [Parameter] = &[
        Parameter::scalar(
            "aeration_stroke",
            "m",
            &[3e-4],
            (0.0, 5e-3),
            "stroke that the compression of the air absorbs in rebound, d_a",
        ),
        Parameter::scalar(
            "aeration_force",
            "N",
            &[150.0],
            (1.0, 1e4),
            "force at which the air has absorbed half of its stroke, F_a",
        ),
        Parameter::scalar(
            "aeration_compression",
            "-",
            &[1.0],
            (0.0, 20.0),
            "ratio of the stroke that the air absorbs in compression to that in rebound, r_a",
        ),
    ];
}

impl Prepare for Aeration {
    const OFF: Self = Aeration { rebound: SoftGap::CLOSED, compression: SoftGap::CLOSED };

    fn prepare(p: &View<Self>) -> Result<Self, Fault> {
        let of = |gap: f64| SoftGap { gap, softness: p.number(own!("aeration_force")) };
        Ok(Aeration {
            rebound: of(p.number(own!("aeration_stroke"))),
            compression: of(p.number(own!("aeration_compression")) * p.number(own!("aeration_stroke"))),
        })
    }
}

impl Aeration {
    /// Returns the law of the air in the chamber under pressure: compression for a negative `side`, otherwise rebound.
    /// `side` is the force or the deflection, which have the same sign.
    #[inline(always)]
    pub(crate) fn under(&self, side: f64) -> SoftGap {
        if side < 0.0 { self.compression } else { self.rebound }
    }

    /// Returns whether the air yields equally in rebound and compression.
    pub(crate) fn is_even(&self) -> bool {
        self.rebound.gap == self.compression.gap
    }
}
