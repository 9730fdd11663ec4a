//! `dashpot diagnose`: where model and records disagree, and which effect is missing.

use super::data::{DataArgs, matches, sign_in_words};
use super::output;
use crate::progress::Progress;
use anyhow::bail;
use dashpot_core::Params;
use dashpot_lab::diagnosis::{Diagnosis, Options, choose_held_out, diagnose};
use dashpot_lab::model_file;
use dashpot_lab::records::{Campaign, Record};
use std::path::{Path, PathBuf};

/// Find where a model and the records of its damper disagree, name the missing effect, and add it
///
/// Every effect in question is added and everything is refitted with it. What is named has to explain tests that no refit
/// has seen; where two effects explain the records as well, or none does, the answer says so.
#[derive(clap::Args)]
#[command(
    after_help = "Example:\n  dashpot diagnose damper.toml campaign/ -o improved.toml --report diagnosis.html --json diagnosis.json"
)]
pub struct Args {
    /// Model file
    #[arg(value_name = "MODEL")]
    model: PathBuf,
    #[command(flatten)]
    data: DataArgs,
    /// Model file to write, with the named effects added
    #[arg(short, long, value_name = "MODEL")]
    output: Option<PathBuf>,
    /// Findings as JSON; - for standard output
    #[arg(long, value_name = "F")]
    json: Option<PathBuf>,
    /// Report for people, one HTML file
    #[arg(long, value_name = "F.html")]
    report: Option<PathBuf>,
    /// Tests that no refit sees, by name; * stands for anything. Chosen over all amplitudes and speeds if not given
    #[arg(long, value_name = "GLOB", value_delimiter = ',')]
    hold_out: Vec<String>,
    /// Most effects to add
    #[arg(long, value_name = "N", default_value_t = 3)]
    max_effects: usize,
    /// Effects that may be named, separated by commas; all if not given
    #[arg(long, value_name = "NAME", value_delimiter = ',')]
    candidates: Option<Vec<String>>,
    /// Chooses which tests are left out
    #[arg(long, value_name = "N", default_value_t = 0)]
    seed: u64,
}

/// Which tests are left out: those named, or some of every amplitude and speed.
fn held_out(campaign: &Campaign, patterns: &[String], seed: u64) -> anyhow::Result<Vec<bool>> {
    let records: Vec<&Record> = campaign.records.iter().collect();
    if patterns.is_empty() {
        return Ok(choose_held_out(&records, seed));
    }
    if let Some(pattern) = patterns.iter().find(|p| !campaign.records.iter().any(|r| matches(r, &[(*p).clone()]))) {
        bail!("--hold-out {pattern:?} matches no test; the first is called {:?}", campaign.records[0].name);
    }
    let out: Vec<bool> = campaign.records.iter().map(|r| matches(r, patterns)).collect();
    if out.iter().all(|o| *o) {
        bail!("--hold-out leaves no test to look at; it matches all {}", out.len());
    }
    Ok(out)
}

/// The plain FV curve of a model, to compare with.
fn plain(model: &model_file::ModelFile) -> Params {
    if let Some(Ok(params)) = model.identification.fv_only.as_ref().map(|f| f.params()) {
        return params;
    }
    let mut params = model.params;
    params.disable_all();
    let _ = params.enable("fv_curve", true);
    let _ = params.enable("gas_preload", model.params.is_on("gas_preload"));
    params
}

/// Runs the verb.
pub fn run(args: &Args) -> anyhow::Result<()> {
    let (json, out) = (args.json.as_deref(), args.output.as_deref());
    let on_stdout = [out, json].into_iter().flatten().filter(|p| output::is_stdout(p)).count();
    if on_stdout > 1 {
        bail!("standard output takes one result: give -o or --json a file");
    }
    output::check([out, json, args.report.as_deref()].into_iter().flatten())?;
    let model = model_file::read(&args.model)?;
    let campaign = args.data.load()?;
    let left = held_out(&campaign, &args.hold_out, args.seed)?;
    let records: Vec<&Record> = campaign.records.iter().collect();
    let options = Options { max_effects: args.max_effects, candidates: args.candidates.clone() };
    let progress = Progress::new("diagnosing");
    let found = diagnose(&records, &left, &model.params, &options, &|done, text| progress.say(done, text))?;
    drop(progress);
    let say = |text: &str| output::say(if on_stdout > 0 { Some(Path::new("-")) } else { None }, text);
    say(&sign_in_words(&campaign.sign))?;
    for line in told(&found) {
        say(&line)?;
    }
    if let Some(path) = out {
        output::write(path, &model_file::write(&found.as_fit(&records, &left, plain(&model))))?;
        say(&format!("model in {}", path.display()))?;
    }
    if let Some(path) = json {
        output::json(path, &found)?;
    }
    Ok(())
}

/// The findings in lines.
fn told(found: &Diagnosis) -> Vec<String> {
    let mut lines = vec![found.summary.clone()];
    for region in found.regions.iter().take(5) {
        lines.push(format!("  where: {}", region.text));
    }
    for finding in &found.findings {
        let form = if finding.form.is_empty() { String::new() } else { format!(" ({})", finding.form) };
        lines.push(format!(
            "  {}{form}, {:.0} % sure: {}",
            finding.effect,
            100.0 * finding.confidence,
            finding.meaning
        ));
        for (name, v) in &finding.parameters {
            let far = if v.plausible { "" } else { "; no damper shows such a value" };
            lines.push(format!("    {name} = {:.4} {} (95 %: {:.4} to {:.4}){far}", v.value, v.unit, v.low, v.high));
        }
        for rival in finding.rivals.iter().take(2) {
            lines.push(format!("    not {}: {}", rival.effect, rival.why));
        }
    }
    for suspect in &found.suspects {
        lines.push(format!("  suspect {}: {}", suspect.effect, suspect.why));
    }
    let error = |f: &dashpot_lab::diagnosis::Figures| match f.held_out_rmse_n {
        Some(out) => format!("{:.2} N rms fitted, {out:.2} N left out, noise {:.2} N", f.rmse_n, f.noise_n),
        None => format!("{:.2} N rms, noise {:.2} N", f.rmse_n, f.noise_n),
    };
    lines.push(format!("  before: {}", error(&found.before)));
    if !found.findings.is_empty() {
        lines.push(format!("  after:  {}", error(&found.after)));
    }
    if let Some(gap) = found.gap_closed {
        lines.push(format!("  {:.0} % of the gap is closed on left-out tests", 100.0 * gap));
    }
    for shift in &found.shifts {
        lines
            .push(format!("  {} moved from {:.4} to {:.4} {}", shift.parameter, shift.before, shift.after, shift.unit));
    }
    for note in &found.notes {
        lines.push(format!("  note: {note}"));
    }
    for test in &found.next_tests {
        lines.push(format!("  next test: {}", test.text));
    }
    for effect in &found.could_not_test {
        lines.push(format!("  could not test {}: {}", effect.effect, effect.why));
    }
    lines
}
