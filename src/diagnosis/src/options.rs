//! What a diagnosis may do, and why there is none.

use super::effects::EFFECTS;
use super::phrases;
use dashpot_estimation::prior_set::PriorSet;
use dashpot_messages::Sentence;
use dashpot_records::Record;

/// What a diagnosis may do.
#[derive(Debug, Clone)]
pub struct Options {
    /// Most effects to add.
    pub max_effects: usize,
    /// Effects that may be named; all where `None`.
    pub candidates: Option<Vec<String>>,
    /// Records of the same tests on a damper that is known to be good: what changed is then asked, not what is missing. Empty: none.
    pub reference: Vec<Record>,
    /// What is known of this damper beside its records.
    pub priors: PriorSet,
}

impl Default for Options {
    fn default() -> Self {
        Options { max_effects: 3, candidates: None, reference: Vec::new(), priors: PriorSet::default() }
    }
}

/// Why there is no diagnosis.
#[derive(Debug, thiserror::Error)]
#[error("{}", self.sentence())]
pub enum DiagnosisError {
    /// Nothing to look at.
    NoTests,
    /// An unknown effect name.
    UnknownEffect {
        /// The name given.
        name: String,
    },
    /// The reference campaign has none of the tests.
    NothingToCompare {
        /// That the two were read as counting opposite directions positive, where that is so.
        turned: Option<Sentence>,
    },
    /// The model gives no finite force.
    NotFinite,
}

impl DiagnosisError {
    /// What is wrong and what to do, to be said in any language.
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
