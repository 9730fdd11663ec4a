//! Priors from the dimensions of a damper.

use crate::errors::{DimensionsError, raise};
use dashpot_estimation::prior_set::PriorSet;
use pyo3::prelude::*;
use std::path::Path;

/// The priors that a file of dimensions gives; none without one.
pub fn priors(path: Option<&Path>) -> PyResult<PriorSet> {
    let Some(path) = path else { return Ok(PriorSet::default()) };
    Ok(dashpot_dimensions::forward::priors(&dashpot_dimensions::read(path).map_err(raise::<DimensionsError>)?))
}
