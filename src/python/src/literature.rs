//! Fit of the models of the literature that serve for comparison only.

use crate::campaign::Campaign;
use crate::errors::{FitError, raise, say};
use crate::work;
use dashpot_identification::Kind;
use dashpot_identification::literature::{Literature, file, observation};
use dashpot_records::hold_out::kept;
use dashpot_records::{SignFinding, Unusable};
use pyo3::prelude::*;
use serde::Serialize;

/// Output of `dashpot fit --model --json`, without the name of the file.
#[derive(Serialize)]
struct LiteratureJson<'a> {
    tests: &'a [String],
    numbers: &'a Literature,
    sign: &'a SignFinding,
    unusable: &'a [Unusable],
}

/// Identifies the model of the literature with this name from records. Returns the text of its file, and its figures as JSON.
#[pyfunction]
#[pyo3(signature = (campaign, name, hold_out=Vec::new(), progress=None))]
pub fn fit_literature(
    py: Python<'_>,
    campaign: &Campaign,
    name: &str,
    hold_out: Vec<String>,
    progress: Option<Py<PyAny>>,
) -> PyResult<(String, String)> {
    let name = match Kind::named(name) {
        Some(Kind::Comparison(name)) => name,
        Some(Kind::Model(_)) => {
            return Err(say::<FitError>(format!(
                "{name} becomes a model file, which every function and host runs: dashpot.fit(campaign, family={name:?})"
            )));
        }
        None => {
            let known = Kind::names(false).join(", ");
            return Err(say::<FitError>(format!("there is no model of the literature {name:?}; there are {known}")));
        }
    };
    let records = kept(&campaign.read, &hold_out).map_err(raise::<FitError>)?;
    let found = work::run(py, progress, |progress| {
        progress.say(0.0, name);
        let found = Literature::fit(name, &observation::of_records(&records));
        progress.say(1.0, name);
        found
    })?;
    let numbers = found.map_err(raise::<FitError>)?;
    let tests: Vec<String> = records.iter().map(|r| r.name.clone()).collect();
    let said = LiteratureJson {
        tests: &tests,
        numbers: &numbers,
        sign: &campaign.read.sign,
        unusable: &campaign.read.unusable,
    };
    Ok((file::write(&numbers, &tests), serde_json::to_string(&said).map_err(raise::<FitError>)?))
}
