//! The forces that a model gives for the motion of a record.

use crate::motion;
use crate::records::Record;
use dashpot_core::step::step_into;
use dashpot_core::{Input, Model, Output, State};

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
    let mut state = model.settled(&input(0));
    let mut forces = vec![dashpot_core::evaluate::force(model, &state, &input(0)).force];
    let (mut next, mut output) = (State::ZERO, Output::ZERO);
    for i in 1..n {
        step_into(model, &state, &input(i), record.time[i] - record.time[i - 1], &mut next, &mut output);
        state = next;
        forces.push(output.force);
    }
    forces
}
