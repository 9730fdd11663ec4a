//! The step of a damper whose series path or hydraulic path has elements of its own (see [`crate::paths`]).
//!
//! Every stage is one scalar equation in the velocity w of the oil at the valves:
//!
//! ```text
//! F_h = N(s F_d(w)),   q = q(F_h),   e − g ė(F_h, e) = E,   u = w + (q − Q)/g + σ (e − E)/g
//! m (u − V)/g = F_s(x − X − g u, v − u) − F_p(X + g u) − F_h        (or u = v)
//! ```
//!
//! with the stage's known parts X, V, Q, E. It is solved to rounding (see [`crate::paths::solve`]), so its slopes are
//! those of the implicit function. The temperature is so slow that a stage damps with its known part.

use super::{Euler, MOST_STAGES, Tableau};
use crate::dual::{Dual, Real};
use crate::elements::{Elements, Motion};
use crate::input::{Path, PathPoint};
use crate::model::Model;
use crate::paths::hydraulic::{Around, deflection, flow};
use crate::paths::series::{self, Frame};
use crate::paths::solve::oil_velocity;
use crate::paths::{STATES, place};
use crate::state::{Output, State};

/// Relative change of the velocity at which a stage is solved.
const TOLERANCE: f64 = 1e-12;

/// Between these lengths of a step, s, the states move by more than their own rounding and the host's motion by less
/// than any damper's stroke.
const SHORTEST: f64 = 1e-15;
const LONGEST: f64 = 100.0;

/// One stage after it was solved: all that a derivative of the step needs.
#[derive(Clone, Copy, Debug)]
pub struct PathsStage<'a> {
    elements: &'a Elements,
    /// Place of the stage in its substep.
    pub index: usize,
    /// Whether it ends the substep.
    pub last: bool,
    /// γ.
    pub gamma: f64,
    /// The row of the method below the diagonal, for the stages before this one.
    pub row: &'a [f64],
    /// The driven end.
    pub path: PathPoint,
    /// Velocity at which the FV curve was read.
    pub oil_velocity: f64,
    g: f64,
    temperature: f64,
    known: [f64; STATES],
}

/// What a stage depends on, as derivatives in N directions.
#[derive(Clone, Copy, Debug)]
pub struct Seeds<const N: usize> {
    /// Known parts of the states.
    pub known: [[f64; N]; STATES],
    /// Displacement and velocity of the driven end.
    pub path: [[f64; N]; 2],
    /// k_s, c_s, m.
    pub frame: [[f64; N]; 3],
    /// A force that pulls at the mass.
    pub pull: [f64; N],
    /// Height of the FV curve where it was read.
    pub curve: [f64; N],
    /// Height of the FV curve at standstill.
    pub standing: [f64; N],
}

impl<const N: usize> Seeds<N> {
    /// No derivatives.
    pub const NONE: Seeds<N> = Seeds {
        known: [[0.0; N]; STATES],
        path: [[0.0; N]; 2],
        frame: [[0.0; N]; 3],
        pull: [0.0; N],
        curve: [0.0; N],
        standing: [0.0; N],
    };
}

/// The derivatives of a stage.
#[derive(Clone, Copy, Debug)]
pub struct Derivatives<const N: usize> {
    /// Of the states after the stage.
    pub states: [[f64; N]; STATES],
    /// Of the force between driven end and ground through both paths.
    pub force: [f64; N],
}

/// What follows from a velocity of the oil.
struct Balance<R> {
    /// 0 where it is the right one.
    residual: R,
    /// States after the stage.
    states: [R; STATES],
    /// Force of the driven end.
    force: R,
    primary: R,
    inner: R,
}

/// What a stage is given.
struct Given<R> {
    frame: Frame<R>,
    known: [R; STATES],
    around: Around<R>,
    pull: R,
    standing: R,
    g: f64,
}

fn balance<R: Real>(e: &Elements, given: &Given<R>, w: R, curve: R) -> Balance<R> {
    let Given { frame, known, around, g, .. } = given;
    let g = *g;
    let per_g = 1.0 / g;
    let mut states = *known;
    let flow = flow(e, curve, given.standing, w, around, known, g);
    states[place::SELECTIVE] = flow.selective;
    states[place::VALVE] = flow.valve;
    let mut u = w;
    if e.has_column() {
        let q = deflection(e, flow.force);
        states[place::COLUMN] = q;
        u = u + (q - known[place::COLUMN]) * per_g;
    }
    if e.has_cavitation() {
        let void = e.cavitation.stage(flow.force, around.v, known[place::VOID], g);
        states[place::VOID] = void;
        u = u + (void - known[place::VOID]) * (per_g * e.cavitation.sign);
    }
    let fade = &e.temperature_fade;
    if fade.heats_itself {
        let heated = known[place::HEAT] + flow.force * w * (g * fade.per_capacity);
        states[place::HEAT] = heated * (1.0 / (1.0 + g * fade.cooling));
    }
    let inner_at = |x: R, u: R| {
        let at =
            Motion { displacement: x.value(), velocity: u.value(), side_force: 0.0, temperature: around.temperature };
        let inner = e.inner(&at);
        x.chain(inner.force, inner.by_x) + u.chain(0.0, inner.by_v)
    };
    if !e.has_series() {
        states[place::X] = around.x;
        states[place::U] = around.v;
        let inner = inner_at(around.x, around.v);
        let force = inner + flow.force - given.pull;
        return Balance { residual: u - around.v, states, force, primary: flow.force, inner };
    }
    let x = known[place::X] + u * g;
    let rate = around.v - u;
    if e.has_bushing() {
        let gives_way = 1.0 / (1.0 + g * e.bushing.per_time);
        states[place::BUSHING] = (known[place::BUSHING] + rate * g) * gives_way;
    }
    states[place::X] = x;
    states[place::U] = u;
    let force = series::force(e, frame, around.x - x, rate, states[place::BUSHING]);
    let inner = inner_at(x, u);
    let inertia = frame.mass * (u - known[place::U]) * per_g;
    let residual = inertia + inner + flow.force - force - given.pull;
    Balance { residual, states, force, primary: flow.force, inner }
}

impl PathsStage<'_> {
    fn given<R: Real>(&self, lift: impl Fn(f64) -> R) -> Given<R> {
        Given {
            frame: Frame::of(self.elements),
            known: self.known.map(&lift),
            around: Around { x: lift(self.path.x), v: lift(self.path.v), temperature: self.temperature },
            pull: lift(0.0),
            standing: lift(self.elements.fv_curve.at_zero()),
            g: self.g,
        }
    }

    /// Finds the velocity of the oil.
    fn solve(&mut self) {
        let e = self.elements;
        if !e.has_series() && !e.has_column() && !e.has_cavitation() {
            self.oil_velocity = self.path.v;
            return;
        }
        let given = self.given(Dual::<2>::constant);
        let least = if e.has_series() { [0.1 * e.series_compliance.mass / self.g, 1e-3] } else { [0.5, 1e-12] };
        // So short that the mass has not moved by more than a picometre.
        let short = 1e-9 / (self.g * (1e-3 + self.oil_velocity.abs()));
        let tolerance = if short < TOLERANCE { short } else { TOLERANCE };
        self.oil_velocity =
            oil_velocity(e, self.oil_velocity, least, tolerance, |w, f| balance(e, &given, w, f).residual);
    }

    fn balance(&self) -> Balance<f64> {
        let curve = self.elements.fv_curve.at(self.oil_velocity).value;
        balance(self.elements, &self.given(|value| value), self.oil_velocity, curve)
    }

    /// The derivatives of the stage in N directions. `M` is N + 1: the last direction is the stage's own unknown.
    #[inline(always)]
    pub fn differentiate<const N: usize, const M: usize>(&self, seeds: &Seeds<N>) -> Derivatives<N> {
        let e = self.elements;
        let lift = |value: f64, slopes: &[f64; N]| {
            let mut dual = Dual::<M>::constant(value);
            for (to, from) in dual.slopes.iter_mut().zip(slopes) {
                *to = *from;
            }
            dual
        };
        let mut given = self.given(Dual::<M>::constant);
        for ((to, value), slopes) in given.known.iter_mut().zip(self.known).zip(&seeds.known) {
            *to = lift(value, slopes);
        }
        let [x, v] = &seeds.path;
        (given.around.x, given.around.v) = (lift(self.path.x, x), lift(self.path.v, v));
        let s = &e.series_compliance;
        let [stiffness, damping, mass] = &seeds.frame;
        given.frame = Frame {
            stiffness: lift(s.stiffness, stiffness),
            damping: lift(s.damping, damping),
            mass: lift(s.mass, mass),
        };
        given.pull = lift(0.0, &seeds.pull);
        given.standing = lift(e.fv_curve.at_zero(), &seeds.standing);
        let w = Dual::<M>::along(self.oil_velocity, N);
        let read = e.fv_curve.at(self.oil_velocity);
        let curve = w.chain(read.value, read.slope) + lift(0.0, &seeds.curve);
        let balance = balance(e, &given, w, curve);
        let by_w = balance.residual.slope(N);
        let per = if by_w != 0.0 { -1.0 / by_w } else { 0.0 };
        let of = |number: &Dual<M>| {
            let follows = number.slope(N) * per;
            let mut slopes = [0.0; N];
            for ((to, own), residual) in slopes.iter_mut().zip(&number.slopes).zip(&balance.residual.slopes) {
                *to = own + follows * residual;
            }
            slopes
        };
        let mut states = [[0.0; N]; STATES];
        for (to, from) in states.iter_mut().zip(&balance.states) {
            *to = of(from);
        }
        Derivatives { states, force: of(&balance.force) }
    }
}

/// Follows the stages of a step through the paths; used for derivatives. The step itself does not depend on it.
pub trait FollowPaths {
    /// Called after every stage.
    fn paths_stage(&mut self, stage: &PathsStage);

    /// Slopes of the force over displacement and velocity at the end of the step.
    fn slopes(&self) -> [f64; 2] {
        [0.0; 2]
    }
}

impl FollowPaths for () {
    fn paths_stage(&mut self, _: &PathsStage) {}
}

/// Derivatives over the displacement and velocity at the end of the step.
pub struct PathsByEnd {
    states: [[f64; 2]; STATES],
    force: [f64; 2],
    /// Of each stage: g × rate of the states.
    gains: [[[f64; 2]; STATES]; MOST_STAGES],
}

impl PathsByEnd {
    /// At the start of a step nothing depends on its end.
    pub fn new() -> PathsByEnd {
        let zero = [[0.0; 2]; STATES];
        PathsByEnd { states: zero, force: [0.0; 2], gains: [zero; MOST_STAGES] }
    }
}

impl Default for PathsByEnd {
    fn default() -> Self {
        PathsByEnd::new()
    }
}

impl FollowPaths for PathsByEnd {
    fn paths_stage(&mut self, s: &PathsStage) {
        let mut seeds = Seeds::<2>::NONE;
        seeds.known = self.states;
        add_row(&mut seeds.known, s.row, s.gamma, &self.gains, s.index);
        seeds.path = [s.path.x_by_end, s.path.v_by_end];
        let after = s.differentiate::<2, 3>(&seeds);
        if let Some(gains) = self.gains.get_mut(s.index) {
            *gains = minus(&after.states, &seeds.known);
        }
        if s.last {
            self.states = after.states;
            self.force = after.force;
        }
    }

    fn slopes(&self) -> [f64; 2] {
        self.force
    }
}

/// known += Σ a_ij/γ gains_j: what the stages before this one add to its known part.
#[inline(always)]
pub fn add_row<const N: usize>(
    known: &mut [[f64; N]; STATES],
    row: &[f64],
    gamma: f64,
    gains: &[[[f64; N]; STATES]],
    index: usize,
) {
    for (a, gain) in row.iter().zip(gains).take(index) {
        let a = a * (1.0 / gamma);
        for (to, from) in known.iter_mut().zip(gain) {
            for (to, from) in to.iter_mut().zip(from) {
                *to += a * from;
            }
        }
    }
}

/// The difference of two sets of states.
#[inline(always)]
pub fn minus<const N: usize>(a: &[[f64; N]; STATES], b: &[[f64; N]; STATES]) -> [[f64; N]; STATES] {
    let mut difference = *a;
    for (to, from) in difference.iter_mut().zip(b) {
        for (to, from) in to.iter_mut().zip(from) {
            *to -= from;
        }
    }
    difference
}

/// What the paths answer at the end of a step.
pub(super) struct Through {
    pub force: f64,
    pub by_x: f64,
    pub by_v: f64,
}

/// A step length that the paths can take.
pub(super) fn held(dt: f64) -> f64 {
    dt.clamp(SHORTEST, LONGEST)
}

/// Moves the states of both paths along the path of the driven end.
pub(super) fn advance<T: Tableau>(
    model: &Model,
    path: &Path,
    substeps: u32,
    temperature: f64,
    state: &mut State,
    output: &mut Output,
    follow: &mut impl FollowPaths,
) -> Through {
    let e = &model.elements;
    let part = 1.0 / substeps as f64;
    let slots = e.slots();
    let states = slots.read(state);
    let oil_velocity = if e.has_series() { states[place::U] } else { path.at(0.0).v };
    let mut now = Now { states, oil_velocity, ..Now::START };
    let mut theta = 0.0;
    for left in (0..substeps).rev() {
        let substep = Substep { elements: e, path, theta, part, ends_step: left == 0, temperature };
        now = if e.has_cavitation() && substep.sees_the_void_turn::<T>(&now) {
            substep.in_pieces(now, follow)
        } else {
            substep.run::<T>(&now, follow)
        };
        theta += part;
    }
    slots.write(&now.states, state);
    output.primary_force = now.primary;
    output.spring_force = now.inner;
    output.oil_temperature = temperature + now.states[place::HEAT];
    output.series_deflection = path.end().0 - now.states[place::X];
    let [by_x, by_v] = follow.slopes();
    Through { force: now.force, by_x, by_v }
}

/// Where the states are, and the forces there.
#[derive(Clone, Copy)]
struct Now {
    states: [f64; STATES],
    oil_velocity: f64,
    force: f64,
    primary: f64,
    inner: f64,
    /// Whether the void was overshot on the way.
    overshot: bool,
}

impl Now {
    const START: Now =
        Now { states: [0.0; STATES], oil_velocity: 0.0, force: 0.0, primary: 0.0, inner: 0.0, overshot: false };
}

/// A part of the step.
#[derive(Clone, Copy)]
struct Substep<'a> {
    elements: &'a Elements,
    path: &'a Path,
    /// Start and length as fractions of the step.
    theta: f64,
    part: f64,
    /// Whether its end is the end of the step.
    ends_step: bool,
    temperature: f64,
}

/// Pieces of a substep in which a void closes.
const PIECES: u32 = 16;
/// A void smaller than this, m, is closed.
const SHUT: f64 = 1e-9;

impl Substep<'_> {
    /// All stages of one method.
    fn run<T: Tableau>(&self, from: &Now, follow: &mut impl FollowPaths) -> Now {
        let g = T::GAMMA * self.path.length() * self.part;
        let mut gains = [[[0.0; 1]; STATES]; MOST_STAGES];
        let mut now = *from;
        now.overshot = false;
        for (index, (row, place_of)) in T::A.iter().zip(T::C).enumerate().take(T::STAGES) {
            let last = index + 1 == T::STAGES;
            let ends = last && self.ends_step;
            let point = if ends { self.path.last() } else { self.path.at(self.theta + place_of * self.part) };
            let mut known = from.states.map(|value| [value]);
            add_row(&mut known, row, T::GAMMA, &gains, index);
            let known = known.map(|[value]| value);
            now.overshot |= known[place::VOID] < 0.0;
            let mut stage = PathsStage {
                elements: self.elements,
                index,
                last,
                gamma: T::GAMMA,
                row,
                path: point,
                oil_velocity: now.oil_velocity,
                g,
                temperature: self.temperature,
                known,
            };
            stage.solve();
            let balance = stage.balance();
            follow.paths_stage(&stage);
            if let Some(gain) = gains.get_mut(index) {
                *gain = minus(&balance.states.map(|v| [v]), &known.map(|v| [v]));
            }
            now.oil_velocity = stage.oil_velocity;
            if last {
                now.states = balance.states;
                if now.states[place::VOID] < SHUT {
                    now.states[place::VOID] = 0.0;
                }
                (now.force, now.primary, now.inner) = (balance.force, balance.primary, balance.inner);
            }
        }
        now
    }

    /// Whether a void closes, or its driving pressure jumps, inside the substep: a method of higher order would then
    /// carry on beyond it what was before.
    fn sees_the_void_turn<T: Tableau>(&self, from: &Now) -> bool {
        let void = from.states[place::VOID];
        let (start, end) = (self.path.at(self.theta).v, self.path.at(self.theta + self.part).v);
        void > 0.0 && (start * end <= 0.0 || self.run::<T>(from, &mut ()).overshot)
    }

    /// In short implicit pieces of the first order, which keep the void from closing further than it is open.
    fn in_pieces(&self, mut now: Now, follow: &mut impl FollowPaths) -> Now {
        let part = self.part / PIECES as f64;
        for piece in 1..=PIECES {
            let theta = self.theta + (piece - 1) as f64 * part;
            let ends_step = self.ends_step && piece == PIECES;
            now = Substep { theta, part, ends_step, ..*self }.run::<Euler>(&now, follow);
        }
        now
    }
}
