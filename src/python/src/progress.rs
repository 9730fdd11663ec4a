//! Progress reports of long work to a Python function.

use dashpot_estimation::cancel::Cancel;
use pyo3::prelude::*;
use std::sync::{Mutex, PoisonError};

/// Payload of the unwinding with which a progress call ends canceled work. [`crate::work::run`] recognizes it by its type.
pub struct Ended;

/// Progress reports to a Python function, which receives the completed fraction and a text. If the function raises an exception, the first
/// exception is stored and the work stops.
pub struct Progress {
    tell: Option<Py<PyAny>>,
    raised: Mutex<Option<PyErr>>,
    /// Token that stops the work.
    pub cancel: Cancel,
}

impl Progress {
    /// Makes the progress reports for one unit of work. Without a function, they report nothing.
    pub fn new(tell: Option<Py<PyAny>>) -> Progress {
        Progress { tell, raised: Mutex::new(None), cancel: Cancel::default() }
    }

    /// Reports the progress. Any thread that does not hold the interpreter lock may call this function.
    ///
    /// If the work was canceled, this call ends the work by unwinding. Work that checks [`dashpot_estimation::cancel::asked`] ends earlier.
    pub fn say(&self, done: f64, text: &str) {
        if let Some(tell) = self.tell.as_ref().filter(|_| !self.cancel.asked()) {
            if let Err(error) = Python::attach(|py| tell.call1(py, (done, text))) {
                self.stop(error);
            }
        }
        // Reading, measuring and comparing records do not check for cancellation. Unwinding ends them and frees their memory. The package
        // is always built with unwinding (`UNWINDS`), and nothing is written to disk before the last call.
        if self.cancel.asked() && cfg!(panic = "unwind") {
            std::panic::resume_unwind(Box::new(Ended));
        }
    }

    /// Stops the work with an exception. Only the first exception is stored.
    pub fn stop(&self, error: PyErr) {
        self.cancel.ask();
        self.raised.lock().unwrap_or_else(PoisonError::into_inner).get_or_insert(error);
    }

    /// Returns the exception that stopped the work, if any.
    pub fn raised(self) -> Option<PyErr> {
        self.raised.into_inner().unwrap_or_else(PoisonError::into_inner)
    }
}
