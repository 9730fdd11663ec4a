//! `dashpot import dpr`: a model from an Adams Car property file, TeimOrbit or XML.

use anyhow::{Context as _, anyhow};
use dashpot_core::Params;
use dashpot_core::parameter::Number;
use dashpot_core::{element, list, number};
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
    params.enable(element!("fv_curve"), true);
    for (list, values) in [(list!("fv_velocity"), &curve.velocities), (list!("fv_force"), &curve.forces)] {
        params.set_list(list, values).map_err(|fault| anyhow!("{}: {list} {}", named(), fault.reason.text()))?;
    }
    let set = |params: &mut Params, number: Number, value: f64| {
        params.set(number, value).map_err(|fault| anyhow!("{}: {number} {}", named(), fault.reason.text()))
    };
    if read.straight {
        set(&mut params, number!("fv_interpolation"), 1.0)?;
    }
    if read.gas_force != 0.0 {
        params.enable(element!("gas_preload"), true);
        set(&mut params, number!("gas_force"), read.gas_force)?;
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
