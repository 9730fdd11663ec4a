//! Functions of the C interface for a damper that depends on a setting. They are separate so that the functions of a damper without a
//! setting stay fast.

use dashpot_core::family::Family;
use dashpot_core::{Input, Output, Partials, State};

use crate::input::{self, checked_setting, dashpot_input, sane};
use crate::model::{dashpot_model, family, prepared};
use crate::partials::{dashpot_partials, dashpot_setting_derivatives};
use crate::pointer::{exclusive, present};
use crate::state::{checked, commands, computed, dashpot_output, dashpot_state, finite};
use crate::status::{DASHPOT_BAD_INPUT, DASHPOT_NOT_COMPUTABLE, DASHPOT_OK, DASHPOT_OUTSIDE_SETTING, Rejected};
use crate::stepping::{checked_step, move_on, range_warning, warnings};

/// Returns `DASHPOT_OUTSIDE_SETTING` for a setting outside the grid of the family, otherwise `DASHPOT_OK`.
fn setting_warning(family: &Family, setting: Option<f64>) -> i32 {
    if setting.is_some_and(|setting| family.is_outside(setting)) { DASHPOT_OUTSIDE_SETTING } else { DASHPOT_OK }
}

/// Computes `dashpot_force()` and `dashpot_force_with_setting()` of a family. Without a setting, the start setting applies.
///
/// # Safety
/// Each pointer is null or aligned, and belongs to the caller.
#[cold]
#[inline(never)]
pub(crate) unsafe fn force(
    model: *const dashpot_model,
    state: *mut dashpot_state,
    velocity: f64,
    setting: Option<f64>,
    dt: f64,
    force: *mut f64,
) -> Result<i32, Rejected> {
    // SAFETY: the caller guarantees the requirements.
    let family = unsafe { family(model)? };
    // SAFETY: as for the model.
    unsafe { finite(state)? };
    if !sane(velocity) {
        return Err(Rejected(DASHPOT_BAD_INPUT));
    }
    let setting = setting.map(checked_setting).transpose()?;
    let dt = checked_step(dt)?;
    // SAFETY: as for the model.
    let force = unsafe { exclusive(force)? };
    let mut output = Output::ZERO;
    let to = Input::velocity(velocity);
    // SAFETY: `finite` excludes null, and the pointer is aligned and exclusive to the caller. Both parts are disjoint.
    let (damper, delay) = unsafe { (&mut *state.cast::<State>(), &mut *commands(state)) };
    if !family.step_in_place(damper, delay, &to, setting, dt, &mut output, false) {
        return Err(Rejected(DASHPOT_NOT_COMPUTABLE));
    }
    *force = output.force;
    Ok(warnings(family.model(), velocity, dt) | setting_warning(family, setting))
}

/// Computes `dashpot_step()` of a family.
///
/// # Safety
/// Each pointer is null or aligned, and belongs to the caller.
#[cold]
#[inline(never)]
pub(crate) unsafe fn step(
    model: *const dashpot_model,
    from: *const dashpot_state,
    to_input: *const dashpot_input,
    dt: f64,
    to: *mut dashpot_state,
    output: *mut dashpot_output,
) -> Result<i32, Rejected> {
    // SAFETY: the caller guarantees the requirements.
    let family = unsafe { family(model)? };
    // SAFETY: as for the model.
    unsafe { finite(from)? };
    // SAFETY: as for the model.
    let (input, setting) = unsafe { (input::checked(to_input)?, input::setting(to_input)?) };
    let dt = checked_step(dt)?;
    present(to)?;
    present(output)?;
    // SAFETY: the checks above exclude null and misaligned pointers.
    unsafe { step_checked(family, from, &input, setting, dt, to, output)? };
    Ok(warnings(family.model(), input.velocity, dt) | setting_warning(family, setting))
}

/// Makes one step of a family with checked arguments. Returns an error if the results are not finite.
///
/// # Safety
/// The pointers are valid and aligned. `from` and `to` may be equal.
unsafe fn step_checked(
    family: &Family,
    from: *const dashpot_state,
    input: &Input,
    setting: Option<f64>,
    dt: f64,
    to: *mut dashpot_state,
    output: *mut dashpot_output,
) -> Result<(), Rejected> {
    // SAFETY: the caller guarantees a valid, aligned pointer. Both types have the same layout (asserted in `state`).
    let output = unsafe { &mut *output.cast::<Output>() };
    if from != to.cast_const() {
        // SAFETY: the caller guarantees valid, aligned pointers. The step works on copies, because states may overlap.
        let (mut damper, mut delay) = unsafe { (*from.cast::<State>(), *commands(from.cast_mut())) };
        computed(family.step_in_place(&mut damper, &mut delay, input, setting, dt, output, true))?;
        // SAFETY: the caller guarantees valid, aligned pointers.
        unsafe {
            *to.cast::<State>() = damper;
            *commands(to) = delay;
        }
        return Ok(());
    }
    // SAFETY: the caller guarantees a valid, aligned pointer. Both parts are disjoint.
    let (damper, delay) = unsafe { (&mut *to.cast::<State>(), &mut *commands(to)) };
    computed(family.step_in_place(damper, delay, input, setting, dt, output, true))
}

/// Computes `dashpot_step_batch()` of dampers of which some depend on a setting.
///
/// # Safety
/// Each array is aligned, not null, belongs to the caller and has `count` elements.
#[cold]
#[inline(never)]
pub(crate) unsafe fn step_batch(
    count: usize,
    models: *const *const dashpot_model,
    from: *const dashpot_state,
    to_inputs: *const dashpot_input,
    dt: f64,
    to: *mut dashpot_state,
    outputs: *mut dashpot_output,
) -> Result<i32, Rejected> {
    for i in 0..count {
        // SAFETY: the caller guarantees `count` elements in each array.
        unsafe {
            let model = *models.add(i);
            if prepared(model).is_err() {
                family(model)?;
            }
            finite(from.add(i))?;
            input::checked(to_inputs.add(i))?;
            input::setting(to_inputs.add(i))?;
        }
    }
    let mut status = DASHPOT_OK;
    for i in 0..count {
        // SAFETY: as above. The first loop checked all arguments.
        unsafe {
            let (model, input) = (*models.add(i), input::taken(to_inputs.add(i)));
            match prepared(model) {
                Ok(model) => {
                    status |= warnings(model, input.velocity, dt);
                    move_on(model, from.add(i), &input, dt, to.add(i), outputs.add(i))?;
                }
                Err(_) => {
                    let (family, setting) = (family(model)?, input::setting(to_inputs.add(i))?);
                    status |= warnings(family.model(), input.velocity, dt) | setting_warning(family, setting);
                    step_checked(family, from.add(i), &input, setting, dt, to.add(i), outputs.add(i))?;
                }
            }
        }
    }
    Ok(status)
}

/// Computes `dashpot_evaluate()` of a family.
///
/// # Safety
/// Each pointer is null or aligned, and belongs to the caller.
#[cold]
#[inline(never)]
pub(crate) unsafe fn evaluate(
    model: *const dashpot_model,
    state: *const dashpot_state,
    input: *const dashpot_input,
    output: *mut dashpot_output,
    rate: *mut dashpot_state,
) -> Result<i32, Rejected> {
    // SAFETY: the caller guarantees the requirements.
    let (family, state) = unsafe { (family(model)?, checked(state)?) };
    // SAFETY: as above.
    let (input, setting) = unsafe { (input::checked(input)?, input::setting(input)?) };
    present(output)?;
    present(rate)?;
    let (answer, rates) = family.evaluate(&state, &input, setting);
    computed(answer.is_finite() && rates.is_finite())?;
    // SAFETY: the checks above exclude null and misaligned pointers. Both types have the same layout (asserted in
    // `state`).
    unsafe {
        *output.cast::<Output>() = answer;
        *rate.cast::<State>() = rates;
        (*rate).commands = [0.0; 20];
    }
    Ok(range_warning(family.model(), input.velocity) | setting_warning(family, setting))
}

/// Computes `dashpot_jacobian()` of a family, or `dashpot_jacobian_setting()` if `by_setting` is not null.
///
/// # Safety
/// Each pointer is null or aligned, and belongs to the caller.
#[cold]
#[inline(never)]
pub(crate) unsafe fn jacobian(
    model: *const dashpot_model,
    state: *const dashpot_state,
    input: *const dashpot_input,
    partials: *mut dashpot_partials,
    by_setting: *mut dashpot_setting_derivatives,
) -> Result<i32, Rejected> {
    // SAFETY: the caller guarantees the requirements.
    let (family, state) = unsafe { (family(model)?, checked(state)?) };
    // SAFETY: as above.
    let (input, setting) = unsafe { (input::checked(input)?, input::setting(input)?) };
    let (own, by) = family.partials(&state, &input, setting);
    computed(own.is_finite() && (by.force + by.rate.iter().sum::<f64>()) * 0.0 == 0.0)?;
    // SAFETY: `is_null` and `present` exclude null. Each pointer is aligned and belongs to the caller. Both types have the same layout
    // (asserted in `partials`).
    unsafe {
        if by_setting.is_null() {
            present(partials)?;
            *partials.cast::<Partials>() = own;
        } else {
            *by_setting = dashpot_setting_derivatives { d_force_d_setting: by.force, d_rate_d_setting: by.rate };
        }
    }
    Ok(range_warning(family.model(), input.velocity) | setting_warning(family, setting))
}
