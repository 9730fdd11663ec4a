//! Priors of a fit or a diagnosis from the dimensions of a damper.

use crate::errors::{DimensionsError, raise};
use dashpot_estimation::prior_set::PriorSet;
use pyo3::prelude::*;
use std::path::Path;

/// Returns the priors from a file of dimensions, or no priors without a file.
pub fn priors(path: Option<&Path>) -> PyResult<PriorSet> {
    let Some(path) = path else { return Ok(PriorSet::default()) };
    Ok(dashpot_dimensions::forward::priors(&dashpot_dimensions::read(path).map_err(raise::<DimensionsError>)?))
}
