//! Partial derivatives
//!
//! What dashpot_jacobian() and dashpot_jacobian_setting() fill in, further down.

use core::mem::{align_of, offset_of, size_of};

use dashpot_core::Partials;
use dashpot_core::family::BySetting;

/// All partial derivatives at one instant. States in the order that dashpot_evaluate() has; inputs: displacement, velocity.
#[repr(C)]
pub struct dashpot_partials {
    /// dF/d(input).
    pub force_by_input: [f64; 2],
    /// dF/d(state).
    pub force_by_state: [f64; 10],
    /// d(rate of state i)/d(input).
    pub rate_by_input: [[f64; 2]; 10],
    /// d(rate of state i)/d(state j).
    pub rate_by_state: [[f64; 10]; 10],
}

const _: () = {
    assert!(size_of::<dashpot_partials>() == size_of::<Partials>());
    assert!(align_of::<dashpot_partials>() == align_of::<Partials>());
    assert!(offset_of!(dashpot_partials, force_by_input) == offset_of!(Partials, force_by_input));
    assert!(offset_of!(dashpot_partials, force_by_state) == offset_of!(Partials, force_by_state));
    assert!(offset_of!(dashpot_partials, rate_by_input) == offset_of!(Partials, rate_by_input));
    assert!(offset_of!(dashpot_partials, rate_by_state) == offset_of!(Partials, rate_by_state));
};

/// Derivatives of force and rates over the commanded setting, at constant states.
#[repr(C)]
pub struct dashpot_by_setting {
    /// dF/d(setting). 0 where the actuator has a lag: the force then follows its state.
    pub force: f64,
    /// d(rate of state i)/d(setting), in the order of dashpot_partials.
    pub rate: [f64; 10],
}

const _: () = {
    assert!(size_of::<dashpot_by_setting>() == size_of::<BySetting>());
    assert!(align_of::<dashpot_by_setting>() == align_of::<BySetting>());
    assert!(offset_of!(dashpot_by_setting, rate) == offset_of!(BySetting, rate));
};
