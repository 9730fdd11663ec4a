//! `dashpot manoeuvre`: effect of the model in a vehicle.

use super::data::DataArgs;
use super::model;
use crate::page::PageArgs;
use crate::quantity::seconds;
use anyhow::{Context as _, bail};
use dashpot_core::element;
use dashpot_core::{Model, Params};
use dashpot_identification::model_file::{ModelFile, prepared};
use dashpot_output::Kind;
use dashpot_report::manoeuvre::{self, Covered, Figures, ManoeuvreInput, beyond_note, coupling_note, quiet_note};
use dashpot_report::words::TERMINAL;
use dashpot_simulation::vehicle::{Car, Manoeuvre, run as drive, without_chatter};
use std::path::{Path, PathBuf};

/// Drive a vehicle over a manoeuvre with the model and with the FV curve
///
/// The vehicle is a passenger car with heave, pitch, roll, lateral and yaw motion on four wheels. Its steps are those of a real-time
/// simulator. Shows the force and motion of every damper, and the chassis. Also compares the region of displacement and velocity in the
/// manoeuvre with that of the rig tests. Manoeuvres: bump, step-steer, sine-steer, track.
#[derive(clap::Args)]
#[command(
    after_help = "Examples:\n  dashpot manoeuvre bump damper.toml --report bump.html --excel bump.xlsx\n  dashpot manoeuvre track front.toml --rear rear.toml --tests campaign/\n  dashpot manoeuvre track front.toml --vehicle car.toml --report track.html"
)]
pub struct Args {
    /// Manoeuvre: bump, step-steer, sine-steer or track
    #[arg(value_name = "NAME", value_parser = Manoeuvre::ALL.map(|(name, _)| name))]
    name: String,
    /// Model file of all dampers, or of the front ones
    #[arg(value_name = "MODEL")]
    model: PathBuf,
    /// Model file of the rear dampers
    #[arg(long, value_name = "MODEL")]
    rear: Option<PathBuf>,
    /// Step of the vehicle, s
    #[arg(long, value_name = "S", value_parser = seconds, default_value_t = 1e-3, allow_negative_numbers = true)]
    step: f64,
    /// Rig records, for a comparison of the region that they cover
    #[arg(long, value_name = "DATA")]
    tests: Option<PathBuf>,
    /// Figures as JSON; - for standard output
    #[arg(long, value_name = "F")]
    json: Option<PathBuf>,
    /// Report with tables and plots, one file that needs no network
    #[arg(long, value_name = "F.html")]
    report: Option<PathBuf>,
    /// Every table as a sheet of one Excel workbook, with numeric cells
    #[arg(long, value_name = "F.xlsx")]
    excel: Option<PathBuf>,
    /// Your own vehicle: a file with lines name = number in SI units. The report lists all names
    #[arg(long, value_name = "car.toml")]
    vehicle: Option<PathBuf>,
    #[command(flatten)]
    page: PageArgs,
}

/// Runs the verb.
pub fn run(args: &Args) -> anyhow::Result<()> {
    for (option, path) in [("--report", &args.report), ("--excel", &args.excel)] {
        if path.as_deref().is_some_and(dashpot_output::is_stdout) {
            bail!("{option} needs a file name: standard output takes figures alone (--json -)");
        }
    }
    dashpot_output::check_kinds([
        (args.json.as_deref(), Kind::Figures),
        (args.report.as_deref(), Kind::Report),
        (args.excel.as_deref(), Kind::Workbook),
    ])?;
    let Some((_, driven)) = Manoeuvre::ALL.into_iter().find(|(name, _)| *name == args.name) else {
        bail!("there is no manoeuvre {}", args.name);
    };
    let front = pair(&args.model)?;
    let rear = args.rear.as_deref().map(pair).transpose()?.unwrap_or(front);
    let car = match &args.vehicle {
        Some(path) => {
            let text = dashpot_records::read_small_text(path)
                .with_context(|| format!("reading the vehicle {}", path.display()))?;
            Car::read(&text).with_context(|| path.display().to_string())?
        }
        None => Car::default(),
    };
    let models = [&front.0, &front.0, &rear.0, &rear.0];
    let curves = [&front.1, &front.1, &rear.1, &rear.1];
    let with_model = drive(&car, driven, models, args.step)?;
    let with_curve = drive(&car, driven, curves, args.step).context("with the FV curve alone")?;
    let both = [with_model, with_curve];
    let quiet = without_chatter(&car, driven, [models, curves], &both, args.step)?;
    let [with_model, with_curve] = &both;
    let campaign = args.tests.as_ref().map(|path| DataArgs::folder(path.clone()).load()).transpose()?;
    let covered = campaign.as_ref().map(|campaign| Covered::from_records(&campaign.records));
    let figures =
        manoeuvre::figures(&args.name, args.step, [with_model, with_curve], quiet.as_ref(), covered.as_ref(), models);
    let json = args.json.as_deref();
    dashpot_output::say(json, &table(&figures))?;
    for note in
        [quiet_note(&figures, &TERMINAL), coupling_note(&figures, &car, &TERMINAL), beyond_note(&figures, &TERMINAL)]
            .into_iter()
            .flatten()
    {
        dashpot_output::say(json, &format!("note: {note}"))?;
    }
    if let Some(path) = json {
        dashpot_output::json(path, &figures)?;
    }
    if args.report.is_some() || args.excel.is_some() {
        let files = [Some(&args.model), args.rear.as_ref(), args.vehicle.as_ref()].into_iter().flatten();
        let made = args.page.text.date.made(files.chain(campaign.iter().flat_map(|c| &c.files)).cloned())?;
        let page = ManoeuvreInput {
            figures: &figures,
            model_file: args.model.display().to_string(),
            model: with_model,
            curve: with_curve,
            quiet: quiet.as_ref(),
            covered: covered.as_ref(),
            car: &car,
            speed: driven.speed(),
            made: &made,
            words: args.page.text.words(),
        };
        if let Some(path) = &args.report {
            dashpot_output::write(path, page.render())?;
            dashpot_output::say(json, &format!("report: {}", path.display()))?;
        }
        if let Some(path) = &args.excel {
            dashpot_report::write_workbook(&page.workbook(), path)?;
            dashpot_output::say(json, &format!("workbook: {}", path.display()))?;
        }
    }
    Ok(())
}

/// Returns the model of a file, and that of the plain curve of [`fv_only`].
fn pair(path: &Path) -> anyhow::Result<(Model, Model)> {
    let file = model::read(path)?;
    let named = || path.display().to_string();
    let model = prepared(&file.params).with_context(named)?;
    Ok((model, prepared(&fv_only(&file)?).with_context(named)?))
}

/// Returns the plain FV curve that the fit stored in the model file. If there is none, returns the model's own curve and gas force.
fn fv_only(file: &ModelFile) -> anyhow::Result<Params> {
    if let Some(curve) = &file.identification.fv_only {
        return curve.params().map_err(anyhow::Error::msg).context("the table fv_only of the model file");
    }
    let (on_gas, mut params) = (file.params.is_on(element!("gas_preload")), file.params);
    params.disable_all();
    params.enable(element!("fv_curve"), true);
    params.enable(element!("gas_preload"), on_gas);
    Ok(params)
}

fn span(range: [f64; 2]) -> String {
    format!("{:.1} to {:.1}", 1e3 * range[0], 1e3 * range[1])
}

fn table(f: &Figures) -> String {
    let mut out = format!(
        "{:<10}{:>20}{:>22}{:>12}{:>12}{:>12}{:>12}{:>12}\n",
        "corner", "displacement mm", "velocity mm/s", "force N", "FV N", "rms diff N", "energy J", "FV J"
    );
    for c in &f.corners {
        out += &format!(
            "{:<10}{:>20}{:>22}{:>12.0}{:>12.0}{:>12.1}{:>12.1}{:>12.1}\n",
            c.corner,
            span(c.saw.displacement_m),
            span(c.saw.velocity_m_s),
            c.largest_force_n,
            c.largest_force_fv_n,
            c.rms_force_difference_n,
            c.energy_j,
            c.energy_fv_j
        );
    }
    if let Some(r) = f.rig_tests {
        out += &format!("{:<10}{:>20}{:>22}\n", "rig tests", span(r.displacement_m), span(r.velocity_m_s));
        for c in &f.corners {
            let share = 100.0 * c.fraction_inside_tests.unwrap_or(0.0);
            out += &format!("{}: {share:.1} % of the time where rig tests came near\n", c.corner);
        }
    }
    let [peak, peak_fv] = f.largest_heave_acceleration_m_s2;
    let [rms, rms_fv] = f.rms_heave_acceleration_m_s2;
    out += &format!(
        "heave acceleration: largest {peak:.2} (FV curve {peak_fv:.2}), rms {rms:.3} (FV curve {rms_fv:.3}) m/s^2; heave differs \
         by {:.2} mm rms",
        1e3 * f.rms_heave_difference_m
    );
    out
}
