//! What the probabilities of the rule of evidence are worth: of names given so, how many are right.

use std::sync::LazyLock;

/// What was calibrated, with where it comes from beside it.
struct Calibration {
    constant: f64,
    by_suspected: f64,
    by_sure: f64,
    against_reference: f64,
    alone: f64,
}

static CALIBRATION: LazyLock<Calibration> = LazyLock::new(|| {
    let of = |name: &str| {
        let line = include_str!("calibration.toml").lines().find(|line| line.starts_with(name));
        line.and_then(|line| line.split('=').nth(1)).and_then(|value| value.trim().parse().ok()).unwrap_or(0.0)
    };
    Calibration {
        constant: of("constant"),
        by_suspected: of("suspected"),
        by_sure: of("sure ="),
        against_reference: of("surest_against_reference"),
        alone: of("surest_alone"),
    }
});

/// Logarithm of the odds beyond which more is no surer.
const MOST: f64 = 8.0;

/// Probability that a name is right to which the rule gives `suspected` where each test counts as two independent samples and `sure`
/// where it counts as one; `against` where a reference campaign took out what both dampers share.
pub fn confidence(suspected: f64, sure: f64, against: bool) -> f64 {
    let c = &*CALIBRATION;
    // No more than as many as were right where it was surest.
    before_limit(suspected, sure) * if against { c.against_reference } else { c.alone }
}

/// The same before it is held to what was right where it was surest: from one half on a name is more likely right than not.
pub fn before_limit(suspected: f64, sure: f64) -> f64 {
    let odds = |p: f64| libm::log(p.max(1e-12) / (1.0 - p).max(1e-12)).clamp(-MOST, MOST);
    let c = &*CALIBRATION;
    let log = c.constant + c.by_suspected * odds(suspected) + c.by_sure * odds(sure);
    1.0 / (1.0 + libm::exp(-log))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn more_evidence_is_more_confidence_and_never_more_than_was_right() {
        let c = &*CALIBRATION;
        assert!(c.by_suspected > 0.0 && c.by_sure > 0.0 && c.alone < c.against_reference && c.against_reference < 1.0);
        for (against, most) in [(true, c.against_reference), (false, c.alone)] {
            let mut last = 0.0;
            for p in [0.1, 0.5, 0.9, 0.99, 1.0] {
                let here = confidence(p, 0.5 * p, against);
                assert!(here > last && here <= most, "{p}: {here}");
                last = here;
            }
            assert!(confidence(1.0, 1.0, against) > 0.99 * most);
        }
    }
}
