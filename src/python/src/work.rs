//! Execution of long work without the interpreter lock, on separate threads.
//!
//! Ctrl-C and exceptions of the progress function end the work.
//!
//! Each unit of work has its own threads instead of Rayon's global threads. The global threads exist until the process ends, but not in a
//! process forked after their start (multiprocessing does that on Linux). Waiting for them in a forked process would never end.

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

/// Interval between checks for Ctrl-C. Users do not notice this delay, and acquiring the interpreter lock so rarely has no measurable cost.
const PAUSE: Duration = Duration::from_millis(50);

/// Number of threads of one unit of work. 0 means the number of processors.
static THREADS: AtomicUsize = AtomicUsize::new(0);

/// Sets the number of threads of each fit, validation, diagnosis and step of many dampers in this process.
///
/// 0, the default, means the number of processors.
#[pyfunction]
pub fn set_threads(count: isize) -> PyResult<()> {
    let count = usize::try_from(count).map_err(|_| {
        PyValueError::new_err(format!("{count} threads are none; give 0 for as many as there are processors"))
    })?;
    THREADS.store(count, Ordering::Relaxed);
    Ok(())
}

/// Runs long work. Returns the result of the work, or the exception that ended it.
pub fn run<T: Send>(py: Python<'_>, tell: Option<Py<PyAny>>, work: impl FnOnce(&Progress) -> T + Send) -> PyResult<T> {
    let progress = Progress::new(tell);
    let done = py.detach(|| {
        scope(|scope| {
            let (alive, ended) = channel::<()>();
            let own = &progress;
            let worker = Builder::new().spawn_scoped(scope, move || {
                // The channel closes when this value is dropped, at the end of the work, even if the work fails.
                let _alive = alive;
                own.cancel.run_on(THREADS.load(Ordering::Relaxed), || work(own))
            });
            let Ok(worker) = worker else { return Ok(None) };
            while ended.recv_timeout(PAUSE) == Err(RecvTimeoutError::Timeout) {
                // Python checks signals only in its main thread. In other threads, this call does nothing.
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

/// Returns the threads that share the steps of many dampers, or `None` if the system provides no threads. After a fork and after
/// [`set_threads`], new threads replace them.
///
/// This function locks the pool only while it also has the interpreter lock. A fork acquires the interpreter lock first, so the lock of the
/// pool is free in a new child process.
pub fn pool(_: Python<'_>) -> Option<Arc<ThreadPool>> {
    static POOL: Mutex<Option<(u32, usize, Arc<ThreadPool>)>> = Mutex::new(None);
    let wanted = (std::process::id(), THREADS.load(Ordering::Relaxed));
    let mut kept = POOL.lock().unwrap_or_else(PoisonError::into_inner);
    match kept.as_ref() {
        Some((process, threads, pool)) if (*process, *threads) == wanted => return Some(pool.clone()),
        // The threads of the parent process do not exist in this process. Dropping their pool would wait for their end forever, so the pool
        // is leaked.
        Some((process, ..)) if *process != wanted.0 => std::mem::forget(kept.take()),
        _ => {}
    }
    let pool = Arc::new(rayon::ThreadPoolBuilder::new().num_threads(wanted.1).build().ok()?);
    *kept = Some((wanted.0, wanted.1, pool.clone()));
    Some(pool)
}
