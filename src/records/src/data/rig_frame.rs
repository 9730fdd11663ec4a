//! Coordinate frame of a rig's displacement, and the range of its tests.
//!
//! Proposed tests use the sign convention, the zero and the unit of the files, and stay within the range of the
//! recorded tests.

use crate::numbers::restrict;
use crate::quantities::unit::Unit;
use crate::tuning::rig_frame::BEYOND;

/// Transformation between displacements in the files and internal displacements, with the range of the tests.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RigFrame {
    /// Sign of displacement in the files: 1 if rebound is positive, −1 if compression is positive.
    pub turn: f64,
    /// Displacement in the files at internal displacement zero, times `gain`, m.
    pub zero_m: f64,
    /// Factor on the displacement of the files.
    pub gain: f64,
    /// Unit of lengths in messages: inches if the files use inches, else millimeters.
    pub unit: Unit,
    /// Lowest and highest displacement of all tests, m, in internal coordinates.
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
    /// Converts an internal displacement `inside`, m, to the displacement in the coordinates of the files, m.
    pub fn position(&self, inside: f64) -> f64 {
        (self.zero_m + self.turn * inside) / self.gain
    }

    /// Returns the unit of speeds in messages: that of lengths per second.
    pub fn speed_unit(&self) -> Unit {
        if self.unit == Unit::Inch { Unit::InchPerSecond } else { Unit::MillimetrePerSecond }
    }

    /// Converts a sine to the coordinates of the files.
    pub fn count(&self, sine: RigSine) -> RigSine {
        RigSine { amplitude_m: sine.amplitude_m / self.gain, mean_m: self.position(sine.mean_m), ..sine }
    }

    /// Limits a sine to the range of the recorded tests, in internal coordinates.
    ///
    /// Shifts or reduces a sine that exceeds the range, and lowers the frequency of a sine that is too fast.
    pub fn restrict_sine(&self, sine: RigSine) -> RigSine {
        let (low, high) = self.reach_m;
        let amplitude = sine.amplitude_m.min((0.5 + BEYOND) * (high - low));
        let (lowest, highest) = (low + amplitude, high - amplitude);
        // If the amplitude is half the range or more, the mean must be the middle of the range.
        let mean = if lowest <= highest { restrict(sine.mean_m, lowest, highest) } else { 0.5 * (low + high) };
        let fastest = (1.0 + BEYOND) * self.speed_m_s / (std::f64::consts::TAU * amplitude);
        RigSine { amplitude_m: amplitude, frequency_hz: sine.frequency_hz.min(fastest), mean_m: mean }
    }

    /// Returns the frame with the opposite sign of displacement.
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
        // The limited sine covers the whole range, about its middle.
        near(made(sine(0.08, 0.1, 0.0)), sine(0.0416, 0.1, 0.09));
        // The limited sine is slower and shifted to the end of the range: 510 mm/s with 10 mm amplitude.
        near(made(sine(0.01, 50.0, 0.045)), sine(0.01, 8.1169, 0.06));
        let anywhere = sine(0.01, 50.0, 0.045);
        assert_eq!(RigFrame::default().restrict_sine(anywhere), anywhere);
        assert_eq!(frame.reversed().reversed(), frame);
        let gain = RigFrame { gain: 2.0, ..RigFrame::default() };
        assert_eq!(gain.count(anywhere), sine(0.005, 50.0, 0.0225));
    }
}
