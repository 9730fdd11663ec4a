//! Calibration of the search's probabilities, so that effect names with a confidence of 90 % are correct in 90 % of
//! cases.

use serde::Deserialize;
use std::sync::LazyLock;

/// Parameters of the calibration. The file `calibration.toml` states their origin.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Calibration {
    most_without_reference: f64,
    constant_against_reference: f64,
    slope_against_reference: f64,
}

static CALIBRATION: LazyLock<Calibration> = LazyLock::new(|| {
    // The file `calibration.toml` is part of the program, so parsing it fails only in a faulty build. The test of this
    // module parses it too.
    toml::from_str(include_str!("calibration.toml")).expect("calibration.toml holds three numbers")
});

/// Log odds of the search's probability above which the confidence no longer increases, in a comparison with a
/// reference.
const MOST: f64 = 8.0;

/// Returns the probability that the name of an effect is correct if the search computes `probability` for this effect.
/// `against_reference` states whether the search used a reference damper.
///
/// Effects with a probability of at most one half are never named, so there is no calibration for them. The function
/// then returns `probability` unchanged.
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
                // Without a reference, the log odds of both 0.99 and 1 exceed the limit `most_without_reference`, so
                // both have the same confidence.
                let is_at_limit = !against && p == 1.0 && here == last;
                assert!((here > last || is_at_limit) && here < 0.96, "{p}: {here}");
                last = here;
            }
        }
    }
}
