//! Forces that a model predicts for the motion of a record.

use crate::warm_starts::warm;
use dashpot_core::family::Family;
use dashpot_core::step::force_in_place;
use dashpot_core::{Input, Model, State};
use dashpot_estimation::samples::input_at;
use dashpot_records::Record;
use dashpot_records::smoothing::Motion;

/// Predicts the forces of a model, N, at the samples of a record. `motion` is the smoothed motion of the record, and the model starts in
/// the steady state.
///
/// [`dashpot_records::smoothing::smooth`] computes the motion. At the start, the oil is warmer than the surroundings by `rise`, K
/// ([`WarmStarts`](crate::warm_starts::WarmStarts)).
pub fn predict(model: &Model, record: &Record, motion: &Motion, rise: f64) -> Vec<f64> {
    let n = record.time.len();
    let input = |i: usize| input_at(record, motion, i);
    let run = |start: State, range: std::ops::Range<usize>, forces: &mut Vec<f64>| {
        let (mut state, mut force) = (start, 0.0);
        for i in range {
            // If the step gives no finite result, state and force keep their values.
            force = force_in_place(model, &mut state, &input(i), record.time[i] - record.time[i - 1]).unwrap_or(force);
            forces.push(force);
        }
        state
    };
    let mut start = model.steady_state(&input(0));
    warm(model, &mut start, rise);
    // A periodic record is a part of a longer test, so the internal state at its start equals the internal state one cycle later.
    if let Some(first) = record.cycles.first().filter(|c| c.start == 0 && c.end < n) {
        let later = run(start, 1..first.end + 1, &mut Vec::new());
        start.mass_displacement = later.mass_displacement - later.displacement + start.displacement;
        start.mass_velocity = later.mass_velocity;
        start.internal = later.internal;
        warm(model, &mut start, rise);
    }
    let mut forces = vec![dashpot_core::evaluate::force(model, &start, &input(0)).force];
    run(start, 1..n, &mut forces);
    forces
}

/// Predicts the forces, N, of an adjustable damper at the samples of a record in which the setting changes.
///
/// The command between two samples is the mean of their settings, because a change is equally likely in both halves of the interval.
pub fn predict_family(family: &Family, record: &Record, motion: &Motion) -> Vec<f64> {
    let n = record.time.len();
    let input = |i: usize| input_at(record, motion, i);
    let command = |i: usize| record.setting_signal.as_ref().map(|signal| signal.command(i));
    let mut state = family.steady_state(&input(0), command(0));
    let mut delay = family.steady_delay(command(0));
    let (mut output, _) = family.evaluate(&state, &input(0), command(0));
    let mut forces = vec![output.force];
    for i in 1..n {
        let dt = record.time[i] - record.time[i - 1];
        // If the step gives no finite result, state and force keep their values.
        let mut next = output;
        if family.step_in_place(&mut state, &mut delay, &input(i), command(i), dt, &mut next, false) {
            output = next;
        }
        forces.push(output.force);
    }
    forces
}

/// Returns velocities, m/s, and the forces of the model, N, at these constant velocities and displacement zero: FV curve, friction and gas
/// force. Velocities at which the force is not finite are left out.
pub fn at_velocities(model: &Model, velocities: &[f64]) -> Vec<[f64; 2]> {
    let at = |velocity: f64| {
        let input = Input::motion(0.0, velocity);
        dashpot_core::evaluate::force(model, &model.steady_state(&input), &input).force
    };
    velocities.iter().map(|v| [*v, at(*v)]).filter(|p| p[1].is_finite()).collect()
}

/// Returns velocities, m/s, and forces, N, as [`at_velocities`] computes them, from the negative velocity `low` to the positive velocity
/// `high`.
///
/// The velocities are dense near zero, where friction and bleed determine the shape of the curve.
pub fn between_velocities(model: &Model, low: f64, high: f64) -> Vec<[f64; 2]> {
    /// Number of points on each side of zero.
    const POINTS: i32 = 120;
    let at = |k: i32| {
        let share = f64::from(k) / f64::from(POINTS);
        share * share * if k < 0 { low } else { high }
    };
    at_velocities(model, &(-POINTS..=POINTS).map(at).collect::<Vec<_>>())
}
