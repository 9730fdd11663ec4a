//! Errors of a family at each setting, and its prediction errors at settings that the fit did not use.

use super::settings::SettingAxis;
use dashpot_core::family::{Axis, Definition};
use dashpot_core::{Fault, Model, Params};
use dashpot_estimation::family::problem::SettingTests;
use dashpot_estimation::family::structure::FamilyStructure;
use dashpot_estimation::hypothesis::Hypothesis;
use dashpot_estimation::refit::Effort;
use dashpot_estimation::samples::Test;
use dashpot_estimation::sensitivity::Accuracy;
use dashpot_estimation::structure::context::Structure;
use rayon::prelude::*;
use serde::Serialize;
use std::collections::BTreeSet;

/// Mean error of a damper over the tests of a setting, from the mean cycle of each test.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct SettingError {
    /// Mean absolute error, N.
    pub mean_error_n: f64,
    /// Mean of the tests' errors, each in percent of the largest force of its test.
    pub error_percent: f64,
}

/// Errors of separate fit, family, and prediction without the setting, at one setting.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SettingReport {
    /// Value of the setting.
    pub setting: f64,
    /// Number of tests at the setting.
    pub tests: usize,
    /// Error of an ordinary damper fitted to the setting alone.
    pub own_fit: SettingError,
    /// Error of the family fitted to all settings.
    pub family: SettingError,
    /// Error of the family fitted to all other settings. `None` at the ends of the grid, where nothing is interpolated, and if that fit
    /// fails.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub left_out: Option<SettingError>,
    /// Ratio of the mean error of `left_out` to that of `own_fit`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub left_out_ratio: Option<f64>,
}

/// Setting that the family predicts worst if it is fitted without that setting.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WorstLeftOut {
    /// Value of the setting.
    pub setting: f64,
    /// Error of the prediction.
    pub error: SettingError,
    /// Ratio of the prediction error to the error of the fit to this setting alone.
    pub ratio: f64,
}

impl WorstLeftOut {
    /// Largest ratio of prediction error to fit error at which a prediction between settings counts as good as a fit at the setting. It is
    /// the target of the figures in the book, and affects messages only.
    const AS_GOOD: f64 = 1.3;

    /// Returns whether the model is worse between its settings than at its settings.
    pub fn is_worse(&self) -> bool {
        self.ratio > WorstLeftOut::AS_GOOD
    }

    /// Finds the setting with the largest ratio in `reports`. Returns `None` if no setting was left out.
    pub fn find(reports: &[SettingReport]) -> Option<WorstLeftOut> {
        let left_out = reports.iter().filter_map(|of| {
            Some(WorstLeftOut { setting: of.setting, error: of.left_out?, ratio: of.left_out_ratio? })
        });
        left_out.max_by(|a, b| a.ratio.total_cmp(&b.ratio))
    }
}

/// Makes the damper over a grid from the parameter set at each setting. A name or unit of the axis that is too long for the kernel is left
/// out.
///
/// # Errors
/// The kernel rejects the parameter sets.
pub fn damper_through(axis: &SettingAxis, grid: &[f64], sets: &[Params]) -> Result<Definition, Fault> {
    let (params, mut over) = Axis::through(grid, sets)?;
    let is_short = |text: &str| text.len() <= dashpot_core::family::axis::MAX_TEXT;
    if is_short(&axis.name) {
        over.set_name(&axis.name)?;
    }
    if is_short(&axis.unit) {
        over.set_unit(&axis.unit)?;
    }
    Ok(Definition { params, axis: over })
}

fn error_of(tests: &[Test], forces: &[Vec<f64>]) -> SettingError {
    let (mut newtons, mut percent) = (0.0, 0.0);
    for (test, forces) in tests.iter().zip(forces) {
        let sum: f64 = test.forces().iter().zip(forces).map(|(measured, force)| (measured - force).abs()).sum();
        let mean = sum / forces.len().max(1) as f64;
        newtons += mean;
        percent += 100.0 * mean / test.segment.top.max(1e-9);
    }
    let count = tests.len().max(1) as f64;
    SettingError { mean_error_n: newtons / count, error_percent: percent / count }
}

/// Computes the mean error of a parameter set over tests, with the measurement errors of the hypothesis `rig` at `theta`. Returns `None` if
/// the parameters form no valid model.
fn error_at(params: &Params, rig: &Hypothesis, theta: &[f64], tests: &[Test]) -> Option<SettingError> {
    Some(error_of(tests, &forces_at(params, rig, theta, tests)?))
}

/// Computes the forces, N, of a parameter set in each test, with the measurement errors of the hypothesis `rig` at `theta`. Returns `None`
/// if the parameters form no valid model.
pub fn forces_at(params: &Params, rig: &Hypothesis, theta: &[f64], tests: &[Test]) -> Option<Vec<Vec<f64>>> {
    let model = Model::new(params).ok()?;
    let integration = Accuracy::Single.integration(params, &model);
    let model = model.with_integration(integration);
    Some(tests.par_iter().map(|test| rig.forces_with(&model, test, theta)).collect())
}

/// Counts the records from which tests come. One long record gives several tests.
pub fn count_records(tests: &[Test]) -> usize {
    tests.iter().map(|test| test.record).collect::<BTreeSet<_>>().len()
}

/// Computes the error of the fit of an ordinary damper, on the tests to which it was fitted.
fn own_error(own: &Structure, tests: &[Test]) -> Option<SettingError> {
    Some(error_of(tests, &own.hypothesis.forces(tests, &own.refit.theta)?))
}

/// Computes the error, at one setting, of the family refitted to all other settings. Returns `None` at an end of the grid, and if the refit
/// fails.
fn left_out_error(
    family: &FamilyStructure,
    axis: &SettingAxis,
    settings: &[SettingTests],
    place: usize,
) -> Option<SettingError> {
    if place == 0 || place + 1 == settings.len() {
        return None;
    }
    let mut others = settings.to_vec();
    let left_out = others.remove(place);
    let less = family.hypothesis.without_setting(place);
    let refit = less.refit(&others, Effort::JUDGE)?;
    let grid: Vec<f64> = others.iter().map(|of| of.value).collect();
    let sets: Vec<Params> = (0..grid.len()).map(|setting| less.params_at(&refit.theta, setting)).collect();
    let params = damper_through(axis, &grid, &sets).ok()?.params_at(left_out.value);
    error_at(&params, &less.template, &less.theta_at(&refit.theta, place - 1), &left_out.tests)
}

/// Computes the errors at every setting. `own` contains the ordinary fit of each setting. Settings at which no error can be computed are
/// left out.
pub fn reports(
    family: &FamilyStructure,
    own: &[&Structure],
    axis: &SettingAxis,
    settings: &[SettingTests],
) -> Vec<SettingReport> {
    let theta = &family.refit.theta;
    settings
        .par_iter()
        .zip(own)
        .enumerate()
        .filter_map(|(place, (of, own))| {
            let own_fit = own_error(own, &of.tests)?;
            let hypothesis = &family.hypothesis;
            let at = hypothesis.theta_at(theta, place);
            let fitted = error_at(&hypothesis.params_at(theta, place), &hypothesis.template, &at, &of.tests)?;
            let left_out = left_out_error(family, axis, settings, place);
            Some(SettingReport {
                setting: of.value,
                tests: count_records(&of.tests),
                own_fit,
                family: fitted,
                left_out,
                left_out_ratio: left_out.map(|error| error.mean_error_n / own_fit.mean_error_n.max(1e-9)),
            })
        })
        .collect()
}
