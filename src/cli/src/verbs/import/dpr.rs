//! `dashpot import dpr`: a model from an Adams Car property file, TeimOrbit or XML.

use anyhow::{Context as _, anyhow};
use dashpot_core::Params;
use dashpot_hosts::adams::property;
use dashpot_identification::model_file;
use dashpot_identification::model_file::prepared;
use std::path::PathBuf;

/// Make a model file from an Adams Car damper property file, .dpr or .xml: the FV curve, and the gas force where it has one
#[derive(clap::Args)]
#[command(after_help = "Example:\n  dashpot import dpr mdi_0001.dpr -o damper.toml")]
pub struct Args {
    /// Property file
    #[arg(value_name = "IN.dpr")]
    input: PathBuf,
    /// Where to write; - for standard output
    #[arg(short, long, value_name = "MODEL")]
    output: PathBuf,
}

/// Runs the verb.
pub fn run(args: &Args) -> anyhow::Result<()> {
    dashpot_output::check([args.output.as_path()])?;
    let named = || args.input.display().to_string();
    let bytes = std::fs::read(&args.input).with_context(|| format!("cannot read {}", named()))?;
    let read = property::read(&bytes).with_context(named)?;
    let curve = &read.curve;
    let mut params = Params::new();
    params.disable_all();
    let set = |params: &mut Params, name: &str, values: &[f64]| {
        params.set_list(name, values).map_err(|fault| anyhow!("{}: {name} {}", named(), fault.reason.text()))
    };
    params.enable("fv_curve", true).map_err(|fault| anyhow!("fv_curve {}", fault.reason.text()))?;
    set(&mut params, "fv_velocity", &curve.velocities)?;
    set(&mut params, "fv_force", &curve.forces)?;
    let scalar = |params: &mut Params, name: &str, value: f64| {
        params.set(name, value).map_err(|fault| anyhow!("{}: {name} {}", named(), fault.reason.text()))
    };
    if read.straight {
        scalar(&mut params, "fv_interpolation", 1.0)?;
    }
    if read.gas_force != 0.0 {
        params.enable("gas_preload", true).map_err(|fault| anyhow!("gas_preload {}", fault.reason.text()))?;
        scalar(&mut params, "gas_force", read.gas_force)?;
    }
    prepared(&params).with_context(named)?;
    let flat = model_file::flat(&params, |row| format!("{}; {}", row.parameter.unit, row.parameter.meaning));
    let file = args.input.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned());
    let mut text = format!("# Read from {}.\n", file.escape_debug());
    for note in &read.notes {
        text += &format!("# Left out: {}.\n", note.escape_debug());
    }
    dashpot_output::write(&args.output, &(text + "\n" + &flat))?;
    let beside = if read.gas_force == 0.0 {
        "friction, gas and series stiffness are off".to_owned()
    } else {
        format!("a gas force of {} N; friction and series stiffness are off", read.gas_force)
    };
    dashpot_output::say(
        Some(&args.output),
        &format!("{} points in {}; {beside}", curve.velocities.len(), args.output.display()),
    )?;
    for note in &read.notes {
        dashpot_output::say(Some(&args.output), &format!("  left out: {note}"))?;
    }
    Ok(())
}
