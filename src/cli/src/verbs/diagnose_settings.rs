//! `dashpot diagnose` of a damper over a setting: a diagnosis at each setting, and one table of all settings.

use super::data::{DataArgs, name_of, named, print_sign};
use super::diagnose_args::Args;
use super::diagnosed::{Diagnosed, examine};
use super::model;
use crate::progress::Progress;
use anyhow::bail;
use dashpot_core::family::{Axis, LARGEST_SETTING};
use dashpot_diagnosis::settings::{
    OverSettings, SettingFigures, SettingPart, SettingsFigures, WithSettings, describe_unmeasured, is_shown,
    split_by_setting,
};
use dashpot_diagnosis::{Diagnosis, Options, choose_left_out};
use dashpot_identification::AS_THE_FIT_SAW;
use dashpot_identification::FitOptions;
use dashpot_identification::family::{fit_family, is_of_grid, model_file};
use dashpot_identification::model_file::{ModelFile, family_of_text, read_family};
use dashpot_identification::setting_units::restate_settings;
use dashpot_records::{Campaign, Note, Record, agree_on_sign, hold_out, setting_in_words};
use dashpot_report::diagnosis::{DiagnosisReport, SettingsReport, headline};
use dashpot_report::inventory::probability;
use dashpot_report::numbers::digits;
use dashpot_report::words::TERMINAL;
use dashpot_report::{parameters, reading, write_workbook};
use dashpot_simulation::comparison::settings_of;
use std::path::{Path, PathBuf};

/// Records at one setting, with the model at this setting.
struct Part {
    setting: f64,
    model: ModelFile,
    campaign: Campaign,
    left_out: Vec<bool>,
    reference: Vec<Record>,
}

/// Subject of the diagnosis: a model file, or a family fitted to the records.
struct Subject {
    model: ModelFile,
    /// Name of the model in reports.
    name: String,
    campaign: Campaign,
    /// Setting of tests that state none.
    given: Option<f64>,
    files: Vec<PathBuf>,
}

/// Rejects options that do not apply to several settings. The error proposes `dashpot setting`, with `what` as its model.
fn check(args: &Args, what: &str) -> anyhow::Result<()> {
    let one = format!("diagnose the damper at one setting: dashpot setting {what} VALUE -o one.toml");
    for (option, is_given, why) in [
        ("-o", args.output.is_some(), "writes an improved damper, and each setting may need another"),
        ("--next-tests", args.next_tests.is_some(), "writes a test matrix, which has no column for the setting"),
        ("--svg", args.svg.is_some(), "writes the figures of one diagnosis"),
        ("--group", args.group.is_some(), "splits the tests itself"),
    ] {
        if is_given {
            bail!("{option} {why}; {one}");
        }
    }
    Ok(())
}

/// Diagnoses an adjustable damper from a model file. `--setting` applies to tests that state no setting.
pub fn of_model(args: &Args, model: ModelFile) -> anyhow::Result<()> {
    check(args, &args.model.display().to_string())?;
    let given = match &args.setting {
        None => None,
        Some(text) => Some(text.parse::<f64>().ok().filter(|value| value.abs() <= LARGEST_SETTING).ok_or_else(|| {
            anyhow::anyhow!(
                "--setting is the setting of tests that say none, a number from -1e9 to 1e9, where a model is given; {text:?} is none"
            )
        })?),
    };
    // The records of the reference also affect the certainty of the sign, so [`run`] prints the warning about the sign later.
    let campaign = args.data.load_over_setting_like(&args.data.data)?;
    let name = name_of(&args.model);
    run(args, &args.data, Subject { model, name, campaign, given, files: vec![args.model.clone()] })
}

/// Fits an adjustable damper to the records and diagnoses it.
pub fn of_data(args: &Args, setting: &str) -> anyhow::Result<()> {
    check(args, "FAMILY")?;
    if setting.parse::<f64>().is_ok() {
        bail!("--setting {setting} needs a damper over a setting as MODEL; without one it is a name, such as current");
    }
    let mut data = args.data.clone();
    data.data.insert(0, args.model.clone());
    let campaign = data.load_over_setting_like(&data.data)?;
    let records: Vec<&Record> = campaign.records.iter().collect();
    let progress = Progress::new("fitting");
    let options =
        FitOptions { priors: super::dimensions::priors(args.dimensions.as_deref())?, ..FitOptions::default() };
    let found = fit_family(&records, setting, &options, |stage| progress.say(stage.done, stage.text.english()))?;
    drop(progress);
    let name = format!("family over {setting}");
    let model = family_of_text(&model_file::write(&found), Path::new(&name))?;
    run(args, &data, Subject { model, name, campaign, given: None, files: Vec::new() })
}

fn run(args: &Args, data: &DataArgs, subject: Subject) -> anyhow::Result<()> {
    let Subject { model, name, mut campaign, given, mut files } = subject;
    files.extend(campaign.files.iter().cloned());
    let mut good = None;
    if args.reference.is_empty() {
        print_sign(&campaign.notes);
    } else {
        let mut reference = data.load_reference_over_setting(&args.reference)?;
        agree_on_sign(&mut [&mut campaign, &mut reference]);
        print_sign(campaign.notes.iter().chain(&reference.notes));
        campaign.also_without(std::mem::take(&mut reference.unusable));
        files.extend(std::mem::take(&mut reference.files));
        good = Some(reference);
    }
    let others = good.iter_mut().flat_map(|good| &mut good.records);
    restate_settings(&model.axis, campaign.records.iter_mut().chain(others))?;
    let others = good.iter_mut().flat_map(|good| &mut good.records);
    let note = model.identification.right(campaign.records.iter_mut().chain(others));
    note.iter().for_each(|note| dashpot_output::warn(&format!("note: {}", note.text)));
    campaign.notes.extend(note);
    let mut parts = split(args, &model, &campaign, good.as_ref(), given)?;
    let unit = model.axis.unit();
    let of_parts = parts.iter().map(|part| part.setting);
    let unmeasured: Vec<f64> = of_parts.filter(|setting| !is_of_grid(model.axis.grid(), *setting)).collect();
    if !unmeasured.is_empty() {
        dashpot_output::warn(&format!("note: {}", describe_unmeasured(&model.axis, &unmeasured)));
    }
    for part in parts.iter_mut().filter(|part| unmeasured.contains(&part.setting)) {
        part.campaign.notes.push(Note { kind: "settings", text: describe_unmeasured(&model.axis, &[part.setting]) });
    }
    let priors = super::dimensions::priors(args.dimensions.as_deref())?;
    let mut found: Vec<(Part, Diagnosed)> = Vec::new();
    for mut part in parts {
        let options = Options {
            max_effects: args.max_effects,
            candidates: args.candidates.clone(),
            reference: std::mem::take(&mut part.reference),
            priors: priors.clone(),
        };
        let diagnosed = examine(&part.model, &part.campaign, part.left_out.clone(), &options)
            .map_err(|error| error.context(format!("at {}", setting_in_words(part.setting, unit))))?;
        found.push((part, diagnosed));
    }
    let answers: Vec<(f64, &Diagnosis)> = found.iter().map(|(part, one)| (part.setting, &one.found)).collect();
    let over = OverSettings::new(&answers, unit, good.is_some());
    let json = args.json.as_deref();
    dashpot_output::say(json, &reading::sign_in_words(&campaign.sign, &TERMINAL))?;
    dashpot_output::say(json, &format_settings(&model.axis, &over, &found).join("\n"))?;
    if let Some(path) = json {
        let as_the_fit_saw = campaign.notes.iter().find(|n| n.kind == AS_THE_FIT_SAW).map(|n| &n.text);
        let figures = found.iter().map(|(part, one)| SettingFigures::new(&model.axis, part.setting, one.json()));
        let beside = (as_the_fit_saw, campaign.unusable.as_slice());
        dashpot_output::json(path, &SettingsFigures::new(&model.axis, &over, figures.collect(), beside))?;
    }
    if args.report.is_none() && args.excel.is_none() {
        return Ok(());
    }
    let (words, print) = args.page.words_and_print();
    let records: Vec<Vec<&Record>> = found.iter().map(|(part, _)| part.campaign.records.iter().collect()).collect();
    let made = args.page.text.date.made(files)?;
    let settings = found.iter().zip(&records).map(|((part, one), records)| {
        let report = DiagnosisReport {
            model_file: name.clone(),
            data: data.named(),
            found: &one.found,
            records,
            reading: reading::sentences(&part.campaign, words),
            over_whole_records: one.over_whole_records,
            parameters: parameters::of_diagnosis(&one.found, words),
            made: made.clone(),
            print,
            words,
        };
        (part.setting, report)
    });
    let report = SettingsReport {
        model_file: name.clone(),
        data: data.named(),
        unit: unit.to_owned(),
        over: &over,
        settings: settings.collect(),
        made: made.clone(),
        print,
        words,
    };
    if let Some(path) = &args.report {
        dashpot_output::write(path, report.render())?;
        dashpot_output::say(json, &format!("report: {}", path.display()))?;
    }
    if let Some(path) = &args.excel {
        write_workbook(&report.workbook(), path)?;
        dashpot_output::say(json, &format!("workbook: {}", path.display()))?;
    }
    Ok(())
}

/// Splits the records by setting. Each part contains the model at the part's setting. The lowest setting comes first.
fn split(
    args: &Args,
    model: &ModelFile,
    campaign: &Campaign,
    good: Option<&Campaign>,
    given: Option<f64>,
) -> anyhow::Result<Vec<Part>> {
    let settings = settings_of(model, campaign, given)?;
    let of_good = good.map(|good| settings_of(model, good, given)).transpose()?;
    let own = WithSettings { records: &campaign.records, settings: &settings };
    let compared = good.zip(of_good.as_deref());
    let compared = compared.map(|(good, settings)| WithSettings { records: &good.records, settings });
    let parts = split_by_setting(&model.definition(), own, compared).map_err(|setting| {
        anyhow::anyhow!(
            "{} has no test at {}; give --reference a campaign of the same settings, or leave these tests out with --exclude",
            named(&args.reference),
            setting_in_words(setting, model.axis.unit())
        )
    })?;
    let changing: Vec<&str> =
        campaign.records.iter().zip(&settings).filter(|(_, s)| s.is_none()).map(|(r, _)| r.name.as_str()).collect();
    if !changing.is_empty() {
        dashpot_output::warn(&format!(
            "note: the setting changes within {} tests, which are not diagnosed: {}; whether the valve responds as before is no part of this answer, dashpot validate shows its response times",
            changing.len(),
            changing.join(", ")
        ));
    }
    if parts.is_empty() {
        bail!("no test has a constant {}, and a damper is diagnosed at constant settings", model.axis.name());
    }
    let (low, high) = model.axis.range();
    if let Some(beyond) = parts.iter().map(|part| part.setting).find(|setting| *setting < low || *setting > high) {
        let unit = model.axis.unit();
        dashpot_output::warn(&format!(
            "warning: tests at {} lie outside the settings of the model, {low} to {high}, and are diagnosed with the damper at the nearest",
            setting_in_words(beyond, unit)
        ));
    }
    let held_out = match args.hold_out.is_empty() {
        true => None,
        false => Some(hold_out::select_hold_out(campaign, &args.hold_out, "look at")?),
    };
    let part = |of: SettingPart| Part {
        setting: of.setting,
        left_out: match &held_out {
            Some(out) => of.places.iter().map(|k| out[*k]).collect(),
            None => choose_left_out(&of.records.iter().collect::<Vec<_>>(), args.seed),
        },
        model: ModelFile {
            params: of.params,
            axis: Axis::NONE,
            identification: model.identification.clone(),
            specified: model.specified.clone(),
            edited: model.edited.clone(),
        },
        campaign: Campaign { records: of.records, unusable: Vec::new(), ..campaign.clone() },
        reference: of.reference,
    };
    Ok(parts.into_iter().map(part).collect())
}

/// Formats the results: the summary, one table over the settings, and the diagnosis at each setting.
fn format_settings(axis: &Axis, over: &OverSettings, found: &[(Part, Diagnosed)]) -> Vec<String> {
    const WIDTH: usize = 16;
    const ALL: &str = "at all settings";
    let unit = axis.unit();
    let mut lines: Vec<String> = over.summary.iter().map(ToString::to_string).collect();
    if !(over.effects.is_empty() && over.changes.is_empty()) {
        let mut heading = format!("  {:<26}", "probability, N rms");
        for (part, _) in found {
            heading += &format!("{:>WIDTH$}", setting_in_words(part.setting, unit));
        }
        lines.push(heading);
    }
    let cell = |of: f64, force: f64, mark: &str| {
        format!("{}, {}{mark}", probability(of).replace('\u{a0}', ""), digits(force, 3))
    };
    let row = |name: &str, at: &dyn Fn(f64) -> Option<String>, remarks: &[Option<&str>]| {
        let mut line = format!("  {name:<26}");
        for (part, _) in found {
            line += &format!("{:>WIDTH$}", at(part.setting).unwrap_or_else(|| "-".to_owned()));
        }
        let remarks: Vec<&str> = remarks.iter().flatten().copied().collect();
        format!("{line}  {}", remarks.join(", ")).trim_end().to_owned()
    };
    for of in &over.changes {
        let at = |setting: f64| {
            let at = of.settings.iter().find(|at| at.setting == setting)?;
            Some(cell(at.change.probability, at.change.force_n_rms, ""))
        };
        lines.push(row(of.name, &at, &[Some("changed"), of.at_all_settings.then_some(ALL)]));
    }
    for of in &over.effects {
        let at = |setting: f64| {
            let at = of.settings.iter().find(|at| at.setting == setting)?;
            Some(cell(at.probability, at.force_n_rms, if is_shown(at.status) { "" } else { " out" }))
        };
        let found = match () {
            () if of.is_found => Some("found"),
            () if of.is_added() => Some("added, not named"),
            () => None,
        };
        lines.push(row(of.effect, &at, &[found, of.at_all_settings.then_some(ALL)]));
    }
    for (part, one) in found {
        let tests = part.campaign.records.len();
        let setting = setting_in_words(part.setting, unit);
        lines.push(format!("{setting}, {tests} tests: {}", headline(&one.found, &TERMINAL)));
    }
    lines.extend(notes_of_settings(unit, found));
    lines
}

/// Returns each note of the diagnoses once. A note that does not apply to all settings begins with a list of its settings.
fn notes_of_settings(unit: &str, found: &[(Part, Diagnosed)]) -> Vec<String> {
    let mut all: Vec<(String, Vec<String>)> = Vec::new();
    for (part, one) in found {
        for note in one.found.notes.iter().map(ToString::to_string) {
            let setting = setting_in_words(part.setting, unit);
            match all.iter_mut().find(|(known, _)| *known == note) {
                Some((_, settings)) => settings.push(setting),
                None => all.push((note, vec![setting])),
            }
        }
    }
    let line = |(note, settings): (String, Vec<String>)| match settings.len() == found.len() {
        true => format!("note: {note}"),
        false => format!("note: {}: {note}", settings.join(", ")),
    };
    all.into_iter().map(line).collect()
}

/// Kind of the first argument of `dashpot diagnose`.
pub enum First {
    /// A model file whose parameters depend on a setting (adjustable damper).
    Family(Box<ModelFile>),
    /// A model file of an ordinary damper.
    Ordinary,
    /// Records.
    Data,
}

/// Determines the kind of the first argument. With `--setting`, everything except a `.toml` file contains records.
pub fn first_argument(args: &Args) -> anyhow::Result<First> {
    let is_model = args.model.is_file() && args.model.extension().is_some_and(|ending| ending == "toml");
    if !is_model && args.setting.is_some() {
        return Ok(First::Data);
    }
    let is_family = read_family(&args.model)?.axis.is_some();
    // The caller prints the notes on the file of an ordinary damper, so they are not printed here.
    Ok(if is_family { First::Family(Box::new(model::read_family(&args.model)?)) } else { First::Ordinary })
}
