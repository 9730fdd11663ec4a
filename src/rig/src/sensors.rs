//! Sensor errors of the rig.
//!
//! Every channel of every test has a separate stream of Gaussian noise. The noise of the force channel may be colored;
//! this channel also has mains hum and the quantization of the analog-to-digital converter.

use std::f64::consts::TAU;

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use rand_distr::{Distribution, StandardNormal};

use crate::draw::fnv1a;
use crate::{Options, Record};

/// Standard deviation of the amplifier noise of the load cell, N, in addition to the noise that is proportional to the
/// test's rms force.
const FORCE_FLOOR_N: f64 = 0.5;
/// Standard deviation of the noise of the displacement transducer, m.
const DISPLACEMENT_M: f64 = 2e-6;
/// Standard deviation of the noise of the velocity channel, relative to the test's peak velocity.
const VELOCITY_SHARE: f64 = 1e-3;
/// Standard deviation of the noise of the side-force cell, N.
const SIDE_FORCE_N: f64 = 0.5;
/// Standard deviation of the noise of the temperature sensor, K.
const TEMPERATURE_K: f64 = 0.1;
/// Mains frequency, Hz.
const HUM_HZ: f64 = 50.0;
/// Ranges of common load cells, N.
const RANGES_N: [f64; 8] = [500.0, 1e3, 2e3, 5e3, 10e3, 20e3, 50e3, 100e3];
/// Smallest ratio of the load cell's range to the largest force of the campaign.
const RESERVE: f64 = 1.2;

/// A measured channel. The values of the variants select the random stream, so they must never be reused.
#[derive(Debug, Clone, Copy)]
pub enum Channel {
    Displacement = 1,
    Velocity = 2,
    Force = 3,
    SideForce = 4,
    Temperature = 5,
}

/// The sensors during one test.
#[derive(Debug, Clone)]
pub struct Sensors<'a> {
    options: &'a Options,
    test: &'a str,
}

impl<'a> Sensors<'a> {
    /// Makes the sensors of a campaign in the test named `test`. If `noise_percent` is 0, no sensor has noise.
    pub fn new(options: &'a Options, test: &'a str) -> Self {
        Self { options, test }
    }

    /// Adds the sensor errors to all channels of a record. `full_cycles_s` is the interval of the full cycles, s,
    /// relative to the start of the test, and `start_s` the time of this start, s. `peak_n` is the largest noise-free
    /// force of the campaign, N.
    pub fn disturb_record(&self, record: &mut Record, full_cycles_s: (f64, f64), start_s: f64, peak_n: f64) {
        let rms_n = record.rms_n((start_s + full_cycles_s.0, start_s + full_cycles_s.1));
        self.disturb_force(rms_n, &mut record.force_n);
        self.hum(&record.time_s, &mut record.force_n);
        self.round(peak_n, &mut record.force_n);
        self.disturb(Channel::Displacement, DISPLACEMENT_M, &mut record.displacement_m);
        self.disturb(Channel::Velocity, VELOCITY_SHARE * record.point.peak_velocity_m_s, &mut record.velocity_m_s);
        if let Some(side_force_n) = &mut record.side_force_n {
            self.disturb(Channel::SideForce, SIDE_FORCE_N, side_force_n);
        }
        if let Some(temperature_c) = &mut record.temperature_c {
            self.disturb(Channel::Temperature, TEMPERATURE_K, temperature_c);
        }
    }

    /// Adds the load cell's noise with the selected correlation. Its standard deviation, N, is `noise_percent` of the
    /// rms force `rms_n`, plus [`FORCE_FLOOR_N`].
    fn disturb_force(&self, rms_n: f64, force_n: &mut [f64]) {
        let deviation = 0.01 * self.options.noise_percent * rms_n + FORCE_FLOOR_N;
        let colour = self.options.noise_colour;
        if self.options.noise_percent == 0.0 || colour == 0.0 {
            return self.disturb(Channel::Force, deviation, force_n);
        }
        let mut stream = self.stream(Channel::Force);
        // The first value has the full standard deviation, so that the noise is stationary from the first sample on.
        let fresh = (1.0 - colour * colour).sqrt();
        let mut last: f64 = StandardNormal.sample(&mut stream);
        for value in force_n {
            *value += deviation * last;
            let unit: f64 = StandardNormal.sample(&mut stream);
            last = colour * last + fresh * unit;
        }
    }

    fn hum(&self, time_s: &[f64], force_n: &mut [f64]) {
        let phase = (fnv1a(self.test.as_bytes()) % 1000) as f64 / 1000.0;
        for (force, time) in force_n.iter_mut().zip(time_s) {
            *force += self.options.hum_n * libm::sin(TAU * (HUM_HZ * time + phase));
        }
    }

    fn round(&self, peak_n: f64, force_n: &mut [f64]) {
        let Some(bits) = self.options.bits else {
            return;
        };
        let step = converter_step_n(bits, peak_n);
        for force in force_n {
            *force = step * (*force / step).round();
        }
    }

    fn disturb(&self, channel: Channel, deviation: f64, values: &mut [f64]) {
        if self.options.noise_percent == 0.0 {
            return;
        }
        let mut stream = self.stream(channel);
        for value in values {
            let unit: f64 = StandardNormal.sample(&mut stream);
            *value += deviation * unit;
        }
    }

    /// Makes a random stream that depends only on the campaign's noise seed, test name and channel, not on test order
    /// or threads.
    fn stream(&self, channel: Channel) -> ChaCha8Rng {
        let mut key = [0; 32];
        let seed = self.options.noise_seed.unwrap_or(self.options.seed);
        key[..8].copy_from_slice(&seed.to_le_bytes());
        key[8..16].copy_from_slice(&fnv1a(self.test.as_bytes()).to_le_bytes());
        let mut stream = ChaCha8Rng::from_seed(key);
        stream.set_stream(channel as u64);
        stream
    }
}

/// Computes the quantization step of the force channel, N: twice the load cell's range divided by 2 to the power
/// `bits`.
fn converter_step_n(bits: u32, peak_n: f64) -> f64 {
    let wanted = RESERVE * peak_n;
    let range = RANGES_N.into_iter().find(|range| *range >= wanted).unwrap_or(wanted);
    2.0 * range / libm::exp2(f64::from(bits))
}

impl Record {
    /// Computes the rms of the noise-free force, N, over the cycles at full amplitude, from `start` to `end`, s.
    /// Returns 0 if no sample lies in these cycles.
    pub(crate) fn rms_n(&self, (start, end): (f64, f64)) -> f64 {
        let (mut sum, mut count) = (0.0, 0.0);
        for (time, force) in self.time_s.iter().zip(&self.clean_force_n) {
            if (start..=end).contains(time) {
                sum += force * force;
                count += 1.0;
            }
        }
        if count > 0.0 { f64::sqrt(sum / count) } else { 0.0 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const COUNT: usize = 20_000;

    fn force_noise(seed: u64, test: &str, percent: f64) -> Vec<f64> {
        disturbed(&Options { seed, noise_percent: percent, ..Options::default() }, test)
    }

    fn disturbed(options: &Options, test: &str) -> Vec<f64> {
        let mut values = vec![0.0; COUNT];
        Sensors::new(options, test).disturb_force(1000.0, &mut values);
        values
    }

    fn correlation(a: &[f64], b: &[f64]) -> f64 {
        let product = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        product(a, b) / (product(a, a) * product(b, b)).sqrt()
    }

    #[test]
    fn force_noise_has_the_stated_deviation_and_is_white() {
        let noise = force_noise(1, "a", 2.0);
        let mean = noise.iter().sum::<f64>() / COUNT as f64;
        let deviation = (noise.iter().map(|n| n * n).sum::<f64>() / COUNT as f64).sqrt();
        // The expected standard deviation is 2 % of 1000 N plus 0.5 N, within four standard errors.
        assert!((deviation / 20.5 - 1.0).abs() < 4.0 / (2.0 * COUNT as f64).sqrt(), "{deviation}");
        assert!(mean.abs() < 4.0 * 20.5 / (COUNT as f64).sqrt());
        assert!(correlation(&noise[1..], &noise[..COUNT - 1]).abs() < 4.0 / (COUNT as f64).sqrt());
    }

    #[test]
    fn streams_are_repeatable_and_independent() {
        let reference = force_noise(1, "a", 1.0);
        assert_eq!(reference, force_noise(1, "a", 1.0));
        let mut displacement = vec![0.0; COUNT];
        let options = Options { seed: 1, ..Options::default() };
        Sensors::new(&options, "a").disturb(Channel::Displacement, DISPLACEMENT_M, &mut displacement);
        for other in [force_noise(2, "a", 1.0), force_noise(1, "b", 1.0), displacement] {
            assert!(correlation(&reference, &other).abs() < 4.0 / (COUNT as f64).sqrt());
        }
    }

    #[test]
    fn no_noise_means_ideal_sensors() {
        assert!(force_noise(1, "a", 0.0).iter().all(|value| *value == 0.0));
    }

    #[test]
    fn coloured_noise_keeps_its_deviation_and_has_the_stated_correlation() {
        for colour in [0.5, 0.9] {
            let noise = disturbed(&Options { noise_percent: 2.0, noise_colour: colour, ..Options::default() }, "a");
            let deviation = (noise.iter().map(|n| n * n).sum::<f64>() / COUNT as f64).sqrt();
            // At the correlation r between successive samples, the effective number of independent samples is (1 - r) /
            // (1 + r) of their number.
            let effective = COUNT as f64 * (1.0 - colour) / (1.0 + colour);
            assert!((deviation / 20.5 - 1.0).abs() < 4.0 / (2.0 * effective).sqrt(), "{colour}: {deviation}");
            for lag in [1, 2, 5] {
                let expected = colour.powi(lag as i32);
                let found = correlation(&noise[lag..], &noise[..COUNT - lag]);
                assert!((found - expected).abs() < 4.0 / effective.sqrt(), "{colour}, lag {lag}: {found}");
            }
        }
    }

    #[test]
    fn hum_has_mains_frequency_and_its_amplitude() {
        let options = Options { noise_percent: 0.0, hum_n: 3.0, ..Options::default() };
        let time: Vec<f64> = (0..1000).map(|i| 100.0 + f64::from(i) * 1e-3).collect();
        let mut force = vec![0.0; 1000];
        Sensors::new(&options, "a").hum(&time, &mut force);
        let part = |shift: f64| {
            2.0 / 1000.0 * time.iter().zip(&force).map(|(t, f)| f * libm::sin(TAU * 50.0 * t + shift)).sum::<f64>()
        };
        assert!((part(0.0).hypot(part(TAU / 4.0)) - 3.0).abs() < 1e-9);
    }

    #[test]
    fn rounding_is_to_whole_steps_and_uniform_between_them() {
        // The converter has 12 bits over +-5 kN, the smallest range with reserve above 3 kN.
        let step = converter_step_n(12, 3000.0);
        assert!((step - 10_000.0 / 4096.0).abs() < 1e-12);
        let options = Options { noise_percent: 0.0, bits: Some(12), ..Options::default() };
        let exact: Vec<f64> = (0..COUNT).map(|i| 3000.0 * libm::sin(i as f64 * 0.618_034)).collect();
        let mut rounded = exact.clone();
        Sensors::new(&options, "a").round(3000.0, &mut rounded);
        let errors: Vec<f64> = exact.iter().zip(&rounded).map(|(a, b)| b - a).collect();
        assert!(rounded.iter().all(|value| ((value / step) - (value / step).round()).abs() < 1e-9));
        assert!(errors.iter().all(|error| error.abs() <= 0.5 * step + 1e-9));
        let deviation = (errors.iter().map(|e| e * e).sum::<f64>() / COUNT as f64).sqrt();
        assert!((deviation * 12f64.sqrt() / step - 1.0).abs() < 0.03, "{deviation}");
    }
}
