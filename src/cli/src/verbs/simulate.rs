//! `dashpot simulate`: computation of the force for any motion.

use super::data::ColumnArgs;
use super::model;
use super::simulate_setting::{Commands, Schedule, heading};
use crate::progress::Progress;
use crate::quantity::{metres, seconds};
use dashpot_core::Model;
use dashpot_core::family::Family;
use dashpot_core::step::LONG_STEP;
use dashpot_identification::model_file::prepared;
use dashpot_identification::setting_units::restate;
use dashpot_records::{Options, Positive, read_force_of_motion, read_motion};
use dashpot_simulation::imposed_motion::{ImposedMotion, SimulatedSample};
use dashpot_simulation::motion_sign::doubt_sign;
use std::fmt::Write as _;
use std::path::PathBuf;

/// Compute the force of a model for any motion
///
/// The motion is used unchanged, without smoothing. Extension (rebound) is positive unless --positive or a campaign.toml in the folder of
/// the motion says otherwise. If the file also has the recorded force, a note says when the other direction fits it better. If the file has displacement and velocity, both drive
/// the model. Displacement alone is differentiated by a cubic spline. Velocity alone is integrated. Noise of a measured displacement
/// appears in the force, multiplied by the series stiffness. `dashpot validate` smooths the motion; `simulate` does not. The damper starts
/// at rest at the first displacement, or in steady motion if the first velocity is not zero. The output has the columns time_s,
/// displacement_m, velocity_m_s and force_N; extension and tension are positive, whatever --positive says of the motion file. For a damper over a setting it also has the setting, such as current_A. A
/// damper over a setting uses the setting of the motion file, through its actuator. That is a column such as current [A], the column of
/// --column setting=HEADING, or a setting in the file name. Between two samples the command is the mean of both. If the motion has no
/// setting, --setting applies, or else the start setting of the model file.
#[derive(clap::Args)]
#[command(
    after_help = "Examples:\n  dashpot simulate damper.toml road.csv -o force.csv\n  dashpot simulate damper.toml road.csv --step 0.001 -o - | head\n  dashpot simulate damper.toml bench.csv --positive compression -o force.csv\n  dashpot simulate semi_active.toml road.csv --setting 0:0.4,1.5:1.2 -o force.csv\n  dashpot simulate adjuster.toml road.csv --column setting=\"p pilot [bar]\" -o force.csv"
)]
pub struct Args {
    /// Model file
    #[arg(value_name = "MODEL")]
    model: PathBuf,
    /// File with time, displacement or velocity or both, and a setting if it has one (CSV, XLSX, MAT v5)
    #[arg(value_name = "MOTION")]
    motion: PathBuf,
    /// Where to write; - for standard output
    #[arg(short, long, value_name = "OUT.csv")]
    output: PathBuf,
    /// Fixed step, s; the file's own times if not given
    #[arg(long, value_name = "S", value_parser = seconds, allow_negative_numbers = true)]
    step: Option<f64>,
    /// Setting of a damper that depends on one, for a motion without a setting column. A number, or pairs of start time (s) and number,
    /// such as 0:0.4,1.5:1.2. Before the first time, the start setting of the model applies
    #[arg(long, value_name = "SETTING", value_parser = Schedule::parse, allow_negative_numbers = true)]
    setting: Option<Schedule>,
    /// Direction that is positive in the motion file; rebound if neither this nor a campaign.toml states it
    #[arg(long, value_name = "rebound|compression")]
    positive: Option<Positive>,
    #[command(flatten)]
    columns: ColumnArgs,
    /// Displacement at the first sample, m, for a motion with velocity alone; 0 if not given
    #[arg(long, value_name = "M", value_parser = metres, allow_negative_numbers = true)]
    initial_position: Option<f64>,
}

/// Runs the verb.
pub fn run(args: &Args) -> anyhow::Result<()> {
    dashpot_output::check([args.output.as_path()])?;
    let file = model::read_family(&args.model)?;
    let model = prepared(&file.params)?;
    if args.setting.is_some() && !file.axis.is_some() {
        anyhow::bail!("{} depends on no setting; leave --setting out", args.model.display());
    }
    let options = Options { positive: args.positive, ..args.columns.options()? };
    let mut record = read_motion(&args.motion, &options)?;
    // If the user states the positive direction of the motion, the recorded force is not used to check it.
    let recorded = record.positive.is_none().then(|| read_force_of_motion(&args.motion, &options)).flatten();
    if let Some(of) = &mut record.setting {
        // [`Commands::choose`] rejects an incompatible unit later, if the setting is used.
        restate(&file.axis, &of.name, &mut of.unit, &mut of.values);
    }
    let own = record.setting.as_ref();
    let commands = match file.axis.is_some() {
        true => Some(Commands::choose((&args.model, &file.axis), (&args.motion, own), args.setting.as_ref())?),
        false => None,
    };
    let unread =
        own.filter(|of| commands.is_none() && of.values.iter().any(|value| *value != of.values[0])).map(|of| {
            format!(
                "{} depends on no setting; the {} of the motion, which changes, is not read",
                args.model.display(),
                of.name
            )
        });
    let as_read = ImposedMotion::new(record, args.initial_position)?;
    let resampled = args.step.map(|step| as_read.resampled(step)).transpose()?;
    let motion = resampled.as_ref().unwrap_or(&as_read);
    let progress = Progress::new("simulating");
    progress.set(0.2);
    let mut family = Box::new(Family::OFF);
    if commands.is_some() {
        // The reader of the model file has already checked the parameters.
        family.set(&file.params, &file.axis).map_err(|fault| anyhow::anyhow!("{}", fault.reason.text()))?;
    }
    let simulate = |motion: &ImposedMotion| match &commands {
        Some(commands) => motion.drive_family(&family, &|sample| commands.command(motion, sample)),
        None => motion.drive(&model),
    };
    let answers = simulate(motion)?;
    let doubt = match recorded {
        // The recorded force has the times of the file, so it is compared with a simulation of the motion as read.
        Some(force) if resampled.is_some() => doubt_sign(&as_read, &simulate(&as_read)?, &force, &simulate)?,
        Some(force) => doubt_sign(&as_read, &answers, &force, &simulate)?,
        None => None,
    };
    drop(progress);
    let of_sign = doubt.map(|doubt| {
        let (counts, remedy) = match doubt.motion_alone {
            true => (
                "its motion, but not its force, in the opposite direction",
                format!("Reverse it with dashpot import-profile {} --flip motion", args.motion.display()),
            ),
            false => (
                "compression positive",
                "Give --positive compression, or --positive rebound to keep it as it is".to_owned(),
            ),
        };
        format!(
            "{} seems to count {counts}: then the model is {:.3} N (rms) off the force in the file, now {:.3} N. {remedy}",
            args.motion.display(),
            doubt.reversed_error,
            doubt.error
        )
    });
    let settings = commands.as_ref().map(|commands| {
        let settings = (0..answers.len()).map(|sample| commands.setting(motion, sample)).collect();
        (heading(&file.axis), settings)
    });
    dashpot_output::write(&args.output, csv(&answers, settings))?;
    // If the rows go to standard output, remarks go to standard error.
    let unreached = commands.as_ref().and_then(|commands| commands.unreached(*motion.time.last()?));
    let interpolated = commands.as_ref().and_then(|commands| commands.interpolated(&file.axis));
    let clamped = commands.as_ref().and_then(|commands| commands.clamped(motion, &file.axis));
    let of_setting = commands
        .map_or_else(Vec::new, |commands| commands.notes)
        .into_iter()
        .chain(unreached)
        .chain(clamped)
        .chain(interpolated);
    for remark in
        of_sign.into_iter().chain(beyond(&model, &answers)).chain(coarse(&answers)).chain(of_setting).chain(unread)
    {
        dashpot_output::say(Some(&args.output), &format!("note: {remark}"))?;
    }
    dashpot_output::say(
        Some(&args.output),
        &format!("{} rows in {}", answers.len(), dashpot_output::target_name(&args.output)),
    )
}

/// Formats the rows, with their settings if there are any. Parsing the numbers gives bitwise equal values.
fn csv(answers: &[SimulatedSample], settings: Option<(String, Vec<f64>)>) -> String {
    let (heading, settings) = settings.map_or((None, Vec::new()), |(heading, settings)| (Some(heading), settings));
    let mut out = String::from("time_s,displacement_m,velocity_m_s,force_N");
    out.extend(heading.map(|heading| format!(",{heading}")));
    out.push('\n');
    for (k, a) in answers.iter().enumerate() {
        let _ = write!(out, "{:?},{:?},{:?},{:?}", a.time, a.displacement, a.velocity, a.force);
        out.extend(settings.get(k).map(|setting| format!(",{setting:?}")));
        out.push('\n');
    }
    out
}

/// Returns a remark if steps are so long that the motion within them is uncertain.
fn coarse(answers: &[SimulatedSample]) -> Option<String> {
    let steps = answers.windows(2).map(|rows| rows[1].time - rows[0].time);
    let long = steps.clone().filter(|step| *step > LONG_STEP * (1.0 + 1e-9)).count();
    let longest = steps.fold(0.0, f64::max);
    (long > 0).then(|| {
        format!(
            "{long} of {} steps are longer than {:.0} ms (the longest {:.3} s); the cubic between their ends stands for the motion, and what is faster is lost. \
             Give --step 0.001, or a motion that is sampled more densely",
            answers.len() - 1,
            1e3 * LONG_STEP,
            longest
        )
    })
}

/// Returns a remark if the motion is faster than the range of the FV curve.
fn beyond(model: &Model, answers: &[SimulatedSample]) -> Option<String> {
    let outside = answers.iter().filter(|a| !model.covers(a.velocity)).count();
    let (low, high) = model.elements().paths.fv_curve.range();
    let fastest = answers.iter().map(|a| a.velocity).max_by(|a, b| a.abs().total_cmp(&b.abs()))?;
    (outside > 0).then(|| {
        format!(
            "{outside} of {} rows are faster than the FV curve reaches ({:.0} to {:.0} mm/s; the fastest {:.0} \
             mm/s), which is prolonged straight there",
            answers.len(),
            1e3 * low,
            1e3 * high,
            1e3 * fastest
        )
    })
}
