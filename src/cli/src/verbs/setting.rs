//! `dashpot setting`: evaluation of an adjustable damper at one setting.

use super::model;
use crate::quantity::SettingText;
use anyhow::bail;
use dashpot_core::family::Axis;
use dashpot_identification::family::{at_setting, interpolated_between};
use dashpot_identification::model_file::with_tables;
use dashpot_records::setting_in_words;
use std::path::PathBuf;

/// Evaluate an adjustable damper at one setting, and write the result as an ordinary damper
///
/// Verbs without a setting option need such a file. Between the settings of the model file, its numbers and forces are interpolated by
/// monotone cubics. At the settings of the file, the stored values apply unchanged. The result does not contain the actuator.
#[derive(clap::Args)]
#[command(
    after_help = "Examples:\n  dashpot setting semi_active.toml 0.8 -o at_0.8.toml\n  dashpot setting adjuster.toml 12 -o - | head"
)]
pub struct Args {
    /// Model file with a setting
    #[arg(value_name = "MODEL")]
    model: PathBuf,
    /// Setting in the unit of the file, such as 0.6, or with a unit, such as 0.6A
    #[arg(value_name = "SETTING", allow_negative_numbers = true)]
    setting: SettingText,
    /// Where to write; - for standard output
    #[arg(short, long, value_name = "OUT.toml")]
    output: PathBuf,
}

/// Runs the verb.
pub fn run(args: &Args) -> anyhow::Result<()> {
    dashpot_output::check_kinds([(Some(args.output.as_path()), dashpot_output::Kind::Model)])?;
    let file = model::read_family(&args.model)?;
    if !file.axis.is_some() {
        bail!("{} depends on no setting; it is an ordinary damper already", args.model.display());
    }
    let setting = args.setting.within(&file.axis, &args.model)?;
    let named = args.model.file_name().unwrap_or_default().to_string_lossy();
    let remark = format!("{named} at {}", model::setting_at(&file.axis, setting));
    let text = with_tables(&at_setting(&file, setting), std::slice::from_ref(&remark))?;
    dashpot_output::write(&args.output, text)?;
    if let Some(note) = note_of_interpolation(&file.axis, setting) {
        dashpot_output::warn(&format!("note: {note}"));
    }
    dashpot_output::say(Some(&args.output), &format!("{remark} in {}", dashpot_output::target_name(&args.output)))
}

/// Returns a note if a setting lies between those of the model file, so that its force is interpolated.
pub fn note_of_interpolation(axis: &Axis, setting: f64) -> Option<String> {
    let neighbors = interpolated_between(axis.grid(), setting)?;
    let [low, high] = neighbors.map(|value| setting_in_words(value, axis.unit()));
    let here = setting_in_words(setting, axis.unit());
    Some(format!(
        "{here} lies between the settings {low} and {high} of the model file, and its force is interpolated. \
         `dashpot validate` with tests at {here} shows the error"
    ))
}
