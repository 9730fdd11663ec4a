//! The damper at one instant: force, state derivatives and exact partial derivatives, for hosts with their own solver.

pub(crate) mod paths;

use crate::assembly::Outer;
use crate::element::OperatingPoint;
use crate::input::Input;
use crate::model::Model;
use crate::state::MAX_INTERNAL;
use crate::state::{Output, State};
use crate::tables::{ForceLaw, Tables};
use paths::FurtherOutputs;

/// All partial derivatives of the force and the state derivatives (rates) at one instant, in SI units.
///
/// The states are, in this order: displacement of the internal mass, its velocity, and the internal states. The inputs
/// are displacement and velocity of the moving end.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Partials {
    /// Derivatives of the force with respect to displacement, N/m, and velocity, N s/m, of the moving end.
    pub d_force_d_input: [f64; 2],
    /// Derivatives of the force with respect to the states, N per unit of the state.
    pub d_force_d_state: [f64; 10],
    /// Derivatives of the rate of state i (row) with respect to displacement and velocity of the moving end.
    pub d_rate_d_input: [[f64; 2]; 10],
    /// Derivatives of the rate of state i (row) with respect to state j (column).
    pub d_rate_d_state: [[f64; 10]; 10],
}

const _: () = assert!(MAX_INTERNAL + 2 == 10);

impl Partials {
    /// All zero.
    pub const ZERO: Partials = Partials {
        d_force_d_input: [0.0; 2],
        d_force_d_state: [0.0; 10],
        d_rate_d_input: [[0.0; 2]; 10],
        d_rate_d_state: [[0.0; 10]; 10],
    };

    /// Returns whether every number is finite.
    pub fn is_finite(&self) -> bool {
        let all = self.d_force_d_input.iter().chain(&self.d_force_d_state);
        let all = all.chain(self.d_rate_d_input.as_flattened()).chain(self.d_rate_d_state.as_flattened());
        all.fold(0.0, |sum, x| sum + x * 0.0) == 0.0
    }
}

#[inline(always)]
fn at(x: f64, v: f64, input: &Input) -> OperatingPoint {
    OperatingPoint { displacement: x, velocity: v, side_force: input.side_force, temperature: input.temperature }
}

/// Returns the displacement of the moving end from the input or, if missing there, from the state.
#[inline(always)]
fn displacement(state: &State, input: &Input) -> f64 {
    input.displacement.unwrap_or(state.displacement)
}

/// Computes the output at a state: the force, with its derivatives with respect to the input at constant state.
pub fn force(model: &Model, state: &State, input: &Input) -> Output {
    force_of(model, state, input)
}

/// Computes the output of [`force`] for a model whose tables may be borrowed.
pub(crate) fn force_of(model: &Model<impl Tables>, state: &State, input: &Input) -> Output {
    if !model.has_laid_out(state) {
        return force_of(model, &model.converted(state), input);
    }
    force_with(model, state, input, FurtherOutputs::Nothing)
}

/// Computes the output for a state in this model's layout. `further` selects the results besides the output.
fn force_with(model: &Model<impl Tables>, state: &State, input: &Input, further: FurtherOutputs) -> Output {
    let e = &model.elements;
    let (x, v) = (displacement(state, input), input.velocity);
    let outer = at(x, v, input);
    let Outer { friction, preload } = e.parallel(&outer);
    let stops = e.stops(&outer);
    let mut output = Output {
        friction_force: friction.force,
        gas_force: preload.force,
        stop_force: stops.force,
        oil_temperature: input.temperature,
        force: friction.force + preload.force + stops.force,
        d_force_d_displacement: friction.d_force_d_x + preload.d_force_d_x + stops.d_force_d_x,
        d_force_d_velocity: friction.d_force_d_v + preload.d_force_d_v + stops.d_force_d_v,
        ..Output::ZERO
    };
    let (x_m, v_m) = if e.has_series() { (state.mass_displacement, state.mass_velocity) } else { (x, v) };
    if e.has_paths() {
        let through = paths::through(e, state, input, further);
        output.primary_force = through.primary;
        output.spring_force = through.inner;
        e.hand_out(&mut output, &at(x_m, v_m, input), &state.internal);
        output.series_deflection = x - x_m;
        output.oil_temperature += through.heat;
        output.force += through.force;
        output.d_force_d_displacement += through.by_input[0];
        output.d_force_d_velocity += through.by_input[1];
        memories(model, state, &outer, &mut output);
        return output;
    }
    let (inner, primary) = (e.inner(&at(x_m, v_m, input)), e.paths.fv_curve.evaluate(v_m));
    output.primary_force = primary.value;
    output.spring_force = inner.force;
    if e.has_series() {
        let s = &e.paths.series_compliance;
        output.series_deflection = x - x_m;
        output.force += s.stiffness * (x - x_m) + s.damping * (v - v_m);
        output.d_force_d_displacement += s.stiffness;
        output.d_force_d_velocity += s.damping;
    } else {
        output.force += primary.value + inner.force;
        output.d_force_d_displacement += inner.d_force_d_x;
        output.d_force_d_velocity += primary.derivative + inner.d_force_d_v;
    }
    memories(model, state, &outer, &mut output);
    output
}

/// Adds the forces of the parallel elements with internal states to `output`.
fn memories(model: &Model<impl Tables>, state: &State, outer: &OperatingPoint, output: &mut Output) {
    let e = &model.elements;
    e.each_stateful(|place, element| {
        if e.has_on_mass(element) {
            return;
        }
        let z = state.internal.get(place).copied().unwrap_or(0.0);
        let response = element.evaluate(outer, z);
        output.count(element.component(), response.force);
        output.force += response.force;
        output.d_force_d_displacement += response.d_force_d_x;
        output.d_force_d_velocity += response.d_force_d_v;
    });
}

/// Computes the output at a state, and the time derivatives of the states. The derivative of [`State::velocity`] is set
/// to 0, because this number is the last input, not a state.
pub fn evaluate(model: &Model, state: &State, input: &Input) -> (Output, State) {
    evaluate_of(model, state, input)
}

/// Computes the results of [`evaluate`] for a model whose tables may be borrowed.
pub(crate) fn evaluate_of(model: &Model<impl Tables>, state: &State, input: &Input) -> (Output, State) {
    if !model.has_laid_out(state) {
        return evaluate_of(model, &model.converted(state), input);
    }
    let e = &model.elements;
    let (x, v) = (displacement(state, input), input.velocity);
    let mut rate = State { displacement: v, ..State::ZERO };
    let output = force_with(model, state, input, FurtherOutputs::Rates(&mut rate));
    if e.has_series() && !e.has_paths() {
        let s = &e.paths.series_compliance;
        let (x_m, v_m) = (state.mass_displacement, state.mass_velocity);
        let series = s.stiffness * (x - x_m) + s.damping * (v - v_m);
        let inner = e.inner(&at(x_m, v_m, input));
        rate.mass_displacement = v_m;
        rate.mass_velocity = (series - inner.force - e.paths.fv_curve.evaluate(v_m).value) / s.mass;
    }
    let mass = [state.mass_displacement, state.mass_velocity];
    e.each_stateful(|place, element| {
        if let (Some(rate), Some(z)) = (rate.internal.get_mut(place), state.internal.get(place)) {
            let [x, v] = if e.has_on_mass(element) { mass } else { [x, v] };
            *rate = element.evaluate(&at(x, v, input), *z).rate;
        }
    });
    (output, rate)
}

/// Computes all partial derivatives of force and state derivatives at a state.
pub fn partials(model: &Model, state: &State, input: &Input) -> Partials {
    partials_of(model, state, input)
}

/// Computes the results of [`partials`] for a model whose tables may be borrowed.
pub(crate) fn partials_of(model: &Model<impl Tables>, state: &State, input: &Input) -> Partials {
    if !model.has_laid_out(state) {
        return partials_of(model, &model.converted(state), input);
    }
    let e = &model.elements;
    let (x, v) = (displacement(state, input), input.velocity);
    let mut p = Partials::ZERO;
    let output = force_with(model, state, input, FurtherOutputs::Partials(&mut p));
    p.d_force_d_input = [output.d_force_d_displacement, output.d_force_d_velocity];
    if e.has_series() && !e.has_paths() {
        let s = &e.paths.series_compliance;
        let (x_m, v_m) = (state.mass_displacement, state.mass_velocity);
        let (inner, primary) = (e.inner(&at(x_m, v_m, input)), e.paths.fv_curve.evaluate(v_m));
        let per_mass = 1.0 / s.mass;
        p.d_force_d_state[0] = -s.stiffness;
        p.d_force_d_state[1] = -s.damping;
        p.d_rate_d_state[0][1] = 1.0;
        p.d_rate_d_state[1][0] = -(s.stiffness + inner.d_force_d_x) * per_mass;
        p.d_rate_d_state[1][1] = -(s.damping + inner.d_force_d_v + primary.derivative) * per_mass;
        p.d_rate_d_input[1] = [s.stiffness * per_mass, s.damping * per_mass];
    }
    e.each_stateful(|place, element| {
        let z = state.internal.get(place).copied().unwrap_or(0.0);
        let k = place + 2;
        if e.has_on_mass(element) {
            let response = element.evaluate(&at(state.mass_displacement, state.mass_velocity, input), z);
            if let Some(slot) = p.d_rate_d_state[1].get_mut(k) {
                *slot = -response.d_force_d_z / e.paths.series_compliance.mass;
            }
            if let Some(row) = p.d_rate_d_state.get_mut(k) {
                [row[0], row[1]] = [response.d_rate_d_x, response.d_rate_d_v];
                if let Some(slot) = row.get_mut(k) {
                    *slot = response.d_rate_d_z;
                }
            }
            return;
        }
        let response = element.evaluate(&at(x, v, input), z);
        if let Some(slot) = p.d_force_d_state.get_mut(k) {
            *slot = response.d_force_d_z;
        }
        if let Some(row) = p.d_rate_d_input.get_mut(k) {
            *row = [response.d_rate_d_x, response.d_rate_d_v];
        }
        if let Some(slot) = p.d_rate_d_state.get_mut(k).and_then(|row| row.get_mut(k)) {
            *slot = response.d_rate_d_z;
        }
    });
    p
}
