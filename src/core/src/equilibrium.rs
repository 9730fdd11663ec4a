//! The equilibrium: state and force after displacement and velocity have been constant for a long time.

use crate::element::OperatingPoint;
use crate::input::Input;
use crate::model::Model;
use crate::paths;
use crate::state::{MAX_INTERNAL, Output, State};
use crate::tables::{ForceLaw, Tables};

/// Number of bracketed Newton steps to the deflection of the series spring at equilibrium. The number may be large,
/// because the computation of an equilibrium is allowed to take more time than a step of the host.
const STEPS: usize = 100;

/// Largest residual of the force balance, relative to its forces, that counts as rounding error.
const ROUNDING: f64 = 1e-13;

/// Half the width of the central differences for static derivatives without a formula, m and m/s.
const NEAR: f64 = 1e-6;

// These functions are compiled here, for a model that owns its tables, once for all crates that call them.
impl Model {
    /// Returns the steady state at an initial position: the damper rests, or moves steadily with `input.velocity`.
    ///
    /// If `input` has no displacement, 0 is used.
    pub fn steady_state(&self, input: &Input) -> State {
        self.equilibrium(input)
    }

    /// Returns the steady state of a damper that was in state `from`: friction contacts at rest keep their deflection.
    /// If `input` has no displacement, that of `from` is used.
    pub fn steady_state_from(&self, from: &State, input: &Input) -> State {
        self.equilibrium_from(from, input)
    }

    /// Returns the output of the steady state at `input`: the static force with its derivatives.
    pub fn static_output(&self, input: &Input) -> Output {
        self.static_output_from(&self.steady_state(input), input)
    }

    /// Returns the static output of a damper that was in state `from`: see [`Model::steady_state_from`].
    ///
    /// At rest, the derivative with respect to velocity contains only elements that respond to velocity immediately. A
    /// friction contact that keeps its deflection responds to displacement only.
    pub fn static_output_from(&self, from: &State, input: &Input) -> Output {
        self.equilibrium_output_from(from, input)
    }
}

impl<T: Tables> Model<T> {
    /// Computes the equilibrium at the motion `input`: see [`Model::steady_state`].
    pub(crate) fn equilibrium(&self, input: &Input) -> State {
        let x = input.displacement.unwrap_or(0.0);
        let fresh = State { displacement: x, layout: self.layout, ..State::ZERO };
        // At rest, a friction contact that has never moved keeps its zero deflection.
        self.equilibrium_keeping(&fresh, input, (input.velocity == 0.0).then_some(&fresh))
    }

    /// Computes the equilibrium of a damper that was in state `from`: see [`Model::steady_state_from`].
    pub(crate) fn equilibrium_from(&self, from: &State, input: &Input) -> State {
        self.equilibrium_keeping(from, input, None)
    }

    /// Computes the result of [`Model::equilibrium_from`]; with `kept`, friction contacts keep their deflection from
    /// that state.
    fn equilibrium_keeping(&self, from: &State, input: &Input, kept: Option<&State>) -> State {
        let laid_out;
        let from = if self.has_laid_out(from) {
            from
        } else {
            laid_out = self.converted(from);
            &laid_out
        };
        let x = input.displacement.unwrap_or(from.displacement);
        let v = input.velocity;
        let e = &self.elements;
        let motion = |x: f64| OperatingPoint {
            displacement: x,
            velocity: v,
            side_force: input.side_force,
            temperature: input.temperature,
        };
        let mut internal = [0.0; MAX_INTERNAL];
        let mut settle = |on_mass: bool, from_x: f64, at: &OperatingPoint| {
            e.each_stateful(|place, element| {
                if let Some((z, before)) = internal.get_mut(place).zip(from.internal.get(place))
                    && e.has_on_mass(element) == on_mass
                {
                    let kept = kept.filter(|_| element.is_path_dependent(&OperatingPoint { velocity: 0.0, ..*at }));
                    *z = match kept.and_then(|kept| kept.internal.get(place)) {
                        Some(kept) => *kept,
                        None => element.equilibrium_from(from_x, *before, at),
                    };
                }
            });
            internal
        };
        settle(false, from.displacement, &motion(x));
        // The force on the internal mass at position `x_m`, with the largest possible derivative of the friction
        // contacts, that without slip.
        let mut on_the_mass = |x_m: f64| {
            let at = motion(x_m);
            let mut sum = e.on_the_mass(&at);
            if e.has_states_on_mass() {
                let states = settle(true, from.mass_displacement, &at);
                e.each_on_mass(&at, &states, |_, response| {
                    sum.force += response.force;
                    sum.d_force_d_x += response.d_force_d_x + response.d_force_d_z * response.d_rate_d_v;
                });
            }
            sum
        };
        let mut x_m = x;
        let (states, primary) = if e.has_paths() {
            crate::evaluate::paths::equilibrium(&e.paths, x, v, input.temperature)
        } else {
            ([0.0; paths::STATES], e.paths.fv_curve.evaluate(v).value)
        };
        if e.has_series() {
            // The force of the springs on the mass never decreases with its displacement. The force with the mass at
            // `x` therefore deflects the series spring further than the solution does, so this deflection bounds the
            // solution.
            let alone = primary + on_the_mass(x).force;
            let furthest = x - paths::series::furthest(&e.paths, alone).copysign(alone);
            let (mut low, mut high) = if furthest < x { (furthest, x) } else { (x, furthest) };
            let mut last = f64::INFINITY;
            for _ in 0..STEPS {
                let inner = on_the_mass(x_m);
                let (series, k) = paths::series::static_force(&e.paths, x - x_m);
                let left = series - primary - inner.force;
                if left > 0.0 {
                    low = x_m;
                } else {
                    high = x_m;
                }
                let newton = x_m + left / (k + inner.d_force_d_x);
                // A slipping friction contact has a smaller derivative than assumed, so Newton steps may converge
                // slowly. Bisection then replaces them.
                let slow = e.has_states_on_mass()
                    && left.abs() > 0.5 * last
                    && left.abs() > ROUNDING * (series.abs() + primary.abs());
                last = left.abs();
                x_m = if newton >= low && newton <= high && !slow { newton } else { 0.5 * (low + high) };
            }
            on_the_mass(x_m);
        }
        let mut state = State { internal, layout: self.layout, ..State::ZERO };
        e.paths.slots().write(&states, &mut state);
        State { displacement: x, velocity: v, mass_displacement: x_m, mass_velocity: v, ..state }
    }

    /// Computes the output at equilibrium: see [`Model::static_output_from`].
    pub(crate) fn equilibrium_output_from(&self, from: &State, input: &Input) -> Output {
        let state = self.equilibrium_from(from, input);
        let mut output = crate::evaluate::force_of(self, &state, input);
        let at = OperatingPoint {
            displacement: state.mass_displacement,
            velocity: input.velocity,
            side_force: input.side_force,
            temperature: input.temperature,
        };
        let e = &self.elements;
        let outer = OperatingPoint { displacement: state.displacement, ..at };
        if e.has_paths() {
            // These central differences of the whole force include the parallel elements with internal states, whose
            // derivatives are therefore not added again below.
            let input_velocity = input.velocity;
            let force = |x: f64, v: f64| {
                let input = Input { displacement: Some(x), velocity: v, ..*input };
                let kept = (x == state.displacement && input_velocity == 0.0).then_some(&state);
                let settled = self.equilibrium_keeping(from, &input, kept);
                crate::evaluate::force_of(self, &settled, &input).force
            };
            let (x, v) = (state.displacement, input.velocity);
            output.d_force_d_displacement = (force(x + NEAR, v) - force(x - NEAR, v)) / (2.0 * NEAR);
            output.d_force_d_velocity = (force(x, v + NEAR) - force(x, v - NEAR)) / (2.0 * NEAR);
            return output;
        }
        if e.has_series() {
            // At equilibrium, the series spring and the springs on the mass are in series, and both ends of the series
            // spring have the input velocity.
            let k = e.paths.series_compliance.stiffness;
            let (inner, primary) = (e.inner(&at), e.paths.fv_curve.evaluate(input.velocity));
            let share = k / (k + inner.d_force_d_x);
            output.d_force_d_displacement += share * inner.d_force_d_x - k;
            output.d_force_d_velocity +=
                share * (primary.derivative + inner.d_force_d_v) - e.paths.series_compliance.damping;
        }
        // The equilibrium value of an internal state depends on the input, so its change contributes to the
        // derivatives.
        e.each_stateful(|place, element| {
            let response = element.evaluate(&outer, state.internal.get(place).copied().unwrap_or(0.0));
            if element.is_path_dependent(&outer) {
                // This is the mean of the derivatives for a displacement in either direction.
                output.d_force_d_displacement += response.d_force_d_z * response.d_rate_d_v;
            } else if response.d_rate_d_z < 0.0 {
                let follows = -response.d_force_d_z / response.d_rate_d_z;
                output.d_force_d_displacement += follows * response.d_rate_d_x;
                output.d_force_d_velocity += follows * response.d_rate_d_v;
            }
        });
        output
    }
}
