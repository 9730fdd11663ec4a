//! Cancellation of long work.
//!
//! The work runs on separate threads, and each thread stores the flag that requests the cancellation. Functions between
//! the caller and the searches therefore require no argument for the flag. The searches check the flag before every
//! step and end early. Their incomplete result is useless, so [`Cancel::run`] discards it.

use std::cell::RefCell;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

thread_local! {
    static FLAG: RefCell<Option<Arc<AtomicBool>>> = const { RefCell::new(None) };
}

/// Handle for the cancellation of work. All copies refer to the same work.
#[derive(Debug, Clone, Default)]
pub struct Cancel(Arc<AtomicBool>);

impl Cancel {
    /// Requests that the work stops.
    pub fn ask(&self) {
        self.0.store(true, Ordering::Relaxed);
    }

    /// Returns whether a stop of the work was requested.
    pub fn asked(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }

    /// Runs the work on separate threads, one for each processor.
    ///
    /// Returns `None` if the work was canceled, or if the system provides no threads.
    pub fn run<T: Send>(&self, work: impl FnOnce() -> T + Send) -> Option<T> {
        self.run_on(0, work)
    }

    /// Runs the work on `threads` separate threads. With 0, the number is one for each processor.
    ///
    /// Returns `None` if the work was canceled, or if the system provides no threads.
    pub fn run_on<T: Send>(&self, threads: usize, work: impl FnOnce() -> T + Send) -> Option<T> {
        let flag = self.0.clone();
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .thread_name(|k| format!("dashpot-{k}"))
            .start_handler(move |_| FLAG.with(|own| *own.borrow_mut() = Some(flag.clone())))
            .build()
            .ok()?;
        let done = pool.install(work);
        (!self.asked()).then_some(done)
    }
}

/// Returns whether a stop of the work on the current thread was requested.
pub fn asked() -> bool {
    FLAG.with(|own| own.borrow().as_ref().is_some_and(|flag| flag.load(Ordering::Relaxed)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use rayon::prelude::*;

    #[test]
    fn every_thread_of_the_work_knows_and_the_result_is_thrown_away() {
        let cancel = Cancel::default();
        assert_eq!(cancel.run(|| (0..64).into_par_iter().filter(|_| asked()).count()), Some(0));
        let from_outside = cancel.clone();
        let seen = std::sync::Mutex::new(0);
        let result = cancel.run(|| {
            from_outside.ask();
            *seen.lock().unwrap() = (0..64).into_par_iter().filter(|_| asked()).count();
        });
        assert_eq!((result, *seen.lock().unwrap()), (None, 64));
        assert!(!asked(), "other threads are not concerned");
    }
}
