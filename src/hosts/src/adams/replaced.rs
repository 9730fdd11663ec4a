//! Replacement of dampers in an Adams dataset, from the file and the user's data about each damper.

use super::patch::{self, Damper};
use crate::damper_length;
use anyhow::{Context as _, anyhow};
use dashpot_identification::model_file;
use std::path::{Path, PathBuf};

/// A damper to replace, as stated by the user. A length without a unit has the unit of the model.
#[derive(Debug, Clone)]
pub struct Named {
    /// Name of the damper's SFORCE, or `SFORCE/id`.
    pub name: String,
    /// Length at zero displacement: a number in the unit of the model, or a number with its own unit.
    pub length: String,
    /// Path at which the Adams solver finds the model file of the damper.
    pub model_file: String,
}

/// Size limit of an Adams model, bytes. Models of whole vehicles have a few megabytes.
const LARGEST: u64 = 256 << 20;

/// Replaces dampers in the model of the file `input`, and returns the changed model with notes.
///
/// The caller writes the result to `output`. A note reports a model file that is missing in the folder of `output`, because the solver
/// searches that folder. With `with_preload`, a function with a force at rest is replaced too.
///
/// # Errors
/// The file cannot be read, a length is impossible for a damper, or [`patch::patch`] fails.
pub fn replaced(input: &Path, output: &Path, named: &[Named], with_preload: bool) -> anyhow::Result<patch::Patched> {
    let file = || input.display().to_string();
    let adm = dashpot_records::read_regular(input, LARGEST).with_context(|| format!("cannot read {}", file()))?;
    let unit = patch::length_unit(&adm).with_context(file)?;
    let damper = |damper: &Named| {
        // Without a UNITS statement, the unit is unknown, and mm is assumed. Files of Adams Car have UNITS.
        let (unit, metres) = unit.as_ref().map_or(("millimeter", 1e-3), |(unit, metres)| (unit.as_str(), *metres));
        let length =
            damper_length::in_units(&damper.length, unit, metres).map_err(|why| anyhow!("{}: {why}", damper.name))?;
        Ok(Damper { name: damper.name.clone(), length, model_file: damper.model_file.clone() })
    };
    let dampers: Vec<Damper> = named.iter().map(damper).collect::<anyhow::Result<_>>()?;
    let mut patched = patch::patch(&adm, &dampers, with_preload).with_context(file)?;
    if unit.is_none() {
        patched.notes.push("the model has no UNITS statement, so its lengths were taken as millimetres".to_owned());
    }
    let mut files: Vec<&str> = dampers.iter().map(|damper| damper.model_file.as_str()).collect();
    files.sort_unstable();
    files.dedup();
    patched.notes.extend(files.into_iter().filter_map(|path| not_there(path, output)));
    Ok(patched)
}

/// Returns a note on a model file that is missing or invalid. The file may be in the folder of `output` or in the working directory.
///
/// The solver usually runs in the folder of its model. A missing file is not an error, because the user may copy it to that folder later.
fn not_there(path: &str, output: &Path) -> Option<String> {
    let beside = output.parent().map(|folder| folder.join(path));
    let Some(found) = beside.into_iter().chain([PathBuf::from(path)]).find(|p| p.is_file()) else {
        return Some(format!(
            "there is no model file {path}, neither beside the new model nor here. The solver looks for it in the folder where it runs: put it \
             there, or name another one"
        ));
    };
    model_file::read(&found).err().map(|error| format!("the solver will refuse the model file: {error}"))
}
