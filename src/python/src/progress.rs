//! Progress reports of long work to a Python function.

use dashpot_estimation::cancel::Cancel;
use pyo3::prelude::*;
use std::sync::{Mutex, PoisonError};

/// Payload with which a progress call unwinds canceled work. Nobody reads it.
pub struct Ended;

/// Calls a Python function with the fraction done and the current step. It keeps the first exception of the function, and then stops the
/// work.
pub struct Progress {
    tell: Option<Py<PyAny>>,
    raised: Mutex<Option<PyErr>>,
    /// Token that stops the work.
    pub cancel: Cancel,
}

impl Progress {
    /// Makes a progress report; without a function it reports nothing.
    pub fn new(tell: Option<Py<PyAny>>) -> Progress {
        Progress { tell, raised: Mutex::new(None), cancel: Cancel::default() }
    }

    /// Reports the progress. Any thread that does not hold the interpreter lock may call it.
    ///
    /// Canceled work ends here. Work that checks [`dashpot_estimation::cancel::asked`] ends earlier.
    pub fn say(&self, done: f64, text: &str) {
        if let Some(tell) = self.tell.as_ref().filter(|_| !self.cancel.asked()) {
            if let Err(error) = Python::attach(|py| tell.call1(py, (done, text))) {
                self.stop(error);
            }
        }
        // Reading, measuring and comparing have no other way to end early. Unwinding frees their memory. The package is always built with
        // unwinding (`UNWINDS`), and nothing is written to disk before the last call.
        if self.cancel.asked() && cfg!(panic = "unwind") {
            std::panic::resume_unwind(Box::new(Ended));
        }
    }

    /// Stops the work with an exception; the first one is kept.
    pub fn stop(&self, error: PyErr) {
        self.cancel.ask();
        self.raised.lock().unwrap_or_else(PoisonError::into_inner).get_or_insert(error);
    }

    /// Returns the exception that stopped the work, if any.
    pub fn raised(self) -> Option<PyErr> {
        self.raised.into_inner().unwrap_or_else(PoisonError::into_inner)
    }
}
