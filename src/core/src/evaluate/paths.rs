//! Force, state derivatives and partial derivatives of a damper with elements in its series or hydraulic path (see
//! [`crate::paths`]).

use super::Partials;
use crate::assembly::Elements;
use crate::curve::Value;
use crate::dual::{Dual, Real};
use crate::element::OperatingPoint;
use crate::input::Input;
use crate::paths::bypass;
use crate::paths::hydraulic::{self, Around, Flow, column_force, column_rate};
use crate::paths::series::{self, Frame};
use crate::paths::solve::{ITERATIONS, Residual, oil_velocity};
use crate::paths::{Paths, STATES, Slots, place};
use crate::state::{MAX_INTERNAL, State};
use crate::tables::{ForceLaw, Tables};

/// Number of variables with respect to which one evaluation differentiates.
///
/// All evaluations here use this number type, even those that need no derivatives, because hosts call them rarely. The
/// thirteen variables are ten states, the motion of the moving end, and the oil velocity. With derivatives with respect
/// to all of them in one evaluation, the machine code was as long as that of all steps together.
const DIRECTIONS: usize = 4;

/// Number with its derivatives with respect to the [`DIRECTIONS`] variables of one evaluation.
type Derivatived = Dual<DIRECTIONS>;

/// State derivatives and forces at given states and a given oil velocity.
struct Instant {
    /// Residual of the equation for the oil velocity at the valves; 0 at the solution.
    residual: Derivatived,
    rates: [Derivatived; STATES],
    force: Derivatived,
    primary: Derivatived,
    inner: Derivatived,
}

/// Calls [`hydraulic::flow`], compiled once for all callers.
#[inline(never)]
fn flow(
    e: &Paths<impl Tables>,
    curve: Derivatived,
    w: Derivatived,
    around: &Around<Derivatived>,
    states: &[Derivatived; STATES],
) -> Flow<Derivatived> {
    hydraulic::flow(e, curve, Dual::constant(e.fv_curve.at_zero()), w, around, states)
}

/// Calls [`bypass::flow`], compiled once for all callers.
#[inline(never)]
fn past(e: &Paths<impl Tables>, force: Derivatived, x: Derivatived, states: &[Derivatived; STATES]) -> Derivatived {
    bypass::flow(e, force, x, states)
}

#[inline(never)]
fn instant(
    elements: &Elements<impl Tables>,
    states: &[Derivatived; STATES],
    internal: &[f64; MAX_INTERNAL],
    around: &Around<Derivatived>,
    w: Derivatived,
    curve: Derivatived,
) -> Instant {
    let e = &elements.paths;
    let frame = Frame::new(e);
    let (x, u) = if e.has_series() { (states[place::X], states[place::U]) } else { (around.x, around.v) };
    let flow = flow(e, curve, w, around, states);
    let mut rates = [Dual::constant(0.0); STATES];
    // The state of an oil column determines the hydraulic force, and the valves then determine the oil velocity.
    let (primary, deflection) = if e.has_column() {
        column_force(e, around.x, states[place::COLUMN])
    } else {
        (flow.force, Dual::constant(0.0))
    };
    let through = w + past(e, primary, around.x, states);
    let mut displaced = through;
    if e.has_cavitation() {
        let oils = e.cavitation.rate(primary, around.v, states[place::VOID]);
        rates[place::VOID] = oils + e.cavitation.lags(around.v);
        displaced = displaced + oils * e.cavitation.sign;
    }
    let residual = if e.has_column() {
        rates[place::COLUMN] = column_rate(e, [around.x, around.v], deflection, u - displaced);
        flow.force - primary
    } else {
        displaced - u
    };
    let selective = &e.frequency_selective_damping;
    rates[place::SELECTIVE] = if e.has_passage() {
        selective.fills(primary, states[place::SELECTIVE])
    } else {
        (flow.selective_target - states[place::SELECTIVE]) * selective.per_time
    };
    [rates[place::VALVE], rates[place::VALVE_RATE]] = flow.valve_rates;
    let fade = &e.temperature_fade;
    if fade.heats_itself {
        rates[place::HEAT] = flow.force * through * fade.per_capacity - states[place::HEAT] * fade.cooling;
    }
    let at = OperatingPoint {
        displacement: x.value(),
        velocity: u.value(),
        side_force: around.side_force,
        temperature: around.temperature,
    };
    let mut inner = elements.on_the_mass(&at);
    inner.add(elements.states_on_mass(&at, internal));
    let inner = x.chain(inner.force, inner.d_force_d_x) + u.chain(0.0, inner.d_force_d_v);
    let mut force = inner + primary;
    if e.has_series() {
        let rate = around.v - u;
        let relaxing = [states[place::BUSHING], states[place::SLOW_BUSHING]];
        force = series::force(e, &frame, around.x - x, rate, relaxing);
        rates[place::X] = u;
        rates[place::U] = (force - inner - primary) * frame.mass.inverse();
        [rates[place::BUSHING], rates[place::SLOW_BUSHING]] = e.bushing.rates(rate, relaxing);
    }
    Instant { residual, rates, force, primary, inner }
}

/// Relative tolerance of the oil velocity at which the iteration ends.
const TOLERANCE: f64 = 1e-13;

/// Finds the oil velocity w, m/s, from a guess, at which the residual `left` is 0. The arguments of `left` are w and
/// the FV force at w, N. `least` are lower bounds of its two derivatives: see [`oil_velocity`].
#[inline(never)]
fn sought(
    e: &Paths<impl Tables>,
    guess: f64,
    least: [f64; 2],
    left: &dyn Fn(Derivatived, Derivatived) -> Derivatived,
) -> f64 {
    let residual = |w: f64, f: f64| {
        let r = left(Dual::along(w, 0), Dual::along(f, 1));
        Residual { value: r.value, by_w: r.derivative(0), by_curve: r.derivative(1) }
    };
    oil_velocity(e, guess, ITERATIONS, least, TOLERANCE, &residual, &mut ()).root()
}

/// Computes the oil velocity at the valves, m/s, at given states and the motion `at`.
fn oil(
    elements: &Elements<impl Tables>,
    states: &[f64; STATES],
    internal: &[f64; MAX_INTERNAL],
    at: &Around<f64>,
) -> f64 {
    let e = &elements.paths;
    let Around { x, v, side_force, temperature } = *at;
    let u = if e.has_series() { states[place::U] } else { v };
    if !e.has_column() && !e.has_cavitation() && !bypass::is_open(e) {
        return u;
    }
    let lifted = states.map(Dual::constant);
    let around = Around { x: Dual::constant(x), v: Dual::constant(v), side_force, temperature };
    let least = if e.has_column() { [1e-3, 1e-3] } else { [0.5, 1e-12] };
    sought(e, u, least, &|w, f| instant(elements, &lifted, internal, &around, w, f).residual)
}

/// Indices of displacement and velocity of the moving end among the variables of an instant, after the states.
const X: usize = STATES;
const V: usize = X + 1;
/// Direction of the oil velocity: the last one. The oil velocity depends on all other variables.
const W: usize = DIRECTIONS - 1;

/// The damper at given states and input, with its oil velocity.
struct At<'a, T: Tables> {
    e: &'a Elements<T>,
    states: [f64; STATES],
    internal: &'a [f64; MAX_INTERNAL],
    around: Around<f64>,
    w: f64,
    curve: Value,
}

impl<'a, T: Tables> At<'a, T> {
    fn new(e: &'a Elements<T>, state: &'a State, input: &Input) -> At<'a, T> {
        let x = super::displacement(state, input);
        let Input { velocity: v, side_force, temperature, .. } = *input;
        let states = e.paths.slots().read(state);
        let around = Around { x, v, side_force, temperature };
        let internal = &state.internal;
        let w = oil(e, &states, internal, &around);
        At { e, states, internal, around, w, curve: e.paths.fv_curve.evaluate(w) }
    }

    /// Evaluates the damper with its derivatives with respect to the variables with the indices `places`: states, [`X`]
    /// and [`V`].
    fn along(&self, places: [usize; W]) -> Instant {
        let lifted = |value: f64, place: usize| match places.iter().position(|moved| *moved == place) {
            Some(direction) => Dual::along(value, direction),
            None => Dual::constant(value),
        };
        let mut states = [Dual::constant(0.0); STATES];
        for (place, (to, value)) in states.iter_mut().zip(self.states).enumerate() {
            *to = lifted(value, place);
        }
        let Around { x, v, side_force, temperature } = self.around;
        let around = Around { x: lifted(x, X), v: lifted(v, V), side_force, temperature };
        let w = Dual::along(self.w, W);
        instant(self.e, &states, self.internal, &around, w, w.chain(self.curve.value, self.curve.derivative))
    }
}

impl Instant {
    /// Computes the total derivatives of a number of this instant, including the change of the oil velocity.
    fn derivatives(&self, number: &Derivatived) -> [f64; W] {
        let by_w = self.residual.derivative(W);
        let follows = if by_w != 0.0 { -number.derivative(W) / by_w } else { 0.0 };
        let mut derivatives = [0.0; W];
        for (to, (own, residual)) in
            derivatives.iter_mut().zip(number.derivatives.iter().zip(&self.residual.derivatives))
        {
            *to = own + follows * residual;
        }
        derivatives
    }
}

/// The force through the series and the hydraulic path, its components in N, and its derivatives with respect to the
/// motion of the moving end.
pub(super) struct Through {
    pub force: f64,
    pub primary: f64,
    pub inner: f64,
    pub by_input: [f64; 2],
    pub heat: f64,
}

/// Results of an evaluation besides forces.
pub(super) enum FurtherOutputs<'a> {
    /// No further output.
    Nothing,
    /// The time derivatives (rates) of the states.
    Rates(&'a mut State),
    /// The derivatives of force and rates.
    Partials(&'a mut Partials),
}

pub(super) fn through(e: &Elements<impl Tables>, state: &State, input: &Input, further: FurtherOutputs) -> Through {
    let at = At::new(e, state, input);
    // Variables of the first evaluation: the last state, and displacement and velocity of the moving end. The
    // derivatives with respect to the latter two are always needed.
    const WITH_INPUT: [usize; W] = [place::HEAT, X, V];
    let instant = at.along(WITH_INPUT);
    let [_, by_x, by_v] = instant.derivatives(&instant.force);
    match further {
        FurtherOutputs::Nothing => (),
        FurtherOutputs::Rates(rate) => e.paths.slots().write(&instant.rates.map(Dual::value), rate),
        FurtherOutputs::Partials(p) => {
            instant.put(WITH_INPUT, e.paths.slots(), p);
            for places in [[0, 1, 2], [3, 4, 5], [6, 7, 8]] {
                at.along(places).put(places, e.paths.slots(), p);
            }
        }
    }
    Through {
        force: instant.force.value,
        primary: instant.primary.value,
        inner: instant.inner.value,
        by_input: [by_x, by_v],
        heat: at.states[place::HEAT],
    }
}

impl Instant {
    /// Writes the derivatives with respect to the variables with the indices `places` to the partials.
    #[inline(never)]
    fn put(&self, places: [usize; W], slots: &Slots, p: &mut Partials) {
        for (place, derivative) in places.into_iter().zip(self.derivatives(&self.force)) {
            if let Some(to) = slots.index(place).and_then(|i| p.d_force_d_state.get_mut(i)) {
                *to = derivative;
            }
        }
        for (place, rate) in self.rates.iter().enumerate() {
            let Some(i) = slots.index(place) else { continue };
            let (Some(by_input), Some(by_state)) = (p.d_rate_d_input.get_mut(i), p.d_rate_d_state.get_mut(i)) else {
                continue;
            };
            for (moved, derivative) in places.into_iter().zip(self.derivatives(rate)) {
                match moved {
                    X => by_input[0] = derivative,
                    V => by_input[1] = derivative,
                    _ => {
                        if let Some(to) = slots.index(moved).and_then(|j| by_state.get_mut(j)) {
                            *to = derivative;
                        }
                    }
                }
            }
        }
    }
}

/// Largest number of iterations for the states and the hydraulic force at equilibrium.
const TOGETHER: usize = 200;
/// Number of iterations to the equilibrium after which the state of the frequency-selective damping is bracketed.
///
/// With a bypass, the force rises steeply as the bypass closes. Without the bracket, the state overshoots by more in
/// every iteration. A lagging valve would move the bracket in every iteration, so models with such a valve use no
/// bracket.
const DRAWN: usize = 40;

/// Computes the states and the hydraulic force, N, at equilibrium, where voids and valves no longer move. The inputs
/// are displacement `x`, m, velocity `v`, m/s, and temperature, °C.
pub(crate) fn equilibrium(e: &Paths<impl Tables>, x: f64, v: f64, temperature: f64) -> ([f64; STATES], f64) {
    let mut states = [0.0; STATES];
    // The target of a state depends on the force, and the force depends on the state, so both are iterated. They
    // converge long before the last iteration.
    let mut force = 0.0;
    let (mut low, mut high) = (f64::NEG_INFINITY, f64::INFINITY);
    for round in 0..TOGETHER {
        // The side force acts on friction alone. No element of the hydraulic path depends on it.
        let side_force = 0.0;
        let around = Around { x: Dual::constant(x), v: Dual::constant(v), side_force, temperature };
        let mut held = states;
        let at = |states: &[f64; STATES], w: f64| {
            let curve = Dual::constant(e.fv_curve.evaluate(w).value);
            flow(e, curve, Dual::constant(w), &around, &states.map(Dual::constant))
        };
        let solve = |states: &[f64; STATES], void_moves: bool| {
            let lifted = states.map(Dual::constant);
            let steady = |w: Derivatived, f: Derivatived| {
                let force = flow(e, f, w, &around, &lifted).force;
                let through = w + past(e, force, around.x, &lifted) - around.v;
                if !void_moves {
                    return through;
                }
                through + e.cavitation.rate(force, around.v, lifted[place::VOID]) * e.cavitation.sign
            };
            if void_moves || bypass::is_open(e) { sought(e, v, [0.5, 1e-12], &steady) } else { v }
        };
        if e.has_cavitation() {
            let whole = at(&states, solve(&states, false)).force.value;
            held[place::VOID] = e.cavitation.rests(whole);
            states[place::VOID] = held[place::VOID];
        }
        let flow = at(&states, solve(&states, e.has_cavitation()));
        let flow_force = flow.force.value;
        held[place::SELECTIVE] = if e.has_passage() {
            e.frequency_selective_damping.equilibrium(flow_force)
        } else {
            flow.selective_target.value
        };
        let (from, to) = (states[place::SELECTIVE], held[place::SELECTIVE]);
        if round >= DRAWN && to != from && !e.has_valve() {
            if to > from {
                low = from;
            } else {
                high = from;
            }
            let inside = to > low && to < high;
            if (!inside || round % 2 == 0) && low.is_finite() && high.is_finite() {
                held[place::SELECTIVE] = 0.5 * (low + high);
            }
        }
        held[place::VALVE] = e.valve_hysteresis.rests(flow.before_valve.value, states[place::VALVE]);
        let still = held == states && force == flow_force;
        force = flow_force;
        states = held;
        if still {
            break;
        }
    }
    if e.has_column() {
        states[place::COLUMN] = crate::paths::hydraulic::column_state(e, x, force);
    }
    (states, force)
}
