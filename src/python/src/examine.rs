//! Which physical effect a model lacks.

use crate::campaign::Campaign;
use crate::errors::{DiagnosisError, raise};
use crate::model::Model;
use crate::progress::Progress;
use dashpot_diagnosis::{Curves, Diagnosis, Options, choose_held_out};
use dashpot_identification::model_file;
use dashpot_records::hold_out::held_out;
use dashpot_records::{Record, Unusable};
use dashpot_simulation::whole_records::OfDiagnosis;
use numpy::PyArray1;
use pyo3::exceptions::PyIndexError;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use serde::Serialize;

/// A diagnosis.
#[pyclass(frozen, module = "dashpot._native")]
pub struct Diagnosed {
    found: Diagnosis,
    over_whole_records: OfDiagnosis,
    as_the_fit_saw: Option<String>,
    unusable: Vec<Unusable>,
    improved: String,
}

/// What `dashpot diagnose --json` writes.
#[derive(Serialize)]
struct DiagnosisJson<'a> {
    #[serde(flatten)]
    found: &'a Diagnosis,
    over_whole_records: OfDiagnosis,
    #[serde(skip_serializing_if = "Option::is_none")]
    as_the_fit_saw: Option<&'a str>,
    unusable: &'a [Unusable],
}

#[pymethods]
impl Diagnosed {
    /// What `dashpot diagnose --json` writes.
    fn json(&self) -> PyResult<String> {
        let said = DiagnosisJson {
            found: &self.found,
            over_whole_records: self.over_whole_records,
            as_the_fit_saw: self.as_the_fit_saw.as_deref(),
            unusable: &self.unusable,
        };
        serde_json::to_string(&said).map_err(raise::<DiagnosisError>)
    }

    /// The text of the model file with the named effects added.
    #[getter]
    fn improved(&self) -> &str {
        &self.improved
    }

    /// Mean cycle of one test: motion, measured force, force before and after.
    fn curves<'py>(&self, py: Python<'py>, index: usize) -> PyResult<Bound<'py, PyDict>> {
        let test = self.found.tests.get(index).ok_or_else(|| PyIndexError::new_err("no such test"))?;
        let Curves { displacement, velocity, measured, before, after, .. } = &test.curves;
        let curves = PyDict::new(py);
        for (name, values) in [
            ("displacement", displacement),
            ("velocity", velocity),
            ("measured", measured),
            ("before", before),
            ("after", after),
        ] {
            curves.set_item(name, PyArray1::from_slice(py, values))?;
        }
        Ok(curves)
    }
}

/// Diagnoses a model against records, against a reference where one is given.
#[pyfunction]
#[pyo3(signature = (model, campaign, reference=None, hold_out=Vec::new(), max_effects=3, candidates=None, seed=0, progress=None))]
#[allow(clippy::too_many_arguments)]
pub fn diagnose(
    py: Python<'_>,
    model: &Model,
    campaign: &Campaign,
    reference: Option<&Campaign>,
    hold_out: Vec<String>,
    max_effects: usize,
    candidates: Option<Vec<String>>,
    seed: u64,
    progress: Option<Py<PyAny>>,
) -> PyResult<Diagnosed> {
    let unusable: Vec<Unusable> =
        std::iter::once(campaign).chain(reference).flat_map(|c| c.read.unusable.iter().cloned()).collect();
    let (mut own, mut reference) =
        (campaign.read.records.clone(), reference.map_or_else(Vec::new, |r| r.read.records.clone()));
    let note = model.file.identification.right(own.iter_mut().chain(&mut reference));
    let records: Vec<&Record> = own.iter().collect();
    let left_out = if hold_out.is_empty() {
        choose_held_out(&records, seed)
    } else {
        held_out(&campaign.read, &hold_out, "look at").map_err(raise::<DiagnosisError>)?
    };
    let options = Options { max_effects, candidates, reference };
    let progress = Progress::new(progress);
    let found = py.detach(|| -> anyhow::Result<Diagnosed> {
        let say = |done: f64, text: &str| progress.say(done, text);
        let found = dashpot_diagnosis::diagnose(&records, &left_out, &model.file.params, &options, &say)?;
        let improved = model_file::write(&found.as_fit(&records, &left_out, &model.file));
        let over_whole_records = OfDiagnosis::of(&model.file.params, &found.base, &found.improved, &records)?;
        Ok(Diagnosed { found, over_whole_records, as_the_fit_saw: note.map(|n| n.text), unusable, improved })
    });
    progress.end()?;
    found.map_err(raise::<DiagnosisError>)
}
