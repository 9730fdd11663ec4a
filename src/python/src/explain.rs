//! What a model says of gas, oil and valves of its damper.

use crate::errors::{DimensionsError, raise};
use crate::model::Model;
use pyo3::prelude::*;
use std::path::PathBuf;

/// Explains a model by a file of dimensions.
///
/// Returns what `dashpot explain --json` writes, but for the names of the two files, and the lines that it prints.
#[pyfunction]
#[allow(clippy::needless_pass_by_value)]
pub fn explain(model: &Model, dimensions: PathBuf) -> PyResult<(String, Vec<String>)> {
    let dimensions = dashpot_dimensions::read(&dimensions).map_err(raise::<DimensionsError>)?;
    let found = dashpot_dimensions::explain(&model.file, &dimensions);
    Ok((serde_json::to_string(&found).map_err(raise::<DimensionsError>)?, found.lines()))
}
