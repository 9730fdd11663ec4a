//! The virtual rig: records to try things on.

use crate::errors::{OutputError, RigError, raise};
use crate::work;
use dashpot_output::FolderLock;
use dashpot_rig::{Campaign, HiddenCase, Matrix, MatrixOptions, Options, Plan};
use pyo3::prelude::*;
use std::path::PathBuf;

/// Measures a test matrix on the virtual rig; returns the number of tests. `hide` names effects with their strengths.
#[pyfunction]
#[pyo3(signature = (folder, amplitudes, peak_velocities, seed, noise_percent, hide, progress=None))]
#[allow(clippy::too_many_arguments)]
pub fn measure(
    py: Python<'_>,
    folder: PathBuf,
    amplitudes: Option<Vec<f64>>,
    peak_velocities: Option<Vec<f64>>,
    seed: u64,
    noise_percent: f64,
    hide: Option<Vec<(String, f64)>>,
    progress: Option<Py<PyAny>>,
) -> PyResult<usize> {
    let usual = MatrixOptions::default();
    let matrix = Matrix::thesis(&MatrixOptions {
        amplitudes_m: amplitudes.unwrap_or_else(|| usual.amplitudes_m.clone()),
        peak_velocities_m_s: peak_velocities.unwrap_or_else(|| usual.peak_velocities_m_s.clone()),
        ..usual
    })
    .map_err(raise::<RigError>)?;
    let options = Options { seed, noise_percent, ..Options::default() };
    let held = FolderLock::take(&folder).map_err(raise::<OutputError>)?;
    let measured = work::run(py, progress, |progress| -> anyhow::Result<usize> {
        let say = |done: usize, total: usize| progress.say(done as f64 / total.max(1) as f64, "measuring");
        let Some(effects) = hide else {
            let campaign = Campaign::run(&matrix, &options, say)?;
            campaign.write(&folder)?;
            return Ok(campaign.records.len());
        };
        let outcome = HiddenCase { effects, plan: Plan::default(), options }.run_matrix(&matrix, say)?;
        outcome.write(&folder)?;
        Ok(outcome.campaign.records.len())
    });
    drop(held);
    measured?.map_err(raise::<RigError>)
}
