//! The hydraulic path: what the valves make of the oil's velocity, and what the oil makes of the piston's.

use super::place;
use super::{STATES, soft_gap::SoftGap};
use crate::dual::Real;
use crate::elements::Elements;

/// What surrounds the path at one instant.
#[derive(Clone, Copy, Debug)]
pub struct Around<R> {
    /// Displacement of the driven end.
    pub x: R,
    /// Its velocity.
    pub v: R,
    /// Temperature that the host gives.
    pub temperature: f64,
}

/// The force of the valves and what became of their states.
#[derive(Clone, Copy, Debug)]
pub struct Flow<R> {
    /// F_h.
    pub force: R,
    /// Force before frequency-selective damping, what that is drawn to, and its state.
    pub selective_target: R,
    /// State of frequency-selective damping.
    pub selective: R,
    /// What the valve's opening is drawn to.
    pub valve_target: R,
    /// The valve's opening.
    pub valve: R,
}

/// Leakage beside the valves, N s/m, where an oil column is: so that a force finds its velocity even where the FV curve
/// is level. Far below all that is measured.
const LEAKAGE: f64 = 0.01;

/// F_h = N(s F_d(w)) where `curve` is F_d(w), after an implicit stage of `g` from the `known` states; `g` = 0 takes the
/// states as they are. What the FV curve has at standstill is no flow's: the force `standing` keeps its size.
#[inline(always)]
pub fn flow<R: Real>(
    e: &Elements,
    curve: R,
    standing: R,
    w: R,
    around: &Around<R>,
    known: &[R; STATES],
    g: f64,
) -> Flow<R> {
    let mut above = curve - standing;
    if e.has_position() {
        above = above * e.position_dependent_damping.factor(around.x, above.value() >= 0.0);
    }
    if e.has_fade() {
        above = above * e.temperature_fade.factor(around.temperature, known[place::HEAT]);
    }
    let mut force = above + standing;
    let (mut valve, mut valve_target) = (known[place::VALVE], known[place::VALVE]);
    if e.has_valve() {
        valve = if g > 0.0 { e.valve_hysteresis.stage(force, valve, g) } else { valve };
        valve_target = e.valve_hysteresis.target(force, valve);
        force = e.valve_hysteresis.force(force, valve);
    }
    let (mut selective, mut selective_target) = (known[place::SELECTIVE], known[place::SELECTIVE]);
    if e.has_frequency_selective() {
        let element = &e.frequency_selective_damping;
        selective_target = element.target(force, w);
        let per = g * element.per_time;
        selective = (selective + selective_target * per) * (1.0 / (1.0 + per));
        force = element.force(force, w, selective);
    }
    if e.has_column() {
        force = force + w * LEAKAGE;
    }
    Flow { force, selective_target, selective, valve_target, valve }
}

/// The oil column as air in line with oil, and the oil's compliance.
#[inline(always)]
fn column(e: &Elements) -> (SoftGap, f64) {
    (e.aeration.0, e.oil_compressibility.compliance)
}

/// q(F_h).
#[inline(always)]
pub fn deflection<R: Real>(e: &Elements, force: R) -> R {
    let (air, compliance) = column(e);
    air.deflection(compliance, force)
}

/// F_h = φ_o(q).
#[inline(always)]
pub fn column_force<R: Real>(e: &Elements, deflection: R) -> R {
    let (air, compliance) = column(e);
    air.force(R::constant(1.0 / compliance), deflection).0
}
