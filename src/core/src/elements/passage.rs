//! The flow through a passage beside the valves, over the force: r = F/(F² + F_l²)^¼, laminar far below F_l, turbulent far above.

use crate::dual::Real;

/// Force at which the flows are stated, N.
pub(crate) const STATED: f64 = 1000.0;

/// 1/r(1 kN) of a passage.
pub(crate) fn per_stated(laminar: f64) -> f64 {
    libm::sqrt(libm::hypot(STATED, laminar)) / STATED
}

/// r(F).
#[inline(always)]
pub(crate) fn law<R: Real>(force: R, laminar: f64) -> R {
    let root = (force * force).plus(laminar * laminar).sqrt().sqrt();
    force * root.inverse()
}
