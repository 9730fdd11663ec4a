//! Formats the errors of models over whole records as text.

use crate::numbers::digits;
use crate::words::Words;
use dashpot_identification::validation::Deviation;
use dashpot_simulation::whole_records::OfDiagnosis;

/// Formats the error of one model: "12.3 N mean (0.46 %)".
pub fn in_words(deviation: &Deviation, words: &Words) -> String {
    let (error, percent) = (digits(deviation.mean_error_n, 3), digits(deviation.error_percent, 2));
    words.fill(words.whole_deviation, &[("error", &error), ("percent", &percent)])
}

/// Smallest ratio of the errors of the given and of the refitted model at which the given model is of another damper.
///
/// A refit of a model that was fitted to the same records changes the error by some percent, and one to other tests of
/// the same damper by up to a half. Test: `a_model_of_another_damper_is_said_to_be_one`.
const OTHER: f64 = 3.0;

/// States that the given model describes another damper than the records. Returns `None` if it describes the same.
pub fn of_another_damper(of: &OfDiagnosis, words: &Words) -> Option<String> {
    let is_other = of.as_it_came.mean_error_n > OTHER * of.refitted.mean_error_n;
    let [came, refitted] = [&of.as_it_came, &of.refitted].map(|d| in_words(d, words));
    is_other.then(|| words.fill(words.whole_records_other, &[("came", &came), ("refitted", &refitted)]))
}

/// Formats the errors of the given, the refitted and the improved model of a diagnosis as a sentence.
pub fn format_errors(of: &OfDiagnosis, words: &Words) -> String {
    let [came, refitted, improved] = [&of.as_it_came, &of.refitted, &of.improved].map(|d| in_words(d, words));
    // Without an added effect, the improved model is the refitted one.
    if of.improved == of.refitted {
        return words.fill(words.whole_records_refitted, &[("came", &came), ("refitted", &refitted)]);
    }
    words.fill(words.whole_records, &[("came", &came), ("refitted", &refitted), ("improved", &improved)])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::words::EN;

    #[test]
    fn a_model_of_another_damper_is_said_to_be_one() {
        let of =
            |mean_error_n: f64| Deviation { mean_error_n, error_percent: 0.1 * mean_error_n, ..Deviation::default() };
        let said = |came: f64, refitted: f64| {
            let all = OfDiagnosis { as_it_came: of(came), refitted: of(refitted), improved: of(refitted) };
            of_another_damper(&all, &EN)
        };
        assert_eq!(said(12.0, 8.0), None);
        assert_eq!(said(0.0, 0.0), None);
        let text = said(319.0, 9.4).unwrap();
        assert!(text.contains("319 N mean (32 %)") && text.contains("9.40 N mean"), "{text}");
    }
}
