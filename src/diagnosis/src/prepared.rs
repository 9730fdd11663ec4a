//! Records and model made ready to be looked at, and the same against a reference.

use super::options::DiagnosisError;
use super::situation::Situation;
use super::{opposite, reference, vocabulary};
use dashpot_core::Params;
use dashpot_estimation::gap::errors;
use dashpot_estimation::heating::Heating;
use dashpot_estimation::hypothesis::Hypothesis;
use dashpot_estimation::refit;
use dashpot_estimation::samples::{self, Test};
use dashpot_estimation::sensitivity::Accuracy;
use dashpot_records::Record;
use std::sync::Arc;

/// What a diagnosis looks at.
pub(super) struct Prepared {
    /// Tests that refits see.
    pub fitted: Vec<Test>,
    /// Those left out.
    pub left: Vec<Test>,
    /// The model as it came.
    pub base: Hypothesis,
    /// What the tests show.
    pub situation: Situation,
}

/// Tests, model and situation of records.
pub(super) fn prepare(records: &[&Record], held_out: &[bool], params: &Params) -> Prepared {
    let all = samples::as_long_as_remembered(samples::tests(records), params);
    let out = |test: &Test| held_out.get(test.record).copied().unwrap_or(false);
    let (left, fitted): (Vec<Test>, Vec<Test>) = all.into_iter().partition(out);
    let heating = Heating::new(records, &fitted);
    let situation = Situation::new(params, records, &fitted);
    let base =
        Hypothesis { base: *params, numbers: vocabulary::base_numbers(params), heating: Some(Arc::new(heating)) };
    Prepared { fitted, left, base, situation }
}

/// The model as the reference damper has it.
pub(super) struct Against {
    /// Explanation and refit.
    pub base: (Hypothesis, refit::Refit),
    /// Tests that the reference campaign does not have.
    pub missing: Vec<String>,
}

impl Prepared {
    /// Takes what the model leaves of the same tests on the reference out of the comparison, and starts from the model fitted to it.
    pub fn against(
        &mut self,
        records: &[&Record],
        reference: &[Record],
        params: &Params,
    ) -> Result<Against, DiagnosisError> {
        let good: Vec<&Record> = reference.iter().collect();
        let mut own = prepare(&good, &[], params);
        own.base.heating = None;
        let start = own.base.start();
        let fine = refit::refit(&own.base, &own.fitted, &start, None, refit::Effort::FINE);
        let fine = fine.ok_or(DiagnosisError::NotFinite)?;
        // By the integration of the refits: where it is not exact, it is off by the same on both dampers, and with another one the numbers
        // of a damper would move against themselves.
        let residual = errors(Accuracy::Single, &own.base, &fine.theta, &good, &own.fitted);
        let residual = residual.ok_or(DiagnosisError::NotFinite)?;
        let correct = |tests: &mut Vec<Test>| {
            let (kept, missing) = reference::without_shared_error(std::mem::take(tests), &own.fitted, &residual);
            *tests = kept;
            missing
        };
        let mut missing = correct(&mut self.fitted);
        missing.extend(correct(&mut self.left));
        if self.fitted.is_empty() {
            let turned = opposite::opposite(records, reference);
            return Err(DiagnosisError::NothingToCompare { turned });
        }
        // What a test was heated by is counted by its place among the tests.
        if let Some(heating) = &mut self.base.heating {
            *heating = Arc::new(heating.of_tests(&self.fitted));
        }
        self.base = self.base.clone().starting_at(&fine.theta);
        let base = (own.base.starting_at(&fine.theta), fine);
        Ok(Against { base, missing })
    }
}
