//! Advice in the words of the rig.
//!
//! Tests to be driven are given in the direction and from the zero that the files count, and stay within what the rig
//! has reached.

use serde::{Deserialize, Serialize};

use super::sign::SignFinding;
use crate::data::record::Record;
use crate::numbers::restrict;
use crate::options::{Options, Positive};
use crate::quantities::channel::Channel;
use crate::tuning::rig_frame::BEYOND;

/// How the rig's own position and what is inside go together, and how far the rig has gone.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct RigFrame {
    /// 1 where the files count displacement rebound positive, −1 where they count it the other way.
    pub turn: f64,
    /// What the files show where displacement is zero, m.
    pub zero_m: f64,
    /// Factor on the displacement of the files.
    pub gain: f64,
    /// Lowest and highest displacement of all tests, m, as counted inside.
    pub reach_m: (f64, f64),
    /// Highest peak velocity of all tests, m/s.
    pub speed_m_s: f64,
}

impl Default for RigFrame {
    fn default() -> Self {
        let everywhere = (f64::NEG_INFINITY, f64::INFINITY);
        RigFrame { turn: 1.0, zero_m: 0.0, gain: 1.0, reach_m: everywhere, speed_m_s: f64::INFINITY }
    }
}

impl RigFrame {
    /// Of the records of a campaign, read by these options.
    pub(crate) fn new(records: &[Record], sign: &SignFinding, options: &Options) -> RigFrame {
        let direction = if sign.positive == Positive::Compression { -1.0 } else { 1.0 };
        let flipped = if options.flip_motion { -1.0 } else { 1.0 };
        let all = || records.iter().flat_map(|record| record.displacement.iter().copied());
        RigFrame {
            turn: direction * flipped,
            zero_m: options.displacement_zero_m,
            gain: options.gains.get(&Channel::Displacement).copied().unwrap_or(1.0),
            reach_m: (all().fold(f64::INFINITY, f64::min), all().fold(f64::NEG_INFINITY, f64::max)),
            speed_m_s: records.iter().map(|record| record.peak_velocity).fold(0.0, f64::max),
        }
    }

    /// A position as the files count it, m.
    pub fn position(&self, inside: f64) -> f64 {
        (self.zero_m + self.turn * inside) / self.gain
    }

    /// A matrix of sines (name, amplitude, frequency, mean and side force, in mm and Hz) as the rig counts it.
    ///
    /// A test beyond its reach is moved or made smaller, and slower where it was too fast. Lines that are no such row
    /// stay as they are.
    pub fn matrix(&self, rows: &str) -> String {
        let row = |line: &str| -> Option<String> {
            let cells: Vec<&str> = line.split(',').collect();
            let &[name, amplitude, frequency, mean, side] = &cells[..] else { return None };
            let [amplitude, frequency, mean] = [amplitude, frequency, mean].map(|cell| cell.parse::<f64>().ok());
            let (amplitude, frequency, mean) = (1e-3 * amplitude?, frequency?, 1e-3 * mean?);
            let (low, high) = self.reach_m;
            let amplitude = amplitude.min((0.5 + BEYOND) * (high - low));
            let mean =
                restrict(mean, (low + amplitude).min(0.5 * (low + high)), (high - amplitude).max(0.5 * (low + high)));
            let fastest = (1.0 + BEYOND) * self.speed_m_s / (std::f64::consts::TAU * amplitude);
            let frequency = frequency.min(fastest);
            let short = |value: f64| {
                let text = format!("{value:.6}");
                let text = text.trim_end_matches('0').trim_end_matches('.').to_owned();
                if text == "-0" { "0".to_owned() } else { text }
            };
            let (amplitude, mean) = (short(1e3 * amplitude / self.gain), short(1e3 * self.position(mean)));
            Some(format!("{name},{amplitude},{},{mean},{side}", short(frequency)))
        };
        let lines: Vec<String> = rows.lines().map(|line| row(line).unwrap_or_else(|| line.to_owned())).collect();
        lines.join("\n") + "\n"
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const HEADING: &str = "name,amplitude_mm,frequency_hz,mean_displacement_mm,side_force_n";

    #[test]
    fn tests_are_given_as_the_rig_counts_and_within_its_reach() {
        let frame = RigFrame { turn: -1.0, zero_m: 0.1, gain: 1.0, reach_m: (-0.03, 0.05), speed_m_s: 0.5 };
        let rows = format!("{HEADING}\nnext_1,10,1,-5,0\nnext_2,80,0.1,0,0\nnext_3,10,50,45,200\n");
        let made = frame.matrix(&rows);
        let lines: Vec<&str> = made.lines().collect();
        assert_eq!((lines.len(), lines[0], lines[1]), (4, HEADING, "next_1,10,1,105,0"));
        // As far as the rig goes, about its middle.
        assert_eq!(lines[2], "next_2,41.6,0.1,90,0");
        // Slower, and moved until its end is reached: 51 mm/s over ten of amplitude.
        assert!(lines[3].starts_with("next_3,10,8.1169") && lines[3].ends_with(",60,200"), "{made}");
        assert_eq!(RigFrame::default().matrix(&rows), rows);
    }
}
