//! `dashpot export dpr`: FV curve as an Adams Car property file.

use crate::verbs::model;
use anyhow::Context as _;
use dashpot_core::Params;
use dashpot_hosts::exports::property_file;
use dashpot_simulation::chatter::{Host, remarks};
use std::path::PathBuf;

/// Write the FV curve of a damper as an Adams Car damper property file
///
/// A property file contains only a curve. Hysteresis, springs and series stiffness need the routines of `dashpot export adams`. The file
/// contains the plain FV curve (fv_only) that `dashpot fit` fitted to the same tests and stored in the model file. It is the best possible
/// curve, and it includes friction. If the model file has no such curve, or if numbers of the model were changed, the file contains the
/// model's own curve. That curve has no friction. A file name that ends in .xml gives the XML form, which also contains the gas preload. A
/// comment in the file and a message state the origin of the curve and the omitted elements.
#[derive(clap::Args)]
#[command(
    after_help = "Examples:\n  dashpot export dpr damper.toml -o damper.dpr\n  dashpot export dpr damper.toml -o valves.dpr --model-curve"
)]
pub struct Args {
    /// Model file
    #[arg(value_name = "MODEL")]
    model: PathBuf,
    /// Where to write; - for standard output
    #[arg(short, long, value_name = "OUT.dpr")]
    output: PathBuf,
    /// Write the model's own curve, which is that of its valves without friction, even if the model file has the plain curve of a fit
    #[arg(long)]
    model_curve: bool,
}

/// Runs the verb.
pub fn run(args: &Args) -> anyhow::Result<()> {
    dashpot_output::check([args.output.as_path()])?;
    let file = model::read(&args.model)?;
    let named = args.model.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned());
    let text = dashpot_records::read_small(&args.model)?;
    let chatters = |curve: &Params| remarks(curve, Host::TYPICAL);
    let made = property_file(&file, args.model_curve, &args.output, (&named, &text), &chatters)
        .with_context(|| args.model.display().to_string())?;
    dashpot_output::write(&args.output, &made.text)?;
    dashpot_output::say(
        Some(&args.output),
        &format!("{} points in {}", made.points, dashpot_output::target_name(&args.output)),
    )?;
    made.remarks.iter().try_for_each(|remark| dashpot_output::say(Some(&args.output), &format!("  {remark}")))
}
