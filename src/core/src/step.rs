//! One host step: a diagonally implicit Runge–Kutta method over a few substeps, at a bounded cost and without side
//! effects.
//!
//! In every stage the velocity u of the internal mass m solves one scalar equation. x_in and v_in are displacement and
//! velocity of the moving end, x_m is the displacement of the mass. k_s and c_s are stiffness and damping of the series
//! compliance. F_p is the force of the springs on the mass, and F_d the FV curve. X and V are the known parts of the
//! mass's displacement and velocity in the stage: start values plus the weighted gains of the previous stages. g is γh,
//! with the diagonal coefficient γ of the method and the length h of the substep:
//!
//! ```text
//! x_m = X + g u,   m (u − V) = g [k_s (x_in − x_m) + c_s (v_in − u) − F_p(x_m) − F_d(u)]
//! ⇔  a u + g F_d(u) = r,   a = m + g (c_s + ∂F_p/∂v) + g² (k_s + ∂F_p/∂x)
//! ```
//!
//! The springs on the mass are linearized about the predicted x_m, because they are soft compared with the series
//! spring. A spring with a table, or with a cubic or quartic term, is linearized again about the solution if its
//! tangent is too inaccurate there. The left side rises strictly with u, so the solution is unique for any stiffness.
//! [`crate::curve::Curve::solve`] finds the solution with a bounded number of operations. All methods are L-stable and
//! stiffly accurate.
//!
//! The cheap step is a separate method: see [`cheap`].

mod cheap;
mod follow;
mod mass;
mod parallel;
pub mod paths;
mod primary;
mod reach;
mod tableau;

use crate::assembly::{Elements, Outer};
use crate::element::{OperatingPoint, Response};
use crate::input::{Input, Path};
pub use crate::integration::{Integration, Method};
use crate::integration::{LONGEST, SHORTEST};
use crate::math::{max, min};
use crate::model::Model;
use crate::state::{Output, State};
use crate::tables::Tables;
use follow::ByEnd;
pub use follow::{Follow, Stage};
use mass::{Drive, Mass, move_mass, move_mass_at_once};
use parallel::advance_extras;
use primary::{Any, Faded, Plain, Primary};
use tableau::{EULER, THREE_STAGE, Tableau};

/// Longest step, s, that resolves fast motion: a tenth of the period of wheel hop, for example.
pub const LONG_STEP: f64 = 0.01;

/// Advances the state `from` by a step of `dt`, s, to its end, where the host's input is `to`.
///
/// Returns the new state and the output at the end. The output contains the force and its exact derivatives with
/// respect to displacement and velocity of `to`. If a result is not finite, returns `from` and [`Output::ZERO`].
///
/// With `dt = 0`, the state does not change and the force is that of the damper at equilibrium. If the host gives only
/// a velocity, the derivative with respect to velocity includes the effect of the integrated displacement.
#[inline]
pub fn step(model: &Model, from: &State, to: &Input, dt: f64) -> (State, Output) {
    let (mut state, mut output) = (State::ZERO, Output::ZERO);
    step_into(model, from, to, dt, &mut state, &mut output);
    (state, output)
}

/// Advances the state `from` by a step of `dt`, s, and writes the new state and the output to the caller's variables.
///
/// Returns false if a number of the new state or of the output is not finite. The state is then `from`, and the output
/// stays unchanged.
#[inline]
pub fn step_into(model: &Model, from: &State, to: &Input, dt: f64, state: &mut State, output: &mut Output) -> bool {
    *state = *from;
    step_in_place(model, state, to, dt, output)
}

/// Advances a state in place by a step of `dt`, s, at whose end the input is `to`.
///
/// Returns false if a number of the new state or of the output is not finite; both then stay unchanged. Only inputs or
/// states far outside the range of dampers cause this. A single cheap step is not checked, because its result is finite
/// unless fourth powers of the inputs overflow.
#[inline(always)]
pub fn step_in_place(model: &Model, state: &mut State, to: &Input, dt: f64, output: &mut Output) -> bool {
    move_on(model, state, to, dt, output, true)
}

/// Advances a state in place and returns the force, N, of [`step_in_place`], equal bit by bit, without its derivatives.
/// Returns `None` if a result is not finite.
#[inline(always)]
pub fn force_in_place(model: &Model, state: &mut State, to: &Input, dt: f64) -> Option<f64> {
    let mut output = Output::ZERO;
    move_on(model, state, to, dt, &mut output, false).then_some(output.force)
}

/// Advances one step of `dt`, s, in place. Without `derivatives`, the derivatives of the output have no meaning.
#[inline(always)]
fn move_on(model: &Model, state: &mut State, to: &Input, dt: f64, output: &mut Output, derivatives: bool) -> bool {
    if !model.has_laid_out(state) {
        return move_on_laid_out(model, state, *to, dt, output, derivatives);
    }
    if dt <= model.integration.cheap_up_to && dt > 0.0 && model.elements.is_plain_mass() {
        if !cheap_step::<true>(model, state, to, dt, output) {
            cheap_step_in_full(model, state, *to, dt, output);
        }
        // The result is not checked. It is finite for all inputs whose fourth powers do not overflow, because the
        // solution has a closed form.
        return true;
    }
    step_of_any_kind(model, state, *to, dt, output, derivatives)
}

/// Steps from a state with the layout of other elements, after converting this state. If a result is not finite, the
/// state does not change.
#[cold]
#[inline(never)]
fn move_on_laid_out(
    model: &Model,
    state: &mut State,
    to: Input,
    dt: f64,
    output: &mut Output,
    derivatives: bool,
) -> bool {
    let mut reached = model.laid_out(state);
    let done = step_of_any_kind(model, &mut reached, to, dt, output, derivatives);
    if done {
        *state = reached;
    }
    done
}

/// Steps a damper with borrowed tables in place, from a state in the damper's layout.
#[inline(always)]
pub(crate) fn step_borrowed(
    model: &Model<impl Tables>,
    state: &mut State,
    to: &Input,
    dt: f64,
    output: &mut Output,
    derivatives: bool,
) -> bool {
    let (mut reached, mut answer) = (*state, Output::ZERO);
    let is_cheap = dt <= model.integration.cheap_up_to && dt > 0.0 && model.elements.is_plain_mass();
    if !(is_cheap && cheap_step::<false>(model, &mut reached, to, dt, &mut answer)) {
        if is_cheap {
            answer_by_table(&EULER, model, &mut reached, to, dt, &mut answer, true);
        } else {
            step_by_its_method(model, &mut reached, to, dt, &mut answer, derivatives);
        }
    }
    keep_if_finite(&reached, &answer, state, output)
}

/// Stores the result of a step and returns true if all its numbers are finite. Otherwise returns false, and state and
/// output stay unchanged.
#[inline(always)]
fn keep_if_finite(reached: &State, answer: &Output, state: &mut State, output: &mut Output) -> bool {
    let finite = reached.is_finite() && answer.is_finite();
    if finite {
        *state = *reached;
        *output = *answer;
    }
    finite
}

/// Takes any step other than a single cheap step. The input is passed by value, so that the caller can keep its own
/// copy in registers.
#[cold]
#[inline(never)]
fn step_of_any_kind(
    model: &Model,
    state: &mut State,
    to: Input,
    dt: f64,
    output: &mut Output,
    derivatives: bool,
) -> bool {
    let (mut reached, mut answer) = (*state, Output::ZERO);
    step_by_its_method(model, &mut reached, &to, dt, &mut answer, derivatives);
    keep_if_finite(&reached, &answer, state, output)
}

#[inline(always)]
fn step_by_its_method(
    model: &Model<impl Tables>,
    state: &mut State,
    to: &Input,
    dt: f64,
    output: &mut Output,
    derivatives: bool,
) {
    if dt == 0.0 {
        let x = to.displacement.unwrap_or(state.displacement);
        *output = model.equilibrium_output_from(state, &Input { displacement: Some(x), ..*to });
        return;
    }
    if model.elements.has_paths() {
        if model.elements.fades_alone() && model.integration.method != Method::Euler {
            step_of_a_fading_damper(model, state, to, dt, output, derivatives);
        } else {
            step_through_paths(model, state, to, dt, output, derivatives);
        }
        return;
    }
    if !is_common(model, dt) {
        answer_by_table(tableau(model, dt), model, state, to, dt, output, derivatives);
    } else if model.elements.is_nonlinear() {
        answer::<Plain, true>(model, state, to, dt, output, derivatives);
    } else {
        answer::<Plain, false>(model, state, to, dt, output, derivatives);
    }
}

/// Returns whether a step of `dt`, s, is one substep of the three-stage method. Most steps are, so this case has its
/// own compiled code. All other steps share the code around their stages. Steps with five stages, nonlinear springs or
/// a fading curve also share the code of the stages ([`mass`]). Separate code for each case would make up a third of
/// the library.
#[inline(always)]
fn is_common(model: &Model<impl Tables>, dt: f64) -> bool {
    let of = &model.integration;
    of.method == Method::ThreeStage && of.is_one(dt)
}

/// Returns the method of a step of `dt`, s, of a damper without a bushing. With a bushing, the method also depends on
/// the rise of its stiffness in the step.
fn tableau(model: &Model<impl Tables>, dt: f64) -> &'static Tableau {
    let of = &model.integration;
    Tableau::for_method(of.method_of(dt, of.substeps(dt), || 1.0))
}

/// Takes a step of a plain damper whose FV curve fades as a whole ([`Elements::fades_alone`]). The fade factor depends
/// on the host's temperature alone, so it is known before the step.
///
/// The cheap method does not use this function, because its linearized plain step would differ from its step through
/// the force path.
#[inline(never)]
fn step_of_a_fading_damper(
    model: &Model<impl Tables>,
    state: &mut State,
    to: &Input,
    dt: f64,
    output: &mut Output,
    derivatives: bool,
) {
    if is_common(model, dt) {
        answer::<Faded, false>(model, state, to, dt, output, derivatives);
    } else {
        answer_by_table(tableau(model, dt), model, state, to, dt, output, derivatives);
    }
}

/// Takes a step of a damper with elements in its series or hydraulic path, with exact derivatives if requested.
#[inline(never)]
fn step_through_paths(
    model: &Model<impl Tables>,
    state: &mut State,
    to: &Input,
    dt: f64,
    output: &mut Output,
    derivatives: bool,
) {
    let mut by_end = paths::PathsByEnd::new(derivatives);
    advance_paths_with(model, state, to, dt, &mut by_end, output);
    if to.displacement.is_none() {
        output.d_force_d_velocity += 0.5 * paths::clamp_step(dt) * output.d_force_d_displacement;
    }
}

/// Advances a damper with elements in its series or hydraulic path ([`Elements::has_paths`]) and passes every stage to
/// `follow`.
pub fn advance_paths(
    model: &Model,
    state: &mut State,
    to: &Input,
    dt: f64,
    follow: &mut impl paths::FollowPaths,
    output: &mut Output,
) {
    advance_paths_with(model, state, to, dt, &mut paths::FollowedStages(follow), output);
}

fn advance_paths_with(
    model: &Model<impl Tables>,
    state: &mut State,
    to: &Input,
    dt: f64,
    follow: &mut impl paths::EachStage,
    output: &mut Output,
) {
    let e = &model.elements;
    let substeps = model.integration.substeps(dt);
    let path = Path::new(state.displacement, state.velocity, to, paths::clamp_step(dt));
    let (x, v) = path.end();
    let outer = OperatingPoint { displacement: x, velocity: v, side_force: to.side_force, temperature: to.temperature };
    let method = Tableau::for_method(model.integration.method_of(dt, substeps, || stiffer(e, state, v)));
    let side = (to.side_force, to.temperature);
    let drive = paths::Drive { model, path: &path, substeps, side, method };
    let through = paths::advance(&drive, state, output, follow);
    state.displacement = x;
    state.velocity = v;
    let Outer { friction, preload } = e.parallel(&outer);
    output.friction_force = friction.force;
    output.gas_force = preload.force;
    let mass = OperatingPoint { displacement: state.mass_displacement, velocity: state.mass_velocity, ..outer };
    e.hand_out(output, &mass, &state.internal);
    let mut extras = Response::NONE;
    output.stop_force = 0.0;
    if e.has_stateful_or_stop() {
        extras = advance_extras(
            (method, substeps),
            e,
            &path,
            &outer,
            &mut state.internal,
            output,
            follow.wants_derivatives(),
        );
    }
    output.force = through.force + friction.force + preload.force + extras.force;
    output.d_force_d_displacement =
        through.d_force_d_x + friction.d_force_d_x + preload.d_force_d_x + extras.d_force_d_x;
    output.d_force_d_velocity = through.d_force_d_v + friction.d_force_d_v + preload.d_force_d_v + extras.d_force_d_v;
}

/// Estimates the ratio of the bushing's stiffness in a step to that at zero deflection; 1 without a bushing. `v` is the
/// velocity of the moving end at the end of the step, m/s.
///
/// The bushing is assumed to store the whole kinetic energy of the mass in its motion relative to the moving end. The
/// speed of the moving end is the higher of its speeds at start and end.
fn stiffer(e: &Elements<impl Tables>, from: &State, v: f64) -> f64 {
    if !e.paths.has_bushing() {
        return 1.0;
    }
    let s = &e.paths.series_compliance;
    let speed = max(v.abs(), from.velocity.abs()) + from.mass_velocity.abs();
    e.paths.bushing.stiffer(from.displacement - from.mass_displacement, s.mass / s.stiffness * (speed * speed))
}

/// Repeats a cheap step that failed, because an element has no short form or because the linearization is too
/// inaccurate.
#[cold]
#[inline(never)]
fn cheap_step_in_full(model: &Model<impl Tables>, state: &mut State, to: Input, dt: f64, output: &mut Output) {
    if !cheap_step::<false>(model, state, &to, dt, output) {
        answer_by_table(&EULER, model, state, &to, dt, output, true);
    }
}

/// Takes one cheap step of a damper without states other than those of its mass, as fast as possible.
///
/// Returns false and changes no state if the linearization is too inaccurate. With `AT_ONCE`, also returns false unless
/// every element has a short form ([`crate::element::Force::at_once`]). With short forms, no function is called and all
/// values stay in registers.
#[inline(always)]
fn cheap_step<const AT_ONCE: bool>(
    model: &Model<impl Tables>,
    state: &mut State,
    to: &Input,
    dt: f64,
    output: &mut Output,
) -> bool {
    let elements = &model.elements;
    let path = Path::new(state.displacement, state.velocity, to, dt);
    let end = path.last();
    // First evaluate and store everything that does not depend on the new motion of the mass.
    let outer =
        OperatingPoint { displacement: end.x, velocity: end.v, side_force: to.side_force, temperature: to.temperature };
    let before = cheap::Before {
        x: state.mass_displacement,
        v: state.mass_velocity,
        gain: end.v - state.velocity,
        h: dt,
        side: (to.side_force, to.temperature),
    };
    let at = before.springs_at(&end);
    let (friction, springs, preload);
    if AT_ONCE {
        // Friction comes first, because it most often has no short form.
        match elements.friction_at_once(&outer) {
            Some(answer) => friction = answer,
            None => return false,
        }
        match (elements.inner_at_once(&at), elements.preload_at_once(&outer)) {
            (Some(inner), Some(position)) => (springs, preload) = (inner, position),
            _ => return false,
        }
    } else {
        friction = elements.friction(&outer);
        springs = elements.inner(&at);
        preload = elements.preload(&outer);
    }
    output.friction_force = friction.force;
    output.gas_force = preload.force;
    output.stop_force = 0.0;
    output.oil_temperature = to.temperature;
    let beside = friction.force + preload.force;
    let (by_x_beside, by_v_beside) =
        (friction.d_force_d_x + preload.d_force_d_x, friction.d_force_d_v + preload.d_force_d_v);

    let after = cheap::take(elements, &before, &end, at.displacement, springs);
    // With `AT_ONCE`, all springs on the mass are linear or quadratic, so their linearization needs no check.
    if !(after.holds() && (AT_ONCE || after.springs_hold(elements, &end, before.side))) {
        return false;
    }
    state.displacement = end.x;
    state.velocity = end.v;
    state.mass_displacement = after.x;
    state.mass_velocity = after.v;
    output.primary_force = after.primary;
    output.spring_force = after.spring;

    let s = &elements.paths.series_compliance;
    let deflection = end.x - after.x;
    output.series_deflection = deflection;
    output.force = (s.stiffness * deflection + s.damping * (end.v - after.v)) + beside;
    // The motion of the mass reduces the derivatives of the series force, because the mass follows the moving end.
    let follows = s.damping + dt * s.stiffness;
    let per_impulse = dt * after.by_impulse;
    let by_x = s.stiffness - follows * (s.stiffness * per_impulse) + by_x_beside;
    let mut by_v = s.damping - follows * (s.damping * per_impulse + after.by_guess) + by_v_beside;
    if to.displacement.is_none() {
        by_v += 0.5 * dt * by_x;
    }
    output.d_force_d_displacement = by_x;
    output.d_force_d_velocity = by_v;
    true
}

/// Advances several dampers of one model by `dt`, s, such as those of a car's corners, with results equal bit by bit to
/// single steps.
///
/// Advances as many dampers as the shortest of the four lists contains.
pub fn step_batch(model: &Model, from: &[State], to: &[Input], dt: f64, states: &mut [State], outputs: &mut [Output]) {
    for (((from, to), state), output) in from.iter().zip(to).zip(states).zip(outputs) {
        step_into(model, from, to, dt, state, output);
    }
}

/// Takes a step for which [`is_common`] is true, with exact derivatives if requested.
///
/// With `BENT` the springs are nonlinear. The function is not inlined, so that its code can use all registers.
#[inline(never)]
fn answer<P: Primary, const BENT: bool>(
    model: &Model<impl Tables>,
    state: &mut State,
    to: &Input,
    dt: f64,
    output: &mut Output,
    derivatives: bool,
) {
    answer_by::<P, true, BENT>(&THREE_STAGE, model, state, to, dt, output, derivatives);
}

/// Takes a step by any method, with exact derivatives if requested.
#[inline(never)]
fn answer_by_table(
    method: &Tableau,
    model: &Model<impl Tables>,
    state: &mut State,
    to: &Input,
    dt: f64,
    output: &mut Output,
    derivatives: bool,
) {
    answer_by::<Any, false, true>(method, model, state, to, dt, output, derivatives);
}

/// Takes a step by one compiled variant. If the host gives no displacement, the displacement at the end of the step
/// depends on the velocity there. The derivative with respect to velocity includes this effect.
#[inline(always)]
fn answer_by<P: Primary, const COMMON: bool, const BENT: bool>(
    method: &Tableau,
    model: &Model<impl Tables>,
    state: &mut State,
    to: &Input,
    dt: f64,
    output: &mut Output,
    derivatives: bool,
) {
    let mut by_end = ByEnd::new(derivatives);
    advance_by::<P, _, _, COMMON, BENT>(method, model, to, dt, &mut by_end, state, output);
    if to.displacement.is_none() {
        output.d_force_d_velocity += 0.5 * dt * output.d_force_d_displacement;
    }
}

/// Advances a state in place and passes every stage to `follow`.
///
/// The derivatives of the output treat the internal mass as fixed, unless [`Follow::yields`] returns the effect of its
/// motion. Unless `follow` requests derivatives, they also treat the internal states as fixed. For dampers with
/// elements in the series or hydraulic path, use [`advance_paths`], because their stages differ.
pub fn advance(model: &Model, state: &mut State, to: &Input, dt: f64, follow: &mut impl Follow, output: &mut Output) {
    let method = tableau(model, dt);
    advance_by::<Plain, _, _, false, true>(method, model, to, dt, follow, state, output);
}

/// Advances a state in place by one method. `COMMON` means that [`is_common`] is true. With `COMMON`, the springs may
/// be nonlinear only if `BENT` is true.
#[inline(always)]
fn advance_by<P: Primary, T: Tables, F: Follow<T>, const COMMON: bool, const BENT: bool>(
    method: &Tableau,
    model: &Model<T>,
    to: &Input,
    dt: f64,
    follow: &mut F,
    state: &mut State,
    output: &mut Output,
) {
    let e = &model.elements;
    let primary = P::new(e, to.temperature);
    output.stop_force = 0.0;
    output.oil_temperature = to.temperature;
    let substeps = if COMMON { 1 } else { model.integration.substeps(dt) };
    let dt = max(dt, SHORTEST);
    let dt = min(dt, LONGEST);
    let path = Path::new(state.displacement, state.velocity, to, dt);
    let (x, v) = path.end();
    let side = (to.side_force, to.temperature);
    let outer = OperatingPoint { displacement: x, velocity: v, side_force: to.side_force, temperature: to.temperature };
    let (mut force, mut by_x, mut by_v);
    state.displacement = x;
    state.velocity = v;
    if e.has_series() {
        let s = &e.paths.series_compliance;
        let start = Mass { x: state.mass_displacement, v: state.mass_velocity, primary: 0.0, inner: 0.0 };
        let drive = Drive { elements: e, primary, path: &path, side };
        let mass = if COMMON {
            move_mass_at_once::<_, BENT>(method, &drive, start, follow)
        } else {
            move_mass(method, &drive, substeps, start, follow)
        };
        state.mass_displacement = mass.x;
        state.mass_velocity = mass.v;
        output.primary_force = mass.primary;
        output.spring_force = mass.inner;
        output.series_deflection = x - mass.x;
        force = s.stiffness * (x - mass.x) + s.damping * (v - mass.v);
        let [x_yields, v_yields] = follow.yields();
        by_x = s.stiffness - x_yields;
        by_v = s.damping - v_yields;
    } else {
        let (inner, primary) = (e.inner(&outer), primary.evaluate(e, v));
        state.mass_displacement = x;
        state.mass_velocity = v;
        output.primary_force = primary.value;
        output.spring_force = inner.force;
        output.series_deflection = 0.0;
        force = inner.force + primary.value;
        by_x = inner.d_force_d_x;
        by_v = inner.d_force_d_v + primary.derivative;
    }
    // The most frequent kind of step inlines friction and preload; all other steps call [`Elements::outer`].
    let Outer { friction, preload } = if COMMON && !BENT {
        Outer { friction: e.friction(&outer), preload: e.preload(&outer) }
    } else {
        e.outer(&outer)
    };
    output.friction_force = friction.force;
    output.gas_force = preload.force;
    force += friction.force + preload.force;
    by_x += friction.d_force_d_x + preload.d_force_d_x;
    by_v += friction.d_force_d_v + preload.d_force_d_v;
    if e.has_stateful_or_stop() {
        // These are copies, so that only this branch stores path and motion in memory.
        let (path, outer) = (path, outer);
        let sum = advance_extras(
            (method, substeps),
            e,
            &path,
            &outer,
            &mut state.internal,
            output,
            follow.wants_derivatives(),
        );
        force += sum.force;
        by_x += sum.d_force_d_x;
        by_v += sum.d_force_d_v;
    }
    output.force = force;
    output.d_force_d_displacement = by_x;
    output.d_force_d_velocity = by_v;
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::vec::Vec;

    /// Returns the Runge–Kutta matrix a_ij of a method, including the diagonal.
    fn matrix(rows: &Tableau) -> Vec<Vec<f64>> {
        let entry = |i: usize, j: usize| match i.cmp(&j) {
            core::cmp::Ordering::Less => 0.0,
            core::cmp::Ordering::Equal => rows.gamma,
            core::cmp::Ordering::Greater => rows.weights[i][j] * rows.gamma,
        };
        (0..rows.stages).map(|i| (0..rows.stages).map(|j| entry(i, j)).collect()).collect()
    }

    /// Returns the largest residual of all Runge–Kutta order conditions of a method up to the order `order`.
    fn misses(method: Method, order: usize) -> f64 {
        let a = matrix(Tableau::for_method(method));
        let c: Vec<f64> = a.iter().map(|row| row.iter().sum()).collect();
        let dot = |x: &[f64], y: &[f64]| x.iter().zip(y).map(|(x, y)| x * y).sum::<f64>();
        let through = |y: &[f64]| a.iter().map(|row| dot(row, y)).collect::<Vec<f64>>();
        let power = |n: i32| c.iter().map(|c| c.powi(n)).collect::<Vec<f64>>();
        // The last row of the matrix gives the result of the step.
        let b = &a[a.len() - 1];
        let both: Vec<f64> = c.iter().zip(through(&c)).map(|(c, ac)| c * ac).collect();
        let conditions = [
            (1, dot(b, &power(0)), 1.0),
            (2, dot(b, &c), 1.0 / 2.0),
            (3, dot(b, &power(2)), 1.0 / 3.0),
            (3, dot(b, &through(&c)), 1.0 / 6.0),
            (4, dot(b, &power(3)), 1.0 / 4.0),
            (4, dot(b, &both), 1.0 / 8.0),
            (4, dot(b, &through(&power(2))), 1.0 / 12.0),
            (4, dot(b, &through(&through(&c))), 1.0 / 24.0),
        ];
        conditions
            .iter()
            .filter(|(of, ..)| *of <= order)
            .map(|(_, got, wanted)| (got - wanted).abs())
            .fold(0.0, f64::max)
    }

    #[test]
    fn the_methods_have_the_orders_that_they_are_named_after() {
        assert!(misses(Method::Euler, 1) < 1e-14 && misses(Method::Euler, 2) > 1e-3);
        assert!(misses(Method::Second, 2) < 1e-14 && misses(Method::Second, 3) > 1e-3);
        assert!(misses(Method::ThreeStage, 2) < 1e-14 && misses(Method::ThreeStage, 3) > 1e-3);
        assert!(misses(Method::Third, 3) < 1e-13 && misses(Method::Third, 4) > 1e-4);
        assert!(misses(Method::Fourth, 4) < 1e-13);
    }

    /// Returns two numbers: the largest growth factor over all frequencies of an oscillation, and the factor of an
    /// infinitely stiff motion.
    fn growth(method: Method) -> (f64, f64) {
        let a = matrix(Tableau::for_method(method));
        let after = |y: f64| {
            // Complex numbers are pairs. The stages k_i of dx/dt = z x with z = iy and the step 1 satisfy k_i = 1 + z Σ
            // a_ij k_j.
            let mut stages: Vec<(f64, f64)> = Vec::new();
            for (i, row) in a.iter().enumerate() {
                let sum = row.iter().zip(&stages).fold((0.0, 0.0), |s, (a, k)| (s.0 + a * k.0, s.1 + a * k.1));
                let known = (1.0 - y * sum.1, y * sum.0);
                let (re, im) = (1.0, -y * row[i]);
                let size = re * re + im * im;
                stages.push(((known.0 * re + known.1 * im) / size, (known.1 * re - known.0 * im) / size));
            }
            let (re, im) = stages[stages.len() - 1];
            re.hypot(im)
        };
        let most = (0..4000).map(|k| after(10f64.powf(-2.0 + 1e-3 * f64::from(k)))).fold(0.0, f64::max);
        (most, after(1e9))
    }

    /// No method amplifies an oscillation, and each removes an infinitely stiff motion. The test evaluates the
    /// imaginary axis. Every diagonal coefficient γ is positive, so all poles of the stability functions lie to the
    /// right of this axis. Therefore the bound holds in the whole left half-plane.
    #[test]
    fn the_methods_are_l_stable() {
        for (most, left) in
            [Method::Euler, Method::Second, Method::ThreeStage, Method::Third, Method::Fourth].map(growth)
        {
            assert!(most <= 1.0 + 1e-12 && left < 1e-6, "grows by {most}, leaves {left}");
        }
    }
}
