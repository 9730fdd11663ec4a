//! The mount in series with the damper: a rubber mount or eye that hardens slightly with force.

use crate::draw::Draw;

/// A mount with the deflection `d(F) = (F/k) · asinh(F/F_h)/(F/F_h)`: linear at first, stiffer beyond F_h.
///
/// A linear damper acts in parallel.
#[derive(Debug, Clone)]
pub struct Mount {
    /// Stiffness at zero force, N/m.
    pub stiffness: f64,
    /// Force at which the stiffness is 1.4 times that at zero force, N.
    pub hardens: f64,
    /// Damping, N s/m.
    pub damping: f64,
}

impl Mount {
    /// Draws a mount within ranges of stiffness and hardening force.
    pub fn new(d: &mut Draw, stiffness: (f64, f64), hardens: (f64, f64)) -> Mount {
        let stiffness = d.scale(stiffness.0, stiffness.1);
        // The relaxation time of rubber is between 0.1 and 0.5 ms.
        Mount { stiffness, hardens: d.scale(hardens.0, hardens.1), damping: stiffness * d.between(1e-4, 5e-4) }
    }

    /// Computes the compliance dd/dF at a force, m/N.
    pub fn compliance(&self, force: f64) -> f64 {
        let r = force / self.hardens;
        1.0 / (self.stiffness * (1.0 + r * r).sqrt())
    }
}
