//! Comparison of the derivatives of a step with finite differences, over random cases.

use crate::case::{Case, Given, prepare};
use dashpot_abi::model::dashpot_model;
use dashpot_abi::state::{dashpot_output, dashpot_state, dashpot_state_init};
use dashpot_abi::step::dashpot_step;
use dashpot_test_support::Random;
use std::mem::zeroed;

/// Step widths of the finite differences, for displacement, m, and velocity, m/s.
///
/// A wide difference may include a knee of the force that a narrow one excludes. For a void of a few nanometers, the opposite holds.
const WIDTHS: [[f64; 7]; 2] =
    [[1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11], [1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8]];
/// Largest deviation of a derivative from the finite differences, relative to the largest of the derivative and the one-sided
/// differences. A host's Newton iteration tolerates this deviation.
const NEAR: f64 = 0.02;
/// Rounding error of a finite difference of forces, relative to the forces.
const ROUNDING: f64 = 1e-13;
/// Shifts of the input that measure the numerical noise of the force, relative to the narrowest width. A shift may end the solver's
/// iteration one step earlier or later.
const AS_GOOD_AS_STILL: [f64; 4] = [-1e-2, -1e-3, 1e-3, 1e-2];

/// A failed comparison: the step in which it failed, and a description.
pub struct Off {
    pub step: usize,
    pub what: String,
}

fn one_step(model: &dashpot_model, from: &dashpot_state, given: &Given) -> Option<(dashpot_state, dashpot_output)> {
    // SAFETY: the structures contain only numbers, for which zero bytes are valid.
    let (mut to, mut output): (dashpot_state, dashpot_output) = unsafe { (zeroed(), zeroed()) };
    let input = given.input();
    // SAFETY: an initialized model and local blocks.
    let status = unsafe { dashpot_step(model, from, &input, given.dt, &mut to, &mut output) };
    (status >= 0).then_some((to, output))
}

/// Returns whether a derivative agrees with the differences of at least one width. It may equal a one-sided difference or lie between both.
///
/// Returns `None` if a force cannot be computed or its noise is too large, at every width.
fn is_derivative(got: f64, force: &dyn Fn(f64) -> Option<f64>, widths: &[f64]) -> Option<Result<(), String>> {
    let at = force(0.0)?;
    let narrowest = widths.iter().fold(f64::MAX, |a, b| a.min(*b));
    let noise = AS_GOOD_AS_STILL
        .iter()
        .filter_map(|share| force(share * narrowest))
        .map(|f| (f - at).abs())
        .fold(0.0, f64::max);
    let mut sides = Vec::new();
    for width in widths {
        let (Some(low), Some(high)) = (force(-width), force(*width)) else { continue };
        let (left, right) = ((at - low) / width, (high - at) / width);
        let size = left.abs().max(right.abs()).max(got.abs());
        let uncertain = 2.0 * (noise + ROUNDING * at.abs().max(low.abs()).max(high.abs())) / width;
        if uncertain > NEAR * size && size > 1.0 {
            continue;
        }
        let slack = NEAR * size + uncertain;
        if got >= left.min(right) - slack && got <= left.max(right) + slack {
            return Some(Ok(()));
        }
        sides.push((*width, left, right));
    }
    (!sides.is_empty()).then(|| Err(format!("{got:.6e}, noise {noise:.1e} of {at:.3e} N, one-sided {sides:?}")))
}

/// Largest distance, m, of a displacement from the integral of a linear velocity at which that velocity gives the derivatives.
///
/// This is a rule of `moving_mass` (step.md of the book). The kernel compares the displacement of the curvature, which is at most this large.
const OF_A_LINEAR_VELOCITY: f64 = 1e-9;

/// Returns whether a moving mass acts, and the displacement of a step is within [`OF_A_LINEAR_VELOCITY`] of the integral of a linear
/// velocity.
fn is_of_a_linear_velocity(case: &Case, from: &dashpot_state, given: &Given) -> bool {
    let integral = from.displacement + 0.5 * given.dt * (from.velocity + given.v);
    case.on.contains(&"moving_mass") && given.x.is_some_and(|x| (x - integral).abs() <= OF_A_LINEAR_VELOCITY)
}

/// Checks the derivatives that a step with a moving mass has at the integral of a linear velocity ([`is_of_a_linear_velocity`]).
///
/// Rounding decides there whether the displacement counts, so a difference over the displacement, or over the velocity alone, has no
/// limit that a host could use. Along the integral, both derivatives together must agree with the difference. The mass adds nothing to
/// that over the displacement, which must be that of the damper without the mass.
fn are_those_of_a_linear_velocity(
    case: &Case,
    model: &dashpot_model,
    from: &dashpot_state,
    given: &Given,
    output: &dashpot_output,
) -> Result<(), String> {
    let along = output.d_force_d_velocity + 0.5 * given.dt * output.d_force_d_displacement;
    let force =
        |h: f64| one_step(model, from, &Given { x: None, v: given.v + h, ..*given }).map(|(_, output)| output.force);
    is_derivative(along, &force, &WIDTHS[1]).unwrap_or(Ok(()))?;
    // The last of several values of a parameter counts.
    let mut without = case.clone();
    without.values.push(("moving_mass", vec![0.0]));
    let Some(model) = prepare(&without) else { return Ok(()) };
    let force =
        |h: f64| one_step(&model, from, &Given { x: given.x.map(|x| x + h), ..*given }).map(|(_, output)| output.force);
    is_derivative(output.d_force_d_displacement, &force, &WIDTHS[0]).unwrap_or(Ok(()))
}

/// Compares the derivatives over displacement and velocity in a random fraction `share` of the steps of a case. Returns the number of
/// comparisons and the failures.
pub fn compare(case: &Case, r: &mut Random, share: f64) -> (u64, Vec<Off>) {
    let (mut count, mut off) = (0, Vec::new());
    let Some(model) = prepare(case) else { return (0, off) };
    // SAFETY: the structure contains only numbers, for which zero bytes are valid.
    let mut state: dashpot_state = unsafe { zeroed() };
    // SAFETY: an initialized model and a local state.
    if !case.ordinary || unsafe { dashpot_state_init(&*model, case.start, &mut state) } < 0 {
        return (0, off);
    }
    for (step, given) in case.motion.iter().enumerate() {
        let Some((next, output)) = one_step(&model, &state, given) else { return (count, off) };
        if r.chance(share) {
            let moved = |x: f64, v: f64| {
                let given = Given { x: given.x.map(|at| at + x), v: given.v + v, ..*given };
                one_step(&model, &state, &given).map(|(_, output)| output.force)
            };
            let by_v = is_derivative(output.d_force_d_velocity, &|h| moved(0.0, h), &WIDTHS[1]);
            let by_x = if given.x.is_some() {
                is_derivative(output.d_force_d_displacement, &|h| moved(h, 0.0), &WIDTHS[0])
            } else {
                None
            };
            let failed = |found: &Option<Result<(), String>>| found.as_ref().is_some_and(Result::is_err);
            let stated = (failed(&by_x) || failed(&by_v))
                && is_of_a_linear_velocity(case, &state, given)
                && are_those_of_a_linear_velocity(case, &model, &state, given, &output).is_ok();
            for (name, found) in [("dF/dx", by_x), ("dF/dv", by_v)] {
                count += u64::from(found.is_some());
                if let Some(Err(what)) = found
                    && !stated
                {
                    off.push(Off { step, what: format!("{name} {what}, {given:?}") });
                }
            }
        }
        state = next;
    }
    (count, off)
}
