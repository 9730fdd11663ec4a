//! Simulation of a typical host loop: the host's mass on a tire, moved by a road. The loop shows how a mass or a void in the damper affects
//! the next steps. Derivatives at one instant do not show this.

use super::host::Host;
use super::situation::Situation;
use dashpot_core::step::step;
use dashpot_core::{Input, Model, Params};
use dashpot_core::{element, number};

/// Stiffness of a car's tire, which carries the host's mass in the loop, N/m.
///
/// If the step cannot resolve the oscillation of the mass on this tire, the loop uses a softer tire ([`FOLLOWS`]).
const TYRE: f64 = 2e5;
/// Largest phase, rad, by which the oscillation of the mass on the tire advances in a step.
const FOLLOWS: f64 = 0.3;
/// Velocity, m/s, above which the loop counts as diverged. No damper moves as fast.
const BEYOND: f64 = 100.0;
/// Initial velocity of the mass in the loop, m/s. An acceleration of 10 m/s² reaches this velocity in a millisecond.
const KNOCK: f64 = 0.01;
/// Smallest alternating part of the force (deviation from the mean of both neighboring steps), N, that counts as a reversal. A smaller one
/// is not visible in a vehicle's signals.
const SEEN: f64 = 5.0;
/// Smallest number of reversals of the force in the last 24 steps that counts as chatter.
///
/// A single impact (a gap, a stop, dry friction at a reversal) causes three or four reversals. If the period of an oscillating mass is no
/// multiple of the step, the force reverses in most steps, but not in all.
const TURNS: u32 = 9;
/// Bit mask of the last 24 steps.
const WINDOW: u32 = (1 << 24) - 1;
/// Largest number of steps of the loop over one road.
const LOOP: usize = 3000;
/// Heights of the roads, m. Situations other than the reference use the first height only.
const ROADS: [f64; 3] = [0.005, 0.02, 0.05];
/// Sines that form a road: fraction of the road's height, and frequency, Hz. The frequencies are near those of the body, between body and
/// axle, and near those of the axle.
const WAVES: [(f64, f64); 4] = [(0.5, 1.3), (0.25, 3.1), (0.12, 9.7), (0.06, 14.0)];
/// Ratio of the mass of the body to that of the wheel.
const BODY: f64 = 10.0;
/// Largest number of times that the host's step is halved in the search for a step without chatter.
pub(super) const HALVINGS: i32 = 6;
/// Tried values of the series damping, as fractions of the critical damping of the internal mass.
const DAMPED: [f64; 4] = [0.05, 0.1, 0.2, 0.4];

/// Result of a host loop that chatters: its force reverses in many steps, or its motion diverges.
///
/// In the loop, a road moves the host's mass on a tire.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Turning {
    /// Largest alternating part of the force (deviation from the mean of both neighboring steps), N, or infinity if the motion diverges.
    pub force: f64,
    /// Number of steps in which the force reverses. If the motion diverges, number of steps before the divergence.
    pub steps: usize,
    /// Height of the road, m.
    pub height: f64,
    /// Situation in which the loop chatters.
    pub situation: Situation,
}

impl Turning {
    /// Describes the chatter of the loop in a clause of a message.
    pub(super) fn describe(&self, host: Host) -> String {
        let Turning { force, steps, height, situation } = *self;
        let does = if self.grows() {
            "the motion grows beyond all bounds".to_owned()
        } else {
            format!("the force turns from step to step, by up to {force:.0} N, in {steps} steps")
        };
        format!(
            "in such a loop that was run here ({} kg on a tyre, its displacement advanced with the new velocity, a rough road of {:.0} mm{}) {does}",
            host.mass,
            1e3 * height,
            situation.describe()
        )
    }

    /// Returns whether the motion diverges.
    pub fn grows(&self) -> bool {
        self.force == f64::INFINITY
    }
}

/// Simulates the loop on the roads of a situation. Returns the result with the largest alternating force, or `None` if the loop chatters on
/// no road.
pub(super) fn turning(model: &Model, situation: Situation, host: Host) -> Option<Turning> {
    // A high road in a stop, for example, would cause unrealistic forces. So situations other than the reference have the lowest road.
    let roads = if situation == Situation::REFERENCE { &ROADS[..] } else { &ROADS[..1] };
    let found = roads.iter().filter_map(|height| loop_like_the_hosts(model, situation, *height, host));
    found.max_by(|a, b| a.force.total_cmp(&b.force))
}

/// Returns the displacement, m, at a time, s, of a rough road with a given height, m.
fn road(height: f64, time: f64) -> f64 {
    height * WAVES.iter().map(|(share, hertz)| share * libm::sin(std::f64::consts::TAU * hertz * time)).sum::<f64>()
}

/// Simulates the loop on one road with the given height, m. Returns `None` if it does not chatter.
pub(super) fn loop_like_the_hosts(model: &Model, situation: Situation, height: f64, host: Host) -> Option<Turning> {
    let Host { step: h, mass } = host;
    // The damper acts between wheel and body, so it moves their reduced mass.
    let mass = mass * BODY / (1.0 + BODY);
    let tyre = TYRE.min(mass * (FOLLOWS / h).powi(2));
    let rest = situation.input();
    let mut state = model.steady_state(&rest);
    let at_rest = step(model, &state, &rest, 0.0).1.force;
    let (mut x, mut v) = (0.0, KNOCK);
    let mut force = [at_rest; 3];
    // Each bit of `turned` represents one of the last steps. It is set if the force reversed in that step.
    let (mut turned, mut last, mut most, mut found) = (0u32, 0.0, 0.0f64, None::<f64>);
    let mut count = 0;
    let turning = |force: f64, steps: usize| Turning { force, steps, height, situation };
    let pace = h.min(FOLLOWS / (std::f64::consts::TAU * WAVES[WAVES.len() - 1].1));
    for k in 1..=LOOP {
        let under = road(height, pace * k as f64);
        // Use semi-implicit Euler, like MuJoCo and game engines.
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

/// Halves the host's step until the loop does not chatter. Returns this step, s, or `None` if the loop chatters at the shortest tried step.
pub(super) fn quiet_loop(model: &Model, situation: Situation, host: Host) -> Option<f64> {
    let shorter = (1..=HALVINGS).map(|halved| Host { step: host.step * 0.5f64.powi(halved), ..host });
    shorter.into_iter().find(|shorter| turning(model, situation, *shorter).is_none()).map(|shorter| shorter.step)
}

/// Returns a series damping, N s/m, with which the loop does not chatter. Returns `None` if the series path is damped or absent, or if no
/// tried damping suffices.
///
/// The search is needed because the internal mass oscillates on an undamped series spring.
pub(super) fn calming(params: &Params, turning: &Turning, host: Host) -> Option<f64> {
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
