//! `dashpot diagnose`: where model and records disagree, and which effect is missing.

use super::data::{DataArgs, name_of, named, print_sign};
use super::diagnose_settings::{self, First};
use super::{groups, model};
use crate::page::PageArgs;
use crate::progress::Progress;
use anyhow::bail;
use dashpot_diagnosis::groups::{Good, diagnose_groups};
use dashpot_diagnosis::{Diagnosis, Figures, Finding, InventoryItem, Options, Status, choose_held_out, diagnose};
use dashpot_identification::AS_THE_FIT_SAW;
use dashpot_identification::model_file::{self, ModelFile};
use dashpot_output::{FolderLock, Kind};
use dashpot_records::groups::split;
use dashpot_records::{Campaign, Record, Sentence, Unusable, agree_on_sign, hold_out};
use dashpot_report::diagnosis::{DiagnosisReport, headline};
use dashpot_report::groups::page;
use dashpot_report::numbers::{digits, fraction, with_interval, with_unit};
use dashpot_report::whole_records;
use dashpot_report::words::{TERMINAL, Words};
use dashpot_report::{Made, Print, parameters, reading, write_workbook};
use dashpot_simulation::whole_records::OfDiagnosis;
use serde::Serialize;
use std::path::{Path, PathBuf};

/// Find where a model and the records of its damper disagree, name the missing effect, and add it
///
/// Every effect in question is added and everything is refitted with it. What is named has to explain tests that no refit
/// has seen; where two effects explain the records as well, or none does, the answer says so.
#[derive(clap::Args)]
#[command(
    mut_arg("data", |data| data.required(false).required_unless_present("setting")),
    after_help = "Examples:\n  dashpot diagnose damper.toml campaign/ -o improved.toml --report diagnosis.html --json diagnosis.json --excel diagnosis.xlsx\n  dashpot diagnose damper.toml fleet/ --group folders --reference good/ --report fleet.html\n  dashpot diagnose family.toml campaign/ --json diagnosis.json\n  dashpot diagnose campaign/ --setting current --report diagnosis.html"
)]
pub struct Args {
    /// Model file
    #[arg(value_name = "MODEL")]
    pub model: PathBuf,
    #[command(flatten)]
    pub data: DataArgs,
    /// Model file to write, with the named effects added
    #[arg(short, long, value_name = "MODEL")]
    pub output: Option<PathBuf>,
    /// Findings as JSON; - for standard output
    #[arg(long, value_name = "F")]
    pub json: Option<PathBuf>,
    /// Report for people, one HTML file
    #[arg(long, value_name = "F.html")]
    pub report: Option<PathBuf>,
    /// Every table as a sheet of one Excel workbook, numbers as numbers
    #[arg(long, value_name = "F.xlsx")]
    pub excel: Option<PathBuf>,
    /// The tests that would tell more, as a test matrix for the rig
    #[arg(long, value_name = "F.csv")]
    pub next_tests: Option<PathBuf>,
    /// Folder for every figure of the report as an SVG file
    #[arg(long, value_name = "DIR")]
    pub svg: Option<PathBuf>,
    /// Tests that no refit sees, by name; * stands for anything. Chosen over all amplitudes and speeds if not given
    #[arg(long, value_name = "GLOB", value_delimiter = ',')]
    pub hold_out: Vec<String>,
    /// Most effects to add
    #[arg(long, value_name = "N", default_value_t = 3, allow_negative_numbers = true)]
    pub max_effects: usize,
    /// Effects that may be named, separated by commas; all if not given
    #[arg(long, value_name = "NAME", value_delimiter = ',')]
    pub candidates: Option<Vec<String>>,
    /// Records of the same tests on a damper known to be good: a folder or file; may be given several times. The question is then what
    /// changed, and what the model's form leaves on both dampers alike is taken out of it: the surest way wherever there is one
    #[arg(long, value_name = "GOOD")]
    pub reference: Vec<PathBuf>,
    /// Many dampers or settings at once, each compared with the reference, or with the first where none is given. The word folders: every
    /// folder in DATA is one. Or a pattern of the tests' names with {} where the group stands, such as '*_c{}_*'. Or a list (CSV with a heading,
    /// tests or folders in its first column) and the column that tells the groups apart, such as tests.csv:clicks
    #[arg(long, value_name = "BY", conflicts_with_all = ["output", "svg", "hold_out", "next_tests"])]
    pub group: Option<String>,
    /// Of a damper over a setting: the setting of tests that say none. Without a model, the name of the setting (current, clicks): the
    /// damper over it is fitted to DATA first
    #[arg(long, value_name = "VALUE|NAME", allow_hyphen_values = true)]
    pub setting: Option<String>,
    /// Chooses which tests are left out
    #[arg(long, value_name = "N", default_value_t = 0, allow_negative_numbers = true)]
    pub seed: u64,
    #[command(flatten)]
    pub page: PageArgs,
}

/// Which tests are left out: those named, or some of every amplitude and speed.
pub fn held_out(campaign: &Campaign, patterns: &[String], seed: u64) -> anyhow::Result<Vec<bool>> {
    let records: Vec<&Record> = campaign.records.iter().collect();
    if patterns.is_empty() {
        return Ok(choose_held_out(&records, seed));
    }
    Ok(hold_out::select_hold_out(campaign, patterns, "look at")?)
}

/// A diagnosis with what it was made from.
pub struct Diagnosed {
    /// The answer.
    pub found: Diagnosis,
    /// Which records no refit saw.
    pub left_out: Vec<bool>,
    /// What `dashpot validate` says of the models in it.
    pub over_whole_records: OfDiagnosis,
    /// What the model's fit found in its own records, and whether it was taken out of these.
    pub as_the_fit_saw: Option<Sentence>,
    /// Files and tests that could not be used, of the reference too.
    pub unusable: Vec<Unusable>,
}

/// The findings as JSON, with the errors over whole records.
#[derive(Serialize)]
pub struct Json<'a> {
    #[serde(flatten)]
    found: &'a Diagnosis,
    over_whole_records: OfDiagnosis,
    #[serde(skip_serializing_if = "Option::is_none")]
    as_the_fit_saw: Option<&'a Sentence>,
    unusable: &'a [Unusable],
}

/// Diagnoses a model against a campaign.
pub fn examine(
    model: &ModelFile,
    campaign: &Campaign,
    left_out: Vec<bool>,
    options: &Options,
) -> anyhow::Result<Diagnosed> {
    let records: Vec<&Record> = campaign.records.iter().collect();
    let progress = Progress::new("diagnosing");
    let found =
        diagnose(&records, &left_out, &model.params, options, &|done, text| progress.say(done, text.english()))?;
    let over_whole_records =
        OfDiagnosis::evaluate(&model.params, &found.base, &found.improved, &found.measured, &records)?;
    let as_the_fit_saw = campaign.notes.iter().find(|n| n.kind == AS_THE_FIT_SAW).map(|n| n.text.clone());
    let unusable = campaign.unusable.clone();
    Ok(Diagnosed { found, left_out, over_whole_records, as_the_fit_saw, unusable })
}

impl Diagnosed {
    /// As JSON.
    pub fn json(&self) -> Json<'_> {
        Json {
            found: &self.found,
            over_whole_records: self.over_whole_records,
            as_the_fit_saw: self.as_the_fit_saw.as_ref(),
            unusable: &self.unusable,
        }
    }

    /// In lines.
    pub fn lines(&self) -> Vec<String> {
        let mut lines = format_diagnosis(&self.found);
        lines.push(whole_records::format_errors(&self.over_whole_records, &TERMINAL));
        lines
    }

    /// The improved model as the text of a model file.
    pub fn model(&self, model: &ModelFile, campaign: &Campaign) -> String {
        let records: Vec<&Record> = campaign.records.iter().collect();
        model_file::write(&self.found.as_fit(&records, &self.left_out, model))
    }

    /// Hands the report over to `write`.
    pub fn report<T>(
        &self,
        model: &Path,
        data: &DataArgs,
        campaign: &Campaign,
        made: Made,
        (words, print): (&'static Words, Print),
        write: impl FnOnce(&DiagnosisReport<'_>) -> anyhow::Result<T>,
    ) -> anyhow::Result<T> {
        let records: Vec<&Record> = campaign.records.iter().collect();
        write(&DiagnosisReport {
            model_file: name_of(model),
            data: data.named(),
            found: &self.found,
            records: &records,
            reading: reading::sentences(campaign, words),
            over_whole_records: self.over_whole_records,
            parameters: parameters::of_diagnosis(&self.found, words),
            made,
            print,
            words,
        })
    }
}

/// Runs the verb.
pub fn run(args: &Args) -> anyhow::Result<()> {
    let (json, out) = (args.json.as_deref(), args.output.as_deref());
    let on_stdout = [out, json].into_iter().flatten().filter(|p| dashpot_output::is_stdout(p)).count();
    if on_stdout > 1 {
        bail!("standard output takes one result: give -o or --json a file");
    }
    for (option, path) in [("--report", &args.report), ("--excel", &args.excel)] {
        if path.as_deref().is_some_and(dashpot_output::is_stdout) {
            bail!("{option} needs a file name: standard output takes findings (--json -) or the model (-o -)");
        }
    }
    dashpot_output::check_kinds([
        (out, Kind::Model),
        (json, Kind::Figures),
        (args.report.as_deref(), Kind::Report),
        (args.excel.as_deref(), Kind::Workbook),
    ])?;
    let _held = args.svg.as_deref().map(FolderLock::take).transpose()?;
    match (diagnose_settings::first_argument(args)?, &args.setting) {
        (First::Family(family), _) => return diagnose_settings::of_model(args, *family),
        (First::Data, Some(name)) => return diagnose_settings::of_data(args, name),
        (First::Ordinary, Some(_)) => bail!("{} depends on no setting; leave --setting out", args.model.display()),
        _ => {}
    }
    let model = model::read(&args.model)?;
    if let Some(by) = &args.group {
        return of_groups(args, &model, by);
    }
    let mut campaign = args.data.load_like(&args.data.data)?;
    if args.reference.is_empty() {
        print_sign(&campaign.notes);
    }
    let left = held_out(&campaign, &args.hold_out, args.seed)?;
    let mut files: Vec<PathBuf> = std::iter::once(&args.model).chain(&campaign.files).cloned().collect();
    let mut reference = Vec::new();
    if !args.reference.is_empty() {
        let mut good = args.data.load_like(&args.reference)?;
        agree_on_sign(&mut [&mut campaign, &mut good]);
        print_sign(campaign.notes.iter().chain(&good.notes));
        campaign.also_without(good.unusable);
        files.extend(good.files);
        reference = good.records;
    }
    let note = model.identification.right(campaign.records.iter_mut().chain(&mut reference));
    note.iter().for_each(|note| dashpot_output::warn(&format!("note: {}", note.text)));
    campaign.notes.extend(note);
    let options = Options { max_effects: args.max_effects, candidates: args.candidates.clone(), reference };
    let diagnosed = examine(&model, &campaign, left, &options)?;
    let say = |text: &str| dashpot_output::say(if on_stdout > 0 { Some(Path::new("-")) } else { None }, text);
    say(&reading::sign_in_words(&campaign.sign, &TERMINAL))?;
    say(&diagnosed.lines().join("\n"))?;
    if let Some(path) = out {
        dashpot_output::write(path, diagnosed.model(&model, &campaign))?;
        if !dashpot_output::is_stdout(path) {
            say(&format!("model: {}", path.display()))?;
        }
    }
    if let Some(path) = json {
        dashpot_output::json(path, &diagnosed.json())?;
    }
    if let Some(path) = &args.next_tests {
        say(&written_next_tests(path, &diagnosed.found, &campaign)?)?;
    }
    if args.report.is_none() && args.excel.is_none() && args.svg.is_none() {
        return Ok(());
    }
    let made = args.page.text.date.made(files)?;
    diagnosed.report(&args.model, &args.data, &campaign, made, args.page.words_and_print(), |report| {
        if let Some(path) = &args.report {
            report.write(path)?;
            say(&format!("report: {}", path.display()))?;
        }
        if let Some(path) = &args.excel {
            write_workbook(&report.workbook(), path)?;
            say(&format!("workbook: {}", path.display()))?;
        }
        if let Some(folder) = &args.svg {
            let written = report.write_svgs(folder)?;
            say(&format!("{} figures in {}", written.len(), folder.display()))?;
        }
        Ok(())
    })
}

/// Writes the tests that would tell more as a matrix; the answer says what was written.
fn written_next_tests(path: &Path, found: &Diagnosis, campaign: &Campaign) -> anyhow::Result<String> {
    let Some((matrix, without)) = found.next_matrix() else {
        return Ok(format!(
            "next tests: there is none that a rig could be driven by, so {} was not written",
            path.display()
        ));
    };
    let matrix = campaign.frame.matrix(&matrix);
    dashpot_output::write(path, &matrix)?;
    let besides = if without == 0 {
        String::new()
    } else {
        format!("; {without} more are no sine and stand in the report alone")
    };
    Ok(format!(
        "next tests: {} rows in {}, as the files count ({} positive) and within what they reach{besides}",
        matrix.lines().count() - 1,
        path.display(),
        campaign.sign.positive.name()
    ))
}

/// Diagnoses every group against the reference.
fn of_groups(args: &Args, model: &ModelFile, by: &str) -> anyhow::Result<()> {
    let data = &args.data;
    let options = data.options()?;
    let mut good = None;
    if !args.reference.is_empty() {
        good = Some(Good { name: named(&args.reference), campaign: data.load_like(&args.reference)? });
    }
    let reference = good.as_mut().map(|good| &mut good.campaign);
    let split = split(&data.data, by, &|paths| data.read(paths, &options), reference)?;
    print_sign(split.notes.iter().chain(good.iter().flat_map(|good| &good.campaign.notes)));
    let mut files: Vec<PathBuf> = std::iter::once(&args.model).chain(&split.files).cloned().collect();
    files.extend(good.iter().flat_map(|good| good.campaign.files.clone()));
    let options = Options { max_effects: args.max_effects, candidates: args.candidates.clone(), ..Options::default() };
    let progress = Progress::new("diagnosing");
    let told = |done: f64, text: &str| progress.say(done, text);
    let answers = diagnose_groups((split, by), good, model, options, args.seed, &told)?;
    drop(progress);
    let json = args.json.as_deref();
    dashpot_output::say(json, &groups::format_groups(&answers).join("\n"))?;
    if let Some(path) = json {
        dashpot_output::json(path, &answers)?;
    }
    if args.report.is_none() && args.excel.is_none() {
        return Ok(());
    }
    let page = page(&answers, &args.model, args.page.text.date.made(files)?, args.page.text.words());
    if let Some(path) = &args.report {
        dashpot_output::write(path, page.render())?;
        dashpot_output::say(json, &format!("report: {}", path.display()))?;
    }
    if let Some(path) = &args.excel {
        write_workbook(&page.workbook(), path)?;
        dashpot_output::say(json, &format!("workbook: {}", path.display()))?;
    }
    Ok(())
}

/// Most regions, rivals and tests told on a terminal; the report has them all.
const REGIONS: usize = 5;
const RIVALS: usize = 2;
const NEXT: usize = 3;

/// The findings in lines.
pub fn format_diagnosis(found: &Diagnosis) -> Vec<String> {
    let mut lines = vec![headline(found, &TERMINAL)];
    if !found.inventory.is_empty() {
        lines.push(format!("  {:<28} {:>10} {:>6} {:>12}  {}", "inventory", "N rms", "force", "probability", "status"));
    }
    lines.extend(found.inventory.iter().map(inventory_line));
    if !found.regions.is_empty() {
        lines.push("Where the model disagrees, refitted to these tests:".to_owned());
        lines.extend(found.regions.iter().take(REGIONS).map(|region| format!("  {}", region.text)));
    }
    for finding in &found.findings {
        lines.extend(one(finding));
    }
    let of = if found.findings.is_empty() { "" } else { " of what is left" };
    for suspect in &found.suspects {
        lines.push(format!("Suspect{of}, {}: {}", suspect.effect, suspect.why));
    }
    lines.extend(errors(found));
    if !found.shifts.is_empty() {
        lines.push("Numbers of the model that moved:".to_owned());
    }
    for shift in &found.shifts {
        let (before, after) = (with_unit(shift.before, shift.unit), with_unit(shift.after, shift.unit));
        lines.push(format!("  {:<30} {before:>16} -> {after}", shift.parameter));
    }
    if !found.changes.is_empty() {
        lines.push("Numbers that are others than on the reference damper:".to_owned());
    }
    for change in &found.changes {
        let (value, interval) = with_interval(change.value, change.low, change.high, change.unit, &TERMINAL);
        let before = with_unit(change.reference, change.unit);
        lines.push(format!("  {:<30} {before:>16} -> {value}  95 %: {interval}", change.label()));
    }
    lines.extend(found.notes.iter().map(|note| format!("note: {note}")));
    lines.extend(found.next_tests.iter().take(NEXT).map(|test| format!("next test: {}", test.text)));
    lines.extend(found.could_not_test.iter().map(|c| format!("could not test {}: {}", c.effect, c.why)));
    lines
}

fn one(finding: &Finding) -> Vec<String> {
    let form = if finding.form.is_empty() { String::new() } else { format!(" ({})", finding.form) };
    let mut lines =
        vec![format!("Found {}{form}, {} sure: {}", finding.effect, fraction(finding.confidence), finding.meaning)];
    lines.push(format!(
        "  where: {}, family {} ({} sure); {} of the disagreement opens again without it",
        finding.path,
        finding.family,
        fraction(finding.family_confidence),
        fraction(finding.share)
    ));
    for (name, v) in &finding.parameters {
        let far = if v.plausible { "" } else { "; outside what dampers and rigs show" };
        let (value, interval) = with_interval(v.value, v.low, v.high, v.unit, &TERMINAL);
        lines.push(format!("  {name:<30} {value:>16}  95 %: {interval}{far}"));
    }
    if let Some(gap) = finding.gap_closed {
        lines.push(format!("  closes {} of the gap by itself", fraction(gap)));
    }
    if finding.of_the_rig {
        lines.push("  of the rig: corrected in the comparison, not put into the model".to_owned());
    }
    lines.extend(finding.rivals.iter().take(RIVALS).map(|rival| format!("  not {}: {}", rival.effect, rival.why)));
    lines
}

/// Errors before and after as a small table.
fn errors(found: &Diagnosis) -> Vec<String> {
    let row = |name: &str, f: &Figures| {
        let optional = |value: Option<f64>| value.map_or_else(|| "–".to_owned(), |v| digits(v, 3));
        let (left, left_noise) = (optional(f.held_out_rmse_n), optional(f.held_out_noise_n));
        format!("  {name:<10}{:>10}{:>10}{left:>10}{left_noise:>10}", digits(f.rmse_n, 3), digits(f.noise_n, 3))
    };
    let mut lines = vec![
        format!("  {:<10}{:>10}{:>10}{:>10}{:>10}", "N rms", "fitted", "noise", "left out", "noise"),
        row("before", &found.before),
    ];
    if !found.findings.is_empty() {
        lines.push(row("after", &found.after));
    }
    if let Some(gap) = found.gap_closed {
        let tests = if found.after.held_out_rmse_n.is_some() { "left-out" } else { "fitted" };
        lines.push(format!(
            "  {} of the gap is closed on {tests} tests, each counted in units of its own noise",
            fraction(gap)
        ));
    }
    lines
}

/// One effect of the inventory: force, fraction of the measured force, probability, and what became of it.
fn inventory_line(item: &InventoryItem) -> String {
    let status = match (item.status, item.replaces) {
        (_, Some(old)) => format!("added, in place of {old}"),
        (Status::Kept, None) => "kept".to_owned(),
        (Status::Added, None) => "added".to_owned(),
        (Status::Replaced, None) => "replaced".to_owned(),
        (Status::Removed, None) => "removed".to_owned(),
    };
    let form = if item.form.is_empty() { String::new() } else { format!(" ({})", item.form) };
    let (force, part, probability) = (digits(item.force_n_rms, 3), fraction(item.share), fraction(item.probability));
    format!("  {:<28} {force:>10} {part:>6} {probability:>12}  {status}{form}", item.effect)
}
