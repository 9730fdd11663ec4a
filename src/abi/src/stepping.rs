//! What every step asks and does, whether or not the damper depends on a setting.

use dashpot_core::step::{LONG_STEP, step_in_place};
use dashpot_core::{Input, Model, Output, State};

use crate::state::{computed, dashpot_output, dashpot_state};
use crate::status::{DASHPOT_BAD_TIME_STEP, DASHPOT_LONG_STEP, DASHPOT_OK, DASHPOT_OUTSIDE_RANGE, Rejected};

/// Longer steps are a mistake in the unit, s.
const LONGEST_STEP: f64 = 100.0;
/// Shorter steps cannot be told from 0, s.
const SHORTEST_STEP: f64 = 1e-15;

// Written out: `contains` costs seven instructions more in every step.
#[allow(clippy::manual_range_contains)]
#[inline(always)]
pub(crate) fn checked_step(dt: f64) -> Result<f64, Rejected> {
    if dt >= SHORTEST_STEP && dt <= LONGEST_STEP || dt == 0.0 { Ok(dt) } else { Err(Rejected(DASHPOT_BAD_TIME_STEP)) }
}

/// The warnings for a step.
#[inline(always)]
pub(crate) fn warnings(model: &Model, velocity: f64, dt: f64) -> i32 {
    if dt > LONG_STEP {
        return long(model, velocity);
    }
    range_warning(model, velocity)
}

/// The warnings for a step that is too long, out of the way of the others.
#[cold]
#[inline(never)]
fn long(model: &Model, velocity: f64) -> i32 {
    range_warning(model, velocity) | DASHPOT_LONG_STEP
}

/// The warning for a velocity.
#[inline(always)]
pub(crate) fn range_warning(model: &Model, velocity: f64) -> i32 {
    let (low, high) = model.elements().paths.fv_curve.range();
    if velocity >= low && velocity <= high { DASHPOT_OK } else { outside(model, velocity) }
}

/// Out of the way of steps without a warning.
#[cold]
#[inline(never)]
fn outside(model: &Model, velocity: f64) -> i32 {
    if model.covers(velocity) { DASHPOT_OK } else { DASHPOT_OUTSIDE_RANGE }
}

/// One checked step.
///
/// # Safety
/// Valid, aligned pointers; `from` and `to` may be the same.
#[inline(always)]
pub(crate) unsafe fn move_on(
    model: &Model,
    from: *const dashpot_state,
    input: &Input,
    dt: f64,
    to: *mut dashpot_state,
    output: *mut dashpot_output,
) -> Result<(), Rejected> {
    let to = to.cast::<State>();
    // SAFETY: valid and aligned by the caller's promise; the same bytes under C names (asserted in `state`).
    let output = unsafe { &mut *output.cast::<Output>() };
    // Through a value where they are two: nothing is said about states that overlap by half, and a refused step leaves them.
    let mut apart;
    let state = if from.cast() == to.cast_const() {
        // SAFETY: valid and aligned by the caller's promise; one reference, since `from` is the same.
        unsafe { &mut *to }
    } else {
        // SAFETY: valid and aligned by the caller's promise.
        apart = unsafe { *from.cast::<State>() };
        &mut apart
    };
    computed(step_in_place(model, state, input, dt, output))?;
    if !core::ptr::eq(state, to) {
        let reached = *state;
        // SAFETY: valid and aligned by the caller's promise; no reference to it is left.
        unsafe { *to = reached };
    }
    Ok(())
}
