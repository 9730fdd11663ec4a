//! Dimensions of the damper from the option `--dimensions`.

use dashpot_estimation::prior_set::PriorSet;
use std::path::Path;

/// Returns the priors that follow from a file of dimensions, or no priors without a file. Prints a note if no prior
/// follows.
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
