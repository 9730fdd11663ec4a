//! `dashpot export adm`: dampers of a compiled Adams Car model replaced by the routine.

use super::damper_length;
use crate::verbs::model;
use anyhow::{Context as _, anyhow};
use dashpot_hosts::adams::patch::{self, Damper};
use std::path::{Path, PathBuf};

/// Replace dampers in a compiled Adams Car model by the model, leaving every other byte alone
#[derive(clap::Args)]
#[command(
    after_help = "Example:\n  dashpot export adm car.adm -o car_dashpot.adm --model-file damper.toml --damper dal_ride_damper.force=412.5 --damper dar_ride_damper.force=412.5\n  dashpot export adm car.adm -o car_dashpot.adm --damper SFORCE/12=412.5,front.toml --damper SFORCE/14=388,rear.toml"
)]
pub struct Args {
    /// Compiled model
    #[arg(value_name = "IN.adm")]
    input: PathBuf,
    /// Where to write; - for standard output
    #[arg(short, long, value_name = "OUT.adm")]
    output: PathBuf,
    /// Name of the damper's SFORCE, or SFORCE/id, its length at zero displacement, in the unit of the model (UNITS) or with its own
    /// (412.5mm, 0.4125m), and its model file where that is not --model-file; repeat for more
    #[arg(long = "damper", value_name = "NAME=LENGTH[,PATH]", required = true, value_parser = damper)]
    dampers: Vec<Named>,
    /// Path of the model file as the solver will find it
    #[arg(long, value_name = "PATH", default_value = "damper.toml")]
    model_file: String,
    /// Replace also a force at rest (a constant beside the spline): the model file holds it as its gas force
    #[arg(long)]
    replace_preload: bool,
}

/// A damper as it is named: what its length is shows in the model.
#[derive(Clone)]
struct Named {
    name: String,
    length: String,
    model_file: String,
}

fn damper(text: &str) -> Result<Named, String> {
    let (name, length) = text.split_once('=').ok_or("say NAME=LENGTH")?;
    let (length, model_file) = length.split_once(',').unwrap_or((length, ""));
    // 412,5 would be taken for 412 and a model file called 5.
    let next = model_file.split(',').next().unwrap_or_default().trim();
    if !next.is_empty() && next.bytes().all(|b| b.is_ascii_digit()) {
        return Err(format!(
            "\"{length},{next}\" looks like a decimal comma; write {length}.{next} (a model file that is called {next} is given as ./{next})"
        ));
    }
    let length = length.trim();
    let number: f64 =
        damper_length::parts(length).0.parse().map_err(|_| format!("the length \"{length}\" is no number"))?;
    if name.is_empty() || !(number > 0.0 && number.is_finite()) {
        return Err("a name and a length above 0 are needed".into());
    }
    Ok(Named { name: name.into(), length: length.into(), model_file: model_file.trim_matches(' ').into() })
}

/// Runs the verb.
pub fn run(args: &Args) -> anyhow::Result<()> {
    dashpot_output::check([args.output.as_path()])?;
    let named = || args.input.display().to_string();
    let adm = std::fs::read(&args.input).with_context(|| format!("cannot read {}", named()))?;
    let unit = patch::length_unit(&adm).with_context(named)?;
    let damper = |damper: &Named| {
        // Without UNITS the numbers of a model have no unit; what Adams Car writes has them.
        let (unit, metres) = unit.as_ref().map_or(("millimeter", 1e-3), |(unit, metres)| (unit.as_str(), *metres));
        let length =
            damper_length::in_units(&damper.length, unit, metres).map_err(|why| anyhow!("{}: {why}", damper.name))?;
        let model_file = if damper.model_file.is_empty() { &args.model_file } else { &damper.model_file };
        Ok(Damper { name: damper.name.clone(), length, model_file: model_file.clone() })
    };
    let dampers: Vec<Damper> = args.dampers.iter().map(damper).collect::<anyhow::Result<_>>()?;
    let patched = patch::patch(&adm, &dampers, args.replace_preload).with_context(named)?;
    dashpot_output::write(&args.output, patched.model)?;
    dashpot_output::say(
        Some(&args.output),
        &format!(
            "{} damper{} replaced in {}",
            dampers.len(),
            if dampers.len() == 1 { "" } else { "s" },
            args.output.display()
        ),
    )?;
    let mut notes = patched.notes;
    if unit.is_none() {
        notes.push("the model has no UNITS statement, so its lengths were taken as millimetres".to_owned());
    }
    let mut named: Vec<&str> = dampers.iter().map(|damper| damper.model_file.as_str()).collect();
    named.sort_unstable();
    named.dedup();
    notes.extend(named.into_iter().filter_map(|path| not_there(path, &args.output)));
    notes.iter().try_for_each(|note| dashpot_output::say(Some(&args.output), &format!("  note: {note}")))
}

/// What is to be said of a model file that does not lie where the solver, which runs beside its model as a rule, would find it, or that is none.
/// It may be brought there later, so that is no error.
fn not_there(path: &str, output: &Path) -> Option<String> {
    let beside = output.parent().map(|folder| folder.join(path));
    let Some(found) = beside.into_iter().chain([PathBuf::from(path)]).find(|p| p.is_file()) else {
        return Some(format!(
            "there is no model file {path}, neither beside the new model nor here. The solver looks for it in the folder where it runs: put it \
             there, or name another one"
        ));
    };
    model::read(&found).err().map(|error| format!("the solver will refuse the model file: {error}"))
}
