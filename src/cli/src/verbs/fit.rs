//! `dashpot fit`: identification of a model file from records.

use super::data::{DataArgs, name_of};
use super::family::{self, Outputs};
use super::record_notes::print_record_notes;
use crate::page::TextArgs;
use crate::plural::count_tests;
use crate::progress::Progress;
use anyhow::{Context as _, bail};
use clap::builder::{PossibleValuesParser, TypedValueParser};
use dashpot_core::{Params, list};
use dashpot_identification::literature::{Literature, file, observation};
use dashpot_identification::model_file;
use dashpot_identification::validation::Deviation;
use dashpot_identification::{
    Estimate, Family, Fit, FitOptions, InventoryItem, KINDS, Kind, Measured, Standing, describe_item, fit,
};
use dashpot_messages::Sentence;
use dashpot_output as output;
use dashpot_records::hold_out::kept;
use dashpot_records::{Campaign, Record, SignFinding, Unusable, WITHOUT_SETTING, not_one_damper};
use dashpot_report::numbers::{with_interval, with_unit};
use dashpot_report::parameters::assumed_of_damper;
use dashpot_report::quality;
use dashpot_report::whole_records::in_words;
use dashpot_report::words::TERMINAL;
use dashpot_report::{Workbook, write_workbook};
use dashpot_simulation::whole_records;
use serde::Serialize;
use std::path::{Path, PathBuf};

/// Identify a damper from rig records
///
/// The FV curve comes from the peak velocities, friction and gas force from the slow tests. Then all parameters are refined together. The
/// evidence in the records determines the effects of the model. A delay of the force channel and drifts of gain and zero are also
/// estimated. The fit reports them; the model does not contain them.
#[derive(clap::Args)]
#[command(
    after_help = "Examples:\n  dashpot fit campaign/ -o damper.toml --hold-out 'a40*' --json fit.json --excel fit.xlsx\n  dashpot fit semi_active/ --setting current -o family.toml --subfolders --report family.html"
)]
pub struct Args {
    #[command(flatten)]
    data: DataArgs,
    /// Model file to write
    #[arg(short, long, value_name = "MODEL")]
    output: PathBuf,
    /// Inventory, estimates and notes as JSON; - for standard output
    #[arg(long, value_name = "F")]
    json: Option<PathBuf>,
    /// Every table as a sheet of one Excel workbook, with numeric cells; of a damper without a setting
    #[arg(long, value_name = "F.xlsx")]
    excel: Option<PathBuf>,
    /// Report of a damper over a setting (--setting): curves, errors and loops by setting. For an ordinary damper, dashpot validate writes
    /// the report
    #[arg(long, value_name = "F.html", requires = "setting")]
    report: Option<PathBuf>,
    /// Kind of model: the thesis's, or a model of the literature for comparison. The kinds fv, piecewise and lag give model files for every
    /// verb and host. The other kinds give files that only dashpot validate --against reads
    #[arg(long, value_name = "MODEL", value_parser = kinds(), default_value = "thesis")]
    model: Kind,
    /// Elements that the fit may use, separated by commas; all elements of the model if not given
    #[arg(long, value_name = "NAME", value_delimiter = ',')]
    elements: Option<Vec<String>>,
    /// Fit one damper over a setting of the tests: current, clicks, voltage, pressure, or the name in campaign.toml. The fit determines
    /// which parameters depend on the setting. Each setting is also predicted from the other settings. 'none' fits tests at several
    /// settings as one damper
    #[arg(long, value_name = "NAME")]
    setting: Option<String>,
    /// Tests to leave out, by name; * stands for any characters
    #[arg(long, value_name = "GLOB", value_delimiter = ',')]
    hold_out: Vec<String>,
    /// Dimensions of the damper, a TOML file with the unit in every key. The fit derives priors of parameters from them
    #[arg(long, value_name = "D.toml")]
    dimensions: Option<PathBuf>,
    #[command(flatten)]
    text: TextArgs,
}

/// Parses the kinds of model by their names.
fn kinds() -> impl TypedValueParser<Value = Kind> {
    let named = |name: String| Kind::named(&name).with_context(|| format!("there is no model {name:?}"));
    PossibleValuesParser::new(KINDS.map(|known| known.0)).try_map(named)
}

#[derive(Serialize)]
struct LiteratureJson<'a> {
    model: &'a Path,
    tests: &'a [String],
    numbers: &'a Literature,
    sign: &'a SignFinding,
    /// Files and tests that could not be used.
    unusable: &'a [Unusable],
}

#[derive(Serialize)]
struct Json<'a> {
    model: &'a Path,
    tests: &'a [String],
    parameters: &'a [Estimate],
    inventory: &'a [InventoryItem],
    /// Measurement errors of the records. The records are corrected before `over_whole_records` is computed.
    measured: &'a [Measured],
    notes: &'a [Sentence],
    misfit: f64,
    /// Errors over every sample of the fitted tests, with the definition of `dashpot validate`.
    over_whole_records: Deviation,
    sign: &'a SignFinding,
    /// Files and tests that could not be used.
    unusable: &'a [Unusable],
}

/// Fits a model and writes its model file.
pub fn identify(records: &[&Record], options: &FitOptions, output: &Path) -> anyhow::Result<Fit> {
    let progress = Progress::new("fitting");
    let found = fit(records, options, |stage| progress.say(stage.done, stage.text.english()))?;
    drop(progress);
    dashpot_output::write(output, model_file::write(&found))?;
    Ok(found)
}

/// Identifies a model of the literature that the kernel cannot run, and writes it in a separate file format.
fn literature(args: &Args, campaign: &Campaign, name: &str, on_stdout: bool) -> anyhow::Result<()> {
    let records = kept(campaign, &args.hold_out)?;
    let progress = Progress::new("fitting");
    progress.set(0.1);
    let found = Literature::fit(name, &observation::of_records(&records))?;
    drop(progress);
    let tests: Vec<String> = records.iter().map(|r| r.name.clone()).collect();
    dashpot_output::write(&args.output, file::write(&found, &tests))?;
    let say = |text: &str| dashpot_output::say(if on_stdout { Some(Path::new("-")) } else { None }, text);
    print_record_notes(campaign, &say)?;
    say(&format!(
        "{} fitted; {name} in {}, which only dashpot validate --against reads",
        count_tests(tests.len()),
        args.output.display()
    ))?;
    if let Some(path) = args.json.as_deref() {
        dashpot_output::json(
            path,
            &LiteratureJson {
                model: &args.output,
                tests: &tests,
                numbers: &found,
                sign: &campaign.sign,
                unusable: &campaign.unusable,
            },
        )?;
    }
    Ok(())
}

/// Runs the verb.
pub fn run(args: &Args) -> anyhow::Result<()> {
    let on_stdout = check_outputs(args)?;
    let setting = args.setting.as_deref().filter(|name| *name != WITHOUT_SETTING);
    check_options(args, setting)?;
    let campaign = if setting.is_some() { args.data.load_over_setting()? } else { args.data.load()? };
    let records = kept(&campaign, &args.hold_out)?;
    if args.setting.is_none()
        && let Some(why) = not_one_damper(&records)
    {
        bail!("{why}");
    }
    let options = FitOptions {
        family: match args.model {
            Kind::Model(family) => family,
            Kind::Comparison(name) => return literature(args, &campaign, name, on_stdout),
        },
        elements: args.elements.clone(),
        priors: super::dimensions::priors(args.dimensions.as_deref())?,
    };
    if let Some(setting) = setting {
        let report = args.report.as_deref().map(|path| (path, &args.text));
        let outputs = Outputs { model: &args.output, json: args.json.as_deref(), report };
        return family::run((&campaign, &records), setting, &options, (&args.data, &outputs));
    }
    let found = identify(&records, &options, &args.output)?;
    let say = |text: &str| dashpot_output::say(if on_stdout { Some(Path::new("-")) } else { None }, text);
    print_record_notes(&campaign, &say)?;
    describe(&found).iter().try_for_each(|line| say(line))?;
    let quality = whole_records::quality(&found, &records)?;
    let over_whole_records = quality.model;
    let error = in_words(&over_whole_records, &TERMINAL);
    say(&format!(
        "{} fitted, off by {error}; model in {}",
        count_tests(found.tests.len()),
        dashpot_output::target_name(&args.output)
    ))?;
    say(&quality::sentence(&quality, &TERMINAL))?;
    if let Some(path) = args.json.as_deref() {
        let json = Json {
            model: &args.output,
            tests: &found.tests,
            parameters: &found.estimates,
            inventory: &found.inventory,
            measured: &found.measured,
            notes: &found.notes,
            misfit: found.misfit,
            over_whole_records,
            sign: &campaign.sign,
            unusable: &campaign.unusable,
        };
        dashpot_output::json(path, &json)?;
    }
    if let Some(path) = args.excel.as_deref() {
        write_workbook(&tables(args, &campaign, &found, &over_whole_records)?, path)?;
        say(&format!("workbook: {}", path.display()))?;
    }
    Ok(())
}

/// Checks the files to write before anything is computed. Returns whether one of them is standard output.
fn check_outputs(args: &Args) -> anyhow::Result<bool> {
    let (json, excel, report) = (args.json.as_deref(), args.excel.as_deref(), args.report.as_deref());
    let on_stdout =
        [Some(args.output.as_path()), json].into_iter().flatten().filter(|p| dashpot_output::is_stdout(p)).count();
    if on_stdout > 1 {
        bail!("standard output takes one result: give -o or --json a file");
    }
    if excel.is_some_and(dashpot_output::is_stdout) {
        bail!("--excel needs a file name: standard output takes estimates (--json -) or the model (-o -)");
    }
    if report.is_some_and(dashpot_output::is_stdout) {
        bail!("--report needs a file name: standard output takes estimates (--json -) or the model (-o -)");
    }
    let kind = match args.model {
        Kind::Model(_) => output::Kind::Model,
        Kind::Comparison(_) => output::Kind::Comparison,
    };
    dashpot_output::check_kinds([
        (Some(args.output.as_path()), kind),
        (json, output::Kind::Figures),
        (excel, output::Kind::Workbook),
        (report, output::Kind::Report),
    ])?;
    Ok(on_stdout > 0)
}

/// Checks that the options suit each other. `setting` is the setting over which the damper is fitted.
fn check_options(args: &Args, setting: Option<&str>) -> anyhow::Result<()> {
    let is_thesis = args.model == Kind::Model(Family::Thesis);
    if args.excel.is_some() && matches!(args.model, Kind::Comparison(_)) {
        bail!(
            "--excel has the tables of a model file; this model's numbers are in the file that -o names, and in --json"
        );
    }
    if args.elements.is_some() && !is_thesis {
        bail!("--elements chooses the elements of --model thesis; the other models have no choice of elements");
    }
    if setting.is_some() && !is_thesis {
        bail!("--setting fits --model thesis over the setting; leave one of the two out");
    }
    if setting.is_some() && args.excel.is_some() {
        bail!("--excel has the tables of a damper without a setting; those of a family are in --json");
    }
    if args.dimensions.is_some() && !is_thesis {
        bail!("--dimensions gives priors to --model thesis; leave one of the two out");
    }
    if setting.is_none() && args.report.is_some() {
        bail!("--report is of a damper over a setting; dashpot validate writes the report of an ordinary damper");
    }
    Ok(())
}

/// Formats inventory, estimates, curve and notes of a fit as lines.
fn describe(found: &Fit) -> Vec<String> {
    let items = found.inventory.iter().map(|item| format!("  {}", describe_item(item)));
    let estimates = found.estimates.iter().filter(|e| e.index.is_none()).map(|e| describe_estimate(e, found));
    let notes = found.further_notes().map(|note| format!("note: {note}"));
    items.chain(estimates).chain(curve_lines(&found.params)).chain(notes).collect()
}

/// Formats an estimate with its interval, or a number that the records do not determine.
fn describe_estimate(e: &Estimate, found: &Fit) -> String {
    match (&e.standing, e.low, e.high) {
        (Standing::NotIdentified, ..) => {
            let assumed = assumed_of_damper(e, (&found.params, &found.priors), &TERMINAL).unwrap_or_default();
            format!("  {:<30} {assumed}", e.name)
        }
        (_, Some(low), Some(high)) => {
            let (value, interval) = with_interval(e.value, low, high, e.unit, &TERMINAL);
            format!("  {:<30} {value:>16}  95 %: {interval}", e.name)
        }
        _ => format!("  {:<30} {:>16}", e.name, with_unit(e.value, e.unit)),
    }
}

/// Formats the FV curve as lines of velocity and force. Returns `None` if the curve has slopes and knees instead of points, or if there is
/// no curve.
fn curve_lines(params: &Params) -> Option<String> {
    let (velocity, force) = (list!("fv_velocity"), list!("fv_force"));
    if !params.counts(velocity.row()) {
        return None;
    }
    let points = params.list(velocity).iter().zip(params.list(force));
    let points = points.map(|(v, f)| format!("    {:>10.0} {f:>10.0}", 1e3 * v));
    let head = format!("  FV curve {:>5} {:>10}", "mm/s", "N");
    Some(std::iter::once(head).chain(points).collect::<Vec<_>>().join("\n"))
}

/// Makes the workbook of a fit.
fn tables(args: &Args, campaign: &Campaign, found: &Fit, error: &Deviation) -> anyhow::Result<Workbook<'static>> {
    let words = args.text.words();
    let made = args.text.date.made(campaign.files.iter().cloned())?;
    Ok(dashpot_report::fit::workbook(
        (found, error),
        &campaign.unusable,
        [&name_of(&args.output), &args.data.named()],
        made,
        words,
    ))
}
