//! What is in line with the damper: a rubber mount or eye that hardens a little with force.

use crate::draw::Draw;

/// Deflection `d(F) = (F/k) · asinh(F/F_h)/(F/F_h)`: straight at first, ever stiffer beyond F_h. A damper acts beside it.
#[derive(Debug, Clone)]
pub struct Mount {
    /// Stiffness at no force, N/m.
    pub stiffness: f64,
    /// Force at which it has become 1.4 times as stiff, N.
    pub hardens: f64,
    /// Damping, N s/m.
    pub damping: f64,
}

impl Mount {
    /// A mount of some stiffness that hardens round some force.
    pub fn new(d: &mut Draw, stiffness: (f64, f64), hardens: (f64, f64)) -> Mount {
        let stiffness = d.scale(stiffness.0, stiffness.1);
        // A relaxation time of rubber between 0.1 and 0.5 ms.
        Mount { stiffness, hardens: d.scale(hardens.0, hardens.1), damping: stiffness * d.between(1e-4, 5e-4) }
    }

    /// dd/dF.
    pub fn compliance(&self, force: f64) -> f64 {
        let r = force / self.hardens;
        1.0 / (self.stiffness * (1.0 + r * r).sqrt())
    }
}
