//! `dashpot export adm`: dampers of a compiled Adams Car model replaced by the routine.

use anyhow::Context as _;
use dashpot_hosts::adams::patch::{self, Damper};
use std::path::PathBuf;

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
    /// Name of the damper's SFORCE, or SFORCE/id, its length at zero displacement in model units, and its model file where that is
    /// not --model-file; repeat for more
    #[arg(long = "damper", value_name = "NAME=LENGTH[,PATH]", required = true, value_parser = damper)]
    dampers: Vec<Damper>,
    /// Path of the model file as the solver will find it
    #[arg(long, value_name = "PATH", default_value = "damper.toml")]
    model_file: String,
    /// Replace also a force at rest (a constant beside the spline): the model file holds it as its gas force
    #[arg(long)]
    replace_preload: bool,
}

fn damper(text: &str) -> Result<Damper, String> {
    let (name, length) = text.split_once('=').ok_or("say NAME=LENGTH")?;
    let (length, model_file) = length.split_once(',').unwrap_or((length, ""));
    let length: f64 = length.trim().parse().map_err(|_| format!("the length \"{length}\" is no number"))?;
    if name.is_empty() || !(length > 0.0 && length.is_finite()) {
        return Err("a name and a length above 0 are needed".into());
    }
    Ok(Damper { name: name.into(), length, model_file: model_file.trim_matches(' ').into() })
}

/// Runs the verb.
pub fn run(args: &Args) -> anyhow::Result<()> {
    dashpot_output::check([args.output.as_path()])?;
    let named = || args.input.display().to_string();
    let adm = std::fs::read(&args.input).with_context(|| format!("cannot read {}", named()))?;
    let mut dampers = args.dampers.clone();
    for damper in dampers.iter_mut().filter(|d| d.model_file.is_empty()) {
        damper.model_file.clone_from(&args.model_file);
    }
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
    patched.notes.iter().try_for_each(|note| dashpot_output::say(Some(&args.output), &format!("  note: {note}")))
}
