//! A model and its FV curve alone beside the records of a campaign.

use crate::prediction::{between_velocities, predict};
use crate::warm_starts::WarmStarts;
use dashpot_core::{Model, Params};
use dashpot_identification::model_file::{ModelFile, NoModel, prepared};
use dashpot_identification::validation::{Compared, Validation};
use dashpot_identification::{Family, FitError, FitOptions, fit};
use dashpot_records::smoothing::smooth;
use dashpot_records::{Campaign, Record};
use rayon::prelude::*;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Why a model and records cannot be compared.
#[derive(Debug, thiserror::Error)]
pub enum CompareError {
    /// The parameters do not make a model.
    #[error(transparent)]
    Model(#[from] NoModel),
    /// The FV curve of the model file does not make one.
    #[error("the table fv_only of the model file: {0}")]
    FvOnly(String),
    /// There is none, and none can be fitted.
    #[error(transparent)]
    Fit(#[from] FitError),
}

/// Simulates every record with the model and with the FV curve alone. `progress` is told how many of how many are done, from
/// several threads.
///
/// # Errors
/// Where there is no model, or no FV curve.
pub fn compare<'a>(
    file: &ModelFile,
    campaign: &'a Campaign,
    progress: &(dyn Fn(usize, usize) + Sync),
) -> Result<Vec<Compared<'a>>, CompareError> {
    let model = prepared(&file.params)?;
    let fv_only = prepared(&fv_only(file, campaign)?)?;
    let warm = WarmStarts::new(&campaign.records.iter().collect::<Vec<_>>());
    let done = AtomicUsize::new(0);
    Ok(campaign
        .records
        .par_iter()
        .enumerate()
        .map(|(k, record)| {
            let motion = smooth(record);
            let compared = Compared {
                record,
                model: predict(&model, record, &motion, warm.rise(&file.params, k)),
                fv_only: predict(&fv_only, record, &motion, 0.0),
                used_in_fit: file.identification.used(record),
            };
            progress(1 + done.fetch_add(1, Ordering::Relaxed), campaign.records.len());
            compared
        })
        .collect())
}

/// The model's force at constant velocities over what the tests reach.
pub fn at_constant_velocity(model: &Model, validation: &Validation) -> Vec<[f64; 2]> {
    let reach = |sign: f64| {
        let peaks = validation.tests.iter().flat_map(|t| &t.peaks).map(|p| sign * p.velocity_m_s);
        sign * peaks.fold(0.0, f64::max)
    };
    between_velocities(model, reach(-1.0), reach(1.0))
}

/// The plain FV curve of the fit; fitted to these records where the model file brings none.
fn fv_only(file: &ModelFile, campaign: &Campaign) -> Result<Params, CompareError> {
    if let Some(curve) = &file.identification.fv_only {
        return curve.params().map_err(CompareError::FvOnly);
    }
    let records: Vec<&Record> = campaign.records.iter().collect();
    Ok(fit(&records, &FitOptions { family: Family::Fv, ..FitOptions::default() }, |_| ())?.params)
}
