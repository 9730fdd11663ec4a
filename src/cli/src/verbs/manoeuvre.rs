//! `dashpot manoeuvre`: what the model changes in a vehicle.

use super::data::DataArgs;
use anyhow::{Context as _, bail};
use dashpot_core::{Model, Params};
use dashpot_identification::model_file::{self, ModelFile, prepared};
use dashpot_output::Kind;
use dashpot_report::blocks::{Block, Column, Figure, Section, Table};
use dashpot_report::numbers;
use dashpot_report::plot::axes::{Axis, Plane, Series};
use dashpot_report::plot::of_test::{FORCE, FV_ONLY, MODEL, VELOCITY};
use dashpot_report::plot::palette::Role;
use dashpot_simulation::vehicle::{CORNERS, Car, Manoeuvre, Run, SLOW, Sample, run as drive};
use serde::Serialize;
use std::path::{Path, PathBuf};

/// Drive a vehicle over a manoeuvre with the model and with the FV curve
///
/// A passenger car of heave, pitch, roll, lateral and yaw motion on four wheels, stepped as a real-time simulator steps.
/// Shows the force and motion of every damper, the chassis, and the region of displacement and velocity that the dampers
/// saw against the one that rig tests covered. Manoeuvres: bump, step-steer, sine-steer, track.
#[derive(clap::Args)]
#[command(
    after_help = "Examples:\n  dashpot manoeuvre bump damper.toml --report bump.html\n  dashpot manoeuvre track front.toml --rear rear.toml --tests campaign/"
)]
pub struct Args {
    /// bump, step-steer, sine-steer or track
    #[arg(value_name = "NAME", value_parser = Manoeuvre::ALL.map(|(name, _)| name))]
    name: String,
    /// Model file of all dampers, or of the front ones
    #[arg(value_name = "MODEL")]
    model: PathBuf,
    /// Model file of the rear dampers
    #[arg(long, value_name = "MODEL")]
    rear: Option<PathBuf>,
    /// Step of the vehicle, s
    #[arg(long, value_name = "S", default_value_t = 1e-3, allow_negative_numbers = true)]
    step: f64,
    /// Rig records, to compare the region that they covered
    #[arg(long, value_name = "DATA")]
    tests: Option<PathBuf>,
    /// Figures as JSON; - for standard output
    #[arg(long, value_name = "F")]
    json: Option<PathBuf>,
    /// Report with tables and plots, one file that opens without a network
    #[arg(long, value_name = "F.html")]
    report: Option<PathBuf>,
}

/// Region of displacement and velocity.
#[derive(Serialize, Clone, Copy)]
struct Region {
    displacement_m: [f64; 2],
    velocity_m_s: [f64; 2],
}

#[derive(Serialize)]
struct CornerFigures {
    corner: &'static str,
    saw: Region,
    largest_force_n: f64,
    largest_force_fv_n: f64,
    rms_force_difference_n: f64,
    energy_j: f64,
    energy_fv_j: f64,
    share_inside_tests: Option<f64>,
}

#[derive(Serialize)]
struct Figures {
    manoeuvre: String,
    step_s: f64,
    largest_heave_acceleration_m_s2: [f64; 2],
    rms_heave_acceleration_m_s2: [f64; 2],
    rms_heave_difference_m: f64,
    coupling: f64,
    coupling_moving: f64,
    rig_tests: Option<Region>,
    corners: Vec<CornerFigures>,
}

/// Points of displacement and velocity that the rig tests covered.
struct Covered {
    region: Region,
    loops: Vec<Vec<[f64; 2]>>,
}

/// Runs the verb.
pub fn run(args: &Args) -> anyhow::Result<()> {
    if args.report.as_deref().is_some_and(dashpot_output::is_stdout) {
        bail!("--report needs a file name: standard output takes figures alone (--json -)");
    }
    dashpot_output::check_kinds([(args.json.as_deref(), Kind::Figures), (args.report.as_deref(), Kind::Report)])?;
    let Some((_, manoeuvre)) = Manoeuvre::ALL.into_iter().find(|(name, _)| *name == args.name) else {
        bail!("there is no manoeuvre {}", args.name);
    };
    let front = pair(&args.model)?;
    let rear = args.rear.as_deref().map(pair).transpose()?.unwrap_or(front);
    let car = Car::default();
    let with_model = drive(&car, manoeuvre, [&front.0, &front.0, &rear.0, &rear.0], args.step)?;
    let with_curve =
        drive(&car, manoeuvre, [&front.1, &front.1, &rear.1, &rear.1], args.step).context("with the FV curve alone")?;
    let covered = args.tests.as_ref().map(|path| covered(path)).transpose()?;
    let figures = figures(args, &with_model, &with_curve, covered.as_ref());
    let json = args.json.as_deref();
    dashpot_output::say(json, &table(&figures))?;
    if let Some(note) = coupling_note(&with_model, &car) {
        dashpot_output::say(json, &note)?;
    }
    if let Some(path) = json {
        dashpot_output::json(path, &figures)?;
    }
    if let Some(path) = &args.report {
        let page = dashpot_report::render_sections(
            &format!("Manoeuvre {}", args.name),
            &format!("Model {} against its FV curve, {} s steps", args.model.display(), args.step),
            &sections(&figures, &with_model, &with_curve, covered.as_ref()),
        );
        dashpot_output::write(path, &page)?;
        dashpot_output::say(json, &format!("report: {}", path.display()))?;
    }
    Ok(())
}

/// What the exchange of force and motion asks of a host, where it asks anything.
fn coupling_note(run: &Run, car: &Car) -> Option<String> {
    let (all, moving, mass) = (run.coupling, run.coupling_moving, car.unsprung_mass);
    if moving > 1.0 {
        return Some(format!(
            "note: c h / m reaches {moving:.2} on the {mass} kg wheel: a simulator that exchanges force and motion with one step of \
             delay is unstable above 1, without delay above 2; a shorter step helps"
        ));
    }
    (all > 1.0).then(|| {
        format!(
            "note: c h / m is at most {moving:.2} on the {mass} kg wheel in motion, but {all:.2} where friction turns over (below {} \
             mm/s): there the exchange chatters within the friction force; a shorter step or less steep friction helps",
            1e3 * SLOW
        )
    })
}

/// The model of a file, and its FV curve alone.
fn pair(path: &Path) -> anyhow::Result<(Model, Model)> {
    let file = model_file::read(path)?;
    let named = || path.display().to_string();
    let model = prepared(&file.params).with_context(named)?;
    Ok((model, prepared(&fv_only(&file)?).with_context(named)?))
}

/// The fit's own FV curve; the model's curve and gas force where the file has none.
fn fv_only(file: &ModelFile) -> anyhow::Result<Params> {
    if let Some(curve) = &file.identification.fv_only {
        return curve.params().map_err(anyhow::Error::msg).context("the table fv_only of the model file");
    }
    let (on_gas, mut params) = (file.params.is_on("gas_preload"), file.params);
    params.disable_all();
    for (element, on) in [("fv_curve", true), ("gas_preload", on_gas)] {
        params.enable(element, on).map_err(|fault| anyhow::anyhow!("{element} {}", fault.reason.text()))?;
    }
    Ok(params)
}

fn region(points: impl Iterator<Item = [f64; 2]>) -> Region {
    let empty = [f64::INFINITY, f64::NEG_INFINITY];
    let (x, v) =
        points.fold((empty, empty), |(x, v), [px, pv]| ([x[0].min(px), x[1].max(px)], [v[0].min(pv), v[1].max(pv)]));
    Region { displacement_m: x, velocity_m_s: v }
}

fn covered(path: &Path) -> anyhow::Result<Covered> {
    let campaign = DataArgs::folder(path.to_path_buf()).load()?;
    let points = |r: &dashpot_records::Record| -> Vec<[f64; 2]> {
        r.displacement.iter().zip(&r.velocity).map(|(x, v)| [*x, *v]).collect()
    };
    let loops: Vec<Vec<[f64; 2]>> = campaign.records.iter().map(points).collect();
    Ok(Covered { region: region(loops.iter().flatten().copied()), loops })
}

impl Covered {
    /// Whether a test came near: within a tenth of the tests' region in both directions.
    fn near(&self) -> impl Fn([f64; 2]) -> bool {
        const CELLS: usize = 20;
        let r = self.region;
        let cell = move |value: f64, range: [f64; 2]| -> Option<usize> {
            let place = (value - range[0]) / (range[1] - range[0]);
            (0.0..=1.0).contains(&place).then_some(((place * CELLS as f64) as usize).min(CELLS - 1))
        };
        let mut seen = [[false; CELLS]; CELLS];
        for [x, v] in self.loops.iter().flatten() {
            if let (Some(i), Some(j)) = (cell(*x, r.displacement_m), cell(*v, r.velocity_m_s)) {
                for row in &mut seen[i.saturating_sub(1)..=(i + 1).min(CELLS - 1)] {
                    row[j.saturating_sub(1)..=(j + 1).min(CELLS - 1)].fill(true);
                }
            }
        }
        move |[x, v]| match (cell(x, r.displacement_m), cell(v, r.velocity_m_s)) {
            (Some(i), Some(j)) => seen[i][j],
            _ => false,
        }
    }
}

fn rms(values: impl Iterator<Item = f64>) -> f64 {
    let (sum, n) = values.fold((0.0, 0_usize), |(s, n), v| (s + v * v, n + 1));
    (sum / n.max(1) as f64).sqrt()
}

fn figures(args: &Args, model: &Run, curve: &Run, covered: Option<&Covered>) -> Figures {
    let near = covered.map(Covered::near);
    let largest = |run: &Run, of: &dyn Fn(&Sample) -> f64| run.samples.iter().fold(0.0_f64, |m, s| m.max(of(s).abs()));
    let acceleration = |s: &Sample| s.body.heave_acceleration;
    let both = || model.samples.iter().zip(&curve.samples);
    let corners = (0..4)
        .map(|i| {
            let energy = |run: &Run| run.samples.iter().map(|s| s.corner[i].force * s.corner[i].velocity).sum::<f64>();
            let points = || model.samples.iter().map(|s| [s.corner[i].displacement, s.corner[i].velocity]);
            CornerFigures {
                corner: CORNERS[i],
                saw: region(points()),
                largest_force_n: largest(model, &|s| s.corner[i].force),
                largest_force_fv_n: largest(curve, &|s| s.corner[i].force),
                rms_force_difference_n: rms(both().map(|(m, c)| m.corner[i].force - c.corner[i].force)),
                energy_j: energy(model) * args.step,
                energy_fv_j: energy(curve) * args.step,
                share_inside_tests: near
                    .as_ref()
                    .map(|near| points().filter(|p| near(*p)).count() as f64 / model.samples.len() as f64),
            }
        })
        .collect();
    Figures {
        manoeuvre: args.name.clone(),
        step_s: args.step,
        largest_heave_acceleration_m_s2: [largest(model, &acceleration), largest(curve, &acceleration)],
        rms_heave_acceleration_m_s2: [model, curve].map(|run| rms(run.samples.iter().map(acceleration))),
        rms_heave_difference_m: rms(both().map(|(m, c)| m.body.position[0] - c.body.position[0])),
        coupling: model.coupling,
        coupling_moving: model.coupling_moving,
        rig_tests: covered.map(|c| c.region),
        corners,
    }
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
            let share = 100.0 * c.share_inside_tests.unwrap_or(0.0);
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

fn plane(title: String, x: &str, y: &str, series: Vec<Series>) -> Plane {
    let along = |k: usize| -> Vec<f64> { series.iter().flat_map(|s| s.lines.concat()).map(|p| p[k]).collect() };
    Plane { title, x: Axis::around(x, along(0)), y: Axis::around(y, along(1)), series }
}

fn series(role: Role, label: &'static str, run: &Run, point: impl Fn(&Sample) -> [f64; 2]) -> Series {
    Series { role, label, lines: vec![run.samples.iter().map(point).collect()], dotted: false }
}

fn sections(f: &Figures, model: &Run, curve: &Run, covered: Option<&Covered>) -> Vec<Section> {
    let two = |point: &dyn Fn(&Sample) -> [f64; 2]| {
        vec![series(Role::FvOnly, FV_ONLY, curve, point), series(Role::Model, MODEL, model, point)]
    };
    let mut columns = vec![Column::words("corner")];
    columns.extend(["displacement, mm", "velocity, mm/s"].map(Column::figures));
    columns.extend(["model", "curve"].map(|name| Column::figures(name).of("largest force, N")));
    columns.push(Column::figures("rms difference, N"));
    columns.extend(["model", "curve"].map(|name| Column::figures(name).of("energy, J")));
    let rows = f
        .corners
        .iter()
        .map(|c| {
            vec![
                c.corner.to_owned(),
                span(c.saw.displacement_m),
                span(c.saw.velocity_m_s),
                numbers::force(c.largest_force_n),
                numbers::force(c.largest_force_fv_n),
                numbers::error(c.rms_force_difference_n),
                numbers::error(c.energy_j),
                numbers::error(c.energy_fv_j),
            ]
        })
        .collect();
    let caption = "What every damper saw and gave. L1 is front left, R2 rear right.".to_owned();
    let lead = table(f).lines().last().unwrap_or_default().to_owned();
    let mut out = vec![Section::new(
        "summary",
        "Summary",
        vec![Block::Lead(lead), Block::Table(Table { caption, columns, rows, sortable: false })],
    )];
    let corner_figures = (0..4)
        .map(|i| {
            let point = |s: &Sample| [1e3 * s.corner[i].velocity, s.corner[i].force];
            // The curve last: it is narrow and would be buried under the model's loops.
            let both = two(&point).into_iter().rev().collect();
            let plane = plane(format!("{}: force over velocity", CORNERS[i]), VELOCITY, FORCE, both);
            Figure::new(format!("force-velocity-{}", CORNERS[i]), plane.draw_traces())
        })
        .collect();
    out.push(Section::new("corners", "Corners", vec![Block::Figures(corner_figures)]));
    let chassis = [
        ("heave", "Chassis displacement", "heave, mm", (|s| 1e3 * s.body.position[0]) as fn(&Sample) -> f64),
        ("acceleration", "Chassis acceleration", "heave acceleration, m/s²", |s| s.body.heave_acceleration),
        ("roll", "Roll", "roll, °", |s| s.body.position[1].to_degrees()),
        ("lateral", "Lateral acceleration", "lateral acceleration, m/s²", |s| s.body.lateral_acceleration),
    ]
    .into_iter()
    .map(|(file, title, y, value)| {
        let mut plane = plane(title.to_owned(), "time, s", y, two(&|s: &Sample| [s.time, value(s)]));
        plane.x = Axis::exactly("time, s", 0.0, model.samples.last().map_or(0.0, |s| s.time));
        Figure::new(file, plane.draw_long())
    })
    .collect();
    out.push(Section::new("chassis", "Chassis", vec![Block::Figures(chassis)]));
    let regions = (0..4)
        .map(|i| {
            let saw = series(Role::Model, "in the vehicle", model, |s| {
                [1e3 * s.corner[i].displacement, 1e3 * s.corner[i].velocity]
            });
            let mut all = Vec::new();
            if let Some(c) = covered {
                let milli = |line: &Vec<[f64; 2]>| line.iter().map(|p| [1e3 * p[0], 1e3 * p[1]]).collect();
                let lines = c.loops.iter().map(milli).collect();
                all.push(Series { role: Role::Measured, label: "rig tests", lines, dotted: false });
            }
            all.push(saw);
            let plane = plane(format!("{}: operating region", CORNERS[i]), "displacement, mm", VELOCITY, all);
            Figure::new(format!("region-{}", CORNERS[i]), plane.draw_traces())
        })
        .collect();
    let told = match covered {
        Some(_) => {
            "Where the dampers worked, over the loops that the rig tests measured. Outside them the model is not checked."
        }
        None => "Where the dampers worked. With --tests the loops of the rig tests are drawn below.",
    };
    out.push(Section::new("region", "Operating region", vec![Block::Paragraph(told.into()), Block::Figures(regions)]));
    out
}
