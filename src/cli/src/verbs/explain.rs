//! `dashpot explain`: properties of gas, oil and valves that follow from a model.

use super::model;
use crate::quantity::SettingText;
use anyhow::bail;
use dashpot_dimensions::{Explanation, explain, read};
use dashpot_identification::family::at_setting;
use dashpot_identification::model_file::ModelFile;
use dashpot_output::Kind;
use serde::Serialize;
use std::path::{Path, PathBuf};

/// Explain a model by the dimensions of its damper: gas pressure, air, moduli, passages of the valves
///
/// Each quantity has a 95 % interval. It includes the intervals of the model file and the dimensions, handbook data of oil, and the form
/// error of the model. Quantities that cannot be determined are listed with the missing entry or parameter. If the dimensions contradict a
/// number of the model, the ratio of the two is reported.
#[derive(clap::Args)]
#[command(
    after_help = "Example:\n  dashpot explain damper.toml --dimensions dimensions.toml --json explained.json\n\nEvery entry of the dimensions is optional:\n  design = \"monotube\"          # or \"twin_tube\"\n  bore_mm = 36\n  rod_mm = 11\n  rebound_chamber_mm = 130     # at displacement zero\n  gas_pressure_bar = [14, 16]  # gauge; a range of 95 %"
)]
pub struct Args {
    /// Model file
    #[arg(value_name = "MODEL")]
    model: PathBuf,
    /// Dimensions of the damper, a TOML file with the unit in every key
    #[arg(long, value_name = "D.toml")]
    dimensions: PathBuf,
    /// Setting at which a damper over a setting is explained
    #[arg(long, value_name = "VALUE", allow_negative_numbers = true)]
    setting: Option<SettingText>,
    /// Quantities, gaps and contradictions as JSON; - for standard output
    #[arg(long, value_name = "F")]
    json: Option<PathBuf>,
}

#[derive(Serialize)]
struct Json<'a> {
    model: &'a Path,
    dimensions: &'a Path,
    #[serde(flatten)]
    explanation: &'a Explanation,
}

/// Returns the damper to explain. An adjustable damper is evaluated at the given setting.
fn damper(args: &Args) -> anyhow::Result<ModelFile> {
    let file = model::read_family(&args.model)?;
    let path = args.model.display();
    let Some(setting) = &args.setting else {
        if file.axis.is_some() {
            let (low, high) = file.axis.range();
            bail!(
                "{path} is a damper over a setting: say at which to explain it, as --setting {low} or another up to {high}"
            );
        }
        return Ok(file);
    };
    if !file.axis.is_some() {
        bail!("{path} depends on no setting; leave --setting out");
    }
    let setting = setting.within(&file.axis, &args.model)?;
    Ok(at_setting(&file, setting))
}

/// Runs the verb.
pub fn run(args: &Args) -> anyhow::Result<()> {
    let json = args.json.as_deref();
    dashpot_output::check_kinds([(json, Kind::Figures)])?;
    let file = damper(args)?;
    let explanation = explain(&file, &read(&args.dimensions)?);
    for line in explanation.lines() {
        dashpot_output::say(json, &line)?;
    }
    if let Some(path) = json {
        let (model, dimensions) = (args.model.as_path(), args.dimensions.as_path());
        dashpot_output::json(path, &Json { model, dimensions, explanation: &explanation })?;
    }
    Ok(())
}
