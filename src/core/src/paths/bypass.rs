//! Oil that flows past the valves: through grooves in the tube, or through the open bypass of frequency-selective damping.
//!
//! u = w + b, b = q √(F_h / 1 kN), smooth through zero: flows through parallel passages add, so a bypass takes more force
//! where the FV curve is steep than where a blow-off valve holds it.

use super::acting::{GROOVE, PASSAGE, acts};
use super::{STATES, place};
use crate::dual::{Dual, Real};
use crate::elements::Elements;

/// Force below which the flow is proportional to it, N.
const LAMINAR: f64 = 20.0;
/// Force at which the flows are stated, N.
const STATED: f64 = 1000.0;

/// √(F / 1 kN) with the sign of F.
#[inline(always)]
fn orifice<R: Real>(force: R) -> R {
    let root = (force * force).plus(LAMINAR * LAMINAR).sqrt().sqrt();
    force * root.inverse() * (1.0 / libm::sqrt(STATED))
}

/// Whether oil flows past the valves.
pub(crate) fn is_open(e: &Elements) -> bool {
    e.has_groove() || e.has_passage()
}

/// b at given states, m/s; 0 where nothing is open.
#[inline(always)]
pub fn flow<R: Real>(e: &Elements, force: R, x: R, states: &[R; STATES]) -> R {
    let mut at_stated = R::constant(0.0);
    if !is_open(e) {
        return at_stated;
    }
    if e.has_groove() {
        at_stated = at_stated + e.position_dependent_damping.groove(x, force.value() >= 0.0);
    }
    if e.has_passage() {
        at_stated = at_stated + e.frequency_selective_damping.passes(force, states[place::SELECTIVE]);
    }
    at_stated * orifice(force)
}

/// b after an implicit stage, with its slopes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Past {
    /// b.
    pub flow: f64,
    /// Over F_h, the displacement and the known state.
    pub flow_by: [f64; 3],
    /// State of the passage after the stage.
    pub state: f64,
    /// Over F_h and the known state.
    pub state_by: [f64; 2],
}

impl Past {
    /// No flow.
    pub const NONE: Past = Past { flow: 0.0, flow_by: [0.0; 3], state: 0.0, state_by: [0.0; 2] };

    /// From the `known` states and the force that the stage tries, at displacement `x`.
    #[inline(always)]
    pub fn stage<const ON: u32>(e: &Elements, force: f64, x: f64, known: f64, g: f64) -> Past {
        let force = Dual::<3>::along(force, 0);
        let mut at_stated = Dual::constant(0.0);
        let (mut state, mut state_by) = (known, [0.0, 1.0]);
        if acts::<ON>(e, GROOVE) {
            let x = Dual::along(x, 1);
            at_stated = at_stated + e.position_dependent_damping.groove(x, force.value >= 0.0);
        }
        if acts::<ON>(e, PASSAGE) {
            let z = e.frequency_selective_damping.filled(force, Dual::along(known, 2), g);
            at_stated = at_stated + e.frequency_selective_damping.passes(force, z);
            (state, state_by) = (z.value, [z.slope(0), z.slope(2)]);
        }
        let flow = at_stated * orifice(force);
        Past { flow: flow.value, flow_by: flow.slopes, state, state_by }
    }
}
