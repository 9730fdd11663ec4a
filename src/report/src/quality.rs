//! Rating of a fit in one sentence, in comparison with the noise and with the FV curve alone.

use crate::numbers::digits;
use crate::words::Words;
use dashpot_identification::validation::{Deviation, Errors};
use dashpot_simulation::whole_records::{Quality, TestQuality};

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
    let Quality { model, fv_only, noise_n, tests } = quality;
    let by_noise = model.mean_error_n / noise_n;
    let is_known = by_noise.is_finite();
    let no_better = !is_better(model, fv_only);
    let of_mean = Grade::new(by_noise, model.error_percent, !no_better);
    let worst = tests
        .iter()
        .map(|test| (Grade::of_test(test), test))
        .max_by(|(a, one), (b, other)| {
            let percent = |test: &TestQuality| test.errors.model.error_percent;
            a.cmp(b).then(percent(one).total_cmp(&percent(other)))
        })
        .filter(|(grade, _)| *grade > of_mean);
    let grade = worst.map_or(of_mean, |(of_worst, _)| of_mean.max(of_worst.one_better()));
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
    let of_all = words.fill(
        words.quality_sentence,
        &[
            ("grade", grade.word(words)),
            ("error", &digits(model.mean_error_n, 3)),
            ("percent", &digits(model.error_percent, 2)),
            ("beside", &beside),
            ("curve", &curve),
        ],
    );
    let of_worst = worst.map(|(_, TestQuality { name, errors, .. })| {
        let values = [
            ("test", name.as_str()),
            ("error", &digits(errors.model.mean_error_n, 3)),
            ("percent", &digits(errors.model.error_percent, 2)),
            ("curve", &digits(errors.fv_only.mean_error_n, 3)),
        ];
        words.fill(words.quality_worst, &values)
    });
    [Some(of_all), of_worst].into_iter().flatten().collect::<Vec<_>>().join(" ")
}

/// Returns whether the model has a clearly smaller error than the FV curve.
fn is_better(model: &Deviation, fv_only: &Deviation) -> bool {
    fv_only.mean_error_n >= BETTER * model.mean_error_n
}

/// Rating of an error, best first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Grade {
    Noise,
    Good,
    Fair,
    Poor,
}

impl Grade {
    /// Rates an error by its ratio to the noise (NaN if the noise is unknown) and by its percentage of the largest force. A rating of fair
    /// becomes poor if the model is not better than the FV curve.
    fn new(by_noise: f64, percent: f64, is_better: bool) -> Grade {
        match () {
            () if by_noise <= NOISE => Grade::Noise,
            () if percent <= GOOD => Grade::Good,
            () if percent <= FAIR && is_better => Grade::Fair,
            () => Grade::Poor,
        }
    }

    fn of_test(test: &TestQuality) -> Grade {
        let Errors { model, fv_only } = &test.errors;
        Grade::new(model.mean_error_n / test.noise_n, model.error_percent, is_better(model, fv_only))
    }

    /// Returns the rating above this one. The rating of a fit is at most one better than that of its worst test. A small mean conceals a
    /// test that the model misses. Test: `one_test_that_is_missed_spoils_the_rating_and_is_named`.
    fn one_better(self) -> Grade {
        match self {
            Grade::Noise | Grade::Good => Grade::Noise,
            Grade::Fair => Grade::Good,
            Grade::Poor => Grade::Fair,
        }
    }

    fn word(self, words: &Words) -> &str {
        match self {
            Grade::Noise => words.quality_noise,
            Grade::Good => words.quality_good,
            Grade::Fair => words.quality_fair,
            Grade::Poor => words.quality_poor,
        }
    }
}

/// Rates an error by its ratio to the noise (NaN if the noise is unknown) and by its percentage of the largest force. A rating of fair
/// becomes poor if the model is not better than the FV curve.
pub fn grade(by_noise: f64, percent: f64, is_better: bool, words: &Words) -> &str {
    Grade::new(by_noise, percent, is_better).word(words)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::words::{EN, Language};

    fn deviation([mean_error_n, error_percent]: [f64; 2]) -> Deviation {
        Deviation { mean_error_n, error_percent, region1_n: 0.0, region2_n: 0.0, rmse_n: mean_error_n }
    }

    fn of(model: [f64; 2], curve: [f64; 2], noise_n: f64) -> Quality {
        Quality { model: deviation(model), fv_only: deviation(curve), noise_n, tests: Vec::new() }
    }

    #[test]
    fn one_test_that_is_missed_spoils_the_rating_and_is_named() {
        let test = |name: &str, model: [f64; 2], curve: [f64; 2]| TestQuality {
            name: name.to_owned(),
            errors: Errors { model: deviation(model), fv_only: deviation(curve) },
            noise_n: 2.0,
        };
        let fine = test("fine", [10.0, 0.8], [90.0, 6.0]);
        let all = |tests: &[TestQuality]| {
            let quality = Quality { tests: tests.to_vec(), ..of([18.0, 1.0], [90.0, 6.0], 2.0) };
            sentence(&quality, &EN)
        };
        assert!(all(&[fine.clone()]).starts_with("Good fit") && !all(&[fine.clone()]).contains("fine"));
        let said = all(&[fine.clone(), test("road", [310.0, 12.0], [420.0, 17.0])]);
        assert!(said.starts_with("Fair fit") && said.contains("worst in road: 310 N on average (12 %"), "{said}");
        // A test that is only fair, or a weak one at the level of the noise, leaves the rating good.
        let said = all(&[fine.clone(), test("slow", [12.0, 3.0], [40.0, 10.0])]);
        assert!(said.starts_with("Good fit") && said.contains("worst in slow"), "{said}");
        let said = all(&[fine, test("weak", [2.0, 9.0], [2.1, 9.2])]);
        assert!(said.starts_with("Good fit") && !said.contains("weak"), "{said}");
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
