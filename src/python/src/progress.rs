//! Progress of long work, told to a Python function.

use pyo3::prelude::*;
use std::sync::Mutex;

/// Calls a Python function with the share done and what is being done; keeps the first exception that it raises.
pub struct Progress {
    tell: Option<Py<PyAny>>,
    raised: Mutex<Option<PyErr>>,
}

impl Progress {
    /// Nobody is told where there is no function.
    pub fn new(tell: Option<Py<PyAny>>) -> Progress {
        Progress { tell, raised: Mutex::new(None) }
    }

    /// Tells how far the work is. May be called from any thread that does not hold the interpreter's lock.
    pub fn say(&self, done: f64, text: &str) {
        let Some(tell) = &self.tell else { return };
        let mut raised = self.raised.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        if raised.is_none() {
            *raised = Python::attach(|py| tell.call1(py, (done, text)).err());
        }
    }

    /// The exception that the function raised, if any.
    ///
    /// # Errors
    /// That exception.
    pub fn end(self) -> PyResult<()> {
        self.raised.into_inner().unwrap_or_else(std::sync::PoisonError::into_inner).map_or(Ok(()), Err)
    }
}
