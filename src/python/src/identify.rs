//! Identification of a model from records.

use crate::campaign::Campaign;
use crate::dimensions::priors;
use crate::errors::{FitError, raise, say};
use crate::work;
use dashpot_identification::validation::Deviation;
use dashpot_identification::{Estimate, Family, Fit, FitOptions, InventoryItem, Kind, Measured, model_file};
use dashpot_messages::Sentence;
use dashpot_records::hold_out::kept;
use dashpot_records::{SignFinding, Unusable, not_one_damper};
use dashpot_simulation::whole_records;
use pyo3::prelude::*;
use serde::Serialize;
use std::path::PathBuf;

/// Output of `dashpot fit --json`, without the name of the file.
#[derive(Serialize)]
struct FitJson<'a> {
    tests: &'a [String],
    parameters: &'a [Estimate],
    inventory: &'a [InventoryItem],
    measured: &'a [Measured],
    notes: &'a [Sentence],
    misfit: f64,
    over_whole_records: Deviation,
    sign: &'a SignFinding,
    unusable: &'a [Unusable],
}

/// Fit with all data that a workbook of its tables needs. It cannot be stored, so only the process that made it can write the workbook.
#[pyclass(frozen, module = "dashpot._native")]
pub struct Fitted {
    /// Results of the fit.
    pub fit: Fit,
    /// Errors of the model over every sample of the records.
    pub over_whole_records: Deviation,
    /// Findings about the campaign, without its records.
    pub about: dashpot_records::Campaign,
}

/// Fits a model to records. Returns the text of its model file, the figures as JSON, and the data for a workbook.
#[pyfunction]
#[pyo3(signature = (campaign, family, elements=None, hold_out=Vec::new(), progress=None, dimensions=None, lumped=false))]
#[allow(clippy::needless_pass_by_value, clippy::too_many_arguments)]
pub fn fit(
    py: Python<'_>,
    campaign: &Campaign,
    family: &str,
    elements: Option<Vec<String>>,
    hold_out: Vec<String>,
    progress: Option<Py<PyAny>>,
    dimensions: Option<PathBuf>,
    lumped: bool,
) -> PyResult<(String, String, Fitted)> {
    let family = match Kind::named(family) {
        Some(Kind::Model(family)) => family,
        Some(Kind::Comparison(name)) => {
            return Err(say::<FitError>(format!(
                "{name} becomes no model that can be run, but one to compare with: dashpot.fit_literature(campaign, {name:?})"
            )));
        }
        None => {
            let known = Kind::names(true).join(", ");
            return Err(say::<FitError>(format!("there is no family {family:?}; there are {known}")));
        }
    };
    if elements.is_some() && family != Family::Thesis {
        return Err(say::<FitError>("elements chooses the elements of the family thesis; the others have no choice"));
    }
    if dimensions.is_some() && family != Family::Thesis {
        return Err(say::<FitError>("dimensions gives priors to the family thesis; leave one of the two out"));
    }
    let priors = priors(dimensions.as_deref())?;
    let records = kept(&campaign.read, &hold_out).map_err(raise::<FitError>)?;
    if !lumped && let Some(why) = not_one_damper(&records) {
        return Err(say::<FitError>(why.to_string()));
    }
    let options = FitOptions { family, elements, priors };
    let found = work::run(py, progress, |progress| -> anyhow::Result<_> {
        let found =
            dashpot_identification::fit(&records, &options, |stage| progress.say(stage.done, stage.text.english()))?;
        let over_whole_records = whole_records::of_fit(&found, &records)?;
        Ok((found, over_whole_records))
    })?;
    let (found, over_whole_records) = found.map_err(raise::<FitError>)?;
    let said = FitJson {
        tests: &found.tests,
        parameters: &found.estimates,
        inventory: &found.inventory,
        measured: &found.measured,
        notes: &found.notes,
        misfit: found.misfit,
        over_whole_records,
        sign: &campaign.read.sign,
        unusable: &campaign.read.unusable,
    };
    let json = serde_json::to_string(&said).map_err(raise::<FitError>)?;
    let text = model_file::write(&found);
    Ok((text, json, Fitted { fit: found, over_whole_records, about: campaign.about() }))
}
