//! Models as files for other programs.

use crate::errors::{ExportError, OutputError, raise};
use crate::model::Model;
use dashpot_core::Params;
use dashpot_hosts::fmu::{self, Options, Scales, Version};
use dashpot_output::{Kind, as_a_run};
use dashpot_simulation::chatter::{self, Host};
use dashpot_simulation::stiffness;
use pyo3::prelude::*;
use std::path::PathBuf;

/// Writes a functional mock-up unit; returns the platforms that it runs on.
#[pyfunction]
#[pyo3(signature = (models, path, name, fmi, four, motion_scale, force_scale, position_offset, sources, hide_parameters, library, force))]
#[allow(clippy::too_many_arguments, clippy::needless_pass_by_value)]
pub fn export_fmu(
    py: Python<'_>,
    models: Vec<Py<Model>>,
    path: PathBuf,
    name: &str,
    fmi: u32,
    four: bool,
    motion_scale: Option<f64>,
    force_scale: Option<f64>,
    position_offset: f64,
    sources: bool,
    hide_parameters: bool,
    library: Option<PathBuf>,
    force: bool,
) -> PyResult<Vec<String>> {
    let reads = || library.as_deref();
    as_a_run(force, reads(), || dashpot_output::check_kinds([(Some(path.as_path()), Kind::Fmu)]))
        .map_err(raise::<OutputError>)?;
    let version = match fmi {
        2 => Version::Two,
        3 => Version::Three,
        other => return Err(raise::<ExportError>(anyhow::anyhow!("there is no FMI {other} here; it is 2 or 3"))),
    };
    let params: Vec<Params> = models.iter().map(|m| m.get().file.params).collect();
    let made = py.detach(|| -> anyhow::Result<fmu::Made> {
        let corners = fmu::corners(&params, four)?;
        let scales = Scales::checked(corners.len(), motion_scale, force_scale, position_offset)?;
        let from_source = library.as_deref();
        let of_one = |p: &Params| chatter::remarks(p, Host::USUAL).into_iter().chain(stiffness::remarks(p));
        let mut remarks: Vec<String> = params.iter().flat_map(of_one).collect();
        remarks.dedup();
        let more = &[];
        fmu::fmu(
            &corners,
            &Options { version, scales, name, from_source, sources, hide_parameters, more, remarks: &remarks },
        )
    });
    let made = made.map_err(raise::<ExportError>)?;
    as_a_run(force, reads(), || dashpot_output::write(&path, &made.bytes)).map_err(raise::<OutputError>)?;
    Ok(made.platforms)
}
