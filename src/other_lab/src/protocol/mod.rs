//! Protocol of a campaign: plan of the tests, their execution, and the measured channels.

pub mod plan;
pub mod waveform;

use crate::LabError;
use crate::draw::Draw;
use plan::Plan;
use serde::Serialize;

/// Protocol of execution and measurement.
#[derive(Debug, Clone, Serialize)]
pub struct Protocol {
    /// Plan of the tests.
    pub plan: Plan,
    /// Sample rate, Hz. Slow tests have a reduced rate because of `most_samples`.
    pub sample_rate_hz: f64,
    /// Largest number of samples of a sine or triangle. A longer record is decimated by an integer factor.
    pub most_samples: usize,
    /// Number of cycles at full amplitude of a sine or triangle.
    pub cycles: u32,
    /// Duration of a road-like random motion, s.
    pub road_s: f64,
    /// Standstill before the motion, s.
    pub rest_s: f64,
    /// Standard deviation of the force noise in percent of each test's rms force; 0.5 N is added. 0 disables the noise
    /// of all channels.
    pub noise_percent: f64,
    /// Correlation between successive samples of the force noise (AR(1)); 0 means white noise.
    pub noise_colour: f64,
    /// Amplitude of 50 Hz hum on the force, N.
    pub hum_n: f64,
    /// Number of bits of the analog-to-digital converters of force and displacement. `None` means no rounding.
    pub bits: Option<u32>,
    /// Delay of the force channel, s.
    pub force_delay_s: f64,
    /// Zero error of the force channel, N.
    pub force_offset_n: f64,
    /// Zero error of the displacement channel, m.
    pub displacement_offset_m: f64,
    /// Whether velocity is measured.
    pub velocity_channel: bool,
    /// Whether the temperature of the oil is measured.
    pub temperature_channel: bool,
    /// Whether the tests are shuffled, with the repeated reference tests at start, middle and end.
    pub shuffled: bool,
    /// Ratio of unrecorded conditioning cycles to recorded cycles of each sine test. Conditioning heats the oil.
    pub conditioning: f64,
}

impl Default for Protocol {
    fn default() -> Protocol {
        Protocol {
            plan: Plan::Sines,
            sample_rate_hz: 2000.0,
            most_samples: 1600,
            cycles: 3,
            road_s: 10.0,
            rest_s: 0.2,
            noise_percent: 2.0,
            noise_colour: 0.0,
            hum_n: 0.0,
            bits: None,
            force_delay_s: 0.0,
            force_offset_n: 0.0,
            displacement_offset_m: 0.0,
            velocity_channel: true,
            temperature_channel: true,
            shuffled: true,
            conditioning: 30.0,
        }
    }
}

impl Protocol {
    /// Draws a random protocol of measurement, as of some laboratory.
    ///
    /// The protocol has a sample rate of 100 Hz to 5 kHz and 3 to 30 cycles. It has converters of 12 to 16 bits or no
    /// rounding, and white or colored noise. Some draws have hum, a velocity channel or a temperature channel. Delays
    /// and offsets are zero.
    pub fn of_laboratory(plan: Plan, seed: u64) -> Protocol {
        let mut d = Draw::new(seed, "laboratory");
        let sample_rate_hz = [100.0, 200.0, 256.0, 500.0, 1000.0, 1024.0, 2000.0, 2048.0, 5000.0][d.choice(9)];
        Protocol {
            plan,
            sample_rate_hz,
            most_samples: [1000, 2000, 4000][d.choice(3)],
            cycles: [3, 3, 4, 5, 8, 12, 20, 30][d.choice(8)],
            road_s: d.between(10.0, 30.0).round(),
            rest_s: d.between(0.1, 0.6),
            noise_percent: d.between(1.0, 3.0),
            noise_colour: if d.choice(2) == 0 { 0.0 } else { d.between(0.5, 0.95) },
            hum_n: if d.choice(2) == 0 { 0.0 } else { d.between(0.5, 4.0) },
            bits: [None, Some(12), Some(14), Some(16)][d.choice(4)],
            velocity_channel: d.choice(2) == 0,
            temperature_channel: d.choice(2) == 0,
            ..Protocol::default()
        }
    }
}

impl Protocol {
    /// Checks that every entry of the protocol is valid.
    ///
    /// # Errors
    /// [`LabError::Protocol`] with the invalid entry.
    pub fn check(&self) -> Result<(), LabError> {
        let positive = [
            ("sample_rate_hz", self.sample_rate_hz),
            ("most_samples", self.most_samples as f64),
            ("cycles", f64::from(self.cycles)),
            ("road_s", self.road_s - 2.0),
        ];
        let not_negative = [
            ("rest_s", self.rest_s),
            ("noise_percent", self.noise_percent),
            ("noise_colour", self.noise_colour),
            ("conditioning", self.conditioning),
            ("force_delay_s", self.force_delay_s),
        ];
        let wrong = positive.iter().find(|(_, value)| !(value.is_finite() && *value > 0.0));
        let wrong = wrong.or_else(|| not_negative.iter().find(|(_, value)| !(value.is_finite() && *value >= 0.0)));
        if let Some((what, _)) = wrong {
            return Err(LabError::Protocol { what, why: "it has to be a positive number (road_s: above 2 s)" });
        }
        if self.noise_colour >= 1.0 {
            return Err(LabError::Protocol { what: "noise_colour", why: "it has to be below 1" });
        }
        Ok(())
    }
}
