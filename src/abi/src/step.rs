//! Step
//!
//! For hosts with a fixed step. A step runs from the time of a state to a time later by dt. The input is the one at the
//! end of the step. The input at the start of the step is not needed again, because the state contains its displacement
//! and velocity.
//!
//! dt = 0 is a static evaluation: the equilibrium force at constant displacement and velocity. Presliding friction keeps its
//! deflection from the motion before. The state does not change.

use dashpot_core::Input;
use dashpot_core::step::force_in_place;

use crate::family as over_setting;
use crate::input::{self, dashpot_input, sane};
use crate::model::{dashpot_model, prepared, prepared_aligned, ready};
use crate::pointer::{aligned, present};
use crate::state::{dashpot_output, dashpot_state, finite};
use crate::status::{DASHPOT_BAD_INPUT, DASHPOT_NOT_COMPUTABLE, DASHPOT_OK, Rejected, status};
use crate::stepping::{checked_step, move_on, warnings};

/// Computes the force (N) from the velocity (m/s) and advances *state by dt (s).
///
/// The displacement is integrated from the initial position. A damper that depends on a setting is at its start setting; see
/// dashpot_force_with_setting(). The force equals that of dashpot_step() to the bit, at a cost lower by a tenth to a quarter, because no
/// partial derivatives are computed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn dashpot_force(
    model: *const dashpot_model,
    state: *mut dashpot_state,
    velocity: f64,
    dt: f64,
    force: *mut f64,
) -> i32 {
    status((|| {
        aligned!(model, state, force);
        // SAFETY: `aligned!` checked the alignment, the callee rejects null, and the manual (`lib.rs`) guarantees the rest.
        let Ok(model) = (unsafe { prepared_aligned(model) }) else {
            // SAFETY: as above.
            return unsafe { over_setting::force(model, state, velocity, None, dt, force) };
        };
        // SAFETY: as for the model.
        unsafe { finite(state)? };
        if !sane(velocity) {
            return Err(Rejected(DASHPOT_BAD_INPUT));
        }
        let dt = checked_step(dt)?;
        present(force)?;
        // SAFETY: the checks above exclude null and misaligned pointers. Both types have the same layout (asserted in `state`).
        let found = force_in_place(model, unsafe { &mut *state.cast() }, &Input::velocity(velocity), dt);
        let found = found.ok_or(Rejected(DASHPOT_NOT_COMPUTABLE))?;
        // SAFETY: the checks above exclude a null or misaligned `force`.
        unsafe { *force = found };
        Ok(warnings(model, velocity, dt))
    })())
}

/// Advances the state *from by one step of dt (s), at whose end the input is *to_input. Writes the new state to *to and
/// the output at the end of the step to *output.
///
/// from and to may be the same state; otherwise *from is not changed, so a step may be tried and repeated.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn dashpot_step(
    model: *const dashpot_model,
    from: *const dashpot_state,
    to_input: *const dashpot_input,
    dt: f64,
    to: *mut dashpot_state,
    output: *mut dashpot_output,
) -> i32 {
    status((|| {
        aligned!(model, from, to_input, to, output);
        // SAFETY: `aligned!` checked the alignment, the callee rejects null, and the manual (`lib.rs`) guarantees the rest.
        let Ok(model) = (unsafe { prepared_aligned(model) }) else {
            // SAFETY: as above.
            return unsafe { over_setting::step(model, from, to_input, dt, to, output) };
        };
        // SAFETY: as for the model.
        unsafe { finite(from)? };
        // SAFETY: as for the model.
        let input = unsafe { input::checked(to_input)? };
        let dt = checked_step(dt)?;
        present(to)?;
        present(output)?;
        // SAFETY: the checks above exclude null and misaligned pointers. The manual allows `from` and `to` to be equal.
        unsafe { move_on(model, from, &input, dt, to, output)? };
        Ok(warnings(model, input.velocity, dt))
    })())
}

/// Advances count dampers by one step of dt (s), such as the four corners of a car.
///
/// models holds count pointers, which may point to the same model. from, to_inputs, to and outputs hold count elements each. from and to
/// may be the same array. The results equal those of count calls of dashpot_step() to the last bit. All arguments are checked first: an
/// error of one damper leaves every output unchanged. Only DASHPOT_NOT_COMPUTABLE occurs later: the dampers before the failed one are then
/// advanced, and the failed one and all after it are unchanged. Returns all warnings combined.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn dashpot_step_batch(
    count: u32,
    models: *const *const dashpot_model,
    from: *const dashpot_state,
    to_inputs: *const dashpot_input,
    dt: f64,
    to: *mut dashpot_state,
    outputs: *mut dashpot_output,
) -> i32 {
    status((|| {
        let dt = checked_step(dt)?;
        // The manual allows null for an array without elements.
        if count == 0 {
            return Ok(DASHPOT_OK);
        }
        aligned!(models, from, to_inputs, to, outputs);
        present(models)?;
        present(to)?;
        present(outputs)?;
        present(from)?;
        present(to_inputs)?;
        let count = count as usize;
        let mut known: *const dashpot_model = core::ptr::null();
        for i in 0..count {
            // SAFETY: `aligned!` checked the alignment, and the manual (`lib.rs`) guarantees `count` elements in each array. This loop
            // checks all arguments before anything is written.
            unsafe {
                let model = *models.add(i);
                // The corners of a car share one or two models. Consecutive equal models are checked once.
                if model != known || known.is_null() {
                    if prepared(model).is_err() {
                        return over_setting::step_batch(count, models, from, to_inputs, dt, to, outputs);
                    }
                    known = model;
                }
                finite(from.add(i))?;
                input::checked(to_inputs.add(i))?;
            }
        }
        let mut status = DASHPOT_OK;
        for i in 0..count {
            // SAFETY: `aligned!` checked the alignment, and the manual (`lib.rs`) guarantees `count` elements in each array. The first
            // loop checked all arguments before anything is written.
            unsafe {
                let model = ready(*models.add(i));
                let input = input::taken(to_inputs.add(i));
                status |= warnings(model, input.velocity, dt);
                move_on(model, from.add(i), &input, dt, to.add(i), outputs.add(i))?;
            }
        }
        Ok(status)
    })())
}
