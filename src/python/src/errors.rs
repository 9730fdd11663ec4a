//! Exceptions of the Python package. Their texts are the messages of the command.

use pyo3::create_exception;
use pyo3::exceptions::PyException;
use pyo3::prelude::*;

create_exception!(dashpot, DashpotError, PyException, "What dashpot refuses; the text says what to do.");
create_exception!(dashpot, RecordError, DashpotError, "Records that cannot be read or trusted.");
create_exception!(dashpot, ModelError, DashpotError, "A model file or a set of parameters that makes no model.");
create_exception!(
    dashpot,
    DimensionsError,
    DashpotError,
    "Dimensions of a damper that cannot be read, or that no damper has together."
);
create_exception!(dashpot, FitError, DashpotError, "Records that no model can be fitted to.");
create_exception!(dashpot, ValidationError, DashpotError, "A model and records that cannot be compared.");
create_exception!(dashpot, DiagnosisError, DashpotError, "A model and records that cannot be diagnosed.");
create_exception!(dashpot, MotionError, DashpotError, "A motion that cannot be imposed on a model.");
create_exception!(dashpot, StepError, DashpotError, "A step that a damper refuses; its state is as it was.");
create_exception!(dashpot, ExportError, DashpotError, "A model that cannot be exported this way.");
create_exception!(dashpot, RigError, DashpotError, "What the virtual rig cannot measure.");
create_exception!(dashpot, OutputError, DashpotError, "A file that cannot be written, or would take another's place.");

/// Converts an error of the crates to an exception. The text is the error with its causes in one sentence, equal to the command's message.
pub fn raise<E: pyo3::PyTypeInfo>(error: impl Into<anyhow::Error>) -> PyErr {
    PyErr::new::<E, _>(as_arguments(dashpot_output::format_once(&error.into())))
}

/// Replaces options of the command in a sentence by the corresponding arguments of the package.
fn as_arguments(said: String) -> String {
    if !said.contains("--") {
        return said;
    }
    let translated = Python::attach(|py| -> PyResult<String> {
        py.import("dashpot._arguments")?.getattr("as_arguments")?.call1((&said,))?.extract()
    });
    translated.unwrap_or(said)
}

/// Makes an exception with a sentence as its text.
pub fn say<E: pyo3::PyTypeInfo>(sentence: impl Into<String>) -> PyErr {
    PyErr::new::<E, _>(sentence.into())
}
