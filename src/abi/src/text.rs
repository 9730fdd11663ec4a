//! Text for C: zero-terminated, in fixed arrays.

use core::ffi::c_char;

/// Pads `text` with zeros, at least one, to `N` bytes. Panics if the text does not fit.
pub(crate) const fn padded<const N: usize>(text: &str) -> [u8; N] {
    let bytes = text.as_bytes();
    assert!(bytes.len() < N, "the text does not fit");
    let mut array = [0; N];
    let mut i = 0;
    while i < bytes.len() {
        array[i] = bytes[i];
        i += 1;
    }
    array
}

/// Writes the pieces consecutively into `to`, truncates them to its length less one, and fills the rest with zeros.
pub(crate) fn write<'a>(to: &mut [c_char], pieces: impl Iterator<Item = &'a str>) {
    write_bytes(to, pieces.map(str::as_bytes));
}

/// Writes pieces of bytes like [`write`] writes text. They may be parts of a file in any encoding.
pub(crate) fn write_bytes<'a>(to: &mut [c_char], pieces: impl Iterator<Item = &'a [u8]>) {
    let (last, to) = match to.split_last_mut() {
        Some(parts) => parts,
        None => return,
    };
    let mut bytes = pieces.flatten().copied();
    for c in to {
        *c = bytes.next().unwrap_or(0) as c_char;
    }
    *last = 0;
}
