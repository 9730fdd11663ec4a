//! Model
//!
//! A model is a parameter set that was checked and prepared. It is constant while it runs, and one model serves any
//! number of dampers.

use core::ffi::c_char;
use core::mem::{MaybeUninit, align_of, offset_of, size_of};

use dashpot_core::Model;
use dashpot_core::family::Family;

use crate::params::{axis, dashpot_params, values};
use crate::pointer::{exclusive, present, usable};
use crate::status::{
    DASHPOT_NO_SUCH_STATE, DASHPOT_NOT_INITIALIZED, DASHPOT_OK, DASHPOT_STRUCT_SIZE, Rejected, status,
};
use crate::text;
use crate::version::magic;

/// A prepared model. The host neither reads nor writes its contents.
#[repr(C, align(16))]
pub struct dashpot_model {
    /// Internal data of the library.
    pub opaque: [u64; 6144],
}

/// Contents of a [`dashpot_model`] block for a damper without a setting.
#[repr(C, align(16))]
pub(crate) struct Prepared {
    magic: u64,
    model: Model,
}

/// Contents of a [`dashpot_model`] block for a damper that depends on a setting.
#[repr(C, align(16))]
struct PreparedFamily {
    magic: u64,
    family: Family,
}

/// Model before preparation. All bytes are zero, so that the library's data need no copy of a model.
// SAFETY: the compiler evaluates this constant, and rejects it if zero bytes are not a valid model.
const BLANK: Model = unsafe { MaybeUninit::zeroed().assume_init() };

/// Family before preparation. All bytes are zero.
// SAFETY: any bytes, zeros included, are valid numbers of a family.
const BLANK_FAMILY: Family = unsafe { MaybeUninit::zeroed().assume_init() };

const MAGIC: u64 = magic("model", size_of::<Model>());
const MAGIC_FAMILY: u64 = magic("family", size_of::<Family>());

const _: () = {
    assert!(size_of::<dashpot_model>() == 49152 && size_of::<Prepared>() <= size_of::<dashpot_model>());
    assert!(size_of::<PreparedFamily>() <= size_of::<dashpot_model>() && align_of::<PreparedFamily>() == 16);
    assert!(offset_of!(PreparedFamily, magic) == offset_of!(Prepared, magic));
    assert!(align_of::<dashpot_model>() == 16 && align_of::<Prepared>() == 16);
};

/// Returns the model in an initialized block.
///
/// # Safety
/// `model` is null, misaligned, or a `dashpot_model` that nobody writes during the call.
#[inline(always)]
pub(crate) unsafe fn prepared<'a>(model: *const dashpot_model) -> Result<&'a Model, Rejected> {
    usable(model)?;
    // SAFETY: `usable` checked the alignment, and the caller guarantees the rest.
    unsafe { prepared_aligned(model) }
}

/// Returns a prepared model at an aligned address.
///
/// # Safety
/// `model` is null, or a `dashpot_model` that nobody writes during the call.
#[inline(always)]
pub(crate) unsafe fn prepared_aligned<'a>(model: *const dashpot_model) -> Result<&'a Model, Rejected> {
    present(model)?;
    // SAFETY: `present` excludes null, and the caller guarantees alignment. Any bytes are a valid magic word, and the model is read only if
    // the word is right.
    let block = unsafe { &*model.cast::<Prepared>() };
    if block.magic != MAGIC { Err(Rejected(DASHPOT_NOT_INITIALIZED)) } else { Ok(&block.model) }
}

/// Returns the family in a block that was initialized for a damper with a setting. Callers try [`prepared`] first.
///
/// # Safety
/// `model` is null, misaligned, or a block of the caller.
#[cold]
pub(crate) unsafe fn family<'a>(model: *const dashpot_model) -> Result<&'a Family, Rejected> {
    usable(model)?;
    // SAFETY: `usable` excludes null and misaligned pointers. Any bytes are a valid magic word, and the family is read only if the word is
    // right.
    let block = unsafe { &*model.cast::<PreparedFamily>() };
    if block.magic != MAGIC_FAMILY { Err(Rejected(DASHPOT_NOT_INITIALIZED)) } else { Ok(&block.family) }
}

/// Returns a model that [`prepared`] has accepted.
///
/// # Safety
/// `model` was accepted by [`prepared`] and is unchanged since.
#[inline(always)]
pub(crate) unsafe fn ready<'a>(model: *const dashpot_model) -> &'a Model {
    // SAFETY: the caller guarantees that `prepared` has accepted this model.
    unsafe { &(*model.cast::<Prepared>()).model }
}

/// Returns the number of states that a solver of the host integrates (see Evaluation), from 2 to DASHPOT_MAX_STATES.
///
/// These are the states of the internal mass and the internal states of the elements that are on. A negative result is an error.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn dashpot_model_states(model: *const dashpot_model) -> i32 {
    status((|| {
        // SAFETY: the manual (`lib.rs`) guarantees that `model` is null, misaligned, or a model that nobody writes during the call.
        let states = match unsafe { prepared(model) } {
            Ok(model) => model.states(),
            // SAFETY: as above.
            Err(_) => unsafe { family(model) }?.states(),
        };
        Ok(states as i32)
    })())
}

/// Maximum number of states of a model; the capacity of dashpot_partials.
pub const DASHPOT_MAX_STATES: u32 = 10;

/// Name and unit of one state. Set struct_size before the call.
#[repr(C)]
pub struct dashpot_state_name {
    /// sizeof(dashpot_state_name).
    pub struct_size: u32,
    /// Index of the state, from 0.
    pub state: u32,
    /// Name, zero-terminated.
    pub name: [c_char; 48],
    /// SI unit; "-" for a pure number.
    pub unit: [c_char; 16],
}

/// Writes the name and the unit of state `state` of a model, counted from 0, to *name. State k is rate->mass_displacement,
/// rate->mass_velocity, rate->internal[k - 2].
#[unsafe(no_mangle)]
pub unsafe extern "C" fn dashpot_model_state_name(
    model: *const dashpot_model,
    state: u32,
    name: *mut dashpot_state_name,
) -> i32 {
    status((|| {
        // SAFETY: the manual (`lib.rs`) guarantees that each pointer is null, misaligned, or not used elsewhere during the call.
        let to = unsafe { exclusive(name)? };
        if to.struct_size as usize != size_of::<dashpot_state_name>() {
            return Err(Rejected(DASHPOT_STRUCT_SIZE));
        }
        // SAFETY: as above.
        let found = match unsafe { prepared(model) } {
            Ok(model) => model.state_name(state as usize),
            // SAFETY: as above.
            Err(_) => unsafe { family(model) }?.state_name(state as usize),
        };
        let (name, unit) = found.ok_or(Rejected(DASHPOT_NO_SUCH_STATE))?;
        to.state = state;
        text::write(&mut to.name, [name].into_iter());
        text::write(&mut to.unit, [unit].into_iter());
        Ok(DASHPOT_OK)
    })())
}

/// Checks a parameter set and prepares a model from it.
///
/// On an error dashpot_params_check() names the parameter at fault. A running model may be prepared again between two steps, for
/// example by a slider, with elements switched on and off: the states stay valid. A parameter set with a setting yields a model of
/// all settings (see Setting).
#[unsafe(no_mangle)]
pub unsafe extern "C" fn dashpot_model_init(model: *mut dashpot_model, params: *const dashpot_params) -> i32 {
    status((|| {
        usable(model)?;
        let block = model.cast::<Prepared>();
        // SAFETY: the manual (`lib.rs`) guarantees that `params` is null, misaligned, or a block that nobody writes during the call.
        let (params, axis) = unsafe { (values(params)?, axis(params)?) };
        if axis.is_some() {
            Family::check(params, axis)?;
            let block = model.cast::<PreparedFamily>();
            // SAFETY: as below. Both kinds of block lie at the caller's address, and their magic words at the same offset.
            unsafe {
                (&raw mut (*block).magic).write(0);
                (&raw mut (*block).family).write(BLANK_FAMILY);
                (*block).family.set_checked(params, axis)?;
                (*block).magic = MAGIC_FAMILY;
            }
            return Ok(DASHPOT_OK);
        }
        Model::check(params)?;
        // SAFETY: `model` is aligned and not null, and its memory is exclusive to this call. A parameter set never overlaps it. Raw writes
        // come before the first reference, because the memory may be uninitialized.
        unsafe {
            (&raw mut (*block).magic).write(0);
            (&raw mut (*block).model).write(BLANK);
            (*block).model.set(params)?;
            (*block).magic = MAGIC;
        }
        Ok(DASHPOT_OK)
    })())
}
