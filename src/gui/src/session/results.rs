//! What the verbs found last, and whether it still belongs to what is on screen.

use crate::session::Session;
use crate::session::campaign::Loaded;
use dashpot_core::Params;
use dashpot_diagnosis::Diagnosis;
use dashpot_identification::Fit;
use dashpot_identification::validation::Validation;
use dashpot_simulation::whole_records::{OfDiagnosis, Quality};
use std::collections::BTreeSet;
use std::sync::Arc;

/// Model, records and tests that an answer was computed from.
#[derive(Debug, Clone, PartialEq)]
pub struct Basis {
    params: Params,
    /// How often records had been read.
    read: u64,
    unticked: BTreeSet<usize>,
}

/// An answer with what it was computed from.
pub struct Finding<T> {
    /// What was found.
    pub found: T,
    basis: Basis,
}

impl<T> Finding<T> {
    /// An answer that was computed from this.
    pub fn new(found: T, basis: Basis) -> Finding<T> {
        Finding { found, basis }
    }

    /// Whether model, records or ticked tests are others by now.
    pub fn is_old(&self, session: &Session) -> bool {
        session.basis().as_ref() != Some(&self.basis)
    }
}

/// What a fit found, and how good it is.
pub struct Fitted {
    /// The fit.
    pub fit: Box<Fit>,
    /// Beside the noise and beside the plain curve; none where the records cannot be compared.
    pub quality: Option<Quality>,
}

/// A diagnosis with what it was made from.
pub struct Diagnosed {
    /// The answer.
    pub found: Box<Diagnosis>,
    /// Which tests no refit saw.
    pub left_out: Vec<bool>,
    /// Errors of the models in it over every sample of the tests.
    pub over_whole_records: OfDiagnosis,
    /// The campaign that it was compared with, where there was one: another may be open by the time that the report is written.
    pub reference: Option<Arc<Loaded>>,
}

/// What the verbs found last.
#[derive(Default)]
pub struct Results {
    /// Of a fit: choices, estimates, notes.
    pub fit: Option<Finding<Fitted>>,
    /// Of a validation.
    pub validation: Option<Finding<Box<Validation>>>,
    /// Of a diagnosis.
    pub diagnosis: Option<Finding<Diagnosed>>,
}

impl Session {
    /// What an answer would be computed from now; none without a model.
    pub fn basis(&self) -> Option<Basis> {
        let params = *self.model.as_ref()?.params();
        Some(Basis { params, read: self.read, unticked: self.unticked.clone() })
    }
}
