//! The series path: its force on the internal mass.

use super::Paths;
use super::acting::acts;
use super::bits::{ANY, BUSHING, FREE_PLAY};
use crate::dual::{Dual, Real};
use crate::tables::Tables;

/// Parameters of the series spring, damper and mass, as numbers that may carry derivatives.
#[derive(Clone, Copy, Debug)]
pub struct Frame<R> {
    /// Stiffness of the series spring, N/m.
    pub stiffness: R,
    /// Damping of the series damper, N s/m.
    pub damping: R,
    /// Internal mass, kg.
    pub mass: R,
}

impl<R: Real> Frame<R> {
    /// Returns stiffness, damping and mass of the model, with zero derivatives.
    #[inline(always)]
    pub fn new(e: &Paths<impl Tables>) -> Frame<R> {
        let s = &e.series_compliance;
        Frame { stiffness: R::constant(s.stiffness), damping: R::constant(s.damping), mass: R::constant(s.mass) }
    }
}

/// Computes the elastic force of the series path, N, its derivative, N/m, and the closed fraction of the free play's
/// contact, from 0 to 1. `stiffness` is that of the series spring, N/m, and `deflection` that of the path, m.
#[inline(always)]
fn elastic<const ON: u32, R: Real>(e: &Paths<impl Tables>, stiffness: R, deflection: R) -> (R, R, R) {
    let (mut force, mut derivative, mut closed) = (stiffness * deflection, stiffness, R::constant(1.0));
    if acts::<ON>(e, FREE_PLAY) {
        (force, derivative) = e.free_play.force(stiffness, deflection);
        closed = derivative * stiffness.inverse();
    }
    if acts::<ON>(e, BUSHING) {
        (force, derivative) = e.bushing.hardened(stiffness, force, derivative);
    }
    (force, derivative, closed)
}

/// Computes the series force, N, from the deflection, m, its rate, m/s, and the two relaxing deflections of a bushing,
/// m.
#[inline(always)]
pub fn force<R: Real>(e: &Paths<impl Tables>, frame: &Frame<R>, deflection: R, rate: R, relaxing: [R; 2]) -> R {
    let (elastic, _, closed) = elastic::<ANY, _>(e, frame.stiffness, deflection);
    let mut force = elastic + frame.damping * closed * rate;
    if e.has_bushing() {
        force = force + frame.stiffness * e.bushing.relaxing(relaxing);
    }
    force
}

/// Series force in a stage of the step, with its derivatives.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Derivatived {
    /// Force of the series path, N.
    pub force: f64,
    /// Derivatives of the force with respect to the deflection, its rate, the bushing's relaxing deflection, and the
    /// stiffness and damping of the series compliance. The relaxing deflection is the force of the relaxing elements
    /// over the series stiffness.
    pub by_deflection: f64,
    pub by_rate: f64,
    pub by_relaxing: f64,
    pub by_stiffness: f64,
    pub by_damping: f64,
}

impl Derivatived {
    /// A stage without a series path.
    pub const NONE: Derivatived = Derivatived {
        force: 0.0,
        by_deflection: 0.0,
        by_rate: 0.0,
        by_relaxing: 0.0,
        by_stiffness: 0.0,
        by_damping: 0.0,
    };
}

/// Computes the force of the series path in a stage, with its derivatives, from the deflection, m, and its rate, m/s.
/// `relaxing` is the force of a bushing's relaxing elements over the series stiffness, m.
#[inline(always)]
pub(crate) fn with_derivatives<const ON: u32>(
    e: &Paths<impl Tables>,
    deflection: f64,
    rate: f64,
    relaxing: f64,
) -> Derivatived {
    let (k, c) = (e.series_compliance.stiffness, e.series_compliance.damping);
    let mut s = Derivatived {
        force: k * deflection + c * rate,
        by_deflection: k,
        by_rate: c,
        by_relaxing: 0.0,
        by_stiffness: deflection,
        by_damping: rate,
    };
    if acts::<ON>(e, FREE_PLAY | BUSHING) {
        let (force, _, closed) = elastic::<ON, _>(e, Dual::<2>::along(k, 1), Dual::along(deflection, 0));
        let force = force + closed * (c * rate);
        s.force = force.value;
        [s.by_deflection, s.by_stiffness] = force.derivatives;
        s.by_rate = c * closed.value;
        s.by_damping = closed.value * rate;
    }
    if acts::<ON>(e, BUSHING) {
        s.by_relaxing = k;
        s.force += k * relaxing;
        s.by_stiffness += relaxing;
    }
    s
}

/// Computes the elastic force of the series path, N, and its derivative, N/m, at a deflection, m, for the equilibrium.
pub fn static_force(e: &Paths<impl Tables>, deflection: f64) -> (f64, f64) {
    let (force, derivative, _) = elastic::<ANY, _>(e, e.series_compliance.stiffness, deflection);
    (force, derivative)
}

/// Returns an upper bound of the deflection of the series path, m, under a force, N.
pub fn furthest(e: &Paths<impl Tables>, force: f64) -> f64 {
    let gap = if e.has_free_play() { e.free_play.furthest() } else { 0.0 };
    force.abs() / e.series_compliance.stiffness + gap
}
