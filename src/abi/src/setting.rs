//! Setting
//!
//! Many dampers depend on a setting: the current of a semi-active valve, the click of an adjuster, a gas pressure. A
//! parameter set may contain one value of a number for each setting of a grid of 2 to 8 settings. The same holds for
//! the forces of the FV table. A model file contains, for example, these lines:
//!
//!     setting = [0.0, 0.8, 1.6]
//!     setting_name = "current"
//!     setting_unit = "A"
//!     gas_force = [80.0, 82.0, 85.0]
//!     fv_force = [[...], [...], [...]]
//!
//! Its model reads the commanded setting from every input (DASHPOT_KNOWS_SETTING), separately for each damper. Numbers and forces are
//! interpolated by monotone cubics, exact on the grid. A setting outside the grid is clamped to its ends (warning DASHPOT_OUTSIDE_SETTING).
//! At every setting the damper equals one without a setting that has the interpolated numbers.
//!
//! The actuator has a dead time, time constants for a rising and for a falling setting, rate limits and hysteresis.
//! dashpot_params_set() sets them by the names "setting_dead_time", "setting_time_up", "setting_time_down",
//! "setting_rate_up", "setting_rate_down", "setting_hysteresis" and "setting_hysteresis_rest". "setting_start" is the
//! setting if the host provides none. The actual setting of the valve is part of the state.
//!
//! An evaluation (see Evaluation) ignores the dead time, because it stores no previous commands. A host that integrates the
//! states must delay the command itself.

use core::ffi::c_char;
use core::mem::size_of;

use dashpot_core::parameter::List;

use crate::family as over_setting;
use crate::input::{self, dashpot_input};
use crate::model::{dashpot_model, family, prepared};
use crate::params::{axis, axis_mut, dashpot_params, parameter};
use crate::partials::dashpot_setting_derivatives;
use crate::pointer::{aligned, array, exclusive, present, usable};
use crate::state::{checked, commands, computed, dashpot_state};
use crate::status::{DASHPOT_NOT_COMPUTABLE, DASHPOT_OK, DASHPOT_STRUCT_SIZE, Rejected, status};
use crate::step::dashpot_force;
use crate::stepping::checked_step;
use crate::text;

/// Maximum number of settings of a grid.
pub const DASHPOT_MAX_SETTINGS: u32 = 8;

/// The setting of a parameter set. Set struct_size before the call.
#[repr(C)]
pub struct dashpot_setting {
    /// sizeof(dashpot_setting).
    pub struct_size: u32,
    /// Number of settings of the grid; 0 if the damper depends on none.
    pub count: u32,
    /// The grid, increasing.
    pub grid: [f64; 8],
    /// Setting if the host provides none.
    pub start: f64,
    /// Name, zero-terminated, such as current; empty where none is given.
    pub name: [c_char; 32],
    /// Unit, zero-terminated, such as A; empty where none is given.
    pub unit: [c_char; 32],
}

/// Sets the grid of the setting: count increasing numbers. All values over the previous grid are removed.
///
/// With count 0 the damper no longer depends on a setting.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn dashpot_params_set_grid(params: *mut dashpot_params, grid: *const f64, count: u32) -> i32 {
    status((|| {
        // SAFETY: the manual (`lib.rs`) guarantees that `params` is null, misaligned, or a block of the caller.
        let axis = unsafe { axis_mut(params) }?;
        // SAFETY: the manual (`lib.rs`) guarantees that the pointer is null, misaligned, or that it has `count` numbers.
        let grid = unsafe { array(grid, count as usize) }?;
        if grid.is_empty() {
            axis.clear();
        } else {
            axis.set_grid(grid)?;
        }
        Ok(DASHPOT_OK)
    })())
}

/// Makes a number depend on the setting: values contains one value for each setting of the grid.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn dashpot_params_set_over(
    params: *mut dashpot_params,
    name: *const c_char,
    values: *const f64,
    count: u32,
) -> i32 {
    status((|| {
        // SAFETY: the manual (`lib.rs`) guarantees that each pointer is null, misaligned, or not used elsewhere during the call.
        // Names are zero-terminated.
        let (axis, row) = unsafe { (axis_mut(params)?, parameter(name)?) };
        // SAFETY: the manual (`lib.rs`) guarantees that the pointer is null, misaligned, or that it has `count` numbers.
        let values = unsafe { array(values, count as usize) }?;
        axis.set_values(row.try_into()?, values)?;
        Ok(DASHPOT_OK)
    })())
}

/// Sets the forces of the FV table, fv_force, at the setting with this index of the grid, from 0. All settings of the grid need them.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn dashpot_params_set_list_over(
    params: *mut dashpot_params,
    name: *const c_char,
    index: u32,
    values: *const f64,
    count: u32,
) -> i32 {
    status((|| {
        // SAFETY: the manual (`lib.rs`) guarantees that each pointer is null, misaligned, or not used elsewhere during the call.
        // Names are zero-terminated.
        let (axis, row) = unsafe { (axis_mut(params)?, parameter(name)?) };
        // SAFETY: the manual (`lib.rs`) guarantees that the pointer is null, misaligned, or that it has `count` numbers.
        let values = unsafe { array(values, count as usize) }?;
        axis.set_list(List::try_from(row)?, index as usize, values)?;
        Ok(DASHPOT_OK)
    })())
}

/// Reads the setting that a parameter set depends on.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn dashpot_params_setting(params: *const dashpot_params, setting: *mut dashpot_setting) -> i32 {
    status((|| {
        // SAFETY: the manual (`lib.rs`) guarantees that each pointer is null, misaligned, or not used elsewhere during the call.
        let (axis, to) = unsafe { (axis(params)?, exclusive(setting)?) };
        if to.struct_size as usize != size_of::<dashpot_setting>() {
            return Err(Rejected(DASHPOT_STRUCT_SIZE));
        }
        to.count = axis.grid().len() as u32;
        to.grid = [0.0; 8];
        for (to, from) in to.grid.iter_mut().zip(axis.grid()) {
            *to = *from;
        }
        to.start = axis.start();
        text::write_bytes(&mut to.name, [axis.name_bytes()].into_iter());
        text::write_bytes(&mut to.unit, [axis.unit_bytes()].into_iter());
        Ok(DASHPOT_OK)
    })())
}

/// Computes the force as dashpot_force() does, with the commanded setting. A damper that depends on none ignores it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn dashpot_force_with_setting(
    model: *const dashpot_model,
    state: *mut dashpot_state,
    velocity: f64,
    setting: f64,
    dt: f64,
    force: *mut f64,
) -> i32 {
    // SAFETY: the manual (`lib.rs`) guarantees the requirements of `prepared`.
    if unsafe { prepared(model) }.is_ok() {
        // SAFETY: as above.
        return unsafe { dashpot_force(model, state, velocity, dt, force) };
    }
    status((|| {
        aligned!(model, state, force);
        // SAFETY: `aligned!` checked the alignment, and the manual (`lib.rs`) guarantees the rest.
        unsafe { over_setting::force(model, state, velocity, Some(setting), dt, force) }
    })())
}

/// Writes the actual setting of the valve to *setting: the command clamped to the grid, after the dynamics of the actuator.
///
/// 0 for a damper that depends on no setting.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn dashpot_actuator_setting(
    model: *const dashpot_model,
    state: *const dashpot_state,
    input: *const dashpot_input,
    setting: *mut f64,
) -> i32 {
    status((|| {
        aligned!(model, state, input);
        // SAFETY: the manual (`lib.rs`) guarantees that each pointer is null, misaligned, or not used elsewhere during the call.
        let (to, state) = unsafe { (exclusive(setting)?, checked(state)?) };
        // SAFETY: as above.
        unsafe { input::checked(input)? };
        // SAFETY: as above.
        *to = match unsafe { prepared(model) } {
            Ok(_) => 0.0,
            // SAFETY: as above.
            Err(_) => unsafe { family(model)?.setting_of(&state, input::setting(input)?) },
        };
        Ok(DASHPOT_OK)
    })())
}

/// Writes the derivative of the force with respect to the actual setting of the valve to *derivative.
///
/// It is the total derivative of the force of dashpot_step() from *from to *to_input; with dt = 0, of the equilibrium force. A controller divides
/// by this derivative. The call costs two steps. 0 for a damper that depends on no setting.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn dashpot_d_force_d_setting(
    model: *const dashpot_model,
    from: *const dashpot_state,
    to_input: *const dashpot_input,
    dt: f64,
    derivative: *mut f64,
) -> i32 {
    status((|| {
        aligned!(model, from, to_input);
        // SAFETY: the manual (`lib.rs`) guarantees that each pointer is null, misaligned, or not used elsewhere during the call.
        let (to, state) = unsafe { (exclusive(derivative)?, checked(from)?) };
        // SAFETY: as above.
        let input = unsafe { input::checked(to_input)? };
        let dt = checked_step(dt)?;
        // SAFETY: as above.
        if unsafe { prepared(model) }.is_ok() {
            *to = 0.0;
            return Ok(DASHPOT_OK);
        }
        // SAFETY: as above.
        let (family, setting, delay) =
            unsafe { (family(model)?, input::setting(to_input)?, *commands(from.cast_mut())) };
        let found = family.d_force_d_setting(&state, &delay, &input, setting, dt);
        let found = found.ok_or(Rejected(DASHPOT_NOT_COMPUTABLE))?;
        computed(found.is_finite())?;
        *to = found;
        Ok(DASHPOT_OK)
    })())
}

/// Writes the derivatives of force and state rates with respect to the commanded setting to *by_setting.
///
/// They apply at *state and *input. dashpot_jacobian() does not contain them. They are 0 for a damper without a setting.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn dashpot_jacobian_setting(
    model: *const dashpot_model,
    state: *const dashpot_state,
    input: *const dashpot_input,
    by_setting: *mut dashpot_setting_derivatives,
) -> i32 {
    status((|| {
        aligned!(model, state, input);
        usable(by_setting)?;
        // SAFETY: the manual (`lib.rs`) guarantees that each pointer is null, misaligned, or not used elsewhere during the call.
        if unsafe { prepared(model) }.is_err() {
            // SAFETY: as above.
            return unsafe { over_setting::jacobian(model, state, input, core::ptr::null_mut(), by_setting) };
        }
        present(state)?;
        // SAFETY: as above.
        unsafe {
            input::checked(input)?;
            *by_setting = dashpot_setting_derivatives { d_force_d_setting: 0.0, d_rate_d_setting: [0.0; 10] };
        }
        Ok(DASHPOT_OK)
    })())
}
