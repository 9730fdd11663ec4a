//! Improved model of a diagnosis as a [`Fit`], so that the code for fits also writes, reads and reports it.

use super::name_of::name_of;
use super::outcome::Diagnosis;
use super::phrases;
use super::wording::{percent, physical};
use dashpot_estimation::campaign_clock::clock_from;
use dashpot_estimation::hypothesis::Free;
use dashpot_estimation::structure::context::Structure;
use dashpot_estimation::unknowns::Unknown;
use dashpot_identification::literature::{fv_curve, observation::of_records};
use dashpot_identification::model_file::ModelFile;
use dashpot_identification::{Estimate, Fit, Measured, Standing};
use dashpot_messages::Sentence;
use dashpot_records::Record;
use dashpot_records::measurement_correction::MeasurementError;

/// Returns estimates of the free scalar parameters of the damper in the structure `found`, with the 95 % intervals
/// `ends`. If `ends` is `None`, the estimates have no intervals and count as not identified.
pub(super) fn estimates(found: &Structure, ends: Option<&[[f64; 2]]>) -> Vec<Estimate> {
    let (last, end) = (&found.hypothesis, &found.refit);
    last.numbers
        .iter()
        .enumerate()
        .filter_map(|(k, number)| {
            let Free::Model(Unknown::Log(_) | Unknown::Linear(_)) = &number.free else { return None };
            let at = |t: f64| physical(&number.free, t);
            let (name, unit) = name_of(&number.free);
            let ends = ends.map(|ends| ends[k].map(at));
            Some(Estimate {
                name,
                index: None,
                value: at(end.theta[k]),
                low: ends.map(|ends| ends[0]),
                high: ends.map(|ends| ends[1]),
                unit,
                from: phrases::ALL_FITTED_TESTS.into(),
                standing: if ends.is_some() { Standing::Identified } else { Standing::NotIdentified },
            })
        })
        .collect()
}

/// Returns the measurement errors in the structure `found` that can be corrected when records are read. `ends` contains
/// the 95 % intervals of its free parameters.
pub(super) fn measured(found: &Structure, ends: &[[f64; 2]]) -> Vec<Measured> {
    let (last, end) = (&found.hypothesis, &found.refit);
    let numbers = last.numbers.iter().enumerate();
    numbers
        .filter_map(|(k, number)| {
            let Free::Rig(artefact) = &number.free else { return None };
            let value = end.theta[k];
            let [low, high] = ends[k];
            Measured::from_artefact(*artefact, [value, low, high])
        })
        .collect()
}

/// Combines the measurement errors for which the records were already corrected with those that the diagnosis found.
///
/// The records were corrected for the errors in `fit`, which come from the fit of the model. For an error that `fit`
/// lacks, they were corrected by the value in `given`, which the user stated.
fn of_both(fit: Vec<Measured>, given: &MeasurementError, diagnosis: &[Measured]) -> Vec<Measured> {
    let mut all = fit;
    for found in diagnosis {
        match all.iter_mut().find(|m| m.name == found.name) {
            Some(own) => *own = own.and(*found),
            None => all.push(found.with_stated(given)),
        }
    }
    all
}

impl Diagnosis {
    /// Returns the improved model as a fit to the records that were not left out.
    ///
    /// The fit contains a plain FV curve of these records. It also contains the measurement errors from the fit of the
    /// diagnosed model and from this diagnosis.
    pub fn as_fit(&self, records: &[&Record], held_out: &[bool], model: &ModelFile) -> Fit {
        let used: Vec<&Record> = records
            .iter()
            .zip(held_out.iter().chain(std::iter::repeat(&false)))
            .filter(|(_, out)| !**out)
            .map(|(r, _)| *r)
            .collect();
        let mut notes = vec![Sentence::from(phrases::DIAGNOSIS).with_sentence("answer", self.summary.clone())];
        notes.extend(self.findings.iter().map(|f| {
            let place = if f.of_the_rig { phrases::OF_THE_RIG } else { phrases::ADDED };
            Sentence::from(place).with("effect", f.effect).with("percent", percent(f.confidence))
        }));
        Fit {
            params: self.improved,
            estimates: self.estimates.clone(),
            inventory: self.inventory.clone(),
            measured: of_both(
                if used.iter().any(|r| r.original_fingerprint.is_some()) {
                    model.identification.measured()
                } else {
                    Vec::new()
                },
                &MeasurementError::stated(records),
                &self.measured,
            ),
            clock_from: clock_from(&used),
            priors: self.priors.clone(),
            notes,
            tests: used.iter().map(|r| r.name.clone()).collect(),
            fingerprints: used.iter().map(|r| r.fingerprint()).collect(),
            // The plain FV curve is fitted again, because the curve in the file of the diagnosed model is unsuitable.
            // With a reference, that curve belongs to another damper. Without a fit, it is the FV curve of the model,
            // without friction.
            fv_only: fv_curve::fit(&of_records(&used)).params(),
            misfit: self.after.rmse_n / self.after.noise_n.max(1e-9),
        }
    }
}
