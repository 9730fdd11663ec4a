//! The springs on the internal mass, evaluated within the reach ([`REACH`]) of the series spring about the moving end.

use crate::assembly::Elements;
use crate::element::{OperatingPoint, Response};
use crate::math::{max, min};
use crate::tables::Tables;

/// Deflection of the series spring, m, beyond which the force of the springs on the mass is extrapolated linearly.
pub(super) const REACH: f64 = 0.05;

/// Clamps a position `x` of the mass, m, to the reach of the series spring about the moving end at `driven`, m.
///
/// Without this limit, a jump of the input would give the derivative of a hardening spring at a position that the mass
/// never reaches.
#[inline(always)]
pub(super) fn within_reach(x: f64, driven: f64) -> f64 {
    let (low, high) = (driven - REACH, driven + REACH);
    min(high, max(low, x))
}

/// Evaluates the springs on the mass at position `x`, m, with the moving end at `driven`, m. The force is linear beyond
/// the reach of the series spring. `side` is the side force, N, and the temperature, °C.
///
/// Returns the response at the clamped position, the extrapolated force at `x`, and the clamped position.
#[inline(always)]
pub(super) fn springs(
    e: &Elements<impl Tables>,
    x: f64,
    velocity: f64,
    driven: f64,
    side: (f64, f64),
) -> (Response, f64, f64) {
    let at = within_reach(x, driven);
    let inner = e.inner(&OperatingPoint { displacement: at, velocity, side_force: side.0, temperature: side.1 });
    (inner, inner.force + inner.d_force_d_x * (x - at), at)
}

/// Half the width of the central difference for the second derivative of a spring, m.
const CURVATURE_WIDTH: f64 = 1e-6;

/// Computes the derivative, N/m, of the force of the springs' tangent, evaluated at the mass position `x_m`, with
/// respect to the position of the linearization. This position x̂ is the displacement of `at`. The derivative is
/// F_p''(x̂) (x_m − x̂) for the spring force F_p.
#[inline(never)]
pub(super) fn line_by_place(e: &Elements<impl Tables>, at: &OperatingPoint, x_m: f64) -> f64 {
    tangent_by_place(|at| e.inner(at), at, x_m)
}

/// Computes the derivative, N/m, of the force on the mass with respect to the displacement of the moving end. It is 0
/// within the reach of the series spring. Beyond it, the end of the reach moves with the moving end, and with it the
/// tangent that replaces the force.
#[inline(always)]
pub(super) fn tangent_by_driven(
    e: &Elements<impl Tables>,
    x_m: f64,
    velocity: f64,
    driven: f64,
    (side_force, temperature): (f64, f64),
) -> f64 {
    let displacement = within_reach(x_m, driven);
    if displacement == x_m {
        return 0.0;
    }
    beyond_reach(e, &OperatingPoint { displacement, velocity, side_force, temperature }, x_m)
}

/// Computes [`tangent_by_driven`] beyond the reach. Not inlined, because it is rare and every compiled set of elements
/// would contain it.
#[cold]
#[inline(never)]
fn beyond_reach(e: &Elements<impl Tables>, at: &OperatingPoint, x_m: f64) -> f64 {
    tangent_by_place(|at| e.on_the_mass(at), at, x_m)
}

/// Computes [`line_by_place`] for any force.
#[inline(always)]
fn tangent_by_place(force: impl Fn(&OperatingPoint) -> Response, at: &OperatingPoint, x_m: f64) -> f64 {
    let derivative = |x: f64| force(&OperatingPoint { displacement: x, ..*at }).d_force_d_x;
    let (low, high) = (derivative(at.displacement - CURVATURE_WIDTH), derivative(at.displacement + CURVATURE_WIDTH));
    (high - low) / (2.0 * CURVATURE_WIDTH) * (x_m - at.displacement)
}
