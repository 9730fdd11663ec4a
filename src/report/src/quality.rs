//! Rating of a fit in one sentence, in comparison with the noise and with the FV curve alone.

use crate::numbers::digits;
use crate::words::Words;
use dashpot_simulation::whole_records::Quality;

/// Largest ratio of the model's mean error to the noise at which noise explains the error. The error of the model itself is then at most
/// three quarters of the noise. A larger ratio indicates a deficiency of the model.
const NOISE: f64 = 1.25;
/// Largest mean error that is rated as good, percent of a test's largest force. A damper repeats within 1 to 2 % from test to test (Dixon,
/// *The Shock Absorber Handbook*, 2007, chapter 10).
const GOOD: f64 = 2.0;
/// Largest mean error that is rated as fair, percent of a test's largest force. With a larger error, the model probably lacks friction, gas
/// or hysteresis.
const FAIR: f64 = 5.0;
/// Smallest ratio of the FV curve's error to the model's error at which the model counts as better than the FV curve.
const BETTER: f64 = 1.05;

/// Formats a rating of the model's error, in comparison with the noise and with the error of the FV curve, as a sentence.
pub fn sentence(quality: &Quality, words: &Words) -> String {
    let Quality { model, fv_only, noise_n } = quality;
    let by_noise = model.mean_error_n / noise_n;
    let is_known = by_noise.is_finite();
    let no_better = fv_only.mean_error_n < BETTER * model.mean_error_n;
    let grade = grade(by_noise, model.error_percent, !no_better, words);
    let beside = if is_known {
        let text = if by_noise > NOISE { words.quality_beyond_noise } else { words.quality_beside_noise };
        words.fill(text, &[("ratio", &digits(by_noise, 2)), ("noise", &digits(*noise_n, 2))])
    } else {
        words.quality_noise_unknown.to_owned()
    };
    let curve = if no_better { words.quality_curve_no_worse } else { words.quality_curve_worse };
    let curve = words.fill(
        curve,
        &[
            ("error", &digits(fv_only.mean_error_n, 3)),
            ("percent", &digits(fv_only.error_percent, 2)),
            ("ratio", &digits(fv_only.mean_error_n / model.mean_error_n, 2)),
        ],
    );
    words.fill(
        words.quality_sentence,
        &[
            ("grade", grade),
            ("error", &digits(model.mean_error_n, 3)),
            ("percent", &digits(model.error_percent, 2)),
            ("beside", &beside),
            ("curve", &curve),
        ],
    )
}

/// Rates an error by its ratio to the noise (NaN if the noise is unknown) and by its percentage of the largest force. A rating of fair
/// becomes poor if the model is not better than the FV curve.
pub fn grade(by_noise: f64, percent: f64, is_better: bool, words: &Words) -> &str {
    if by_noise <= NOISE {
        words.quality_noise
    } else if percent <= GOOD {
        words.quality_good
    } else if percent <= FAIR && is_better {
        words.quality_fair
    } else {
        words.quality_poor
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::words::{EN, Language};
    use dashpot_identification::validation::Deviation;

    fn of(model: [f64; 2], curve: [f64; 2], noise_n: f64) -> Quality {
        let deviation = |[mean_error_n, error_percent]: [f64; 2]| Deviation {
            mean_error_n,
            error_percent,
            region1_n: 0.0,
            region2_n: 0.0,
            rmse_n: mean_error_n,
        };
        Quality { model: deviation(model), fv_only: deviation(curve), noise_n }
    }

    #[test]
    fn it_says_good_or_bad_beside_noise_and_curve() {
        for (quality, begins, holds) in [
            (
                of([4.0, 0.5], [40.0, 5.0], 3.2),
                "As good as the noise allows",
                "1.2 times the noise of the records (3.2 N)",
            ),
            (
                of([12.0, 1.2], [40.0, 5.0], 1.0),
                "Good",
                "12 times the noise of the records (1.0 N), so the tests show more",
            ),
            (of([12.0, 1.2], [40.0, 5.0], 0.0), "Good", "3.3 times as much"),
            (of([40.0, 4.0], [80.0, 8.0], 1.0), "Fair", "2.0 times as much"),
            (of([40.0, 4.0], [40.0, 4.0], 1.0), "Poor", "about as good or better"),
            (of([90.0, 9.0], [180.0, 18.0], 1.0), "Poor", "2.0 times as much"),
        ] {
            let text = sentence(&quality, &EN);
            assert!(text.starts_with(begins) && text.contains(holds), "{text}");
        }
        let german = sentence(&of([4.0, 0.5], [40.0, 5.0], 3.2), Language::German.words());
        assert!(german.contains("3,2 N") && german.contains("FV-Kurve"), "{german}");
    }
}
