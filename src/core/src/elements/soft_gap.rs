//! A spring in series with a gap that closes gradually: the law of a worn eye, and of oil that contains air.

use crate::dual::Real;

/// Spring and soft gap with the deflection d(F) = F/k + g F/(|F| + F_0).
///
/// At large forces, the deflection is that of the spring plus g on either side; the law is softest at F = 0.
#[derive(Clone, Copy, Debug)]
pub struct SoftGap {
    /// g, m.
    pub gap: f64,
    /// F_0, N: force at which half the gap is closed.
    pub softness: f64,
}

impl SoftGap {
    /// No gap.
    pub const CLOSED: SoftGap = SoftGap { gap: 0.0, softness: 1.0 };

    /// Computes d(F) with a spring of compliance 1/k.
    #[inline(always)]
    pub fn deflection<R: Real>(&self, compliance: f64, force: R) -> R {
        let taken = force.abs().plus(self.softness).inverse() * self.gap;
        force * taken.plus(compliance)
    }

    /// Computes F(d) and dF/dd with a spring of stiffness `k`: |F| is the root of y² + (F_0 + k g − k|d|) y = k|d| F_0.
    #[inline(always)]
    pub fn force<R: Real>(&self, k: R, d: R) -> (R, R) {
        let alone = k * d.abs();
        let half = (k * self.gap - alone).plus(self.softness) * 0.5;
        let product = alone * self.softness;
        // A tiny number, far below the square of any force, avoids the square root of 0, which has no finite
        // derivative.
        let root = (half * half + product).plus(1e-30).sqrt();
        let size = if half.value() > 0.0 { product * (half + root).inverse() } else { root - half };
        let open = size.plus(self.softness).inverse();
        let stiffness = (k.inverse() + open * open * (self.gap * self.softness)).inverse();
        (if d.value() < 0.0 { -size } else { size }, stiffness)
    }
}
