//! Independent integrator for reference solutions: Radau IIA of order 5 on the continuous equations of the model.
//!
//! The integrator shares only [`dashpot_core::evaluate()`] and its derivatives with the fixed step `dashpot_core::step`. The motion is
//! evaluated exactly, and Newton's method solves all three Radau stages together to rounding. Callers must choose steps so short that
//! halving them does not change the result.

use dashpot_core::evaluate::partials;
use dashpot_core::{Input, Model, State, evaluate};
use nalgebra::{DMatrix, DVector};

/// Imposed motion: displacement and velocity at a time.
pub trait PrescribedMotion {
    /// Returns displacement, m, and velocity, m/s, at time `t`, s.
    fn evaluate(&self, t: f64) -> (f64, f64);
}

impl<F: Fn(f64) -> (f64, f64)> PrescribedMotion for F {
    fn evaluate(&self, t: f64) -> (f64, f64) {
        self(t)
    }
}

/// Simulates the model from the steady state. Returns the force, N, at each multiple of `dt`, s: `steps + 1` values.
///
/// Every interval is divided into `parts` Radau steps.
pub fn reference_forces(
    model: &Model,
    motion: &impl PrescribedMotion,
    dt: f64,
    steps: usize,
    parts: usize,
) -> Vec<f64> {
    let input = |t: f64| {
        let (x, v) = motion.evaluate(t);
        Input::motion(x, v)
    };
    let mut state = model.steady_state(&input(0.0));
    let mut forces = vec![evaluate(model, &state, &input(0.0)).0.force];
    let h = dt / parts as f64;
    for i in 0..steps {
        for j in 0..parts {
            state = radau_step(model, &state, &input, i as f64 * dt + j as f64 * h, h);
        }
        forces.push(evaluate(model, &state, &input((i + 1) as f64 * dt)).0.force);
    }
    forces
}

fn pack(state: &State, memory: usize) -> Vec<f64> {
    let mut y = vec![state.mass_displacement, state.mass_velocity];
    y.extend(&state.internal[..memory]);
    y
}

fn unpack(y: &[f64], memory: usize) -> State {
    let mut state = State { mass_displacement: y[0], mass_velocity: y[1], ..State::ZERO };
    state.internal[..memory].copy_from_slice(&y[2..2 + memory]);
    state
}

fn radau_step(model: &Model, from: &State, input: &impl Fn(f64) -> Input, t: f64, h: f64) -> State {
    let s6 = 6f64.sqrt();
    let c = [(4.0 - s6) / 10.0, (4.0 + s6) / 10.0, 1.0];
    let a = [
        [(88.0 - 7.0 * s6) / 360.0, (296.0 - 169.0 * s6) / 1800.0, (-2.0 + 3.0 * s6) / 225.0],
        [(296.0 + 169.0 * s6) / 1800.0, (88.0 + 7.0 * s6) / 360.0, (-2.0 - 3.0 * s6) / 225.0],
        [(16.0 - s6) / 36.0, (16.0 + s6) / 36.0, 1.0 / 9.0],
    ];
    let memory = model.elements().memories();
    let n = 2 + memory;
    let y0 = pack(from, memory);
    let mut stages = vec![y0.clone(); 3];
    for _ in 0..50 {
        let rates: Vec<Vec<f64>> = stages
            .iter()
            .zip(c)
            .map(|(y, c)| pack(&evaluate(model, &unpack(y, memory), &input(t + c * h)).1, memory))
            .collect();
        let residual = DVector::from_fn(3 * n, |row, _| {
            let (i, k) = (row / n, row % n);
            stages[i][k] - y0[k] - h * (0..3).map(|j| a[i][j] * rates[j][k]).sum::<f64>()
        });
        let jacobians: Vec<_> =
            stages.iter().zip(c).map(|(y, c)| partials(model, &unpack(y, memory), &input(t + c * h))).collect();
        let jacobian = DMatrix::from_fn(3 * n, 3 * n, |row, column| {
            let (i, k, j, l) = (row / n, row % n, column / n, column % n);
            f64::from(u8::from(row == column)) - h * a[i][j] * jacobians[j].d_rate_d_state[k][l]
        });
        let Some(step) = jacobian.lu().solve(&residual) else { break };
        for row in 0..3 * n {
            stages[row / n][row % n] -= step[row];
        }
        if step.amax() < 1e-13 {
            break;
        }
    }
    unpack(&stages[2], memory)
}
