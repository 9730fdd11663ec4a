//! A model against records.

use crate::campaign::Campaign;
use crate::errors::{ValidationError, raise};
use crate::model::Model;
use crate::progress::Progress;
use dashpot_simulation::comparison::compare;
use numpy::PyArray1;
use pyo3::exceptions::PyIndexError;
use pyo3::prelude::*;

/// Figures of a validation, and the simulated forces behind them.
#[pyclass(frozen, module = "dashpot._native")]
pub struct Compared {
    json: String,
    forces: Vec<[Vec<f64>; 2]>,
    read: dashpot_records::Campaign,
}

#[pymethods]
impl Compared {
    /// What `dashpot validate --json` writes.
    #[getter]
    fn json(&self) -> &str {
        &self.json
    }

    /// The records as they were compared: without what the model's own fit found them to be off by.
    #[getter]
    fn campaign(&self) -> Campaign {
        Campaign { read: self.read.clone() }
    }

    /// Forces of the model and of the FV curve alone at the samples of one test, N.
    fn forces<'py>(&self, py: Python<'py>, index: usize) -> PyResult<[Bound<'py, PyArray1<f64>>; 2]> {
        let pair = self.forces.get(index).ok_or_else(|| PyIndexError::new_err("no such test"))?;
        Ok([PyArray1::from_slice(py, &pair[0]), PyArray1::from_slice(py, &pair[1])])
    }
}

/// Compares a model with records, beside the plain FV curve.
#[pyfunction]
#[pyo3(signature = (model, campaign, progress=None))]
pub fn validate(py: Python<'_>, model: &Model, campaign: &Campaign, progress: Option<Py<PyAny>>) -> PyResult<Compared> {
    let progress = Progress::new(progress);
    let done = py.detach(|| -> anyhow::Result<Compared> {
        let say = |done: usize, total: usize| progress.say(done as f64 / total.max(1) as f64, "simulating");
        let mut read = campaign.read.clone();
        let note = model.file.identification.right(&mut read.records);
        let said = note.as_ref().map(|note| note.text.clone());
        read.notes.extend(note);
        let compared = compare(&model.file, &read, &say)?;
        let mut validation = dashpot_identification::validation::validate(&compared)?;
        validation.as_the_fit_saw = said;
        validation.unusable.clone_from(&read.unusable);
        let json = serde_json::to_string(&validation)?;
        let forces = compared.into_iter().map(|c| [c.model, c.fv_only]).collect();
        Ok(Compared { json, forces, read })
    });
    progress.end()?;
    done.map_err(raise::<ValidationError>)
}
