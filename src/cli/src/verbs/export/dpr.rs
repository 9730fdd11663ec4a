//! `dashpot export dpr`: the FV curve as an Adams Car property file.

use anyhow::bail;
use dashpot_core::elements::{self, GROUPS};
use dashpot_hosts::adams::property::{self, Curve, Form, Properties};
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
    if !file.params.is_on("fv_curve") {
        bail!("{}: the element fv_curve is off, so there is no curve to export", args.model.display());
    }
    let model = prepared(&file.params)?;
    let curve = Curve::of(&file.params, &model);
    let xml = args.output.extension().is_some_and(|e| e.eq_ignore_ascii_case("xml"));
    let form = if xml { Form::Xml } else { Form::TeimOrbit };
    let gas_force = if xml && file.params.is_on("gas_preload") { file.params.scalar("gas_force") } else { 0.0 };
    let held = |name: &str| name == "fv_curve" || (xml && name == "gas_preload");
    let left_out: Vec<&str> = GROUPS[..elements::COUNT]
        .iter()
        .map(|g| g.name)
        .filter(|name| file.params.is_on(name) && !held(name))
        .collect();
    let named = args.model.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned());
    let mut notes = vec![format!(
        "{}{} from {} (check sum {:08x}). Rebound and tension are positive.",
        dashpot_output::WRITTEN,
        env!("CARGO_PKG_VERSION"),
        if named.is_ascii() { named } else { "a model file".into() },
        dashpot_hosts::fmu::check_sum(&std::fs::read(&args.model)?)
    )];
    if !left_out.is_empty() {
        notes.push(format!("Left out, for a property file has no place for it: {}.", left_out.join(", ")));
    }
    let mut alone = file.params;
    alone.disable_all();
    alone.enable("fv_curve", true).map_err(|fault| anyhow::anyhow!("{}", fault.reason.text()))?;
    notes.extend(remarks(&alone, Host::USUAL));
    let points = curve.velocities.len();
    let text = property::write(&Properties { curve, straight: false, gas_force, notes }, form);
    dashpot_output::write(&args.output, &text)?;
    let more = if left_out.is_empty() { String::new() } else { format!("; left out: {}", left_out.join(", ")) };
    dashpot_output::say(Some(&args.output), &format!("{points} points in {}{more}", args.output.display()))
}
