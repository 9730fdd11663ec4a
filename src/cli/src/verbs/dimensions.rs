//! Dimensions that the command line names.

use dashpot_estimation::prior_set::PriorSet;
use std::path::Path;

/// The priors that a file of dimensions gives; none without one.
pub fn priors(path: Option<&Path>) -> anyhow::Result<PriorSet> {
    let Some(path) = path else { return Ok(PriorSet::default()) };
    let priors = dashpot_dimensions::forward::priors(&dashpot_dimensions::read(path)?);
    if priors.rows().is_empty() {
        let path = path.display();
        dashpot_output::warn(&format!(
            "note: no prior follows from {path}: give rod_mm with gas_pressure_bar, or bore_mm, rod_mm and rebound_chamber_mm"
        ));
    }
    Ok(priors)
}
