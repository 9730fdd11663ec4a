//! Simulation of an adjustable damper along a segment whose setting changes.

use crate::segment::Segment;
use dashpot_core::Input;
use dashpot_core::family::Family;
use dashpot_core::input::Path;

/// Number of simulation steps for each sample while the valve moves. A time step uses the setting at its end, so a
/// moving valve leads slower states by half a step. With steps of a whole sample, 1 ms, an identified lag was 0.3 ms
/// too long.
const PARTS: u32 = 4;
/// Change of the valve's position within a sample, as a fraction of the grid's range, above which the valve counts as
/// moving.
const MOVING: f64 = 1e-3;

/// Computes the forces, N, and the valve's positions, in the unit of the setting, at the samples of a segment. The
/// simulation begins at the equilibrium of the first sample.
pub fn run(family: &Family, segment: &Segment) -> (Vec<f64>, Vec<f64>) {
    run_commanded(family, segment, segment.setting.as_deref())
}

/// Returns the input at the fraction `theta` of a time step, which ends with `input`.
fn part_of(input: &Input, path: &Path, theta: f64) -> Input {
    let point = path.point(theta);
    Input { displacement: Some(point.x), velocity: point.v, ..*input }
}

/// Computes forces, N, and valve positions, in the unit of the setting, under other commands than those of the segment.
/// Each command applies to the step that ends at its sample.
pub fn run_commanded(family: &Family, segment: &Segment, commands: Option<&[f64]>) -> (Vec<f64>, Vec<f64>) {
    let command = |sample: usize| commands.and_then(|all| all.get(sample)).copied();
    let count = segment.input.len();
    let (mut forces, mut settings) = (Vec::with_capacity(count), Vec::with_capacity(count));
    let Some(first) = segment.input.first() else { return (forces, settings) };
    let mut state = family.steady_state(first, command(0));
    let mut delay = family.steady_delay(command(0));
    let (mut output, _) = family.evaluate(&state, first, command(0));
    forces.push(output.force);
    settings.push(family.setting_of(&state, command(0)));
    let (low, high) = family.range();
    for (i, input) in segment.input.iter().enumerate().skip(1) {
        let dt = segment.dt[i];
        let moved = settings.iter().rev().take(2).copied().reduce(|last, before| last - before).unwrap_or(0.0);
        let is_moving = command(i) != command(i - 1) || settings.len() > 1 && moved.abs() > MOVING * (high - low);
        let parts = if is_moving && dt > 0.0 { PARTS } else { 1 };
        let path = Path::new(state.displacement, state.velocity, input, dt);
        let mut is_finite = true;
        for part in 1..=parts {
            let end = if part == parts { *input } else { part_of(input, &path, f64::from(part) / f64::from(parts)) };
            let dt = dt / f64::from(parts);
            is_finite &= family.step_in_place(&mut state, &mut delay, &end, command(i), dt, &mut output, false);
        }
        forces.push(if is_finite { output.force } else { f64::NAN });
        settings.push(family.setting_of(&state, command(i)));
    }
    (forces, settings)
}
