//! What a probability of the search is worth: of names given with it, that many were right.

use serde::Deserialize;
use std::sync::LazyLock;

/// Logistic calibration, with its origin beside it in the file.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Calibration {
    constant_against_reference: f64,
    slope_against_reference: f64,
}

static CALIBRATION: LazyLock<Calibration> = LazyLock::new(|| {
    // The file is part of the program, so only a build can be wrong; the test below reads it.
    toml::from_str(include_str!("calibration.toml")).expect("calibration.toml holds two numbers")
});

/// Log odds beyond which more is no surer.
const MOST: f64 = 8.0;

/// Probability that a name against a reference is right to which the search gives `probability`.
///
/// Below one half no name is given, so nothing is known of such names: their probability is that of the search. Without a reference the
/// probability of the search is used as it is: its temperatures were fitted to names.
pub fn confidence_against_reference(probability: f64) -> f64 {
    if probability <= 0.5 {
        return probability;
    }
    let c = &*CALIBRATION;
    let odds = libm::log(probability / (1.0 - probability).max(1e-12)).min(MOST);
    1.0 / (1.0 + libm::exp(-(c.constant_against_reference + c.slope_against_reference * odds)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn more_probability_is_more_confidence() {
        let mut last = 0.0;
        for p in [0.05, 0.1, 0.5, 0.9, 0.99, 1.0] {
            let here = confidence_against_reference(p);
            assert!(here > last && here <= 1.0, "{p}: {here}");
            last = here;
        }
    }
}
