//! Export of models to files of Adams, and import of models from such files and from tables of peak forces.

use crate::errors::{ExportError, ModelError, OutputError, raise, say};
use crate::family::check_settings;
use crate::model::Model;
use dashpot_core::Params;
use dashpot_hosts::adams::folder::SineTest;
use dashpot_hosts::adams::imported::of_property_file;
use dashpot_hosts::adams::replaced::{Named, replaced};
use dashpot_hosts::damper_length::{in_metres, in_millimetres};
use dashpot_hosts::exports::{self, RunFolderInput};
use dashpot_identification::model_file;
use dashpot_identification::of_peaks::{family_of_peaks, of_peaks};
use dashpot_output::as_a_run;
use dashpot_records::PeakOptions;
use dashpot_rig::{Matrix, TestPoint};
use dashpot_simulation::chatter::{Host, Ready, remarks};
use pyo3::prelude::*;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// Parses a length from a text with a unit, or from a number in m. Returns the length in mm.
fn millimetres(length: &str) -> Result<f64, String> {
    // Parse the length in m first, because the error message of `in_metres` states that a number alone is in m.
    in_metres(length)?;
    let has_unit = length.trim_end().ends_with('m');
    in_millimetres(&if has_unit { length.to_owned() } else { format!("{length}m") })
}

/// Writes a folder with all files that Adams needs to run a damper. Returns notes on the folder.
#[pyfunction]
#[allow(clippy::too_many_arguments, clippy::needless_pass_by_value)]
pub fn export_adams(
    py: Python<'_>,
    model: &Model,
    folder: PathBuf,
    length: Option<&str>,
    library: Option<PathBuf>,
    host_step: f64,
    wheel_mass: f64,
    for_step: Option<f64>,
    force: bool,
) -> PyResult<Vec<String>> {
    let length = length.map(millimetres).transpose().map_err(say::<ExportError>)?;
    let made = py.detach(|| -> anyhow::Result<_> {
        let ready = Ready::prepare(&model.file.params, host_step, wheel_mass, for_step)?;
        let prepared = model_file::prepared(&ready.params)?;
        let libraries = exports::adams_libraries(library.as_deref())?;
        let text = match ready.softened {
            Some(_) => model_file::plain(&ready.params, &ready.messages()),
            None => model.text_of_file().to_owned(),
        };
        let (replaced, chatters) = (ready.replaced(), ready.remarks());
        let sine = |p: &TestPoint| SineTest { amplitude_m: p.amplitude_m, frequency_hz: p.frequency_hz };
        let tests: Vec<SineTest> = Matrix::default().points().iter().map(sine).collect();
        Ok(exports::run_folder(RunFolderInput {
            params: &ready.params,
            model: &prepared,
            text: text.as_bytes(),
            length,
            tests: &tests,
            libraries,
            replaced,
            chatters,
        }))
    });
    let made = made.map_err(raise::<ExportError>)?;
    let written = as_a_run(force, library.as_deref(), || {
        dashpot_output::make_folder(&folder)?;
        made.files.iter().try_for_each(|(name, content)| dashpot_output::write(&folder.join(name), content))
    });
    written.map_err(raise::<OutputError>)?;
    let mut notes = made.notes(&folder);
    notes.extend(made.if_coupled());
    Ok(notes)
}

/// Writes the FV curve of a model as a property file of Adams Car. `name` is the name of the model. Returns the number of points of the
/// written curve, and notes.
#[pyfunction]
#[allow(clippy::needless_pass_by_value)]
pub fn export_dpr(
    model: &Model,
    path: PathBuf,
    name: &str,
    model_curve: bool,
    force: bool,
) -> PyResult<(usize, Vec<String>)> {
    let chatters = |curve: &Params| remarks(curve, Host::TYPICAL);
    let of = (name, model.text_of_file().as_bytes());
    let made = exports::property_file(&model.file, model_curve, &path, of, &chatters);
    let made = made.map_err(raise::<ExportError>)?;
    let written = as_a_run(force, [], || {
        dashpot_output::check([path.as_path()])?;
        dashpot_output::write(&path, &made.text)
    });
    written.map_err(raise::<OutputError>)?;
    Ok((made.points, made.remarks))
}

/// Writes a compiled Adams Car model in which dampers are replaced. Each entry of `dampers` gives the name of a damper's SFORCE, its length
/// at zero displacement and the path of its model file. Returns notes.
#[pyfunction]
#[allow(clippy::needless_pass_by_value)]
pub fn export_adm(
    source: PathBuf,
    path: PathBuf,
    dampers: Vec<(String, String, String)>,
    replace_preload: bool,
    force: bool,
) -> PyResult<Vec<String>> {
    let named: Vec<Named> =
        dampers.into_iter().map(|(name, length, model_file)| Named { name, length, model_file }).collect();
    let made = replaced(&source, &path, &named, replace_preload).map_err(raise::<ExportError>)?;
    let written = as_a_run(force, [source.as_path()], || {
        dashpot_output::check([path.as_path()])?;
        dashpot_output::write(&path, &made.model)
    });
    written.map_err(raise::<OutputError>)?;
    Ok(made.notes)
}

/// Makes a model from a property file of Adams Car. Returns the text of the model file.
#[pyfunction]
#[allow(clippy::needless_pass_by_value)]
pub fn import_dpr(path: PathBuf) -> PyResult<String> {
    of_property_file(&path).map(|made| made.text).map_err(raise::<ModelError>)
}

/// Makes a model from a table of peak forces.
///
/// With `is_family`, makes one model over the clicks of the table. Returns the text of the model file, the side that was interpreted as
/// rebound, whether the forces contradict that interpretation, and notes.
#[pyfunction]
#[allow(clippy::needless_pass_by_value, clippy::too_many_arguments)]
pub fn import_peaks(
    path: PathBuf,
    positive: Option<&str>,
    units: BTreeMap<String, String>,
    columns: BTreeMap<String, String>,
    clicks: Option<f64>,
    gas_force: f64,
    friction: f64,
    is_family: bool,
) -> PyResult<(String, String, bool, Vec<String>)> {
    check_settings("clicks", &clicks)?;
    let said = |name: &str, why: String| say::<ModelError>(format!("{name}: {why}"));
    let mut options = PeakOptions { clicks, ..PeakOptions::default() };
    if let Some(text) = positive {
        options.positive = Some(text.parse().map_err(|why| said("positive", why))?);
    }
    for (channel, unit) in &units {
        let channel = channel.parse().map_err(|why| said("units", why))?;
        options.unit_of(channel, unit).map_err(|why| said("units", why))?;
    }
    for (column, heading) in columns {
        options.columns.insert(column.parse().map_err(|why| said("columns", why))?, heading);
    }
    let path: &Path = &path;
    let make = if is_family { family_of_peaks } else { of_peaks };
    let begun = make(path, &options, gas_force, friction).map_err(raise::<ModelError>)?;
    let notes = begun.notes();
    Ok((begun.text, begun.direction, begun.is_doubtful, notes))
}
