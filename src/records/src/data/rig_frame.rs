//! How a rig counts its own position, and how far it has gone.
//!
//! Tests that are proposed are stated in the direction, from the zero and in the unit of the files, and stay within what
//! the rig has reached.

use crate::numbers::restrict;
use crate::quantities::unit::Unit;
use crate::tuning::rig_frame::BEYOND;

/// The rig's own count of displacement against that inside, and the reach of its tests.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RigFrame {
    /// 1 where the files count displacement rebound positive, −1 where they count it the other way.
    pub turn: f64,
    /// What the files show where displacement is zero, m.
    pub zero_m: f64,
    /// Factor on the displacement of the files.
    pub gain: f64,
    /// Unit of lengths in a sentence: inches where the files count so, else millimetres.
    pub unit: Unit,
    /// Lowest and highest displacement of all tests, m, as counted inside.
    pub reach_m: (f64, f64),
    /// Highest peak velocity of all tests, m/s.
    pub speed_m_s: f64,
}

impl Default for RigFrame {
    fn default() -> Self {
        let everywhere = (f64::NEG_INFINITY, f64::INFINITY);
        RigFrame {
            turn: 1.0,
            zero_m: 0.0,
            gain: 1.0,
            unit: Unit::Millimetre,
            reach_m: everywhere,
            speed_m_s: f64::INFINITY,
        }
    }
}

/// A sine that a rig is to drive.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RigSine {
    /// Amplitude, m.
    pub amplitude_m: f64,
    /// Frequency, Hz.
    pub frequency_hz: f64,
    /// Mean displacement, m.
    pub mean_m: f64,
}

impl RigFrame {
    /// A position as the files count it, m.
    pub fn position(&self, inside: f64) -> f64 {
        (self.zero_m + self.turn * inside) / self.gain
    }

    /// A sine as the files count it.
    pub fn count(&self, sine: RigSine) -> RigSine {
        RigSine { amplitude_m: sine.amplitude_m / self.gain, mean_m: self.position(sine.mean_m), ..sine }
    }

    /// A sine within what the rig has reached, as counted inside.
    ///
    /// One beyond its reach is moved or made smaller, and slower where it was too fast.
    pub fn restrict_sine(&self, sine: RigSine) -> RigSine {
        let (low, high) = self.reach_m;
        let amplitude = sine.amplitude_m.min((0.5 + BEYOND) * (high - low));
        let (lowest, highest) = (low + amplitude, high - amplitude);
        // An amplitude of the whole reach leaves its middle alone.
        let mean = if lowest <= highest { restrict(sine.mean_m, lowest, highest) } else { 0.5 * (low + high) };
        let fastest = (1.0 + BEYOND) * self.speed_m_s / (std::f64::consts::TAU * amplitude);
        RigSine { amplitude_m: amplitude, frequency_hz: sine.frequency_hz.min(fastest), mean_m: mean }
    }

    /// The frame of the same files, counted the other way round.
    pub(crate) fn reversed(&self) -> RigFrame {
        let (low, high) = self.reach_m;
        RigFrame { turn: -self.turn, reach_m: (-high, -low), ..*self }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tests_are_given_as_the_rig_counts_and_within_its_reach() {
        let frame = RigFrame { turn: -1.0, zero_m: 0.1, reach_m: (-0.03, 0.05), speed_m_s: 0.5, ..RigFrame::default() };
        let sine = |amplitude_m, frequency_hz, mean_m| RigSine { amplitude_m, frequency_hz, mean_m };
        let made = |s| frame.count(frame.restrict_sine(s));
        let near = |a: RigSine, b: RigSine| {
            let pairs = [(a.amplitude_m, b.amplitude_m), (a.frequency_hz, b.frequency_hz), (a.mean_m, b.mean_m)];
            assert!(pairs.iter().all(|(a, b)| (a - b).abs() < 1e-4), "{a:?} {b:?}");
        };
        near(made(sine(0.01, 1.0, -0.005)), sine(0.01, 1.0, 0.105));
        // As far as the rig goes, about its middle.
        near(made(sine(0.08, 0.1, 0.0)), sine(0.0416, 0.1, 0.09));
        // Slower, and moved until its end is reached: 510 mm/s over 10 mm of amplitude.
        near(made(sine(0.01, 50.0, 0.045)), sine(0.01, 8.1169, 0.06));
        let anywhere = sine(0.01, 50.0, 0.045);
        assert_eq!(RigFrame::default().restrict_sine(anywhere), anywhere);
        assert_eq!(frame.reversed().reversed(), frame);
        let gain = RigFrame { gain: 2.0, ..RigFrame::default() };
        assert_eq!(gain.count(anywhere), sine(0.005, 50.0, 0.0225));
    }
}
