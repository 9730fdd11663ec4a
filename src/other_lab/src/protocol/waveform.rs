//! Motions of the moving end of the damper in a test.

use crate::draw::Draw;
use crate::jet::Jet;
use serde::Serialize;
use std::f64::consts::TAU;

/// A motion about the mean displacement.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(rename_all = "snake_case", tag = "kind")]
pub enum Waveform {
    /// A sine.
    Sine {
        /// Amplitude, m.
        amplitude: f64,
        /// Frequency, Hz.
        frequency: f64,
    },
    /// A triangular wave with rounded tips and nearly constant speed between the tips.
    Triangle {
        /// Amplitude, m.
        amplitude: f64,
        /// Frequency, Hz.
        frequency: f64,
    },
    /// A sine with exponentially increasing frequency and constant peak velocity.
    Sweep {
        /// Amplitude at the first frequency, m.
        amplitude: f64,
        /// First and last frequency, Hz.
        frequencies: (f64, f64),
        /// Duration, s.
        seconds: f64,
    },
    /// A road-like random motion: sine waves of random phase from 0.5 to 25 Hz, with amplitudes that decrease with
    /// frequency as on a road.
    Road {
        /// Largest displacement, m.
        displacement: f64,
        /// Largest velocity, m/s.
        velocity: f64,
        /// Duration, s.
        seconds: f64,
        /// Seed of the random frequencies and phases.
        seed: u64,
    },
}

/// Factor s of the triangular wave asin(s sin(ωt)) with the angular frequency ω and the time t. With a value below 1,
/// the tips are rounded.
const SHARP: f64 = 0.995;
const WAVES: usize = 28;
/// Duration of the fade-in and of the fade-out of a road-like motion or sweep, s.
const FADE: f64 = 0.5;

/// A motion prepared for evaluation.
#[derive(Debug, Clone)]
pub struct Ready {
    motion: Waveform,
    mean: f64,
    rest: f64,
    cycles: f64,
    /// Amplitude, m, angular frequency, rad/s, and phase, rad, of each sine wave of a road-like motion.
    waves: Vec<[f64; 3]>,
}

impl Waveform {
    /// Returns the longest step of the simulation of this motion, s.
    pub fn longest_step(&self) -> f64 {
        match self {
            Waveform::Sine { frequency, .. } => 1.0 / (110.0 * frequency),
            Waveform::Triangle { frequency, .. } => 1.0 / (200.0 * frequency),
            Waveform::Sweep { .. } | Waveform::Road { .. } => 2e-3,
        }
    }

    /// Returns the duration of the motion at full amplitude with `cycles` cycles, s. For a sweep or road-like motion,
    /// this is its whole duration.
    pub fn seconds(&self, cycles: f64) -> f64 {
        match self {
            Waveform::Sine { frequency, .. } | Waveform::Triangle { frequency, .. } => cycles / frequency,
            Waveform::Sweep { seconds, .. } | Waveform::Road { seconds, .. } => *seconds,
        }
    }

    /// Returns the duration of the fade-in before the full motion, s: one cycle of a sine or triangle, otherwise 0.
    pub fn run_up(&self) -> f64 {
        match self {
            Waveform::Sine { frequency, .. } | Waveform::Triangle { frequency, .. } => 1.0 / frequency,
            _ => 0.0,
        }
    }

    /// Prepares the motion about a mean displacement, m, for evaluation. The motion begins after a standstill of
    /// `rest`, s, and has `cycles` cycles.
    pub fn ready(&self, mean: f64, rest: f64, cycles: f64) -> Ready {
        let mut ready = Ready { motion: *self, mean, rest, cycles, waves: Vec::new() };
        if let Waveform::Road { displacement, velocity, seconds, seed } = *self {
            let mut d = Draw::new(seed, "road");
            let ratio = libm::log(25.0 / 0.5) / WAVES as f64;
            let drawn: Vec<[f64; 2]> =
                (0..WAVES).map(|i| [0.5 * libm::exp((i as f64 + d.fraction()) * ratio), TAU * d.fraction()]).collect();
            // A spectrum that falls faster with frequency has a larger displacement at equal velocity. Bisection finds
            // the exponent with which the motion reaches both limits.
            let (mut flat, mut steep) = (-0.3, 1.5);
            for _ in 0..24 {
                let power = 0.5 * (flat + steep);
                ready.waves = drawn
                    .iter()
                    .map(|[f, phase]| [libm::pow(*f, -power) / (1.0 + (f / 15.0).powi(4)), TAU * f, *phase])
                    .collect();
                let (mut x, mut v) = (0.0f64, 0.0f64);
                for i in 0..(seconds * 100.0) as usize {
                    let at = ready.evaluate(rest + i as f64 / 100.0);
                    (x, v) = (x.max((at.x - mean).abs()), v.max(at.v.abs()));
                }
                let factor = (displacement / x).min(velocity / v);
                ready.waves.iter_mut().for_each(|wave| wave[0] *= factor);
                if displacement / x < velocity / v {
                    steep = power;
                } else {
                    flat = power;
                }
                if libm::log(displacement / x / (velocity / v)).abs() < 0.01 {
                    break;
                }
            }
        }
        ready
    }
}

impl Ready {
    /// Computes displacement, m, velocity, m/s, and acceleration, m/s², at time `t` since the start of the record, s.
    pub fn evaluate(&self, t: f64) -> Jet {
        let since = Jet::time(t - self.rest);
        if since.x <= 0.0 {
            return Jet::constant(self.mean);
        }
        let moved = match self.motion {
            Waveform::Sine { amplitude, frequency } => {
                since.times(TAU * frequency).sin().times(amplitude) * since.times(frequency).smooth_step()
            }
            Waveform::Triangle { amplitude, frequency } => {
                let wave = since.times(TAU * frequency).sin().times(SHARP).asin().times(amplitude / libm::asin(SHARP));
                wave * since.times(frequency).smooth_step()
            }
            Waveform::Sweep { amplitude, frequencies: (from, to), seconds } => {
                let rate = libm::log(to / from) / seconds;
                let growth = libm::exp(rate * since.x);
                let growth = since.times(rate).through(growth, growth, growth);
                let phase = (growth - Jet::constant(1.0)).times(TAU * from / rate);
                phase.sin() * growth.powf(-1.0).times(amplitude) * self.fades(since, seconds)
            }
            Waveform::Road { seconds, .. } => {
                let sum = self.waves.iter().fold(Jet::constant(0.0), |sum, [size, omega, phase]| {
                    let (s, c) = (omega * since.x + phase).sin_cos();
                    sum + Jet { x: size * s, v: size * omega * c, a: -size * omega * omega * s }
                });
                sum * self.fades(since, seconds)
            }
        };
        Jet::constant(self.mean) + moved
    }

    fn fades(&self, since: Jet, seconds: f64) -> Jet {
        let start = since.times(1.0 / FADE).smooth_step();
        start * (Jet::constant(seconds) - since).times(1.0 / FADE).smooth_step()
    }

    /// Returns the duration of the record, s.
    pub fn seconds(&self) -> f64 {
        self.rest + self.motion.run_up() + self.motion.seconds(self.cycles)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn velocity_and_acceleration_belong_to_displacement() {
        for motion in [
            Waveform::Sine { amplitude: 0.02, frequency: 2.0 },
            Waveform::Triangle { amplitude: 0.02, frequency: 1.0 },
            Waveform::Sweep { amplitude: 0.02, frequencies: (0.5, 10.0), seconds: 5.0 },
            Waveform::Road { displacement: 0.03, velocity: 0.8, seconds: 5.0, seed: 4 },
        ] {
            let ready = motion.ready(0.01, 0.2, 3.0);
            let h = 1e-6;
            for i in 0..60 {
                let t = 0.21 + 0.047 * f64::from(i);
                let (before, at, after) = (ready.evaluate(t - h), ready.evaluate(t), ready.evaluate(t + h));
                assert!((at.v - (after.x - before.x) / (2.0 * h)).abs() < 1e-6, "{motion:?} at {t}");
                assert!(
                    (at.a - (after.v - before.v) / (2.0 * h)).abs() < 1e-3 * (1.0 + at.a.abs()),
                    "{motion:?} at {t}"
                );
            }
        }
    }

    #[test]
    fn roads_keep_their_limits_and_use_one() {
        let road = Waveform::Road { displacement: 0.03, velocity: 0.8, seconds: 10.0, seed: 7 }.ready(0.0, 0.2, 1.0);
        let all: Vec<Jet> = (0..10_200).map(|i| road.evaluate(f64::from(i) * 1e-3)).collect();
        let x = all.iter().fold(0.0f64, |m, at| m.max(at.x.abs())) / 0.03;
        let v = all.iter().fold(0.0f64, |m, at| m.max(at.v.abs())) / 0.8;
        assert!(x < 1.03 && v < 1.03 && x.max(v) > 0.97, "{x} {v}");
    }
}
