//! Evaluation
//!
//! For hosts whose own solver integrates the states: force, rates and partial derivatives at one instant. The functions
//! read the state and do not change it.
//!
//! The states that the solver integrates are, in this order: displacement of the internal mass, its velocity, and the
//! internal states. dashpot_model_states() returns their number, dashpot_model_state_name() their names. All entries after
//! them in a structure are 0 and stay 0. Without series_compliance the internal mass moves with the moving end: its two
//! rates are 0. A host without a displacement integrates that too (rate->displacement is the velocity). state->velocity is
//! the last input of a step and no state: it is ignored, and its rate is 0.
//!
//! The states are stiff: the small mass behind the valves follows at rates of 1e4 to 1e6 1/s, which `dashpot check` reports for
//! a model file. An implicit solver with the partial derivatives (CVODE, DASSL, Radau) takes long steps. An explicit one
//! (Euler, Runge-Kutta) needs steps of microseconds; longer steps may yield a wrong force with status 0. dashpot_step() is
//! stable at every step.

use dashpot_core::evaluate::partials;
use dashpot_core::{Output, Partials, State};

use crate::family as over_setting;
use crate::input::{self, dashpot_input};
use crate::model::{dashpot_model, prepared_aligned};
use crate::partials::dashpot_partials;
use crate::pointer::{aligned, present};
use crate::state::{checked, computed, dashpot_output, dashpot_state};
use crate::status::status;
use crate::stepping::range_warning;

/// Evaluates force and state derivatives at *state and *input: writes the output to *output, d(state)/dt to *rate.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn dashpot_evaluate(
    model: *const dashpot_model,
    state: *const dashpot_state,
    input: *const dashpot_input,
    output: *mut dashpot_output,
    rate: *mut dashpot_state,
) -> i32 {
    status((|| {
        aligned!(model, state, input, output, rate);
        // SAFETY: `aligned!` checked the alignment, the callee rejects null, and the manual (`lib.rs`) guarantees the rest.
        let Ok(model) = (unsafe { prepared_aligned(model) }) else {
            // SAFETY: as above.
            return unsafe { over_setting::evaluate(model, state, input, output, rate) };
        };
        // SAFETY: as above.
        let (state, input) = unsafe { (checked(state)?, input::checked(input)?) };
        present(output)?;
        present(rate)?;
        let (answer, rates) = dashpot_core::evaluate(model, &state, &input);
        computed(answer.is_finite() && rates.is_finite())?;
        // SAFETY: the checks above exclude null and misaligned pointers. Both types have the same layout (asserted in
        // `state`).
        unsafe {
            *output.cast::<Output>() = answer;
            *rate.cast::<State>() = rates;
        }
        Ok(range_warning(model, input.velocity))
    })())
}

/// Writes all partial derivatives of force and rates at *state and *input to *partials.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn dashpot_jacobian(
    model: *const dashpot_model,
    state: *const dashpot_state,
    input: *const dashpot_input,
    partials: *mut dashpot_partials,
) -> i32 {
    status((|| {
        aligned!(model, state, input, partials);
        // SAFETY: `aligned!` checked the alignment, the callee rejects null, and the manual (`lib.rs`) guarantees the rest.
        let Ok(model) = (unsafe { prepared_aligned(model) }) else {
            // SAFETY: as above.
            return unsafe { over_setting::jacobian(model, state, input, partials, core::ptr::null_mut()) };
        };
        // SAFETY: as above.
        let (state, input) = unsafe { (checked(state)?, input::checked(input)?) };
        present(partials)?;
        let answer = self::partials(model, &state, &input);
        computed(answer.is_finite())?;
        // SAFETY: the checks above exclude null and misaligned pointers. Both types have the same layout (asserted in
        // `partials`).
        unsafe { *partials.cast::<Partials>() = answer };
        Ok(range_warning(model, input.velocity))
    })())
}
