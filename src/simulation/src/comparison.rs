//! Comparison of a model and its FV curve with the records of a campaign.

use crate::own_setting::OwnSetting;
use crate::prediction::{between_velocities, predict, predict_family};
use crate::setting_doubts::doubt_settings;
use crate::step_response::step_responses;
use crate::warm_starts::WarmStarts;
use dashpot_core::family::Definition;
use dashpot_core::family::axis::ENTRIES;
use dashpot_core::{Model, Params, element};
use dashpot_identification::model_file::{ModelFile, NoModel, prepared, prepared_family};
use dashpot_identification::validation::{Compared, Validation};
use dashpot_identification::{Family, FitError, FitOptions, fit};
use dashpot_messages::Sentence;
use dashpot_records::smoothing::smooth;
use dashpot_records::{Campaign, Record, is_same_setting, records_without_setting, setting_in_words, unread_current};
use rayon::prelude::*;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Reason why a model cannot be compared with records.
#[derive(Debug, thiserror::Error)]
pub enum CompareError {
    /// The parameters do not form a valid model.
    #[error(transparent)]
    Model(#[from] NoModel),
    /// The plain FV curve that the model file contains in its table `fv_only` does not form a valid model.
    #[error("the table fv_only of the model file: {0}")]
    FvOnly(String),
    /// A record does not state the setting on which the damper depends, and the user gives none.
    #[error(
        "test '{test}' does not say its {name}, which the model depends on{}: give it in the name of the test, with --column setting=HEADING if a column has it, in campaign.toml under settings, or for all tests with --setting{}",
        seen.as_ref().map_or_else(String::new, |seen| format!("; it says {seen}, which is another setting")),
        unread.as_ref().map_or_else(String::new, |note| format!("; {note}"))
    )]
    NoSetting {
        /// Name of the test.
        test: String,
        /// Name of the setting.
        name: String,
        /// Setting with another name that the test states, in words.
        seen: Option<String>,
        /// Note about a column in a unit of current that was not read.
        unread: Option<Sentence>,
    },
    /// The model file has no plain FV curve, and none can be fitted to the records.
    #[error(transparent)]
    Fit(#[from] FitError),
}

/// Simulates every record with the model and with the FV curve alone.
///
/// Several threads call `progress` with the number of completed records and their total.
///
/// # Errors
/// Returns an error if the parameters or the plain FV curve of the model file do not form a valid model. Also returns an error if the file
/// has no plain FV curve and none can be fitted to the records.
pub fn compare<'a>(
    file: &ModelFile,
    campaign: &'a Campaign,
    progress: &(dyn Fn(usize, usize) + Sync),
) -> Result<Vec<Compared<'a>>, CompareError> {
    let fv_only = fv_only(file, campaign)?;
    compare_records(file, campaign, &|_| Ok(Dampers::Constant(file.params, fv_only)), progress)
}

/// Simulates every record with an adjustable damper, which depends on a setting. If a record states no setting, the `given` one applies.
///
/// For comparison, a plain FV curve is fitted to the records of each setting. For records in which the setting changes, the FV curves of
/// the adjustable damper itself are used, without its actuator.
///
/// # Errors
/// Returns an error if a record has no setting and none is given, or if the parameters do not form a valid model.
pub fn compare_family<'a>(
    file: &ModelFile,
    campaign: &'a Campaign,
    given: Option<f64>,
    progress: &(dyn Fn(usize, usize) + Sync),
) -> Result<Vec<Compared<'a>>, CompareError> {
    let settings = settings_of(file, campaign, given)?;
    let mut distinct: Vec<f64> = Vec::new();
    for setting in settings.iter().flatten() {
        if !distinct.iter().any(|known| is_same_setting(*known, *setting)) {
            distinct.push(*setting);
        }
    }
    let plain: Vec<Params> = distinct
        .par_iter()
        .map(|setting| {
            let is_own = |k: &usize| settings[*k].is_some_and(|own| is_same_setting(own, *setting));
            let own: Vec<&Record> =
                (0..settings.len()).filter(is_own).filter_map(|k| campaign.records.get(k)).collect();
            let options = FitOptions { family: Family::Fv, ..FitOptions::default() };
            // No FV curve can be fitted to records with motion in only one direction. Use the FV curve of the adjustable damper at this
            // setting for such records.
            fit(&own, &options, |_| ())
                .map_or_else(|_| plain_curve(&file.definition().params_at(*setting)), |fit| fit.params)
        })
        .collect();
    let at = |k: usize| {
        let Some(setting) = settings[k] else { return Ok(Dampers::Changing) };
        let place = distinct.iter().position(|known| is_same_setting(*known, setting)).unwrap_or(0);
        Ok(Dampers::Constant(file.definition().params_at(setting), plain[place]))
    };
    compare_records(file, campaign, &at, progress)
}

/// Dampers with which one record is simulated: the full model, and the FV curve alone.
enum Dampers {
    /// Parameters of the damper and of the FV curve alone, at a constant setting.
    Constant(Params, Params),
    /// The setting changes within the record, so the whole adjustable damper and its FV curves at all settings are used.
    Changing,
}

/// Returns the setting of every record, or `None` if the setting changes within the record. If a record does not state the setting of the
/// model, the `given` one applies.
///
/// # Errors
/// Returns the first record without a setting if no setting is given.
pub fn settings_of(
    file: &ModelFile,
    campaign: &Campaign,
    given: Option<f64>,
) -> Result<Vec<Option<f64>>, CompareError> {
    let name = file.axis.name();
    let of = |record: &Record| match OwnSetting::find(&file.axis, record) {
        OwnSetting::Changing => Ok(None),
        OwnSetting::Constant(value) => Ok(Some(value)),
        OwnSetting::Unstated => given.map(Some).ok_or_else(|| {
            let without = records_without_setting(campaign.records.iter(), name);
            let first = without.first().map_or(record, |first| *first);
            let seen = first.setting.as_ref().map(|of| format!("{} {}", of.name, setting_in_words(of.value, &of.unit)));
            CompareError::NoSetting {
                test: first.name.clone(),
                name: if name.is_empty() { "setting".to_owned() } else { name.to_owned() },
                seen,
                unread: unread_current(campaign.records.iter()),
            }
        }),
    };
    campaign.records.iter().map(of).collect()
}

/// Summarizes a validation by the settings of its tests. Adds the responses to steps of the setting, and the tests with doubtful settings.
/// Returns the setting of every test.
///
/// # Errors
/// Returns the errors of [`settings_of`]. Also returns an error if the parameters do not form a valid model.
pub fn summarize_settings(
    validation: &mut Validation,
    file: &ModelFile,
    (campaign, compared): (&Campaign, &[Compared<'_>]),
    given: Option<f64>,
) -> Result<Vec<Option<f64>>, CompareError> {
    let settings = settings_of(file, campaign, given)?;
    validation.summarize_settings(&settings, file.axis.grid());
    let changing = campaign.records.iter().zip(&settings).filter(|(_, setting)| setting.is_none());
    let changing: Vec<&Record> = changing.map(|(record, _)| record).collect();
    validation.step_responses = step_responses(&file.definition(), &changing)?;
    validation.setting_doubts = doubt_settings(file, compared, &settings);
    Ok(settings)
}

/// Returns a damper that has only the FV curve and the gas force of the given damper.
fn plain_curve(params: &Params) -> Params {
    let mut curve = *params;
    curve.disable_all();
    curve.enable(element!("fv_curve"), true);
    curve.enable(element!("gas_preload"), params.is_on(element!("gas_preload")));
    curve
}

/// Returns an adjustable damper that has only the FV curve and the gas force of the given damper. Its setting follows every command
/// instantaneously.
pub(crate) fn without_actuator(definition: &Definition) -> Definition {
    let mut plain = Definition { params: plain_curve(&definition.params), axis: definition.axis };
    for index in 1..ENTRIES.len() {
        // `set_number` cannot fail, because every parameter of an actuator may be 0. The value 0 disables the effect of the parameter.
        let _ = plain.axis.set_number(index, 0.0);
    }
    plain
}

/// Simulates every record with the dampers that `of_record` returns for its index.
fn compare_records<'a>(
    file: &ModelFile,
    campaign: &'a Campaign,
    of_record: &(dyn Fn(usize) -> Result<Dampers, CompareError> + Sync),
    progress: &(dyn Fn(usize, usize) + Sync),
) -> Result<Vec<Compared<'a>>, CompareError> {
    let warm = WarmStarts::new(&campaign.records.iter().collect::<Vec<_>>());
    let done = AtomicUsize::new(0);
    campaign
        .records
        .par_iter()
        .enumerate()
        .map(|(k, record)| {
            let dampers = of_record(k)?;
            let motion = smooth(record);
            let (model, fv_only) = match dampers {
                Dampers::Constant(params, fv_only) => {
                    let (model, curve) = (prepared(&params)?, prepared(&fv_only)?);
                    let forces = predict(&model, record, &motion, warm.rise(&params, k));
                    (forces, predict(&curve, record, &motion, 0.0))
                }
                Dampers::Changing => {
                    let run = |definition: &Definition| {
                        Ok::<_, CompareError>(predict_family(&*prepared_family(definition)?, record, &motion))
                    };
                    (run(&file.definition())?, run(&without_actuator(&file.definition()))?)
                }
            };
            let compared = Compared { record, model, fv_only, used_in_fit: file.identification.used(record) };
            progress(1 + done.fetch_add(1, Ordering::Relaxed), campaign.records.len());
            Ok(compared)
        })
        .collect()
}

/// Returns velocities, m/s, and the forces of the model, N, at these constant velocities. The velocities cover the range of the tests' peak
/// velocities.
pub fn at_constant_velocity(model: &Model, validation: &Validation) -> Vec<[f64; 2]> {
    let reach = |sign: f64| {
        let peaks = validation.tests.iter().flat_map(|t| &t.peaks).map(|p| sign * p.velocity_m_s);
        sign * peaks.fold(0.0, f64::max)
    };
    between_velocities(model, reach(-1.0), reach(1.0))
}

/// Returns the plain FV curve in the tables of the model file. If the file has none, fits one to the records of the campaign.
fn fv_only(file: &ModelFile, campaign: &Campaign) -> Result<Params, CompareError> {
    if let Some(curve) = &file.identification.fv_only {
        return curve.params().map_err(CompareError::FvOnly);
    }
    let records: Vec<&Record> = campaign.records.iter().collect();
    Ok(fit(&records, &FitOptions { family: Family::Fv, ..FitOptions::default() }, |_| ())?.params)
}
