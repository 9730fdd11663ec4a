//! Diagnosis of the physical effects that a model lacks.

use crate::campaign::Campaign;
use crate::dimensions::priors;
use crate::errors::{DiagnosisError, raise};
use crate::family::{Family, check_settings};
use crate::model::Model;
use crate::work;
use dashpot_diagnosis::settings::{OverSettings, SettingFigures, SettingsFigures, WithSettings, split_by_setting};
use dashpot_diagnosis::{Curves, Diagnosis, Options, choose_left_out};
use dashpot_identification::model_file;
use dashpot_identification::setting_units::restate_settings;
use dashpot_messages::Sentence;
use dashpot_messages::Template;
use dashpot_records::hold_out::select_hold_out;
use dashpot_records::{Record, Unusable, agree_on_sign, setting_in_words};
use dashpot_simulation::comparison::settings_of;
use dashpot_simulation::whole_records::OfDiagnosis;
use numpy::PyArray1;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use serde::Serialize;
use std::path::PathBuf;

/// Output of `dashpot diagnose --json`.
#[derive(Serialize)]
struct DiagnosisJson<'a> {
    #[serde(flatten)]
    found: &'a Diagnosis,
    over_whole_records: OfDiagnosis,
    #[serde(skip_serializing_if = "Option::is_none")]
    as_the_fit_saw: Option<&'a Sentence>,
    unusable: &'a [Unusable],
}

/// Returns the mean cycle of one test: displacement, m, velocity, m/s, and three forces, N: measured, and of the model before and after the
/// diagnosis.
pub fn arrays<'py>(py: Python<'py>, curves: &Curves) -> PyResult<Bound<'py, PyDict>> {
    let Curves { displacement, velocity, measured, before, after, .. } = curves;
    let arrays = PyDict::new(py);
    for (name, values) in [
        ("displacement", displacement),
        ("velocity", velocity),
        ("measured", measured),
        ("before", before),
        ("after", after),
    ] {
        arrays.set_item(name, PyArray1::from_slice(py, values))?;
    }
    Ok(arrays)
}

/// Diagnosis with all data that its reports need. It cannot be stored, so only the process that made it can write reports.
#[pyclass(frozen, module = "dashpot._native")]
pub struct Diagnosed {
    /// Results of the diagnosis.
    pub found: Diagnosis,
    /// Errors of the given, the refitted and the improved model over every sample of the records.
    pub over_whole_records: OfDiagnosis,
    /// Diagnosed model.
    pub model: Py<Model>,
    /// Records before the corrections of the diagnosis.
    pub campaign: Py<Campaign>,
    /// Records of the reference before the corrections of the diagnosis, or `None` without a reference.
    pub reference: Option<Py<Campaign>>,
    /// Findings about the campaign, without its records.
    pub about: dashpot_records::Campaign,
}

/// Diagnoses a damper over a setting at each setting of the records.
///
/// Returns the output of `dashpot diagnose --json`, and the mean cycles of every test at each setting.
#[pyfunction]
#[pyo3(signature = (family, campaign, given=None, reference=None, hold_out=Vec::new(), max_effects=3, candidates=None, seed=0, progress=None, dimensions=None))]
#[allow(clippy::too_many_arguments)]
pub fn diagnose_family<'py>(
    py: Python<'py>,
    family: Py<Family>,
    campaign: Py<Campaign>,
    given: Option<f64>,
    reference: Option<Py<Campaign>>,
    hold_out: Vec<String>,
    max_effects: usize,
    candidates: Option<Vec<String>>,
    seed: u64,
    progress: Option<Py<PyAny>>,
    dimensions: Option<PathBuf>,
) -> PyResult<(String, Vec<Vec<Bound<'py, PyDict>>>)> {
    check_settings("setting", &given)?;
    let priors = priors(dimensions.as_deref())?;
    let (file, mut read) = (&family.get().file, campaign.get().read.clone());
    let held_out = match hold_out.is_empty() {
        true => None,
        false => Some(select_hold_out(&read, &hold_out, "look at").map_err(raise::<DiagnosisError>)?),
    };
    let mut good = reference.map(|reference| reference.get().read.clone());
    if let Some(good) = &mut good {
        agree_on_sign(&mut [&mut read, good]);
    }
    let others = good.iter_mut().flat_map(|good| &mut good.records);
    restate_settings(&file.axis, read.records.iter_mut().chain(others)).map_err(raise::<DiagnosisError>)?;
    let others = good.iter_mut().flat_map(|good| &mut good.records);
    let note = file.identification.right(read.records.iter_mut().chain(others));
    if let Some(good) = &mut good {
        read.also_without(std::mem::take(&mut good.unusable));
    }
    let done = work::run(py, progress, |progress| -> anyhow::Result<_> {
        let settings = settings_of(file, &read, given)?;
        let of_good = good.as_ref().map(|good| settings_of(file, good, given)).transpose()?;
        let own = WithSettings { records: &read.records, settings: &settings };
        let compared = good.as_ref().zip(of_good.as_deref());
        let compared = compared.map(|(good, settings)| WithSettings { records: &good.records, settings });
        let unit = file.axis.unit();
        let parts = split_by_setting(&file.definition(), own, compared)
            .map_err(|setting| anyhow::anyhow!("reference has no test at {}", setting_in_words(setting, unit)))?;
        if parts.is_empty() {
            anyhow::bail!("no test has a constant setting, and a damper is diagnosed at constant settings");
        }
        let count = parts.len() as f64;
        let mut found: Vec<(f64, Diagnosis, OfDiagnosis)> = Vec::new();
        for (place, part) in parts.into_iter().enumerate() {
            let records: Vec<&Record> = part.records.iter().collect();
            let left_out = match &held_out {
                Some(out) => part.places.iter().map(|k| out[*k]).collect(),
                None => choose_left_out(&records, seed),
            };
            let options = Options {
                max_effects,
                candidates: candidates.clone(),
                reference: part.reference,
                priors: priors.clone(),
            };
            let say = |done: f64, text: Template| progress.say((place as f64 + done) / count, text.english());
            let one = dashpot_diagnosis::diagnose(&records, &left_out, &part.params, &options, &say)?;
            let whole = OfDiagnosis::evaluate(&part.params, &one.base, &one.improved, &one.measured, &records)?;
            found.push((part.setting, one, whole));
        }
        let answers: Vec<(f64, &Diagnosis)> = found.iter().map(|(setting, one, _)| (*setting, one)).collect();
        let over = OverSettings::new(&answers, unit, good.is_some());
        let as_the_fit_saw = note.as_ref().map(|n| &n.text);
        let figures = found.iter().map(|(setting, one, over_whole_records)| {
            let over_whole_records = *over_whole_records;
            let diagnosis = DiagnosisJson { found: one, over_whole_records, as_the_fit_saw, unusable: &[] };
            SettingFigures::new(&file.axis, *setting, diagnosis)
        });
        let beside = (as_the_fit_saw, read.unusable.as_slice());
        let json = serde_json::to_string(&SettingsFigures::new(&file.axis, &over, figures.collect(), beside))?;
        let curves: Vec<Vec<Curves>> =
            found.into_iter().map(|(_, one, _)| one.tests.into_iter().map(|test| test.curves).collect()).collect();
        Ok((json, curves))
    })?;
    let (json, curves) = done.map_err(raise::<DiagnosisError>)?;
    let of_setting = |all: &Vec<Curves>| all.iter().map(|curves| arrays(py, curves)).collect::<PyResult<Vec<_>>>();
    Ok((json, curves.iter().map(of_setting).collect::<PyResult<_>>()?))
}

/// Diagnoses a model against records, and against a reference if one is given.
///
/// Returns the output of `dashpot diagnose --json`, and the text of the model file with the named effects added. Also returns the mean
/// cycle of every test, and the data for reports.
#[pyfunction]
#[pyo3(signature = (model, campaign, reference=None, hold_out=Vec::new(), max_effects=3, candidates=None, seed=0, progress=None, dimensions=None))]
#[allow(clippy::too_many_arguments)]
pub fn diagnose<'py>(
    py: Python<'py>,
    model: Py<Model>,
    campaign: Py<Campaign>,
    reference: Option<Py<Campaign>>,
    hold_out: Vec<String>,
    max_effects: usize,
    candidates: Option<Vec<String>>,
    seed: u64,
    progress: Option<Py<PyAny>>,
    dimensions: Option<PathBuf>,
) -> PyResult<(String, String, Vec<Bound<'py, PyDict>>, Diagnosed)> {
    let (file, of_damper) = (&model.get().file, campaign.get());
    let mut about = of_damper.about();
    let mut read = of_damper.read.clone();
    let mut good = Vec::new();
    if let Some(reference) = &reference {
        let mut reference = reference.get().read.clone();
        about.also_without(reference.unusable.clone());
        let known = read.notes.len();
        agree_on_sign(&mut [&mut read, &mut reference]);
        about.notes.extend(read.notes.iter().skip(known).cloned());
        good = reference.records;
    }
    let mut own = read.records;
    let note = file.identification.right(own.iter_mut().chain(&mut good));
    about.notes.extend(note.clone());
    let records: Vec<&Record> = own.iter().collect();
    let left_out = if hold_out.is_empty() {
        choose_left_out(&records, seed)
    } else {
        select_hold_out(&of_damper.read, &hold_out, "look at").map_err(raise::<DiagnosisError>)?
    };
    let priors = priors(dimensions.as_deref())?;
    let options = Options { max_effects, candidates, reference: good, priors };
    let done = work::run(py, progress, |progress| -> anyhow::Result<_> {
        let say = |done: f64, text: Template| progress.say(done, text.english());
        let found = dashpot_diagnosis::diagnose(&records, &left_out, &file.params, &options, &say)?;
        let improved = model_file::write(&found.as_fit(&records, &left_out, file));
        let over_whole_records =
            OfDiagnosis::evaluate(&file.params, &found.base, &found.improved, &found.measured, &records)?;
        let as_the_fit_saw = note.as_ref().map(|n| &n.text);
        let json = serde_json::to_string(&DiagnosisJson {
            found: &found,
            over_whole_records,
            as_the_fit_saw,
            unusable: &about.unusable,
        })?;
        Ok((json, improved, found, over_whole_records))
    })?;
    let (json, improved, found, over_whole_records) = done.map_err(raise::<DiagnosisError>)?;
    let curves = found.tests.iter().map(|test| arrays(py, &test.curves)).collect::<PyResult<_>>()?;
    Ok((json, improved, curves, Diagnosed { found, over_whole_records, model, campaign, reference, about }))
}
