//! Flow through a passage parallel to the valves, proportional to r = F/(F² + F_l²)^¼ of the hydraulic force F.
//!
//! The flow is laminar (r proportional to F) far below the force F_l, and turbulent (r near √F) far above it.

use crate::dual::Real;

/// Hydraulic force, N, at which the parameters of bypass flows give the flow.
pub(crate) const STATED: f64 = 1000.0;

/// Computes 1/r at the force 1 kN for the law r(F) = F/(F² + F_l²)^¼ of a passage; `laminar` is F_l, N.
pub(crate) fn per_stated(laminar: f64) -> f64 {
    libm::sqrt(libm::hypot(STATED, laminar)) / STATED
}

/// Computes the flow law r(F) = F/(F² + F_l²)^¼ of a passage, √N, at the force `force`, N; `laminar` is F_l, N.
#[inline(always)]
pub(crate) fn law<R: Real>(force: R, laminar: f64) -> R {
    let root = (force * force).plus(laminar * laminar).sqrt().sqrt();
    force * root.inverse()
}
