//! How far models are off over whole records, in words.

use crate::numbers::digits;
use dashpot_identification::validation::Deviation;
use dashpot_simulation::whole_records::OfDiagnosis;

/// One model: "12.3 N mean (0.46 %)".
pub fn in_words(deviation: &Deviation) -> String {
    format!("{} N mean ({} %)", digits(deviation.mean_error_n, 3), digits(deviation.error_percent, 2))
}

/// The models of a diagnosis in a sentence.
pub fn told(of: &OfDiagnosis) -> String {
    format!(
        "Over every sample of all records, as dashpot validate measures: {} as the model came, {} refitted, {} improved. The figures \
         above are of mean cycles, in which noise is averaged out.",
        in_words(&of.as_it_came),
        in_words(&of.refitted),
        in_words(&of.improved)
    )
}
