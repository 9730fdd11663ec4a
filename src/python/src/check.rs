//! Check of a model in a host with a zero-order hold of its force.

use crate::errors::{ModelError, raise};
use crate::model::Model;
use crate::work;
use dashpot_identification::model_file;
use dashpot_simulation::chatter::{Figures, Ready};
use pyo3::prelude::*;

/// Checks whether a damper chatters in a host with the step `host_step`, s, and the moved mass `wheel_mass`, kg. With `for_step`, s,
/// replaces friction that would chatter at that step.
///
/// Returns the output of `dashpot check --json` and the messages of the command. Also returns the text of a model file with the damper for
/// this host.
#[pyfunction]
#[pyo3(signature = (model, host_step, wheel_mass, for_step=None))]
pub fn check(
    py: Python<'_>,
    model: &Model,
    host_step: f64,
    wheel_mass: f64,
    for_step: Option<f64>,
) -> PyResult<(String, Vec<String>, String)> {
    let done = work::run(py, None, |_| -> anyhow::Result<(Figures, Vec<String>, String)> {
        let ready = Ready::prepare(&model.file.params, host_step, wheel_mass, for_step)?;
        let told = ready.messages().into_iter().chain(ready.stiffness()?).collect();
        Ok((ready.figures()?, told, model_file::plain(&ready.params, &ready.messages())))
    })?;
    let (figures, told, text) = done.map_err(raise::<ModelError>)?;
    Ok((serde_json::to_string(&figures).map_err(raise::<ModelError>)?, told, text))
}
