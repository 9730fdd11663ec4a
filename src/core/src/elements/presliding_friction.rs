//! Presliding friction: contacts that bend before they slide (Dahl; effect of seal lip and guide after every reversal).

use crate::elements::{Describe, Memory, Motion, Prepare, Recall, Share};
use crate::fault::Fault;
use crate::math::power;
use crate::parameter::{Parameter, View};

/// F = F_c z/z_0, dz/dt = v − |v|_c (z/z_0) |z/z_0|^(n−1): the force turns over within a few z_0 of travel, whatever the speed.
/// n = 1 is Dahl's contact, which slips from the first; a larger n bends elastically first. Where the return is elastic a
/// bent contact does not slip while it is unbent (Bouc and Wen with β = γ). |v|_c = √(v² + v_c²): below the speed v_c the
/// contact creeps, and the friction of a long slow motion is less than F_c.
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
    returns_elastically: bool,
    /// v_c².
    creep_squared: f64,
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
        Parameter::choice(
            "presliding_return",
            &["slips", "elastic"],
            "after a reversal a bent contact slips at once, or first springs back",
        ),
        Parameter::scalar("presliding_creep", "m/s", &[1e-9], (1e-9, 0.1), "speed below which the contact creeps, v_c"),
    ];
}

impl Prepare for PreslidingFriction {
    const OFF: Self = PreslidingFriction {
        stiffness: 0.0,
        length: 1.0,
        per_length: 1.0,
        power: 0.0,
        returns_elastically: false,
        creep_squared: 0.0,
    };

    fn prepare(p: &View) -> Result<Self, Fault> {
        let length = p.number(1);
        Ok(PreslidingFriction {
            stiffness: p.number(0) / length,
            length,
            per_length: 1.0 / length,
            power: p.number(2) - 1.0,
            returns_elastically: p.number(3) == 1.0,
            creep_squared: p.number(4) * p.number(4),
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
        let speed = libm::sqrt(v * v + self.creep_squared);
        let sign = if v == 0.0 { 0.0 } else { v / speed };
        let (mut slips, mut slips_by_bent) = (bent, 1.0);
        if self.returns_elastically && v * z < 0.0 {
            (slips, slips_by_bent) = (0.0, 0.0);
        } else if self.power > 0.0 {
            let size = bent.abs();
            let raised = if size > 0.0 { power(size, self.power) } else { 0.0 };
            (slips, slips_by_bent) = (bent * raised, (1.0 + self.power) * raised);
        }
        Recall {
            force: self.stiffness * z,
            by_memory: self.stiffness,
            rate: v - speed * slips,
            rate_by_v: 1.0 - sign * slips,
            rate_by_memory: -speed * slips_by_bent * self.per_length,
            ..Recall::NONE
        }
    }

    /// At rest every bend stays; the unbent one is taken.
    fn settled(&self, at: &Motion) -> f64 {
        if at.velocity == 0.0 {
            return 0.0;
        }
        let share = at.velocity.abs() / libm::sqrt(at.velocity * at.velocity + self.creep_squared);
        (self.length * power(share, 1.0 / (1.0 + self.power))).copysign(at.velocity)
    }
}
