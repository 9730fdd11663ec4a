//! Parameters
//!
//! A parameter set is filled with defaults first, then changed by name, or read from a model file. The names, with
//! units, bounds and meaning, are listed at the end of this header.

use core::ffi::c_char;
use core::mem::{align_of, offset_of, size_of};

use dashpot_core::family::Axis;
use dashpot_core::family::Family;
use dashpot_core::family::axis::{ENTRIES, can_vary, index_of};
use dashpot_core::model_file;
use dashpot_core::parameter::{Element, Row, table};
use dashpot_core::{Fault, Model, Params};

use crate::pointer::{array, exclusive, one_of, shared, usable};
use crate::status::{
    DASHPOT_ABI_MISMATCH, DASHPOT_BUFFER_TOO_SHORT, DASHPOT_NOT_INITIALIZED, DASHPOT_OK, DASHPOT_STRUCT_SIZE,
    DASHPOT_UNKNOWN_NAME, Rejected, status,
};
use crate::table::parameter_name;
use crate::text;
use crate::version::{DASHPOT_ABI_VERSION, magic};

/// A parameter set. Start with DASHPOT_PARAMS_INIT, or set the first two members by hand, and call
/// dashpot_params_default().
#[repr(C, align(16))]
pub struct dashpot_params {
    /// sizeof(dashpot_params).
    pub struct_size: u32,
    /// DASHPOT_ABI_VERSION.
    pub abi_version: u32,
    /// Internal data of the library.
    pub opaque: [u64; 2047],
}

/// An error and its position.
#[repr(C)]
pub struct dashpot_fault {
    /// The status; 0 without an error.
    pub status: i32,
    /// Line of the model file, from 1; 0 if no line is at fault.
    pub line: u32,
    /// Name of the parameter or element, zero-terminated; empty if none is at fault.
    pub parameter: [c_char; 48],
}

/// Contents of a [`dashpot_params`] block.
#[repr(C, align(16))]
struct Filled {
    struct_size: u32,
    abi_version: u32,
    magic: u64,
    values: Params,
    axis: Axis,
}

const MAGIC: u64 = magic("params", size_of::<Params>() + size_of::<Axis>());

const _: () = {
    assert!(size_of::<dashpot_params>() == 16384 && size_of::<Filled>() <= size_of::<dashpot_params>());
    assert!(align_of::<dashpot_params>() == 16 && align_of::<Filled>() == 16);
    assert!(offset_of!(dashpot_params, abi_version) == offset_of!(Filled, abi_version));
};

/// Returns the block of parameters if its size and interface version are correct.
///
/// # Safety
/// `params` is null, misaligned, or a block of the caller.
unsafe fn block(params: *const dashpot_params) -> Result<*const Filled, Rejected> {
    // SAFETY: the requirements are those of `shared`.
    let head = unsafe { shared(params) }?;
    if head.struct_size as usize != size_of::<dashpot_params>() {
        return Err(Rejected(DASHPOT_STRUCT_SIZE));
    }
    if head.abi_version != DASHPOT_ABI_VERSION {
        return Err(Rejected(DASHPOT_ABI_MISMATCH));
    }
    Ok(params.cast())
}

/// Returns the values of a filled block.
///
/// # Safety
/// The requirements of [`shared`].
pub(crate) unsafe fn values<'a>(params: *const dashpot_params) -> Result<&'a Params, Rejected> {
    // SAFETY: `block` checked size and version, so the block has the size and alignment of `Filled`. Any bytes are a valid magic word, and
    // the values are read only if the word is right.
    let block = unsafe { &*block(params)? };
    if block.magic != MAGIC { Err(Rejected(DASHPOT_NOT_INITIALIZED)) } else { Ok(&block.values) }
}

/// Returns the setting on which a parameter set depends. Its grid is empty if the set depends on no setting.
///
/// # Safety
/// The requirements of [`shared`].
pub(crate) unsafe fn axis<'a>(params: *const dashpot_params) -> Result<&'a Axis, Rejected> {
    // SAFETY: the requirements are those of `values`.
    unsafe { values(params) }?;
    // SAFETY: `values` above excludes null, misaligned and unfilled blocks.
    Ok(unsafe { &(*params.cast::<Filled>()).axis })
}

/// Returns mutable access to the setting on which a parameter set depends.
///
/// # Safety
/// `params` is null, misaligned, or a block of the caller that nobody else uses.
pub(crate) unsafe fn axis_mut<'a>(params: *mut dashpot_params) -> Result<&'a mut Axis, Rejected> {
    // SAFETY: the caller guarantees the requirements of `exclusive`, which include those of `values`.
    unsafe { values(params) }?;
    // SAFETY: `values` above excludes null, misaligned and unfilled blocks. The caller guarantees exclusive access.
    Ok(unsafe { &mut (*params.cast::<Filled>()).axis })
}

/// Returns the index in [`ENTRIES`] of the number with this name. These numbers describe the actuator and the start of the setting.
///
/// # Safety
/// `name` is null or zero-terminated.
unsafe fn entry(name: *const c_char) -> Result<usize, Rejected> {
    // SAFETY: the requirements are those of `one_of`.
    let entry = unsafe { one_of(name, ENTRIES.iter(), |entry| entry.name) }?;
    index_of(entry.name.as_bytes()).ok_or(Rejected(DASHPOT_UNKNOWN_NAME))
}

/// Returns mutable access to the values of a filled block.
///
/// # Safety
/// The requirements of [`exclusive`].
unsafe fn values_mut<'a>(params: *mut dashpot_params) -> Result<&'a mut Params, Rejected> {
    // SAFETY: the caller guarantees the requirements of `exclusive`, which include those of `values`.
    unsafe { values(params) }?;
    // SAFETY: `values` above excludes null, misaligned and unfilled blocks. The caller guarantees exclusive access.
    Ok(unsafe { &mut (*params.cast::<Filled>()).values })
}

/// Returns the row of the parameter table with this name.
///
/// # Safety
/// The requirements of [`one_of`].
pub(crate) unsafe fn parameter(name: *const c_char) -> Result<Row, Rejected> {
    // SAFETY: the requirements are those of `one_of`.
    unsafe { one_of(name, table(), |row| row.parameter.name) }
}

/// Returns the element with this name.
///
/// # Safety
/// The requirements of [`one_of`].
unsafe fn element(name: *const c_char) -> Result<Element, Rejected> {
    // SAFETY: the requirements are those of `one_of`.
    unsafe { one_of(name, Element::all(), |element| element.name()) }
}

fn fill(report: &mut dashpot_fault, status: i32, line: u32, parameter: Option<&[u8]>) {
    (report.status, report.line) = (status, line);
    text::write_bytes(&mut report.parameter, parameter.into_iter());
}

impl From<Fault> for Rejected {
    fn from(fault: Fault) -> Rejected {
        fault.reason.into()
    }
}

/// Fills a parameter set with the defaults of the table. params->struct_size and params->abi_version must be set.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn dashpot_params_default(params: *mut dashpot_params) -> i32 {
    status((|| {
        // SAFETY: the manual (`lib.rs`) guarantees that `params` is null, misaligned, or a block of the caller.
        let block = unsafe { block(params) }?.cast_mut();
        // SAFETY: `block` checked size and alignment. Raw writes come before the first reference.
        unsafe {
            (&raw mut (*block).values).write(Params::new());
            (&raw mut (*block).axis).write(Axis::NONE);
            (*block).magic = MAGIC;
        }
        Ok(DASHPOT_OK)
    })())
}

/// Sets one number, or a choice by its index from 0. A number that depended on the setting is then constant.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn dashpot_params_set(params: *mut dashpot_params, name: *const c_char, value: f64) -> i32 {
    status((|| {
        // SAFETY: the manual (`lib.rs`) guarantees that each pointer is null, misaligned, or not used elsewhere during the call.
        // Names are zero-terminated.
        let (row, entry) = unsafe { (parameter(name), entry(name)) };
        if let Ok(index) = entry {
            // SAFETY: as above.
            unsafe { axis_mut(params) }?.set_number(index, value)?;
            return Ok(DASHPOT_OK);
        }
        // SAFETY: as above.
        let (params, axis) = unsafe { (values_mut(params)?, axis_mut(params)?) };
        let number = row?.try_into()?;
        params.set(number, value)?;
        axis.forget_values(number);
        Ok(DASHPOT_OK)
    })())
}

/// Sets a list of count numbers. The two lists of a curve may be set in any order; whether they fit together is
/// checked by dashpot_params_check() and dashpot_model_init().
#[unsafe(no_mangle)]
pub unsafe extern "C" fn dashpot_params_set_list(
    params: *mut dashpot_params,
    name: *const c_char,
    values: *const f64,
    count: u32,
) -> i32 {
    status((|| {
        // SAFETY: the manual (`lib.rs`) guarantees that each pointer is null, misaligned, or not used elsewhere during the call.
        // Names are zero-terminated.
        let (params, axis, row) = unsafe { (values_mut(params)?, axis_mut(params)?, parameter(name)?) };
        // SAFETY: the manual (`lib.rs`) guarantees that the pointer is null, misaligned, or that it has `count` numbers.
        let values = unsafe { array(values, count as usize) }?;
        let list = row.try_into()?;
        params.set_list(list, values)?;
        if can_vary(list) {
            axis.forget_forces();
        }
        Ok(DASHPOT_OK)
    })())
}

/// Reads one number, or the index of a choice from 0, into *value.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn dashpot_params_get(
    params: *const dashpot_params,
    name: *const c_char,
    value: *mut f64,
) -> i32 {
    status((|| {
        // SAFETY: the manual (`lib.rs`) guarantees that each pointer is null, misaligned, or not used elsewhere during the call.
        // Names are zero-terminated.
        let (row, entry, value) = unsafe { (parameter(name), entry(name), exclusive(value)?) };
        if let Ok(index) = entry {
            // SAFETY: as above.
            *value = unsafe { axis(params) }?.number(index);
            return Ok(DASHPOT_OK);
        }
        // SAFETY: as above.
        *value = unsafe { values(params) }?.number(row?.try_into()?);
        Ok(DASHPOT_OK)
    })())
}

/// Reads a list into values, which has room for capacity numbers, and its length into *count. If values is null, only the
/// length is returned.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn dashpot_params_get_list(
    params: *const dashpot_params,
    name: *const c_char,
    values: *mut f64,
    capacity: u32,
    count: *mut u32,
) -> i32 {
    status((|| {
        // SAFETY: the manual (`lib.rs`) guarantees that each pointer is null, misaligned, or not used elsewhere during the call.
        // Names are zero-terminated.
        let (params, row, count) = unsafe { (self::values(params)?, parameter(name)?, exclusive(count)?) };
        let list = params.list(row.try_into()?);
        if !values.is_null() {
            usable(values)?;
            if list.len() > capacity as usize {
                return Err(Rejected(DASHPOT_BUFFER_TOO_SHORT));
            }
            // SAFETY: `usable` excludes null and misaligned pointers. The manual (`lib.rs`) guarantees room for `capacity` numbers. The
            // comparison above proves that they suffice. A list lies inside the parameter set, which the caller's array does not overlap.
            unsafe { core::ptr::copy_nonoverlapping(list.as_ptr(), values, list.len()) };
        }
        *count = list.len() as u32;
        Ok(DASHPOT_OK)
    })())
}

/// Switches an element of the model on (on not 0) or off (0).
#[unsafe(no_mangle)]
pub unsafe extern "C" fn dashpot_params_enable(params: *mut dashpot_params, element: *const c_char, on: u32) -> i32 {
    status((|| {
        // SAFETY: the manual (`lib.rs`) guarantees that each pointer is null, misaligned, or not used elsewhere during the call.
        // Names are zero-terminated.
        let (params, element) = unsafe { (values_mut(params)?, self::element(element)?) };
        params.enable(element, on != 0);
        Ok(DASHPOT_OK)
    })())
}

/// Reads whether an element of the model is on: *on becomes 1 or 0.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn dashpot_params_is_on(
    params: *const dashpot_params,
    element: *const c_char,
    on: *mut u32,
) -> i32 {
    status((|| {
        // SAFETY: the manual (`lib.rs`) guarantees that each pointer is null, misaligned, or not used elsewhere during the call.
        // Names are zero-terminated.
        let (params, element, on) = unsafe { (values(params)?, self::element(element)?, exclusive(on)?) };
        *on = params.is_on(element) as u32;
        Ok(DASHPOT_OK)
    })())
}

/// Reads a model file: text contains the length bytes of the file, without a terminating zero.
///
/// All parameters are set: those that the file does not name get their defaults, so dashpot_params_default() is not needed before.
/// On an error *fault contains the line and the parameter; fault may be null.
///
/// Numbers are read the same way whatever the locale: the decimal sign is a point.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn dashpot_params_read(
    params: *mut dashpot_params,
    text: *const c_char,
    length: usize,
    fault: *mut dashpot_fault,
) -> i32 {
    status((|| {
        // SAFETY: the manual (`lib.rs`) guarantees that `params` is null, misaligned, or a block of the caller.
        let block = unsafe { block(params) }?.cast_mut();
        // SAFETY: the manual (`lib.rs`) guarantees that `text` is null or has `length` bytes.
        let text = unsafe { array(text.cast::<u8>(), length) }?;
        // SAFETY: null is handled first. Otherwise `exclusive` rejects a misaligned pointer, and the manual (`lib.rs`) guarantees
        // exclusive access.
        let report = if fault.is_null() { None } else { Some(unsafe { exclusive(fault) }?) };
        let (line, found) = match model_file::check_family(text) {
            Ok(()) => {
                // SAFETY: `block` checked size and alignment. Raw writes come before the first reference, because the caller's memory may
                // be uninitialized.
                unsafe {
                    (&raw mut (*block).values).write(Params::new());
                    (&raw mut (*block).axis).write(Axis::NONE);
                    (*block).magic = MAGIC;
                    // `check_family` accepted the text, so this read succeeds.
                    let _ = model_file::read_checked(text, &mut (*block).values, &mut (*block).axis);
                }
                (0, None)
            }
            Err(error) => (error.line, Some(error)),
        };
        let code = found.map_or(DASHPOT_OK, |error| Rejected::from(error.problem).0);
        if let Some(report) = report {
            // For a name that is not in the parameter table, the fault contains the name as the file spells it.
            let name = |error: &model_file::ReadError| {
                parameter_name(error.parameter).map(str::as_bytes).or_else(|| model_file::name_at(text, error))
            };
            fill(report, code, line, found.as_ref().and_then(name));
        }
        Ok(code)
    })())
}

/// Checks the set as dashpot_model_init() does, and names the parameter at fault in *fault.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn dashpot_params_check(params: *const dashpot_params, fault: *mut dashpot_fault) -> i32 {
    status((|| {
        // SAFETY: the manual (`lib.rs`) guarantees that each pointer is null, misaligned, or not used elsewhere during the call.
        // Names are zero-terminated.
        let (params, axis, report) = unsafe { (values(params)?, axis(params)?, exclusive(fault)?) };
        let found = if axis.is_some() { Family::check(params, axis) } else { Model::check(params) }.err();
        let code = found.map_or(DASHPOT_OK, |fault| Rejected::from(fault).0);
        fill(report, code, 0, found.and_then(|fault| parameter_name(fault.parameter)).map(str::as_bytes));
        Ok(code)
    })())
}
