//! What the verbs found last, and whether it still belongs to what is on screen.

use crate::session::Session;
use crate::session::campaign::Loaded;
use dashpot_core::Params;
use dashpot_core::family::Definition;
use dashpot_diagnosis::Diagnosis;
use dashpot_identification::Fit;
use dashpot_identification::family::FamilyFit;
use dashpot_identification::validation::Validation;
use dashpot_records::Record;
use dashpot_simulation::whole_records::{OfDiagnosis, Quality};
use std::collections::BTreeSet;
use std::sync::Arc;

/// Model, records and tests that an answer was computed from.
#[derive(Debug, Clone, PartialEq)]
pub struct Basis {
    /// The values on screen, where they count.
    params: Option<Params>,
    /// The damper over a setting behind them.
    damper: Option<Definition>,
    /// Whether each test is at its own setting, where that counts.
    own_settings: bool,
    /// How often records had been read.
    read: u64,
    unticked: BTreeSet<usize>,
}

/// An answer with what it was computed from.
pub struct Finding<T> {
    /// What was found.
    pub found: T,
    basis: Basis,
    /// What it would be computed from now.
    now: fn(&Session) -> Option<Basis>,
}

impl<T> Finding<T> {
    /// What a fit has found, from the basis that it leaves.
    pub fn of_fit(found: T, basis: Basis) -> Finding<T> {
        Finding { found, basis, now: Session::basis_of_fit }
    }

    /// What a validation has found.
    pub fn of_validation(found: T, basis: Basis) -> Finding<T> {
        Finding { found, basis, now: Session::basis }
    }

    /// What a diagnosis has found.
    pub fn of_diagnosis(found: T, basis: Basis) -> Finding<T> {
        Finding { found, basis, now: Session::basis_of_diagnosis }
    }

    /// Whether model, records or ticked tests are others by now.
    pub fn is_old(&self, session: &Session) -> bool {
        (self.now)(session).as_ref() != Some(&self.basis)
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
    /// Of a fit over a setting.
    pub family_fit: Option<Finding<Box<FamilyFit>>>,
    /// Of a validation.
    pub validation: Option<Finding<Box<Validation>>>,
    /// Of a diagnosis.
    pub diagnosis: Option<Finding<Diagnosed>>,
}

impl Session {
    /// What a validation would be computed from now; none without a model.
    ///
    /// Where every ticked test states its setting, the one on screen does not count.
    pub fn basis(&self) -> Option<Basis> {
        let basis = self.basis_of_diagnosis()?;
        let model = self.model.as_ref()?;
        let dampers = self.dampers()?;
        let ticked: Vec<&Record> = self.ticked().into_iter().filter_map(|k| self.record(k)).collect();
        let counts = model.is_tuned() || dampers.uses_shown(&ticked);
        Some(Basis { params: basis.params.filter(|_| counts), ..basis })
    }

    /// What a diagnosis would be computed from now: the damper on screen and the tests at its setting.
    pub fn basis_of_diagnosis(&self) -> Option<Basis> {
        let model = self.model.as_ref()?;
        Some(Basis {
            params: Some(*model.params()),
            damper: model.definition().copied(),
            own_settings: self.own_settings && model.over_setting().is_some(),
            read: self.read,
            unticked: self.unticked.clone(),
        })
    }

    /// The model as a fit left it, with records and tests; the setting on screen does not count.
    pub fn basis_of_fit(&self) -> Option<Basis> {
        let basis = self.basis_of_diagnosis()?;
        let model = self.model.as_ref()?;
        let counts = model.is_tuned() || model.over_setting().is_none();
        Some(Basis { params: basis.params.filter(|_| counts), own_settings: false, ..basis })
    }
}
