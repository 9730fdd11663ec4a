//! The mount in series with the damper: a rubber mount or eye that hardens slightly with force.

use crate::draw::Draw;

/// A mount with the deflection `d(F) = (F/k) · asinh(F/F_h)/(F/F_h)`, m, at the force F, N. k is the stiffness at zero
/// force, N/m. Beyond the force F_h, N, the mount is stiffer.
///
/// A linear damper acts in parallel with the mount's spring.
#[derive(Debug, Clone)]
pub struct Mount {
    /// Stiffness k at zero force, N/m.
    pub stiffness: f64,
    /// Force F_h at which the stiffness is 1.4 times that at zero force, N.
    pub hardens: f64,
    /// Damping of the parallel linear damper, N s/m.
    pub damping: f64,
}

impl Mount {
    /// Draws a mount within ranges of the stiffness at zero force, N/m, and of the force F_h, N, at which it hardens.
    pub fn new(d: &mut Draw, stiffness: (f64, f64), hardens: (f64, f64)) -> Mount {
        let stiffness = d.scale(stiffness.0, stiffness.1);
        // The ratio of damping to stiffness of rubber is between 0.1 and 0.5 ms.
        Mount { stiffness, hardens: d.scale(hardens.0, hardens.1), damping: stiffness * d.between(1e-4, 5e-4) }
    }

    /// Computes the compliance, m/N: the derivative of the deflection with respect to force, at a force, N.
    pub fn compliance(&self, force: f64) -> f64 {
        let r = force / self.hardens;
        1.0 / (self.stiffness * (1.0 + r * r).sqrt())
    }
}
