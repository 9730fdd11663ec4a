//! Parameter table
//!
//! For programs that list the parameters, such as a dialogue: name, unit, bounds, default and meaning of every row.

use core::ffi::c_char;
use core::mem::size_of;

use dashpot_core::parameter::GROUPS;
use dashpot_core::parameter::{COUNT, Shape, table};

use crate::pointer::exclusive;
use crate::status::{DASHPOT_NO_SUCH_ROW, DASHPOT_OK, DASHPOT_STRUCT_SIZE, Rejected, status};
use crate::text;

/// The parameter is one number.
pub const DASHPOT_SHAPE_NUMBER: u32 = 0;
/// The parameter is one of several words, set by number from 0; meaning lists them.
pub const DASHPOT_SHAPE_CHOICE: u32 = 1;
/// The parameter is a list of numbers.
pub const DASHPOT_SHAPE_LIST: u32 = 2;

/// One row of the parameter table. Set struct_size before the call.
#[repr(C)]
pub struct dashpot_parameter {
    /// sizeof(dashpot_parameter).
    pub struct_size: u32,
    /// DASHPOT_SHAPE_NUMBER, DASHPOT_SHAPE_CHOICE or DASHPOT_SHAPE_LIST.
    pub shape: u32,
    /// Capacity: 1, or the maximum length of a list.
    pub capacity: u32,
    /// Row of this parameter in the table.
    pub row: u32,
    /// Default; for a list its first number (dashpot_params_get_list() on a default set returns all).
    pub default_value: f64,
    /// Smallest allowed value.
    pub low: f64,
    /// Largest allowed value.
    pub high: f64,
    /// Name.
    pub name: [c_char; 48],
    /// SI unit; "-" for a pure number.
    pub unit: [c_char; 16],
    /// Name of the parameter's element, or of the group of settings.
    pub element: [c_char; 48],
    /// Meaning in one sentence.
    pub meaning: [c_char; 256],
}

/// Length of the array of a name, including at least one terminating zero.
pub(crate) const NAME_LENGTH: usize = 48;

const _: () = {
    let mut g = 0;
    while g < GROUPS.len() {
        assert!(GROUPS[g].name.len() < NAME_LENGTH);
        let mut p = 0;
        while p < GROUPS[g].parameters.len() {
            let row = &GROUPS[g].parameters[p];
            // The last 64 bytes of the array for the meaning are reserved for the words of a choice.
            assert!(row.name.len() < NAME_LENGTH && row.unit.len() < 16 && row.meaning.len() < 192);
            p += 1;
        }
        g += 1;
    }
};

/// Number of rows of the parameter table.
#[unsafe(no_mangle)]
pub extern "C" fn dashpot_parameter_count() -> u32 {
    COUNT as u32
}

/// Describes row `row` of the parameter table, from 0.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn dashpot_parameter_info(row: u32, info: *mut dashpot_parameter) -> i32 {
    status((|| {
        // SAFETY: the manual (`lib.rs`) guarantees that `info` is null, misaligned, or not used elsewhere during the call.
        let info = unsafe { exclusive(info) }?;
        if info.struct_size as usize != size_of::<dashpot_parameter>() {
            return Err(Rejected(DASHPOT_STRUCT_SIZE));
        }
        let found = table().nth(row as usize).ok_or(Rejected(DASHPOT_NO_SUCH_ROW))?;
        let p = found.parameter;
        let words: &[&str] = match p.shape {
            Shape::Choice(words) => words,
            _ => &[],
        };
        info.shape = match p.shape {
            Shape::Scalar => DASHPOT_SHAPE_NUMBER,
            Shape::Choice(_) => DASHPOT_SHAPE_CHOICE,
            Shape::List(_) => DASHPOT_SHAPE_LIST,
        };
        info.capacity = match p.shape {
            Shape::List(capacity) => capacity as u32,
            _ => 1,
        };
        info.row = row;
        info.default_value = p.default.first().copied().unwrap_or(0.0);
        (info.low, info.high) = (p.low, p.high);
        text::write(&mut info.name, [p.name].into_iter());
        text::write(&mut info.unit, [p.unit].into_iter());
        text::write(&mut info.element, GROUPS.get(found.group).map(|group| group.name).into_iter());
        let choices = words.iter().enumerate().flat_map(|(i, word)| [if i == 0 { ": " } else { ", " }, *word]);
        text::write(&mut info.meaning, [p.meaning].into_iter().chain(choices));
        Ok(DASHPOT_OK)
    })())
}

/// Returns the name of the parameter in a row of the parameter table, or `None` if the table has no such row.
pub(crate) fn parameter_name(row: u16) -> Option<&'static str> {
    table().nth(row as usize).map(|row| row.parameter.name)
}
