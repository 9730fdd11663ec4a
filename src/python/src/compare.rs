//! A model against records.

use crate::campaign::Campaign;
use crate::errors::{ValidationError, raise};
use crate::limits;
use crate::model::Model;
use crate::work;
use dashpot_identification::limits::judge;
use dashpot_records::Record;
use dashpot_simulation::against::{self as rivals, FITTED_TO_ALL, Rivals};
use dashpot_simulation::comparison::compare;
use numpy::PyArray1;
use pyo3::prelude::*;

/// Forces of the model and of the FV curve alone at the samples of one test, N.
type Forces<'py> = (Bound<'py, PyArray1<f64>>, Bound<'py, PyArray1<f64>>);

/// Compares a model with records, beside the plain FV curve; returns what `dashpot validate --json` writes, the simulated forces of every test,
/// and the records as they were compared: without what the model's own fit found them to be off by. Limits, where some are given, are judged
/// as `dashpot validate --limits` does; models of the literature, where some are named, stand beside it as `dashpot validate --against` puts them.
/// What is to be told of these comes last.
#[pyfunction]
#[pyo3(signature = (model, campaign, progress=None, limits=None, against=Vec::new()))]
pub fn validate<'py>(
    py: Python<'py>,
    model: &Model,
    campaign: &Campaign,
    progress: Option<Py<PyAny>>,
    limits: Option<Vec<limits::Row>>,
    against: Vec<String>,
) -> PyResult<(String, Vec<Forces<'py>>, Campaign, Option<&'static str>)> {
    rivals::named(&against).map_err(raise::<ValidationError>)?;
    let windows = limits.map(limits::of_rows).transpose()?;
    let done = work::run(py, progress, |progress| -> anyhow::Result<_> {
        let say = |done: usize, total: usize| progress.say(done as f64 / total.max(1) as f64, "simulating");
        let mut read = campaign.read.clone();
        let note = model.file.identification.right(&mut read.records);
        let said = note.as_ref().map(|note| note.text.clone());
        read.notes.extend(note);
        let compared = compare(&model.file, &read, &say)?;
        let mut validation = dashpot_identification::validation::validate(&compared)?;
        validation.as_the_fit_saw = said;
        validation.unusable.clone_from(&read.unusable);
        validation.limits = windows.map(|windows| {
            let records: Vec<&Record> = compared.iter().map(|c| c.record).collect();
            let forces: Vec<&[f64]> = compared.iter().map(|c| c.model.as_slice()).collect();
            judge(&windows, &records, Some(&forces))
        });
        let mut told = None;
        if !against.is_empty() {
            let found = Rivals::of(&against, &model.file, &read, &|done, name| progress.say(done, name))?;
            found.put_into(&mut validation, &compared);
            told = found.fitted_to_all.then_some(FITTED_TO_ALL);
        }
        let json = serde_json::to_string(&validation)?;
        let forces: Vec<_> = compared.into_iter().map(|c| (c.model, c.fv_only)).collect();
        Ok((json, forces, read, told))
    })?;
    let (json, forces, read, told) = done.map_err(raise::<ValidationError>)?;
    let arrays = |(model, fv_only)| (PyArray1::from_vec(py, model), PyArray1::from_vec(py, fv_only));
    Ok((json, forces.into_iter().map(arrays).collect(), Campaign { read }, told))
}
