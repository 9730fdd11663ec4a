//! The series path: what pulls at the internal mass.

use crate::dual::Real;
use crate::elements::Elements;

/// The series spring and damper, as numbers that may be differentiated by.
#[derive(Clone, Copy, Debug)]
pub struct Frame<R> {
    /// k_s.
    pub stiffness: R,
    /// c_s.
    pub damping: R,
    /// m.
    pub mass: R,
}

impl<R: Real> Frame<R> {
    /// That of the model.
    #[inline(always)]
    pub fn of(e: &Elements) -> Frame<R> {
        let s = &e.series_compliance;
        Frame { stiffness: R::constant(s.stiffness), damping: R::constant(s.damping), mass: R::constant(s.mass) }
    }
}

/// The elastic force φ and its slope φ' at a deflection, and the share of the contact that is closed, from 0 to 1.
#[inline(always)]
fn elastic<R: Real>(e: &Elements, stiffness: R, deflection: R) -> (R, R, R) {
    let (mut force, mut slope, mut closed) = (stiffness * deflection, stiffness, R::constant(1.0));
    if e.has_free_play() {
        (force, slope) = e.free_play.0.force(stiffness, deflection);
        closed = slope * stiffness.inverse();
    }
    if e.has_bushing() {
        (force, slope) = e.bushing.hardened(stiffness, force, slope);
    }
    (force, slope, closed)
}

/// F_s at a deflection, its rate, and the Maxwell spring's deflection z.
#[inline(always)]
pub fn force<R: Real>(e: &Elements, frame: &Frame<R>, deflection: R, rate: R, maxwell: R) -> R {
    let (elastic, _, closed) = elastic(e, frame.stiffness, deflection);
    let mut force = elastic + frame.damping * closed * rate;
    if e.has_bushing() {
        force = force + frame.stiffness * maxwell * e.bushing.share;
    }
    force
}

/// The elastic force and its slope, for the static answer.
pub fn held(e: &Elements, deflection: f64) -> (f64, f64) {
    let (force, slope, _) = elastic(e, e.series_compliance.stiffness, deflection);
    (force, slope)
}

/// Most that the path yields to a force.
pub fn furthest(e: &Elements, force: f64) -> f64 {
    let gap = if e.has_free_play() { e.free_play.0.gap } else { 0.0 };
    force.abs() / e.series_compliance.stiffness + gap
}
