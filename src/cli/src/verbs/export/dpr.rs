//! `dashpot export dpr`: the FV curve as an Adams Car property file.

use anyhow::Context as _;
use dashpot_core::Params;
use dashpot_hosts::handed_out::property_file;
use dashpot_identification::model_file;
use dashpot_identification::model_file::prepared;
use dashpot_simulation::chatter::{Host, remarks};
use std::path::PathBuf;

/// Write the FV curve of a model as an Adams Car damper property file
///
/// A property file holds the curve alone; friction, springs and series stiffness need the routines of `dashpot export adams`.
/// A file name that ends in .xml gets the XML form, which holds the gas preload too. What is left out stands in the file as a
/// comment and is said.
#[derive(clap::Args)]
#[command(after_help = "Example:\n  dashpot export dpr damper.toml -o damper.dpr")]
pub struct Args {
    /// Model file
    #[arg(value_name = "MODEL")]
    model: PathBuf,
    /// Where to write; - for standard output
    #[arg(short, long, value_name = "OUT.dpr")]
    output: PathBuf,
}

/// Runs the verb.
pub fn run(args: &Args) -> anyhow::Result<()> {
    dashpot_output::check([args.output.as_path()])?;
    let file = model_file::read(&args.model)?;
    let model = prepared(&file.params)?;
    let named = args.model.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned());
    let text = std::fs::read(&args.model)?;
    let chatters = |curve: &Params| remarks(curve, Host::USUAL);
    let made = property_file(&file.params, &model, &args.output, (&named, &text), &chatters)
        .with_context(|| args.model.display().to_string())?;
    dashpot_output::write(&args.output, &made.text)?;
    let more =
        if made.left_out.is_empty() { String::new() } else { format!("; left out: {}", made.left_out.join(", ")) };
    dashpot_output::say(Some(&args.output), &format!("{} points in {}{more}", made.points, args.output.display()))
}
