//! Options and errors of a diagnosis.

use super::effects::EFFECTS;
use super::phrases;
use dashpot_estimation::prior_set::PriorSet;
use dashpot_messages::Sentence;
use dashpot_records::Record;

/// Options of a diagnosis.
#[derive(Debug, Clone)]
pub struct Options {
    /// Largest number of rare effects to add, such as faults. With 0, no effect is added.
    pub max_effects: usize,
    /// Effects that the diagnosis may name. `None` means all effects.
    pub candidates: Option<Vec<String>>,
    /// Records of the same tests on a good damper. The diagnosis then searches for changes instead of missing effects.
    /// Empty if there is no reference.
    pub reference: Vec<Record>,
    /// Prior knowledge of this damper, in addition to its records.
    pub priors: PriorSet,
}

impl Default for Options {
    fn default() -> Self {
        Options { max_effects: 3, candidates: None, reference: Vec::new(), priors: PriorSet::default() }
    }
}

/// Error of a diagnosis.
#[derive(Debug, thiserror::Error)]
#[error("{}", self.sentence())]
pub enum DiagnosisError {
    /// There is no test.
    NoTests,
    /// An effect name is unknown.
    UnknownEffect {
        /// The unknown name.
        name: String,
    },
    /// The reference campaign has no test.
    NothingToCompare {
        /// Note if the campaign and the reference were read with opposite positive directions.
        turned: Option<Sentence>,
    },
    /// The model gives no finite force.
    NotFinite,
}

impl DiagnosisError {
    /// Returns the error and its remedy as a sentence that can be translated.
    pub fn sentence(&self) -> Sentence {
        match self {
            DiagnosisError::NoTests => phrases::NO_TESTS.into(),
            DiagnosisError::UnknownEffect { name } => Sentence::from(phrases::UNKNOWN_NAME)
                .with("name", format!("{name:?}"))
                .with_names("known", EFFECTS, phrases::COMMA),
            DiagnosisError::NothingToCompare { turned } => {
                let turned = turned.clone().map(|said| Sentence::from(phrases::BESIDES).with_sentence("said", said));
                Sentence::from(phrases::NOTHING_TO_COMPARE).with_any("turned", turned)
            }
            DiagnosisError::NotFinite => phrases::NOT_FINITE.into(),
        }
    }
}
