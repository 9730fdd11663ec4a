//! `dashpot diagnose`: regions where model and records disagree, and the missing effect.

use super::data::{named, print_notes_of_groups, print_sign};
pub use super::diagnose_args::Args;
use super::diagnose_settings::{self, First};
use super::diagnosed::examine;
use super::{groups, model};
use crate::progress::Progress;
use anyhow::bail;
use dashpot_diagnosis::groups::{Comparison, Good, diagnose_groups};
use dashpot_diagnosis::{Diagnosis, Options, choose_left_out};
use dashpot_identification::model_file::ModelFile;
use dashpot_output::{FolderLock, Kind};
use dashpot_records::groups::split;
use dashpot_records::{Campaign, Record, agree_on_sign, hold_out};
use dashpot_report::groups::page;
use dashpot_report::words::TERMINAL;
use dashpot_report::{reading, write_workbook};
use std::cell::RefCell;
use std::path::{Path, PathBuf};

/// Returns for each test whether it is left out of all refits. Without `patterns`, selects some tests of every
/// amplitude and speed.
pub fn left_out(campaign: &Campaign, patterns: &[String], seed: u64) -> anyhow::Result<Vec<bool>> {
    let records: Vec<&Record> = campaign.records.iter().collect();
    if patterns.is_empty() {
        return Ok(choose_left_out(&records, seed));
    }
    Ok(hold_out::select_hold_out(campaign, patterns, "look at")?)
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
    let left = left_out(&campaign, &args.hold_out, args.seed)?;
    let mut files: Vec<PathBuf> = std::iter::once(&args.model).chain(&campaign.files).cloned().collect();
    let mut reference = Vec::new();
    if !args.reference.is_empty() {
        let mut good = args.data.load_reference(&args.reference)?;
        agree_on_sign(&mut [&mut campaign, &mut good]);
        print_sign(campaign.notes.iter().chain(&good.notes));
        campaign.also_without(good.unusable);
        files.extend(good.files);
        reference = good.records;
    }
    let note = model.identification.right(campaign.records.iter_mut().chain(&mut reference));
    note.iter().for_each(|note| dashpot_output::warn(&format!("note: {}", note.text)));
    campaign.notes.extend(note);
    let priors = super::dimensions::priors(args.dimensions.as_deref())?;
    let options = Options { max_effects: args.max_effects, candidates: args.candidates.clone(), reference, priors };
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

/// Writes the proposed tests as a test matrix. Returns a message on the result.
fn written_next_tests(path: &Path, found: &Diagnosis, campaign: &Campaign) -> anyhow::Result<String> {
    let Some((matrix, without)) = found.next_matrix() else {
        let others = if found.could_not_test.is_empty() {
            ""
        } else {
            "; the tests that would show further effects are listed under 'could not test'"
        };
        return Ok(format!(
            "next tests: no sine within the reach of these tests distinguishes the effects in question, so {} was not written{others}",
            path.display()
        ));
    };
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

/// Diagnoses every group against the reference, the first group or the preceding group, and writes the results.
fn of_groups(args: &Args, model: &ModelFile, by: &str) -> anyhow::Result<()> {
    let data = &args.data;
    let options = data.options()?;
    let mut good = None;
    if !args.reference.is_empty() {
        good = Some(Good { name: named(&args.reference), campaign: data.load_reference(&args.reference)? });
    }
    let reference = good.as_mut().map(|good| &mut good.campaign);
    let notes = RefCell::new(Vec::new());
    let split = split(&data.data, by, &|paths| data.read_one_of_many(paths, &options, &notes), reference)?;
    print_notes_of_groups(&notes.into_inner());
    print_sign(split.notes.iter().chain(good.iter().flat_map(|good| &good.campaign.notes)));
    let mut files: Vec<PathBuf> = std::iter::once(&args.model).chain(&split.files).cloned().collect();
    files.extend(good.iter().flat_map(|good| good.campaign.files.clone()));
    let options = Options {
        max_effects: args.max_effects,
        candidates: args.candidates.clone(),
        priors: super::dimensions::priors(args.dimensions.as_deref())?,
        ..Options::default()
    };
    let progress = Progress::new("diagnosing");
    let told = |done: f64, text: &str| progress.say(done, text);
    let comparison = if args.chain { Comparison::Chain } else { Comparison::Reference };
    let answers = diagnose_groups((split, by), good, comparison, model, options, args.seed, &told)?;
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
