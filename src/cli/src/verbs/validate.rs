//! `dashpot validate`: comparison of a model with records and with the FV curve.

use super::Verdict;
use super::data::{DataArgs, name_of};
use super::model;
use crate::page::PageArgs;
use crate::progress::Progress;
use crate::quantity::SettingText;
use anyhow::bail;
use dashpot_core::Model;
use dashpot_identification::AS_THE_FIT_SAW;
use dashpot_identification::limits::{self, Limit};
use dashpot_identification::model_file::{ModelFile, prepared};
use dashpot_identification::validation::{
    Against, AgainstSummary, Compared, ResponseTimes, StepResponse, TimeUncertainty, Validation, validate,
};
use dashpot_output::{FolderLock, Kind};
use dashpot_records::{Campaign, Record, setting_in_words};
use dashpot_report::against::{Rival, section};
use dashpot_report::certificate::{self, CertificateInput};
use dashpot_report::numbers::digits;
use dashpot_report::{FamilyReport, ReportInput};
use dashpot_simulation::against::{self, FITTED_TO_ALL, Rivals};
use dashpot_simulation::comparison;
use std::path::{Path, PathBuf};

/// Compare a model with records, and with the plain FV curve that is fitted to the same data
///
/// Reports errors by amplitude and by peak velocity, hysteresis, and plots. Tests that the fit used are separate from other tests.
#[derive(clap::Args)]
#[command(
    after_help = "Examples:\n  dashpot validate damper.toml campaign/ --report report.html --json errors.json --excel tables.xlsx\n  dashpot validate damper.toml \
                  campaign/ --limits limits.csv --certificate certificate.html\n  dashpot validate family.toml campaign/ --setting 0.5\n\nWith --limits it ends with 0 where the damper keeps \
                  them all, with 1 where it does not or not all could be tested, and with 2 on an error."
)]
pub struct Args {
    /// Model file
    #[arg(value_name = "MODEL")]
    model: PathBuf,
    #[command(flatten)]
    data: DataArgs,
    /// Figures as JSON; - for standard output
    #[arg(long, value_name = "F")]
    json: Option<PathBuf>,
    /// Report with tables and plots, one file that needs no network
    #[arg(long, value_name = "F.html")]
    report: Option<PathBuf>,
    /// Every table as a sheet of one Excel workbook, with numeric cells
    #[arg(long, value_name = "F.xlsx")]
    excel: Option<PathBuf>,
    /// Models of the literature for comparison, identified from the tests to which MODEL was fitted. One or more of fv, piecewise, lag,
    /// surface, dahl, bouc-wen, spencer, kwok, network, separated by commas; all; or a file that dashpot fit --model wrote
    #[arg(long, value_name = "NAME", value_delimiter = ',')]
    against: Vec<String>,
    /// Folder for every figure of the report as an SVG file
    #[arg(long, value_name = "DIR")]
    svg: Option<PathBuf>,
    /// Setting of tests that state none, for a model that depends on a setting
    #[arg(long, value_name = "VALUE", allow_negative_numbers = true)]
    setting: Option<SettingText>,
    /// Limits for the damper: a table with the columns quantity, velocity_m_s, low and high. The command reports whether the damper passes.
    /// Quantities are force, gas_force, friction and hysteresis. A damper over a setting also has response_time_up, response_time_down,
    /// rise_time_up and rise_time_down. A damper that depends on a setting has a column setting
    #[arg(long, value_name = "F.csv")]
    limits: Option<PathBuf>,
    /// Write the verdict on the limits of --limits as a separate page
    #[arg(long, value_name = "F.html", requires = "limits")]
    certificate: Option<PathBuf>,
    #[command(flatten)]
    page: PageArgs,
}

/// Runs the verb.
pub fn run(args: &Args) -> anyhow::Result<Verdict> {
    check_outputs(args)?;
    let mut windows = args.limits.as_deref().map(limits::read).transpose()?;
    let _held = args.svg.as_deref().map(FolderLock::take).transpose()?;
    against::named(&args.against)?;
    let model = model::read_family(&args.model)?;
    let is_family = model.axis.is_some();
    let setting = read_setting(args, &model)?;
    match &mut windows {
        Some(windows) if is_family => limits::restate_settings_of_limits(windows, model.axis.unit())?,
        Some(windows) => limits::check_without_setting(windows)?,
        None => {}
    }
    let campaign = args.data.load_for(&model)?;
    let is_stated = |record: &Record| record.setting.is_some() || record.setting_signal.is_some();
    if setting.is_some() && campaign.records.iter().all(is_stated) {
        dashpot_output::warn(
            "note: every test states its own setting, which counts; --setting is that of tests that state none",
        );
    }
    let compared = if is_family { compare_family(&model, &campaign, setting)? } else { compare(&model, &campaign)? };
    let mut validation = validate(&compared)?;
    let settings = match is_family {
        true => comparison::summarize_settings(&mut validation, &model, (&campaign, &compared), setting)?,
        false => Vec::new(),
    };
    if let (true, Some(windows)) = (is_family, &windows) {
        limits::check_over_settings(windows, &settings)?;
    }
    validation.as_the_fit_saw = campaign.notes.iter().find(|n| n.kind == AS_THE_FIT_SAW).map(|n| n.text.clone());
    validation.unusable.clone_from(&campaign.unusable);
    let mut run = Run { args, model: &model, campaign: &campaign, compared: &compared, validation };
    run.print_errors()?;
    let rivals = run.compare_with_literature()?;
    if let Some(windows) = &windows {
        run.judge_limits(windows, &settings)?;
    }
    run.print_fast_tests()?;
    if let Some(path) = run.json() {
        dashpot_output::json(path, &run.validation)?;
    }
    if [&args.report, &args.svg, &args.certificate, &args.excel].into_iter().any(Option::is_some) {
        run.write_documents(&rivals)?;
    }
    Ok(match &run.validation.limits {
        Some(found) if !found.passed => Verdict::Failed,
        _ => Verdict::Passed,
    })
}

/// Checks the files to write before anything is computed.
fn check_outputs(args: &Args) -> anyhow::Result<()> {
    for (option, path) in [("--report", &args.report), ("--certificate", &args.certificate), ("--excel", &args.excel)] {
        if path.as_deref().is_some_and(dashpot_output::is_stdout) {
            bail!("{option} needs a file name: standard output takes figures alone (--json -)");
        }
    }
    dashpot_output::check_kinds([
        (args.json.as_deref(), Kind::Figures),
        (args.report.as_deref(), Kind::Report),
        (args.certificate.as_deref(), Kind::Report),
        (args.excel.as_deref(), Kind::Workbook),
    ])?;
    Ok(())
}

/// Returns the setting of `--setting` in the unit of the model. Checks that the options suit the model.
fn read_setting(args: &Args, model: &ModelFile) -> anyhow::Result<Option<f64>> {
    let is_family = model.axis.is_some();
    if args.setting.is_some() && !is_family {
        bail!("{} depends on no setting; leave --setting out", args.model.display());
    }
    if is_family && !args.against.is_empty() {
        bail!(
            "--against compares dampers at one setting; write one with dashpot setting {} 0.8 -o one.toml",
            args.model.display()
        );
    }
    args.setting.as_ref().map(|setting| setting.in_unit_of(&model.axis)).transpose()
}

/// Comparison of a model with records, with the arguments of the verb.
struct Run<'a> {
    args: &'a Args,
    model: &'a ModelFile,
    campaign: &'a Campaign,
    compared: &'a [Compared<'a>],
    validation: Validation,
}

impl Run<'_> {
    fn json(&self) -> Option<&Path> {
        self.args.json.as_deref()
    }

    fn say(&self, text: &str) -> anyhow::Result<()> {
        dashpot_output::say(self.json(), text)
    }

    /// Prints the errors, for a family also those at each setting.
    fn print_errors(&self) -> anyhow::Result<()> {
        self.say(&table(&self.validation))?;
        if self.model.axis.is_some() {
            self.say(&settings_table(self.model, &self.validation))?;
            for doubt in &self.validation.setting_doubts {
                dashpot_output::warn(&format!("warning: {}", doubt.sentence(self.model.axis.unit())));
            }
        }
        Ok(())
    }

    /// Compares the models of the literature that `--against` names, and returns their forces.
    fn compare_with_literature(&mut self) -> anyhow::Result<Vec<Rival>> {
        if self.args.against.is_empty() {
            return Ok(Vec::new());
        }
        let progress = Progress::new("comparing");
        let named = &self.args.against;
        let found = Rivals::compare(named, self.model, self.campaign, &|done, name| progress.say(done, name))?;
        drop(progress);
        if found.fitted_to_all {
            self.say(&format!("note: {FITTED_TO_ALL}"))?;
        }
        found.put_into(&mut self.validation, self.compared);
        let drawn = |one: against::Rival| Rival { name: one.literature.name(), forces: one.forces };
        let rivals = found.all.into_iter().map(drawn).collect();
        self.say(&against_table(&self.validation.against))?;
        Ok(rivals)
    }

    /// Compares records and model with the limits. `settings` are those of the records of a family.
    fn judge_limits(&mut self, windows: &[Limit], settings: &[Option<f64>]) -> anyhow::Result<()> {
        let records: Vec<&Record> = self.compared.iter().map(|c| c.record).collect();
        let forces: Vec<&[f64]> = self.compared.iter().map(|c| c.model.as_slice()).collect();
        let found = if self.model.axis.is_some() {
            let responses = &self.validation.step_responses;
            limits::judge_over_settings(windows, (&records, settings), &forces, responses)?
        } else {
            limits::judge(windows, &records, Some(&forces))
        };
        self.say(&crate::limits::table(&found))?;
        self.validation.limits = Some(found);
        Ok(())
    }

    /// Prints a note about tests that are faster than the FV curve reaches.
    fn print_fast_tests(&self) -> anyhow::Result<()> {
        let curve = prepared(&self.model.params)?;
        let records = &self.campaign.records;
        let fast: Vec<&str> = records.iter().filter(|r| outruns(&curve, r)).map(|r| r.name.as_str()).collect();
        let Some(first) = fast.first() else { return Ok(()) };
        let (low, high) = curve.elements().paths.fv_curve.range();
        self.say(&format!(
            "note: {} of {} tests are faster than the FV curve reaches ({:.0} to {:.0} mm/s), the first is {first}; the \
             curve is prolonged straight there",
            fast.len(),
            records.len(),
            1e3 * low,
            1e3 * high
        ))
    }

    /// Writes certificate, report, workbook and figures.
    fn write_documents(&self, rivals: &[Rival]) -> anyhow::Result<()> {
        let args = self.args;
        let progress = Progress::new("drawing");
        progress.set(0.2);
        let input = self.report_input(rivals)?;
        if let (Some(path), Some(found)) = (&args.certificate, &self.validation.limits) {
            let records: Vec<&Record> = self.campaign.records.iter().collect();
            let page = certificate::render(&CertificateInput {
                certificate: found,
                records: &records,
                data: input.data.clone(),
                limits: args.limits.as_ref().map_or_else(String::new, |p| p.display().to_string()),
                curve: &input.curve,
                made: &input.made,
                words: input.words,
            });
            dashpot_output::write(path, page)?;
            self.say(&format!("certificate: {}", path.display()))?;
        }
        if let Some(path) = &args.report {
            dashpot_report::write_atomic(&input, path)?;
            self.say(&format!("report: {}", path.display()))?;
        }
        if let Some(path) = &args.excel {
            dashpot_report::write_workbook(&dashpot_report::workbook(&input), path)?;
            self.say(&format!("workbook: {}", path.display()))?;
        }
        if let Some(folder) = &args.svg {
            let written = dashpot_report::svgs(&input, folder)?;
            self.say(&format!("{} figures in {}", written.len(), folder.display()))?;
        }
        Ok(())
    }

    /// Makes the input of the report.
    fn report_input<'a>(&'a self, rivals: &[Rival]) -> anyhow::Result<ReportInput<'a>> {
        let (args, model) = (self.args, self.model);
        let files =
            [Some(&args.model), args.limits.as_ref()].into_iter().flatten().chain(&self.campaign.files).cloned();
        let words = args.page.text.words();
        let mut input = ReportInput {
            print: args.page.print(),
            made: args.page.text.date.made(files)?,
            model_file: name_of(&args.model),
            data: args.data.named(),
            ..ReportInput::from_validation(model, self.campaign, self.compared, &self.validation, words)?
        };
        if model.axis.is_some() {
            // The figure of peak forces gets no curve, because the curve at one setting does not represent the other
            // settings.
            input.curve.clear();
            input.family = Some(FamilyReport { model, fit: None });
        }
        input.extra.extend(section(&self.validation, self.compared, rivals, input.words));
        Ok(input)
    }
}

/// Formats the errors of the model and of the models of the literature.
fn against_table(against: &[Against]) -> String {
    let mut out = format!(
        "{:<14}{:>8}{:>10}{:>9}{:>10}{:>10}{:>10}{:>9}{:>10}\n",
        "", "fitted", "mean N", "error %", "rms N", "left out", "mean N", "error %", "rms N"
    );
    let figures = |summary: &Option<AgainstSummary>, width: usize| match summary {
        Some(s) => format!(
            "{:>width$}{:>10.2}{:>9.2}{:>10.2}",
            s.tests, s.errors.mean_error_n, s.errors.error_percent, s.errors.rmse_n
        ),
        None => format!("{:>width$}{:>10}{:>9}{:>10}", 0, "-", "-", "-"),
    };
    for one in against {
        out += &format!("{:<14}{}{}\n", one.model, figures(&one.used_in_fit, 8), figures(&one.left_out, 10));
    }
    out.trim_end().to_owned()
}

/// Returns whether the peak velocity of a test exceeds the range of the FV curve by more than 5 %, the scatter of measured peaks.
fn outruns(model: &Model, record: &Record) -> bool {
    let peak = record.peak_velocity / 1.05;
    !model.covers(peak) || !model.covers(-peak)
}

/// Simulates every record with the model and with the FV curve alone, and shows the progress.
pub fn compare<'a>(file: &ModelFile, campaign: &'a Campaign) -> anyhow::Result<Vec<Compared<'a>>> {
    let progress = Progress::new("simulating");
    Ok(comparison::compare(file, campaign, &|done, total| progress.count(done, total))?)
}

/// Simulates every record with an adjustable damper at the record's own setting, and with the FV curve alone.
pub fn compare_family<'a>(
    file: &ModelFile,
    campaign: &'a Campaign,
    given: Option<f64>,
) -> anyhow::Result<Vec<Compared<'a>>> {
    let progress = Progress::new("simulating");
    Ok(comparison::compare_family(file, campaign, given, &|done, total| progress.count(done, total))?)
}

/// Formats the errors at each setting. Marks settings outside the range of the model.
pub fn settings_table(model: &ModelFile, validation: &Validation) -> String {
    let axis = &model.axis;
    let name = super::model::setting_name(axis);
    let mut out = format!("{name:<34}{:>6}{:>10}{:>9}{:>12}{:>10}", "tests", "mean N", "error %", "FV mean N", "FV %");
    let (low, high) = axis.range();
    for of in &validation.settings {
        let errors = &of.summary.errors;
        let where_ = match of.setting {
            setting if setting < low || setting > high => ", clamped to the model's",
            _ if !of.is_of_grid => ", interpolated",
            _ => "",
        };
        let label = format!("{}{where_}", setting_in_words(of.setting, axis.unit()));
        out += &format!(
            "\n{label:<34}{:>6}{:>10.2}{:>9.2}{:>12.2}{:>10.2}",
            of.summary.tests,
            errors.model.mean_error_n,
            errors.model.error_percent,
            errors.fv_only.mean_error_n,
            errors.fv_only.error_percent
        );
    }
    if let Some(changing) = &validation.changing {
        let errors = &changing.summary.errors;
        out += &format!(
            "\n{:<34}{:>6}{:>10.2}{:>9.2}{:>12.2}{:>10.2}",
            "changing",
            changing.summary.tests,
            errors.model.mean_error_n,
            errors.model.error_percent,
            errors.fv_only.mean_error_n,
            errors.fv_only.error_percent
        );
    }
    for of in &validation.step_responses {
        out += &format!("\n{}", response(of, axis.unit()));
    }
    out
}

/// Smallest fraction of a step response that must be complete when the next step of the setting begins. For a smaller fraction, the text
/// recommends longer constant settings between the steps.
const SETTLED: f64 = 0.97;

/// Formats the response times of measurement and model for one kind of step of the setting.
fn response(of: &StepResponse, unit: &str) -> String {
    let times = |times: &Option<ResponseTimes>, uncertainty: Option<TimeUncertainty>| match times {
        Some(t) => {
            let milli = |value: f64, known_to: Option<f64>| match TimeUncertainty::if_coarse(known_to, value) {
                Some(known) => format!("{:.1} ± {} ms", 1e3 * value, digits(1e3 * known, 1)),
                None => format!("{:.1} ms", 1e3 * value),
            };
            format!(
                "{} to 63 %, {} to 90 % ({} from 10 %), overshoot {:.0} %",
                milli(t.t63_s, uncertainty.map(|of| of.t63_s)),
                milli(t.t90_s, uncertainty.map(|of| of.t90_s)),
                milli(t.t90_s - t.t10_s, uncertainty.map(|of| of.rise_s)),
                100.0 * t.overshoot
            )
        }
        None => "not shown".to_owned(),
    };
    let short = match of.end_fraction < SETTLED {
        true => format!("; the levels end at {:.0} % of the way, longer ones show more", 100.0 * of.end_fraction),
        false => String::new(),
    };
    let late = of.delay_of_model().map_or_else(String::new, |delay| {
        let when = if delay > 0.0 { "later" } else { "earlier" };
        format!("; the model is {:.1} ms {when}, more than the uncertainty of the measurement", 1e3 * delay.abs())
    });
    let step = format!("{} to {} {unit}", of.from, of.to);
    format!(
        "step from {}, {} steps: measured {}; model {}{late}{short}",
        step.trim_end(),
        of.steps,
        times(&of.measured, of.uncertainty),
        times(&of.model, None)
    )
}

/// Formats the errors of the model and of the FV curve by amplitude, by peak velocity, by use in the fit, and over all tests.
pub fn table(v: &Validation) -> String {
    let mut out = format!(
        "{:<34}{:>6}{:>10}{:>9}{:>12}{:>12}{:>12}{:>10}\n",
        "", "tests", "mean N", "error %", "region 1 N", "region 2 N", "FV mean N", "FV %"
    );
    // Forces have two decimals. For a small damper, they have enough decimals for two digits of the mean error.
    let places = (2..6).find(|&p| v.overall.errors.model.mean_error_n * 10f64.powi(p) >= 10.0).unwrap_or(2) as usize;
    let mut row = |label: &str, tests: usize, e: &dashpot_identification::validation::Errors| {
        out += &format!(
            "{:<34}{:>6}{:>10.places$}{:>9.2}{:>12.places$}{:>12.places$}{:>12.places$}{:>10.2}\n",
            label,
            tests,
            e.model.mean_error_n,
            e.model.error_percent,
            e.model.region1_n,
            e.model.region2_n,
            e.fv_only.mean_error_n,
            e.fv_only.error_percent
        );
    };
    for r in &v.matrix.by_amplitude {
        row(&r.label, r.tests, &r.errors);
    }
    for r in v.matrix.slow.iter().chain(&v.matrix.not_periodic) {
        row(&r.label, r.tests, &r.errors);
    }
    for r in &v.matrix.by_peak_velocity {
        row(&r.label, r.tests, &r.errors);
    }
    for (label, summary) in [("tests used in the fit", &v.used_in_fit), ("tests left out", &v.left_out)] {
        if let Some(s) = summary {
            row(label, s.tests, &s.errors);
        }
    }
    row("all tests", v.overall.tests, &v.overall.errors);
    out + "error %: of an amplitude or a peak velocity in percent of the largest force there; else the mean of the tests, each in percent of its own largest force"
}
