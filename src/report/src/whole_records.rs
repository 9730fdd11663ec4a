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

/// Formats the errors of the given, the refitted and the improved model of a diagnosis as a sentence.
pub fn format_errors(of: &OfDiagnosis, words: &Words) -> String {
    let [came, refitted, improved] = [&of.as_it_came, &of.refitted, &of.improved].map(|d| in_words(d, words));
    // Without an added effect, the improved model is the refitted one.
    if of.improved == of.refitted {
        return words.fill(words.whole_records_refitted, &[("came", &came), ("refitted", &refitted)]);
    }
    words.fill(words.whole_records, &[("came", &came), ("refitted", &refitted), ("improved", &improved)])
}
