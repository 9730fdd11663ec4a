//! Partial derivatives
//!
//! The outputs of dashpot_jacobian() and dashpot_jacobian_setting().

use core::mem::{align_of, offset_of, size_of};

use dashpot_core::Partials;
use dashpot_core::family::BySetting;

/// All partial derivatives at one instant. The states have the order of dashpot_evaluate(); the inputs are displacement and
/// velocity.
#[repr(C)]
pub struct dashpot_partials {
    /// dF/d(input).
    pub d_force_d_input: [f64; 2],
    /// dF/d(state).
    pub d_force_d_state: [f64; 10],
    /// d(rate of state i)/d(input).
    pub d_rate_d_input: [[f64; 2]; 10],
    /// d(rate of state i)/d(state j).
    pub d_rate_d_state: [[f64; 10]; 10],
}

const _: () = {
    assert!(size_of::<dashpot_partials>() == size_of::<Partials>());
    assert!(align_of::<dashpot_partials>() == align_of::<Partials>());
    assert!(offset_of!(dashpot_partials, d_force_d_input) == offset_of!(Partials, d_force_d_input));
    assert!(offset_of!(dashpot_partials, d_force_d_state) == offset_of!(Partials, d_force_d_state));
    assert!(offset_of!(dashpot_partials, d_rate_d_input) == offset_of!(Partials, d_rate_d_input));
    assert!(offset_of!(dashpot_partials, d_rate_d_state) == offset_of!(Partials, d_rate_d_state));
};

/// Derivatives of force and state rates with respect to the commanded setting, at constant states.
#[repr(C)]
pub struct dashpot_setting_derivatives {
    /// dF/d(setting). 0 if the actuator has a lag, because the force then depends on the actuator's states instead.
    pub d_force_d_setting: f64,
    /// d(rate of state i)/d(setting), in the order of dashpot_partials.
    pub d_rate_d_setting: [f64; 10],
}

const _: () = {
    assert!(size_of::<dashpot_setting_derivatives>() == size_of::<BySetting>());
    assert!(align_of::<dashpot_setting_derivatives>() == align_of::<BySetting>());
    assert!(offset_of!(dashpot_setting_derivatives, d_rate_d_setting) == offset_of!(BySetting, rate));
};
