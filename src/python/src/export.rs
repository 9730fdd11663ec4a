//! Export of models as functional mock-up units.

use crate::errors::{ExportError, OutputError, raise, say};
use crate::model::Model;
use anyhow::{Context as _, bail};
use dashpot_core::Params;
use dashpot_hosts::damper_length::in_metres;
use dashpot_hosts::fmu::{self, Binary, Inputs, Scales, Version};
use dashpot_hosts::plain_curve::PlainCurve;
use dashpot_output::{Kind, as_a_run};
use dashpot_simulation::chatter::Ready;
use dashpot_simulation::stiffness;
use pyo3::prelude::*;
use std::path::PathBuf;

/// Options of an FMU and its host.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct Wanted {
    /// Name of the model in the FMU.
    name: String,
    /// Name of the first model file, without its folder.
    model_file: String,
    fmi: u32,
    four: bool,
    motion_scale: Option<f64>,
    force_scale: Option<f64>,
    position_offset: f64,
    /// Instant for which the importer sets the inputs of a step: "begin" or "end".
    inputs: Option<String>,
    /// Length of the damper for `CarMaker`: a number in m, or a number with its unit. `None` if the FMU is not for `CarMaker`.
    carmaker: Option<String>,
    /// Whether the equilibrium in `CarMaker` uses the FV curve of the model itself, even if the file has a plain FV curve.
    model_curve: bool,
    sources: bool,
    hide_parameters: bool,
    library: Option<PathBuf>,
    /// Binaries for further platforms: name of the platform, and path of the file.
    binaries: Vec<(String, PathBuf)>,
    host_step: f64,
    wheel_mass: f64,
    for_step: Option<f64>,
    force: bool,
}

/// An FMU, and the file next to it for `CarMaker`.
struct Files {
    made: fmu::Made,
    plug_info: Option<String>,
}

impl Wanted {
    /// Makes the contents of all files before any file is written, so that invalid options cause an error before writing.
    fn files(&self, models: &[&Model], stem: &str) -> anyhow::Result<Files> {
        let version = match self.fmi {
            2 => Version::Two,
            3 => Version::Three,
            other => bail!("there is no FMI {other} here; it is 2 or 3"),
        };
        let inputs = match self.inputs.as_deref() {
            None => Inputs::Unspecified,
            Some("begin") => Inputs::Begin,
            Some("end") => Inputs::End,
            Some(other) => bail!("inputs is \"begin\" or \"end\" of a step, not {other:?}"),
        };
        if self.carmaker.is_some() && models.len() > 1 {
            bail!("carmaker_length_m takes one model: CarMaker has one FMU for each kind of damper");
        }
        let (mut remarks, mut ready) = (Vec::new(), Vec::<Params>::new());
        for model in models {
            let one = Ready::prepare(&model.file.params, self.host_step, self.wheel_mass, self.for_step)?;
            remarks.extend(one.notes());
            remarks.extend(stiffness::remarks(&one.params));
            ready.push(one.params);
        }
        let corners = fmu::corners(&ready, self.four)?;
        let scales = match &self.carmaker {
            Some(length) => Scales::carmaker(in_metres(length).map_err(anyhow::Error::msg)?)?,
            None => Scales::checked(corners.len(), self.motion_scale, self.force_scale, self.position_offset)?,
        };
        let binary = |(platform, file): &(String, PathBuf)| Binary::read(platform, file);
        let more: Vec<Binary> = self.binaries.iter().map(binary).collect::<anyhow::Result<_>>().context("binaries")?;
        let made = fmu::fmu(
            &corners,
            &fmu::Options {
                version,
                scales,
                inputs,
                explicit_step: stiffness::longest_explicit_step(&corners),
                name: &self.name,
                from_source: self.library.as_deref(),
                sources: self.sources,
                conceal_parameters: self.hide_parameters,
                more: &more,
                remarks: &remarks,
            },
        )?;
        if self.carmaker.is_none() {
            return Ok(Files { made, plug_info: None });
        }
        // If the parameters are concealed, the file next to the FMU gets no curve, because the curve would reveal them.
        let curve =
            if self.hide_parameters { None } else { PlainCurve::from_model_file(&models[0].file, self.model_curve)? };
        let written = format!(
            "{}{} from {}. It belongs to {stem}.fmu.",
            dashpot_output::WRITTEN,
            env!("CARGO_PKG_VERSION"),
            self.model_file
        );
        let plug_info = fmu::plug_info((stem, &made.guid), false, curve.as_ref(), &written)?;
        Ok(Files { made, plug_info: Some(plug_info) })
    }
}

/// Writes a functional mock-up unit. If requested, also writes the file next to it for `CarMaker`. Returns the platforms on which the FMU
/// runs.
#[pyfunction]
#[allow(clippy::needless_pass_by_value)]
pub fn export_fmu(py: Python<'_>, models: Vec<Py<Model>>, path: PathBuf, wanted: Wanted) -> PyResult<Vec<String>> {
    let plug_info = wanted.carmaker.as_ref().map(|_| path.with_extension("pluginfo"));
    let stem = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let reads = || wanted.library.iter().chain(wanted.binaries.iter().map(|b| &b.1)).map(PathBuf::as_path);
    if plug_info.as_ref() == Some(&path) {
        return Err(say::<OutputError>(format!(
            "{} is the name of the file beside the FMU; name the FMU otherwise, such as damper.fmu",
            path.display()
        )));
    }
    let outputs = || [(Some(path.as_path()), Kind::Fmu), (plug_info.as_deref(), Kind::PlugInfo)];
    as_a_run(wanted.force, reads(), || dashpot_output::check_kinds(outputs())).map_err(raise::<OutputError>)?;
    let of_python: Vec<&Model> = models.iter().map(Py::get).collect();
    let files = py.detach(|| wanted.files(&of_python, &stem)).map_err(raise::<ExportError>)?;
    let written = as_a_run(wanted.force, reads(), || {
        dashpot_output::write(&path, &files.made.bytes)?;
        match (&plug_info, &files.plug_info) {
            (Some(path), Some(text)) => dashpot_output::write(path, text),
            _ => Ok(()),
        }
    });
    written.map_err(raise::<OutputError>)?;
    Ok(files.made.platforms)
}
