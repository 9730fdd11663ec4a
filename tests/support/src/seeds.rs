//! Seeds of property tests: other cases in every run, and the same again on demand.

use proptest::test_runner::{Config, RngSeed};
use std::hash::{BuildHasher, RandomState};

/// The variable that holds the seed of a run that is to be repeated; proptest's own name for it.
const VARIABLE: &str = "PROPTEST_RNG_SEED";

/// The settings of a property test of so many cases. Its seed is drawn anew in every run, and printed, so that a failure shows how to get it again.
///
/// # Panics
/// Where the variable holds no number.
#[must_use]
pub fn drawn(cases: u32) -> Config {
    // The standard library draws the keys of its hash maps from the system's random numbers.
    with(cases, asked().unwrap_or_else(|| RandomState::new().hash_one(0)))
}

/// The settings of a property that is known not to hold everywhere: the same cases in every run, and others where [`VARIABLE`] asks for them.
/// Where it is used stands what other seeds find.
///
/// # Panics
/// Where the variable holds no number.
#[must_use]
pub fn held(cases: u32, seed: u64) -> Config {
    with(cases, asked().unwrap_or(seed))
}

fn asked() -> Option<u64> {
    let text = std::env::var(VARIABLE).ok()?;
    Some(text.parse().unwrap_or_else(|_| panic!("{VARIABLE}={text} is not a number")))
}

fn with(cases: u32, seed: u64) -> Config {
    println!("{VARIABLE}={seed} runs the same cases again");
    // Without the files that proptest leaves beside the sources: the line above says the same.
    Config { cases, failure_persistence: None, rng_seed: RngSeed::Fixed(seed), ..Config::default() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_run_draws_its_own_seed() {
        if std::env::var_os(VARIABLE).is_none() {
            assert_ne!(drawn(1).rng_seed, drawn(1).rng_seed);
        }
    }
}
