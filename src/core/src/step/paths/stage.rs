//! One stage of the step through the force paths: its equation, its solution, and the derivatives of the solution.

use super::on_mass::{MassForces, MassStart};
use super::{Balance, Carried, Known, MovedFrom, REACH, StageDerivatives};
use crate::assembly::Elements;
use crate::dual::Dual;
use crate::element::{OperatingPoint, Response};
use crate::elements::bushing::Relaxed;
use crate::input::PathPoint;
use crate::math::min;
use crate::paths::acting::acts;
use crate::paths::bits::{
    BUSHING, CAVITATION, COLUMN, GROOVE, HEAT, LENGTH, PASSAGE, SERIES, SLOW_BUSHING, SPOOL, WHOLE,
};
use crate::paths::bypass::Past;
use crate::paths::hydraulic::{Column, Factors, Moves, Valves};
use crate::paths::series;
use crate::paths::solve::{Equation, Found, ITERATIONS, Residual, oil_velocity};
use crate::paths::{Paths, STATES, place};
use crate::step::reach::tangent_by_driven;
use crate::tables::{ForceLaw, Tables};
use core::cell::Cell;

/// Largest last Newton step in the solution of a stage, relative to the oil velocity. The remaining relative error is
/// about the square of this ratio.
const TOLERANCE: f64 = 1e-5;

/// A solved stage, with the values that are necessary for derivatives of the step. `ON` is the set of elements that act
/// in the stage ([`crate::paths::acting`]).
#[derive(Clone, Copy, Debug)]
pub struct PathsStage<'a, T: Tables, const ON: u32> {
    paths: &'a Paths<T>,
    /// Index of the stage in its substep.
    pub index: usize,
    /// Whether the stage ends the substep.
    pub last: bool,
    /// Weights of the gains (g × rate of the states) of the previous stages, with the weight g of the stage.
    pub row: &'a [f64],
    /// Motion of the moving end at the stage.
    pub path: PathPoint,
    /// Displacement of the moving end before the stage, m, with its derivatives.
    pub(super) moved_from: MovedFrom,
    /// Oil velocity at which the FV curve was evaluated, m/s.
    pub oil_velocity: f64,
    /// Displacement of the internal mass after the stage, m.
    pub x_m: f64,
    /// Velocity of the internal mass after the stage, m/s.
    pub u: f64,
    g: f64,
    /// Weight, s, of the rate of the valve's state: see `Known::since`.
    since: f64,
    pub(super) valve_jumps: bool,
    /// Factor by which a lagging valve increased the force.
    pub(super) raised: f64,
    known: [f64; STATES],
    from_start: MassStart,
    has_states_on_mass: bool,
    /// Bit set of the states whose known parts were clamped to their ranges.
    pub(super) kept: u32,
    /// Whether the void counts as closed after the stage, even if rounding leaves a nonzero depth.
    pub(super) shuts: bool,
    /// Derivative of the FV curve at the oil velocity, N s/m.
    derivative: f64,
    at: StageAtVelocity,
    /// One over the total derivative of the stage equation's residual with respect to the oil velocity.
    per: f64,
    /// Derivative of the force of the springs on the mass with respect to the displacement of the moving end, N/m: see
    /// [`tangent_by_driven`].
    springs_by_driven: f64,
}

/// Derivatives of the inputs of a stage with respect to one variable (a direction).
#[derive(Clone, Copy, Debug)]
pub struct Seed {
    /// Derivatives of the known parts of the states.
    pub known: [f64; STATES],
    /// Derivative of the displacement of the moving end.
    pub x: f64,
    /// Derivative of the velocity of the moving end.
    pub v: f64,
    /// Derivative of the displacement of the moving end before the stage.
    pub from: f64,
    /// Derivative of the FV curve's force at the evaluated velocity.
    pub curve: f64,
    /// Derivative of the FV curve's force at standstill.
    pub standing: f64,
    /// Derivatives of the FV curve's force, relative to that at standstill, at the velocities of
    /// [`StageDerivatives::valve_read`].
    pub read: [f64; 2],
    /// Derivative of the series force at constant motion and states: see [`StageDerivatives::series_by_frame`].
    pub series: f64,
    /// Derivative of the restoring force of springs and inertia on the mass, at constant motion and states.
    pub drag: f64,
}

impl Seed {
    /// Zero derivatives.
    pub const NONE: Seed = Seed {
        known: [0.0; STATES],
        x: 0.0,
        v: 0.0,
        from: 0.0,
        curve: 0.0,
        standing: 0.0,
        read: [0.0; 2],
        series: 0.0,
        drag: 0.0,
    };
}

/// The derivatives of a stage's results with respect to one variable (a direction).
#[derive(Clone, Copy, Debug)]
pub struct Derivative {
    /// Derivatives of the states after the stage.
    pub states: [f64; STATES],
    /// Derivative of the force between moving end and ground through both force paths.
    pub force: f64,
}

/// Quantities of a stage computed from an oil velocity w, with their derivatives.
#[derive(Clone, Copy, Debug)]
struct StageAtVelocity {
    residual: Residual,
    valves: Valves,
    column: Column,
    /// Flow through the bypass of the valves.
    past: Past,
    /// Depth e of the void, m. `void_by` contains the derivatives of e. `oil_void_by` contains those of the change of e
    /// in the stage, without the refill deficit. The three variables are the hydraulic force, the moving end's
    /// velocity, and the known part of e.
    void: f64,
    void_by: [f64; 3],
    oil_void_by: [f64; 3],
    /// Derivative of the piston velocity u with respect to the hydraulic force at constant oil velocity.
    u_by_force: f64,
    x: f64,
    u: f64,
    /// Relaxing deflections z and y of the bushing.
    relaxed: Relaxed,
    /// Derivative of the bushing's relaxing deflection, (k_1 z + k_2 y)/k_s, with respect to the rate of the series
    /// deflection.
    relaxing_by_rate: f64,
    law: series::Derivatived,
    inner: Response,
    on_mass: MassForces,
    /// Derivative of the restoring force on the mass (springs, series path, inertia) with respect to its velocity, N
    /// s/m.
    resists: f64,
}

impl<'a, T: Tables, const ON: u32> PathsStage<'a, T, ON> {
    /// Solves the stage from a guess of the oil velocity, m/s.
    #[inline(always)]
    pub(super) fn solve(
        elements: &'a Elements<T>,
        known: &Known<'a>,
        path: PathPoint,
        side: (f64, f64),
        guess: f64,
    ) -> PathsStage<'a, T, ON> {
        let e = &elements.paths;
        let (g, states) = (known.g, known.states);
        let factors = Factors::new::<ON>(e, path.x, side.1, states[place::HEAT]);
        let standing = e.fv_curve.at_zero();
        let per_g = 1.0 / g;
        let given = StageInputs {
            elements,
            path,
            from: known.moved_from.x,
            side,
            states,
            on_mass: &known.on_mass,
            g,
            since: known.since,
            raised: Cell::new(known.raised),
            per_g,
            standing,
            factors,
        };
        let least = if acts::<ON>(e, SERIES) { [0.1 * e.series_compliance.mass * per_g, 1e-3] } else { [0.5, 1e-12] };
        // Relative tolerance at which the last Newton step moves the mass by at most a nanometer. In long stages, it is
        // smaller than [`TOLERANCE`].
        let short = 1e-9 / (g * (1e-3 + guess.abs()));
        let tolerance = min(short, TOLERANCE);
        // If no element lies between the moving end and the valves, the oil has the velocity of the moving end.
        let is_sought = acts::<ON>(e, SERIES | COLUMN | CAVITATION | GROOVE | PASSAGE);
        let (from, rounds) = if is_sought { (guess, ITERATIONS) } else { (path.v, 0) };
        let mut at = StageAtVelocity::NONE;
        let Found { w, step, curve } =
            oil_velocity(e, from, rounds, least, tolerance, &Stage::<T, ON>(e, &given), &mut at);
        at.go::<ON>(e, g, step, curve.derivative);
        let by_w = at.residual.by_w + at.residual.by_curve * curve.derivative;
        PathsStage {
            paths: e,
            index: known.index,
            last: known.last,
            row: known.row,
            path,
            moved_from: known.moved_from,
            oil_velocity: w + step,
            x_m: at.x,
            u: at.u,
            g,
            since: known.since,
            valve_jumps: known.valve_jumps,
            raised: given.raised.get(),
            known: states,
            from_start: known.on_mass,
            has_states_on_mass: elements.has_states_on_mass(),
            kept: known.kept,
            shuts: false,
            derivative: curve.derivative,
            at,
            per: if by_w != 0.0 { 1.0 / by_w } else { 0.0 },
            springs_by_driven: 0.0,
        }
    }

    /// Evaluates the equation again at the solution, for the derivatives.
    ///
    /// The derivatives of the last evaluation belong to a point one Newton step away from the solution. Strongly
    /// nonlinear forces are those of a bushing, a void with expanding gas, and elements with a state on the mass. With
    /// such a force, the weights of the method amplify the error of the derivatives to a hundredth of the derivative of
    /// the step. No other element is so nonlinear within a Newton step. States and forces do not change.
    #[inline(always)]
    pub(super) fn evaluate_at_solution(&mut self, elements: &Elements<T>, side: (f64, f64)) {
        let (e, g) = (self.paths, self.g);
        self.springs_by_driven = tangent_by_driven(elements, self.x_m, self.u, self.path.x, side);
        if !acts::<ON>(e, BUSHING | CAVITATION) && self.on_mass().is_none() {
            return;
        }
        let curve = e.fv_curve.evaluate(self.oil_velocity);
        let given = StageInputs {
            elements,
            path: self.path,
            from: self.moved_from.x,
            side,
            states: self.known,
            on_mass: &self.from_start,
            g,
            since: self.since,
            raised: Cell::new(self.raised),
            per_g: 1.0 / g,
            standing: e.fv_curve.at_zero(),
            factors: Factors::new::<ON>(e, self.path.x, side.1, self.known[place::HEAT]),
        };
        self.at = StageAtVelocity::at::<ON>(e, &given, self.oil_velocity, curve.value);
        self.derivative = curve.derivative;
        let by_w = self.at.residual.by_w + self.at.residual.by_curve * curve.derivative;
        self.per = if by_w != 0.0 { 1.0 / by_w } else { 0.0 };
    }

    /// Computes the derivatives of the elements that act on the mass and have a state. The variables are the values at
    /// the start of the substep.
    #[inline(always)]
    pub(super) fn evaluate_at_start(&mut self, elements: &Elements<T>) {
        if self.on_mass().is_some() {
            self.at.on_mass.evaluate_at_start(elements, &self.from_start, self.x_m);
        }
    }

    /// Returns the forces of the elements that act on the mass and have a state, if such elements exist.
    #[inline(always)]
    pub(super) fn on_mass(&self) -> Option<&MassForces> {
        (acts::<ON>(self.paths, WHOLE) && self.has_states_on_mass).then_some(&self.at.on_mass)
    }

    /// Returns states and forces after the stage.
    #[inline(always)]
    pub(super) fn balance(&self) -> Balance {
        let (e, at, g) = (self.paths, &self.at, self.g);
        let mut states = self.known;
        let primary = at.valves.force;
        states[place::X] = at.x;
        states[place::U] = at.u;
        if acts::<ON>(e, BUSHING) {
            states[place::BUSHING] = at.relaxed.at[0];
        }
        if acts::<ON>(e, SLOW_BUSHING) {
            states[place::SLOW_BUSHING] = at.relaxed.at[1];
        }
        if acts::<ON>(e, COLUMN) {
            states[place::COLUMN] = at.column.state;
        }
        if acts::<ON>(e, CAVITATION) {
            states[place::VOID] = at.void;
        }
        states[place::SELECTIVE] = if acts::<ON>(e, PASSAGE) { at.past.state } else { at.valves.selective };
        states[place::VALVE] = at.valves.valve;
        if acts::<ON>(e, SPOOL) {
            states[place::VALVE_RATE] =
                (at.valves.valve - self.known[place::VALVE]) / (g * e.valve_hysteresis.per_time);
        }
        if acts::<ON>(e, HEAT) {
            let fade = &e.temperature_fade;
            let flow = self.oil_velocity + at.past.flow;
            let heated = self.known[place::HEAT] + primary * flow * (g * fade.per_capacity);
            states[place::HEAT] = heated / (1.0 + g * fade.cooling);
        }
        let force = if acts::<ON>(e, SERIES) { at.law.force } else { at.inner.force + primary };
        Balance { states, force, primary, inner: at.inner.force, on_mass: self.on_mass().map(MassForces::states) }
    }

    /// Computes the derivatives of the stage's results in one direction; `seed` contains those of its inputs.
    #[inline(always)]
    pub fn along(&self, seed: &Seed) -> Derivative {
        let (e, at, g) = (self.paths, &self.at, self.g);
        let (known, has_series) = (&seed.known, acts::<ON>(e, SERIES));
        let leaks = acts::<ON>(e, COLUMN);
        let per_g = 1.0 / g;
        let mut moves = Moves {
            curve: seed.curve,
            standing: seed.standing,
            w: 0.0,
            x: seed.x,
            rise: known[place::HEAT],
            valve: e.valve_hysteresis.known(known[place::VALVE], known[place::VALVE_RATE], self.since),
            read: seed.read,
            selective: known[place::SELECTIVE],
        };
        // Compute the derivatives first at constant oil velocity w, then add the effect of the derivative of w.
        let [held, ..] = at.valves.along::<ON>(e, &moves, leaks);
        let mut u_held = at.u_by_force * held;
        let [void_by_force, void_by_v, void_by_void] = at.void_by;
        let void_held = void_by_v * seed.v + void_by_void * known[place::VOID];
        let [_, by_known, by_x, by_from] = at.column.change_by;
        if acts::<ON>(e, COLUMN) {
            u_held += per_g * (by_known * known[place::COLUMN]);
        }
        if acts::<ON>(e, LENGTH) {
            u_held += per_g * (by_x * seed.x + by_from * seed.from);
        }
        if acts::<ON>(e, GROOVE | PASSAGE) {
            u_held += at.past.flow_by[1] * seed.x + at.past.flow_by[2] * known[place::SELECTIVE];
        }
        if acts::<ON>(e, CAVITATION) {
            let [_, by_v, by_void] = at.oil_void_by;
            u_held += (per_g * e.cavitation.sign) * (by_v * seed.v + by_void * known[place::VOID]);
        }
        let law = &at.law;
        let by_rate = law.by_rate + law.by_relaxing * at.relaxing_by_rate;
        let Relaxed { by_rate: relaxed_by_rate, by_known, .. } = at.relaxed;
        let relaxing = [by_known[0] * known[place::BUSHING], by_known[1] * known[place::SLOW_BUSHING]];
        let residual = if has_series {
            let mut residual =
                at.resists * u_held + held + (at.inner.d_force_d_x + law.by_deflection) * known[place::X]
                    - (e.series_compliance.mass * per_g) * known[place::U]
                    + (self.springs_by_driven - law.by_deflection) * seed.x
                    - by_rate * seed.v
                    + (seed.drag - seed.series);
            if acts::<ON>(e, BUSHING) {
                residual -= law.by_relaxing * e.bushing.relaxing(relaxing);
            }
            residual
        } else {
            u_held - seed.v
        };
        moves.w = -residual * self.per;
        moves.curve += self.derivative * moves.w;
        let [primary, valve, selective] = at.valves.along::<ON>(e, &moves, leaks);
        let u = u_held + moves.w + at.u_by_force * (primary - held);
        let mut states = [0.0; STATES];
        if acts::<ON>(e, COLUMN) {
            states[place::COLUMN] = at.column.by_force * primary;
        }
        if acts::<ON>(e, LENGTH) {
            states[place::COLUMN] += at.column.d_state_d_x * seed.x;
        }
        if acts::<ON>(e, CAVITATION) {
            states[place::VOID] = void_held + void_by_force * primary;
        }
        states[place::SELECTIVE] = selective;
        if acts::<ON>(e, PASSAGE) {
            let [by_force, by_state] = at.past.state_by;
            states[place::SELECTIVE] = by_force * primary + by_state * known[place::SELECTIVE];
        }
        states[place::VALVE] = valve;
        if acts::<ON>(e, SPOOL) {
            states[place::VALVE_RATE] = (valve - known[place::VALVE]) / (g * e.valve_hysteresis.per_time);
        }
        if acts::<ON>(e, HEAT) {
            let fade = &e.temperature_fade;
            let [by_force, by_x, by_state] = at.past.flow_by;
            let past = by_force * primary + by_x * seed.x + by_state * known[place::SELECTIVE];
            let power = at.valves.force * (moves.w + past) + (self.oil_velocity + at.past.flow) * primary;
            states[place::HEAT] = (known[place::HEAT] + power * (g * fade.per_capacity)) / (1.0 + g * fade.cooling);
        }
        if !has_series {
            states[place::X] = seed.x;
            states[place::U] = seed.v;
            let inner = at.inner.d_force_d_x * seed.x + at.inner.d_force_d_v * seed.v;
            return Derivative { states, force: inner + primary + seed.drag };
        }
        let x = known[place::X] + g * u;
        states[place::X] = x;
        states[place::U] = u;
        let mut force = law.by_deflection * (seed.x - x) + law.by_rate * (seed.v - u) + seed.series;
        if acts::<ON>(e, BUSHING) {
            let relaxed = [0, 1].map(|k| relaxing[k] + relaxed_by_rate[k] * (seed.v - u));
            [states[place::BUSHING], states[place::SLOW_BUSHING]] = relaxed;
            force += law.by_relaxing * e.bushing.relaxing(relaxed);
        }
        Derivative { states, force }
    }
}

impl<T: Tables, const ON: u32> StageDerivatives for PathsStage<'_, T, ON> {
    fn oil_velocity(&self) -> f64 {
        self.oil_velocity
    }

    fn valve_read(&self) -> [f64; 2] {
        self.at.valves.read
    }

    fn mass_displacement(&self) -> f64 {
        self.x_m
    }

    fn series_by_frame(&self) -> [f64; 3] {
        [self.at.law.by_stiffness, self.at.law.by_damping, (self.u - self.known[place::U]) / self.g]
    }

    fn carry(&self, derivatives: &mut Carried, seed: Seed) {
        derivatives.over(self, seed);
    }
}

/// Inputs of a stage.
struct StageInputs<'a, T: Tables> {
    elements: &'a Elements<T>,
    path: PathPoint,
    /// Displacement of the moving end before the stage, m.
    from: f64,
    /// Side force, N, and temperature, °C, from the host.
    side: (f64, f64),
    states: [f64; STATES],
    on_mass: &'a MassStart,
    g: f64,
    since: f64,
    raised: Cell<f64>,
    per_g: f64,
    standing: f64,
    factors: Factors,
}

/// The scalar equation of a stage for the oil velocity.
struct Stage<'a, T: Tables, const ON: u32>(&'a Paths<T>, &'a StageInputs<'a, T>);

impl<T: Tables, const ON: u32> Equation for Stage<'_, T, ON> {
    type Seen = StageAtVelocity;
    #[inline(always)]
    fn evaluate(&self, w: f64, curve: f64, seen: &mut StageAtVelocity) -> Residual {
        *seen = StageAtVelocity::at::<ON>(self.0, self.1, w, curve);
        seen.residual
    }
}

/// Evaluates the force on the mass parallel to the oil, at displacement `x`, m, and velocity `u`, m/s. Where `x` is
/// further than [`REACH`] from the displacement `driven` of the moving end, m, the force is extrapolated linearly.
///
/// The plain step has the same limit. Without the limit, Newton's method from a distant guess would converge slowly
/// with a hardening spring.
#[inline(always)]
fn springs(e: &Elements<impl Tables>, x: f64, u: f64, driven: f64, (side_force, temperature): (f64, f64)) -> Response {
    let at = if x < driven - REACH { driven - REACH } else { x };
    let at = if at > driven + REACH { driven + REACH } else { at };
    let near = e.on_the_mass(&OperatingPoint { displacement: at, velocity: u, side_force, temperature });
    Response { force: near.force + near.d_force_d_x * (x - at), ..near }
}

/// Flows that the force of the valves drives, and the resulting velocity of the mass.
struct Flows {
    /// Velocity of the mass, m/s.
    u: f64,
    u_by_force: f64,
    column: Column,
    past: Past,
    void: f64,
    void_by: [f64; 3],
    oil_void_by: [f64; 3],
}

impl Flows {
    /// Evaluates the flows at the force of the valves, N, and the oil velocity `w`, m/s.
    #[inline(always)]
    fn stage<const ON: u32>(e: &Paths<impl Tables>, given: &StageInputs<impl Tables>, force: f64, w: f64) -> Flows {
        let (mut u, mut u_by_force) = (w, 0.0);
        let mut column = Column::NONE;
        if acts::<ON>(e, COLUMN) {
            column = Column::stage::<ON>(e, force, [given.from, given.path.x], given.states[place::COLUMN]);
            u += column.change * given.per_g;
            u_by_force += column.change_by[0] * given.per_g;
        }
        let mut past = Past::NONE;
        if acts::<ON>(e, GROOVE | PASSAGE) {
            past = Past::stage::<ON>(e, force, given.path.x, given.states[place::SELECTIVE], given.g);
            u += past.flow;
            u_by_force += past.flow_by[0];
        }
        let (mut void, mut void_by, mut oil_void_by) = (0.0, [0.0; 3], [0.0; 3]);
        if acts::<ON>(e, CAVITATION) {
            let (force, v) = (Dual::<3>::along(force, 0), Dual::along(given.path.v, 1));
            let before = Dual::along(given.states[place::VOID], 2) + e.cavitation.lags(v) * given.g;
            let after = e.cavitation.stage(force, v, before, given.g);
            let oils = after - before;
            (void, void_by, oil_void_by) = (after.value, after.derivatives, oils.derivatives);
            let per = given.per_g * e.cavitation.sign;
            u += oils.value * per;
            u_by_force += oil_void_by[0] * per;
        }
        Flows { u, u_by_force, column, past, void, void_by, oil_void_by }
    }
}

impl StageAtVelocity {
    /// The initial value before any evaluation.
    const NONE: StageAtVelocity = StageAtVelocity {
        residual: Residual { value: 0.0, by_w: 0.0, by_curve: 0.0 },
        valves: Valves::NONE,
        column: Column::NONE,
        past: Past::NONE,
        void: 0.0,
        void_by: [0.0; 3],
        oil_void_by: [0.0; 3],
        u_by_force: 0.0,
        x: 0.0,
        u: 0.0,
        relaxed: Relaxed::NONE,
        relaxing_by_rate: 0.0,
        law: series::Derivatived::NONE,
        inner: Response::NONE,
        on_mass: MassForces::NONE,
        resists: 0.0,
    };

    /// Extrapolates all quantities linearly by a step of the oil velocity, m/s; `derivative` is that of the FV curve.
    #[inline(always)]
    fn go<const ON: u32>(&mut self, e: &Paths<impl Tables>, g: f64, step: f64, derivative: f64) {
        let moves = Moves { curve: derivative * step, w: step, ..Moves::NONE };
        let [force, valve, selective] = self.valves.along::<ON>(e, &moves, acts::<ON>(e, COLUMN));
        self.valves.force += force;
        self.valves.valve += valve;
        self.valves.selective += selective;
        self.column.state += self.column.by_force * force;
        self.past.flow += self.past.flow_by[0] * force;
        self.past.state += self.past.state_by[0] * force;
        self.void += self.void_by[0] * force;
        if !acts::<ON>(e, SERIES) {
            return;
        }
        let u = step + self.u_by_force * force;
        self.u += u;
        self.x += g * u;
        self.inner.force += (self.inner.d_force_d_v + g * self.inner.d_force_d_x) * u;
        if acts::<ON>(e, WHOLE) {
            self.on_mass.go(g * u);
        }
        self.law.force -= (self.law.by_deflection * g + self.law.by_rate) * u;
        if acts::<ON>(e, BUSHING) {
            for (at, by_rate) in self.relaxed.at.iter_mut().zip(self.relaxed.by_rate) {
                *at -= by_rate * u;
            }
            self.law.force -= self.law.by_relaxing * self.relaxing_by_rate * u;
        }
    }

    #[inline(always)]
    fn at<const ON: u32>(
        e: &Paths<impl Tables>,
        given: &StageInputs<impl Tables>,
        w: f64,
        curve: f64,
    ) -> StageAtVelocity {
        let StageInputs {
            elements,
            path,
            side,
            states: known,
            on_mass,
            g,
            since,
            raised,
            per_g,
            standing,
            factors,
            ..
        } = given;
        let (g, per_g, side) = (*g, *per_g, *side);
        let leaks = acts::<ON>(e, COLUMN);
        let valves = Valves::stage::<ON>(e, factors, [curve, *standing, w], known, [g, *since], raised, leaks);
        let flows = Flows::stage::<ON>(e, given, valves.force, w);
        let Flows { mut u, u_by_force, column, past, void, void_by, oil_void_by } = flows;
        let (mut relaxed, mut relaxing, mut relaxing_by_rate) = (Relaxed::NONE, 0.0, 0.0);
        let mut states_on_mass = MassForces::NONE;
        let (residual, x, law, at, resists);
        if acts::<ON>(e, SERIES) {
            x = known[place::X] + u * g;
            let rate = path.v - u;
            if acts::<ON>(e, BUSHING) {
                let before = [known[place::BUSHING], known[place::SLOW_BUSHING]];
                relaxed = if acts::<ON>(e, SLOW_BUSHING) {
                    e.bushing.stage::<true>(rate, before, g)
                } else {
                    e.bushing.stage::<false>(rate, before, g)
                };
                (relaxing, relaxing_by_rate) = (e.bushing.relaxing(relaxed.at), e.bushing.relaxing(relaxed.by_rate));
            }
            law = series::with_derivatives::<ON>(e, path.x - x, rate, relaxing);
            let mut pulls = springs(elements, x, u, path.x, side);
            if acts::<ON>(e, WHOLE) && elements.has_states_on_mass() {
                states_on_mass = MassForces::stage(elements, on_mass, x);
                let [force, by_x] = states_on_mass.force();
                pulls.force += force;
                pulls.d_force_d_x += by_x;
            }
            at = pulls;
            let mass_rate = e.series_compliance.mass * per_g;
            let mut held = mass_rate + at.d_force_d_v + g * at.d_force_d_x + g * law.by_deflection + law.by_rate;
            if acts::<ON>(e, BUSHING) {
                held += law.by_relaxing * relaxing_by_rate;
            }
            resists = held;
            let follows = 1.0 + resists * u_by_force;
            residual = Residual {
                value: mass_rate * (u - known[place::U]) + at.force + valves.force - law.force,
                by_w: resists + follows * valves.by_w,
                by_curve: follows * valves.by_curve,
            };
        } else {
            residual = Residual {
                value: u - path.v,
                by_w: 1.0 + u_by_force * valves.by_w,
                by_curve: u_by_force * valves.by_curve,
            };
            (x, u) = (path.x, path.v);
            (law, at, resists) = (series::Derivatived::NONE, springs(elements, x, u, x, side), 1.0);
        }
        StageAtVelocity {
            residual,
            valves,
            column,
            past,
            void,
            void_by,
            oil_void_by,
            u_by_force,
            x,
            u,
            relaxed,
            relaxing_by_rate,
            law,
            inner: at,
            on_mass: states_on_mass,
            resists,
        }
    }
}
