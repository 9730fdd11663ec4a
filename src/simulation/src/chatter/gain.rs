//! Largest gain of a disturbance in one step of a host: (h/m)(∂F/∂v + h ∂F/∂x), with the host's step h, s, and mass m, kg. F is the damper
//! force, N, v the velocity, m/s, and x the displacement, m. The gain is searched over typical sines, at the reversals of these sines, and
//! on every segment of the FV curve.

use super::host::Host;
use super::situation::Situation;
use dashpot_core::step::step;
use dashpot_core::{Input, Model, Output, Params};
use dashpot_core::{element, list, number};

/// Amplitudes of the evaluated motions, m. With [`SPEEDS`], they range from almost standstill to a pothole.
///
/// Outside the reference situation, only motions with medium amplitudes and speeds are evaluated. The other motions would change the result
/// little and take most of the time.
const AMPLITUDES: [f64; 4] = [2e-4, 1e-3, 5e-3, 0.02];
/// Peak velocities of the evaluated motions, m/s.
const SPEEDS: [f64; 4] = [2e-3, 0.02, 0.2, 1.0];
/// Amplitude, m, and peak velocity, m/s, of a stroke through most of the travel, which can open a void.
const LONG: (f64, f64) = (0.05, 1.0);
/// Largest number of steps of one motion.
pub(super) const STEPS: usize = 4000;
/// Velocities that are evaluated at a reversal of a motion, m/s.
const AT_THE_TURN: [f64; 5] = [0.0, 5e-4, -5e-4, 3e-3, -3e-3];
/// Positions on a segment of the FV curve, as fractions of its length. The ends and the middle suffice, because a monotone cubic is
/// steepest at one of them.
const ON_A_PIECE: [f64; 3] = [0.02, 0.5, 0.98];

/// Evaluated motion: a sine that starts at its mean displacement with the peak velocity.
#[derive(Clone, Copy)]
pub(super) struct Sine {
    situation: Situation,
    amplitude: f64,
    speed: f64,
    /// Angular frequency, rad/s.
    pub(super) omega: f64,
}

impl Sine {
    pub(super) fn input_at(&self, time: f64) -> Input {
        let phase = self.omega * time;
        let Situation { place, side_force, temperature } = self.situation;
        let motion = Input::motion(place + self.amplitude * libm::sin(phase), self.speed * libm::cos(phase));
        Input { side_force, temperature, ..motion }
    }
}

/// Returns the motions in a situation that the host resolves. In a step of the host, the phase of such a motion advances by at most 0.5
/// rad.
pub(super) fn motions(situation: Situation, host: Host) -> impl Iterator<Item = Sine> {
    let all = AMPLITUDES.iter().flat_map(|amplitude| SPEEDS.map(|speed| (*amplitude, speed)));
    let is_usual = situation == Situation::REFERENCE;
    let usual = all.filter(move |(amplitude, speed)| is_usual || (1e-3..=5e-3).contains(amplitude) && *speed >= 0.02);
    usual
        .chain(is_usual.then_some(LONG))
        .map(move |(amplitude, speed)| Sine { situation, amplitude, speed, omega: speed / amplitude })
        .filter(move |sine| sine.omega * host.step <= 0.5)
}

/// Largest gain, with the velocity, the model output and the situation at which it occurs.
pub(super) struct Largest {
    pub gain: f64,
    pub velocity: f64,
    pub output: Output,
    pub situation: Situation,
}

/// Returns the largest gain at rest, over all motions in a situation, and at the reversals of these motions.
pub(super) fn largest(model: &Model, situation: Situation, host: Host) -> Largest {
    let gain = |o: &Output| host.step / host.mass * (o.d_force_d_velocity + host.step * o.d_force_d_displacement);
    let rest = situation.input();
    let at_rest = step(model, &model.steady_state(&rest), &rest, host.step).1;
    let mut most = Largest { gain: gain(&at_rest), velocity: 0.0, output: at_rest, situation };
    for sine in motions(situation, host) {
        let input = |k: usize| sine.input_at(host.step * k as f64);
        let mut state = model.steady_state(&rest);
        let steps = (1.25 * std::f64::consts::TAU / (sine.omega * host.step)) as usize;
        for k in 1..=steps.min(STEPS) {
            let to = input(k);
            // Also evaluate the velocities of a reversal, because a void or a gap may close between two samples of the motion.
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

/// Returns the largest gain at constant velocities: at zero velocity and on all segments of the FV curve. The segments are checked because
/// a motion may have no sample on a narrow steep segment.
pub(super) fn on_the_curve(params: &Params, model: &Model, host: Host) -> Largest {
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
        let output = step(model, &model.steady_state(&to), &to, host.step).1;
        let gain = host.step / host.mass * (output.d_force_d_velocity + host.step * output.d_force_d_displacement);
        Largest { gain, velocity, output, situation: Situation::REFERENCE }
    };
    velocities.map(at).fold(at(0.0), |most, other| if other.gain > most.gain { other } else { most })
}
