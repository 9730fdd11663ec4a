//! Validation of a model: comparison with records, limits and models of the literature.

use crate::campaign::Campaign;
use crate::errors::{ValidationError, raise};
use crate::limits;
use crate::model::Model;
use crate::work;
use dashpot_identification::AS_THE_FIT_SAW;
use dashpot_identification::limits::{Limit, check_without_setting, judge};
use dashpot_identification::model_file::ModelFile;
use dashpot_identification::validation::{Compared, Validation};
use dashpot_records::Record;
use dashpot_simulation::against::{self as rivals, FITTED_TO_ALL, Rivals};
use dashpot_simulation::comparison::compare;
use numpy::PyArray1;
use pyo3::prelude::*;

/// Forces of the model and of the FV curve alone at the samples of one test, N.
type Forces<'py> = (Bound<'py, PyArray1<f64>>, Bound<'py, PyArray1<f64>>);
/// Name of a model of the literature, and its forces at the samples of every test, N.
type OfRival<'py> = (&'static str, Vec<Bound<'py, PyArray1<f64>>>);

/// Result of a comparison.
///
/// It contains the figures as JSON, the simulated forces of every test, and the compared records. It also contains the note on the models
/// of the literature, and the forces of these models.
type Validated<'py> = (String, Vec<Forces<'py>>, Campaign, Option<&'static str>, Vec<OfRival<'py>>);

/// Combines the tests of a campaign with forces that were computed before: of the model, and of the FV curve alone.
pub fn compared<'a>(
    file: &ModelFile,
    read: &'a dashpot_records::Campaign,
    forces: Vec<(Vec<f64>, Vec<f64>)>,
) -> Vec<Compared<'a>> {
    let of_one = |(record, (model, fv_only)): (&'a Record, _)| {
        let used_in_fit = file.identification.used(record);
        Compared { record, model, fv_only, used_in_fit }
    };
    read.records.iter().zip(forces).map(of_one).collect()
}

/// Computes the figures of a comparison.
///
/// The campaign supplies the note on the correction of its records, and the unusable tests. The limits `windows` are checked if they are
/// given. `rivals` contains names and forces of the models of the literature, whose errors are added.
pub fn figures(
    read: &dashpot_records::Campaign,
    compared: &[Compared<'_>],
    windows: Option<&[Limit]>,
    rivals: &[(String, Vec<Vec<f64>>)],
) -> anyhow::Result<Validation> {
    let mut validation = dashpot_identification::validation::validate(compared)?;
    validation.as_the_fit_saw = read.notes.iter().find(|n| n.kind == AS_THE_FIT_SAW).map(|n| n.text.clone());
    validation.unusable.clone_from(&read.unusable);
    validation.limits = windows.map(|windows| {
        let records: Vec<&Record> = compared.iter().map(|c| c.record).collect();
        let forces: Vec<&[f64]> = compared.iter().map(|c| c.model.as_slice()).collect();
        judge(windows, &records, Some(&forces))
    });
    if !rivals.is_empty() {
        validation.against.push(validation.as_against());
        validation.against.extend(rivals.iter().map(|(name, forces)| rivals::of_forces(name, compared, forces)));
    }
    Ok(validation)
}

/// Compares a model with records, and with the plain FV curve.
///
/// Returns the output of `dashpot validate --json`, the simulated forces of every test, and the compared records. These records are
/// corrected for the measurement errors that the fit of the model found. If limits are given, they are checked like with
/// `dashpot validate --limits`. Models of the literature in `against` are compared like with `dashpot validate --against`. The result then
/// includes the note on these models, and the forces of each of them.
#[pyfunction]
#[pyo3(signature = (model, campaign, progress=None, limits=None, against=Vec::new()))]
pub fn validate<'py>(
    py: Python<'py>,
    model: &Model,
    campaign: &Campaign,
    progress: Option<Py<PyAny>>,
    limits: Option<Vec<limits::Row>>,
    against: Vec<String>,
) -> PyResult<Validated<'py>> {
    rivals::named(&against).map_err(raise::<ValidationError>)?;
    let windows = limits.map(limits::of_rows).transpose()?;
    check_without_setting(windows.as_deref().unwrap_or_default()).map_err(raise::<ValidationError>)?;
    let done = work::run(py, progress, |progress| -> anyhow::Result<_> {
        let say = |done: usize, total: usize| progress.say(done as f64 / total.max(1) as f64, "simulating");
        let mut read = campaign.read.clone();
        let note = model.file.identification.right(&mut read.records);
        read.notes.extend(note);
        let compared = compare(&model.file, &read, &say)?;
        let mut validation = figures(&read, &compared, windows.as_deref(), &[])?;
        let mut found = Rivals::default();
        if !against.is_empty() {
            found = Rivals::compare(&against, &model.file, &read, &|done, name| progress.say(done, name))?;
            found.put_into(&mut validation, &compared);
        }
        let json = serde_json::to_string(&validation)?;
        let forces: Vec<_> = compared.into_iter().map(|c| (c.model, c.fv_only)).collect();
        Ok((json, forces, read, found))
    })?;
    let (json, forces, read, found) = done.map_err(raise::<ValidationError>)?;
    let array = |values| PyArray1::from_vec(py, values);
    let forces = forces.into_iter().map(|(model, fv_only)| (array(model), array(fv_only))).collect();
    let told = found.fitted_to_all.then_some(FITTED_TO_ALL);
    let of_one = |rival: rivals::Rival| (rival.literature.name(), rival.forces.into_iter().map(array).collect());
    Ok((json, forces, Campaign { read }, told, found.all.into_iter().map(of_one).collect()))
}
