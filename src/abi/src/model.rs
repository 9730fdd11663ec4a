//! Model
//!
//! A model is a parameter set that was checked and made ready. It is constant while it runs, and one model serves any
//! number of dampers.

use core::mem::{align_of, size_of};

use dashpot_core::Model;

use crate::params::{dashpot_params, values};
use crate::pointer::{present, usable};
use crate::status::{DASHPOT_NOT_SET, DASHPOT_OK, Refused, status};
use crate::version::magic;

/// A prepared model. Nothing in it is for the host.
#[repr(C, align(16))]
pub struct dashpot_model {
    /// The library's.
    pub opaque: [u64; 3072],
}

/// What the block really holds.
#[repr(C, align(16))]
pub(crate) struct Prepared {
    magic: u64,
    model: Model,
}

const MAGIC: u64 = magic("model", size_of::<Model>());

const _: () = {
    assert!(size_of::<dashpot_model>() == 24576 && size_of::<Prepared>() <= size_of::<dashpot_model>());
    assert!(align_of::<dashpot_model>() == 16 && align_of::<Prepared>() == 16);
};

/// The model in a block that was initialised.
///
/// # Safety
/// Null, misaligned, or a `dashpot_model` that nobody writes meanwhile.
#[inline(always)]
pub(crate) unsafe fn prepared<'a>(model: *const dashpot_model) -> Result<&'a Model, Refused> {
    usable(model)?;
    unsafe { prepared_aligned(model) }
}

/// As [`prepared`], at an aligned address.
///
/// # Safety
/// Null, or a `dashpot_model` that nobody writes meanwhile.
#[inline(always)]
pub(crate) unsafe fn prepared_aligned<'a>(model: *const dashpot_model) -> Result<&'a Model, Refused> {
    present(model)?;
    let block = unsafe { &*model.cast::<Prepared>() };
    if block.magic != MAGIC { Err(Refused(DASHPOT_NOT_SET)) } else { Ok(&block.model) }
}

/// A model that was found prepared before.
///
/// # Safety
/// What [`prepared`] accepted, unchanged since.
#[inline(always)]
pub(crate) unsafe fn ready<'a>(model: *const dashpot_model) -> &'a Model {
    unsafe { &(*model.cast::<Prepared>()).model }
}

/// Checks a parameter set and prepares a model from it. Where it refuses, dashpot_params_check() names the parameter
/// to blame. A model that runs may be prepared anew between two steps, for example by a slider: the states stay valid.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn dashpot_model_init(model: *mut dashpot_model, params: *const dashpot_params) -> i32 {
    status((|| {
        usable(model)?;
        let prepared = Prepared { magic: MAGIC, model: Model::new(unsafe { values(params) }?)? };
        unsafe { model.cast::<Prepared>().write(prepared) };
        Ok(DASHPOT_OK)
    })())
}
