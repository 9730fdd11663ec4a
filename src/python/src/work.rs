//! Long work without the interpreter's lock, on threads of its own.
//!
//! Ctrl-C ends it, and so does an exception of the progress function.
//!
//! The threads belong to one piece of work. Rayon's own, which last as long as the process, would be missing in a process that was forked off
//! after their start (multiprocessing does that on Linux), and whoever waits for them there waits for ever.

use crate::progress::{Ended, Progress};
use pyo3::exceptions::{PyRuntimeError, PyValueError};
use pyo3::prelude::*;
use rayon::ThreadPool;
use std::panic::resume_unwind;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::{Builder, scope};
use std::time::Duration;

/// Between two looks whether Ctrl-C was pressed: a hand does not notice, and taking the interpreter's lock so seldom costs nothing.
const PAUSE: Duration = Duration::from_millis(50);

/// Threads of one piece of work; 0 is as many as there are processors.
static THREADS: AtomicUsize = AtomicUsize::new(0);

/// Threads that each fit, validation, diagnosis and step of many dampers may use from now on, in this process.
///
/// 0, as at the start, is as many as there are processors.
#[pyfunction]
pub fn set_threads(count: isize) -> PyResult<()> {
    let count = usize::try_from(count).map_err(|_| {
        PyValueError::new_err(format!("{count} threads are none; give 0 for as many as there are processors"))
    })?;
    THREADS.store(count, Ordering::Relaxed);
    Ok(())
}

/// Does the work; its result, or the exception that ended it.
pub fn run<T: Send>(py: Python<'_>, tell: Option<Py<PyAny>>, work: impl FnOnce(&Progress) -> T + Send) -> PyResult<T> {
    let progress = Progress::new(tell);
    let done = py.detach(|| {
        scope(|scope| {
            let (alive, ended) = channel::<()>();
            let own = &progress;
            let worker = Builder::new().spawn_scoped(scope, move || {
                // Dropped at the end, however the work ends.
                let _alive = alive;
                own.cancel.run_on(THREADS.load(Ordering::Relaxed), || work(own))
            });
            let Ok(worker) = worker else { return Ok(None) };
            while ended.recv_timeout(PAUSE) == Err(RecvTimeoutError::Timeout) {
                // Python looks at signals in its first thread alone; in others this does nothing.
                if let Err(interrupt) = Python::attach(|py| py.check_signals()) {
                    progress.stop(interrupt);
                }
            }
            worker.join()
        })
    });
    let done = match done {
        Ok(done) => done,
        Err(payload) if payload.is::<Ended>() => None,
        Err(payload) => resume_unwind(payload),
    };
    if let Some(error) = progress.raised() {
        return Err(error);
    }
    done.ok_or_else(|| PyRuntimeError::new_err("the system gives no threads to work on"))
}

/// Threads that steps of many dampers share: made once, and anew after a fork and after [`set_threads`]. None where the system gives none.
///
/// The lock is held with the interpreter's own, which a fork takes first: no child is born with it held.
pub fn pool(_: Python<'_>) -> Option<Arc<ThreadPool>> {
    static POOL: Mutex<Option<(u32, usize, Arc<ThreadPool>)>> = Mutex::new(None);
    let wanted = (std::process::id(), THREADS.load(Ordering::Relaxed));
    let mut kept = POOL.lock().unwrap_or_else(PoisonError::into_inner);
    match kept.as_ref() {
        Some((process, threads, pool)) if (*process, *threads) == wanted => return Some(pool.clone()),
        // The threads of the parent are none of this process: to wait for their end would be for ever.
        Some((process, ..)) if *process != wanted.0 => std::mem::forget(kept.take()),
        _ => {}
    }
    let pool = Arc::new(rayon::ThreadPoolBuilder::new().num_threads(wanted.1).build().ok()?);
    *kept = Some((wanted.0, wanted.1, pool.clone()));
    Some(pool)
}
