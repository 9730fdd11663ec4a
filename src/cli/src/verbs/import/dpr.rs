//! `dashpot import dpr`: import of a model from an Adams Car property file, TeimOrbit or XML.

use dashpot_hosts::adams::imported::of_property_file;
use std::path::PathBuf;

/// Make a model file from an Adams Car damper property file, .dpr or .xml: the FV curve and any gas force
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
    dashpot_output::check_kinds([(Some(args.output.as_path()), dashpot_output::Kind::Model)])?;
    let made = of_property_file(&args.input)?;
    dashpot_output::write(&args.output, &made.text)?;
    dashpot_output::say(
        Some(&args.output),
        &format!("{} points in {}; {}", made.points, dashpot_output::target_name(&args.output), made.other_contents),
    )?;
    made.remarks.iter().try_for_each(|remark| dashpot_output::say(Some(&args.output), &format!("  {remark}")))
}
