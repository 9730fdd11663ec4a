//! Pointers from C: refused when null or misaligned, references afterwards.

use core::ffi::c_char;
use core::mem::align_of;

use crate::status::{DASHPOT_MISALIGNED, DASHPOT_NULL, DASHPOT_UNKNOWN_NAME, Rejected};

/// Refuses an address that cannot be one of a `T`.
#[inline(always)]
pub(crate) fn usable<T>(pointer: *const T) -> Result<(), Rejected> {
    present(pointer)?;
    if pointer.is_aligned() { Ok(()) } else { Err(Rejected(DASHPOT_MISALIGNED)) }
}

/// Refuses a null pointer.
#[inline(always)]
pub(crate) fn present<T>(pointer: *const T) -> Result<(), Rejected> {
    if pointer.is_null() { Err(Rejected(DASHPOT_NULL)) } else { Ok(()) }
}

/// Refuses unless all pointers are aligned (or null). One question for all of them: this is in the way of every step.
macro_rules! aligned {
    ($($pointer:expr),+ $(,)?) => {
        if 0 $(| $crate::pointer::off($pointer))+ != 0 {
            return Err($crate::status::Rejected($crate::status::DASHPOT_MISALIGNED));
        }
    };
}
pub(crate) use aligned;

/// The bits of the address that must be zero.
#[inline(always)]
pub(crate) fn off<T>(pointer: *const T) -> usize {
    pointer.addr() & (align_of::<T>() - 1)
}

/// What `pointer` points to, for reading.
///
/// # Safety
/// Null, misaligned, or a `T` that nobody writes meanwhile.
#[inline(always)]
pub(crate) unsafe fn shared<'a, T>(pointer: *const T) -> Result<&'a T, Rejected> {
    usable(pointer)?;
    // SAFETY: not null and aligned by `usable`; the rest is the caller's promise.
    Ok(unsafe { &*pointer })
}

/// What `pointer` points to, for writing.
///
/// # Safety
/// Null, misaligned, or room for a `T` that nobody else reads or writes meanwhile.
#[inline(always)]
pub(crate) unsafe fn exclusive<'a, T>(pointer: *mut T) -> Result<&'a mut T, Rejected> {
    usable(pointer)?;
    // SAFETY: not null and aligned by `usable`; that nobody else uses it is the caller's promise.
    Ok(unsafe { &mut *pointer })
}

/// The elements of an array; `pointer` may be null when there are none.
///
/// # Safety
/// As [`shared`], for `count` elements.
pub(crate) unsafe fn array<'a, T>(pointer: *const T, count: usize) -> Result<&'a [T], Rejected> {
    if count == 0 {
        return Ok(&[]);
    }
    usable(pointer)?;
    // SAFETY: not null and aligned by `usable`; that `count` elements are there is the caller's promise.
    Ok(unsafe { core::slice::from_raw_parts(pointer, count) })
}

/// The one of `known` that the C string spells. Not a byte behind the string is read.
///
/// # Safety
/// Null or a zero-terminated string.
pub(crate) unsafe fn one_of<T>(
    pointer: *const c_char,
    mut known: impl Iterator<Item = T>,
    name: impl Fn(&T) -> &'static str,
) -> Result<T, Rejected> {
    usable(pointer)?;
    // SAFETY: not null; that it is zero-terminated is the caller's promise.
    known.find(|one| unsafe { spells(pointer, name(one).as_bytes()) }).ok_or(Rejected(DASHPOT_UNKNOWN_NAME))
}

/// Whether the C string is `name`.
///
/// # Safety
/// A zero-terminated string.
unsafe fn spells(pointer: *const c_char, name: &[u8]) -> bool {
    // A name holds no zero, so the comparison stops at the string's end at the latest.
    // SAFETY: no byte before this one was the closing zero: a name holds none, and `all` stops at the first
    // difference.
    let same = name.iter().enumerate().all(|(i, c)| unsafe { *pointer.add(i) } as u8 == *c);
    // SAFETY: all bytes of the name were the string's, so that none of them closed it, and one more is there to read.
    same && unsafe { *pointer.add(name.len()) } == 0
}
