//! A spring in series with a gap that closes gradually: the law of a worn eye, and of oil that contains air.

use crate::dual::Real;

/// Spring and soft gap with the deflection d(F) = F/k + g F/(|F| + F_0), m, under the force F, N.
///
/// k is the stiffness of the spring, N/m. At forces far above F_0, the deflection is that of the spring plus g on
/// either side; the law is softest at F = 0.
#[derive(Clone, Copy, Debug)]
pub struct SoftGap {
    /// Half the gap, g, m: the free travel to either side.
    pub gap: f64,
    /// Force F_0 at which the gap is half closed, N.
    pub softness: f64,
}

impl SoftGap {
    /// No gap.
    pub const CLOSED: SoftGap = SoftGap { gap: 0.0, softness: 1.0 };

    /// Computes the deflection d(F), m, under the force `force`, N, with a spring of `compliance` 1/k, m/N.
    #[inline(always)]
    pub fn deflection<R: Real>(&self, compliance: f64, force: R) -> R {
        let taken = force.abs().plus(self.softness).inverse() * self.gap;
        force * taken.plus(compliance)
    }

    /// Computes the force F, N, and dF/dd, N/m, at the deflection `d`, m, with a spring of stiffness `k`, N/m. |F| is
    /// the positive root y of y² + (F_0 + k g − k|d|) y = k|d| F_0.
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
