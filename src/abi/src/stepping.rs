//! Checks and warnings of every step, and the step of a damper without a setting.

use dashpot_core::step::{LONG_STEP, step_in_place};
use dashpot_core::{Input, Model, Output, State};

use crate::state::{computed, dashpot_output, dashpot_state};
use crate::status::{DASHPOT_BAD_TIME_STEP, DASHPOT_LONG_STEP, DASHPOT_OK, DASHPOT_OUTSIDE_RANGE, Rejected};

/// Longest accepted step, s. A longer step indicates a wrong unit.
const LONGEST_STEP: f64 = 100.0;
/// Shortest accepted step other than 0, s. A shorter step is indistinguishable from 0.
const SHORTEST_STEP: f64 = 1e-15;

// The comparison does not use `contains`, which costs seven more instructions in every step.
#[allow(clippy::manual_range_contains)]
#[inline(always)]
pub(crate) fn checked_step(dt: f64) -> Result<f64, Rejected> {
    if dt >= SHORTEST_STEP && dt <= LONGEST_STEP || dt == 0.0 { Ok(dt) } else { Err(Rejected(DASHPOT_BAD_TIME_STEP)) }
}

/// Returns the warnings for a step of `dt`, s: a step that is too long, or a velocity, m/s, outside the FV curve.
#[inline(always)]
pub(crate) fn warnings(model: &Model, velocity: f64, dt: f64) -> i32 {
    if dt > LONG_STEP {
        return long(model, velocity);
    }
    range_warning(model, velocity)
}

/// Returns the warnings for a step longer than [`LONG_STEP`]. It is a separate cold function, so that other steps stay fast.
#[cold]
#[inline(never)]
fn long(model: &Model, velocity: f64) -> i32 {
    range_warning(model, velocity) | DASHPOT_LONG_STEP
}

/// Returns `DASHPOT_OUTSIDE_RANGE` for a velocity, m/s, outside the points of the FV curve, otherwise `DASHPOT_OK`.
#[inline(always)]
pub(crate) fn range_warning(model: &Model, velocity: f64) -> i32 {
    let (low, high) = model.elements().paths.fv_curve.range();
    if velocity >= low && velocity <= high { DASHPOT_OK } else { outside(model, velocity) }
}

/// Returns the warning for a velocity, m/s, outside the points of the FV curve. A damper without an FV curve gets no warning.
///
/// It is a separate cold function, so that steps without a warning stay fast.
#[cold]
#[inline(never)]
fn outside(model: &Model, velocity: f64) -> i32 {
    if model.covers(velocity) { DASHPOT_OK } else { DASHPOT_OUTSIDE_RANGE }
}

/// Makes one step with checked arguments. Returns an error if the results are not finite.
///
/// # Safety
/// The pointers are valid and aligned. `from` and `to` may be equal.
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
    // SAFETY: the caller guarantees a valid, aligned pointer. Both types have the same layout (asserted in `state`).
    let output = unsafe { &mut *output.cast::<Output>() };
    // If `from` and `to` differ, the step works on a copy. So the states may overlap partially, and a rejected step changes neither state.
    let mut apart;
    let state = if from.cast() == to.cast_const() {
        // SAFETY: the caller guarantees a valid, aligned pointer. This is the only reference, because `from` equals `to`.
        unsafe { &mut *to }
    } else {
        // SAFETY: the caller guarantees a valid, aligned pointer.
        apart = unsafe { *from.cast::<State>() };
        &mut apart
    };
    computed(step_in_place(model, state, input, dt, output))?;
    if !core::ptr::eq(state, to) {
        let reached = *state;
        // SAFETY: the caller guarantees a valid, aligned pointer. No other reference to it exists.
        unsafe { *to = reached };
    }
    Ok(())
}
