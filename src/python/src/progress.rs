//! Progress of long work, told to a Python function.

use dashpot_estimation::cancel::Cancel;
use pyo3::prelude::*;
use std::sync::{Mutex, PoisonError};

/// What a progress call throws through work that is to end: nobody reads it.
pub struct Ended;

/// Calls a Python function with the share done and what is being done; keeps the first exception that it raises, and stops the work then.
pub struct Progress {
    tell: Option<Py<PyAny>>,
    raised: Mutex<Option<PyErr>>,
    /// Asks the work to stop.
    pub cancel: Cancel,
}

impl Progress {
    /// Nobody is told where there is no function.
    pub fn new(tell: Option<Py<PyAny>>) -> Progress {
        Progress { tell, raised: Mutex::new(None), cancel: Cancel::default() }
    }

    /// Tells how far the work is. May be called from any thread that does not hold the interpreter's lock. Work that was asked to stop does not
    /// go on from here; what looks at [`dashpot_estimation::cancel::asked`] ends earlier.
    pub fn say(&self, done: f64, text: &str) {
        if let Some(tell) = self.tell.as_ref().filter(|_| !self.cancel.asked()) {
            if let Err(error) = Python::attach(|py| tell.call1(py, (done, text))) {
                self.stop(error);
            }
        }
        // Reading, measuring and comparing know no other way to end early. Unwinding frees what they hold; the package is always built with it
        // (`UNWINDS`), and nothing is written to disk before the last call.
        if self.cancel.asked() && cfg!(panic = "unwind") {
            std::panic::resume_unwind(Box::new(Ended));
        }
    }

    /// Stops the work with an exception; the first counts.
    pub fn stop(&self, error: PyErr) {
        self.cancel.ask();
        self.raised.lock().unwrap_or_else(PoisonError::into_inner).get_or_insert(error);
    }

    /// The exception that stopped the work, if any.
    pub fn raised(self) -> Option<PyErr> {
        self.raised.into_inner().unwrap_or_else(PoisonError::into_inner)
    }
}
