//! The springs on the mass, as far from the driven end as a series spring reaches.

use crate::assembly::Elements;
use crate::element::{Motion, Response};
use crate::math::{larger, smaller};
use crate::tables::Tables;

/// Deflection of the series spring, m, beyond which the springs on the mass are taken as straight.
pub(super) const REACH: f64 = 0.05;

/// A place no further from the driven end than a series spring reaches: a mass flung by a jump would else take the slope of a
/// hardening spring from where it will never be.
#[inline(always)]
pub(super) fn within_reach(x: f64, driven: f64) -> f64 {
    let (low, high) = (driven - REACH, driven + REACH);
    smaller(high, larger(low, x))
}

/// The springs on the mass at a place, straight beyond the reach of the series spring about the driven end: as if from the place
/// given, with the force at x itself.
#[inline(always)]
pub(super) fn springs(
    e: &Elements<impl Tables>,
    x: f64,
    velocity: f64,
    driven: f64,
    side: (f64, f64),
) -> (Response, f64, f64) {
    let at = within_reach(x, driven);
    let inner = e.inner(&Motion { displacement: at, velocity, side_force: side.0, temperature: side.1 });
    (inner, inner.force + inner.by_x * (x - at), at)
}
