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
    /// The longest step at which nothing changes sign, s.
    pub quiet_step: f64,
    /// The element that makes most of it, and the gain without it; `None` where no element alone does.
    pub element: Option<(Element, f64)>,
}

/// Amplitudes of the motions looked at, m, and their peak velocities, m/s; from standstill to a pothole.
const AMPLITUDES: [f64; 4] = [2e-4, 1e-3, 5e-3, 0.02];
const SPEEDS: [f64; 4] = [2e-3, 0.02, 0.2, 1.0];
/// Most steps of one motion.
const STEPS: usize = 4000;
/// Share of the gain that must go with an element to be its doing.
const ITS_DOING: f64 = 0.3;
/// Elements that [`softened`] can replace, with their level.
const FRICTION: [(Element, Number); 2] = [
    (element!("coulomb_friction"), number!("coulomb_force")),
    (element!("stribeck_friction"), number!("stribeck_coulomb_force")),
];

/// A motion looked at: a sine from its middle.
#[derive(Clone, Copy)]
struct Sine {
    amplitude: f64,
    speed: f64,
    /// rad/s.
    omega: f64,
}

impl Sine {
    fn at(&self, time: f64) -> Input {
        let phase = self.omega * time;
        Input::motion(self.amplitude * phase.sin(), self.speed * phase.cos())
    }
}

/// The motions that a host can follow.
fn motions(host: Host) -> impl Iterator<Item = Sine> {
    let all = AMPLITUDES.iter().flat_map(|amplitude| SPEEDS.map(|speed| (*amplitude, speed)));
    all.map(|(amplitude, speed)| Sine { amplitude, speed, omega: speed / amplitude })
        .filter(move |sine| sine.omega * host.step <= 0.5)
}

/// The largest gain over all motions, with the answer that has it and its velocity.
fn largest(model: &Model, host: Host) -> (f64, f64, Output) {
    let gain = |o: &Output| host.step / host.mass * (o.force_by_velocity + host.step * o.force_by_displacement);
    let rest = Input::motion(0.0, 0.0);
    let at_rest = step(model, &model.settled(&rest), &rest, host.step).1;
    let mut most = (gain(&at_rest), 0.0, at_rest);
    for sine in motions(host) {
        let input = |k: usize| sine.at(host.step * k as f64);
        let mut state = model.settled(&rest);
        let steps = (1.25 * std::f64::consts::TAU / (sine.omega * host.step)) as usize;
        for k in 1..=steps.min(STEPS) {
            let (next, output) = step(model, &state, &input(k), host.step);
            state = next;
            let here = gain(&output);
            if here > most.0 {
                most = (here, input(k).velocity, output);
            }
        }
    }
    most
}

/// Looks at a damper in a host.
///
/// # Errors
/// Parameters that make no model.
pub fn chatter(params: &Params, host: Host) -> Result<Chatter, Fault> {
    let (gain, velocity, output) = largest(&Model::new(params)?, host);
    let without = |element: Element| {
        let mut less = *params;
        less.enable(element, false);
        let model = Model::new(&less).ok()?;
        Some((element, largest(&model, host).0))
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
        quiet_step,
        element,
    })
}

/// A damper that does not chatter in a host, with what that costs.
#[derive(Debug, Clone)]
pub struct Softened {
    /// The damper.
    pub params: Params,
    /// The element that was replaced.
    pub replaced: Element,
    /// Force of the presliding friction in its place, N, and the length over which it turns, m.
    pub force: f64,
    /// See `force`.
    pub length: f64,
    /// By how much its force differs over the motions looked at, root mean square and at most, N.
    pub rms_error: f64,
    /// At most.
    pub largest_error: f64,
    /// Largest gain of it.
    pub gain: f64,
}

/// Length over which presliding friction of seals usually turns, m (Deubel & Prokop, J. Automob. Eng. 2023: tenths of a millimetre): none
/// longer is tried, and of the shorter ones, which are nearer to friction that turns at once, the shortest of this gain.
const LENGTH: f64 = 2e-4;
const QUIET: f64 = 0.3;
/// Longest step at which the two are compared, s.
const FINE: f64 = 1e-4;

/// The damper with its steep friction as presliding friction, which acts like a stiff spring where the other jumps; `None` where no
/// steep friction is what chatters, or that would not help.
///
/// # Errors
/// Parameters that make no model.
pub fn softened(params: &Params, host: Host) -> Result<Option<Softened>, Fault> {
    let found = chatter(params, host)?;
    let Some((replaced, _)) = found.element.filter(|_| found.rings()) else { return Ok(None) };
    let Some((_, level)) = FRICTION.iter().find(|(element, _)| *element == replaced) else { return Ok(None) };
    let level = params.number(*level);
    if params.is_on(element!("presliding_friction")) {
        return Ok(None);
    }
    let mut soft = *params;
    soft.enable(replaced, false);
    soft.enable(element!("presliding_friction"), true);
    soft.set(number!("presliding_force"), level)?;
    soft.set(number!("presliding_length"), LENGTH)?;
    let mut gain = chatter(&soft, host)?.gain;
    if gain >= RINGS {
        return Ok(None);
    }
    let mut length = LENGTH;
    let (shortest, _) = number!("presliding_length").bounds();
    while 0.5 * length >= shortest {
        let mut shorter = soft;
        shorter.set(number!("presliding_length"), 0.5 * length)?;
        let there = chatter(&shorter, host)?.gain;
        if there > QUIET.max(gain) {
            break;
        }
        (soft, gain, length) = (shorter, there, 0.5 * length);
    }
    let (before, after) = (Model::new(params)?, Model::new(&soft)?);
    let (mut squares, mut count, mut largest_error) = (0.0, 0.0, 0.0f64);
    for sine in motions(host) {
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
    Ok(Some(Softened { params: soft, replaced, force: level, length, rms_error, largest_error, gain }))
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
            "At a host step of {} ms and {mass} kg the damper's gain c·h/m is {:.2} at most (c {:.0} N s/m, k {:.0} N/m, at {:.1} mm/s)",
            1e3 * step,
            self.gain,
            self.by_velocity,
            self.by_displacement,
            1e3 * self.velocity
        );
        if !self.rings() {
            return format!("{head}: it does not chatter in a host that holds its force over a step.");
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
        let is_friction = self.element.is_some_and(|(element, _)| FRICTION.iter().any(|f| f.0 == element));
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
        format!(
            "{} was replaced by presliding friction of {:.1} N that turns over {:.4} mm: the gain is {:.2} now; the force differs by {:.2} N rms and \
             {:.1} N at most over motions of 0.2 to 20 mm at 2 mm/s to 1 m/s, at reversals.",
            self.replaced,
            self.force,
            1e3 * self.length,
            self.gain,
            self.rms_error,
            self.largest_error
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
        let model = Model::new(params).unwrap();
        let mut state = model.settled(&Input::motion(0.0, 0.0));
        let (mut x, mut v, mut force) = (0.0, 1e-3, 0.0);
        let mut last = 0.0f64;
        for k in 0..6000 {
            v -= host.step / host.mass * (force + 200.0 * x);
            x += host.step * v;
            let (next, output) = step(&model, &state, &Input::motion(x, v), host.step);
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
        assert!(soft.gain < RINGS && soft.replaced == element!("coulomb_friction"));
        assert!(swings(&soft.params, HOST) < 0.05, "{}", swings(&soft.params, HOST));
        // At the step that is called quiet the steep one is quiet too.
        let quiet = Host { step: 0.9 * found.quiet_step, ..HOST };
        assert!(chatter(&steep, quiet).unwrap().gain < RINGS);
        assert!(swings(&steep, quiet) < 0.5, "{}", swings(&steep, quiet));
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
        assert!(soft.largest_error <= 2.2 * soft.force && soft.rms_error < 0.6 * soft.force, "{soft:?}");
        assert!(soft.told().contains("presliding"));
    }
}
