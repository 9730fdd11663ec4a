//! Flow through a passage parallel to the valves as a function of the force: r = F/(F² + F_l²)^¼.
//!
//! The flow is laminar far below F_l and turbulent far above.

use crate::dual::Real;

/// Force to which the flow parameters refer, N.
pub(crate) const STATED: f64 = 1000.0;

/// Computes 1/r(1 kN) of a passage with the laminar force F_l = `laminar`, N.
pub(crate) fn per_stated(laminar: f64) -> f64 {
    libm::sqrt(libm::hypot(STATED, laminar)) / STATED
}

/// Computes r(F) of a passage with the laminar force F_l = `laminar`, N.
#[inline(always)]
pub(crate) fn law<R: Real>(force: R, laminar: f64) -> R {
    let root = (force * force).plus(laminar * laminar).sqrt().sqrt();
    force * root.inverse()
}
