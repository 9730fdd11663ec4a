//! The C interface of `dashpot-abi` as a shared and a static library.
//!
//! It adds the panic handler that a library without `std` must have.
//!
//! The library must have no path to a panic. The linker proves it: the handler calls a function that exists nowhere,
//! so a surviving path shows as an undefined symbol of the shared library, and a static link fails. Linkers for Windows
//! resolve names before they drop what is unused, so there the handler calls nothing; the sources are the same.

// Checking tools build a test harness even where tests are off; that brings its own panic handler.
#![cfg_attr(not(test), no_std)]

pub use dashpot_abi::*;

#[cfg(not(any(test, debug_assertions, windows)))]
#[panic_handler]
fn panic(_: &core::panic::PanicInfo) -> ! {
    unsafe extern "C" {
        fn dashpot_panic_path_exists() -> !;
    }
    // SAFETY: never linked, so never called.
    unsafe { dashpot_panic_path_exists() }
}

/// Builds with debug assertions have panic paths; there is nobody to tell.
#[cfg(all(any(debug_assertions, windows), not(test)))]
#[panic_handler]
fn panic(_: &core::panic::PanicInfo) -> ! {
    loop {}
}
