//! Diagnosis of a model, with all steps from the records to the outcome.

use super::calibration::confidence;
use super::composed::Composed;
use super::decisions::{NAMED, NEEDED};
use super::effects::{self, EFFECTS};
use super::options::{DiagnosisError, Options};
use super::outcome::Diagnosis;
use super::prepared::{Prepared, prepare};
use super::{identical, opposite, phrases, warmer};
use dashpot_core::Params;
use dashpot_estimation::refit::Effort;
use dashpot_estimation::samples::Test;
use dashpot_estimation::situation::Situation;
use dashpot_estimation::structure::context::{SearchContext, Structure};
use dashpot_estimation::structure::search::{StructureSearch, Temperatures};
use dashpot_estimation::structure::starts;
use dashpot_estimation::structure::without_doubtful::without_doubtful;
use dashpot_estimation::vocabulary::{Candidate, changes};
use dashpot_identification::{describe_roads, select_tests};
use dashpot_messages::Template;
use dashpot_records::Record;

/// Returns whether a diagnosis may use a candidate: the effect must be requested, and the records must be able to show
/// it. A candidate without an effect name is always allowed.
///
/// Two measurement errors are excluded, because only a fit identifies them: a mass on the load cell and a gain drift.
/// In the vocabulary, the mass on the load cell has the effect name `moving_mass`.
fn is_allowed(candidate: &Candidate, situation: &Situation, options: &Options) -> bool {
    if candidate.unnamed.is_some() {
        return true;
    }
    let effect = candidate.effect;
    let is_of_fit = candidate.is_artefact() && ["moving_mass", "gain_drift"].contains(&effect);
    !is_of_fit
        && options.candidates.as_ref().is_none_or(|list| list.iter().any(|name| name == effect))
        && effects::can_be_shown(effect, situation)
}

/// Diagnoses a model against records. `held_out` marks the records that refits and the search must not use.
///
/// # Errors
/// Returns an error if the records or the reference have no test, or if the name of a requested effect is unknown. Also
/// returns an error if the model gives no finite force.
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
    if let Some((selected, note)) = select_tests(records) {
        let of_it: Vec<&Record> = selected.iter().map(|place| records[*place]).collect();
        let held_out: Vec<bool> = selected.iter().map(|place| held_out.get(*place).copied().unwrap_or(false)).collect();
        let mut found = diagnose(&of_it, &held_out, params, options, progress)?;
        found.notes.push(note);
        return Ok(found);
    }
    let prepared = prepare(records, held_out, params);
    let roads = describe_roads(&prepared.fitted);
    if prepared.fitted.is_empty() {
        return Err(DiagnosisError::NoTests);
    }
    let reference_remarks = [
        identical::identical(records, &options.reference),
        opposite::opposite(records, &options.reference),
        warmer::warmer(records, &options.reference),
    ];
    let reference_remarks = reference_remarks.into_iter().flatten().collect();
    let composed = if options.reference.is_empty() {
        alone(records, prepared, params, options, progress)?
    } else {
        against_reference(records, prepared, params, options, progress)?
    };
    progress(0.95, phrases::WHAT_IS_LEFT);
    let mut diagnosis = Composed { reference_remarks, ..composed }.diagnosis();
    diagnosis.notes.extend(roads);
    progress(1.0, phrases::DONE);
    Ok(diagnosis)
}

/// Refits the given model and the most probable structure with the final accuracy. Returns `None` if one of them gives
/// no finite force.
fn finished(search: &StructureSearch, tests: &[Test]) -> Option<(Structure, Structure)> {
    let given = search.start.as_ref()?.refitted(tests, Effort::FINE)?;
    Some((given, search.best.refitted(tests, Effort::FINE)?))
}

/// Returns the predicate whether an effect is probable enough to name it.
fn is_named(search: &StructureSearch, is_against: bool) -> impl Fn(&str) -> bool + use<> {
    let at = if is_against { Temperatures::AGAINST_REFERENCE } else { Temperatures::WITHOUT_REFERENCE };
    let probabilities = search.probabilities(at);
    move |effect| confidence(probabilities.get(effect).copied().unwrap_or(0.0), is_against) >= NAMED
}

/// Returns whether a structure has additional effects but does not explain the records better than the given model.
///
/// Such a structure is more probable only because its effects are more frequent in dampers, or because it has fewer
/// parameters. The given model then counts as complete.
fn adds_without_need(given: &Structure, best: &Structure) -> bool {
    let effects = |of: &Structure| of.components.iter().map(|component| component.effect).collect::<Vec<_>>();
    is_without_need(&effects(given), &effects(best), best.evidence.log_likelihood() - given.evidence.log_likelihood())
}

/// Returns whether `best` has effects that `given` lacks, although its log likelihood is higher by less than
/// [`NEEDED`].
fn is_without_need(given: &[&str], best: &[&str], gain: f64) -> bool {
    best.iter().any(|effect| !given.contains(effect)) && gain < NEEDED
}

/// Searches for the most probable structure that explains the records, starting from the given model.
fn alone<'a>(
    records: &'a [&'a Record],
    prepared: Prepared,
    params: &Params,
    options: &'a Options,
    progress: &(dyn Fn(f64, Template) + Sync),
) -> Result<Composed<'a>, DiagnosisError> {
    progress(0.05, phrases::REFITTING);
    let Prepared { fitted, left, heating, situation } = prepared;
    let may = |candidate: &Candidate, situation: &Situation| is_allowed(candidate, situation, options);
    let context = SearchContext {
        records,
        tests: &fitted,
        is_allowed: &may,
        changes: &[],
        priors: &options.priors,
        most: options.max_effects,
        progress: &|done| progress(0.1 + 0.8 * done, phrases::EACH_EFFECT),
    };
    // The search also starts from models made from the records alone, unless the request allows only some effects or
    // none.
    let is_open = options.candidates.is_none() && options.max_effects > 0;
    let plain = if is_open { starts::plain(&fitted, &heating, &|_| true) } else { Vec::new() };
    let search = StructureSearch::run(&context, Some(starts::from_params(params, &heating)), plain);
    let search = search.ok_or(DiagnosisError::NotFinite)?;
    progress(0.9, phrases::WEIGHING);
    let (given, best) = finished(&search, &fitted).ok_or(DiagnosisError::NotFinite)?;
    let mut best = without_doubtful(&context, &given, best, &is_named(&search, false));
    if given.log_posterior >= best.log_posterior || adds_without_need(&given, &best) {
        best = given.clone();
    }
    Ok(Composed {
        reference_remarks: Vec::new(),
        records,
        fitted,
        left,
        search,
        start: given,
        best,
        situation,
        against: None,
        asked: options.candidates.as_deref(),
    })
}

/// Searches for the smallest set of changes that explains the difference from a reference.
fn against_reference<'a>(
    records: &'a [&'a Record],
    mut prepared: Prepared,
    params: &Params,
    options: &'a Options,
    progress: &(dyn Fn(f64, Template) + Sync),
) -> Result<Composed<'a>, DiagnosisError> {
    progress(0.02, phrases::FITTING_REFERENCE);
    let against = prepared.against(records, options, params)?;
    let Prepared { fitted, left, situation, .. } = prepared;
    let reference = &against.structure;
    let candidates = changes(&reference.hypothesis);
    let may = |candidate: &Candidate, situation: &Situation| {
        candidate.form == "changed" || is_allowed(candidate, situation, options)
    };
    let priors = options.priors.clone().against_reference();
    let context = SearchContext {
        records,
        tests: &fitted,
        is_allowed: &may,
        changes: &candidates,
        priors: &priors,
        most: options.max_effects,
        progress: &|done| progress(0.2 + 0.7 * done, phrases::EACH_EFFECT),
    };
    let mut same = reference.hypothesis.clone();
    same.base = reference.hypothesis.params(&reference.refit.theta);
    same.numbers.clear();
    same.heating = Some(prepared.heating.clone());
    same.priors = priors.clone();
    let search = StructureSearch::run(&context, Some((same, Vec::new())), Vec::new());
    let search = search.ok_or(DiagnosisError::NotFinite)?;
    let (given, best) = finished(&search, &fitted).ok_or(DiagnosisError::NotFinite)?;
    let best = without_doubtful(&context, &given, best, &is_named(&search, true));
    let against = Some(against);
    Ok(Composed {
        reference_remarks: Vec::new(),
        records,
        fitted,
        left,
        search,
        start: given,
        best,
        situation,
        against,
        asked: options.candidates.as_deref(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_effect_that_fits_as_well_as_one_of_the_model_is_not_missing() {
        let given = ["gas_preload", "series_compliance"];
        let exchanged = ["gas_preload", "oil_compressibility"];
        // The log likelihood falls, stays equal, or rises by more than `NEEDED`.
        assert!(is_without_need(&given, &exchanged, -3.0) && is_without_need(&given, &exchanged, 0.0));
        assert!(!is_without_need(&given, &exchanged, 2.0));
        // A structure that only removes effects is accepted regardless of the gain.
        assert!(!is_without_need(&given, &given[..1], -0.5));
    }
}
