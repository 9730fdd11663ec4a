//! What a model says of gas, oil and valves of its damper.

use crate::errors::{DimensionsError, raise};
use crate::family::Family;
use crate::model::Model;
use dashpot_identification::family::at_setting;
use dashpot_identification::model_file::ModelFile;
use pyo3::prelude::*;
use std::path::{Path, PathBuf};

/// Explains a family at a setting by a file of dimensions, as [`explain`] does a model.
#[pyfunction]
#[allow(clippy::needless_pass_by_value)]
pub fn explain_family(family: &Family, dimensions: PathBuf, setting: f64) -> PyResult<(String, Vec<String>)> {
    explain_file(&at_setting(&family.file, setting), &dimensions)
}

/// Explains a model by a file of dimensions.
///
/// Returns what `dashpot explain --json` writes, but for the names of the two files, and the lines that it prints.
#[pyfunction]
#[allow(clippy::needless_pass_by_value)]
pub fn explain(model: &Model, dimensions: PathBuf) -> PyResult<(String, Vec<String>)> {
    explain_file(&model.file, &dimensions)
}

fn explain_file(file: &ModelFile, dimensions: &Path) -> PyResult<(String, Vec<String>)> {
    let dimensions = dashpot_dimensions::read(dimensions).map_err(raise::<DimensionsError>)?;
    let found = dashpot_dimensions::explain(file, &dimensions);
    Ok((serde_json::to_string(&found).map_err(raise::<DimensionsError>)?, found.lines()))
}
