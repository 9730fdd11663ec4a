//! Detection of a closed standard output, before the runtime replaces it by the null device.

/// Returns an error message if the parent process closed standard output.
pub fn closed() -> Option<&'static str> {
    was_closed().then_some("standard output is closed; send it to a file, or to /dev/null if nobody reads it")
}

#[cfg(any(target_os = "linux", target_os = "macos"))]
mod at_start {
    use std::sync::atomic::{AtomicBool, Ordering};

    static CLOSED: AtomicBool = AtomicBool::new(false);

    extern "C" fn look() {
        // SAFETY: the borrowed descriptor is only queried for its flags, which is allowed for a closed descriptor.
        let out = unsafe { rustix::fd::BorrowedFd::borrow_raw(1) };
        CLOSED.store(rustix::io::fcntl_getfd(out).is_err(), Ordering::Relaxed);
    }

    // Before `main`, the language runtime opens the null device on closed standard descriptors. A closed output is then
    // indistinguishable from an output that the user redirected to the null device. Functions in the section of
    // initializers run earlier. SAFETY: the section contains pointers to functions without arguments, which the loader
    // calls once. `look` uses nothing that the runtime initializes later.
    #[used]
    #[cfg_attr(target_os = "linux", unsafe(link_section = ".init_array"))]
    #[cfg_attr(target_os = "macos", unsafe(link_section = "__DATA,__mod_init_func"))]
    static LOOK: extern "C" fn() = look;

    pub fn was_closed() -> bool {
        CLOSED.load(Ordering::Relaxed)
    }
}

#[cfg(any(target_os = "linux", target_os = "macos"))]
use at_start::was_closed;

#[cfg(not(any(target_os = "linux", target_os = "macos")))]
fn was_closed() -> bool {
    false
}
