//! `dashpot import dpr`: a model from the FV curve of an Adams Car property file.

use crate::adams::dpr;
use crate::verbs::output;
use crate::verbs::validate::prepared;
use anyhow::{Context as _, anyhow};
use dashpot_core::Params;
use dashpot_lab::model_file;
use std::path::PathBuf;

/// Make a model file from an Adams Car damper property file: the FV curve alone
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
    output::check([args.output.as_path()])?;
    let named = || args.input.display().to_string();
    let bytes = std::fs::read(&args.input).with_context(|| format!("cannot read {}", named()))?;
    let curve = dpr::read(&String::from_utf8_lossy(&bytes)).with_context(named)?;
    let mut params = Params::new();
    params.disable_all();
    let set = |params: &mut Params, name: &str, values: &[f64]| {
        params.set_list(name, values).map_err(|fault| anyhow!("{}: {name} {}", named(), fault.reason.text()))
    };
    params.enable("fv_curve", true).map_err(|fault| anyhow!("fv_curve {}", fault.reason.text()))?;
    set(&mut params, "fv_velocity", &curve.velocities)?;
    set(&mut params, "fv_force", &curve.forces)?;
    prepared(&params).with_context(named)?;
    output::write(
        &args.output,
        &model_file::flat(&params, |row| format!("{}; {}", row.parameter.unit, row.parameter.meaning)),
    )?;
    output::say(
        Some(&args.output),
        &format!(
            "{} points in {}; friction, gas and series stiffness are off",
            curve.velocities.len(),
            args.output.display()
        ),
    )
}
