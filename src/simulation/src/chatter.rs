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
use dashpot_core::{element, number};

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
    /// The longest step at which nothing changes sign, s.
    pub quiet_step: f64,
    /// The element that makes most of it, and the gain without it; `None` where no element alone does.
    pub element: Option<(Element, f64)>,
}

/// Amplitudes of the motions looked at, m, and their peak velocities, m/s; from standstill to a pothole. Away from the usual situation only those
/// of a middle size: the others differ little there and take most of the time.
const AMPLITUDES: [f64; 4] = [2e-4, 1e-3, 5e-3, 0.02];
const SPEEDS: [f64; 4] = [2e-3, 0.02, 0.2, 1.0];
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
    all.filter(move |(amplitude, speed)| is_usual || (1e-3..=5e-3).contains(amplitude) && *speed >= 0.02)
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
            let (next, output) = step(model, &state, &input(k), host.step);
            state = next;
            let here = gain(&output);
            if here > most.gain {
                most = Largest { gain: here, velocity: input(k).velocity, output, situation };
            }
        }
    }
    most
}

/// Looks at a damper in a host: over its stroke, under side force and in the cold where those change it.
///
/// # Errors
/// Parameters that make no model.
pub fn chatter(params: &Params, host: Host) -> Result<Chatter, Fault> {
    let model = Model::new(params)?;
    let usual = largest(&model, Situation::USUAL, host);
    let others = Situation::all(params, &model).into_iter().skip(1).map(|situation| largest(&model, situation, host));
    let Largest { gain, velocity, output, situation } =
        others.fold(usual, |most, other| if other.gain > most.gain { other } else { most });
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
        .filter(|(_, left)| *left < (1.0 - ITS_DOING) * gain);
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
        quiet_step,
        element,
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
    let mut found = chatter(&soft, host)?;
    for _ in 0..MOST {
        let Some((element, _)) = found.element.filter(|_| found.rings()) else { break };
        let done = match FRICTION.iter().find(|(friction, _)| *friction == element) {
            _ if element == element!("side_force_friction") => less_steep(&mut soft, host)?,
            // Where the damper has presliding friction of its own there is no room for another.
            Some(friction) if !params.is_on(element!("presliding_friction")) => {
                presliding_instead(&mut soft, *friction, host)?;
                true
            }
            _ => false,
        };
        if !done {
            break;
        }
        found = chatter(&soft, host)?;
    }
    let softer = Softer::all(params, &soft);
    if softer.is_empty() || found.rings() {
        return Ok(None);
    }
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

/// Puts presliding friction in the place of an element, beside what it has replaced before.
fn presliding_instead(soft: &mut Params, (element, level): (Element, Number), host: Host) -> Result<(), Fault> {
    let presliding = element!("presliding_friction");
    let before = if soft.is_on(presliding) { soft.number(number!("presliding_force")) } else { 0.0 };
    let force = before + soft.number(level);
    soft.enable(element, false);
    soft.enable(presliding, true);
    soft.set(number!("presliding_force"), force)?;
    let turns = number!("presliding_length");
    soft.set(turns, LENGTH)?;
    let mut gain = chatter(soft, host)?.gain;
    while 0.5 * soft.number(turns) >= turns.bounds().0 {
        let mut shorter = *soft;
        shorter.set(turns, 0.5 * soft.number(turns))?;
        let there = chatter(&shorter, host)?.gain;
        if there > QUIET.max(gain) {
            break;
        }
        (*soft, gain) = (shorter, there);
    }
    Ok(())
}

/// Halves the steepness of side-force friction until it is quiet under the side force looked at; whether that was possible.
fn less_steep(soft: &mut Params, host: Host) -> Result<bool, Fault> {
    let steepness = number!("side_force_steepness");
    while chatter(soft, host)?.element.is_some_and(|(element, _)| element == element!("side_force_friction")) {
        let half = 0.5 * soft.number(steepness);
        if half < steepness.bounds().0 {
            return Ok(false);
        }
        soft.set(steepness, half)?;
    }
    Ok(true)
}

impl Chatter {
    /// Whether a disturbance changes sign at every step.
    pub fn rings(&self) -> bool {
        self.gain >= RINGS
    }

    /// What must be known of it beside an export: nothing where it does not chatter.
    pub fn remark(&self, host: Host) -> Option<String> {
        self.rings().then(|| self.told(host))
    }

    /// What to know of it, in sentences.
    pub fn told(&self, host: Host) -> String {
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
        if !self.rings() {
            return format!(
                "{head}: it does not chatter in a host that holds its force over a step. Looked at were motions up to 20 mm and 1 m/s about the middle, and, where \
                 they change this damper, places up to {:.0} mm from it, {SIDE_FORCE} N of side force, stops up to {:.0} kN and {COLD} °C.",
                1e3 * PLACES[7],
                1e-3 * STOP_FORCE
            );
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
        let is_friction = self.element.is_some_and(|(element, _)| {
            element == element!("side_force_friction") || FRICTION.iter().any(|f| f.0 == element)
        });
        let softer = if is_friction { format!(", or export with --for-step {step}") } else { String::new() };
        format!(
            "{head}{by}: in a host that holds the force over a step (explicit) {how}. Take steps of {:.2} ms or less, let the host solve with \
             the slopes that dashpot_step gives (implicit){softer}.",
            1e3 * self.quiet_step
        )
    }
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
            "{}: the gain is {:.2} now; the force differs by {:.2} N rms and {:.1} N at most over motions of 0.2 to 20 mm at 2 mm/s to 1 m/s{}, at reversals.",
            done.join("; "),
            self.gain,
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
        let quiet = Host { step: 0.9 * found.quiet_step, ..HOST };
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
        assert!(!plain.rings() && plain.told(HOST).contains("side force"), "{}", plain.told(HOST));
        let pushed = of(element!("side_force_friction"), &[]);
        assert!(pushed.rings() && pushed.situation.side_force == SIDE_FORCE, "{pushed:?}");
        assert!(pushed.told(HOST).contains("under 2000 N of side force"), "{}", pushed.told(HOST));
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
}
