//! What a probability of the search is worth: of names given with it, that many were right.

use serde::Deserialize;
use std::sync::LazyLock;

/// Logistic calibration, with its origin beside it in the file.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Calibration {
    most_without_reference: f64,
    constant_against_reference: f64,
    slope_against_reference: f64,
}

static CALIBRATION: LazyLock<Calibration> = LazyLock::new(|| {
    // The file is part of the program, so only a build can be wrong; the test below reads it.
    toml::from_str(include_str!("calibration.toml")).expect("calibration.toml holds three numbers")
});

/// Log odds against a reference beyond which more is no surer.
const MOST: f64 = 8.0;

/// Probability that a name is right to which the search gives `probability`.
///
/// Below one half no name is given, so nothing is known of such names: their probability is that of the search.
pub fn confidence(probability: f64, against_reference: bool) -> f64 {
    if probability <= 0.5 {
        return probability;
    }
    let c = &*CALIBRATION;
    let odds = libm::log(probability / (1.0 - probability).max(1e-12));
    let log = if against_reference {
        c.constant_against_reference + c.slope_against_reference * odds.min(MOST)
    } else {
        odds.min(c.most_without_reference)
    };
    1.0 / (1.0 + libm::exp(-log))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn more_probability_is_more_confidence() {
        for against in [true, false] {
            let mut last = 0.0;
            for p in [0.05, 0.1, 0.5, 0.9, 0.99, 1.0] {
                let here = confidence(p, against);
                // Without a reference the last two are beyond the limit.
                let is_at_limit = !against && p == 1.0 && here == last;
                assert!((here > last || is_at_limit) && here < 0.96, "{p}: {here}");
                last = here;
            }
        }
    }
}
