//! A semi-active damper of the second laboratory, identified as a function of its current. Evaluates the predictions of
//! the identified damper for data that the fit did not use.

use crate::EvaluationError;
use dashpot_core::Input;
use dashpot_core::family::Definition;
use dashpot_estimation::family::response::run as run_family;
use dashpot_estimation::segment::Segment;
use dashpot_identification::FitOptions;
use dashpot_identification::family::{FamilyFit, fit_family};
use dashpot_identification::model_file::prepared_family;
use dashpot_identification::validation::ResponseTimes;
use dashpot_other_lab::semi_active::{
    Command, LEFT_OUT, SemiActivePlant, SemiActiveRecord, SemiActiveTest, protocol, steps,
};
use dashpot_other_lab::{Accuracy, Protocol};
use dashpot_records::Record;
use dashpot_severity::SeverityError;
use dashpot_severity::measured::write_and_read;
use dashpot_simulation::prediction::predict_family;
use dashpot_simulation::step_response::{StepForces, mean_response};
use rayon::prelude::*;
use serde::Serialize;
use std::path::Path;

/// Sampling rate of the compared responses, 1/s.
const RATE: f64 = 10_000.0;
/// Grid of a response: start and end, s after the step, and number of intervals.
const GRID: (f64, f64, usize) = (-0.01, 0.09, 1000);

/// Time from a step of the current to 63 % of its effect, s, of the plant and of the identified model.
#[derive(Debug, Clone, Copy, Serialize)]
pub struct Lag {
    /// Currents before and after the step, A.
    pub step_a: [f64; 2],
    /// Time of the plant (the simulated true damper), s.
    pub plant_s: f64,
    /// Time of the model, s.
    pub model_s: f64,
}

impl Lag {
    /// Returns the relative error of the model.
    pub fn error(&self) -> f64 {
        self.model_s / self.plant_s - 1.0
    }
}

/// Result of the evaluation of one damper.
#[derive(Debug, Clone, Serialize)]
pub struct SemiActiveOutcome {
    /// Seed of the damper, its steps and its noise.
    pub seed: u64,
    /// Largest of [`SemiActiveOutcome::ratios`], at the worst current.
    pub worst_ratio: f64,
    /// Error ratio at each current inside the grid. It is the error of a fit without that current, relative to the
    /// error of a fit at that current alone.
    pub ratios: Vec<f64>,
    /// Largest mean error of the adjustable damper at a current without which it was fitted, in percent of the largest
    /// force of each test.
    pub left_out_percent: f64,
    /// Mean error over the left-out test with random current, as a fraction of the largest force of this test.
    pub random_error: f64,
    /// Lags of the valve position. Each position is expressed as the current at which it is the steady state.
    pub valve: Vec<Lag>,
    /// Lags of the force at constant speed.
    pub force: Vec<Lag>,
    /// Parts of the identified actuator, and its parameters with their intervals.
    pub actuator: String,
    /// Duration of the fit, s.
    pub seconds: f64,
}

impl SemiActiveOutcome {
    /// Returns the largest absolute relative error of the valve's lag.
    pub fn worst_lag(&self) -> f64 {
        self.valve.iter().map(|lag| lag.error().abs()).fold(0.0, f64::max)
    }
}

/// Measures tests and reads their records back from files.
///
/// # Errors
/// Returns the errors of the laboratory and the reader.
pub fn measure(
    plant: &SemiActivePlant,
    tests: &[SemiActiveTest],
    protocol: &Protocol,
    seed: u64,
) -> Result<Vec<Record>, EvaluationError> {
    let all: Vec<SemiActiveRecord> =
        tests.par_iter().map(|test| plant.run(test, protocol, &Accuracy::default(), seed)).collect::<Result<_, _>>()?;
    let write = |folder: &Path| -> Result<(), SeverityError> {
        std::fs::create_dir_all(folder)?;
        for one in &all {
            std::fs::write(folder.join(format!("{}.csv", one.record.name)), one.csv())?;
        }
        Ok(())
    };
    Ok(write_and_read(write)?)
}

/// Measures, fits and evaluates the damper of a seed with the whole protocol.
///
/// # Errors
/// Returns the errors of the laboratory, the reader and the fit.
pub fn evaluate(seed: u64) -> Result<SemiActiveOutcome, EvaluationError> {
    let plant = SemiActivePlant::new(seed);
    let tests = protocol(seed, plant.most);
    evaluate_tests(&plant, &tests, seed)
}

/// Measures, fits and evaluates a damper with the given tests.
///
/// # Errors
/// Returns the errors of the laboratory, the reader and the fit.
pub fn evaluate_tests(
    plant: &SemiActivePlant,
    tests: &[SemiActiveTest],
    seed: u64,
) -> Result<SemiActiveOutcome, EvaluationError> {
    let as_measured = Protocol { noise_percent: 1.0, ..Protocol::default() };
    let records = measure(plant, tests, &as_measured, seed)?;
    let (held_out, seen): (Vec<&Record>, Vec<&Record>) = records.iter().partition(|r| r.name.starts_with(LEFT_OUT));
    let begun = std::time::Instant::now();
    let found = fit_family(&seen, "current", &FitOptions::default(), |_| ())
        .map_err(|error| EvaluationError::Family(error.to_string()))?;
    let seconds = begun.elapsed().as_secs_f64();
    let ratios: Vec<f64> = found.settings.iter().filter_map(|of| of.left_out_ratio).collect();
    let worst_ratio = ratios.iter().copied().fold(0.0, f64::max);
    let inside = || found.settings.iter().filter(|of| of.left_out.is_some());
    let left_out_percent = inside().filter_map(|of| Some(of.left_out?.error_percent)).fold(0.0, f64::max);
    let family = prepared_family(&found.damper).map_err(|error| EvaluationError::Family(error.to_string()))?;
    let error = |record: &&Record| {
        let motion = dashpot_records::smoothing::smooth(record);
        let forces = predict_family(&family, record, &motion);
        let sum: f64 = forces.iter().zip(&record.force).map(|(a, b)| (a - b).abs()).sum();
        let top = record.force.iter().fold(0.0f64, |m, f| m.max(f.abs()));
        sum / forces.len() as f64 / top
    };
    let random_error = held_out.iter().map(error).fold(0.0, f64::max);
    let (valve, force) = lags(plant, &found.damper, seed)?;
    let actuator = describe(&found);
    Ok(SemiActiveOutcome { seed, worst_ratio, ratios, left_out_percent, random_error, valve, force, actuator, seconds })
}

fn describe(found: &FamilyFit) -> String {
    let Some(actuator) = &found.actuator else { return "no actuator".to_owned() };
    let number = |e: &dashpot_identification::Estimate| match (e.low, e.high) {
        (Some(low), Some(high)) => format!("{} {:.5} [{low:.5}, {high:.5}]", e.name, e.value),
        _ => format!("{} {:.5} open", e.name, e.value),
    };
    let parts: Vec<String> = actuator.parts.iter().map(|p| format!("{} {:.2}", p.name, p.probability)).collect();
    let numbers: Vec<String> = actuator.estimates.iter().map(number).collect();
    format!("{}; {}", parts.join(", "), numbers.join(", "))
}

/// Replaces the steps of a test's command by one constant current, A.
fn constant(test: &SemiActiveTest, level: f64) -> SemiActiveTest {
    SemiActiveTest { command: Command::Levels(vec![[0.0, level]]), ..test.clone() }
}

/// Computes the times to 63 % of the steps of valve position and force, s, for plant and model without noise.
fn lags(plant: &SemiActivePlant, damper: &Definition, seed: u64) -> Result<(Vec<Lag>, Vec<Lag>), EvaluationError> {
    let clean = Protocol { noise_percent: 0.0, sample_rate_hz: RATE, ..Protocol::default() };
    let grid: Vec<f64> = (0..=GRID.2).map(|k| GRID.0 + (GRID.1 - GRID.0) * k as f64 / GRID.2 as f64).collect();
    let map = plant.stage_map();
    let family = prepared_family(damper).map_err(|error| EvaluationError::Family(error.to_string()))?;
    // Use only the tests at 300 mm/s, which have three pairs of current levels.
    let tests: Vec<SemiActiveTest> = steps(seed).into_iter().filter(|test| test.name.ends_with("_300mm_s")).collect();
    let (mut valves, mut forces) = (Vec::new(), Vec::new());
    for test in &tests {
        let Command::Levels(levels) = &test.command else { continue };
        let accuracy = Accuracy { relative: 1e-4, absolute: 0.1, longest: 0.5 };
        let run = |test: &SemiActiveTest| plant.run(test, &clean, &accuracy, seed);
        let stepped = run(test)?;
        let (low, high) = (levels[0][1], levels[1][1]);
        let at = [run(&constant(test, low))?, run(&constant(test, high))?];
        let segment = segment(&stepped, Some(&stepped.command_a));
        let (model, settings) = run_family(&family, &segment);
        let constant_model = [low, high].map(|level| {
            let commands = vec![level; segment.input.len()];
            run_family(&family, &Segment { setting: Some(commands), ..segment.clone() }).0
        });
        let equivalent: Vec<f64> = stepped.stage_m.iter().map(|stage| current_of(&map, *stage)).collect();
        let time = &stepped.record.time_s;
        for (from, to) in [(low, high), (high, low)] {
            let [before, after] = if to > from { [0, 1] } else { [1, 0] };
            let ends = |k: usize| levels.get(k + 1).map_or(time[time.len() - 1] - 0.1, |next| next[0]);
            let instants: Vec<(f64, f64)> =
                (1..levels.len()).filter(|k| levels[*k][1] == to).map(|k| (levels[k][0], ends(k))).collect();
            let cut = |force: &[f64], before: &[f64], after: &[f64]| -> Vec<StepForces> {
                let of = |(instant, end): &(f64, f64)| {
                    let range = time.partition_point(|t| *t < instant + 1.1 * GRID.0)
                        ..time.partition_point(|t| *t < end.min(instant + 1.1 * GRID.1));
                    StepForces {
                        velocity_window_s: 0.0,
                        time: time[range.clone()].iter().map(|t| t - instant).collect(),
                        force: force[range.clone()].to_vec(),
                        before: before[range.clone()].to_vec(),
                        after: after[range].to_vec(),
                    }
                };
                instants.iter().map(of).collect()
            };
            let t63 = |steps: &[StepForces]| {
                ResponseTimes::measure(&grid, &mean_response(steps, &grid)).map_or(f64::NAN, |times| times.t63_s)
            };
            let plant_force =
                cut(&stepped.record.clean_force_n, &at[before].record.clean_force_n, &at[after].record.clean_force_n);
            let model_force = cut(&model, &constant_model[before], &constant_model[after]);
            forces.push(Lag { step_a: [from, to], plant_s: t63(&plant_force), model_s: t63(&model_force) });
            let levels = [from, to].map(|level| vec![level; time.len()]);
            let plant_valve = cut(&equivalent, &levels[0], &levels[1]);
            let model_valve = cut(&settings, &levels[0], &levels[1]);
            valves.push(Lag { step_a: [from, to], plant_s: t63(&plant_valve), model_s: t63(&model_valve) });
        }
    }
    Ok((valves, forces))
}

/// Returns the current, A, at which a position of the main stage, m, is the steady state.
fn current_of(map: &[[f64; 2]], stage: f64) -> f64 {
    let right = map.partition_point(|[place, _]| *place < stage).min(map.len() - 1).max(1);
    let ([x0, i0], [x1, i1]) = (map[right - 1], map[right]);
    i0 + (stage - x0) / (x1 - x0) * (i1 - i0)
}

fn segment(record: &SemiActiveRecord, command: Option<&[f64]>) -> Segment {
    let of = &record.record;
    let velocity = of.velocity_m_s.clone().unwrap_or_default();
    let input = of.displacement_m.iter().zip(&velocity).map(|(x, v)| Input::motion(*x, *v)).collect();
    let dt = std::iter::once(0.0).chain(of.time_s.windows(2).map(|t| t[1] - t[0])).collect();
    Segment {
        name: of.name.clone(),
        dt,
        input,
        setting: command.map(<[f64]>::to_vec),
        force: of.clean_force_n.clone(),
        from: 0,
        scale: 1.0,
        top: 1.0,
        peak_velocity: 1.0,
        amplitude: 1.0,
        clock: 0.0,
    }
}
