//! Conversion of pointers from C to references. Null and misaligned pointers are rejected.

use core::ffi::c_char;
use core::mem::align_of;

use crate::status::{DASHPOT_MISALIGNED, DASHPOT_NULL, DASHPOT_UNKNOWN_NAME, Rejected};

/// Rejects an address that is null or not aligned for a `T`.
#[inline(always)]
pub(crate) fn usable<T>(pointer: *const T) -> Result<(), Rejected> {
    present(pointer)?;
    if pointer.is_aligned() { Ok(()) } else { Err(Rejected(DASHPOT_MISALIGNED)) }
}

/// Rejects a null pointer.
#[inline(always)]
pub(crate) fn present<T>(pointer: *const T) -> Result<(), Rejected> {
    if pointer.is_null() { Err(Rejected(DASHPOT_NULL)) } else { Ok(()) }
}

/// Rejects misaligned pointers. Null is accepted here. One combined check keeps the cost of a step low.
macro_rules! aligned {
    ($($pointer:expr),+ $(,)?) => {
        if 0 $(| $crate::pointer::misaligned_bits($pointer))+ != 0 {
            return Err($crate::status::Rejected($crate::status::DASHPOT_MISALIGNED));
        }
    };
}
pub(crate) use aligned;

/// Returns the address bits that are zero for an aligned pointer.
#[inline(always)]
pub(crate) fn misaligned_bits<T>(pointer: *const T) -> usize {
    pointer.addr() & (align_of::<T>() - 1)
}

/// Returns shared access to the target of `pointer`.
///
/// # Safety
/// `pointer` is null, misaligned, or a `T` that nobody writes during the call.
#[inline(always)]
pub(crate) unsafe fn shared<'a, T>(pointer: *const T) -> Result<&'a T, Rejected> {
    usable(pointer)?;
    // SAFETY: `usable` excludes null and misaligned pointers. The caller guarantees the rest.
    Ok(unsafe { &*pointer })
}

/// Returns exclusive access to the target of `pointer`.
///
/// # Safety
/// `pointer` is null, misaligned, or room for a `T` that nobody else reads or writes during the call.
#[inline(always)]
pub(crate) unsafe fn exclusive<'a, T>(pointer: *mut T) -> Result<&'a mut T, Rejected> {
    usable(pointer)?;
    // SAFETY: `usable` excludes null and misaligned pointers. The caller guarantees exclusive access.
    Ok(unsafe { &mut *pointer })
}

/// Returns the elements of an array. `pointer` may be null if `count` is 0.
///
/// # Safety
/// The requirements of [`shared`], for `count` elements.
pub(crate) unsafe fn array<'a, T>(pointer: *const T, count: usize) -> Result<&'a [T], Rejected> {
    if count == 0 {
        return Ok(&[]);
    }
    usable(pointer)?;
    // SAFETY: `usable` excludes null and misaligned pointers. The caller guarantees `count` elements.
    Ok(unsafe { core::slice::from_raw_parts(pointer, count) })
}

/// Returns the element of `known` whose name equals the C string. Reads no byte after the string.
///
/// # Safety
/// `pointer` is null or a zero-terminated string.
pub(crate) unsafe fn one_of<T>(
    pointer: *const c_char,
    mut known: impl Iterator<Item = T>,
    name: impl Fn(&T) -> &'static str,
) -> Result<T, Rejected> {
    usable(pointer)?;
    // SAFETY: `usable` excludes null. The caller guarantees a zero-terminated string.
    known.find(|one| unsafe { spells(pointer, name(one).as_bytes()) }).ok_or(Rejected(DASHPOT_UNKNOWN_NAME))
}

/// Returns whether the C string equals `name`.
///
/// # Safety
/// `pointer` is a zero-terminated string.
unsafe fn spells(pointer: *const c_char, name: &[u8]) -> bool {
    // A name contains no zero byte, so the comparison stops at the end of the string at the latest.
    // SAFETY: all bytes before this one equal those of the name, so none of them was the terminating zero. `all` stops at the first
    // difference.
    let same = name.iter().enumerate().all(|(i, c)| unsafe { *pointer.add(i) } as u8 == *c);
    // SAFETY: all bytes of the name equal those of the string, so none terminated it and one more byte exists.
    same && unsafe { *pointer.add(name.len()) } == 0
}
