//! Random draws that depend only on a seed and a purpose, not on previous draws.

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};
use rand_distr::{Distribution, StandardNormal};

/// A stream of random numbers.
#[derive(Debug, Clone)]
pub struct Draw(ChaCha8Rng);

impl Draw {
    /// Makes the stream of random numbers of a seed for a purpose, such as the noise of one channel.
    pub fn new(seed: u64, purpose: &str) -> Draw {
        // Two FNV-1a hashes with different start values give 128 bits, which are sufficient to distinguish purposes.
        let hash = |start: u64| {
            purpose.bytes().fold(start, |h, byte| (h ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3))
        };
        let mut key = [0; 32];
        key[..8].copy_from_slice(&seed.to_le_bytes());
        key[8..16].copy_from_slice(&hash(0xcbf2_9ce4_8422_2325).to_le_bytes());
        key[16..24].copy_from_slice(&hash(0x6c62_272e_07bb_0142).to_le_bytes());
        Draw(ChaCha8Rng::from_seed(key))
    }

    /// Draws a number uniformly from 0 to 1.
    pub fn fraction(&mut self) -> f64 {
        (self.0.next_u64() >> 11) as f64 / (1u64 << 53) as f64
    }

    /// Draws a number uniformly between `low` and `high`.
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.fraction()
    }

    /// Draws a number log-uniformly between the positive numbers `low` and `high`.
    pub fn scale(&mut self, low: f64, high: f64) -> f64 {
        low * libm::pow(high / low, self.fraction())
    }

    /// Draws an index below `count`.
    pub fn choice(&mut self, count: usize) -> usize {
        ((self.fraction() * count as f64) as usize).min(count.saturating_sub(1))
    }

    /// Draws +1 or -1.
    pub fn sign(&mut self) -> f64 {
        if self.fraction() < 0.5 { -1.0 } else { 1.0 }
    }

    /// Draws from the normal distribution with mean 0 and standard deviation 1.
    pub fn normal(&mut self) -> f64 {
        StandardNormal.sample(&mut self.0)
    }

    /// Shuffles items.
    pub fn shuffle<T>(&mut self, items: &mut [T]) {
        for last in (1..items.len()).rev() {
            items.swap(last, self.choice(last + 1));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn streams_depend_on_seed_and_purpose_only() {
        let first = |seed, purpose| Draw::new(seed, purpose).fraction();
        assert_eq!(first(1, "a"), first(1, "a"));
        assert_ne!(first(1, "a"), first(2, "a"));
        assert_ne!(first(1, "a"), first(1, "b"));
    }

    #[test]
    fn draws_fill_their_range() {
        let mut draw = Draw::new(1, "range");
        let drawn: Vec<f64> = (0..4000).map(|_| draw.between(2.0, 3.0)).collect();
        let mean = drawn.iter().sum::<f64>() / 4000.0;
        assert!(drawn.iter().all(|d| (2.0..3.0).contains(d)) && (mean - 2.5).abs() < 0.03, "{mean}");
    }
}
