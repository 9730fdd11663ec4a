//! Random draws that record the drawn values, because the truth of an injected case lists them.

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};

/// A random stream of one seed for one purpose, such as the noise of one test.
#[derive(Debug, Clone)]
pub(crate) struct Draw {
    stream: ChaCha8Rng,
    /// Names (with unit) and values, in the order of the draws.
    pub values: Vec<(String, f64)>,
}

impl Draw {
    /// Initializes a random stream that depends only on seed and purpose. Draws from streams with other purposes do not
    /// change it.
    pub fn new(seed: u64, purpose: &str) -> Self {
        let mut key = [0; 32];
        key[..8].copy_from_slice(&seed.to_le_bytes());
        key[8..16].copy_from_slice(&fnv1a(purpose.as_bytes()).to_le_bytes());
        key[16] = 0x5d;
        Self { stream: ChaCha8Rng::from_seed(key), values: Vec::new() }
    }

    /// Draws a value uniformly in 0..1, without recording it.
    pub fn unit(&mut self) -> f64 {
        (self.stream.next_u64() >> 11) as f64 / (1u64 << 53) as f64
    }

    /// Draws a value uniformly between `low` and `high`, and records it under `name`.
    pub fn between(&mut self, name: &str, low: f64, high: f64) -> f64 {
        let value = low + (high - low) * self.unit();
        self.values.push((name.into(), value));
        value
    }

    /// Draws a value log-uniformly between the positive values `low` and `high`, and records it under `name`.
    pub fn ratio(&mut self, name: &str, low: f64, high: f64) -> f64 {
        let value = low * libm::pow(high / low, self.unit());
        self.values.push((name.into(), value));
        value
    }

    /// Draws one of `count` equally likely indices, without recording.
    pub fn choice(&mut self, count: usize) -> usize {
        ((self.unit() * count as f64) as usize).min(count - 1)
    }
}

/// Computes the hash FNV-1a, which, unlike the standard library's hash, does not change between releases.
pub(crate) fn fnv1a(bytes: &[u8]) -> u64 {
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(*byte)).wrapping_mul(0x0000_0100_0000_01b3))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn streams_repeat_differ_and_stay_in_range() {
        let draw = |seed, purpose| {
            let mut draw = Draw::new(seed, purpose);
            (0..200).map(|_| draw.ratio("x", 0.1, 10.0)).collect::<Vec<_>>()
        };
        assert_eq!(draw(1, "a"), draw(1, "a"));
        assert_ne!(draw(1, "a"), draw(1, "b"));
        assert_ne!(draw(1, "a"), draw(2, "a"));
        assert!(draw(1, "a").iter().all(|x| (0.1..=10.0).contains(x)));
        let below = draw(1, "a").iter().filter(|x| **x < 1.0).count();
        assert!((70..=130).contains(&below), "{below}");
    }
}
