//! Moving mass between load cell and damper: eye, clamp and tube, where the load cell moves with them.

use crate::elements::{Describe, Memory, Motion, Prepare, Recall};
use crate::fault::Fault;
use crate::parameter::{Parameter, View};

/// F = M (v − z)/τ, dz/dt = (v − z)/τ.
///
/// Hosts give displacement and velocity but no acceleration, so the mass, at velocity z, is drawn along by a stiff
/// damper M/τ. It only ever takes energy, and lags behind a mass without it by τ.
#[derive(Clone, Copy, Debug)]
pub struct MovingMass {
    /// M/τ.
    damping: f64,
    /// 1/τ.
    per_time: f64,
}

impl Describe for MovingMass {
    const MEANING: &'static str = "mass between load cell and damper, moved by the driven end";
    const PARAMETERS: &'static [Parameter] = &[
        Parameter::scalar("moving_mass", "kg", &[2.0], (0.0, 100.0), "mass, M"),
        Parameter::scalar(
            "moving_mass_time",
            "s",
            &[2e-4],
            (1e-4, 1e-2),
            "time by which its force lags, tau; short beside the motion",
        ),
    ];
}

impl Prepare for MovingMass {
    const OFF: Self = MovingMass { damping: 0.0, per_time: 1.0 };

    fn prepare(p: &View) -> Result<Self, Fault> {
        let per_time = 1.0 / p.number(1);
        Ok(MovingMass { damping: p.number(0) * per_time, per_time })
    }
}

impl Memory for MovingMass {
    fn recall(&self, at: &Motion, z: f64) -> Recall {
        let behind = at.velocity - z;
        Recall {
            force: self.damping * behind,
            by_v: self.damping,
            by_memory: -self.damping,
            rate: behind * self.per_time,
            rate_by_v: self.per_time,
            rate_by_memory: -self.per_time,
            ..Recall::NONE
        }
    }

    fn settled(&self, at: &Motion) -> f64 {
        at.velocity
    }
}
