//! Whether a damper chatters in a host that holds its force over a step, which element makes it, and a damper that does not.
//!
//! A host that computes the force at the start of a step and moves a mass m by it over the step h,
//!
//! ```text
//! v' = v − (h/m) F(x, v),   x' = x + h v'
//! ```
//!
//! returns a small disturbance of the velocity times 1 − g, with g = (h/m)(∂F/∂v + h ∂F/∂x). Below 1 it dies out smoothly, from 1 on
//! it changes sign at every step, beyond 2 it grows until something bounds it: friction swings between its two levels for ever.
//! The slopes are those of the damper's own step of the length h, so that a series spring and presliding friction soften what they carry.

use dashpot_core::parameter::{Element, Number};
use dashpot_core::step::step;
use dashpot_core::{Fault, Input, Model, Output, Params};
use dashpot_core::{element, list, number};

/// A host as far as chatter goes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Host {
    /// Its step, s.
    pub step: f64,
    /// The lightest mass that the damper moves, kg.
    pub mass: f64,
}

impl Host {
    /// A real-time host with the lightest mass that a damper of a car moves: wheel, hub and half the links of a small car's front corner.
    pub const USUAL: Host = Host { step: 1e-3, mass: 40.0 };
}

/// What must be known beside an export of a damper: how it chatters, where it does in that host.
pub fn remarks(params: &Params, host: Host) -> Vec<String> {
    chatter(params, host).ok().and_then(|c| c.remark(host)).into_iter().collect()
}

/// Gain from which a disturbance changes sign at every step.
pub const RINGS: f64 = 1.0;
/// Gain from which it grows.
pub const GROWS: f64 = 2.0;

/// What a damper does in a host.
#[derive(Debug, Clone, PartialEq)]
pub struct Chatter {
    /// The largest gain.
    pub gain: f64,
    /// Velocity at which it has it, m/s, and the slopes there: N s/m, N/m.
    pub velocity: f64,
    /// ∂F/∂v.
    pub by_velocity: f64,
    /// ∂F/∂x.
    pub by_displacement: f64,
    /// Where and under what it has it.
    pub situation: Situation,
    /// The longest step at which nothing changes sign, s; `None` where none was found.
    pub quiet_step: Option<f64>,
    /// The element that makes most of it, and the gain without it; `None` where no element alone does.
    pub element: Option<(Element, f64)>,
    /// What a loop like that of the host does, where that is not quiet.
    pub turning: Option<Turning>,
    /// A damping of the path in series, N s/m, with which the loop would be quiet, where it has none.
    pub calming: Option<f64>,
}

/// Amplitudes of the motions looked at, m, and their peak velocities, m/s; from standstill to a pothole. Away from the usual situation only those
/// of a middle size: the others differ little there and take most of the time.
const AMPLITUDES: [f64; 4] = [2e-4, 1e-3, 5e-3, 0.02];
const SPEEDS: [f64; 4] = [2e-3, 0.02, 0.2, 1.0];
/// One stroke through most of the travel, such as opens a void.
const LONG: (f64, f64) = (0.05, 1.0);
/// Side force, N, that a damper with friction in proportion to it is looked at under: a strut of a car in a bend or under the brake.
const SIDE_FORCE: f64 = 2000.0;
/// Force, N, up to which a stop is looked at: a front corner that goes through a pothole.
const STOP_FORCE: f64 = 1e4;
/// Temperature, °C, at which a damper whose oil thickens is looked at: a winter's morning.
const COLD: f64 = -20.0;
/// Places of the stroke, m, where the damping depends on the place.
const PLACES: [f64; 8] = [-0.08, -0.06, -0.04, -0.02, 0.02, 0.04, 0.06, 0.08];
/// Furthest place, m, at which a stop is sought.
const FURTHEST: f64 = 0.3;
/// Most steps of one motion.
const STEPS: usize = 4000;
/// Velocities looked at where a motion turns, m/s.
const AT_THE_TURN: [f64; 5] = [0.0, 5e-4, -5e-4, 3e-3, -3e-3];
/// Places on a piece of the FV curve, as shares of it: a monotone cubic is steepest in its middle or at an end.
const ON_A_PIECE: [f64; 3] = [0.02, 0.5, 0.98];
/// Stiffness of the tyre that the host's mass stands on in the loop, N/m (a car's); softer where the step could not follow the mass on it: by a step it
/// moves on by no more than this angle, rad.
const TYRE: f64 = 2e5;
const FOLLOWS: f64 = 0.3;
/// Velocity, m/s, beyond which no damper moves: the loop has left all bounds.
const BEYOND: f64 = 100.0;
/// Velocity, m/s, with which the loop begins: a knock of 10 m/s² in a millisecond.
const KNOCK: f64 = 0.01;
/// Alternating part of the force, N, from which it is seen in a vehicle's signals, and how often the force must turn among the last 24 steps: what
/// strikes once (a gap, a stop, dry friction at a reversal) turns it three or four times. A mass whose ringing is no multiple of the step turns it in
/// most steps, not in all.
const SEEN: f64 = 5.0;
const TURNS: u32 = 9;
const WINDOW: u32 = (1 << 24) - 1;
/// Most steps of the loop over one road.
const LOOP: usize = 3000;
/// Heights of the roads, m, the first for all situations; shares of the height and Hz: body, axle and what lies between.
const ROADS: [f64; 3] = [0.005, 0.02, 0.05];
const WAVES: [(f64, f64); 4] = [(0.5, 1.3), (0.25, 3.1), (0.12, 9.7), (0.06, 14.0)];
/// Mass of the body over that of the wheel.
const BODY: f64 = 10.0;
/// Halvings of the step that are tried.
const HALVINGS: i32 = 6;
/// Shares of the critical damping of the inner mass that are tried.
const DAMPED: [f64; 4] = [0.05, 0.1, 0.2, 0.4];
/// Share of the gain that must go with an element to be its doing.
const ITS_DOING: f64 = 0.3;
/// Elements that [`softened`] can replace, with their level.
const FRICTION: [(Element, Number); 2] = [
    (element!("coulomb_friction"), number!("coulomb_force")),
    (element!("stribeck_friction"), number!("stribeck_coulomb_force")),
];

/// Where in its stroke a damper moves, and under what.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Situation {
    /// Middle of the motion, m.
    pub place: f64,
    /// N.
    pub side_force: f64,
    /// °C.
    pub temperature: f64,
}

impl Situation {
    /// In the middle, without side force, at the temperature at which rigs measure.
    pub const USUAL: Situation = Situation { place: 0.0, side_force: 0.0, temperature: 20.0 };

    /// All that changes the slopes of this damper.
    fn all(params: &Params, model: &Model) -> Vec<Situation> {
        let mut all = vec![Situation::USUAL];
        if params.is_on(element!("side_force_friction")) {
            all.push(Situation { side_force: SIDE_FORCE, ..Situation::USUAL });
        }
        if params.is_on(element!("temperature_fade")) {
            all.push(Situation { temperature: COLD, ..Situation::USUAL });
        }
        let at = |place| Situation { place, ..Situation::USUAL };
        if [element!("position_dependent_damping"), element!("oil_compressibility")].iter().any(|e| params.is_on(*e)) {
            all.extend(PLACES.map(at));
        }
        let stops = [(element!("bump_stop"), -1.0), (element!("rebound_stop"), 1.0)];
        all.extend(stops.iter().filter(|(stop, _)| params.is_on(*stop)).map(|(_, side)| at(in_the_stop(model, *side))));
        all
    }

    fn input(&self) -> Input {
        Input { side_force: self.side_force, temperature: self.temperature, ..Input::motion(self.place, 0.0) }
    }

    /// What is not usual about it, in words.
    fn told(&self) -> String {
        let mut told = String::new();
        if self.place != 0.0 {
            told += &format!(
                ", {:.0} mm from the middle in {}",
                1e3 * self.place.abs(),
                if self.place > 0.0 { "rebound" } else { "compression" }
            );
        }
        if self.side_force != 0.0 {
            told += &format!(", under {:.0} N of side force", self.side_force);
        }
        if self.temperature != Situation::USUAL.temperature {
            told += &format!(", at {:.0} °C", self.temperature);
        }
        told
    }
}

/// Where the stop of a side holds [`STOP_FORCE`].
fn in_the_stop(model: &Model, side: f64) -> f64 {
    let force = |depth: f64| model.static_output(&Input::motion(side * depth, 0.0)).stop_force.abs();
    let (mut low, mut high) = (0.0, FURTHEST);
    for _ in 0..40 {
        let middle = 0.5 * (low + high);
        if force(middle) < STOP_FORCE { low = middle } else { high = middle }
    }
    side * low
}

/// A motion looked at: a sine from its middle.
#[derive(Clone, Copy)]
struct Sine {
    situation: Situation,
    amplitude: f64,
    speed: f64,
    /// rad/s.
    omega: f64,
}

impl Sine {
    fn at(&self, time: f64) -> Input {
        let phase = self.omega * time;
        let Situation { place, side_force, temperature } = self.situation;
        let motion = Input::motion(place + self.amplitude * phase.sin(), self.speed * phase.cos());
        Input { side_force, temperature, ..motion }
    }
}

/// The motions that a host can follow.
fn motions(situation: Situation, host: Host) -> impl Iterator<Item = Sine> {
    let all = AMPLITUDES.iter().flat_map(|amplitude| SPEEDS.map(|speed| (*amplitude, speed)));
    let is_usual = situation == Situation::USUAL;
    let usual = all.filter(move |(amplitude, speed)| is_usual || (1e-3..=5e-3).contains(amplitude) && *speed >= 0.02);
    usual
        .chain(is_usual.then_some(LONG))
        .map(move |(amplitude, speed)| Sine { situation, amplitude, speed, omega: speed / amplitude })
        .filter(move |sine| sine.omega * host.step <= 0.5)
}

/// The largest gain, and where the damper has it.
struct Largest {
    gain: f64,
    velocity: f64,
    output: Output,
    situation: Situation,
}

/// The largest gain over all motions in a situation.
fn largest(model: &Model, situation: Situation, host: Host) -> Largest {
    let gain = |o: &Output| host.step / host.mass * (o.force_by_velocity + host.step * o.force_by_displacement);
    let rest = situation.input();
    let at_rest = step(model, &model.settled(&rest), &rest, host.step).1;
    let mut most = Largest { gain: gain(&at_rest), velocity: 0.0, output: at_rest, situation };
    for sine in motions(situation, host) {
        let input = |k: usize| sine.at(host.step * k as f64);
        let mut state = model.settled(&rest);
        let steps = (1.25 * std::f64::consts::TAU / (sine.omega * host.step)) as usize;
        for k in 1..=steps.min(STEPS) {
            let to = input(k);
            // At the turn itself a void or a gap may close, between two instants of the motion.
            if to.velocity * input(k - 1).velocity <= 0.0 {
                for velocity in AT_THE_TURN {
                    let turned = Input { velocity, ..to };
                    let output = step(model, &state, &turned, host.step).1;
                    if gain(&output) > most.gain {
                        most = Largest { gain: gain(&output), velocity, output, situation };
                    }
                }
            }
            let (next, output) = step(model, &state, &to, host.step);
            state = next;
            let here = gain(&output);
            if here > most.gain {
                most = Largest { gain: here, velocity: to.velocity, output, situation };
            }
        }
    }
    most
}

/// The largest gain at steady velocities on every piece of the FV curve: a narrow steep one lies between the instants of every motion.
fn on_the_curve(params: &Params, model: &Model, host: Host) -> Largest {
    let knots = if params.number(number!("fv_form")) == 0.0 {
        params.list(list!("fv_velocity")).to_vec()
    } else {
        let [r1, r2, c1] = [number!("fv_rebound_v1"), number!("fv_rebound_v2"), number!("fv_compression_v1")]
            .map(|v| params.number(v));
        vec![-2.0 * c1, -c1, 0.0, r1, r2, 2.0 * r2]
    };
    let pieces = knots.windows(2).filter(|_| params.is_on(element!("fv_curve")));
    let velocities = pieces.flat_map(|piece| ON_A_PIECE.map(|share| piece[0] + share * (piece[1] - piece[0])));
    let at = |velocity: f64| {
        let to = Input::motion(0.0, velocity);
        let output = step(model, &model.settled(&to), &to, host.step).1;
        let gain = host.step / host.mass * (output.force_by_velocity + host.step * output.force_by_displacement);
        Largest { gain, velocity, output, situation: Situation::USUAL }
    };
    velocities.map(at).fold(at(0.0), |most, other| if other.gain > most.gain { other } else { most })
}

/// What a loop like that of the host does where its force turns at every step: the host's mass on a tyre, moved by a road.
///
/// The slopes at an instant do not see what a moving mass, an inner mass or a void make of the next steps. The loop does.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Turning {
    /// Largest alternating part of the force, N; infinite where the motion leaves all bounds.
    pub force: f64,
    /// Steps in which it turns; those until the motion leaves all bounds, where it does.
    pub steps: usize,
    /// Height of the road, m.
    pub height: f64,
    /// Where and under what.
    pub situation: Situation,
}

impl Turning {
    /// In words.
    fn told(&self, host: Host) -> String {
        let Turning { force, steps, height, situation } = *self;
        let does = if self.grows() {
            "the motion grows beyond all bounds".to_owned()
        } else {
            format!("the force turns from step to step, by up to {force:.0} N, in {steps} steps")
        };
        format!(
            "in such a loop that was run here ({} kg on a tyre, a rough road of {:.0} mm{}) {does}",
            host.mass,
            1e3 * height,
            situation.told()
        )
    }

    /// Whether the motion leaves all bounds.
    pub fn grows(&self) -> bool {
        self.force == f64::INFINITY
    }
}

/// What the loop does on the roads of a situation, where it is not quiet.
fn turning(model: &Model, situation: Situation, host: Host) -> Option<Turning> {
    // In a stop a high road would be beyond every force of it.
    let roads = if situation == Situation::USUAL { &ROADS[..] } else { &ROADS[..1] };
    let found = roads.iter().filter_map(|height| loop_like_the_hosts(model, situation, *height, host));
    found.max_by(|a, b| a.force.total_cmp(&b.force))
}

/// Displacement of a rough road of a height, m.
fn road(height: f64, time: f64) -> f64 {
    height * WAVES.iter().map(|(share, hertz)| share * (std::f64::consts::TAU * hertz * time).sin()).sum::<f64>()
}

/// One road.
fn loop_like_the_hosts(model: &Model, situation: Situation, height: f64, host: Host) -> Option<Turning> {
    let Host { step: h, mass } = host;
    // Of wheel and body the damper moves what is left of the two masses in series.
    let mass = mass * BODY / (1.0 + BODY);
    let tyre = TYRE.min(mass * (FOLLOWS / h).powi(2));
    let rest = situation.input();
    let mut state = model.settled(&rest);
    let at_rest = step(model, &state, &rest, 0.0).1.force;
    let (mut x, mut v) = (0.0, KNOCK);
    let mut force = [at_rest; 3];
    // One bit for each of the last steps in which the force turned.
    let (mut turned, mut last, mut most, mut found) = (0u32, 0.0, 0.0f64, None::<f64>);
    let mut count = 0;
    let turning = |force: f64, steps: usize| Turning { force, steps, height, situation };
    let pace = h.min(FOLLOWS / (std::f64::consts::TAU * WAVES[WAVES.len() - 1].1));
    for k in 1..=LOOP {
        let under = road(height, pace * k as f64);
        v += h / mass * (tyre * (under - x) - (force[2] - at_rest));
        x += h * v;
        if !(v.abs() < BEYOND) {
            return Some(turning(f64::INFINITY, k));
        }
        let to = Input { displacement: Some(situation.place + x), velocity: v, ..rest };
        let (next, output) = step(model, &state, &to, h);
        state = next;
        force = [force[1], force[2], output.force];
        let turn = force[1] - 0.5 * (force[0] + force[2]);
        let turns = turn * last < 0.0 && turn.abs() >= SEEN && last.abs() >= SEEN;
        turned = (turned << 1 | u32::from(turns)) & WINDOW;
        last = turn;
        most = if turned == 0 { 0.0 } else { most.max(if turns { turn.abs() } else { 0.0 }) };
        if turned.count_ones() >= TURNS {
            count += usize::from(turns);
            found = Some(found.unwrap_or_default().max(most));
        }
    }
    found.map(|force| turning(force, count + TURNS as usize - 1))
}

/// The longest of the steps halved from the host's at which the loop is quiet, s.
fn quiet_loop(model: &Model, situation: Situation, host: Host) -> Option<f64> {
    let shorter = (1..=HALVINGS).map(|halved| Host { step: host.step * 0.5f64.powi(halved), ..host });
    shorter.into_iter().find(|shorter| turning(model, situation, *shorter).is_none()).map(|shorter| shorter.step)
}

/// Damping of the path in series, N s/m, with which the loop is quiet, where the path has none: a mass rings on a spring that nothing damps.
fn calming(params: &Params, turning: &Turning, host: Host) -> Option<f64> {
    let [stiffness, mass, damping] =
        [number!("series_stiffness"), number!("internal_mass"), number!("series_damping")].map(|n| params.number(n));
    let without = params.is_on(element!("series_compliance")) && damping == 0.0;
    let rounded = |damping: f64| (0.1 * damping).ceil() * 10.0;
    let shares = DAMPED.iter().map(|share| rounded(share * 2.0 * (stiffness * mass).sqrt()));
    shares.filter(|_| without).find(|damping| {
        let mut calm = *params;
        let done = calm.set(number!("series_damping"), *damping);
        done.is_ok()
            && Model::new(&calm)
                .is_ok_and(|model| loop_like_the_hosts(&model, turning.situation, turning.height, host).is_none())
    })
}

/// Looks at a damper in a host: over its stroke, under side force and in the cold where those change it.
///
/// # Errors
/// Parameters that make no model.
pub fn chatter(params: &Params, host: Host) -> Result<Chatter, Fault> {
    let model = Model::new(params)?;
    let usual = largest(&model, Situation::USUAL, host);
    let situations = Situation::all(params, &model);
    let others = situations.iter().skip(1).map(|situation| largest(&model, *situation, host));
    let Largest { gain, velocity, output, situation } = others
        .chain([on_the_curve(params, &model, host)])
        .fold(usual, |most, other| if other.gain > most.gain { other } else { most });
    let turning = situations
        .iter()
        .filter_map(|situation| turning(&model, *situation, host))
        .max_by(|a, b| a.force.total_cmp(&b.force));
    let without = |element: Element| {
        let mut less = *params;
        less.enable(element, false);
        let model = Model::new(&less).ok()?;
        Some((element, largest(&model, situation, host).gain))
    };
    let element = (gain >= RINGS)
        .then(|| {
            let on = Element::all().filter(|e| params.is_on(*e) && *e != element!("series_compliance"));
            on.filter_map(without).min_by(|a, b| a.1.total_cmp(&b.1))
        })
        .flatten()
        .filter(|(_, left)| *left < (1.0 - ITS_DOING) * gain)
        .or_else(|| {
            let turning = turning.filter(|_| gain < RINGS)?;
            // Without the path in series nothing has a mass of its own, which says little.
            let on = Element::all().filter(|e| params.is_on(*e) && *e != element!("series_compliance"));
            let is_quiet = |element: &Element| {
                let mut less = *params;
                less.enable(*element, false);
                Model::new(&less)
                    .is_ok_and(|model| loop_like_the_hosts(&model, turning.situation, turning.height, host).is_none())
            };
            on.filter(is_quiet).find_map(without)
        });
    // g = (h c + h² k)/m = 1, solved for h.
    let (c, k) = (output.force_by_velocity.max(0.0), output.force_by_displacement.max(0.0));
    let quiet_step =
        if k > 0.0 { 2.0 * host.mass / (c + (c * c + 4.0 * k * host.mass).sqrt()) } else { host.mass / c.max(1e-9) };
    Ok(Chatter {
        gain,
        velocity,
        by_velocity: output.force_by_velocity,
        by_displacement: output.force_by_displacement,
        situation,
        quiet_step: match turning.filter(|_| gain < RINGS) {
            Some(turning) => quiet_loop(&model, turning.situation, host),
            None => Some(quiet_step),
        },
        element,
        calming: turning.and_then(|turning| calming(params, &turning, host)),
        turning,
    })
}

/// A damper that does not chatter in a host, with what that costs.
#[derive(Debug, Clone)]
pub struct Softened {
    /// The damper.
    pub params: Params,
    /// What was done to each friction that chattered.
    pub softer: Vec<Softer>,
    /// By how much its force differs over the motions looked at, root mean square and at most, N.
    pub rms_error: f64,
    /// At most.
    pub largest_error: f64,
    /// Largest gain of it.
    pub gain: f64,
}

/// What was done to a friction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Softer {
    /// Presliding friction takes its place.
    Replaced {
        /// The element.
        element: Element,
        /// Level of the presliding friction, N: of all that it replaces.
        force: f64,
        /// Length over which it turns, m.
        length: f64,
    },
    /// Side-force friction, whose level is the host's, changes its sign less steeply, s/m.
    LessSteep {
        /// Steepness as it was.
        before: f64,
        /// As it is.
        after: f64,
    },
}

impl Softer {
    /// What tells a damper that was made softer from the one that it was.
    fn all(before: &Params, soft: &Params) -> Vec<Softer> {
        let (force, length) = (soft.number(number!("presliding_force")), soft.number(number!("presliding_length")));
        let replaced = FRICTION.iter().filter(|(element, _)| before.is_on(*element) && !soft.is_on(*element));
        let mut all: Vec<Softer> =
            replaced.map(|(element, _)| Softer::Replaced { element: *element, force, length }).collect();
        let [before, after] = [before, soft].map(|params| params.number(number!("side_force_steepness")));
        if after < before {
            all.push(Softer::LessSteep { before, after });
        }
        all
    }

    /// The element that it was done to.
    pub fn element(&self) -> Element {
        match self {
            Softer::Replaced { element, .. } => *element,
            Softer::LessSteep { .. } => element!("side_force_friction"),
        }
    }
}

/// Length over which presliding friction of seals usually turns, m (Deubel & Prokop, J. Automob. Eng. 2023: tenths of a millimetre): none
/// longer is tried, and of the shorter ones, which are nearer to friction that turns at once, the shortest of this gain.
const LENGTH: f64 = 2e-4;
const QUIET: f64 = 0.3;
/// Longest step at which the two are compared, s.
const FINE: f64 = 1e-4;
/// Elements that turn at once: no damper has more.
const MOST: usize = FRICTION.len() + 1;

/// The damper with its steep friction as presliding friction, which acts like a stiff spring where the other jumps, and with side-force friction that
/// turns less steeply; `None` where no steep friction is what chatters, or that would not help.
///
/// # Errors
/// Parameters that make no model.
pub fn softened(params: &Params, host: Host) -> Result<Option<Softened>, Fault> {
    let mut soft = *params;
    for _ in 0..MOST {
        let Some((element, situation)) = friction_that_rings(&soft, host)? else { break };
        match FRICTION.iter().find(|(friction, _)| *friction == element) {
            Some(friction) => presliding_instead(&mut soft, *friction, situation, host)?,
            None if less_steep(&mut soft, situation, host)? => {}
            None => break,
        }
    }
    let softer = Softer::all(params, &soft);
    if softer.is_empty() {
        return Ok(None);
    }
    let found = chatter(&soft, host)?;
    let (before, after) = (Model::new(params)?, Model::new(&soft)?);
    let (mut squares, mut count, mut largest_error) = (0.0, 0.0, 0.0f64);
    let under_side_force = Situation { side_force: SIDE_FORCE, ..Situation::USUAL };
    let has_less_steep = softer.iter().any(|one| matches!(one, Softer::LessSteep { .. }));
    let compared = if has_less_steep { under_side_force } else { Situation::USUAL };
    for sine in motions(compared, host) {
        let omega = sine.omega;
        let dt = FINE.min(0.01 / omega).max(0.25 * std::f64::consts::TAU / (omega * STEPS as f64));
        let input = |k: usize| sine.at(dt * k as f64);
        let (mut a, mut b) = (before.settled(&input(0)), after.settled(&input(0)));
        for k in 1..=(1.5 * std::f64::consts::TAU / (omega * dt)) as usize {
            let ((next_a, from), (next_b, to)) = (step(&before, &a, &input(k), dt), step(&after, &b, &input(k), dt));
            (a, b) = (next_a, next_b);
            // The first half turn builds the friction up from a start at rest.
            if omega * dt * k as f64 > 0.5 * std::f64::consts::TAU {
                squares += (to.force - from.force).powi(2);
                count += 1.0;
                largest_error = largest_error.max((to.force - from.force).abs());
            }
        }
    }
    let rms_error = (squares / f64::max(count, 1.0)).sqrt();
    Ok(Some(Softened { params: soft, softer, rms_error, largest_error, gain: found.gain }))
}

/// A steep friction that rings in a situation, whatever rings beside it in others (a stop, the FV curve), and that situation.
fn friction_that_rings(params: &Params, host: Host) -> Result<Option<(Element, Situation)>, Fault> {
    let model = Model::new(params)?;
    for situation in Situation::all(params, &model) {
        let gain = largest(&model, situation, host).gain;
        let frictions = FRICTION.iter().map(|(friction, _)| *friction).chain([element!("side_force_friction")]);
        let on = frictions.filter(|friction| gain >= RINGS && params.is_on(*friction));
        let mut most = None::<(Element, f64)>;
        for friction in on {
            let mut less = *params;
            less.enable(friction, false);
            let left = largest(&Model::new(&less)?, situation, host).gain;
            if left < (1.0 - ITS_DOING) * gain && most.is_none_or(|(_, least)| left < least) {
                most = Some((friction, left));
            }
        }
        if let Some((friction, _)) = most {
            return Ok(Some((friction, situation)));
        }
    }
    Ok(None)
}

/// Puts presliding friction in the place of an element, beside what the damper has of it.
fn presliding_instead(
    soft: &mut Params,
    (element, level): (Element, Number),
    situation: Situation,
    host: Host,
) -> Result<(), Fault> {
    let gain = |params: &Params| Ok(largest(&Model::new(params)?, situation, host).gain);
    let presliding = element!("presliding_friction");
    let has = soft.is_on(presliding);
    let before = if has { soft.number(number!("presliding_force")) } else { 0.0 };
    let force = before + soft.number(level);
    soft.enable(element, false);
    soft.enable(presliding, true);
    soft.set(number!("presliding_force"), force)?;
    // What the damper has of it keeps its length where that is quiet.
    if has && gain(soft)? <= QUIET {
        return Ok(());
    }
    let turns = number!("presliding_length");
    soft.set(turns, LENGTH)?;
    let mut now = gain(soft)?;
    while 0.5 * soft.number(turns) >= turns.bounds().0 {
        let mut shorter = *soft;
        shorter.set(turns, 0.5 * soft.number(turns))?;
        let there = gain(&shorter)?;
        if there > QUIET.max(now) {
            break;
        }
        (*soft, now) = (shorter, there);
    }
    Ok(())
}

/// Halves the steepness of side-force friction until it is quiet in a situation; whether that was possible.
fn less_steep(soft: &mut Params, situation: Situation, host: Host) -> Result<bool, Fault> {
    let steepness = number!("side_force_steepness");
    let mut without = *soft;
    without.enable(element!("side_force_friction"), false);
    let rest = largest(&Model::new(&without)?, situation, host).gain;
    while largest(&Model::new(soft)?, situation, host).gain >= RINGS.max(rest / (1.0 - ITS_DOING)) {
        let half = 0.5 * soft.number(steepness);
        if half < steepness.bounds().0 {
            return Ok(false);
        }
        soft.set(steepness, half)?;
    }
    Ok(true)
}

impl Chatter {
    /// Whether a disturbance changes sign at every step, by the slopes or in the loop.
    pub fn rings(&self) -> bool {
        self.gain >= RINGS || self.turning.is_some()
    }

    /// Whether it does so without dying out.
    pub fn swings(&self) -> bool {
        self.gain >= GROWS || self.turning.is_some()
    }

    /// What must be known of it beside an export: nothing where it does not chatter.
    pub fn remark(&self, host: Host) -> Option<String> {
        self.rings().then(|| self.told(host, false))
    }

    /// What to know of it, in sentences; `softened` where `--for-step` was asked for already.
    pub fn told(&self, host: Host, softened: bool) -> String {
        let Host { step, mass } = host;
        let head = format!(
            "At a host step of {} ms and {mass} kg the damper's gain c·h/m is {:.2} at most (c {:.0} N s/m, k {:.0} N/m, at {:.1} mm/s{})",
            1e3 * step,
            self.gain,
            self.by_velocity,
            self.by_displacement,
            1e3 * self.velocity,
            self.situation.told()
        );
        let below = if self.gain < 0.0 {
            "; a gain below 0 says nothing by itself, for it comes from a mass in the damper, which acts on in the next step"
        } else {
            ""
        };
        if !self.rings() {
            return format!(
                "{head}{below}: it does not chatter in a host that holds its force over a step, nor in such a loop that was run here ({mass} kg on a \
                 tyre). Looked at were motions up to 50 mm and 1 m/s about the middle, and, where they change this damper, places up to {:.0} mm from it, \
                 {SIDE_FORCE} N of side force, stops up to {:.0} kN and {COLD} °C.",
                1e3 * PLACES[7],
                1e-3 * STOP_FORCE
            );
        }
        let is_friction = self.element.is_some_and(|(element, _)| {
            element == element!("side_force_friction") || FRICTION.iter().any(|f| f.0 == element)
        });
        let softer =
            if is_friction && !softened { format!(", or export with --for-step {step}") } else { String::new() };
        let steps = match self.quiet_step {
            Some(quiet) => format!("Take steps of {} ms or less", plain(1e3 * quiet)),
            None => format!("No step down to {} ms was quiet", plain(1e3 * step * 0.5f64.powi(HALVINGS))),
        };
        let in_the_loop = self.turning.map(|turning| turning.told(host));
        if self.gain < RINGS {
            let by = match self.element {
                Some((element, _)) => format!("; {element} makes it, without it the loop is quiet"),
                None => "; no element makes it alone".to_owned(),
            };
            let calming = match self.calming {
                Some(damping) => format!(
                    ", or give series_damping, which is 0, a value: with {damping:.0} N s/m the loop is quiet. The mass inside rings on its spring, which nothing damps"
                ),
                None => String::new(),
            };
            return format!("{head}{below}. But {}{by}. {steps}{calming}{softer}.", in_the_loop.unwrap_or_default());
        }
        let by = match self.element {
            Some((element, left)) => format!("; {element} makes it, without it the gain is {left:.2}"),
            None => "; no element makes it alone".to_owned(),
        };
        let how = if self.gain < GROWS {
            "a disturbance changes sign at every step and dies out"
        } else {
            "the force swings from step to step"
        };
        let seen = in_the_loop.map_or_else(String::new, |seen| format!("; {seen}"));
        format!(
            "{head}{by}: in a host that holds the force over a step (explicit) {how}{seen}. {steps}, let the host solve with the slopes that \
             dashpot_step gives (implicit){softer}."
        )
    }
}

/// A number with two digits behind the first that is not 0.
fn plain(number: f64) -> String {
    let digits = (2.0 - number.abs().max(1e-9).log10().floor()).clamp(0.0, 9.0) as usize;
    // Never more than it is: it is a limit.
    let scale = 10f64.powi(digits as i32);
    format!("{}", (number * scale * (1.0 + 1e-12)).floor() / scale)
}

impl Softened {
    /// What was done and what it costs, in a sentence.
    pub fn told(&self) -> String {
        let done = self.softer.iter().map(|one| match one {
            Softer::Replaced { element, force, length } => format!(
                "{element} was replaced by presliding friction of {force:.1} N that turns over {:.4} mm",
                1e3 * length
            ),
            Softer::LessSteep { before, after } => {
                format!("side_force_steepness was lowered from {before:.0} to {after:.0} s/m")
            }
        });
        let done: Vec<String> = done.collect();
        format!(
            "{}: the gain is {:.2} now{}; the force differs by {:.2} N rms and {:.1} N at most over motions of 0.2 to 50 mm at 2 mm/s to 1 m/s{}, at reversals.",
            done.join("; "),
            self.gain,
            if self.gain < RINGS { "" } else { ", which comes from what was not replaced" },
            self.rms_error,
            self.largest_error,
            if self.softer.iter().any(|one| matches!(one, Softer::LessSteep { .. })) {
                format!(" under {SIDE_FORCE} N of side force")
            } else {
                String::new()
            }
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn steep() -> Params {
        let mut params = Params::new();
        // Without gas the mass comes to rest on its spring.
        for off in [element!("stribeck_friction"), element!("series_compliance"), element!("gas_preload")] {
            params.enable(off, false);
        }
        params.enable(element!("coulomb_friction"), true);
        params.set(number!("coulomb_force"), 40.0).unwrap();
        params.set(number!("coulomb_steepness"), 5000.0).unwrap();
        params
    }

    const HOST: Host = Host { step: 1e-3, mass: 40.0 };

    /// A mass on the damper and a spring, moved as such a host moves it; the largest change of velocity within the last steps.
    fn swings(params: &Params, host: Host) -> f64 {
        swings_under(params, host, 0.0)
    }

    fn swings_under(params: &Params, host: Host, side_force: f64) -> f64 {
        let model = Model::new(params).unwrap();
        let mut state = model.settled(&Input::motion(0.0, 0.0));
        let (mut x, mut v, mut force) = (0.0, 1e-3, 0.0);
        let mut last = 0.0f64;
        for k in 0..6000 {
            v -= host.step / host.mass * (force + 200.0 * x);
            x += host.step * v;
            let to = Input { side_force, ..Input::motion(x, v) };
            let (next, output) = step(&model, &state, &to, host.step);
            let change = (output.force - force).abs();
            (state, force) = (next, output.force);
            if k > 5900 {
                last = last.max(change);
            }
        }
        last
    }

    #[test]
    fn what_is_said_is_what_a_held_force_does() {
        let steep = steep();
        let found = chatter(&steep, HOST).unwrap();
        assert!(
            found.gain > GROWS && found.element.is_some_and(|(element, _)| element == element!("coulomb_friction")),
            "{found:?}"
        );
        assert!(swings(&steep, HOST) > 1.0, "{}", swings(&steep, HOST));
        let soft = softened(&steep, HOST).unwrap().unwrap();
        assert!(soft.gain < RINGS && soft.softer[0].element() == element!("coulomb_friction"));
        assert!(swings(&soft.params, HOST) < 0.05, "{}", swings(&soft.params, HOST));
        // At the step that is called quiet the steep one is quiet too.
        let quiet = Host { step: 0.9 * found.quiet_step.unwrap(), ..HOST };
        assert!(chatter(&steep, quiet).unwrap().gain < RINGS);
        assert!(swings(&steep, quiet) < 0.5, "{}", swings(&steep, quiet));
    }

    #[test]
    fn what_chatters_under_side_force_in_a_stop_or_off_the_middle_alone_is_found() {
        let of = |on: Element, numbers: &[(Number, f64)]| {
            let mut params = Params::new();
            params.enable(element!("stribeck_friction"), false);
            params.enable(on, true);
            numbers.iter().for_each(|(number, value)| params.set(*number, *value).unwrap());
            chatter(&params, HOST).unwrap()
        };
        let plain = of(element!("gas_preload"), &[]);
        assert!(!plain.rings() && plain.told(HOST, false).contains("side force"), "{}", plain.told(HOST, false));
        let pushed = of(element!("side_force_friction"), &[]);
        assert!(pushed.rings() && pushed.situation.side_force == SIDE_FORCE, "{pushed:?}");
        assert!(pushed.told(HOST, false).contains("under 2000 N of side force"), "{}", pushed.told(HOST, false));
        let stopped = of(element!("bump_stop"), &[(number!("bump_stop_damping"), 1e5)]);
        assert!(stopped.rings() && stopped.situation.place < -0.05, "{stopped:?}");
        assert!(stopped.element.is_some_and(|(element, _)| element == element!("bump_stop")), "{stopped:?}");
        let cold = of(element!("temperature_fade"), &[]);
        assert_eq!(cold.situation.temperature, COLD, "{cold:?}");
    }

    #[test]
    fn friction_under_side_force_is_made_quiet_and_its_error_is_told() {
        let mut params = Params::new();
        params.enable(element!("stribeck_friction"), false);
        params.enable(element!("side_force_friction"), true);
        let soft = softened(&params, HOST).unwrap().unwrap();
        let [Softer::LessSteep { before, after }] = soft.softer[..] else { panic!("{soft:?}") };
        assert!(after < before && soft.gain < RINGS && soft.largest_error > 1.0, "{soft:?}");
        let pushed = |params: &Params| swings_under(params, HOST, SIDE_FORCE);
        assert!(pushed(&params) > 10.0 && pushed(&soft.params) < 0.5, "{} {}", pushed(&params), pushed(&soft.params));
    }

    #[test]
    fn two_frictions_are_both_replaced() {
        let mut params = steep();
        params.enable(element!("stribeck_friction"), true);
        params.set(number!("stribeck_coulomb_force"), 30.0).unwrap();
        let soft = softened(&params, HOST).unwrap().unwrap();
        assert_eq!(soft.softer.len(), 2, "{soft:?}");
        assert_eq!(soft.params.number(number!("presliding_force")), 70.0);
        assert!(swings(&soft.params, HOST) < 0.05, "{}", swings(&soft.params, HOST));
    }

    #[test]
    fn a_damper_without_steep_friction_is_left_as_it_is() {
        let mut smooth = steep();
        smooth.enable(element!("coulomb_friction"), false);
        assert!(chatter(&smooth, HOST).unwrap().gain < RINGS);
        assert!(softened(&smooth, HOST).unwrap().is_none());
    }

    #[test]
    fn the_error_of_the_replacement_is_that_of_reversals() {
        let soft = softened(&steep(), HOST).unwrap().unwrap();
        let [Softer::Replaced { force, .. }] = soft.softer[..] else { panic!("{soft:?}") };
        assert!(soft.largest_error <= 2.2 * force && soft.rms_error < 0.6 * force, "{soft:?}");
        assert!(soft.told().contains("presliding"));
    }

    fn with(elements: &[Element], numbers: &[(Number, f64)]) -> Params {
        let mut params = Params::new();
        params.disable_all();
        elements.iter().for_each(|element| params.enable(*element, true));
        numbers.iter().for_each(|(number, value)| params.set(*number, *value).unwrap());
        params
    }

    /// The path in series of a damper whose inner mass nothing damps.
    const UNDAMPED: [(Number, f64); 3] =
        [(number!("series_stiffness"), 3e6), (number!("series_damping"), 0.0), (number!("internal_mass"), 0.1)];

    #[test]
    fn a_moving_mass_above_the_wheels_is_no_quiet_damper() {
        let elements = [element!("fv_curve"), element!("series_compliance"), element!("moving_mass")];
        for (mass, rings) in [(2.0, false), (10.0, false), (45.0, true), (60.0, true)] {
            let params = with(&elements, &[UNDAMPED.as_slice(), &[(number!("moving_mass"), mass)]].concat());
            let found = chatter(&params, HOST).unwrap();
            assert_eq!(found.rings(), rings, "{mass} {found:?}");
            let told = found.told(HOST, false);
            assert!(!rings || told.contains("moving_mass makes it") && !told.contains("does not chatter"), "{told}");
            assert!(found.gain > 0.0 || told.contains("says nothing by itself"), "{told}");
        }
    }

    #[test]
    fn an_open_void_and_an_inner_mass_that_rings_are_found() {
        let elements =
            [element!("fv_curve"), element!("series_compliance"), element!("gas_preload"), element!("cavitation")];
        let capped = |force: f64, more: &[(Number, f64)]| {
            let cap = [(number!("cavitation_force"), force)];
            chatter(&with(&elements, &[UNDAMPED.as_slice(), &cap, more].concat()), HOST).unwrap()
        };
        let stays_open = capped(800.0, &[(number!("cavitation_return"), 0.0)]);
        assert!(stays_open.gain > RINGS, "{stays_open:?}");
        let rings = capped(500.0, &[]);
        assert!(rings.gain < RINGS && rings.turning.is_some() && rings.calming.is_some(), "{rings:?}");
        assert!(rings.element.is_some_and(|(e, _)| e == element!("cavitation")), "{rings:?}");
        assert!(!capped(3000.0, &[]).rings());
    }

    #[test]
    fn a_narrow_steep_piece_of_the_curve_is_found() {
        let mut params = with(&[element!("fv_curve")], &[(number!("fv_interpolation"), 1.0)]);
        params.set_list(list!("fv_velocity"), &[-1.5, 0.0, 5e-4, 3e-3, 1.5]).unwrap();
        params.set_list(list!("fv_force"), &[-1500.0, 0.0, 1.0, 401.0, 2500.0]).unwrap();
        let found = chatter(&params, HOST).unwrap();
        assert!((found.gain - 4.0).abs() < 0.01 && found.swings(), "{found:?}");
    }

    #[test]
    fn friction_is_replaced_whatever_else_rings() {
        let base = [element!("fv_curve"), element!("series_compliance"), element!("coulomb_friction")];
        for beside in [element!("rebound_stop"), element!("presliding_friction")] {
            let params = with(&[base.as_slice(), &[beside]].concat(), &[]);
            let soft = softened(&params, HOST).unwrap().unwrap();
            assert_eq!(soft.softer[0].element(), element!("coulomb_friction"), "{soft:?}");
            assert!(!soft.params.is_on(element!("coulomb_friction")) && soft.params.is_on(beside));
            let left = chatter(&soft.params, HOST).unwrap();
            let told = left.told(HOST, true);
            assert!(
                !told.contains("--for-step") && !left.element.is_some_and(|e| e.0 == element!("coulomb_friction")),
                "{told}"
            );
            assert_eq!(left.rings(), beside == element!("rebound_stop"), "{told}");
        }
    }
}
