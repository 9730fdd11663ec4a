//! Fit of a damper family: one damper whose numbers may depend on a setting.

use super::TEMPERATURE;
use super::actuator::{self, ActuatorFit, identify_actuator};
use super::left_out::{SettingReport, WorstLeftOut, damper_through, reports};
use super::selection::select_tests;
use super::setting_labels;
use super::settings::{FamilyError, SettingAxis, SettingRecords, by_setting, split_changing};
use crate::expected::{contradiction, expectation, is_contradiction};
use crate::fit::{
    About, check_elements, check_motion, coverage_notes, has_compliance, of_number, plain_curve, search_structure,
    with_free_measurement,
};
use crate::intervals::{Estimate, Known, Standing, sources};
use crate::of_the_rig::{Measured, can_distinguish_delay, measured};
use crate::rare_values::describe_rare;
use crate::setting_energy::energy_remark;
use crate::{FitOptions, Stage, phrases};
use dashpot_core::family::{Definition, Family};
use dashpot_core::parameter::table;
use dashpot_core::{Fault, Params, list};
use dashpot_estimation::campaign_clock::clock_from;
use dashpot_estimation::family::alternatives::{FamilyAlternative, alternatives};
use dashpot_estimation::family::pattern::{Site, varying_sites};
use dashpot_estimation::family::problem::{FamilyHypothesis, FamilyRefit, SettingTests};
use dashpot_estimation::family::search::{dependences, search_family};
use dashpot_estimation::family::structure::FamilyStructure;
use dashpot_estimation::hypothesis::Free;
use dashpot_estimation::prior_set::PriorSet;
use dashpot_estimation::refit::Effort;
use dashpot_estimation::samples::{self, Test, segments};
use dashpot_estimation::structure::alternatives::Part;
use dashpot_estimation::structure::context::Structure;
use dashpot_estimation::structure::inventory::{InventoryItem, inventory};
use dashpot_estimation::structure::search::StructureSearch;
use dashpot_estimation::unknowns::Unknown;
use dashpot_messages::Sentence;
use dashpot_records::Record;
use dashpot_records::measurement_correction::MeasurementError;
use serde::Serialize;
use std::collections::BTreeMap;

/// Estimate of one number of a family.
#[derive(Debug, Clone, Serialize)]
pub struct FamilyEstimate {
    /// Setting at which the estimate holds, or `None` if all settings share the number.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub setting: Option<f64>,
    /// Estimate of the number.
    #[serde(flatten)]
    pub estimate: Estimate,
}

/// Decision on whether a number depends on the setting.
#[derive(Debug, Clone, Serialize)]
pub struct SettingDependence {
    /// Name of the number; `fv_force` for the FV curve.
    pub name: &'static str,
    /// Whether the number depends on the setting in the model.
    pub varies: bool,
    /// Probability that the number depends on the setting. It follows from a first-order estimate of the log posterior for the opposite
    /// decision.
    pub probability: f64,
}

/// Force of an effect at one setting.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct ForceAtSetting {
    /// Value of the setting.
    pub setting: f64,
    /// Root mean square over the tests at the setting, N.
    pub force_n_rms: f64,
    /// Ratio of `force_n_rms` to the root mean square of the measured force.
    #[serde(rename = "share")]
    pub fraction: f64,
}

/// Effect of a damper family, with its forces.
#[derive(Debug, Clone, Serialize)]
pub struct FamilyItem {
    /// The effect, with its force over all settings.
    #[serde(flatten)]
    pub item: InventoryItem,
    /// Force of the effect at each setting.
    pub settings: Vec<ForceAtSetting>,
}

/// An identified family.
#[derive(Debug, Clone)]
pub struct FamilyFit {
    /// Name and unit of the setting.
    pub setting: SettingAxis,
    /// The damper family: its parameters, and their values over the setting.
    pub damper: Definition,
    /// Estimates of all fitted numbers: one for each number that all settings share, and one at every setting for any other number.
    pub estimates: Vec<FamilyEstimate>,
    /// Numbers that may depend on the setting, with the decision for each.
    pub dependences: Vec<SettingDependence>,
    /// The actuator, or `None` if no test has a changing setting or the actuator gives no finite forces.
    pub actuator: Option<ActuatorFit>,
    /// Effects with their forces, over all settings and at each setting.
    pub inventory: Vec<FamilyItem>,
    /// Measurement errors of the records. These errors never become part of the model.
    pub measured: Vec<Measured>,
    /// Time at which the drifts of the force channel's gain and zero are zero, s since 1970. `None` if the records have no common clock
    /// with date and time.
    pub clock_from: Option<f64>,
    /// Errors at each setting, including those of a family fitted without the setting.
    pub settings: Vec<SettingReport>,
    /// Plain FV curves with a constant gas force, one for each setting, fitted to the tests of this setting.
    pub fv_only: Vec<Params>,
    /// Remarks for the engineer.
    pub notes: Vec<Sentence>,
    /// Notes on tests or settings whose forces contradict the settings that tests state. They are also among the notes.
    pub label_doubts: Vec<Sentence>,
    /// Names of the tests that the fit used.
    pub tests: Vec<String>,
    /// Fingerprints of the contents of the tests that the fit used, in the order of `tests`.
    pub fingerprints: Vec<String>,
    /// Root mean square of the weighted residual. At 1, the residual equals noise and form error, the error of a curve between its points.
    pub misfit: f64,
}

impl FamilyFit {
    /// Returns the values of the setting for which the model file gives numbers.
    pub fn settings_grid(&self) -> &[f64] {
        self.damper.axis.grid()
    }

    /// Returns the setting that the family predicts worst if it is fitted without that setting. Returns `None` if no setting was left out.
    pub fn worst_left_out(&self) -> Option<WorstLeftOut> {
        WorstLeftOut::find(&self.settings)
    }
}

/// Fits one damper family to records measured at several values of the setting with the name `setting`.
///
/// # Errors
/// The records lack the setting, have a single setting or too many, or the setting changes within all of them. Further errors are a setting
/// at which no damper can be fitted, forces that are not finite, and numbers that the kernel rejects.
pub fn fit_family(
    records: &[&Record],
    setting: &str,
    options: &FitOptions,
    progress: impl Fn(Stage) + Sync,
) -> Result<FamilyFit, FamilyError> {
    progress(Stage { done: 0.0, text: phrases::PREPARING });
    let (constant, mut changing) = split_changing(records, setting);
    if constant.is_empty() && !changing.is_empty() {
        return Err(FamilyError::OnlyChanging { name: setting.to_owned(), count: changing.len() });
    }
    let (axis, mut sorted) = by_setting(&constant, setting)?;
    let selection = select_tests(&mut sorted, &mut changing);
    let constant: Vec<&Record> = sorted.iter().flat_map(|of| of.records.iter().copied()).collect();
    let used: Vec<&Record> = constant.iter().chain(&changing).copied().collect();
    let is_used = |record: &&&Record| used.iter().any(|of| std::ptr::eq(*of, **record));
    let records: Vec<&Record> = records.iter().filter(is_used).copied().collect();
    let records = &records[..];
    let fail = |of: &SettingRecords, why| FamilyError::At { name: axis.name.clone(), value: of.value, why };
    for of in &sorted {
        check_elements(options).and_then(|()| check_motion(&segments(&of.records))).map_err(|why| fail(of, why))?;
    }
    let about = About::from_records(records);
    let settings: Vec<SettingTests> =
        sorted.iter().map(|of| SettingTests { value: of.value, tests: samples::tests(&of.records) }).collect();
    let mut found: Vec<StructureSearch> = Vec::new();
    for (place, (of, own)) in sorted.iter().zip(&settings).enumerate() {
        progress(Stage { done: 0.05 + 0.5 * place as f64 / sorted.len() as f64, text: phrases::FAMILY_EACH });
        let search = search_structure(&of.records, &own.tests, options, &about);
        found.push(search.map_err(|why| fail(of, why))?);
    }
    let search = search_family(&settings, &found, &|done| {
        progress(Stage { done: 0.55 + 0.3 * done, text: phrases::FAMILY_JOINT });
    });
    let search = search.ok_or(FamilyError::NotFinite)?;
    progress(Stage { done: 0.85, text: phrases::REFINING });
    let others = alternatives(&search.best, &search.rivals, &settings, TEMPERATURE);
    let FamilyStructure { hypothesis, components, .. } = search.best;
    let best = FamilyStructure::fit(hypothesis, components, &settings, Effort::FINE).ok_or(FamilyError::NotFinite)?;
    let mut damper = damper(&best, &axis, &settings).map_err(|fault| FamilyError::Kernel {
        parameter: table().nth(fault.parameter as usize).map_or("the setting", |row| row.parameter.name),
        why: fault.reason.text(),
    })?;
    progress(Stage { done: 0.9, text: phrases::FAMILY_LEFT_OUT });
    let own: Vec<&Structure> = found.iter().map(|search| &search.best).collect();
    let reports = reports(&best, &own, &axis, &settings);
    progress(Stage { done: 0.95, text: phrases::FAMILY_ACTUATOR });
    let actuator = identify_actuator(&mut damper, &best, &reports, &changing, &|done| {
        progress(Stage { done: 0.95 + 0.05 * done, text: phrases::FAMILY_ACTUATOR });
    });
    let all: Vec<Test> = settings.iter().flat_map(|of| of.tests.iter().cloned()).collect();
    let joint = best.hypothesis.joint();
    let joint_refit = best.hypothesis.joint_refit(&best.refit);
    let mut estimates = estimates(&best.hypothesis, &best.refit, &settings);
    mix_alternatives(&mut estimates, &others, &settings);
    if has_compliance(&damper.params) && can_distinguish_delay(&all) {
        hold_too(&mut estimates, &with_open_measurement(&best, &settings, &about.stated));
    }
    let mut measured = measured(&joint, &joint_refit, &all);
    measured.sort_by_key(|m| m.name);
    let measured: Vec<Measured> = measured.into_iter().map(|m| m.with_stated(&about.stated)).collect();
    let dependences = named_dependences(&best, &settings);
    let mut notes = notes(&damper, &estimates, &axis);
    notes.extend(notes_of_priors(&options.priors, &estimates, &axis));
    notes.extend(estimates.iter().filter_map(|of| {
        let said = describe_rare(&of.estimate, &damper.params, &options.priors)?;
        Some(match of.setting {
            Some(value) => at_setting(&axis, value, said),
            None => said,
        })
    }));
    let doubts = setting_labels::notes(&best, &damper, &axis, &sorted, &settings);
    notes.extend(doubts.iter().cloned());
    notes.extend(worse_than_alone(&reports, &axis));
    notes.extend(selection);
    notes.extend(actuator.iter().flat_map(|fit| actuator::notes(fit, &axis.name, &damper.axis)));
    notes.extend(coverage_notes(&segments(&constant), &damper.params));
    notes.extend(measured.iter().map(Measured::in_words));
    let scored: usize = all.iter().flat_map(|t| &t.allowed).filter(|a| a.is_finite()).count();
    progress(Stage { done: 1.0, text: phrases::DONE });
    Ok(FamilyFit {
        setting: axis,
        damper,
        estimates,
        dependences,
        actuator,
        inventory: inventory_of(&best, &settings),
        measured,
        clock_from: clock_from(records),
        settings: reports,
        fv_only: sorted.iter().map(|of| plain_curve(&segments(&of.records))).collect(),
        notes,
        tests: used.iter().map(|r| r.name.clone()).collect(),
        fingerprints: used.iter().map(|r| r.fingerprint()).collect(),
        label_doubts: doubts,
        misfit: (joint_refit.residual.norm_squared() / scored.max(1) as f64).sqrt(),
    })
}

/// Makes the damper family of the best structure, and checks that the kernel accepts it.
fn damper(best: &FamilyStructure, axis: &SettingAxis, settings: &[SettingTests]) -> Result<Definition, Fault> {
    let grid: Vec<f64> = settings.iter().map(|of| of.value).collect();
    let sets: Vec<Params> =
        (0..grid.len()).map(|setting| best.hypothesis.params_at(&best.refit.theta, setting)).collect();
    let damper = damper_through(axis, &grid, &sets)?;
    Family::check(&damper.params, &damper.axis)?;
    Ok(damper)
}

/// Estimates the numbers of a family. A number that all settings share has one estimate. Any other number has one at each setting.
fn estimates(hypothesis: &FamilyHypothesis, refit: &FamilyRefit, settings: &[SettingTests]) -> Vec<FamilyEstimate> {
    let tests: Vec<Test> = settings.iter().flat_map(|of| of.tests.iter().cloned()).collect();
    let (joint, joint_refit) = (hypothesis.joint(), hypothesis.joint_refit(refit));
    let Some((covariance, determined)) = hypothesis.covariance(refit, settings) else { return Vec::new() };
    let known = Known { covariance, determined, sources: sources(&joint, &joint_refit, &tests) };
    let columns = hypothesis.columns();
    let varying = varying_sites(&hypothesis.template, &hypothesis.varies);
    let is_relative_to = |level: &str, name: &str| {
        hypothesis.template.numbers.iter().any(|number| match number.free {
            Free::Model(Unknown::Above(own, below)) => own.name() == name && below.name() == level,
            _ => false,
        })
    };
    let varies = |estimate: &Estimate| {
        varying.iter().any(|site| match site {
            Site::Curve => estimate.name == list!("fv_force").name(),
            Site::Number(number) => estimate.name == number.name() || is_relative_to(number.name(), estimate.name),
        })
    };
    // The tests at a setting decide whether a number of this setting counts as identified. All tests decide about a shared number.
    let at = |place: usize, tests: &[Test], residual: &[f64]| {
        let theta = hypothesis.theta_at(&refit.theta, place);
        known.select(&columns[place]).estimates(&hypothesis.template, &theta, tests, residual)
    };
    let shared = at(0, &tests, joint_refit.residual.as_slice()).into_iter().filter(|estimate| !varies(estimate));
    let mut all: Vec<FamilyEstimate> = shared.map(|estimate| FamilyEstimate { setting: None, estimate }).collect();
    for (place, of) in settings.iter().enumerate() {
        let own =
            at(place, &of.tests, refit.residuals[place].as_slice()).into_iter().filter(|estimate| varies(estimate));
        all.extend(own.map(|estimate| FamilyEstimate { setting: Some(of.value), estimate }));
    }
    all
}

/// Mixes the intervals with those of the alternative families, by their weights. If all settings share a number in an alternative, its
/// single interval counts at every setting. If a number depends on the setting only in the alternative, each of its intervals has an equal
/// part of the weight.
fn mix_alternatives(all: &mut [FamilyEstimate], others: &[FamilyAlternative], settings: &[SettingTests]) {
    let others: Vec<(f64, Vec<FamilyEstimate>)> =
        others.iter().map(|of| (of.weight, estimates(&of.family.hypothesis, &of.family.refit, settings))).collect();
    for FamilyEstimate { setting, estimate } in all {
        let (name, index) = (estimate.name, estimate.index);
        let of_other = |(weight, theirs): &(f64, Vec<FamilyEstimate>)| -> Vec<Part> {
            let is_of_same_number = |of: &&FamilyEstimate| {
                let is_at_setting = setting.is_none() || of.setting.is_none() || of.setting == *setting;
                is_at_setting && of.estimate.name == name && of.estimate.index == index
            };
            let same: Vec<&FamilyEstimate> = theirs.iter().filter(is_of_same_number).collect();
            let weight = weight / same.len().max(1) as f64;
            same.into_iter().filter_map(|of| of.estimate.part(weight)).collect()
        };
        estimate.mix(others.iter().flat_map(of_other));
    }
}

/// Estimates the numbers of a family again, with the delay of the force channel and the mass on the load cell free within their priors.
/// Returns no estimates if neither can be free, or if the refit fails.
fn with_open_measurement(
    best: &FamilyStructure,
    settings: &[SettingTests],
    given: &MeasurementError,
) -> Vec<FamilyEstimate> {
    let mut freed = best.hypothesis.clone();
    let Some(template) = with_free_measurement(&freed.template, given) else { return Vec::new() };
    for number in &template.numbers[freed.template.numbers.len()..] {
        freed.varies.push(false);
        freed.starts.iter_mut().for_each(|start| start.push(number.start));
    }
    freed.template = template;
    let Some(refit) = freed.refit(settings, Effort::JUDGE) else { return Vec::new() };
    estimates(&freed, &refit, settings)
}

/// Widens the intervals of `all` until they contain the intervals of `others`, another fit of the same numbers. The records do not exclude
/// that fit.
fn hold_too(all: &mut [FamilyEstimate], others: &[FamilyEstimate]) {
    for of in all {
        let others = others.iter().filter(|other| other.setting == of.setting).map(|other| &other.estimate);
        crate::fit::hold_too(std::slice::from_mut(&mut of.estimate), others);
    }
}

/// Returns the decisions on whether numbers depend on the setting, with the name of each number.
fn named_dependences(best: &FamilyStructure, settings: &[SettingTests]) -> Vec<SettingDependence> {
    let named = dependences(best, settings).into_iter().map(|of| SettingDependence {
        name: match of.site {
            Site::Curve => list!("fv_force").name(),
            Site::Number(number) => number.name(),
        },
        varies: of.varies,
        probability: 1.0 / (1.0 + libm::exp(-of.log_odds / TEMPERATURE)),
    });
    named.collect()
}

/// Computes the force of each effect over all settings and at each setting. The probability of an effect follows from the log posteriors of
/// the family with and without this effect.
fn inventory_of(best: &FamilyStructure, settings: &[SettingTests]) -> Vec<FamilyItem> {
    let probabilities: BTreeMap<&str, f64> = best
        .components
        .iter()
        .enumerate()
        .map(|(place, component)| {
            let less = best.without(place, settings, Effort::COMPARE);
            let rise = less.map_or(f64::INFINITY, |less| best.log_posterior - less.log_posterior);
            (component.effect, 1.0 / (1.0 + libm::exp(-rise / TEMPERATURE)))
        })
        .collect();
    let mut all: Vec<FamilyItem> = Vec::new();
    let count = settings.len() as f64;
    for (place, of) in settings.iter().enumerate() {
        let template = best.hypothesis.template.clone();
        let refit = best.hypothesis.refit_at(&best.refit, place);
        let structure = Structure::new(template, refit, best.components.clone(), &of.tests);
        let probability = |effect: &str| probabilities.get(effect).copied().unwrap_or(0.0);
        for item in inventory(&structure, None, &of.tests, &probability) {
            let here = ForceAtSetting { setting: of.value, force_n_rms: item.force_n_rms, fraction: item.fraction };
            match all.iter_mut().find(|known| known.item.effect == item.effect) {
                Some(known) => {
                    known.item.test_forces_n.extend(item.test_forces_n);
                    known.settings.push(here);
                }
                None => all.push(FamilyItem { item, settings: vec![here] }),
            }
        }
    }
    for FamilyItem { item, settings } in &mut all {
        let rms = |of: fn(&ForceAtSetting) -> f64| (settings.iter().map(|s| of(s).powi(2)).sum::<f64>() / count).sqrt();
        (item.force_n_rms, item.fraction) = (rms(|of| of.force_n_rms), rms(|of| of.fraction));
    }
    all.sort_by(|a, b| b.item.force_n_rms.total_cmp(&a.item.force_n_rms));
    all
}

/// Returns sentences on the values that the priors predict, and on contradictions between priors and records. A contradiction of a number
/// that depends on the setting names the setting.
fn notes_of_priors(priors: &PriorSet, estimates: &[FamilyEstimate], axis: &SettingAxis) -> Vec<Sentence> {
    let mut notes = Vec::new();
    for row in priors.rows() {
        let own = estimates.iter().filter(|of| of.estimate.name == row.number.name());
        let (against, with): (Vec<_>, Vec<_>) = own.partition(|of| is_contradiction(row, &of.estimate));
        if !with.is_empty() {
            notes.push(expectation(row));
        }
        notes.extend(against.iter().map(|of| {
            let said = contradiction(row, &of.estimate);
            match of.setting {
                Some(value) => at_setting(axis, value, said),
                None => said,
            }
        }));
    }
    notes
}

/// Ratio of two errors above which a note names a setting. The errors are those of the family and of a separate fit of the setting, the
/// larger divided by the smaller. The worst ratio in the UTFSM records is 1.15. The ratio was 2.2 for a model with shared friction and
/// records with friction that depends on the setting.
const WORSE: f64 = 1.5;

/// Returns notes on settings at which a separate fit is clearly better or clearly worse than the family.
fn worse_than_alone<'r>(reports: &'r [SettingReport], axis: &'r SettingAxis) -> impl Iterator<Item = Sentence> + 'r {
    reports.iter().filter_map(|of| {
        let ratio = of.family.mean_error_n / of.own_fit.mean_error_n.max(1e-300);
        let (times, phrase) =
            if ratio > 1.0 { (ratio, phrases::FAMILY_WORSE) } else { (1.0 / ratio, phrases::ALONE_WORSE) };
        let said = Sentence::from(phrase).with("ratio", format!("{times:.1}"));
        (times > WORSE).then(|| at_setting(axis, of.setting, said))
    })
}

/// Puts the name and value of the setting before a sentence.
fn at_setting(axis: &SettingAxis, value: f64, said: Sentence) -> Sentence {
    Sentence::from(phrases::FAMILY_AT).with("name", &axis.name).with("value", value).with_sentence("why", said)
}

/// Returns remarks for the engineer: on numbers through which a change of the setting may do work, not identified, or at a bound.
fn notes(damper: &Definition, estimates: &[FamilyEstimate], axis: &SettingAxis) -> Vec<Sentence> {
    let mut notes = Vec::new();
    notes.extend(energy_remark(damper));
    for FamilyEstimate { setting, estimate } in estimates {
        let said = match estimate.standing {
            Standing::NotIdentified if estimate.index.is_none() => of_number(phrases::HELD, estimate),
            Standing::AtBound => of_number(phrases::AT_BOUND, estimate),
            _ => continue,
        };
        notes.push(match setting {
            None => said,
            Some(value) => at_setting(axis, *value, said),
        });
    }
    notes
}
