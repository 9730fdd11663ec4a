//! Input
//!
//! The inputs of the damper at one instant. dashpot_force() needs none of this.

use core::mem::size_of;

use dashpot_core::Input;

use crate::pointer::present;
use crate::status::{DASHPOT_BAD_INPUT, DASHPOT_STRUCT_SIZE, DASHPOT_UNKNOWN_FLAG, Rejected};

/// The host provides the displacement; without this bit it is integrated from the initial position.
pub const DASHPOT_KNOWS_DISPLACEMENT: u32 = 1;
/// The host provides the side force; without this bit it is 0.
pub const DASHPOT_KNOWS_SIDE_FORCE: u32 = 2;
/// The host provides the temperature; without this bit it is 20 degrees Celsius.
pub const DASHPOT_KNOWS_TEMPERATURE: u32 = 4;
/// The host provides the setting of a damper that depends on one; without this bit it is the start setting of the model file.
pub const DASHPOT_KNOWS_SETTING: u32 = 8;

/// Input at one instant. Start with dashpot_input_velocity() or dashpot_input_motion(). Displacement, side force,
/// temperature and setting are each ignored if their bit is missing in the member known.
#[repr(C)]
pub struct dashpot_input {
    /// sizeof(dashpot_input).
    pub struct_size: u32,
    /// Sum of the DASHPOT_KNOWS_... bits that apply.
    pub known: u32,
    /// Displacement, m, extension positive. A host that knows the displacement should provide it, because an integrated
    /// displacement drifts.
    pub displacement: f64,
    /// Velocity, m/s, extension positive. Always needed.
    pub velocity: f64,
    /// Side force on the rod, N.
    pub side_force: f64,
    /// Damper temperature, degrees Celsius.
    pub temperature: f64,
    /// Commanded setting (current, clicks, ...) in the unit of the model file, constant during a step. Ignored if the damper depends on none.
    pub setting: f64,
}

const KNOWN: u32 =
    DASHPOT_KNOWS_DISPLACEMENT | DASHPOT_KNOWS_SIDE_FORCE | DASHPOT_KNOWS_TEMPERATURE | DASHPOT_KNOWS_SETTING;

/// Largest accepted sum of the magnitudes of displacement, velocity, weighted side force and weighted temperature.
///
/// 1000 m and 1000 m/s are at least a hundred times the values of any damper. Thus extreme trial steps of a host's solver still get an
/// output. Powers of much larger values would overflow.
pub(crate) const LARGEST: f64 = 1e3;
/// Weight of a newton of side force in the sum that [`LARGEST`] limits. `PER_DEGREE` is the weight of a degree Celsius of temperature.
///
/// 1e9 N or 1e5 degrees alone reach the limit.
const PER_NEWTON: f64 = 1e-6;
const PER_DEGREE: f64 = 1e-2;

/// Returns whether the magnitude of a number is at most [`LARGEST`]. Returns false for NaN.
#[inline(always)]
pub(crate) fn sane(number: f64) -> bool {
    number.abs() <= LARGEST
}

/// Converts and checks the input of the host.
///
/// # Safety
/// `input` is null, or it is aligned and not written during the call.
#[inline(always)]
pub(crate) unsafe fn checked(input: *const dashpot_input) -> Result<Input, Rejected> {
    present(input)?;
    // SAFETY: `present` excludes null. The caller guarantees alignment and that nobody writes the input.
    unsafe { &*input }.checked()
}

/// Converts an input that [`checked`] has accepted.
///
/// # Safety
/// `input` is aligned, was checked, and is unchanged since.
#[inline(always)]
pub(crate) unsafe fn taken(input: *const dashpot_input) -> Input {
    // SAFETY: the caller guarantees that `checked` has accepted this input.
    unsafe { &*input }.taken().0
}

/// Returns the setting that the host provides, or `None` if it provides none. Rejects a setting that is not finite.
///
/// # Safety
/// `input` is valid and aligned.
#[inline(always)]
pub(crate) unsafe fn setting(input: *const dashpot_input) -> Result<Option<f64>, Rejected> {
    // SAFETY: the caller guarantees the requirements.
    let input = unsafe { &*input };
    if input.known & DASHPOT_KNOWS_SETTING == 0 {
        return Ok(None);
    }
    checked_setting(input.setting).map(Some)
}

/// Rejects a setting that is not finite. A setting outside the grid is clamped later.
#[inline(always)]
pub(crate) fn checked_setting(setting: f64) -> Result<f64, Rejected> {
    if setting.is_finite() { Ok(setting) } else { Err(Rejected(DASHPOT_BAD_INPUT)) }
}

impl dashpot_input {
    /// Converts to the kernel's input, and rejects unknown flags and values out of range.
    #[inline(always)]
    fn checked(&self) -> Result<Input, Rejected> {
        if self.struct_size as usize != size_of::<dashpot_input>() {
            return Err(Rejected(DASHPOT_STRUCT_SIZE));
        }
        if self.known & !KNOWN != 0 {
            return Err(Rejected(DASHPOT_UNKNOWN_FLAG));
        }
        let (input, sum) = self.taken();
        if sum <= LARGEST { Ok(input) } else { Err(Rejected(DASHPOT_BAD_INPUT)) }
    }

    /// Converts to the kernel's input, and returns the sum of the weighted magnitudes that [`LARGEST`] limits.
    #[inline(always)]
    fn taken(&self) -> (Input, f64) {
        let knows = |bit| self.known & bit != 0;
        let mut input = Input::velocity(self.velocity);
        // The sum is at most `LARGEST` only if every magnitude is within its own limit. A NaN makes the sum NaN.
        let mut sum = self.velocity.abs();
        if knows(DASHPOT_KNOWS_DISPLACEMENT) {
            input.displacement = Some(self.displacement);
            sum += self.displacement.abs();
        }
        // Most hosts provide neither side force nor temperature, so one combined check saves a branch.
        if knows(DASHPOT_KNOWS_SIDE_FORCE | DASHPOT_KNOWS_TEMPERATURE) {
            if knows(DASHPOT_KNOWS_SIDE_FORCE) {
                input.side_force = self.side_force;
                sum += self.side_force.abs() * PER_NEWTON;
            }
            if knows(DASHPOT_KNOWS_TEMPERATURE) {
                input.temperature = self.temperature;
                sum += self.temperature.abs() * PER_DEGREE;
            }
        }
        (input, sum)
    }
}
