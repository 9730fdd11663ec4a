//! The forces that a model gives for the motion of a record.

use crate::motion;
use crate::records::Record;
use dashpot_core::step::{Integration, Method, step_into};
use dashpot_core::{Input, Model, Output, State};

/// Above this sample distance a model is quasi-static between samples and one cheap substep is exact enough.
pub const SLOW_STEP: f64 = 0.02;

/// How a model is stepped over samples that lie `dt` apart.
pub fn integration_for(model: &Model, dt: f64) -> Integration {
    if dt > SLOW_STEP { Integration::fixed(Method::Second, 1) } else { model.integration() }
}

/// Forces of the model at the samples of a record, driven by its smoothed motion from the settled state.
pub fn predict(model: &Model, record: &Record) -> Vec<f64> {
    let motion = motion::smooth(record);
    let n = record.time.len();
    let input = |i: usize| Input {
        displacement: Some(motion.displacement[i]),
        velocity: motion.velocity[i],
        side_force: record.side_force.as_ref().map_or(0.0, |c| c[i]),
        temperature: record.temperature.as_ref().map_or(20.0, |c| c[i]),
    };
    let mean_dt = (record.time[n - 1] - record.time[0]) / (n - 1).max(1) as f64;
    let model = model.with_integration(integration_for(model, mean_dt));
    let mut state = model.settled(&input(0));
    let mut forces = vec![dashpot_core::evaluate::force(&model, &state, &input(0)).force];
    let (mut next, mut output) = (State::ZERO, Output::ZERO);
    for i in 1..n {
        step_into(&model, &state, &input(i), record.time[i] - record.time[i - 1], &mut next, &mut output);
        state = next;
        forces.push(output.force);
    }
    forces
}
