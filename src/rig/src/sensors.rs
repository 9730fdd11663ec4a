//! What the rig's sensors add to the truth: white Gaussian noise, a stream of its own for every channel of every test.

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use rand_distr::{Distribution, StandardNormal};

/// Noise of the load cell's amplifier, standard deviation, N; comes on top of the share of the test's force.
const FORCE_FLOOR_N: f64 = 0.5;
/// Noise of the displacement transducer, standard deviation, m.
const DISPLACEMENT_M: f64 = 2e-6;
/// Noise of the velocity channel, standard deviation, as a share of the test's peak velocity.
const VELOCITY_SHARE: f64 = 1e-3;
/// Noise of the side-force cell, standard deviation, N.
const SIDE_FORCE_N: f64 = 0.5;

/// A measured channel. The numbers choose the random stream: never reuse one.
#[derive(Debug, Clone, Copy)]
pub enum Channel {
    Displacement = 1,
    Velocity = 2,
    Force = 3,
    SideForce = 4,
}

/// The sensors during one test.
#[derive(Debug, Clone)]
pub struct Sensors<'a> {
    seed: u64,
    test: &'a str,
    noise_percent: f64,
}

impl<'a> Sensors<'a> {
    /// Sensors of the campaign `seed` in the test named `test`. With `noise_percent` 0 they are ideal, all of them.
    pub fn new(seed: u64, test: &'a str, noise_percent: f64) -> Self {
        Self { seed, test, noise_percent }
    }

    /// Adds the load cell's noise: `noise_percent` of `rms_n`, plus the amplifier's.
    pub fn disturb_force(&self, rms_n: f64, force_n: &mut [f64]) {
        self.disturb(Channel::Force, 0.01 * self.noise_percent * rms_n + FORCE_FLOOR_N, force_n);
    }

    /// Adds the side-force cell's noise.
    pub fn disturb_side_force(&self, side_force_n: &mut [f64]) {
        self.disturb(Channel::SideForce, SIDE_FORCE_N, side_force_n);
    }

    /// Adds the displacement transducer's noise.
    pub fn disturb_displacement(&self, displacement_m: &mut [f64]) {
        self.disturb(Channel::Displacement, DISPLACEMENT_M, displacement_m);
    }

    /// Adds the velocity channel's noise.
    pub fn disturb_velocity(&self, peak_m_s: f64, velocity_m_s: &mut [f64]) {
        self.disturb(Channel::Velocity, VELOCITY_SHARE * peak_m_s, velocity_m_s);
    }

    fn disturb(&self, channel: Channel, deviation: f64, values: &mut [f64]) {
        if self.noise_percent == 0.0 {
            return;
        }
        let mut stream = self.stream(channel);
        for value in values {
            let unit: f64 = StandardNormal.sample(&mut stream);
            *value += deviation * unit;
        }
    }

    /// Depends on campaign, test name and channel only, so neither the order of the tests nor the threads matter.
    fn stream(&self, channel: Channel) -> ChaCha8Rng {
        let mut key = [0; 32];
        key[..8].copy_from_slice(&self.seed.to_le_bytes());
        key[8..16].copy_from_slice(&fnv1a(self.test.as_bytes()).to_le_bytes());
        let mut stream = ChaCha8Rng::from_seed(key);
        stream.set_stream(channel as u64);
        stream
    }
}

/// FNV-1a: unlike the standard library's hash, the same in every release.
fn fnv1a(bytes: &[u8]) -> u64 {
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(*byte)).wrapping_mul(0x0000_0100_0000_01b3))
}

#[cfg(test)]
mod tests {
    use super::*;

    const COUNT: usize = 20_000;

    fn force_noise(seed: u64, test: &str, percent: f64) -> Vec<f64> {
        let mut values = vec![0.0; COUNT];
        Sensors::new(seed, test, percent).disturb_force(1000.0, &mut values);
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
        // 2 % of 1000 N + 0.5 N; four standard errors.
        assert!((deviation / 20.5 - 1.0).abs() < 4.0 / (2.0 * COUNT as f64).sqrt(), "{deviation}");
        assert!(mean.abs() < 4.0 * 20.5 / (COUNT as f64).sqrt());
        assert!(correlation(&noise[1..], &noise[..COUNT - 1]).abs() < 4.0 / (COUNT as f64).sqrt());
    }

    #[test]
    fn streams_are_repeatable_and_independent() {
        let reference = force_noise(1, "a", 1.0);
        assert_eq!(reference, force_noise(1, "a", 1.0));
        let mut displacement = vec![0.0; COUNT];
        Sensors::new(1, "a", 1.0).disturb_displacement(&mut displacement);
        for other in [force_noise(2, "a", 1.0), force_noise(1, "b", 1.0), displacement] {
            assert!(correlation(&reference, &other).abs() < 4.0 / (COUNT as f64).sqrt());
        }
    }

    #[test]
    fn no_noise_means_ideal_sensors() {
        assert!(force_noise(1, "a", 0.0).iter().all(|value| *value == 0.0));
    }
}
