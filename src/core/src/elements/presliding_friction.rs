//! Presliding friction: contacts that bend before they slide (Dahl; effect of seal lip and guide after every reversal).

use crate::elements::{Describe, Memory, Motion, Prepare, Recall, Share};
use crate::fault::Fault;
use crate::math::power;
use crate::parameter::{Parameter, View};

/// F = F_c z/z_0, dz/dt = v − |v| (z/z_0) |z/z_0|^(n−1): the force turns over within a few z_0 of travel, whatever the speed.
/// n = 1 is Dahl's contact, which slips from the first; a larger n bends elastically first, as Bouc and Wen have it.
#[derive(Clone, Copy, Debug)]
pub struct PreslidingFriction {
    /// F_c/z_0.
    stiffness: f64,
    /// z_0.
    length: f64,
    /// 1/z_0.
    per_length: f64,
    /// n − 1.
    power: f64,
}

impl Describe for PreslidingFriction {
    const MEANING: &'static str = "friction that turns over within a short travel after each reversal (Dahl)";
    const PARAMETERS: &'static [Parameter] = &[
        Parameter::scalar("presliding_force", "N", &[40.0], (0.0, 1e4), "friction level after long travel, F_c"),
        Parameter::scalar(
            "presliding_length",
            "m",
            &[3e-4],
            (1e-5, 5e-3),
            "travel in which the force approaches its level by a factor e, z_0",
        ),
        Parameter::scalar(
            "presliding_power",
            "-",
            &[1.0],
            (1.0, 10.0),
            "1: slips from the first (Dahl); larger: bends elastically before it slips, n",
        ),
    ];
}

impl Prepare for PreslidingFriction {
    const OFF: Self = PreslidingFriction { stiffness: 0.0, length: 1.0, per_length: 1.0, power: 0.0 };

    fn prepare(p: &View) -> Result<Self, Fault> {
        let length = p.number(1);
        Ok(PreslidingFriction {
            stiffness: p.number(0) / length,
            length,
            per_length: 1.0 / length,
            power: p.number(2) - 1.0,
        })
    }
}

impl Memory for PreslidingFriction {
    fn share(&self) -> Share {
        Share::Friction
    }

    fn recall(&self, at: &Motion, z: f64) -> Recall {
        let v = at.velocity;
        let bent = z * self.per_length;
        let sign = if v == 0.0 { 0.0 } else { 1.0f64.copysign(v) };
        let (mut slips, mut slips_by_bent) = (bent, 1.0);
        if self.power > 0.0 {
            let size = bent.abs();
            let raised = if size > 0.0 { power(size, self.power) } else { 0.0 };
            (slips, slips_by_bent) = (bent * raised, (1.0 + self.power) * raised);
        }
        Recall {
            force: self.stiffness * z,
            by_memory: self.stiffness,
            rate: v - v.abs() * slips,
            rate_by_v: 1.0 - sign * slips,
            rate_by_memory: -v.abs() * slips_by_bent * self.per_length,
            ..Recall::NONE
        }
    }

    /// At rest every bend stays; the unbent one is taken.
    fn settled(&self, at: &Motion) -> f64 {
        if at.velocity == 0.0 { 0.0 } else { self.length.copysign(at.velocity) }
    }
}
