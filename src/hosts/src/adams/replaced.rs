//! Replacement of dampers in a compiled Adams Car model, from the file and the user's data on each damper.

use super::patch::{self, Damper};
use crate::damper_length;
use anyhow::{Context as _, anyhow};
use dashpot_identification::model_file;
use std::path::{Path, PathBuf};

/// A damper as the user names it. The model shows the unit of its length.
#[derive(Debug, Clone)]
pub struct Named {
    /// Name of its SFORCE, or `SFORCE/id`.
    pub name: String,
    /// Its length at zero displacement: a number in the unit of the model, or with its own unit.
    pub length: String,
    /// Path of its model file, as the solver finds it.
    pub model_file: String,
}

/// Replaces dampers in the model of file `input`, and returns the model with notes.
///
/// The result is written to `output`, whose folder determines whether the solver finds a model file. With `with_preload` a force at rest is
/// replaced too.
///
/// # Errors
/// A file that cannot be read, a length that no damper has, and the errors of [`patch::patch`].
pub fn replaced(input: &Path, output: &Path, named: &[Named], with_preload: bool) -> anyhow::Result<patch::Patched> {
    let file = || input.display().to_string();
    let adm = std::fs::read(input).with_context(|| format!("cannot read {}", file()))?;
    let unit = patch::length_unit(&adm).with_context(file)?;
    let damper = |damper: &Named| {
        // Without UNITS the numbers of a model have no unit. Files of Adams Car have UNITS.
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

/// Returns a note on a model file that is missing, or that the solver would not find.
///
/// The solver usually runs in the folder of its model. The file may be copied there later, so this is no error.
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
