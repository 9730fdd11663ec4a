//! A diagnosis from end to end.

use super::composed::Composed;
use super::decisions::{SURE, SUSPECTED};
use super::effects::{self, EFFECTS};
use super::options::{DiagnosisError, Options};
use super::outcome::Diagnosis;
use super::prepared::{Prepared, prepare};
use super::search::{Limits, search};
use super::{calibration, opposite, phrases, warmer};
use dashpot_core::Params;
use dashpot_records::Record;
use dashpot_records::sentence::Template;

/// Diagnoses a model against records; `held_out` marks those that neither refit nor choice may see.
///
/// # Errors
/// No test to look at, an unknown name, a model without finite forces.
pub fn diagnose(
    records: &[&Record],
    held_out: &[bool],
    params: &Params,
    options: &Options,
    progress: &(dyn Fn(f64, Template) + Sync),
) -> Result<Diagnosis, DiagnosisError> {
    if let Some(name) = options.candidates.iter().flatten().find(|n| !EFFECTS.contains(&n.as_str())) {
        return Err(DiagnosisError::UnknownEffect { name: name.clone() });
    }
    progress(0.0, phrases::PREPARING);
    let mut prepared = prepare(records, held_out, params);
    if prepared.fitted.is_empty() {
        return Err(DiagnosisError::NoTests);
    }
    let reference = if options.reference.is_empty() {
        None
    } else {
        progress(0.02, phrases::FITTING_REFERENCE);
        Some(prepared.against(records, &options.reference, params)?)
    };
    let Prepared { fitted, left, base, situation } = prepared;
    let may = |effect: &str| {
        options.candidates.as_ref().is_none_or(|list| list.iter().any(|n| n == effect))
            && effects::can_be_shown(effect, &situation)
    };
    let limits = Limits { effects: options.max_effects, allowed: &may };
    let found = search(base, records, &fitted, &limits, progress).ok_or(DiagnosisError::NotFinite)?;
    progress(0.95, phrases::WHAT_IS_LEFT);
    let confidence = found.found.added.iter().map(|a| {
        let of = |samples| found.probability(a, samples);
        calibration::confidence(of(SUSPECTED), of(SURE), reference.is_some())
    });
    let confidence = confidence.collect();
    let beside = [opposite::opposite(records, &options.reference), warmer::warmer(records, &options.reference)];
    let composed = Composed {
        beside,
        records,
        fitted: &fitted,
        left: &left,
        found: &found,
        situation: &situation,
        confidence,
        reference,
    };
    let diagnosis = composed.diagnosis();
    progress(1.0, phrases::DONE);
    Ok(diagnosis)
}
