//! Oil that bypasses the valves: through grooves in the tube, or through the open bypass of frequency-selective
//! damping.
//!
//! u = w + b, b = q r(F_h)/r(1 kN), r = F/(F² + F_l²)^¼. All flows are piston velocities: u of the piston, w through
//! the valves, b through the bypass. q is b at a hydraulic force F_h of 1 kN. The flow is proportional to the force far
//! below F_l, and to its square root far above F_l. A groove uses √(1 kN) instead of r(1 kN), which is smaller by one
//! ten-thousandth: b = q r(F_h)/√(1 kN). Flows through parallel passages add. A bypass therefore reduces the force more
//! where the FV curve is steep than where a blow-off valve limits it.

use super::Paths;
use super::acting::acts;
use super::bits::{GROOVE, PASSAGE};
use super::{STATES, place};
use crate::dual::{Dual, Real};
use crate::elements::passage::{STATED, law};
use crate::tables::Tables;

/// F_l of a groove, N: the force below which its flow is laminar. It is small, because a groove is short.
const LAMINAR: f64 = 20.0;
/// Computes r(F)/√(1 kN) of a groove.
#[inline(always)]
fn short<R: Real>(force: R) -> R {
    law(force, LAMINAR) * (1.0 / libm::sqrt(STATED))
}

/// Returns whether a bypass of the valves exists.
pub(crate) fn is_open(e: &Paths<impl Tables>) -> bool {
    e.has_groove() || e.has_passage()
}

/// Computes b at given states, m/s; 0 without a bypass.
#[inline(always)]
pub fn flow<R: Real>(e: &Paths<impl Tables>, force: R, x: R, states: &[R; STATES]) -> R {
    let mut flow = R::constant(0.0);
    if e.has_groove() {
        flow = e.position_dependent_damping.groove(x, force.value() >= 0.0) * short(force);
    }
    if e.has_passage() {
        flow = flow + e.frequency_selective_damping.passes(force, states[place::SELECTIVE]);
    }
    flow
}

/// Flow b after an implicit stage, with its derivatives.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Past {
    /// b.
    pub flow: f64,
    /// Derivatives of b with respect to F_h, displacement and the known part of the passage's state.
    pub flow_by: [f64; 3],
    /// State of the passage after the stage.
    pub state: f64,
    /// Derivatives of the passage's state with respect to F_h and the known part of this state.
    pub state_by: [f64; 2],
}

impl Past {
    /// No flow.
    pub const NONE: Past = Past { flow: 0.0, flow_by: [0.0; 3], state: 0.0, state_by: [0.0; 2] };

    /// Computes the flow under the force of the current iteration, at displacement `x`. `known` is the known part of
    /// the passage's state, and `g` the factor of the state derivative in the stage.
    #[inline(always)]
    pub fn stage<const ON: u32>(e: &Paths<impl Tables>, force: f64, x: f64, known: f64, g: f64) -> Past {
        let force = Dual::<3>::along(force, 0);
        let mut flow = Dual::constant(0.0);
        let (mut state, mut state_by) = (known, [0.0, 1.0]);
        if acts::<ON>(e, GROOVE) {
            let x = Dual::along(x, 1);
            flow = e.position_dependent_damping.groove(x, force.value >= 0.0) * short(force);
        }
        if acts::<ON>(e, PASSAGE) {
            let z = e.frequency_selective_damping.filled(force, Dual::along(known, 2), g);
            flow = flow + e.frequency_selective_damping.passes(force, z);
            (state, state_by) = (z.value, [z.derivative(0), z.derivative(2)]);
        }
        Past { flow: flow.value, flow_by: flow.derivatives, state, state_by }
    }
}
