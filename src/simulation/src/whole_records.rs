//! Errors of a model over whole records.
//!
//! A fit, a validation and a diagnosis all report these errors, so their figures are comparable.
//!
//! The internal figures of a fit and a diagnosis are smaller than those of a validation. This is because mean cycles average out the noise,
//! and a diagnosis first refits the model. A validation uses every sample of every record and begins in the steady state.

use crate::comparison::without_actuator;
use crate::prediction::{predict, predict_family};
use crate::warm_starts::WarmStarts;
use dashpot_core::Params;
use dashpot_identification::family::FamilyFit;
use dashpot_identification::model_file::{NoModel, prepared, prepared_family};
use dashpot_identification::validation::{
    Compared, Deviation, Errors, TestValidation, Validation, ValidationError, validate,
};
use dashpot_identification::{Fit, Measured, to_measurement_error};
use dashpot_records::measurement_correction::correct_record;
use dashpot_records::smoothing::smooth;
use dashpot_records::{Record, is_same_setting};
use rayon::prelude::*;
use serde::Serialize;

/// Reason why errors over whole records cannot be computed.
#[derive(Debug, thiserror::Error)]
pub enum WholeRecordsError {
    /// The parameters do not form a valid model.
    #[error(transparent)]
    Model(#[from] NoModel),
    /// The records cannot be compared with a model.
    #[error(transparent)]
    Records(#[from] ValidationError),
}

/// Computes the mean errors of a model over records with the definitions of a validation.
///
/// # Errors
/// Returns an error if the parameters do not form a valid model, or if the records cannot be compared.
pub fn deviation(params: &Params, records: &[&Record]) -> Result<Deviation, WholeRecordsError> {
    let forces = forces(params, records)?;
    let compared: Vec<Compared> = records
        .iter()
        .zip(forces)
        .map(|(record, forces)| Compared { record, fv_only: forces.clone(), model: forces, used_in_fit: true })
        .collect();
    Ok(validate(&compared)?.overall.errors.model)
}

/// Computes the forces of a model over records, N.
fn forces(params: &Params, records: &[&Record]) -> Result<Vec<Vec<f64>>, NoModel> {
    let model = prepared(params)?;
    let warm = WarmStarts::new(records);
    let of = |(k, record): (usize, &&Record)| predict(&model, record, &smooth(record), warm.rise(params, k));
    Ok(records.par_iter().enumerate().map(of).collect())
}

/// Computes the errors of a fitted model over the records of the fit. The records are first corrected for the measurement errors that the
/// fit found.
///
/// # Errors
/// Returns the errors of [`deviation`].
pub fn of_fit(fit: &Fit, records: &[&Record]) -> Result<Deviation, WholeRecordsError> {
    without(&fit.measured, &fit.params, records)
}

/// Quality of a fit: the error of its model, in comparison with that of the plain FV curve and with the noise of the records. The noise is
/// the smallest error that a model can have.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Quality {
    /// Error of the model.
    pub model: Deviation,
    /// Error of the plain FV curve fitted to the same tests.
    pub fv_only: Deviation,
    /// Mean magnitude of the noise of the force, N, or 0 if it is unknown.
    pub noise_n: f64,
    /// Quality in each test.
    pub tests: Vec<TestQuality>,
}

/// Quality of a fit in one test.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct TestQuality {
    /// Name of the test.
    pub name: String,
    /// Errors of the model and of the plain FV curve.
    #[serde(flatten)]
    pub errors: Errors,
    /// Mean magnitude of the noise of the force, N, or 0 if it is unknown.
    pub noise_n: f64,
}

/// Computes the quality of a fit over the records of the fit.
///
/// # Errors
/// Returns the errors of [`deviation`].
pub fn quality(fit: &Fit, records: &[&Record]) -> Result<Quality, WholeRecordsError> {
    let off = to_measurement_error(&fit.measured);
    let right: Vec<Record> = records.iter().map(|record| correct_record(record, &off)).collect();
    let right: Vec<&Record> = right.iter().collect();
    let forces = forces(&fit.params, &right)?.into_iter().zip(forces(&fit.fv_only, &right)?);
    let compared: Vec<Compared> = right
        .iter()
        .zip(forces)
        .map(|(record, (model, fv_only))| Compared { record, model, fv_only, used_in_fit: true })
        .collect();
    quality_of(&compared)
}

/// Mean magnitude of normally distributed noise over its root mean square, √(2/π).
const MEAN_OF_RMS: f64 = 0.797_884_560_802_865_4;

/// Computes the quality of an adjustable damper over the tests of its fit with constant settings. Each test is simulated at its own
/// setting.
///
/// # Errors
/// Returns the errors of [`deviation`].
pub fn quality_of_family(fit: &FamilyFit, records: &[&Record]) -> Result<Quality, WholeRecordsError> {
    let off = to_measurement_error(&fit.measured);
    let mut all: Vec<(Record, [Vec<f64>; 2])> = Vec::new();
    for (setting, fv_only) in fit.settings_grid().iter().zip(&fit.fv_only) {
        let is_of_setting =
            |record: &Record| record.setting.as_ref().is_some_and(|of| is_same_setting(of.value, *setting));
        let own: Vec<Record> = records
            .iter()
            .filter(|record| is_of_setting(record) && fit.fingerprints.contains(&record.fingerprint()))
            .map(|record| correct_record(record, &off))
            .collect();
        let warm = WarmStarts::new(&own.iter().collect::<Vec<_>>());
        let params = fit.damper.params_at(*setting);
        let (damper, curve) = ((&params, prepared(&params)?), (fv_only, prepared(fv_only)?));
        let found: Vec<(Record, [Vec<f64>; 2])> = own
            .into_par_iter()
            .enumerate()
            .map(|(k, record)| {
                let smoothed = smooth(&record);
                let forces =
                    [&damper, &curve].map(|(params, model)| predict(model, &record, &smoothed, warm.rise(params, k)));
                (record, forces)
            })
            .collect();
        all.extend(found);
    }
    let compared: Vec<Compared> = all
        .iter()
        .map(|(record, [model, fv_only])| Compared {
            record,
            model: model.clone(),
            fv_only: fv_only.clone(),
            used_in_fit: true,
        })
        .collect();
    quality_of(&compared)
}

/// Computes the quality over compared records.
fn quality_of(compared: &[Compared<'_>]) -> Result<Quality, WholeRecordsError> {
    Ok(Quality::of_validation(&validate(compared)?))
}

impl Quality {
    /// Returns the quality of the model of a validation.
    pub fn of_validation(found: &Validation) -> Quality {
        let of_test = |test: &TestValidation| TestQuality {
            name: test.name.clone(),
            errors: test.errors,
            noise_n: test.noise_rms_n.max(0.0) * MEAN_OF_RMS,
        };
        let tests: Vec<TestQuality> = found.tests.iter().map(of_test).collect();
        let known: Vec<f64> = tests.iter().map(|test| test.noise_n).filter(|noise| *noise > 0.0).collect();
        Quality {
            model: found.overall.errors.model,
            fv_only: found.overall.errors.fv_only,
            noise_n: known.iter().sum::<f64>() / known.len().max(1) as f64,
            tests,
        }
    }
}

/// Computes the quality of an adjustable damper over the tests of its fit in which the setting changes. Returns `None` without such tests.
///
/// # Errors
/// Returns the errors of [`deviation`].
pub fn quality_where_the_setting_changes(
    fit: &FamilyFit,
    records: &[&Record],
) -> Result<Option<Quality>, WholeRecordsError> {
    let off = to_measurement_error(&fit.measured);
    let own: Vec<Record> = records
        .iter()
        .filter(|record| record.setting_signal.is_some() && fit.fingerprints.contains(&record.fingerprint()))
        .map(|record| correct_record(record, &off))
        .collect();
    if own.is_empty() {
        return Ok(None);
    }
    let plain = without_actuator(&fit.damper);
    let (damper, plain) = (prepared_family(&fit.damper)?, prepared_family(&plain)?);
    let compared: Vec<Compared> = own
        .par_iter()
        .map(|record| {
            let motion = smooth(record);
            let [model, fv_only] = [&damper, &plain].map(|family| predict_family(family, record, &motion));
            Compared { record, model, fv_only, used_in_fit: true }
        })
        .collect();
    quality_of(&compared).map(Some)
}

/// Computes the errors of a model over records after correcting them for measurement errors.
fn without(measured: &[Measured], params: &Params, records: &[&Record]) -> Result<Deviation, WholeRecordsError> {
    let off = to_measurement_error(measured);
    let right: Vec<Record> = records.iter().map(|record| correct_record(record, &off)).collect();
    deviation(params, &right.iter().collect::<Vec<_>>())
}

/// Errors of the three models of a diagnosis, over every sample of every record.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct OfDiagnosis {
    /// Errors of the model before the diagnosis.
    pub as_it_came: Deviation,
    /// Errors of the model after a refit.
    pub refitted: Deviation,
    /// Errors of the model with the findings that belong to the damper. The records are corrected for the measurement errors that the
    /// diagnosis found.
    ///
    /// A validation with the file of the improved model gives the same figures.
    pub improved: Deviation,
}

impl OfDiagnosis {
    /// Computes the errors of the model before the diagnosis, of the refitted model, and of the improved model. For the improved model, the
    /// records are corrected for `measured`.
    ///
    /// # Errors
    /// Returns the errors of [`deviation`].
    pub fn evaluate(
        as_it_came: &Params,
        refitted: &Params,
        improved: &Params,
        measured: &[Measured],
        records: &[&Record],
    ) -> Result<OfDiagnosis, WholeRecordsError> {
        let of = |params: &Params| deviation(params, records);
        let improved = without(measured, improved, records)?;
        Ok(OfDiagnosis { as_it_came: of(as_it_came)?, refitted: of(refitted)?, improved })
    }
}
