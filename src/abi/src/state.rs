//! State
//!
//! The state contains the whole history of a damper, friction hysteresis included, as numbers that the host owns. Copy the structure to
//! try a step and roll it back, or to save a run and resume it. A run resumed from a copy repeats the original run to the last bit.
//!
//! A state may be used with another model, for example when a model is prepared again while it
//! runs. Internal states follow their elements, and an element that was off before starts in equilibrium.
//!
//! Derivatives of a step are exact where its force is smooth. A knee is a point of a piecewise linear curve, a stop, a
//! reversal or a void that closes. At a knee the derivatives are those of the side on which the step was solved, or lie
//! between those of both sides. An implicit host should bound its Newton steps there. In a search over random steps,
//! most of them far from real dampers, one derivative in a thousand has an error above 2 %. With a nonlinear spring
//! nearly as stiff as the series spring and an element of the oil, a step of 10 ms gives the derivative of the tangent
//! at its last iterate.

use core::mem::{align_of, offset_of, size_of};

use dashpot_core::family::Delay;
use dashpot_core::{Input, Output, State};

use crate::input::{self, dashpot_input, sane};
use crate::model::{dashpot_model, family, prepared};
use crate::pointer::{aligned, exclusive, present};
use crate::status::{DASHPOT_BAD_INPUT, DASHPOT_BAD_STATE, DASHPOT_NOT_COMPUTABLE, DASHPOT_OK, Rejected, status};

/// State of one damper.
#[repr(C)]
pub struct dashpot_state {
    /// Displacement of the moving end, m: provided by the host, or integrated from the initial position.
    pub displacement: f64,
    /// Velocity of the moving end at the last step, m/s.
    pub velocity: f64,
    /// Displacement of the internal mass, m.
    pub mass_displacement: f64,
    /// Velocity of the internal mass, m/s.
    pub mass_velocity: f64,
    /// Internal states of the elements that are on.
    pub internal: [f64; 8],
    /// Number that identifies the layout of the internal states; written by the library. 0: the layout of the model
    /// that the state is passed to.
    pub layout: f64,
    /// 0.
    pub reserved: f64,
    /// Commands of the last dead time, for a damper that depends on a setting; written by the library.
    pub commands: [f64; 20],
}

/// Output at one instant.
#[repr(C)]
pub struct dashpot_output {
    /// Damper force, N, tension positive.
    pub force: f64,
    /// Derivative of the force with respect to the input displacement, N/m, at constant states. After a step: the total
    /// derivative at the end of the step.
    pub d_force_d_displacement: f64,
    /// Derivative of the force with respect to the input velocity, N s/m, at constant states. After a step: the total
    /// derivative at the end of the step. Without an input displacement, that derivative includes the effect of the
    /// integrated displacement.
    pub d_force_d_velocity: f64,
    /// Force of the primary damper (the force-velocity curve), N.
    pub primary_force: f64,
    /// Force of the springs on the internal mass, N.
    pub spring_force: f64,
    /// Friction, presliding included, N.
    pub friction_force: f64,
    /// Gas force, gas spring included, N; negative where it pushes the rod out.
    pub gas_force: f64,
    /// Deflection of the series spring, m.
    pub series_deflection: f64,
    /// Force of the stops at the ends of the stroke, N.
    pub stop_force: f64,
    /// Temperature of the oil at which the forces are computed, degrees Celsius.
    pub oil_temperature: f64,
}

// These types are the kernel's structures under C names. The layouts are equal, so a step writes directly to the host's memory.
const _: () = {
    assert!(size_of::<dashpot_state>() == size_of::<State>() + size_of::<Delay>());
    assert!(align_of::<dashpot_state>() == align_of::<State>() && align_of::<Delay>() == align_of::<State>());
    assert!(offset_of!(dashpot_state, commands) == size_of::<State>());
    assert!(offset_of!(dashpot_state, displacement) == offset_of!(State, displacement));
    assert!(offset_of!(dashpot_state, velocity) == offset_of!(State, velocity));
    assert!(offset_of!(dashpot_state, mass_displacement) == offset_of!(State, mass_displacement));
    assert!(offset_of!(dashpot_state, mass_velocity) == offset_of!(State, mass_velocity));
    assert!(offset_of!(dashpot_state, internal) == offset_of!(State, internal));
    assert!(offset_of!(dashpot_state, layout) == offset_of!(State, layout));
    assert!(offset_of!(dashpot_state, reserved) == offset_of!(State, reserved));
    assert!(size_of::<dashpot_output>() == size_of::<Output>() && align_of::<dashpot_output>() == align_of::<Output>());
    assert!(offset_of!(dashpot_output, force) == offset_of!(Output, force));
    assert!(offset_of!(dashpot_output, d_force_d_displacement) == offset_of!(Output, d_force_d_displacement));
    assert!(offset_of!(dashpot_output, d_force_d_velocity) == offset_of!(Output, d_force_d_velocity));
    assert!(offset_of!(dashpot_output, primary_force) == offset_of!(Output, primary_force));
    assert!(offset_of!(dashpot_output, spring_force) == offset_of!(Output, spring_force));
    assert!(offset_of!(dashpot_output, friction_force) == offset_of!(Output, friction_force));
    assert!(offset_of!(dashpot_output, gas_force) == offset_of!(Output, gas_force));
    assert!(offset_of!(dashpot_output, series_deflection) == offset_of!(Output, series_deflection));
    assert!(offset_of!(dashpot_output, stop_force) == offset_of!(Output, stop_force));
    assert!(offset_of!(dashpot_output, oil_temperature) == offset_of!(Output, oil_temperature));
};

/// Largest accepted sum of the magnitudes of a state, far beyond the result of any step.
///
/// Its fourth power times the largest coefficient that the parameter table allows is finite, so a closed-form step stays finite.
const LARGEST: f64 = 1e60;

/// Rejects a state that contains NaN, infinity or values that no step produces. The commands of the dead time are not checked.
///
/// # Safety
/// `state` is null, or it is aligned and nobody writes it during the call.
#[inline(always)]
pub(crate) unsafe fn finite(state: *const dashpot_state) -> Result<(), Rejected> {
    present(state)?;
    // Sum the magnitudes in pairs, because processors add both lanes of a vector simultaneously (SIMD).
    // SAFETY: the caller guarantees validity. Without its commands a state is fourteen numbers, and seven pairs have the same layout.
    let pairs = unsafe { &*state.cast::<[[f64; 2]; 7]>() };
    let sum = pairs.iter().fold([0.0; 2], |sum, pair| [sum[0] + pair[0].abs(), sum[1] + pair[1].abs()]);
    // The comparison is false for NaN.
    if sum[0] + sum[1] <= LARGEST { Ok(()) } else { Err(Rejected(DASHPOT_BAD_STATE)) }
}

/// Returns a pointer to the commands of the last dead time in a state. Only dampers that depend on a setting read them.
///
/// # Safety
/// `state` is aligned, not null, and belongs to the caller.
pub(crate) unsafe fn commands(state: *mut dashpot_state) -> *mut Delay {
    // SAFETY: the caller guarantees validity. Both types have the same layout (asserted above).
    unsafe { (&raw mut (*state).commands).cast() }
}

/// Returns the error `DASHPOT_NOT_COMPUTABLE` unless `numbers` is true. `numbers` states whether the results are finite
/// numbers.
#[inline(always)]
pub(crate) fn computed(numbers: bool) -> Result<(), Rejected> {
    if numbers { Ok(()) } else { Err(Rejected(DASHPOT_NOT_COMPUTABLE)) }
}

/// Returns a copy of a checked state of the host.
///
/// # Safety
/// The requirements of [`finite`].
#[inline(always)]
pub(crate) unsafe fn checked(state: *const dashpot_state) -> Result<State, Rejected> {
    // SAFETY: the caller guarantees validity. Any fourteen numbers are a valid state.
    unsafe {
        finite(state)?;
        Ok(*state.cast::<State>())
    }
}

/// Writes a state and its commands.
///
/// # Safety
/// `to` is aligned and belongs to the caller.
unsafe fn put(to: *mut dashpot_state, state: State, delay: Delay) {
    // SAFETY: the caller guarantees validity. Both types have the same layout (asserted above).
    unsafe {
        *to.cast::<State>() = state;
        *commands(to) = delay;
    }
}

/// Initializes the state of a damper at rest in equilibrium at initial_position (m, extension positive).
///
/// A step at constant position then returns the static force. A damper that depends on a setting is in equilibrium at the start setting.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn dashpot_state_init(
    model: *const dashpot_model,
    initial_position: f64,
    state: *mut dashpot_state,
) -> i32 {
    status((|| {
        // SAFETY: the manual (`lib.rs`) guarantees that each pointer is null, misaligned, or not used elsewhere during the call.
        let (to, plain) = unsafe { (exclusive(state)?, prepared(model)) };
        if !sane(initial_position) {
            return Err(Rejected(DASHPOT_BAD_INPUT));
        }
        let at = Input::motion(initial_position, 0.0);
        // SAFETY: as above.
        let (settled, delay) = match plain {
            Ok(model) => (model.steady_state(&at), Delay::UNSET),
            Err(_) => {
                // SAFETY: as above.
                unsafe { family(model) }.map(|family| (family.steady_state(&at, None), family.steady_delay(None)))?
            }
        };
        computed(settled.is_finite())?;
        // SAFETY: the checks above exclude null and misaligned pointers, and access is exclusive. Both types have the same layout (asserted
        // above).
        unsafe { put(to, settled, delay) };
        Ok(DASHPOT_OK)
    })())
}

/// Initializes the steady state of a damper at the constant velocity of *input.
///
/// Use it where a simulation starts in motion, to avoid a jump of the velocity in the first steps. Without DASHPOT_KNOWS_DISPLACEMENT the
/// displacement is 0.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn dashpot_state_init_motion(
    model: *const dashpot_model,
    input: *const dashpot_input,
    state: *mut dashpot_state,
) -> i32 {
    status((|| {
        aligned!(input);
        // SAFETY: `aligned!` checked the alignment of the input. The manual (`lib.rs`) guarantees that each pointer is null, misaligned,
        // or not used elsewhere during the call.
        let (to, plain) = unsafe { (exclusive(state)?, prepared(model)) };
        // SAFETY: as above.
        let at = unsafe { input::checked(input) }?;
        // SAFETY: as above.
        let (settled, delay) = match plain {
            Ok(model) => (model.steady_state(&at), Delay::UNSET),
            // SAFETY: as above.
            Err(_) => unsafe {
                let (family, setting) = (family(model)?, input::setting(input)?);
                (family.steady_state(&at, setting), family.steady_delay(setting))
            },
        };
        computed(settled.is_finite())?;
        // SAFETY: the checks above exclude null and misaligned pointers, and access is exclusive. Both types have the same layout (asserted
        // above).
        unsafe { put(to, settled, delay) };
        Ok(DASHPOT_OK)
    })())
}
