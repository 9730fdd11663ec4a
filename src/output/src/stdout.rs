//! Standard output that is closed: found out before the runtime puts the null device in its place.

/// The error where standard output was closed by whoever started the program.
pub fn closed() -> Option<&'static str> {
    was_closed().then_some("standard output is closed; send it to a file, or to /dev/null if nobody reads it")
}

#[cfg(any(target_os = "linux", target_os = "macos"))]
mod at_start {
    use std::sync::atomic::{AtomicBool, Ordering};

    static CLOSED: AtomicBool = AtomicBool::new(false);

    extern "C" fn look() {
        // SAFETY: a borrowed descriptor is only asked for its flags, which is allowed for one that is closed.
        let out = unsafe { rustix::fd::BorrowedFd::borrow_raw(1) };
        CLOSED.store(rustix::io::fcntl_getfd(out).is_err(), Ordering::Relaxed);
    }

    // The runtime of the language opens the null device on closed standard descriptors before `main`, after which a closed
    // output cannot be told from one that the user sent there. Functions in this section run earlier still.
    // SAFETY: the section holds pointers to functions without arguments that the loader calls once; `look` uses nothing
    // that the runtime has yet to set up.
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
