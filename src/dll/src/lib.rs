//! The C interface of `dashpot-abi` as a shared and a static library.
//!
//! It adds the panic handler that a library without `std` must have.
//!
//! The library must have no path to a panic, and the linker proves it. The handler calls a function that exists nowhere. A remaining path
//! then appears as an undefined symbol of the shared library, and a static link fails.
//! Linkers for Windows resolve names before they drop unused code, so the handler calls nothing there. The proof on other platforms
//! also applies to Windows, because the sources are the same.

// Checking tools build a test harness even if tests are disabled. The harness brings its own panic handler.
#![cfg_attr(not(test), no_std)]

pub use dashpot_abi::*;

#[cfg(not(any(test, debug_assertions, windows)))]
#[panic_handler]
fn panic(_: &core::panic::PanicInfo) -> ! {
    unsafe extern "C" {
        fn dashpot_panic_path_exists() -> !;
    }
    // SAFETY: the function is never linked, and therefore never called.
    unsafe { dashpot_panic_path_exists() }
}

/// Handles panics of builds with debug assertions, which have panic paths, and of builds for Windows. There is no output for a message.
#[cfg(all(any(debug_assertions, windows), not(test)))]
#[panic_handler]
fn panic(_: &core::panic::PanicInfo) -> ! {
    loop {}
}
