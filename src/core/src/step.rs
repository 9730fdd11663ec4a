//! One host step at a fixed cost: a diagonally implicit Runge–Kutta method over a few substeps. Pure.
//!
//! In every stage the internal velocity u answers one scalar equation. With the stage's known parts X, V of
//! displacement and velocity and g = γh,
//!
//! ```text
//! x_m = X + g u,   m (u − V) = g [k_s (x_in − x_m) + c_s (v_in − u) − F_p(x_m) − F_d(u)]
//! ⇔  a u + g F_d(u) = r,   a = m + g (c_s + F_p') + g² (k_s + F_p'),
//! ```
//!
//! where the springs on the mass are linearised about the predicted x_m (they are soft beside k_s); one of a table or of a
//! higher power, whose line may end at the next point, about the x_m that they lead to. The left side
//! rises strictly with u, so there is one answer whatever the stiffness, and the FV curve finds it in a fixed number
//! of operations ([`crate::curve::Curve::solve`]). All methods are L-stable and stiffly accurate.
//!
//! The cheap step is a method of its own: see [`cheap`].

mod cheap;
pub mod paths;
mod primary;

use crate::assembly::{Elements, Outer};
use crate::curve::Value;
use crate::element::{Memory, Motion, Response};
use crate::input::{Input, Path, PathPoint};
pub use crate::integration::{Integration, Method};
use crate::integration::{LONGEST, SHORTEST};
use crate::math::pair;
use crate::model::Model;
use crate::state::{MAX_MEMORY, Output, State};
use primary::{Faded, Plain, Primary};

/// Steps longer than this, s, hide fast motion between their ends: a wheel hops in a tenth of a second.
pub const LONG_STEP: f64 = 0.01;

/// Most stages of a method.
const MOST_STAGES: usize = 5;

/// Coefficients of a diagonally implicit method; the last row is the result (stiffly accurate). A constant of a type, so
/// that every stage is compiled for its own.
trait Tableau {
    const STAGES: usize;
    const ROWS: Rows;
    /// How far from its latest stage a step through the paths may end at least, in halves of the spread of its stages: see
    /// [`paths`]. With 1 the method of four stages was taken to be thrown at every twentieth step of free play, where it was not.
    const ENDS_WITHIN: f64 = 1.0;
}

/// The rows of a method.
struct Rows {
    /// γ of each stage: the diagonal.
    gamma: [f64; MOST_STAGES],
    /// a_ij/γ_j below the diagonal: what a stage takes of γ_j h times the rates of those before.
    weights: [[f64; MOST_STAGES]; MOST_STAGES],
    /// Places of the stages inside the step.
    c: [f64; MOST_STAGES],
}

impl Rows {
    /// From the diagonal and the rows below it. The places are the sums of the rows; what is not used is 0.
    const fn new(stages: usize, gamma: [f64; MOST_STAGES], below: [[f64; MOST_STAGES]; MOST_STAGES]) -> Rows {
        let mut rows = Rows { gamma, weights: [[0.0; MOST_STAGES]; MOST_STAGES], c: [1.0; MOST_STAGES] };
        let mut i = 0;
        while i + 1 < stages {
            let (mut j, mut sum) = (0, 0.0);
            while j < i {
                sum += below[i][j];
                j += 1;
            }
            rows.c[i] = sum + gamma[i];
            i += 1;
        }
        i = 0;
        while i < stages {
            let mut j = 0;
            while j < i {
                rows.weights[i][j] = below[i][j] / gamma[j];
                j += 1;
            }
            i += 1;
        }
        rows
    }
}

struct Euler;

impl Tableau for Euler {
    const STAGES: usize = 1;
    const ROWS: Rows = Rows::new(1, [1.0; 5], [[0.0; 5]; 5]);
}

struct Second;

impl Tableau for Second {
    const STAGES: usize = 2;
    const ROWS: Rows = {
        let gamma = 1.0 - core::f64::consts::FRAC_1_SQRT_2;
        Rows::new(2, [gamma; 5], [[0.0; 5], [1.0 - gamma, 0.0, 0.0, 0.0, 0.0], [0.0; 5], [0.0; 5], [0.0; 5]])
    };
}

/// The smallest γ with which three stages of order 2 are L-stable, rounded up, and with it the smallest error (Hairer & Wanner,
/// table IV.6.4).
const THREE_STAGE_GAMMA: f64 = 0.180_425_4;
/// The second stage's place, which the conditions of order leave free: least error over dampers of every kind at 1 ms, flat
/// about it.
const THREE_STAGE_PLACE: f64 = 0.663;

struct ThreeStage;

impl Tableau for ThreeStage {
    const STAGES: usize = 3;
    const ROWS: Rows = {
        let (gamma, c2) = (THREE_STAGE_GAMMA, THREE_STAGE_PLACE);
        // b₁ + b₂ + γ = 1 and b₁ γ + b₂ c₂ + γ = ½.
        let b2 = (0.5 - gamma - (1.0 - gamma) * gamma) / (c2 - gamma);
        let below =
            [[0.0; 5], [c2 - gamma, 0.0, 0.0, 0.0, 0.0], [1.0 - gamma - b2, b2, 0.0, 0.0, 0.0], [0.0; 5], [0.0; 5]];
        Rows::new(3, [gamma; 5], below)
    };
}

/// The smallest γ with which four stages of order 3 are L-stable, rounded up (the same table).
const THIRD_GAMMA: f64 = 0.223_647_9;
/// The places of the two inner stages, which the conditions of order leave free: as [`THREE_STAGE_PLACE`].
const THIRD_PLACES: [f64; 2] = [0.607, 0.877];

struct Third;

impl Tableau for Third {
    const STAGES: usize = 4;
    const ROWS: Rows = {
        let (g, [c2, c3]) = (THIRD_GAMMA, THIRD_PLACES);
        // Σ b = 1, Σ b c = ½, Σ b c² = ⅓ without the last stage, which has c = 1 and b = γ.
        let sums = [1.0 - g, 0.5 - g, 1.0 / 3.0 - g];
        const fn weight(sums: [f64; 3], own: f64, other: f64, third: f64) -> f64 {
            (sums[2] - (other + third) * sums[1] + other * third * sums[0]) / ((own - other) * (own - third))
        }
        let (b1, b2, b3) = (weight(sums, g, c2, c3), weight(sums, c2, g, c3), weight(sums, c3, g, c2));
        // Σ b_i a_ij c_j = ⅙, solved for a₃₂.
        let others = 0.5 * g + b1 * g * g + b2 * ((c2 - g) * g + g * c2) + b3 * ((c3 - g) * g + g * c3);
        let a32 = (1.0 / 6.0 - others) / (b3 * (c2 - g));
        let below = [
            [0.0; 5],
            [c2 - g, 0.0, 0.0, 0.0, 0.0],
            [c3 - g - a32, a32, 0.0, 0.0, 0.0],
            [b1, b2, b3, 0.0, 0.0],
            [0.0; 5],
        ];
        Rows::new(4, [g; 5], below)
    };
}

struct Fourth;

impl Tableau for Fourth {
    const STAGES: usize = 5;
    /// Its weights reach 31.
    const ENDS_WITHIN: f64 = 0.0;
    const ROWS: Rows = Rows::new(
        5,
        [0.25; 5],
        [
            [0.0; 5],
            [1.0 / 2.0, 0.0, 0.0, 0.0, 0.0],
            [17.0 / 50.0, -1.0 / 25.0, 0.0, 0.0, 0.0],
            [371.0 / 1360.0, -137.0 / 2720.0, 15.0 / 544.0, 0.0, 0.0],
            [25.0 / 24.0, -49.0 / 48.0, 125.0 / 16.0, -85.0 / 12.0, 0.0],
        ],
    );
}

/// What happened in one stage: all that a derivative of the step needs.
#[derive(Clone, Copy, Debug)]
pub struct Stage<'a> {
    /// Place of the stage in its substep.
    pub index: usize,
    /// Whether it ends the substep.
    pub last: bool,
    /// γh of the stage, s.
    pub g: f64,
    /// What it takes of the gains of the stages before it.
    pub row: &'a [f64],
    /// The driven end.
    pub path: PathPoint,
    /// Known part of the velocity of the mass, V.
    pub known_velocity: f64,
    /// Displacement and velocity of the mass after the stage.
    pub x_m: f64,
    /// Velocity of the mass.
    pub u: f64,
    /// a + g F_d': what divides every derivative of u.
    pub denominator: f64,
    /// The same over g, N s/m.
    pub resistance: f64,
    /// Springs on the mass, linearised.
    pub inner: Response,
    /// Place about which they were linearised.
    pub inner_at: f64,
    /// ∂u/∂v̂ over the velocity v̂ about which the FV curve was linearised; 0 where the curve itself was solved.
    pub by_guess: f64,
    /// What the driven end adds to v̂, over the displacement and velocity at the end of the step.
    pub guess_by_end: [f64; 2],
}

/// Follows the stages of a step; used for derivatives. The step itself does not depend on it.
pub trait Follow {
    /// Whether the answer's slopes are asked for.
    #[inline(always)]
    fn wants_slopes(&self) -> bool {
        false
    }

    /// Called after every stage.
    fn stage(&mut self, elements: &Elements, stage: &Stage);

    /// Slopes of k_s x_m + c_s v_m over displacement and velocity at the end of the step: what the series force loses
    /// because the mass yields. Zero where the slopes of the output are to hold the mass still.
    #[inline(always)]
    fn yields(&self) -> [f64; 2] {
        [0.0; 2]
    }
}

/// Derivatives of the mass's motion over the displacement and velocity at the end of the step.
struct ByEnd {
    /// Whether they are asked for.
    wanted: bool,
    /// Whether anything depends on the end of the step yet: not before its first stage.
    moved: bool,
    x: [f64; 2],
    v: [f64; 2],
    /// Of k_s x_m + c_s v_m: what the series force loses because the mass yields.
    yields: [f64; 2],
    /// Of each stage of the substep: g × velocity and g × acceleration.
    gains: [[[f64; 2]; 2]; MOST_STAGES],
}

impl ByEnd {
    #[inline(always)]
    fn new(wanted: bool) -> ByEnd {
        let zero = [0.0; 2];
        ByEnd { wanted, moved: false, x: zero, v: zero, yields: zero, gains: [[zero; 2]; MOST_STAGES] }
    }
}

impl Follow for ByEnd {
    #[inline(always)]
    fn wants_slopes(&self) -> bool {
        self.wanted
    }

    #[inline(always)]
    fn stage(&mut self, elements: &Elements, s: &Stage) {
        if !self.wanted {
            return;
        }
        let e = &elements.paths.series_compliance;
        let divide = 1.0 / s.resistance;
        let follows = e.damping + s.g * e.stiffness;
        let drive = s.path.drive_by_end(e.stiffness, e.damping);
        let (mut x, mut v) = ([0.0; 2], [0.0; 2]);
        let mut u = drive.map(|d| d * divide);
        let mut yields = [0.0; 2];
        // A first stage starts from what the end of the step cannot change.
        if s.index > 0 || self.moved {
            (x, v) = (self.x, self.v);
            for (a, [moved, push]) in s.row.iter().zip(&self.gains).take(s.index) {
                x = pair(|k| x[k] + a * moved[k]);
                v = pair(|k| v[k] + a * push[k]);
            }
            let (mass_rate, stiffness) = (e.mass / s.g, e.stiffness + s.inner.by_x);
            u = pair(|k| (mass_rate * v[k] + (drive[k] - stiffness * x[k])) * divide);
        }
        if s.by_guess != 0.0 {
            u = pair(|k| u[k] + s.by_guess * (v[k] + s.guess_by_end[k]));
        }
        if s.last {
            yields = pair(|k| e.stiffness * x[k] + follows * u[k]);
        }
        let moved = u.map(|u| s.g * u);
        if s.last {
            self.x = pair(|k| x[k] + moved[k]);
            self.v = u;
            self.yields = yields;
            self.moved = true;
        } else if let Some(gains) = self.gains.get_mut(s.index) {
            *gains = [moved, pair(|k| u[k] - v[k])];
        }
    }

    #[inline(always)]
    fn yields(&self) -> [f64; 2] {
        self.yields
    }
}

/// Where the mass is, and what acts on it.
#[derive(Clone, Copy)]
struct Mass {
    x: f64,
    v: f64,
    primary: f64,
    inner: f64,
}

/// Deflection of the series spring, m, beyond which the springs on the mass are taken as straight.
const REACH: f64 = 0.05;

/// One substep under way.
struct Substep<'a, P> {
    elements: &'a Elements,
    primary: P,
    path: &'a Path,
    /// Start and length of the substep as fractions of the step.
    theta: f64,
    part: f64,
    /// Whether its end is the end of the step.
    ends_step: bool,
    /// Its length, s, and 1 over it.
    h: f64,
    per_h: f64,
    side: (f64, f64),
    start: Mass,
    predicted: f64,
    /// Of each stage: g × velocity and g × acceleration.
    gains: [[f64; 2]; MOST_STAGES],
}

impl<P: Primary> Substep<'_, P> {
    /// All stages. `BENT`: with springs that no straight line may stand for; apart, so that others do not pay for it.
    #[inline(always)]
    fn run<T: Tableau, const BENT: bool>(&mut self, follow: &mut impl Follow) -> Mass {
        let mut mass = self.stage::<T, 0, BENT>(follow);
        if T::STAGES > 1 {
            mass = self.stage::<T, 1, BENT>(follow);
        }
        if T::STAGES > 2 {
            mass = self.stage::<T, 2, BENT>(follow);
        }
        if T::STAGES > 3 {
            mass = self.stage::<T, 3, BENT>(follow);
        }
        if T::STAGES > 4 {
            mass = self.stage::<T, 4, BENT>(follow);
        }
        mass
    }

    #[inline(always)]
    fn stage<T: Tableau, const I: usize, const BENT: bool>(&mut self, follow: &mut impl Follow) -> Mass {
        let e = &self.elements.paths.series_compliance;
        let g = T::ROWS.gamma[I] * self.h;
        let mass_rate = e.mass * (1.0 / T::ROWS.gamma[I] * self.per_h);
        let resistance = mass_rate + e.damping + g * e.stiffness;
        let last = I + 1 == T::STAGES;
        let point =
            if last && self.ends_step { self.path.last() } else { self.path.at(self.theta + T::ROWS.c[I] * self.part) };
        let mut known = [self.start.x, self.start.v];
        for j in 0..I {
            let a = T::ROWS.weights[I][j];
            known = pair(|k| known[k] + a * self.gains[j][k]);
        }
        let [known_x, known_v] = known;
        let inner_at = within_reach(known_x + g * self.predicted, point.x);
        let (side_force, temperature) = self.side;
        let at = Motion { displacement: inner_at, velocity: self.predicted, side_force, temperature };
        let inner = self.elements.inner(&at);
        // F_p(x_m) ≈ F_p(x̂) + F_p' (X + g u − x̂) = known part + (g F_p' + ∂F_p/∂v) u
        let inner_known = inner.force + inner.by_x * (known_x - inner_at) - inner.by_v * self.predicted;
        let inner_slope = inner.by_v + g * inner.by_x;
        let a = resistance + inner_slope;
        let drive = e.stiffness * (point.x - known_x) + e.damping * point.v;
        let r = mass_rate * known_v + drive - inner_known;
        // Three iterations are below the method's own error.
        let (mut u, mut fd) = self.primary.solve(self.elements, a, r);
        let (mut a, mut inner, mut inner_at) = (a, inner, inner_at);
        let (mut inner_known, mut inner_slope) = (inner_known, inner_slope);
        let missed = |made: f64| (made - inner_known - inner_slope * u).abs() > MISSED * (made.abs() + fd.value.abs());
        if BENT && missed(springs(self.elements, known_x + g * u, u, point.x, self.side).1) {
            let mut balance = Balance { u, fd, inner, inner_at, inner_known, inner_slope };
            let held = Held { g, resistance, known: known_x, driven: point.x, r: r + inner_known };
            self.settle(&held, &mut balance);
            Balance { u, fd, inner, inner_at, inner_known, inner_slope } = balance;
            a = resistance + inner_slope;
        }
        let moved = g * u;
        self.gains[I] = [moved, u - known_v];
        self.predicted = u;
        let x_m = known_x + moved;
        follow.stage(
            self.elements,
            &Stage {
                index: I,
                last,
                g,
                row: &T::ROWS.weights[I],
                path: point,
                known_velocity: known_v,
                x_m,
                u,
                denominator: g * (a + fd.slope),
                resistance: a + fd.slope,
                inner,
                inner_at,
                by_guess: 0.0,
                guess_by_end: [0.0; 2],
            },
        );
        Mass { x: x_m, v: u, primary: fd.value, inner: inner_known + inner_slope * u }
    }
}

/// A place no further from the driven end than a series spring reaches: a mass flung by a jump would else take the slope of a
/// hardening spring from where it will never be.
#[inline(always)]
fn within_reach(x: f64, driven: f64) -> f64 {
    let (low, high) = (driven - REACH, driven + REACH);
    let at = if x < low { low } else { x };
    if at > high { high } else { at }
}

/// The springs on the mass at a place, straight beyond the reach of the series spring about the driven end: as if from the place
/// given, with the force at x itself.
#[inline(always)]
fn springs(e: &Elements, x: f64, velocity: f64, driven: f64, side: (f64, f64)) -> (Response, f64, f64) {
    let at = within_reach(x, driven);
    let inner = e.inner(&Motion { displacement: at, velocity, side_force: side.0, temperature: side.1 });
    (inner, inner.force + inner.by_x * (x - at), at)
}

/// What answers a stage: the velocity of the mass, the FV curve there, and the springs about a place.
struct Balance {
    u: f64,
    fd: Value,
    inner: Response,
    inner_at: f64,
    /// The springs as `inner_known` + `inner_slope` u.
    inner_known: f64,
    inner_slope: f64,
}

/// What a stage holds still while its springs are sought.
struct Held {
    g: f64,
    resistance: f64,
    /// X.
    known: f64,
    /// Displacement of the driven end.
    driven: f64,
    /// The right side without the springs.
    r: f64,
}

/// What the springs' straight line may miss, as a part of the forces on the mass: the error that the automatic method is held
/// to. More lets through forces that no spring makes.
const MISSED: f64 = 1e-3;
/// What is left of a balance of large forces that cancel, as a part of them.
const ROUNDING: f64 = 1e-12;
/// Most rounds until it misses no more. Past [`PATIENCE`] every other one halves the bracket.
const ROUNDS: usize = 60;
const PATIENCE: usize = 6;

impl<P: Primary> Substep<'_, P> {
    /// Solves a stage whose springs bend: the straight line that they were taken for at the predicted place holds neither beyond
    /// the next point of a table nor far out on a power, and a mass that meets a force which no spring makes is thrown.
    ///
    /// The springs rise with the place and the curve with the velocity, so what is left of the balance rises with u: each
    /// answer of the line about the last closes a bracket, and halves of it take over where the lines go to and fro.
    #[inline(never)]
    fn settle(&self, held: &Held, balance: &mut Balance) {
        let Held { g, resistance, known, driven, r } = *held;
        let (mut low, mut high) = (f64::NEG_INFINITY, f64::INFINITY);
        for round in 0..ROUNDS {
            let Balance { u, fd, .. } = *balance;
            let (inner, held, at) = springs(self.elements, known + g * u, u, driven, self.side);
            let slope = inner.by_v + g * inner.by_x;
            *balance = Balance { u, fd, inner, inner_at: at, inner_known: held - slope * u, inner_slope: slope };
            let left = resistance * u + held + fd.value - r;
            if left.abs() <= MISSED * (held.abs() + fd.value.abs()) + ROUNDING * r.abs() {
                break;
            }
            if left > 0.0 {
                high = u;
            } else {
                low = u;
            }
            (balance.u, balance.fd) = self.primary.solve(self.elements, resistance + slope, r - balance.inner_known);
            let inside = balance.u > low && balance.u < high;
            let halved = round >= PATIENCE && round % 2 == 0 && low.is_finite() && high.is_finite();
            if !inside || halved {
                balance.u = if low.is_finite() && high.is_finite() { 0.5 * (low + high) } else { u };
                balance.fd = self.primary.at(self.elements, balance.u);
            }
        }
    }
}

impl<'a, P: Primary> Substep<'a, P> {
    /// The substep from `start` over the part `part` of the step, from its fraction `theta` on.
    #[inline(always)]
    fn new(drive: &Drive<'a, P>, theta: f64, part: f64, ends_step: bool, start: Mass) -> Substep<'a, P> {
        let h = drive.path.length() * part;
        Substep {
            elements: drive.elements,
            primary: drive.primary,
            path: drive.path,
            theta,
            part,
            ends_step,
            h,
            per_h: 1.0 / h,
            side: drive.side,
            start,
            predicted: start.v,
            gains: [[0.0; 2]; MOST_STAGES],
        }
    }
}

/// What moves the internal mass during a step.
#[derive(Clone, Copy)]
struct Drive<'a, P> {
    elements: &'a Elements,
    primary: P,
    path: &'a Path,
    side: (f64, f64),
}

/// Moves the internal mass along the path.
#[inline(always)]
fn move_mass<T: Tableau, const ONCE: bool>(
    drive: &Drive<impl Primary>,
    substeps: u32,
    mass: Mass,
    follow: &mut impl Follow,
) -> Mass {
    if T::STAGES == 1 {
        return move_mass_cheaply(drive, substeps, mass, follow);
    }
    if drive.elements.bends() {
        return move_mass_on_bent_springs::<T>(drive, substeps, mass, follow);
    }
    if ONCE {
        // The common case, written out so that the places of the stages are constants.
        return Substep::new(drive, 0.0, 1.0, true, mass).run::<T, false>(follow);
    }
    move_mass_in_substeps::<T, false>(drive, substeps, mass, follow)
}

/// As [`move_mass`] where springs bend ([`Elements::bends`]).
#[inline(never)]
fn move_mass_on_bent_springs<T: Tableau>(
    drive: &Drive<impl Primary>,
    substeps: u32,
    mass: Mass,
    follow: &mut impl Follow,
) -> Mass {
    move_mass_in_substeps::<T, true>(drive, substeps, mass, follow)
}

#[inline(always)]
fn move_mass_in_substeps<T: Tableau, const BENT: bool>(
    drive: &Drive<impl Primary>,
    substeps: u32,
    mut mass: Mass,
    follow: &mut impl Follow,
) -> Mass {
    let part = 1.0 / substeps as f64;
    let mut theta = 0.0;
    for left in (0..substeps).rev() {
        mass = Substep::new(drive, theta, part, left == 0, mass).run::<T, BENT>(follow);
        theta += part;
    }
    mass
}

/// As [`move_mass`] by cheap steps.
fn move_mass_cheaply(drive: &Drive<impl Primary>, substeps: u32, mut mass: Mass, follow: &mut impl Follow) -> Mass {
    let (elements, path) = (drive.elements, drive.path);
    let part = 1.0 / substeps as f64;
    let h = path.length() * part;
    let mut from = path.at(0.0);
    for sub in 1..=substeps {
        let last = sub == substeps;
        let to = if last { path.last() } else { path.at(sub as f64 * part) };
        let before = cheap::Before { x: mass.x, v: mass.v, gain: to.v - from.v, h, side: drive.side };
        let at = before.springs_at(&to);
        let (inner, inner_at) = (elements.inner(&at), at.displacement);
        let after = cheap::take(elements, &before, &to, inner_at, inner);
        if !(after.holds() && after.springs_hold(elements, &to, drive.side)) {
            mass = Substep::new(drive, (sub - 1) as f64 * part, part, last, mass).run::<Euler, true>(follow);
            from = to;
            continue;
        }
        let denominator = 1.0 / after.by_impulse;
        follow.stage(
            elements,
            &Stage {
                index: 0,
                last: true,
                g: h,
                row: &[],
                path: to,
                known_velocity: mass.v,
                x_m: after.x,
                u: after.v,
                denominator,
                resistance: denominator / h,
                inner,
                inner_at,
                by_guess: after.by_guess,
                guess_by_end: pair(|k| to.v_by_end[k] - from.v_by_end[k]),
            },
        );
        mass = Mass { x: after.x, v: after.v, primary: after.primary, inner: after.spring };
        from = to;
    }
    mass
}

/// Advances all private states beside the damper along the path; returns the force of their elements and of the stops
/// at its end, with its slopes, and counts their shares in `output`.
///
/// Apart, so that a damper without such elements does not pay for them.
#[inline(never)]
fn advance_extras<T: Tableau>(
    elements: &Elements,
    path: &Path,
    substeps: u32,
    end: &Motion,
    memory: &mut [f64; MAX_MEMORY],
    output: &mut Output,
    slopes: bool,
) -> Response {
    let mut sum = elements.stops(end);
    output.stop_force = sum.force;
    elements.each_memory(|place, element| {
        let Some(slot) = memory.get_mut(place) else {
            return;
        };
        let (z, by_end) = element.carried(path, *slot, slopes).unwrap_or_else(|| {
            advance_memory::<T>(substeps, element, *slot, path, slopes, (end.side_force, end.temperature))
        });
        *slot = z;
        let recall = element.recall(end, z);
        output.count(element.share(), recall.force);
        sum.force += recall.force;
        sum.by_x += recall.by_x + recall.by_memory * by_end[0];
        sum.by_v += recall.by_v + recall.by_memory * by_end[1];
    });
    sum
}

/// Advances one element's private state, driven by the known input motion.
///
/// The rate is linearised in z once per stage: exact for a rate that is linear in its state. Without `slopes` those over
/// the end of the step are 0.
fn advance_memory<T: Tableau>(
    substeps: u32,
    element: &dyn Memory,
    z0: f64,
    path: &Path,
    slopes: bool,
    side: (f64, f64),
) -> (f64, [f64; 2]) {
    let n = substeps;
    let part = 1.0 / n as f64;
    let h = path.length() * part;
    let (mut z, mut by_end) = (z0, [0.0; 2]);
    let mut theta = 0.0;
    for sub in 0..n {
        let (mut pushes, mut d_pushes) = ([0.0; MOST_STAGES], [[0.0; 2]; MOST_STAGES]);
        let (mut now, mut d_now) = (z, by_end);
        for i in 0..T::STAGES {
            let ends_step = i + 1 == T::STAGES && sub + 1 == n;
            let point = if ends_step { path.last() } else { path.at(theta + T::ROWS.c[i] * part) };
            let mut known = z;
            for (push, weight) in pushes.iter().zip(&T::ROWS.weights[i]).take(i) {
                known += weight * push;
            }
            let at = Motion { displacement: point.x, velocity: point.v, side_force: side.0, temperature: side.1 };
            let recall = element.recall(&at, known);
            let g = T::ROWS.gamma[i] * h;
            let divide = 1.0 / (1.0 - g * recall.rate_by_memory);
            now = known + g * recall.rate * divide;
            pushes[i] = now - known;
            if !slopes {
                continue;
            }
            let mut d_known = by_end;
            for (push, weight) in d_pushes.iter().zip(&T::ROWS.weights[i]).take(i) {
                d_known = pair(|k| d_known[k] + weight * push[k]);
            }
            // Differentiated where the stage ends: there the rate depends on the input alone.
            let recall = element.recall(&at, now);
            for k in 0..2 {
                let drive = recall.rate_by_x * point.x_by_end[k] + recall.rate_by_v * point.v_by_end[k];
                d_now[k] = (d_known[k] + g * drive) * divide;
                d_pushes[i][k] = d_now[k] - d_known[k];
            }
        }
        z = now;
        by_end = d_now;
        theta += part;
    }
    (z, by_end)
}

/// Advances `from` to the end of the step, where the host's input is `to`; returns the new state and the force there
/// with its exact slopes over the displacement and the velocity of `to`.
///
/// `dt = 0` is a static evaluation: the state comes back as it was, with the force at which the damper would settle.
/// Where the host gives velocity alone, the slope over velocity includes the displacement that it integrates to.
#[inline]
pub fn step(model: &Model, from: &State, to: &Input, dt: f64) -> (State, Output) {
    let (mut state, mut output) = (State::ZERO, Output::ZERO);
    step_into(model, from, to, dt, &mut state, &mut output);
    (state, output)
}

/// As [`step`], writing the new state and the answer where the caller keeps them. False, and both as they were, where the
/// answer is not a finite number.
#[inline]
pub fn step_into(model: &Model, from: &State, to: &Input, dt: f64, state: &mut State, output: &mut Output) -> bool {
    *state = *from;
    step_in_place(model, state, to, dt, output)
}

/// As [`step`], moving a state on where it is. False, and state and answer as they were, where the answer is not a finite
/// number: that takes an input or a state far from what a damper meets.
#[inline(always)]
pub fn step_in_place(model: &Model, state: &mut State, to: &Input, dt: f64, output: &mut Output) -> bool {
    move_on(model, state, to, dt, output, true)
}

/// The force of [`step_in_place`], to the bit, where nobody asks for its slopes; `None` where it is not a finite number.
#[inline(always)]
pub fn force_in_place(model: &Model, state: &mut State, to: &Input, dt: f64) -> Option<f64> {
    let mut output = Output::ZERO;
    move_on(model, state, to, dt, &mut output, false).then_some(output.force)
}

/// A step; without `slopes` those of the answer are left to chance.
#[inline(always)]
fn move_on(model: &Model, state: &mut State, to: &Input, dt: f64, output: &mut Output, slopes: bool) -> bool {
    if !model.has_laid_out(state) {
        return move_on_laid_out(model, state, *to, dt, output, slopes);
    }
    if dt <= model.integration.cheap_up_to && dt > 0.0 && model.elements.is_plain_mass() {
        if !cheap_step::<true>(model, state, to, dt, output) {
            cheap_step_in_full(model, state, *to, dt, output);
        }
        // All is found in closed form from numbers whose fourth powers do not overflow.
        return true;
    }
    step_of_any_kind(model, state, *to, dt, output, slopes)
}

/// A step from a state of other elements, which is laid out anew first; where there is no answer it stays as it was.
#[cold]
#[inline(never)]
fn move_on_laid_out(model: &Model, state: &mut State, to: Input, dt: f64, output: &mut Output, slopes: bool) -> bool {
    let mut reached = model.laid_out(state);
    let done = step_of_any_kind(model, &mut reached, to, dt, output, slopes);
    if done {
        *state = reached;
    }
    done
}

/// A step that is not a single cheap one. The input comes by value, so that cheap steps keep theirs in registers;
/// beside the others the call is nothing.
#[cold]
#[inline(never)]
fn step_of_any_kind(model: &Model, state: &mut State, to: Input, dt: f64, output: &mut Output, slopes: bool) -> bool {
    let (mut reached, mut answer) = (*state, Output::ZERO);
    step_by_its_method(model, &mut reached, &to, dt, &mut answer, slopes);
    let finite = reached.is_finite() && answer.is_finite();
    if finite {
        *state = reached;
        *output = answer;
    }
    finite
}

#[inline(always)]
fn step_by_its_method(model: &Model, state: &mut State, to: &Input, dt: f64, output: &mut Output, slopes: bool) {
    if dt == 0.0 {
        let x = to.displacement.unwrap_or(state.displacement);
        *output = model.static_output_from(state, &Input { displacement: Some(x), ..*to });
        return;
    }
    if model.elements.has_paths() {
        if model.elements.fades_alone() && model.integration.method != Method::Euler {
            step_of_a_fading_damper(model, state, to, dt, output, slopes);
        } else {
            step_through_paths(model, state, to, dt, output, slopes);
        }
        return;
    }
    let once = model.integration.substeps(dt) == 1;
    match (model.integration.method, once) {
        (Method::Fourth, true) => answer::<Fourth, Plain, true>(model, state, to, dt, output, slopes),
        (Method::Fourth, false) => answer::<Fourth, Plain, false>(model, state, to, dt, output, slopes),
        (Method::ThreeStage, true) => answer::<ThreeStage, Plain, true>(model, state, to, dt, output, slopes),
        (Method::ThreeStage, false) => answer::<ThreeStage, Plain, false>(model, state, to, dt, output, slopes),
        (Method::Third, _) => answer::<Third, Plain, false>(model, state, to, dt, output, slopes),
        (Method::Second, _) => answer::<Second, Plain, false>(model, state, to, dt, output, slopes),
        (Method::Euler, _) => answer::<Euler, Plain, false>(model, state, to, dt, output, slopes),
    }
}

/// A step of a damper whose FV curve fades as a whole and which is a plain one otherwise ([`Elements::fades_alone`]): the factor
/// is known before the step. The cheap step is another method than what goes through the paths, and does not come here.
#[inline(never)]
fn step_of_a_fading_damper(model: &Model, state: &mut State, to: &Input, dt: f64, output: &mut Output, slopes: bool) {
    let once = model.integration.substeps(dt) == 1;
    match (model.integration.method, once) {
        (Method::ThreeStage, true) => answer::<ThreeStage, Faded, true>(model, state, to, dt, output, slopes),
        (Method::ThreeStage, false) => answer::<ThreeStage, Faded, false>(model, state, to, dt, output, slopes),
        (Method::Third, _) => answer::<Third, Faded, false>(model, state, to, dt, output, slopes),
        (Method::Second, _) => answer::<Second, Faded, false>(model, state, to, dt, output, slopes),
        (Method::Fourth | Method::Euler, _) => answer::<Fourth, Faded, false>(model, state, to, dt, output, slopes),
    }
}

/// A step of a damper with elements in its series or hydraulic path, with exact slopes where they are asked for.
#[inline(never)]
fn step_through_paths(model: &Model, state: &mut State, to: &Input, dt: f64, output: &mut Output, slopes: bool) {
    let mut by_end = paths::PathsByEnd::new(slopes);
    advance_paths_by_its_method(model, state, to, dt, &mut by_end, output);
    if to.displacement.is_none() {
        output.force_by_velocity += 0.5 * paths::held(dt) * output.force_by_displacement;
    }
}

/// As [`advance`], for a damper with elements in its series or hydraulic path ([`Elements::has_paths`]).
pub fn advance_paths(
    model: &Model,
    state: &mut State,
    to: &Input,
    dt: f64,
    follow: &mut impl paths::FollowPaths,
    output: &mut Output,
) {
    advance_paths_by_its_method(model, state, to, dt, &mut paths::Told(follow), output);
}

fn advance_paths_by_its_method(
    model: &Model,
    state: &mut State,
    to: &Input,
    dt: f64,
    follow: &mut impl paths::EachStage,
    output: &mut Output,
) {
    match model.integration.method {
        Method::Fourth => advance_paths_by::<Fourth, _>(model, state, to, dt, follow, output),
        Method::Third => advance_paths_by::<Third, _>(model, state, to, dt, follow, output),
        Method::ThreeStage => advance_paths_by::<ThreeStage, _>(model, state, to, dt, follow, output),
        Method::Second => advance_paths_by::<Second, _>(model, state, to, dt, follow, output),
        Method::Euler => advance_paths_by::<Euler, _>(model, state, to, dt, follow, output),
    }
}

fn advance_paths_by<T: Tableau, F: paths::EachStage>(
    model: &Model,
    state: &mut State,
    to: &Input,
    dt: f64,
    follow: &mut F,
    output: &mut Output,
) {
    let e = &model.elements;
    let substeps = model.integration.substeps(dt);
    let path = Path::new(state.displacement, state.velocity, to, paths::held(dt));
    let (x, v) = path.end();
    let outer = Motion { displacement: x, velocity: v, side_force: to.side_force, temperature: to.temperature };
    let method = paths::Table::of::<T>();
    let side = (to.side_force, to.temperature);
    let drive = paths::Drive { model, path: &path, substeps, side, method };
    let through = paths::advance(&drive, state, output, follow);
    state.displacement = x;
    state.velocity = v;
    let Outer { friction, preload } = e.beside(&outer);
    output.friction_force = friction.force;
    output.gas_force = preload.force;
    e.hand_out(output, &Motion { displacement: state.mass_displacement, velocity: state.mass_velocity, ..outer });
    let mut extras = Response::NONE;
    output.stop_force = 0.0;
    if e.has_beside() {
        extras = advance_extras::<T>(e, &path, substeps, &outer, &mut state.memory, output, follow.wants_slopes());
    }
    output.force = through.force + friction.force + preload.force + extras.force;
    output.force_by_displacement = through.by_x + friction.by_x + preload.by_x + extras.by_x;
    output.force_by_velocity = through.by_v + friction.by_v + preload.by_v + extras.by_v;
}

/// A cheap step in which some element takes its time, or in which a line does not hold.
#[cold]
#[inline(never)]
fn cheap_step_in_full(model: &Model, state: &mut State, to: Input, dt: f64, output: &mut Output) {
    if !cheap_step::<false>(model, state, &to, dt, output) {
        answer::<Euler, Plain, false>(model, state, &to, dt, output, true);
    }
}

/// One cheap step of a damper whose only memory is its mass, as fast as it goes. Leaves the state and returns false where its
/// lines do not hold and, with `AT_ONCE`, unless all elements answer at once; nothing is then called, and all stays in
/// registers.
#[inline(always)]
fn cheap_step<const AT_ONCE: bool>(model: &Model, state: &mut State, to: &Input, dt: f64, output: &mut Output) -> bool {
    let elements = &model.elements;
    let path = Path::new(state.displacement, state.velocity, to, dt);
    let end = path.last();
    // What does not wait for the mass comes first and is put away.
    let outer = Motion { displacement: end.x, velocity: end.v, side_force: to.side_force, temperature: to.temperature };
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
        // Friction is the likeliest to decline.
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
    let (by_x_beside, by_v_beside) = (friction.by_x + preload.by_x, friction.by_v + preload.by_v);

    let after = cheap::take(elements, &before, &end, at.displacement, springs);
    // A spring that answers at once does not bend.
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
    // The mass yields by dt k_s and dt c_s to displacement and velocity of the driven end.
    let follows = s.damping + dt * s.stiffness;
    let per_impulse = dt * after.by_impulse;
    let by_x = s.stiffness - follows * (s.stiffness * per_impulse) + by_x_beside;
    let mut by_v = s.damping - follows * (s.damping * per_impulse + after.by_guess) + by_v_beside;
    if to.displacement.is_none() {
        by_v += 0.5 * dt * by_x;
    }
    output.force_by_displacement = by_x;
    output.force_by_velocity = by_v;
    true
}

/// One step of several dampers of one model, such as the corners of a car: to the bit what single steps give.
///
/// Stops at the shortest of the lists.
pub fn step_batch(model: &Model, from: &[State], to: &[Input], dt: f64, states: &mut [State], outputs: &mut [Output]) {
    for (((from, to), state), output) in from.iter().zip(to).zip(states).zip(outputs) {
        step_into(model, from, to, dt, state, output);
    }
}

/// A step with its exact slopes where they are asked for. `ONCE`: in one substep, as most steps are. Not inlined, so that each has the registers to
/// itself.
#[inline(never)]
fn answer<T: Tableau, P: Primary, const ONCE: bool>(
    model: &Model,
    state: &mut State,
    to: &Input,
    dt: f64,
    output: &mut Output,
    slopes: bool,
) {
    let mut by_end = ByEnd::new(slopes);
    advance_by::<T, P, _, ONCE>(model, to, dt, &mut by_end, state, output);
    if to.displacement.is_none() {
        output.force_by_velocity += 0.5 * dt * output.force_by_displacement;
    }
}

/// As [`step_in_place`], telling `follow` every stage. The slopes of the output hold the internal mass and, unless `follow`
/// asks for them, the private states still. For a damper without elements in its series or hydraulic path, whose stages are of
/// another kind: see [`advance_paths`].
pub fn advance(model: &Model, state: &mut State, to: &Input, dt: f64, follow: &mut impl Follow, output: &mut Output) {
    match model.integration.method {
        Method::Fourth => advance_by::<Fourth, Plain, _, false>(model, to, dt, follow, state, output),
        Method::Third => advance_by::<Third, Plain, _, false>(model, to, dt, follow, state, output),
        Method::ThreeStage => advance_by::<ThreeStage, Plain, _, false>(model, to, dt, follow, state, output),
        Method::Second => advance_by::<Second, Plain, _, false>(model, to, dt, follow, state, output),
        Method::Euler => advance_by::<Euler, Plain, _, false>(model, to, dt, follow, state, output),
    }
}

/// By one method, in place.
#[inline(always)]
fn advance_by<T: Tableau, P: Primary, F: Follow, const ONCE: bool>(
    model: &Model,
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
    let substeps = if ONCE { 1 } else { model.integration.substeps(dt) };
    let dt = if dt > SHORTEST { dt } else { SHORTEST };
    let dt = if dt < LONGEST { dt } else { LONGEST };
    let path = Path::new(state.displacement, state.velocity, to, dt);
    let (x, v) = path.end();
    let side = (to.side_force, to.temperature);
    let outer = Motion { displacement: x, velocity: v, side_force: to.side_force, temperature: to.temperature };
    let (mut force, mut by_x, mut by_v);
    state.displacement = x;
    state.velocity = v;
    if e.has_series() {
        let s = &e.paths.series_compliance;
        let start = Mass { x: state.mass_displacement, v: state.mass_velocity, primary: 0.0, inner: 0.0 };
        let mass = move_mass::<T, ONCE>(&Drive { elements: e, primary, path: &path, side }, substeps, start, follow);
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
        let (inner, primary) = (e.inner(&outer), primary.at(e, v));
        state.mass_displacement = x;
        state.mass_velocity = v;
        output.primary_force = primary.value;
        output.spring_force = inner.force;
        output.series_deflection = 0.0;
        force = inner.force + primary.value;
        by_x = inner.by_x;
        by_v = inner.by_v + primary.slope;
    }
    let (friction, preload) = (e.friction(&outer), e.preload(&outer));
    output.friction_force = friction.force;
    output.gas_force = preload.force;
    force += friction.force + preload.force;
    by_x += friction.by_x + preload.by_x;
    by_v += friction.by_v + preload.by_v;
    if e.has_beside() {
        // Copies, so that nobody but this branch keeps them in memory.
        let (path, outer) = (path, outer);
        let sum = advance_extras::<T>(e, &path, substeps, &outer, &mut state.memory, output, follow.wants_slopes());
        force += sum.force;
        by_x += sum.by_x;
        by_v += sum.by_v;
    }
    output.force = force;
    output.force_by_displacement = by_x;
    output.force_by_velocity = by_v;
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::vec::Vec;

    /// The matrix of a method, the diagonal included.
    fn matrix<T: Tableau>() -> Vec<Vec<f64>> {
        let rows = T::ROWS;
        let entry = |i: usize, j: usize| match i.cmp(&j) {
            core::cmp::Ordering::Less => 0.0,
            core::cmp::Ordering::Equal => rows.gamma[i],
            core::cmp::Ordering::Greater => rows.weights[i][j] * rows.gamma[j],
        };
        (0..T::STAGES).map(|i| (0..T::STAGES).map(|j| entry(i, j)).collect()).collect()
    }

    /// How far a method is from the conditions up to an order.
    fn misses<T: Tableau>(order: usize) -> f64 {
        let a = matrix::<T>();
        let c: Vec<f64> = a.iter().map(|row| row.iter().sum()).collect();
        let dot = |x: &[f64], y: &[f64]| x.iter().zip(y).map(|(x, y)| x * y).sum::<f64>();
        let through = |y: &[f64]| a.iter().map(|row| dot(row, y)).collect::<Vec<f64>>();
        let power = |n: i32| c.iter().map(|c| c.powi(n)).collect::<Vec<f64>>();
        // The last row is the result.
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
        assert!(misses::<Euler>(1) < 1e-14 && misses::<Euler>(2) > 1e-3);
        assert!(misses::<Second>(2) < 1e-14 && misses::<Second>(3) > 1e-3);
        assert!(misses::<ThreeStage>(2) < 1e-14 && misses::<ThreeStage>(3) > 1e-3);
        assert!(misses::<Third>(3) < 1e-13 && misses::<Third>(4) > 1e-4);
        assert!(misses::<Fourth>(4) < 1e-13);
    }

    /// Largest growth of an oscillation of any frequency, and how much of an infinitely stiff motion is left.
    fn growth<T: Tableau>() -> (f64, f64) {
        let a = matrix::<T>();
        let after = |y: f64| {
            // Complex numbers by hand: z = iy, k_i = 1 + z Σ a_ij k_j.
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

    /// On the imaginary axis, and with all poles to the right of it since every γ is above 0: in the whole left half.
    #[test]
    fn the_methods_are_l_stable() {
        for (most, left) in
            [growth::<Euler>(), growth::<Second>(), growth::<ThreeStage>(), growth::<Third>(), growth::<Fourth>()]
        {
            assert!(most <= 1.0 + 1e-12 && left < 1e-6, "grows by {most}, leaves {left}");
        }
    }
}
