//! Error of the model's fixed step (`dashpot_core::step`) relative to a converged solution, over a matrix of sine tests.

pub mod radau;

use dashpot_core::{Input, Model, step};
use rayon::prelude::*;
use std::f64::consts::TAU;

/// Sine test.
#[derive(Debug, Clone, Copy)]
pub struct Sine {
    /// Amplitude, m.
    pub amplitude: f64,
    /// Frequency, Hz.
    pub frequency: f64,
}

impl Sine {
    /// Returns displacement, m, and velocity, m/s, over time, s. The motion starts at rest at the lower end of the stroke.
    pub fn motion(self) -> impl Fn(f64) -> (f64, f64) {
        let (a, w) = (self.amplitude, TAU * self.frequency);
        move |t| (-a * libm::cos(w * t), a * w * libm::sin(w * t))
    }
}

/// Input that the host provides at each step.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum HostInput {
    /// Displacement and velocity.
    Motion,
    /// Velocity only.
    Velocity,
}

/// Force errors of one test, as fractions of the largest force of this test.
#[derive(Debug, Clone, Copy, Default)]
pub struct Errors {
    /// Root mean square error, as a fraction of the largest force.
    pub rms: f64,
    /// Largest error, as a fraction of the largest force.
    pub largest: f64,
}

/// Computes the forces, N, of the model's fixed step at each multiple of `dt`, s: `steps + 1` values. The simulation starts in the steady
/// state.
pub fn step_forces(
    model: &Model,
    motion: &impl radau::PrescribedMotion,
    dt: f64,
    steps: usize,
    given: HostInput,
) -> Vec<f64> {
    let input = |t: f64| {
        let (x, v) = motion.evaluate(t);
        match given {
            HostInput::Motion => Input::motion(x, v),
            HostInput::Velocity => Input::velocity(v),
        }
    };
    let (x, v) = motion.evaluate(0.0);
    let mut state = model.steady_state(&Input::motion(x, v));
    let mut forces = vec![dashpot_core::evaluate(model, &state, &Input::motion(x, v)).0.force];
    for i in 1..=steps {
        let (next, output) = step(model, &state, &input(i as f64 * dt), dt);
        state = next;
        forces.push(output.force);
    }
    forces
}

/// Computes the errors of `forces`, N, relative to the largest force of `exact`, N.
pub fn errors(forces: &[f64], exact: &[f64]) -> Errors {
    let top = exact.iter().fold(0.0f64, |m, f| m.max(f.abs()));
    let (mut sum, mut largest) = (0.0, 0.0f64);
    for (f, e) in forces.iter().zip(exact) {
        sum += (f - e) * (f - e);
        largest = largest.max((f - e).abs());
    }
    Errors { rms: (sum / exact.len() as f64).sqrt() / top, largest: largest / top }
}

/// Converged reference forces of each test, on the grid of the finest step of a comparison.
pub struct References {
    tests: Vec<(Sine, Vec<f64>)>,
    dt: f64,
}

/// Number of Radau steps in an interval of the reference grid. Twice the number changes the reference by less than a thousandth of the
/// measured errors (see the tests).
const PARTS: usize = 4;
/// Number of cycles of each test. Slow tests are truncated to [`LONGEST`].
const CYCLES: f64 = 2.0;
/// Longest duration of a test, s.
const LONGEST: f64 = 8.0;

impl References {
    /// Solves each test on a grid with the step `dt`, s.
    pub fn solve(model: &Model, tests: &[Sine], dt: f64) -> References {
        let tests = tests
            .par_iter()
            .map(|sine| {
                let steps = ((CYCLES / sine.frequency).min(LONGEST) / dt).ceil() as usize;
                // The coarsest host step of a comparison is 40 steps of the reference grid. The number of grid steps is a multiple of 40.
                // So every host step whose number of grid steps divides 40 ends at the end of the test.
                let steps = steps.div_ceil(40) * 40;
                (*sine, radau::reference_forces(model, &sine.motion(), dt, steps, PARTS))
            })
            .collect();
        References { tests, dt }
    }

    /// Returns the tests and their reference forces, N, at each multiple of the reference step.
    pub fn forces(&self) -> impl Iterator<Item = (Sine, &[f64])> {
        self.tests.iter().map(|(sine, exact)| (*sine, exact.as_slice()))
    }

    /// Computes the errors of the model's step at the host step `dt`, s, for each test. `dt` must be a multiple of the reference step.
    pub fn compare(&self, model: &Model, dt: f64, given: HostInput) -> Vec<(Sine, Errors)> {
        let every = (dt / self.dt).round() as usize;
        self.tests
            .par_iter()
            .map(|(sine, exact)| {
                let exact: Vec<f64> = exact.iter().copied().step_by(every).collect();
                let forces = step_forces(model, &sine.motion(), dt, exact.len() - 1, given);
                (*sine, errors(&forces, &exact))
            })
            .collect()
    }
}

/// Returns the largest root mean square error and the largest error over several tests.
pub fn worst(errors: &[(Sine, Errors)]) -> Errors {
    errors
        .iter()
        .fold(Errors::default(), |w, (_, e)| Errors { rms: w.rms.max(e.rms), largest: w.largest.max(e.largest) })
}
