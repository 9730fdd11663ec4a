//! `dashpot demo`: all steps once, on a virtual rig.

mod riddle;

use super::data::{DataArgs, name_of};
use super::{fit, validate};
use crate::page::PageArgs;
use crate::progress::Progress;
use dashpot_identification::{FitOptions, describe_item};
use dashpot_identification::{model_file, validation};
use dashpot_output::FolderLock;
use dashpot_records::hold_out;
use dashpot_report::ReportInput;
use dashpot_rig::{Campaign, Matrix, Options};
use std::path::PathBuf;

/// Measure a virtual damper, identify it and validate the model; then find an injected effect in another damper
///
/// Writes records, model files and reports to one folder. The fit does not use three rows of the test matrix, so the report shows errors on
/// tests that are new to the model. The second damper has an effect that the model lacks. The diagnosis names the effect, adds it, and
/// reports the reduction of the error.
#[derive(clap::Args)]
#[command(after_help = "Example:\n  dashpot demo -o demo")]
pub struct Args {
    /// Folder for all results
    #[arg(short, long, value_name = "DIR", default_value = "demo")]
    output: PathBuf,
    /// Seed of the virtual damper
    #[arg(long, default_value_t = 0)]
    seed: u64,
}

/// Name patterns of the tests that the fit does not use: all tests of the matrix with amplitudes of 40, 25 and 2 mm.
const HELD_OUT: [&str; 3] = ["a40mm*", "a25mm*", "a02mm*"];

/// Runs the verb.
pub fn run(args: &Args) -> anyhow::Result<()> {
    let say = |text: &str| dashpot_output::say(None, text);
    let records = args.output.join("records");
    let _held = FolderLock::take(&args.output)?;
    say("1. A virtual rig measures a virtual damper over the thesis's test matrix.")?;
    let progress = Progress::new("measuring");
    let options = Options { seed: args.seed, ..Options::default() };
    Campaign::run(&Matrix::default(), &options, |done, total| progress.count(done, total))?.write(&records)?;
    drop(progress);
    let data = DataArgs::folder(records);
    let mut campaign = data.load()?;
    say(&format!("   {} tests in {}", campaign.records.len(), data.named()))?;
    say("2. The damper is identified from these records, without the rows at 40, 25 and 2 mm.")?;
    let model_path = args.output.join("damper.toml");
    let held_out: Vec<String> = HELD_OUT.map(String::from).to_vec();
    let found = fit::identify(&hold_out::kept(&campaign, &held_out)?, &FitOptions::default(), &model_path)?;
    for item in &found.inventory {
        say(&format!("   {}", describe_item(item)))?;
    }
    say(&format!("   model file: {}", model_path.display()))?;
    say("3. The model is compared with all records, beside the plain FV curve.\n")?;
    let model = model_file::read(&model_path)?;
    campaign.notes.extend(model.identification.right(&mut campaign.records));
    let compared = validate::compare(&model, &campaign)?;
    let validation = validation::validate(&compared)?;
    say(&validate::table(&validation))?;
    let report_path = args.output.join("report.html");
    let page = PageArgs::default();
    let input = ReportInput {
        print: page.print(),
        made: page.text.date.made(std::iter::once(model_path.clone()).chain(campaign.files.iter().cloned()))?,
        model_file: name_of(&model_path),
        data: data.named(),
        ..ReportInput::from_validation(&model, &campaign, &compared, &validation, page.text.words())?
    };
    dashpot_report::write_atomic(&input, &report_path)?;
    say(&format!("   report: {}\n", report_path.display()))?;
    let diagnosis_path = riddle::write(&args.output, args.seed)?;
    say(&format!("\nOpen the reports in a browser:\n  {}\n  {}", absolute(&report_path), absolute(&diagnosis_path)))
}

fn absolute(path: &std::path::Path) -> String {
    std::fs::canonicalize(path).unwrap_or_else(|_| path.to_path_buf()).display().to_string()
}
