//! `dashpot export adm`: replacement of dampers in a compiled Adams Car model by calls of dashpot's user subroutine.

use dashpot_hosts::adams::replaced::{Named, replaced};
use dashpot_hosts::damper_length;
use std::path::PathBuf;

/// Replace dampers in a compiled Adams Car model by the model, without changing any other byte
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
    /// Name of the damper's SFORCE, or SFORCE/id, and its length at zero displacement. Add its model file if it differs from --model-file.
    /// The length is in the unit of the model (UNITS) or has its own unit (412.5mm, 0.4125m). Repeat for more dampers
    #[arg(long = "damper", value_name = "NAME=LENGTH[,PATH]", required = true, value_parser = damper)]
    dampers: Vec<Named>,
    /// Path at which the solver will find the model file
    #[arg(long, value_name = "PATH", default_value = "damper.toml")]
    model_file: String,
    /// Also replace a force at rest, which is a constant added to the spline. Requires that the model file contains it as gas force
    #[arg(long)]
    replace_preload: bool,
}

fn damper(text: &str) -> Result<Named, String> {
    let (name, length) = text.split_once('=').ok_or("say NAME=LENGTH")?;
    let (length, model_file) = length.split_once(',').unwrap_or((length, ""));
    // Without this check, `412,5` would mean length 412 and a model file with the name 5.
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
    let mut dampers = args.dampers.clone();
    for damper in dampers.iter_mut().filter(|damper| damper.model_file.is_empty()) {
        damper.model_file.clone_from(&args.model_file);
    }
    let patched = replaced(&args.input, &args.output, &dampers, args.replace_preload)?;
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
