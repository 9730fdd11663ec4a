//! Properties of gas, oil and valves of a damper that follow from its model.

use crate::errors::{DimensionsError, raise};
use crate::family::Family;
use crate::model::Model;
use dashpot_identification::family::at_setting;
use dashpot_identification::model_file::ModelFile;
use pyo3::prelude::*;
use std::path::{Path, PathBuf};

/// Explains a damper family at a setting with a file of dimensions. Returns the results of [`explain`].
#[pyfunction]
#[allow(clippy::needless_pass_by_value)]
pub fn explain_family(family: &Family, dimensions: PathBuf, setting: f64) -> PyResult<(String, Vec<String>)> {
    explain_file(&at_setting(&family.file, setting), &dimensions)
}

/// Explains a model with a file of dimensions.
///
/// Returns the output of `dashpot explain --json` without the names of the two files, and the lines that the command prints.
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
