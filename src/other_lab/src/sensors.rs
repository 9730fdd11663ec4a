//! Errors of sensors and analog-to-digital converters.

use crate::draw::Draw;
use crate::protocol::Protocol;
use std::f64::consts::TAU;

/// Standard deviation of the noise of the load cell's amplifier, N, in addition to the noise relative to the test's rms
/// force.
pub const LEAST_NOISE_N: f64 = 0.5;
/// Standard deviation of the noise of the displacement transducer, m, for an LVDT with a range of 100 mm.
const DISPLACEMENT_M: f64 = 2e-6;
/// Standard deviation of the noise of the velocity channel, relative to the largest velocity of the test.
const VELOCITY_SHARE: f64 = 1.5e-3;
const SIDE_FORCE_N: f64 = 1.0;
const TEMPERATURE_K: f64 = 0.1;
const HUM_HZ: f64 = 50.0;
/// Ratio of the force converter's range to the largest force of the campaign.
const RESERVE: f64 = 1.3;
/// Range of the displacement transducer, m.
const STROKE_M: f64 = 0.1;

/// The sensors of a campaign in one test.
pub struct Sensors<'a> {
    /// Protocol of the measurement.
    pub protocol: &'a Protocol,
    /// Seed of the noise.
    pub seed: u64,
    /// Name of the test.
    pub test: &'a str,
    /// Largest force of the campaign, N.
    pub peak_n: f64,
}

impl Sensors<'_> {
    fn draw(&self, channel: &str) -> Draw {
        Draw::new(self.seed, &format!("{channel} of {}", self.test))
    }

    fn white(&self, channel: &str, deviation: f64, values: &mut [f64]) {
        if self.protocol.noise_percent > 0.0 {
            let mut d = self.draw(channel);
            values.iter_mut().for_each(|value| *value += deviation * d.normal());
        }
    }

    fn rounded(&self, range: f64, values: &mut [f64]) {
        if let Some(bits) = self.protocol.bits {
            let step = 2.0 * range / libm::exp2(f64::from(bits));
            values.iter_mut().for_each(|value| *value = step * (*value / step).round());
        }
    }

    /// Adds noise, hum, offset and quantization to the force of a test, N, at the times `time`, s.
    pub fn force(&self, time: &[f64], force: &mut [f64]) {
        let p = self.protocol;
        if p.noise_percent > 0.0 {
            let rms = (force.iter().map(|f| f * f).sum::<f64>() / force.len().max(1) as f64).sqrt();
            let deviation = 0.01 * p.noise_percent * rms + LEAST_NOISE_N;
            let mut d = self.draw("force");
            let fresh = (1.0 - p.noise_colour * p.noise_colour).sqrt();
            let mut last = d.normal();
            for value in force.iter_mut() {
                *value += deviation * last;
                last = p.noise_colour * last + fresh * d.normal();
            }
        }
        let phase = self.draw("hum").fraction();
        for (value, t) in force.iter_mut().zip(time) {
            *value += p.force_offset_n + p.hum_n * libm::sin(TAU * (HUM_HZ * t + phase));
        }
        self.rounded(RESERVE * self.peak_n, force);
    }

    /// Adds noise, offset and quantization to the displacement, m.
    pub fn displacement(&self, values: &mut [f64]) {
        self.white("displacement", DISPLACEMENT_M, values);
        values.iter_mut().for_each(|value| *value += self.protocol.displacement_offset_m);
        self.rounded(STROKE_M, values);
    }

    /// Adds noise to the velocity, m/s.
    pub fn velocity(&self, values: &mut [f64]) {
        let peak = values.iter().fold(0.0f64, |m, v| m.max(v.abs()));
        self.white("velocity", VELOCITY_SHARE * peak, values);
    }

    /// Adds noise to the side force, N.
    pub fn side(&self, values: &mut [f64]) {
        self.white("side force", SIDE_FORCE_N, values);
    }

    /// Adds noise to the temperature, °C.
    pub fn temperature(&self, values: &mut [f64]) {
        self.white("temperature", TEMPERATURE_K, values);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn coloured_noise_has_its_deviation_and_correlation() {
        let protocol = Protocol { noise_percent: 2.0, noise_colour: 0.8, ..Protocol::default() };
        let sensors = Sensors { protocol: &protocol, seed: 1, test: "a", peak_n: 1000.0 };
        let time: Vec<f64> = (0..40_000).map(f64::from).collect();
        let mut force = vec![1000.0; time.len()];
        sensors.force(&time, &mut force);
        let noise: Vec<f64> = force.iter().map(|f| f - 1000.0).collect();
        let square = |n: &[f64]| n.iter().map(|n| n * n).sum::<f64>();
        let deviation = (square(&noise) / noise.len() as f64).sqrt();
        let next: f64 = noise.windows(2).map(|w| w[0] * w[1]).sum::<f64>() / square(&noise);
        assert!((deviation / 20.5 - 1.0).abs() < 0.05, "{deviation}");
        assert!((next - 0.8).abs() < 0.03, "{next}");
    }

    #[test]
    fn steps_and_offset_are_those_asked_for() {
        let protocol = Protocol { noise_percent: 0.0, bits: Some(12), force_offset_n: 100.0, ..Protocol::default() };
        let sensors = Sensors { protocol: &protocol, seed: 1, test: "a", peak_n: 1000.0 };
        let mut force: Vec<f64> = (0..1000).map(|i| f64::from(i) * 0.37).collect();
        let time = force.clone();
        sensors.force(&time, &mut force);
        let step = 2600.0 / 4096.0;
        for (f, t) in force.iter().zip(&time) {
            assert!((f / step - (f / step).round()).abs() < 1e-9 && (f - t - 100.0).abs() <= 0.5 * step + 1e-9);
        }
    }
}
