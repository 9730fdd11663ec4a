//! Version
//!
//! The interface version counts changes of the structures and functions below. Programs built for one interface version run
//! with every library of the same interface version. With another one every function that takes a parameter set rejects it
//! (DASHPOT_ABI_MISMATCH), and the program has to be built again. Parameters and elements may be added within one
//! interface version. A model file or a program that does not name them gets the same results as before. The digits of a force may
//! change from one library version to the next, within the stated accuracy. Do not exchange states and
//! models between versions; exchange parameter sets as model files.

use core::ffi::c_char;

/// Version of this interface.
pub const DASHPOT_ABI_VERSION: u32 = 9;

/// Version of the library that this header belongs to: DASHPOT_VERSION_MAJOR.DASHPOT_VERSION_MINOR.DASHPOT_VERSION_PATCH.
pub const DASHPOT_VERSION_MAJOR: u32 = 0;
/// See DASHPOT_VERSION_MAJOR.
pub const DASHPOT_VERSION_MINOR: u32 = 1;
/// See DASHPOT_VERSION_MAJOR.
pub const DASHPOT_VERSION_PATCH: u32 = 0;

/// Parses a decimal number.
const fn number(text: &str) -> u32 {
    let (bytes, mut value, mut i) = (text.as_bytes(), 0, 0);
    while i < bytes.len() {
        value = value * 10 + (bytes[i] - b'0') as u32;
        i += 1;
    }
    value
}

const _: () = {
    assert!(number(env!("CARGO_PKG_VERSION_MAJOR")) == DASHPOT_VERSION_MAJOR);
    assert!(number(env!("CARGO_PKG_VERSION_MINOR")) == DASHPOT_VERSION_MINOR);
    assert!(number(env!("CARGO_PKG_VERSION_PATCH")) == DASHPOT_VERSION_PATCH);
};

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

/// Returns a number that identifies an initialized block. It depends on the kind of block, the library version and the size.
pub(crate) const fn magic(kind: &str, size: usize) -> u64 {
    let mut hash = fold(0xcbf2_9ce4_8422_2325, kind.as_bytes());
    hash = fold(hash, env!("CARGO_PKG_VERSION").as_bytes());
    fold(hash, &(size as u64).to_le_bytes())
}

/// Continues an FNV-1a hash with more bytes.
const fn fold(mut hash: u64, bytes: &[u8]) -> u64 {
    let mut i = 0;
    while i < bytes.len() {
        hash = (hash ^ bytes[i] as u64).wrapping_mul(0x0000_0100_0000_01b3);
        i += 1;
    }
    hash
}
