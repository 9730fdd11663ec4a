//! `dashpot export dpr`: the FV curve as an Adams Car property file.

use crate::adams::dpr::{self, Curve};
use crate::adams::gas_preload;
use crate::verbs::output;
use crate::verbs::validate::prepared;
use anyhow::bail;
use dashpot_core::{Model, Params};
use dashpot_lab::model_file;
use std::path::PathBuf;

/// Write the FV curve of a model as an Adams Car damper property file
///
/// A property file holds the curve alone; friction, springs and series stiffness need the routines of `dashpot export adams`.
/// A file name that ends in .xml gets the XML form, which holds the gas preload too.
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
    output::check([args.output.as_path()])?;
    let file = model_file::read(&args.model)?;
    if !file.params.is_on("fv_curve") {
        bail!("{}: the element fv_curve is off, so there is no curve to export", args.model.display());
    }
    let model = prepared(&file.params)?;
    let curve = curve(&file.params, &model);
    let xml = args.output.extension().is_some_and(|e| e.eq_ignore_ascii_case("xml"));
    let text = if xml {
        let gas = if file.params.is_on("gas_preload") { file.params.scalar("gas_force") } else { 0.0 };
        gas_preload::write(&curve, gas)
    } else {
        dpr::write(&curve)
    };
    output::write(&args.output, &text)?;
    output::say(Some(&args.output), &format!("{} points in {}", curve.velocities.len(), args.output.display()))
}

/// The curve's own points; of the form with slopes and knees, a point at every knee and some between and beyond.
fn curve(params: &Params, model: &Model) -> Curve {
    let fv = model.elements().fv_curve;
    let velocities = if params.scalar("fv_form") == 0.0 {
        params.list("fv_velocity").to_vec()
    } else {
        let of = |name: &str| params.scalar(name);
        let (r1, r2, c1) = (of("fv_rebound_v1"), of("fv_rebound_v2"), of("fv_compression_v1"));
        vec![-3.0 * c1.max(r2), -2.0 * c1, -c1, -0.5 * c1, 0.0, 0.5 * r1, r1, 0.5 * (r1 + r2), r2, 1.5 * r2, 3.0 * r2]
    };
    let forces = velocities.iter().map(|v| fv.at(*v).value).collect();
    Curve { velocities, forces }
}
