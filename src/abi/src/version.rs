//! Version
//!
//! The interface version counts changes of the structures and functions below. Programs written for one interface
//! version run with every library of the same interface version.

use core::ffi::c_char;

/// Version of this interface.
pub const DASHPOT_ABI_VERSION: u32 = 8;

/// The interface version of the library that is loaded; compare it with DASHPOT_ABI_VERSION.
#[unsafe(no_mangle)]
pub extern "C" fn dashpot_abi_version() -> u32 {
    DASHPOT_ABI_VERSION
}

/// The version of the library as text, "major.minor.patch". Never null; lives as long as the library.
#[unsafe(no_mangle)]
pub extern "C" fn dashpot_version() -> *const c_char {
    concat!(env!("CARGO_PKG_VERSION"), "\0").as_ptr().cast()
}

/// A number that differs between builds whose blocks differ: what an initialised block is known by.
pub(crate) const fn magic(kind: &str, size: usize) -> u64 {
    let mut hash = fold(0xcbf2_9ce4_8422_2325, kind.as_bytes());
    hash = fold(hash, env!("CARGO_PKG_VERSION").as_bytes());
    fold(hash, &(size as u64).to_le_bytes())
}

/// FNV-1a.
const fn fold(mut hash: u64, bytes: &[u8]) -> u64 {
    let mut i = 0;
    while i < bytes.len() {
        hash = (hash ^ bytes[i] as u64).wrapping_mul(0x0000_0100_0000_01b3);
        i += 1;
    }
    hash
}
