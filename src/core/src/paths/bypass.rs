//! Oil that bypasses the valves: through grooves in the tube, or through the open bypass of frequency-selective
//! damping.
//!
//! u = w + b, b = q r(F_h)/r(1 kN), r = F/(F² + F_l²)^¼. All flows are piston velocities, m/s: u of the piston, w
//! through the valves, b through the bypass. q is b at a hydraulic force F_h of 1 kN. The flow is proportional to the
//! force far below the laminar force F_l, and to its square root far above F_l. A groove uses √(1 kN) instead of r(1
//! kN), which is smaller by one ten-thousandth: b = q r(F_h)/√(1 kN). Flows through parallel passages add. A bypass
//! therefore reduces the force more where the FV curve is steep than where a blow-off valve limits it.

use super::Paths;
use super::acting::acts;
use super::bits::{GROOVE, PASSAGE};
use super::{STATES, place};
use crate::dual::{Dual, Real};
use crate::elements::passage::{STATED, law};
use crate::tables::Tables;

/// Hydraulic force, N, below which the flow through a groove is laminar. It is small, because a groove is short.
const LAMINAR: f64 = 20.0;
/// Computes the flow through a groove relative to that at 1 kN: r(F)/√(1 kN), with the law r of
/// [`crate::elements::passage`]. `force` is the hydraulic force F, N.
#[inline(always)]
fn short<R: Real>(force: R) -> R {
    law(force, LAMINAR) * (1.0 / libm::sqrt(STATED))
}

/// Returns whether a bypass of the valves exists.
pub(crate) fn is_open(e: &Paths<impl Tables>) -> bool {
    e.has_groove() || e.has_passage()
}

/// Computes the flow that bypasses the valves at given states, as a piston velocity, m/s; 0 without a bypass. `force`
/// is the hydraulic force, N, and `x` the displacement, m.
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

/// Flow that bypasses the valves after an implicit stage, with its derivatives.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Past {
    /// Flow that bypasses the valves, as a piston velocity, m/s.
    pub flow: f64,
    /// Derivatives of the flow with respect to the hydraulic force, the displacement and the known part of the
    /// passage's state.
    pub flow_by: [f64; 3],
    /// State of the passage after the stage.
    pub state: f64,
    /// Derivatives of the passage's state with respect to the hydraulic force and the known part of this state.
    pub state_by: [f64; 2],
}

impl Past {
    /// No flow.
    pub const NONE: Past = Past { flow: 0.0, flow_by: [0.0; 3], state: 0.0, state_by: [0.0; 2] };

    /// Computes the flow under the hydraulic force `force`, N, of the current iteration, at displacement `x`, m.
    /// `known` is the known part of the passage's state, and `g` the weight of the state derivative in the stage, s.
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
