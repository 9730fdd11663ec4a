//! Long work that may be told to stop.
//!
//! The work runs on threads of its own, each of which knows the flag; the searches look at it before every step and end where
//! they are. What they return then is of no use, so [`Cancel::run`] throws it away: nobody sees half a result, and no function
//! between the searches and the caller has to hand the flag on.

use std::cell::RefCell;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

thread_local! {
    static FLAG: RefCell<Option<Arc<AtomicBool>>> = const { RefCell::new(None) };
}

/// Asks a piece of work to stop; copies ask the same one.
#[derive(Debug, Clone, Default)]
pub struct Cancel(Arc<AtomicBool>);

impl Cancel {
    /// Asks the work to stop.
    pub fn ask(&self) {
        self.0.store(true, Ordering::Relaxed);
    }

    /// Whether it was asked to stop.
    pub fn asked(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }

    /// Runs the work on threads of its own, as many as there are processors.
    ///
    /// `None` where it was cancelled, or the system provides no threads.
    pub fn run<T: Send>(&self, work: impl FnOnce() -> T + Send) -> Option<T> {
        self.run_on(0, work)
    }

    /// Runs the work on `threads` threads of its own; 0 is as many as there are processors.
    ///
    /// `None` where it was cancelled, or the system provides no threads.
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

/// Whether the work that this thread does was asked to stop.
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
