//! `dashpot export adm`: dampers of a compiled Adams Car model replaced by the routine.

use crate::adams::patch::{self, Damper};
use crate::verbs::output;
use anyhow::Context as _;
use std::path::PathBuf;

/// Replace dampers in a compiled Adams Car model by the model, leaving every other byte alone
#[derive(clap::Args)]
#[command(
    after_help = "Example:\n  dashpot export adm car.adm -o car_dashpot.adm --model-file damper.toml --damper dal_ride_damper.force=412.5 --damper dar_ride_damper.force=412.5"
)]
pub struct Args {
    /// Compiled model
    #[arg(value_name = "IN.adm")]
    input: PathBuf,
    /// Where to write; - for standard output
    #[arg(short, long, value_name = "OUT.adm")]
    output: PathBuf,
    /// Name of the damper's SFORCE, or SFORCE/id, and its length at zero displacement in model units; repeat for more
    #[arg(long = "damper", value_name = "NAME=LENGTH", required = true, value_parser = damper)]
    dampers: Vec<Damper>,
    /// Path of the model file as the solver will find it
    #[arg(long, value_name = "PATH", default_value = "damper.toml")]
    model_file: String,
}

fn damper(text: &str) -> Result<Damper, String> {
    let (name, length) = text.split_once('=').ok_or("say NAME=LENGTH")?;
    let length: f64 = length.trim().parse().map_err(|_| format!("the length \"{length}\" is no number"))?;
    if name.is_empty() || !(length > 0.0 && length.is_finite()) {
        return Err("a name and a length above 0 are needed".into());
    }
    Ok(Damper { name: name.into(), length })
}

/// Runs the verb.
pub fn run(args: &Args) -> anyhow::Result<()> {
    output::check([args.output.as_path()])?;
    let named = || args.input.display().to_string();
    let adm = std::fs::read(&args.input).with_context(|| format!("cannot read {}", named()))?;
    output::write(&args.output, patch::patch(&adm, &args.dampers, &args.model_file).with_context(named)?)?;
    output::say(Some(&args.output), &format!("{} dampers replaced in {}", args.dampers.len(), args.output.display()))
}
