//! Status
//!
//! Every function returns a status: 0 success, positive a warning (the result is usable), negative an error
//! (nothing was changed). Warnings are bits and may be combined. Numbers never change their meaning.

use core::ffi::c_char;

use dashpot_core::Reason;
use dashpot_core::model_file::LineProblem;

use crate::text::padded;

/// Success.
pub const DASHPOT_OK: i32 = 0;

/// Warning bit: the velocity lies outside the identified force-velocity curve, which is extrapolated linearly.
pub const DASHPOT_OUTSIDE_RANGE: i32 = 1;
/// Warning bit: the step is longer than 0.01 s; fast motion inside it is not resolved.
pub const DASHPOT_LONG_STEP: i32 = 2;
/// Warning bit: the setting lies outside the grid of the family and is clamped to it.
pub const DASHPOT_OUTSIDE_SETTING: i32 = 4;

/// A pointer is null.
pub const DASHPOT_NULL: i32 = -1;
/// An address is not aligned for what it points to.
pub const DASHPOT_MISALIGNED: i32 = -2;
/// The struct_size of a structure is not the size that this library expects.
pub const DASHPOT_STRUCT_SIZE: i32 = -3;
/// abi_version is not the interface version of this library.
pub const DASHPOT_ABI_MISMATCH: i32 = -4;
/// The parameters or the model were not initialized, or by another build of the library.
pub const DASHPOT_NOT_INITIALIZED: i32 = -5;
/// An input is NaN, infinite, or far beyond all dampers.
///
/// The limits are 1000 for displacement plus velocity (m, m/s), 1e9 N for the side force and 1e5 degrees for the temperature.
pub const DASHPOT_BAD_INPUT: i32 = -6;
/// The state holds NaN, infinity or a number beyond 1e60: it was not initialized.
pub const DASHPOT_BAD_STATE: i32 = -7;
/// dt is NaN, negative, above 100 s, or above 0 but below 1e-15 s.
pub const DASHPOT_BAD_TIME_STEP: i32 = -8;
/// The member known of an input has a bit that this library does not define.
pub const DASHPOT_UNKNOWN_FLAG: i32 = -9;
/// No parameter or element has this name.
pub const DASHPOT_UNKNOWN_NAME: i32 = -10;
/// A parameter is NaN or infinite.
pub const DASHPOT_NOT_FINITE: i32 = -11;
/// A parameter is outside the bounds of the parameter table.
pub const DASHPOT_OUT_OF_BOUNDS: i32 = -12;
/// A parameter is none of the choices of the parameter table.
pub const DASHPOT_NOT_A_CHOICE: i32 = -13;
/// A list where one number belongs, or one number where a list belongs.
pub const DASHPOT_WRONG_SHAPE: i32 = -14;
/// A list has too few or too many points.
pub const DASHPOT_POINT_COUNT: i32 = -15;
/// The two lists of a curve have different lengths.
pub const DASHPOT_CURVE_LENGTHS: i32 = -16;
/// A list of velocities or displacements does not increase.
pub const DASHPOT_NOT_INCREASING: i32 = -17;
/// A list of forces decreases: the damper would push where it should resist.
pub const DASHPOT_FORCE_DECREASES: i32 = -18;
/// A limit that must exceed another does not.
pub const DASHPOT_ORDER: i32 = -19;
/// The caller's array is too short.
pub const DASHPOT_BUFFER_TOO_SHORT: i32 = -20;
/// A line of the model file is not of the form name = value.
pub const DASHPOT_FILE_SYNTAX: i32 = -21;
/// A value in the model file is neither a number nor a word in double quotes nor a list of them.
pub const DASHPOT_FILE_VALUE: i32 = -22;
/// A name appears twice in the model file.
pub const DASHPOT_FILE_REPEATED: i32 = -23;
/// The model file does not say format = 1.
pub const DASHPOT_FILE_FORMAT: i32 = -24;
/// The model file does not name its elements.
pub const DASHPOT_FILE_NO_ELEMENTS: i32 = -25;
/// The model file names an element that this library does not have.
pub const DASHPOT_FILE_UNKNOWN_ELEMENT: i32 = -26;
/// A list in the model file has more numbers than any parameter takes.
pub const DASHPOT_FILE_TOO_LONG: i32 = -27;
/// The parameter table has no row with this number.
pub const DASHPOT_NO_SUCH_ROW: i32 = -28;
/// The series spring is softer than the parallel spring somewhere within 100 mm.
pub const DASHPOT_SOFTER_THAN_INNER: i32 = -29;
/// The elements that are on have more than 8 internal states.
pub const DASHPOT_TOO_MANY_STATES: i32 = -30;
/// Free play or a bushing is on, and series_compliance, which they belong to, is off.
pub const DASHPOT_NEEDS_SERIES: i32 = -31;

/// Two points of a curve are closer than 1e-6 m/s or m.
pub const DASHPOT_TOO_CLOSE: i32 = -32;
/// A curve rises from one point to the next by more than 1e8 N s/m or N/m.
pub const DASHPOT_TOO_STEEP: i32 = -33;
/// The step cannot be computed: an input or a state is far outside the range of dampers.
pub const DASHPOT_NOT_COMPUTABLE: i32 = -34;
/// The model has no state with this number.
pub const DASHPOT_NO_SUCH_STATE: i32 = -35;
/// The model file is truncated: it ends before the [...] that its first comment announces.
pub const DASHPOT_FILE_CUT_OFF: i32 = -36;
/// The parameter's magnitude is inconsistent with the others.
///
/// Parameters with a force in their unit may be a thousandth to a hundred times those of a car's damper, if one factor
/// scales all. A rod of 1 g is consistent with a damper of 10 N, not with one of 1 kN.
pub const DASHPOT_OUT_OF_PROPORTION: i32 = -37;
/// A table of the model file is named as an element; parameters belong above the first `[table]`.
pub const DASHPOT_FILE_ELEMENT_TABLE: i32 = -38;
/// The grid of a setting is not 2 to 8 increasing numbers, or a setting is used without a grid.
pub const DASHPOT_SETTING_GRID: i32 = -39;
/// The number of values differs from the number of settings in the grid.
pub const DASHPOT_SETTING_COUNT: i32 = -40;
/// A parameter that cannot depend on the setting: a word, a list other than fv_force, or one of the integration.
pub const DASHPOT_SETTING_FIXED: i32 = -41;
/// More than 32 numbers depend on the setting.
pub const DASHPOT_SETTING_TOO_MANY: i32 = -42;
/// A parameter is 0 at one setting and not at another. A state would then exist only at some settings.
pub const DASHPOT_SETTING_STATES: i32 = -43;

/// Length of the array of each text, including at least one terminating zero.
const LENGTH: usize = 128;

/// Table of all statuses and their texts. Combinations of warning bits have texts of their own.
static TEXTS: [(i32, [u8; LENGTH]); 51] = [
    (DASHPOT_OK, padded("success")),
    (
        DASHPOT_OUTSIDE_RANGE,
        padded("velocity outside the identified force-velocity curve, which is prolonged straight"),
    ),
    (DASHPOT_LONG_STEP, padded("step longer than 0.01 s; fast motion inside it is not resolved")),
    (
        DASHPOT_OUTSIDE_RANGE | DASHPOT_LONG_STEP,
        padded("velocity outside the identified force-velocity curve, and step longer than 0.01 s"),
    ),
    (DASHPOT_OUTSIDE_SETTING, padded("setting outside the grid of the family, to which it is clamped")),
    (
        DASHPOT_OUTSIDE_RANGE | DASHPOT_OUTSIDE_SETTING,
        padded("velocity outside the identified force-velocity curve, and setting outside the grid of the family"),
    ),
    (
        DASHPOT_LONG_STEP | DASHPOT_OUTSIDE_SETTING,
        padded("step longer than 0.01 s, and setting outside the grid of the family"),
    ),
    (
        DASHPOT_OUTSIDE_RANGE | DASHPOT_LONG_STEP | DASHPOT_OUTSIDE_SETTING,
        padded("velocity outside the curve, setting outside the grid of the family, and step longer than 0.01 s"),
    ),
    (DASHPOT_NULL, padded("a pointer is null")),
    (DASHPOT_MISALIGNED, padded("an address is not aligned for what it points to")),
    (DASHPOT_STRUCT_SIZE, padded("struct_size is not the size of that structure; start from its initialiser")),
    (
        DASHPOT_ABI_MISMATCH,
        padded("header and library have different interface versions; rebuild with the header of this library"),
    ),
    (
        DASHPOT_NOT_INITIALIZED,
        padded("parameters or model not initialised; call dashpot_params_default or dashpot_model_init first"),
    ),
    (
        DASHPOT_BAD_INPUT,
        padded(
            "an input is NaN, infinite or absurd: displacement + velocity above 1000, side force 1e9 N, temperature 1e5",
        ),
    ),
    (DASHPOT_BAD_STATE, padded("the state holds NaN or infinity; call dashpot_state_init first")),
    (DASHPOT_BAD_TIME_STEP, padded("dt must be 0 for a static evaluation, or between 1e-15 and 100 s")),
    (DASHPOT_UNKNOWN_FLAG, padded("known has a bit that this library does not know")),
    (DASHPOT_UNKNOWN_NAME, padded(Reason::UnknownName.text())),
    (DASHPOT_NOT_FINITE, padded(Reason::NotFinite.text())),
    (DASHPOT_OUT_OF_BOUNDS, padded(Reason::OutOfBounds.text())),
    (DASHPOT_NOT_A_CHOICE, padded(Reason::NotAChoice.text())),
    (DASHPOT_WRONG_SHAPE, padded(Reason::WrongShape.text())),
    (DASHPOT_POINT_COUNT, padded(Reason::PointCount.text())),
    (DASHPOT_CURVE_LENGTHS, padded(Reason::CurveLengths.text())),
    (DASHPOT_NOT_INCREASING, padded(Reason::NotIncreasing.text())),
    (DASHPOT_FORCE_DECREASES, padded(Reason::ForceDecreases.text())),
    (DASHPOT_OUT_OF_PROPORTION, padded(Reason::OutOfProportion.text())),
    (DASHPOT_ORDER, padded(Reason::Order.text())),
    (DASHPOT_SOFTER_THAN_INNER, padded(Reason::SofterThanInner.text())),
    (DASHPOT_TOO_MANY_STATES, padded(Reason::TooManyStates.text())),
    (DASHPOT_NEEDS_SERIES, padded(Reason::NeedsSeries.text())),
    (DASHPOT_TOO_CLOSE, padded(Reason::TooClose.text())),
    (DASHPOT_TOO_STEEP, padded(Reason::TooSteep.text())),
    (
        DASHPOT_NOT_COMPUTABLE,
        padded("the step cannot be computed: an input or the state is far from what a damper meets"),
    ),
    (DASHPOT_BUFFER_TOO_SHORT, padded("the caller's array is too short")),
    (DASHPOT_FILE_SYNTAX, padded(LineProblem::Syntax.text())),
    (DASHPOT_FILE_VALUE, padded(LineProblem::Value.text())),
    (DASHPOT_FILE_REPEATED, padded(LineProblem::Repeated.text())),
    (DASHPOT_FILE_FORMAT, padded(LineProblem::Format.text())),
    (DASHPOT_FILE_NO_ELEMENTS, padded(LineProblem::NoElements.text())),
    (DASHPOT_FILE_UNKNOWN_ELEMENT, padded(LineProblem::UnknownElement.text())),
    (DASHPOT_FILE_TOO_LONG, padded(LineProblem::TooLong.text())),
    (DASHPOT_FILE_CUT_OFF, padded(LineProblem::CutOff.text())),
    (DASHPOT_FILE_ELEMENT_TABLE, padded(LineProblem::ElementTable.text())),
    (DASHPOT_SETTING_GRID, padded(Reason::SettingGrid.text())),
    (DASHPOT_SETTING_COUNT, padded(Reason::SettingCount.text())),
    (DASHPOT_SETTING_FIXED, padded(Reason::SettingFixed.text())),
    (DASHPOT_SETTING_TOO_MANY, padded(Reason::SettingTooMany.text())),
    (DASHPOT_SETTING_STATES, padded(Reason::SettingStates.text())),
    (DASHPOT_NO_SUCH_STATE, padded("the model has no state with this number")),
    (DASHPOT_NO_SUCH_ROW, padded("the parameter table has no row with this number")),
];
static UNKNOWN: [u8; LENGTH] = padded("unknown status: not one of this library's");

/// Returns the message of a status. Never null; valid as long as the library is loaded.
///
/// A message about a parameter continues the parameter's name: "fv_force" "falls from one point to the next; ...".
#[unsafe(no_mangle)]
pub extern "C" fn dashpot_status_text(status: i32) -> *const c_char {
    TEXTS.iter().find(|(code, _)| *code == status).map_or(&UNKNOWN, |(_, text)| text).as_ptr().cast()
}

/// Error of a C function: its negative status.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Rejected(pub i32);

/// Converts a result to the status that a C function returns: the warnings, or the error.
#[inline(always)]
pub(crate) fn status(result: Result<i32, Rejected>) -> i32 {
    match result {
        Ok(status) => status,
        Err(Rejected(status)) => status,
    }
}

impl From<Reason> for Rejected {
    fn from(reason: Reason) -> Rejected {
        Rejected(match reason {
            Reason::UnknownName => DASHPOT_UNKNOWN_NAME,
            Reason::NotFinite => DASHPOT_NOT_FINITE,
            Reason::OutOfBounds => DASHPOT_OUT_OF_BOUNDS,
            Reason::NotAChoice => DASHPOT_NOT_A_CHOICE,
            Reason::WrongShape => DASHPOT_WRONG_SHAPE,
            Reason::PointCount => DASHPOT_POINT_COUNT,
            Reason::CurveLengths => DASHPOT_CURVE_LENGTHS,
            Reason::NotIncreasing => DASHPOT_NOT_INCREASING,
            Reason::ForceDecreases => DASHPOT_FORCE_DECREASES,
            Reason::OutOfProportion => DASHPOT_OUT_OF_PROPORTION,
            Reason::Order => DASHPOT_ORDER,
            Reason::SofterThanInner => DASHPOT_SOFTER_THAN_INNER,
            Reason::TooManyStates => DASHPOT_TOO_MANY_STATES,
            Reason::NeedsSeries => DASHPOT_NEEDS_SERIES,
            Reason::TooClose => DASHPOT_TOO_CLOSE,
            Reason::TooSteep => DASHPOT_TOO_STEEP,
            Reason::SettingGrid => DASHPOT_SETTING_GRID,
            Reason::SettingCount => DASHPOT_SETTING_COUNT,
            Reason::SettingFixed => DASHPOT_SETTING_FIXED,
            Reason::SettingTooMany => DASHPOT_SETTING_TOO_MANY,
            Reason::SettingStates => DASHPOT_SETTING_STATES,
        })
    }
}

impl From<LineProblem> for Rejected {
    fn from(problem: LineProblem) -> Rejected {
        Rejected(match problem {
            LineProblem::Syntax => DASHPOT_FILE_SYNTAX,
            LineProblem::Value => DASHPOT_FILE_VALUE,
            LineProblem::Repeated => DASHPOT_FILE_REPEATED,
            LineProblem::Format => DASHPOT_FILE_FORMAT,
            LineProblem::NoElements => DASHPOT_FILE_NO_ELEMENTS,
            LineProblem::UnknownElement => DASHPOT_FILE_UNKNOWN_ELEMENT,
            LineProblem::TooLong => DASHPOT_FILE_TOO_LONG,
            LineProblem::CutOff => DASHPOT_FILE_CUT_OFF,
            LineProblem::ElementTable => DASHPOT_FILE_ELEMENT_TABLE,
            LineProblem::Parameter(fault) => return fault.reason.into(),
            LineProblem::Setting(reason) => return reason.into(),
            // Only a reader of dampers without a setting reports this problem, for the file of a family. This interface accepts both kinds
            // of file, so the case does not occur.
            LineProblem::Family => DASHPOT_SETTING_GRID,
        })
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;
    use std::ffi::CStr;

    use super::*;

    #[test]
    fn numbers_and_texts_are_unique() {
        let numbers: BTreeSet<i32> = TEXTS.iter().map(|(code, _)| *code).collect();
        let texts: BTreeSet<_> = TEXTS.iter().map(|(_, text)| text).collect();
        assert_eq!(numbers.len(), TEXTS.len());
        assert_eq!(texts.len(), TEXTS.len());
    }

    #[test]
    fn every_constant_of_this_file_has_a_text() {
        let mut seen = 0;
        for line in include_str!("status.rs").lines().filter(|l| l.starts_with("pub const DASHPOT_")) {
            let number = line.split(['=', ';']).nth(1).unwrap().trim().parse().unwrap();
            // SAFETY: the function guarantees a static, zero-terminated text.
            let text = unsafe { CStr::from_ptr(dashpot_status_text(number)) };
            assert!(!text.to_str().unwrap().starts_with("unknown status"), "{line}");
            seen += 1;
        }
        // Each text belongs to one constant, except the four texts for combinations of warnings.
        assert_eq!(seen + 4, TEXTS.len());
    }
}
