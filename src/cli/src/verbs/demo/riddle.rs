//! Second half of the demo: a damper with an injected effect is measured, identified without the effect, and diagnosed.

use super::super::data::DataArgs;
use super::super::{diagnose, diagnosed, fit};
use crate::page::DateArgs;
use crate::progress::Progress;
use anyhow::Context as _;
use dashpot_diagnosis::Options as DiagnosisOptions;
use dashpot_identification::FitOptions;
use dashpot_identification::model_file;
use dashpot_records::hold_out;
use dashpot_report::diagnosis::picture;
use dashpot_report::words::EN;
use dashpot_report::{Print, replace_file};
use dashpot_rig::{CHECK_PREFIX, InjectedCase, Options, Plan};
use std::path::{Path, PathBuf};

/// Injected effect and its strength. A strength of 1 is a typical strong case.
const HIDDEN: (&str, f64) = ("free_play", 1.0);

/// Runs the second half of the demo and writes its results to a subfolder. Returns the path of the report.
pub fn write(folder: &Path, seed: u64) -> anyhow::Result<PathBuf> {
    let say = |text: &str| dashpot_output::say(None, text);
    let folder = folder.join("riddle");
    let in_folder = |name: &str| folder.join(name);
    let records = in_folder("records");
    std::fs::create_dir_all(&folder).with_context(|| format!("making the folder {}", folder.display()))?;
    say("4. Another damper hides something that its model will lack. What it is lies sealed beside the records.")?;
    let case = InjectedCase {
        effects: vec![(HIDDEN.0.to_owned(), HIDDEN.1)],
        plan: Plan::default(),
        options: Options { seed, ..Options::default() },
    };
    let progress = Progress::new("measuring");
    let measured = case.run_matrix(&case.plan.matrix(seed), |done, total| progress.count(done, total))?;
    measured.write(&records)?;
    drop(progress);
    let data = DataArgs::folder(records);
    let mut campaign = data.load()?;
    say(&format!("   {} tests in {}", campaign.records.len(), data.named()))?;

    say(&format!(
        "5. It is identified as the first was; the tests {CHECK_PREFIX}* are kept from everything that follows."
    ))?;
    let kept_back = [format!("{CHECK_PREFIX}*")];
    let model_path = in_folder("damper.toml");
    fit::identify(&hold_out::kept(&campaign, &kept_back)?, &FitOptions::default(), &model_path)?;
    let model = model_file::read(&model_path)?;
    campaign.notes.extend(model.identification.right(&mut campaign.records));
    say(&format!("   model file: {}", model_path.display()))?;

    say("6. Where do model and records disagree, and what is missing? (dashpot diagnose)\n")?;
    let left_out = diagnose::left_out(&campaign, &kept_back, seed)?;
    let diagnosed = diagnosed::examine(&model, &campaign, left_out, &DiagnosisOptions::default())?;
    say(&diagnosed.lines().join("\n"))?;
    dashpot_output::write(&in_folder("improved.toml"), diagnosed.model(&model, &campaign))?;
    dashpot_output::json(&in_folder("diagnosis.json"), &diagnosed.json())?;
    let report_path = in_folder("diagnosis.html");
    let made = DateArgs::default().made(std::iter::once(model_path.clone()).chain(campaign.files.iter().cloned()))?;
    diagnosed.report(&model_path, &data, &campaign, made, (&EN, Print::Brief), |report| report.write(&report_path))?;
    if let Some(svg) = picture(&diagnosed.found, &EN) {
        let path = in_folder("before-after.svg");
        replace_file(&path, svg.as_bytes()).with_context(|| format!("writing the figure {}", path.display()))?;
        say(&format!("\n   before and after: {}", path.display()))?;
    }
    let named: Vec<&str> = diagnosed.found.findings.iter().map(|f| f.effect).collect();
    let hidden: Vec<&str> = measured.truth.effects.iter().map(|e| e.name.as_str()).collect();
    let verdict = if named == hidden { "the diagnosis was right" } else { "the diagnosis was not right this time" };
    say(&format!("   The seal opened: hidden was {}; {verdict}.", hidden.join(", ")))?;
    Ok(report_path)
}
