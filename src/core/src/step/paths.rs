//! The step of a damper whose series path or hydraulic path has elements of its own (see [`crate::paths`]).
//!
//! Every stage is one scalar equation in the velocity w of the oil at the valves:
//!
//! ```text
//! F_h = N(s F_d(w)),   q = q(F_h),   e − g ė(F_h, e) = E,   u = w + b + (s(x − g v, q) − S)/g + σ (e − E)/g
//! m (u − V)/g = F_s(x − X − g u, v − u) − F_p(X + g u) − F_h        (or u = v)
//! ```
//!
//! with the stage's known parts X, V, S, E. It is solved to rounding (see [`crate::paths::solve`]), so its derivatives are
//! those of the implicit function. The temperature is so slow that a stage damps with its known part.

mod on_mass;
mod stage;

use super::reach::REACH;
use super::tableau::{EULER, MOST_STAGES, SECOND, Tableau};
use crate::assembly::Elements;
use crate::input::{Path, PathPoint};
use crate::math::{max, min};
use crate::model::Model;
use crate::paths::acting::{acts, is_for, moves};
use crate::paths::bits::{
    AIR, ANY, BUSHING, CAVITATION, COLUMN, FADE, FREE_PLAY, GROOVE, HEAT, LENGTH, PASSAGE, POSITION, SELECTIVE, SERIES,
    SPOOL, VALVE,
};
use crate::paths::{Paths, STATES, place};
use crate::state::{Output, State};
use crate::tables::Tables;
use on_mass::MassStart;
use stage::PathsStage;
pub use stage::Seed;

/// Bounds of the length of a step, s.
///
/// Above the first the states move by more than their own rounding; below the second the host's motion is less than
/// any damper's stroke.
const SHORTEST: f64 = 1e-15;
const LONGEST: f64 = 100.0;

/// What a stage starts from.
struct Known<'a> {
    index: usize,
    last: bool,
    row: &'a [f64],
    g: f64,
    moved_from: MovedFrom,
    /// Time over which a stage takes a late valve: g, or all since the substep began.
    since: f64,
    /// Whether it is the latter.
    valve_jumps: bool,
    /// By how much the valve raised the force in the last stage.
    raised: f64,
    states: [f64; STATES],
    /// Those of them that were brought back into their ranges, as bits.
    kept: u32,
    /// Where what acts on the mass with a state starts from.
    on_mass: MassStart,
}

/// Where a stage moves the driven end from, X: what it does to a column that counts stroke is s(x) − s(X).
///
/// X is put together from the stages before as the states are, so that in a whole step a column whose pressure holds has been moved by the
/// stroke, whatever the speeds were at which the stages looked. By their speeds, X = x − g v, the cheapest method did not move it at all in a
/// stroke that ends at rest, and the others by up to a stroke too much where one step goes from end to end.
#[derive(Clone, Copy, Debug)]
struct MovedFrom {
    x: f64,
    /// Slopes over the displacement and the velocity at the end of the step.
    by_end: [f64; 2],
}

impl MovedFrom {
    const NOWHERE: MovedFrom = MovedFrom { x: 0.0, by_end: [0.0; 2] };

    fn at(point: &PathPoint) -> MovedFrom {
        MovedFrom { x: point.x, by_end: point.x_by_end }
    }

    /// From the `start` of the substep and the strokes of the stages before, which the stage weighs by `row`.
    #[inline(always)]
    fn of(start: &MovedFrom, row: &[f64], strokes: &[MovedFrom], index: usize) -> MovedFrom {
        let mut from = *start;
        for (a, stroke) in row.iter().zip(strokes).take(index) {
            from.x += a * stroke.x;
            for (by, of_stroke) in from.by_end.iter_mut().zip(stroke.by_end) {
                *by += a * of_stroke;
            }
        }
        from
    }

    /// To a point: the stroke of a stage.
    #[inline(always)]
    fn to(&self, point: &PathPoint) -> MovedFrom {
        let [by_x, by_v] = point.x_by_end;
        MovedFrom { x: point.x - self.x, by_end: [by_x - self.by_end[0], by_v - self.by_end[1]] }
    }
}

/// States and forces after a stage.
struct Balance {
    states: [f64; STATES],
    /// Force of the driven end.
    force: f64,
    primary: f64,
    inner: f64,
    on_mass: Option<on_mass::States>,
}

/// Follows the stages of a step through the paths; used for derivatives. The step itself does not depend on it.
pub trait FollowPaths {
    /// Called after every stage.
    fn paths_stage(&mut self, stage: &dyn StageDerivatives);
}

/// A stage as one sees it who follows, whatever it is compiled for.
pub trait StageDerivatives {
    /// Velocity at which the FV curve was read.
    fn oil_velocity(&self) -> f64;
    /// Velocities at which a late valve read it beside that; 0 where none did.
    fn valve_read(&self) -> [f64; 2];
    /// Displacement of the mass after the stage.
    fn mass_displacement(&self) -> f64;
    /// Slopes of the force of the series path over k_s and c_s, and of the inertia over m: what moves the stage when
    /// these do.
    fn series_by_frame(&self) -> [f64; 3];
    /// Carries derivatives over the stage. `seed` says how their direction moves the stage itself; its known parts are
    /// filled in here.
    fn carry(&self, derivatives: &mut Carried, seed: Seed);
}

/// Follows each stage within the step; compiled for each follower.
///
/// It is [`PathsByEnd`] here, and others through [`Told`] in their crate.
pub(super) trait EachStage {
    /// Whether the answer's derivatives are asked for.
    fn wants_derivatives(&self) -> bool;
    /// Whether anybody follows.
    fn follows(&self) -> bool;
    /// Called after every stage.
    fn stage<const ON: u32>(&mut self, stage: &PathsStage<impl Tables, ON>);
    /// Slopes of the force over displacement and velocity at the end of the step.
    fn derivatives(&self) -> [f64; 2];
}

/// Somebody who follows from outside.
pub(super) struct Told<'a, F>(pub &'a mut F);

impl<F: FollowPaths> EachStage for Told<'_, F> {
    #[inline(always)]
    fn wants_derivatives(&self) -> bool {
        false
    }

    #[inline(always)]
    fn follows(&self) -> bool {
        true
    }

    #[inline(always)]
    fn stage<const ON: u32>(&mut self, stage: &PathsStage<impl Tables, ON>) {
        self.0.paths_stage(stage);
    }

    #[inline(always)]
    fn derivatives(&self) -> [f64; 2] {
        [0.0; 2]
    }
}

/// Derivatives in one direction, carried from stage to stage.
#[derive(Clone, Copy, Debug)]
pub struct Carried {
    /// Of the states.
    pub states: [f64; STATES],
    /// Of the force of the driven end.
    pub force: f64,
    /// Of each stage: g × rate of the states.
    gains: [[f64; STATES]; MOST_STAGES],
    /// Derivatives of the states of elements on the mass.
    on_mass: on_mass::States,
}

impl Carried {
    /// Nothing depends on the direction yet.
    pub const NONE: Carried = Carried {
        states: [0.0; STATES],
        force: 0.0,
        gains: [[0.0; STATES]; MOST_STAGES],
        on_mass: [0.0; on_mass::MOST],
    };

    /// Carries a direction through the stage: see [`StageDerivatives::carry`].
    #[inline(always)]
    fn over<const ON: u32>(&mut self, stage: &PathsStage<impl Tables, ON>, mut seed: Seed) {
        seed.known = known_part::<ON>(&self.states, stage.row, &self.gains, stage.index);
        if stage.valve_jumps {
            seed.known[place::VALVE] = self.states[place::VALVE];
        }
        if stage.kept != 0 {
            for (place, known) in seed.known.iter_mut().enumerate() {
                *known = if stage.kept & 1 << place == 0 { *known } else { 0.0 };
            }
        }
        // Until its last stage the states are those at the start of the substep.
        let start = [self.states[place::X], self.states[place::U]];
        let on_mass = stage.on_mass();
        if let Some(on_mass) = on_mass {
            seed.drag += on_mass.force_by_start(start, &self.on_mass);
        }
        let after = stage.along(&seed);
        if stage.last {
            if let Some(on_mass) = on_mass {
                self.on_mass = on_mass.states_along(after.states[place::X], start, &self.on_mass);
            }
            self.states = after.states;
            if stage.shuts {
                self.states[place::VOID] = 0.0;
            }
            self.force = after.force;
        } else if let Some(gains) = self.gains.get_mut(stage.index) {
            *gains = gain::<ON>(&after.states, &seed.known);
        }
    }
}

/// Derivatives over the displacement and velocity at the end of the step.
pub struct PathsByEnd {
    by_end: [Carried; 2],
    wanted: bool,
}

impl PathsByEnd {
    /// At the start of a step nothing depends on its end. Where they are not `wanted` nothing is followed, and they stay 0.
    #[inline(always)]
    pub fn new(wanted: bool) -> PathsByEnd {
        PathsByEnd { by_end: [Carried::NONE; 2], wanted }
    }
}

impl EachStage for PathsByEnd {
    #[inline(always)]
    fn wants_derivatives(&self) -> bool {
        self.wanted
    }

    #[inline(always)]
    fn follows(&self) -> bool {
        self.wanted
    }

    #[inline(always)]
    fn stage<const ON: u32>(&mut self, s: &PathsStage<impl Tables, ON>) {
        if !self.wanted {
            return;
        }
        let [by_x, by_v] = &mut self.by_end;
        let [xx, xv] = s.path.x_by_end;
        let [vx, vv] = s.path.v_by_end;
        let [from_x, from_v] = s.moved_from.by_end;
        by_x.over(s, Seed { x: xx, v: vx, from: from_x, ..Seed::NONE });
        by_v.over(s, Seed { x: xv, v: vv, from: from_v, ..Seed::NONE });
    }

    #[inline(always)]
    fn derivatives(&self) -> [f64; 2] {
        self.by_end.map(|carried| carried.force)
    }
}

/// The known part of a stage: the start plus Σ a_ij/γ_j gains_j over the stages before it.
#[inline(always)]
fn known_part<const ON: u32>(
    start: &[f64; STATES],
    row: &[f64],
    gains: &[[f64; STATES]],
    index: usize,
) -> [f64; STATES] {
    let mut known = *start;
    for (a, gain) in row.iter().zip(gains).take(index) {
        for place in 0..STATES {
            if moves::<ON>(place) {
                known[place] += a * gain[place];
            }
        }
    }
    known
}

/// Brings openings and fillings back into their ranges, and says which as bits.
///
/// Every stage ends inside them, but what the method of fourth order puts together for the next, with weights of up to 31, need
/// not lie there: a valve that is open two and a half times over takes more than all its force away, and the stage's
/// equation then has no one answer.
#[inline(always)]
fn keep<const ON: u32>(e: &Paths<impl Tables>, known: &mut [f64; STATES]) -> u32 {
    let mut kept = 0;
    let mut within = |place: usize, (low, high): (f64, f64)| {
        let at = known[place];
        if at < low || at > high {
            known[place] = if at < low { low } else { high };
            kept |= 1 << place;
        }
    };
    if acts::<ON>(e, VALVE) {
        within(place::VALVE, e.valve_hysteresis.range());
    }
    if acts::<ON>(e, SELECTIVE | PASSAGE) {
        within(place::SELECTIVE, e.frequency_selective_damping.range());
    }
    kept
}

/// What a stage adds to the states.
#[inline(always)]
fn gain<const ON: u32>(after: &[f64; STATES], known: &[f64; STATES]) -> [f64; STATES] {
    let mut gain = [0.0; STATES];
    for place in 0..STATES {
        if moves::<ON>(place) {
            gain[place] = after[place] - known[place];
        }
    }
    gain
}

/// What the paths answer at the end of a step.
pub(super) struct Through {
    pub force: f64,
    pub d_force_d_x: f64,
    pub d_force_d_v: f64,
}

/// A step length that the paths can take.
pub(super) fn held(dt: f64) -> f64 {
    dt.clamp(SHORTEST, LONGEST)
}

/// What moves the states of the paths during a step.
#[derive(Clone, Copy)]
pub(super) struct Drive<'a, T: Tables> {
    pub model: &'a Model<T>,
    pub path: &'a Path,
    pub substeps: u32,
    /// Side force and temperature.
    pub side: (f64, f64),
    pub method: &'a Tableau,
}

/// Moves the states of both paths along the path of the driven end.
pub(super) fn advance<T: Tables>(
    drive: &Drive<T>,
    state: &mut State,
    output: &mut Output,
    follow: &mut impl EachStage,
) -> Through {
    let e = &drive.model.elements.paths;
    let slots = e.slots();
    let states = slots.read(state);
    let driven = drive.path.point(0.0).v;
    let oil_velocity = if e.has_series() { states[place::U] } else { driven };
    let mut now = Now { states, oil_velocity, driven, ..Now::START };
    let has_states_on_mass = drive.model.elements.has_states_on_mass();
    if has_states_on_mass {
        now.on_mass = on_mass::read(&drive.model.elements, &state.internal);
    }
    /// Elements that are on alone.
    macro_rules! compiled {
        ($($on:expr,)*) => {
            match () {
                $(() if T::HAS_STAGES_OF_ITS_OWN && is_for::<{ $on }>(e) => advance_on::<{ $on }>(drive, &mut now, follow),)*
                () => advance_on::<ANY>(drive, &mut now, follow),
            }
        };
    }
    compiled! {
        SERIES | COLUMN | AIR,
        SERIES | COLUMN | LENGTH,
        SERIES | CAVITATION,
        SERIES | FREE_PLAY,
        SERIES | BUSHING,
        SERIES | POSITION,
        SERIES | GROOVE,
        SERIES | FADE | HEAT,
        SERIES | SELECTIVE,
        SERIES | PASSAGE,
        SERIES | VALVE | SPOOL,
    }
    slots.write(&now.states, state);
    if has_states_on_mass {
        on_mass::write(&drive.model.elements, &now.on_mass, &mut state.internal);
    }
    output.primary_force = now.primary;
    output.spring_force = now.inner;
    output.oil_temperature = drive.side.1 + now.states[place::HEAT];
    output.series_deflection = drive.path.end().0 - now.states[place::X];
    let [by_x, by_v] = follow.derivatives();
    Through { force: now.force, d_force_d_x: by_x, d_force_d_v: by_v }
}

#[inline(never)]
fn advance_on<const ON: u32>(drive: &Drive<impl Tables>, now: &mut Now, follow: &mut impl EachStage) {
    let Drive { model, path, substeps, side, .. } = *drive;
    let part = 1.0 / substeps as f64;
    let mut theta = 0.0;
    for left in (0..substeps).rev() {
        let substep = Substep { elements: &model.elements, path, theta, part, ends_step: left == 0, side };
        substep.take::<ON>(drive.method, now, follow);
        theta += part;
    }
}

/// Where the states are, and the forces there.
#[derive(Clone, Copy)]
struct Now {
    states: [f64; STATES],
    /// States of the elements on the mass.
    on_mass: on_mass::States,
    oil_velocity: f64,
    /// Velocity of the driven end.
    driven: f64,
    /// By how much a late valve raises the force.
    raised: f64,
    force: f64,
    primary: f64,
    inner: f64,
}

impl Now {
    const START: Now = Now {
        states: [0.0; STATES],
        on_mass: [0.0; on_mass::MOST],
        oil_velocity: 0.0,
        driven: 0.0,
        raised: 1.0,
        force: 0.0,
        primary: 0.0,
        inner: 0.0,
    };
}

/// A part of the step.
#[derive(Clone, Copy)]
struct Substep<'a, T: Tables> {
    elements: &'a Elements<T>,
    path: &'a Path,
    /// Start and length as fractions of the step.
    theta: f64,
    part: f64,
    /// Whether its end is the end of the step.
    ends_step: bool,
    /// Side force and temperature.
    side: (f64, f64),
}

/// Pieces of a substep in which a void closes.
const PIECES: u32 = 16;
/// A void smaller than this, m, is about to close.
const CLOSING: f64 = 2e-5;
/// A void smaller than this, m, is closed.
const SHUT: f64 = 1e-9;

/// Pieces of a substep in which something turns that the method of the model carries on beyond its turn.
const CALM: u32 = 8;
/// How many times further from the force of its latest stage than a straight line through the stages a substep may end. One
/// that starts level and bends with the square of time goes on 1.75 times as far. At 2.5 rubber that is let go in a step of 2 ms
/// ended 1.8 times too high (search, seed 295465, case 53629), at 2 it does not; a spool that turned went 3.2 times as far.
const THROWN: f64 = 2.0;
/// Smallest spread relative to the size of those forces: below it, an end so near is no throw.
const BESIDE: f64 = 0.02;

/// Whether the `stages` before the last account for a force at the `end`. A force that is no number is not accounted for.
#[inline(always)]
fn is_near(stages: &[f64], end: f64, method: &Tableau) -> bool {
    let (mut least, mut most) = (f64::INFINITY, f64::NEG_INFINITY);
    for force in stages {
        least = min(*force, least);
        most = max(*force, most);
    }
    let near = THROWN * method.goes_on * (most - least) + BESIDE * (most.abs() + least.abs());
    let latest = stages.get(method.latest).copied().unwrap_or(end);
    (end - latest).abs() <= near
}

/// What a substep came to.
enum Ended {
    /// Its end.
    Well,
    /// A void closed inside it.
    VoidClosed,
    /// It was thrown beyond what its stages know.
    Thrown,
}

impl<T: Tables> Substep<'_, T> {
    /// By the method of the model; in pieces where something turns inside that this would carry on beyond its turn.
    ///
    /// # What keeps the force near
    /// Each stage has an answer (see [`crate::paths::solve`]) and its own force is one that the elements make. What a method
    /// puts together from its stages need not be: the last row of the one of fourth order weighs them by up to 31. Where
    /// the force at the end lies further from that of the latest stage than those of all stages account for, the substep is done
    /// again by the method of second order, which is algebraically stable (γ ≥ ¼: Burrage & Butcher, SIAM J. Numer. Anal. 16,
    /// 1979): two motions of a damper that only takes energy do not part in it, however sharply its elements turn.
    ///
    /// The same is asked of the force of the valves where a column of two chambers counts the stroke that it has taken up: put
    /// together from stages on both sides of rest, where the chambers' lengths differ, that may stand for a force of neither,
    /// and a strong damping of the series path, whose own force spreads far, hides it.
    #[inline(always)]
    fn take<const ON: u32>(&self, method: &Tableau, now: &mut Now, follow: &mut impl EachStage) {
        let turns = acts::<ON>(&self.elements.paths, CAVITATION) && self.driven_turns(now);
        let ended = if turns { Ended::VoidClosed } else { self.run_watched::<ON>(method, now, follow) };
        match ended {
            Ended::Well => (),
            // Known to the compiler, so that nothing else is compiled for it.
            Ended::VoidClosed if const { ON & CAVITATION != 0 } => {
                self.in_pieces::<ON>(&EULER, PIECES, now, follow);
            }
            // So rare that it is compiled once for all.
            Ended::VoidClosed | Ended::Thrown => self.in_pieces::<ANY>(&SECOND, CALM, now, follow),
        }
    }

    /// Runs a substep and checks its end; pieces of the same elements use the same code.
    #[inline(always)]
    fn run_watched<const ON: u32>(&self, method: &Tableau, now: &mut Now, follow: &mut impl EachStage) -> Ended {
        if const { ON & CAVITATION != 0 } {
            self.run_apart::<ON>(method, now, true, follow)
        } else {
            self.run::<ON>(method, now, true, follow)
        }
    }

    /// [`Substep::run`], compiled once for all callers.
    #[inline(never)]
    fn run_apart<const ON: u32>(
        &self,
        method: &Tableau,
        now: &mut Now,
        watched: bool,
        follow: &mut impl EachStage,
    ) -> Ended {
        self.run::<ON>(method, now, watched, follow)
    }

    /// All stages of one method. `watched`: unless it ends where it should not; its last stage is then told to nobody, so that
    /// who follows is where the substep began.
    #[inline(always)]
    fn run<const ON: u32>(&self, method: &Tableau, now: &mut Now, watched: bool, follow: &mut impl EachStage) -> Ended {
        let e = &self.elements.paths;
        let h = self.path.length() * self.part;
        let valve_jumps = acts::<ON>(e, VALVE) && e.valve_hysteresis.jumps(h);
        let mut gains = [[0.0; STATES]; MOST_STAGES];
        let counts_stroke = acts::<ON>(e, LENGTH) && e.counts_stroke();
        let start = if counts_stroke { MovedFrom::at(&self.path.point(self.theta)) } else { MovedFrom::NOWHERE };
        let mut strokes = [MovedFrom::NOWHERE; MOST_STAGES];
        let from = now.states;
        let Now { mut oil_velocity, mut driven, mut raised, .. } = *now;
        let mut overshot = false;
        let (mut forces, mut valves) = ([0.0; MOST_STAGES], [0.0; MOST_STAGES]);
        let g = method.gamma * h;
        for (index, (row, place_of)) in method.weights.iter().zip(&method.c).enumerate().take(method.stages) {
            let last = index + 1 == method.stages;
            let ends = last && self.ends_step;
            let point = if ends { self.path.last() } else { self.path.point(self.theta + place_of * self.part) };
            let mut known = known_part::<ON>(&from, row, &gains, index);
            if valve_jumps {
                known[place::VALVE] = from[place::VALVE];
            }
            let kept = keep::<ON>(e, &mut known);
            overshot |= known[place::VOID] < 0.0;
            // The oil follows the driven end, but where a void takes up the motion.
            let follows = if acts::<ON>(e, CAVITATION) { 0.0 } else { point.v - driven };
            let guess = oil_velocity + follows;
            let since = if valve_jumps { place_of * h } else { g };
            let mut moved_from = start;
            if counts_stroke {
                moved_from = MovedFrom::of(&start, row, &strokes, index);
                if let Some(stroke) = strokes.get_mut(index) {
                    *stroke = moved_from.to(&point);
                }
            }
            let on_mass = MassStart { mass: [from[place::X], from[place::U]], states: now.on_mass, time: place_of * h };
            let known =
                Known { index, last, row, g, moved_from, since, valve_jumps, raised, states: known, kept, on_mass };
            let mut stage = PathsStage::<T, ON>::solve(self.elements, &known, point, self.side, guess);
            let balance = stage.balance();
            if !last {
                if let Some(force) = forces.get_mut(index) {
                    *force = balance.force;
                }
                if let Some(primary) = valves.get_mut(index)
                    && counts_stroke
                {
                    *primary = balance.primary;
                }
            } else if watched {
                let void = from[place::VOID];
                if acts::<ON>(e, CAVITATION) && void > 0.0 && (overshot || balance.states[place::VOID] < CLOSING) {
                    return Ended::VoidClosed;
                }
                let mut near = is_near(forces.get(..index).unwrap_or(&[]), balance.force, method);
                if counts_stroke {
                    near &= is_near(valves.get(..index).unwrap_or(&[]), balance.primary, method);
                }
                if method.latest > 0 && !near {
                    return Ended::Thrown;
                }
            }
            stage.shuts = last && balance.states[place::VOID] < SHUT;
            if follow.wants_derivatives() {
                stage.look_at_answer(self.elements, self.side);
            }
            if follow.follows() {
                stage.look_at_start(self.elements);
            }
            follow.stage(&stage);
            (oil_velocity, driven, raised) = (stage.oil_velocity, point.v, stage.raised);
            if last {
                let Balance { mut states, force, primary, inner, on_mass } = balance;
                if stage.shuts {
                    states[place::VOID] = 0.0;
                }
                let on_mass = on_mass.unwrap_or(now.on_mass);
                *now = Now { states, on_mass, oil_velocity, driven, raised, force, primary, inner };
            } else if let Some(gains) = gains.get_mut(index) {
                *gains = gain::<ON>(&balance.states, &known.states);
            }
        }
        Ended::Well
    }

    /// Whether the driven end turns round beside a void, whose pressure then jumps.
    #[inline(always)]
    fn driven_turns(&self, from: &Now) -> bool {
        let void = from.states[place::VOID];
        void > 0.0 && self.path.point(self.theta).v * self.path.point(self.theta + self.part).v <= 0.0
    }

    /// In short pieces. Those of the first order keep a void from closing further than it is open.
    #[inline(never)]
    fn in_pieces<const ON: u32>(&self, method: &Tableau, pieces: u32, now: &mut Now, follow: &mut impl EachStage) {
        let part = self.part / f64::from(pieces);
        for piece in 1..=pieces {
            let theta = self.theta + f64::from(piece - 1) * part;
            let ends_step = self.ends_step && piece == pieces;
            let piece = Substep { theta, part, ends_step, ..*self };
            piece.run_apart::<ON>(method, now, false, follow);
        }
    }
}
