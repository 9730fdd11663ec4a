//! `dashpot bench`: cost and accuracy of the integration step.

use crate::progress::Progress;
use anyhow::bail;
use dashpot_core::number;
use dashpot_core::step::{Integration, Method, step_into};
use dashpot_core::{Input, Model, Output, Params};
use dashpot_rig::Matrix;
use dashpot_simulation::accuracy::{HostInput, References, Sine, worst};
use serde::Serialize;
use std::path::PathBuf;
use std::process::Command;
use std::time::Instant;

/// Measure error against cost of the fixed step over the test matrix
///
/// Errors are relative to each test's largest force, and the largest over all tests is reported. The reference is a converged solution
/// under the exact motion. Valgrind counts the instructions if it is installed. Times depend on the machine.
#[derive(clap::Args)]
#[command(after_help = "Example:\n  dashpot bench --json bench.json")]
pub struct Args {
    /// Figures as JSON; - for standard output
    #[arg(long, value_name = "F")]
    json: Option<PathBuf>,
    /// Run a number of steps of one integration and print nothing, for the instruction count
    #[arg(long, hide = true, num_args = 3, value_names = ["METHOD", "SUBSTEPS", "STEPS"])]
    spin: Option<Vec<String>>,
}

#[derive(Serialize)]
struct Row {
    model: &'static str,
    method: &'static str,
    substeps: u32,
    automatic: bool,
    rms_percent_1ms: f64,
    largest_percent_1ms: f64,
    rms_percent_quarter_ms: f64,
    rms_percent_velocity_only: f64,
    instructions: Option<u64>,
    nanoseconds: f64,
}

const METHODS: [(&str, Method); 5] = [
    ("euler", Method::Euler),
    ("second_order", Method::Second),
    ("three_stage", Method::ThreeStage),
    ("third_order", Method::Third),
    ("fourth_order", Method::Fourth),
];
/// Step of the host in the comparison and in the timing, s.
const STEP: f64 = 1e-3;
/// Number of steps with which one integration is timed, in all its seven runs together.
const TIMED: usize = 200_000;

/// Runs the verb.
pub fn run(args: &Args) -> anyhow::Result<()> {
    if let Some(spin) = &args.spin {
        return spin_for(spin);
    }
    dashpot_output::check_kinds([(args.json.as_deref(), dashpot_output::Kind::Figures)])?;
    let tests: Vec<Sine> = Matrix::default()
        .points()
        .iter()
        .map(|p| Sine { amplitude: p.amplitude_m, frequency: p.frequency_hz })
        .collect();
    let counted = count("euler", 1).is_some();
    let models: [(&str, f64, f64); 2] = [("default", 3e6, 0.5), ("stiff", 1e7, 0.1)];
    let choices: [(Method, u32); 9] = [
        (Method::Euler, 1),
        (Method::Second, 1),
        (Method::Second, 3),
        (Method::ThreeStage, 1),
        (Method::ThreeStage, 2),
        (Method::Third, 1),
        (Method::Third, 2),
        (Method::Fourth, 1),
        (Method::Fourth, 4),
    ];
    let progress = Progress::new("measuring");
    let mut rows = Vec::new();
    for (k, (name, stiffness, mass)) in models.into_iter().enumerate() {
        let mut params = Params::new();
        // The values lie inside the bounds of the parameter table, so setting them cannot fail.
        let _ = params.set(number!("series_stiffness"), stiffness);
        let _ = params.set(number!("internal_mass"), mass);
        let Ok(model) = Model::new(&params) else { bail!("the built-in model {name} is refused") };
        progress.say((k as f64 + 0.1) / models.len() as f64, "solving the reference");
        let references = References::solve(&model, &tests, 0.25 * STEP);
        let chosen = model.integration();
        let last = [(chosen.method, chosen.substeps(STEP), true)];
        for (method, substeps, automatic) in
            choices.map(|(method, substeps)| (method, substeps, false)).into_iter().chain(last)
        {
            let Some((method_name, _)) = METHODS.into_iter().find(|(_, each)| *each == method) else { continue };
            progress.say((k as f64 + 0.5) / models.len() as f64, method_name);
            let run = if automatic { model } else { model.with_integration(Integration::fixed(method, substeps)) };
            let exact = worst(&references.compare(&run, STEP, HostInput::Motion));
            rows.push(Row {
                model: name,
                method: method_name,
                substeps,
                automatic,
                rms_percent_1ms: 100.0 * exact.rms,
                largest_percent_1ms: 100.0 * exact.largest,
                rms_percent_quarter_ms: 100.0 * worst(&references.compare(&run, 0.25 * STEP, HostInput::Motion)).rms,
                rms_percent_velocity_only: 100.0 * worst(&references.compare(&run, STEP, HostInput::Velocity)).rms,
                instructions: if counted { count(method_name, substeps) } else { None },
                nanoseconds: time(&run),
            });
        }
    }
    drop(progress);
    let json = args.json.as_deref();
    dashpot_output::say(json, &table(&rows))?;
    if !counted {
        dashpot_output::say(
            json,
            "instructions need valgrind, which is not installed (Debian: apt-get install valgrind)",
        )?;
    }
    if let Some(path) = json {
        dashpot_output::json(path, &rows)?;
    }
    Ok(())
}

fn table(rows: &[Row]) -> String {
    let mut out = format!(
        "{:<8} {:<13} {:>8} {:>12} {:>12} {:>14} {:>14} {:>13} {:>8}\n",
        "model",
        "method",
        "substeps",
        "rms % 1 ms",
        "max % 1 ms",
        "rms % 0.25 ms",
        "rms % v alone",
        "instructions",
        "ns"
    );
    for r in rows {
        let substeps = if r.automatic { format!("auto ({})", r.substeps) } else { r.substeps.to_string() };
        out += &format!(
            "{:<8} {:<13} {:>8} {:>12.4} {:>12.4} {:>14.5} {:>14.4} {:>13} {:>8.0}\n",
            r.model,
            r.method,
            substeps,
            r.rms_percent_1ms,
            r.largest_percent_1ms,
            r.rms_percent_quarter_ms,
            r.rms_percent_velocity_only,
            r.instructions.map_or("-".to_owned(), |i| i.to_string()),
            r.nanoseconds
        );
    }
    out.trim_end().to_owned()
}

/// Returns a damper motion with a body frequency, 9.4 rad/s, and a wheel frequency, 81.7 rad/s, as in a simulated vehicle.
fn road() -> Vec<Input> {
    (0..4096)
        .map(|i| {
            let t = STEP * i as f64;
            let (a, b) = (9.4, 81.7);
            Input::motion(
                0.03 * libm::sin(a * t) + 0.004 * libm::sin(b * t + 1.0),
                0.03 * a * libm::cos(a * t) + 0.004 * b * libm::cos(b * t + 1.0),
            )
        })
        .collect()
}

fn spin(model: &Model, steps: usize) -> f64 {
    let road = road();
    let mut state = model.steady_state(&road[0]);
    let mut output = Output::ZERO;
    let mut sum = 0.0;
    for i in 0..steps {
        let from = state;
        step_into(model, &from, &road[i & 4095], STEP, &mut state, &mut output);
        sum += output.force + output.d_force_d_displacement + output.d_force_d_velocity;
    }
    sum
}

fn time(model: &Model) -> f64 {
    // Use the fastest of several runs, because other work on the machine disturbed it least.
    (0..7)
        .map(|_| {
            let start = Instant::now();
            std::hint::black_box(spin(model, TIMED / 7));
            start.elapsed().as_nanos() as f64 / (TIMED / 7) as f64
        })
        .fold(f64::INFINITY, f64::min)
}

fn spin_for(words: &[String]) -> anyhow::Result<()> {
    let method = METHODS.iter().find(|(name, _)| *name == words[0]);
    let (Some((_, method)), Ok(substeps), Ok(steps)) = (method, words[1].parse(), words[2].parse()) else {
        bail!("--spin takes a method, a number of substeps and a number of steps");
    };
    let Ok(model) = Model::new(&Params::new()) else { bail!("the default model is refused") };
    std::hint::black_box(spin(&model.with_integration(Integration::fixed(*method, substeps)), steps));
    Ok(())
}

/// Counts the instructions of one step, from the difference of two runs under callgrind. Returns `None` if Valgrind does
/// not run.
fn count(method: &str, substeps: u32) -> Option<u64> {
    let total = |steps: u32| -> Option<u64> {
        let out = Command::new("valgrind")
            .args(["--tool=callgrind", "--callgrind-out-file=/dev/null"])
            .arg(std::env::current_exe().ok()?)
            .args(["bench", "--spin", method, &substeps.to_string(), &steps.to_string()])
            .output()
            .ok()?;
        let text = String::from_utf8_lossy(&out.stderr).into_owned();
        text.lines().find_map(|l| l.split("Collected :").nth(1))?.trim().parse().ok()
    };
    Some((total(6000)? - total(2000)?) / 4000)
}
