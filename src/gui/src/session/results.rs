//! The last results of fit, validation and diagnosis, and whether they match the model and tests on screen.

use crate::session::Session;
use crate::session::campaign::Loaded;
use dashpot_core::Params;
use dashpot_core::family::Definition;
use dashpot_diagnosis::Diagnosis;
use dashpot_identification::Fit;
use dashpot_identification::family::FamilyFit;
use dashpot_identification::validation::Validation;
use dashpot_records::{Record, SettingRules};
use dashpot_simulation::whole_records::{OfDiagnosis, Quality};
use std::cmp::Reverse;
use std::collections::BTreeSet;
use std::sync::Arc;
use std::time::Instant;

/// Model, records and tests from which a result was computed.
#[derive(Debug, Clone, PartialEq)]
pub struct Basis {
    /// Parameter values on screen, or `None` if the result does not depend on them.
    params: Option<Params>,
    /// The adjustable damper to which these values belong.
    damper: Option<Definition>,
    /// Whether each test has its own setting, if the result depends on that.
    own_settings: bool,
    /// Number of times that records were read before the result.
    read: u64,
    /// Number of times that a reference was read before the result; `None` without a reference, or if the result does not depend on it.
    reference: Option<u64>,
    unticked: BTreeSet<usize>,
    /// Rules for the settings of the tests, with the corrections by hand.
    settings: SettingRules,
}

/// A result with its basis.
pub struct Finding<T> {
    /// The result.
    pub found: T,
    basis: Basis,
    /// Function that returns the basis that this kind of result would have now.
    now: fn(&Session) -> Option<Basis>,
    /// Instant at which the result arrived.
    arrived: Instant,
}

impl<T> Finding<T> {
    /// Makes a [`Finding`] from the result of a fit and its [`Basis`].
    pub fn of_fit(found: T, basis: Basis) -> Finding<T> {
        Finding { found, basis, now: Session::basis_of_fit, arrived: Instant::now() }
    }

    /// Makes a [`Finding`] from the result of a validation and its [`Basis`].
    pub fn of_validation(found: T, basis: Basis) -> Finding<T> {
        Finding { found, basis, now: Session::basis, arrived: Instant::now() }
    }

    /// Makes a [`Finding`] from the result of a diagnosis and its [`Basis`].
    pub fn of_diagnosis(found: T, basis: Basis) -> Finding<T> {
        Finding { found, basis, now: Session::basis_of_diagnosis, arrived: Instant::now() }
    }

    /// Returns whether model, records or ticked tests have changed since the result.
    pub fn is_old(&self, session: &Session) -> bool {
        (self.now)(session).as_ref() != Some(&self.basis)
    }
}

/// Result and quality of a fit.
pub struct Fitted {
    /// The fit.
    pub fit: Box<Fit>,
    /// Errors of the model and of the FV curve alone, and the noise; `None` if the records are not comparable.
    pub quality: Option<Quality>,
}

/// A diagnosis with its inputs.
pub struct Diagnosed {
    /// The diagnosis.
    pub found: Box<Diagnosis>,
    /// For each test, whether it was held out from every refit.
    pub left_out: Vec<bool>,
    /// Errors of the given, the refitted and the improved model over every sample of the tests.
    pub over_whole_records: OfDiagnosis,
    /// Setting of the slider with its unit, if the tests of the other settings of an adjustable damper were not diagnosed.
    pub only_at: Option<String>,
    /// The reference campaign of the diagnosis, if any. Another reference may be open when the report is written.
    pub reference: Option<Arc<Loaded>>,
}

/// The last results of fit, validation and diagnosis.
#[derive(Default)]
pub struct Results {
    /// Last fit of an ordinary damper.
    pub fit: Option<Finding<Fitted>>,
    /// Last fit of an adjustable damper.
    pub family_fit: Option<Finding<Box<FamilyFit>>>,
    /// Last validation.
    pub validation: Option<Finding<Box<Validation>>>,
    /// Last diagnosis.
    pub diagnosis: Option<Finding<Diagnosed>>,
}

/// Kind of a result.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// Fit of an ordinary damper.
    Fit,
    /// Fit of an adjustable damper.
    FamilyFit,
    /// Validation.
    Validation,
    /// Diagnosis.
    Diagnosis,
}

impl Results {
    /// Returns the kinds of the available results in the order of their display. Results that are out of date come last. Within each group,
    /// a newer result comes first.
    pub fn order(&self, session: &Session) -> Vec<Kind> {
        let mut all: Vec<(bool, Reverse<Instant>, Kind)> = Vec::new();
        all.extend(self.fit.as_ref().map(|of| (of.is_old(session), Reverse(of.arrived), Kind::Fit)));
        all.extend(self.family_fit.as_ref().map(|of| (of.is_old(session), Reverse(of.arrived), Kind::FamilyFit)));
        all.extend(self.validation.as_ref().map(|of| (of.is_old(session), Reverse(of.arrived), Kind::Validation)));
        all.extend(self.diagnosis.as_ref().map(|of| (of.is_old(session), Reverse(of.arrived), Kind::Diagnosis)));
        all.sort_by_key(|(is_old, arrived, _)| (*is_old, *arrived));
        all.into_iter().map(|(.., kind)| kind).collect()
    }
}

impl Session {
    /// Returns the basis of a validation at present, or `None` without a model. If every ticked test has its own setting and no value is
    /// tuned, the basis contains no parameter values.
    pub fn basis(&self) -> Option<Basis> {
        let basis = self.basis_of_diagnosis()?;
        let model = self.model.as_ref()?;
        let dampers = self.dampers()?;
        let ticked: Vec<&Record> = self.ticked().into_iter().filter_map(|k| self.record(k)).collect();
        let counts = model.is_tuned() || dampers.uses_shown(&ticked);
        Some(Basis { params: basis.params.filter(|_| counts), reference: None, ..basis })
    }

    /// Returns the basis of a diagnosis at present: the damper on screen, the tests at its setting and the reference.
    pub fn basis_of_diagnosis(&self) -> Option<Basis> {
        let model = self.model.as_ref()?;
        Some(Basis {
            params: Some(*model.params()),
            damper: model.definition().copied(),
            own_settings: self.own_settings && model.over_setting().is_some(),
            read: self.read,
            reference: self.reference.as_ref().map(|_| self.read_reference),
            unticked: self.unticked.clone(),
            settings: self.corrections.rules().clone(),
        })
    }

    /// Returns the basis of a fit at present: fitted model, records and tests. The values of an untuned adjustable damper are not part of
    /// the basis, because the setting on screen does not affect a fit.
    pub fn basis_of_fit(&self) -> Option<Basis> {
        let basis = self.basis_of_diagnosis()?;
        let model = self.model.as_ref()?;
        let counts = model.is_tuned() || model.over_setting().is_none();
        Some(Basis { params: basis.params.filter(|_| counts), own_settings: false, reference: None, ..basis })
    }
}
