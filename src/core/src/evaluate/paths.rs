//! Force, rates and partials of a damper with elements in its series or hydraulic path (see [`crate::paths`]).

use super::Partials;
use crate::assembly::Elements;
use crate::dual::{Dual, Real};
use crate::element::Motion;
use crate::input::Input;
use crate::paths::bypass;
use crate::paths::hydraulic::{Around, column_force, column_rate, flow};
use crate::paths::series::{self, Frame};
use crate::paths::solve::{Residual, oil_velocity};
use crate::paths::{Paths, STATES, place};
use crate::state::State;

/// What the oil does at given states.
struct Instant<R> {
    /// 0 where the velocity of the oil is the right one.
    residual: R,
    rates: [R; STATES],
    force: R,
    primary: R,
    inner: R,
}

fn instant<R: Real>(elements: &Elements, states: &[R; STATES], around: &Around<R>, w: R, curve: R) -> Instant<R> {
    let e = &elements.paths;
    let frame = Frame::of(e);
    let (x, u) = if e.has_series() { (states[place::X], states[place::U]) } else { (around.x, around.v) };
    let standing = R::constant(e.fv_curve.at_zero());
    let flow = flow(e, curve, standing, w, around, states);
    let mut rates = [R::constant(0.0); STATES];
    // The oil column, where there is one, holds the force; the valves then answer with their velocity.
    let (primary, deflection) =
        if e.has_column() { column_force(e, around.x, states[place::COLUMN]) } else { (flow.force, R::constant(0.0)) };
    let through = w + bypass::flow(e, primary, around.x, states);
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
    let at = Motion {
        displacement: x.value(),
        velocity: u.value(),
        side_force: around.side_force,
        temperature: around.temperature,
    };
    let inner = elements.on_the_mass(&at);
    let inner = x.chain(inner.force, inner.by_x) + u.chain(0.0, inner.by_v);
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

/// Relative change of the velocity at which it is found.
const TOLERANCE: f64 = 1e-13;

/// A residual with its slopes over the velocity of the oil and the force of the FV curve.
fn sloped(residual: impl Fn(Dual<2>, Dual<2>) -> Dual<2>, w: f64, f: f64) -> Residual {
    let r = residual(Dual::along(w, 0), Dual::along(f, 1));
    Residual { value: r.value, by_w: r.slope(0), by_curve: r.slope(1) }
}

/// The velocity of the oil at given states.
fn oil(elements: &Elements, states: &[f64; STATES], at: &Around<f64>) -> f64 {
    let e = &elements.paths;
    let Around { x, v, side_force, temperature } = *at;
    let u = if e.has_series() { states[place::U] } else { v };
    if !e.has_column() && !e.has_cavitation() && !bypass::is_open(e) {
        return u;
    }
    let lifted = states.map(Dual::<2>::constant);
    let around = Around { x: Dual::constant(x), v: Dual::constant(v), side_force, temperature };
    let least = if e.has_column() { [1e-3, 1e-3] } else { [0.5, 1e-12] };
    let left = |w: f64, f: f64| sloped(|w, f| instant(elements, &lifted, &around, w, f).residual, w, f);
    oil_velocity(e, u, least, TOLERANCE, &left, &mut ()).answer()
}

/// Number of directions: the states, displacement, velocity, and the velocity of the oil.
const DIRECTIONS: usize = STATES + 3;

/// The instant with its slopes over states and input.
struct Sloped<'a> {
    e: &'a Elements,
    by: Instant<Dual<DIRECTIONS>>,
}

impl<'a> Sloped<'a> {
    fn new(e: &'a Elements, state: &State, input: &Input) -> Sloped<'a> {
        let x = super::displacement(state, input);
        let Input { velocity: v, side_force, temperature, .. } = *input;
        let states = e.paths.slots().read(state);
        let w = oil(e, &states, &Around { x, v, side_force, temperature });
        let mut lifted = [Dual::constant(0.0); STATES];
        for (direction, (to, value)) in lifted.iter_mut().zip(states).enumerate() {
            *to = Dual::along(value, direction);
        }
        let around = Around { x: Dual::along(x, STATES), v: Dual::along(v, STATES + 1), side_force, temperature };
        let read = e.paths.fv_curve.at(w);
        let w = Dual::along(w, STATES + 2);
        let curve = w.chain(read.value, read.slope);
        Sloped { e, by: instant(e, &lifted, &around, w, curve) }
    }

    /// The slopes of a number, the velocity of the oil following.
    fn slopes(&self, number: &Dual<DIRECTIONS>) -> [f64; DIRECTIONS] {
        let by_w = self.by.residual.slope(STATES + 2);
        let follows = if by_w != 0.0 { -number.slope(STATES + 2) / by_w } else { 0.0 };
        let mut slopes = number.slopes;
        for (to, residual) in slopes.iter_mut().zip(&self.by.residual.slopes) {
            *to += follows * residual;
        }
        slopes
    }
}

/// The force through both paths, its parts, and its slopes over displacement and velocity of the driven end.
pub(super) struct Through {
    pub force: f64,
    pub primary: f64,
    pub inner: f64,
    pub by_input: [f64; 2],
    pub heat: f64,
}

pub(super) fn force(e: &Elements, state: &State, input: &Input) -> Through {
    let sloped = Sloped::new(e, state, input);
    let [.., by_x, by_v, _] = sloped.slopes(&sloped.by.force);
    Through {
        force: sloped.by.force.value,
        primary: sloped.by.primary.value,
        inner: sloped.by.inner.value,
        by_input: [by_x, by_v],
        heat: e.paths.slots().read(state)[place::HEAT],
    }
}

/// Rates of the states.
pub(super) fn rates(e: &Elements, state: &State, input: &Input, rate: &mut State) {
    let x = super::displacement(state, input);
    let states = e.paths.slots().read(state);
    let around = Around { x, v: input.velocity, side_force: input.side_force, temperature: input.temperature };
    let w = oil(e, &states, &around);
    let instant = instant(e, &states, &around, w, e.paths.fv_curve.at(w).value);
    e.paths.slots().write(&instant.rates, rate);
}

/// Adds the slopes of force and rates.
pub(super) fn partials(e: &Elements, state: &State, input: &Input, p: &mut Partials) {
    let sloped = Sloped::new(e, state, input);
    let slots = sloped.e.paths.slots();
    let force = sloped.slopes(&sloped.by.force);
    for (place, slope) in force.iter().enumerate().take(STATES) {
        if let Some(to) = slots.index(place).and_then(|i| p.force_by_state.get_mut(i)) {
            *to = *slope;
        }
    }
    for (place, rate) in sloped.by.rates.iter().enumerate() {
        let slopes = sloped.slopes(rate);
        let Some(i) = slots.index(place) else { continue };
        let [.., by_x, by_v, _] = slopes;
        if let Some(to) = p.rate_by_input.get_mut(i) {
            *to = [by_x, by_v];
        }
        let Some(row) = p.rate_by_state.get_mut(i) else { continue };
        for (place, slope) in slopes.iter().enumerate().take(STATES) {
            if let Some(to) = slots.index(place).and_then(|j| row.get_mut(j)) {
                *to = *slope;
            }
        }
    }
}

/// The velocity of the oil and the hydraulic force where nothing opens or closes any more: what [`crate::settle`] needs.
pub(crate) fn settled(e: &Paths, x: f64, v: f64, temperature: f64) -> ([f64; STATES], f64) {
    let mut states = [0.0; STATES];
    // What a state is drawn to follows the force, and the force the state: both have settled long before the end.
    let mut force = 0.0;
    for _ in 0..200 {
        // No spring moves the oil.
        let side_force = 0.0;
        let around = Around { x, v, side_force, temperature };
        let standing = e.fv_curve.at_zero();
        let mut held = states;
        let solve = |states: &[f64; STATES], void_moves: bool| {
            let lifted = states.map(Dual::<2>::constant);
            let around = Around { x: Dual::constant(x), v: Dual::constant(v), side_force, temperature };
            let standing = Dual::constant(standing);
            let steady = |w: Dual<2>, f: Dual<2>| {
                let force = flow(e, f, standing, w, &around, &lifted).force;
                let through = w + bypass::flow(e, force, around.x, &lifted) - around.v;
                if !void_moves {
                    return through;
                }
                through + e.cavitation.rate(force, around.v, lifted[place::VOID]) * e.cavitation.sign
            };
            if void_moves || bypass::is_open(e) {
                oil_velocity(e, v, [0.5, 1e-12], TOLERANCE, &|w: f64, f: f64| sloped(steady, w, f), &mut ()).answer()
            } else {
                v
            }
        };
        if e.has_cavitation() {
            let w = solve(&states, false);
            let whole = flow(e, e.fv_curve.at(w).value, standing, w, &around, &states).force;
            held[place::VOID] = e.cavitation.rests(whole);
            states[place::VOID] = held[place::VOID];
        }
        let w = solve(&states, e.has_cavitation());
        let flow = flow(e, e.fv_curve.at(w).value, standing, w, &around, &states);
        held[place::SELECTIVE] =
            if e.has_passage() { e.frequency_selective_damping.settles(flow.force) } else { flow.selective_target };
        held[place::VALVE] = e.valve_hysteresis.rests(flow.before_valve, states[place::VALVE]);
        let still = held == states && force == flow.force;
        force = flow.force;
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
