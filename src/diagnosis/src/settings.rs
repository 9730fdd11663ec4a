//! Diagnosis of one damper at several settings: the records of each setting, and effects at all or some settings.

use crate::changes::Change;
use crate::outcome::{Diagnosis, Finding, Verdict};
use crate::phrases;
use dashpot_core::Params;
use dashpot_core::family::{Axis, Definition};
use dashpot_estimation::structure::inventory::{InventoryItem, Status};
use dashpot_identification::family::is_of_grid;
use dashpot_messages::Sentence;
use dashpot_messages::Template;
use dashpot_records::{Record, Unusable, is_same_setting, setting_in_words};
use serde::Serialize;

/// The damper at one setting with its records.
#[derive(Debug, Clone)]
pub struct SettingPart {
    /// Value of the setting.
    pub setting: f64,
    /// Damper at this setting.
    pub params: Params,
    /// Indices of the records at this setting among all records.
    pub places: Vec<usize>,
    /// Records at this setting.
    pub records: Vec<Record>,
    /// Records of the reference at this setting; empty if there is no reference.
    pub reference: Vec<Record>,
}

/// Records with the setting of each. `None` marks a record with a changing setting, which does not belong to a single
/// setting.
#[derive(Debug, Clone, Copy)]
pub struct WithSettings<'a> {
    /// The records.
    pub records: &'a [Record],
    /// Settings of the records.
    pub settings: &'a [Option<f64>],
}

/// States that the diagnosis does not judge the interpolation of the damper at `settings`.
pub fn describe_unmeasured(axis: &Axis, settings: &[f64]) -> Sentence {
    let names = settings.iter().map(|setting| setting_in_words(*setting, axis.unit()));
    Sentence::from(phrases::SETTINGS_NOT_IN_MODEL).with_names("names", names.collect::<Vec<_>>(), phrases::COMMA)
}

/// Splits records by their setting, with the damper at each setting, lowest setting first.
///
/// # Errors
/// Returns the first setting at which the reference has no record.
pub fn split_by_setting(
    damper: &Definition,
    of: WithSettings<'_>,
    reference: Option<WithSettings<'_>>,
) -> Result<Vec<SettingPart>, f64> {
    let mut distinct: Vec<f64> = Vec::new();
    for setting in of.settings.iter().flatten() {
        if !distinct.iter().any(|known| is_same_setting(*known, *setting)) {
            distinct.push(*setting);
        }
    }
    distinct.sort_by(f64::total_cmp);
    let own = |all: WithSettings<'_>, setting: f64| -> Vec<usize> {
        let is_own = |k: &usize| all.settings[*k].is_some_and(|other| is_same_setting(other, setting));
        (0..all.settings.len().min(all.records.len())).filter(is_own).collect()
    };
    let part = |setting: f64| {
        let places = own(of, setting);
        let taken = |all: WithSettings<'_>, places: &[usize]| places.iter().map(|k| all.records[*k].clone()).collect();
        let compared: Vec<Record> = reference.map_or_else(Vec::new, |good| taken(good, &own(good, setting)));
        if reference.is_some() && compared.is_empty() {
            return Err(setting);
        }
        Ok(SettingPart {
            setting,
            params: damper.params_at(setting),
            records: taken(of, &places),
            places,
            reference: compared,
        })
    };
    distinct.into_iter().map(part).collect()
}

/// Name, unit and grid of the setting of a damper in the results.
#[derive(Debug, Clone, Copy, Serialize)]
struct AxisFigures<'a> {
    name: &'a str,
    unit: &'a str,
    grid: &'a [f64],
}

/// Diagnosis at one setting. `D` is the type of the diagnosis, which is serialized with the keys of a diagnosis at a
/// single setting.
#[derive(Debug, Clone, Serialize)]
pub struct SettingFigures<D> {
    setting: f64,
    /// Whether the model has no fitted numbers at this setting and is interpolated. The diagnosis does not judge the
    /// interpolation.
    interpolated: bool,
    #[serde(flatten)]
    diagnosis: D,
}

impl<D> SettingFigures<D> {
    /// Collects the diagnosis at a setting of a damper with this axis.
    pub fn new(axis: &Axis, setting: f64, diagnosis: D) -> SettingFigures<D> {
        SettingFigures { setting, interpolated: !is_of_grid(axis.grid(), setting), diagnosis }
    }
}

/// Results of a diagnosis at several settings, in the form that `dashpot diagnose` writes and Python reads.
#[derive(Debug, Clone, Serialize)]
pub struct SettingsFigures<'a, D> {
    setting: AxisFigures<'a>,
    #[serde(flatten)]
    over: &'a OverSettings,
    settings: Vec<SettingFigures<D>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    as_the_fit_saw: Option<&'a Sentence>,
    unusable: &'a [Unusable],
}

impl<'a, D> SettingsFigures<'a, D> {
    /// Collects the results over the settings of an axis. `as_the_fit_saw` reports the correction of the records, and
    /// `unusable` lists the files and tests that could not be used.
    pub fn new(
        axis: &'a Axis,
        over: &'a OverSettings,
        settings: Vec<SettingFigures<D>>,
        (as_the_fit_saw, unusable): (Option<&'a Sentence>, &'a [Unusable]),
    ) -> SettingsFigures<'a, D> {
        SettingsFigures {
            setting: AxisFigures { name: axis.name(), unit: axis.unit(), grid: axis.grid() },
            over,
            settings,
            as_the_fit_saw,
            unusable,
        }
    }
}

/// An effect at one setting.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct EffectAtSetting {
    /// Value of the setting.
    pub setting: f64,
    /// Probability that the damper has the effect at this setting. If the diagnosis has a [`Finding`] for the effect,
    /// it is the confidence of this finding. Otherwise, it is the probability of the effect's [`InventoryItem`].
    pub probability: f64,
    /// Force of the effect at this setting, N rms.
    pub force_n_rms: f64,
    /// Whether the effect was kept, added, removed or replaced at this setting.
    pub status: Status,
    /// Whether the diagnosis of this setting names the effect, so that it has a [`Finding`]. An added effect without a
    /// name is too improbable, or its force is too small.
    pub is_named: bool,
    /// Effect of the model that this effect replaces at this setting.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub replaces: Option<&'static str>,
}

/// Results for one effect at all settings.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct EffectOverSettings {
    /// Name of the effect.
    pub effect: &'static str,
    /// Whether the most probable model has the effect at every diagnosed setting.
    pub at_all_settings: bool,
    /// Whether the diagnosis names the effect at one setting or more, because the given model lacks the effect there.
    pub is_found: bool,
    /// Settings at which the given model or the most probable model has the effect.
    pub settings: Vec<EffectAtSetting>,
}

impl EffectOverSettings {
    /// Returns whether the most probable model of at least one setting has the effect and the given model lacks it,
    /// named or not.
    pub fn is_added(&self) -> bool {
        self.settings.iter().any(|at| at.status == Status::Added)
    }
}

/// A change relative to the reference at one setting.
#[derive(Debug, Clone, Serialize)]
pub struct ChangeAtSetting {
    /// Value of the setting.
    pub setting: f64,
    /// Change at this setting.
    #[serde(flatten)]
    pub change: Change,
}

/// A change relative to the reference over all settings.
#[derive(Debug, Clone, Serialize)]
pub struct ChangeOverSettings {
    /// Name of a parameter of the model, or of a part of its FV curve.
    pub name: &'static str,
    /// Whether the parameter changed at every diagnosed setting.
    pub at_all_settings: bool,
    /// Every setting at which the parameter changed.
    pub settings: Vec<ChangeAtSetting>,
}

/// Combined results of the diagnoses of one damper at several settings.
#[derive(Debug, Clone, Serialize)]
pub struct OverSettings {
    /// Summary in sentences. An effect or a change at all settings is named only once.
    pub summary: Vec<Sentence>,
    /// Every effect: first effects at all settings, then the others. Each part is sorted by force, largest first.
    pub effects: Vec<EffectOverSettings>,
    /// Every change relative to a reference: first changes at all settings, then the others. Each part is sorted by
    /// force, largest first.
    pub changes: Vec<ChangeOverSettings>,
}

impl OverSettings {
    /// Combines the diagnoses at the settings. `unit` is the unit of the settings. `is_against` is true if there is a
    /// reference.
    pub fn new(answers: &[(f64, &Diagnosis)], unit: &str, is_against: bool) -> OverSettings {
        let (effects, changes) = (effects_over_settings(answers), changes_over_settings(answers));
        let has_no_name = |found: &Diagnosis| matches!(found.verdict, Verdict::Ambiguous | Verdict::UnknownEffect);
        let open: Vec<f64> =
            answers.iter().filter(|(_, found)| has_no_name(found)).map(|(setting, _)| *setting).collect();
        let summary = summarize(&effects, &changes, &open, (answers.len(), unit, is_against));
        OverSettings { summary, effects, changes }
    }
}

/// Returns whether an effect of this status is part of the most probable model.
pub fn is_shown(status: Status) -> bool {
    matches!(status, Status::Kept | Status::Added)
}

/// Collects the changes of one damper at several settings. Changes at all settings come first, and each part is sorted
/// by force, largest first.
fn changes_over_settings(answers: &[(f64, &Diagnosis)]) -> Vec<ChangeOverSettings> {
    let mut all: Vec<ChangeOverSettings> = Vec::new();
    for (setting, found) in answers {
        for change in &found.changes {
            let at = ChangeAtSetting { setting: *setting, change: change.clone() };
            match all.iter_mut().find(|of| of.name == change.name) {
                Some(of) => of.settings.push(at),
                None => {
                    all.push(ChangeOverSettings { name: change.name, at_all_settings: false, settings: vec![at] });
                }
            }
        }
    }
    for of in &mut all {
        of.at_all_settings = of.settings.len() == answers.len();
    }
    let force =
        |of: &ChangeOverSettings| of.settings.iter().fold(0.0, |most, at| f64::max(most, at.change.force_n_rms));
    all.sort_by(|a, b| b.at_all_settings.cmp(&a.at_all_settings).then(force(b).total_cmp(&force(a))));
    all
}

/// Collects the effects of one damper at several settings. Effects at all settings come first, and each part is sorted
/// by force, largest first.
fn effects_over_settings(answers: &[(f64, &Diagnosis)]) -> Vec<EffectOverSettings> {
    let mut all: Vec<EffectOverSettings> = Vec::new();
    let mut add = |effect: &'static str, at: EffectAtSetting| match all.iter_mut().find(|of| of.effect == effect) {
        Some(of) => of.settings.push(at),
        None => {
            all.push(EffectOverSettings { effect, at_all_settings: false, is_found: false, settings: vec![at] });
        }
    };
    for (setting, found) in answers {
        let named = |effect: &str| found.findings.iter().find(|finding| finding.effect == effect);
        for item in &found.inventory {
            add(item.effect, at_setting(*setting, item, named(item.effect)));
        }
        // A finding that the inventory does not contain is added separately.
        let is_listed = |effect: &str| found.inventory.iter().any(|item| item.effect == effect);
        for finding in found.findings.iter().filter(|finding| !is_listed(finding.effect)) {
            add(finding.effect, of_finding(*setting, finding));
        }
    }
    for of in &mut all {
        let shown = of.settings.iter().filter(|at| is_shown(at.status)).count();
        of.at_all_settings = shown == answers.len();
        of.is_found = of.settings.iter().any(|at| at.is_named);
    }
    let force = |of: &EffectOverSettings| of.settings.iter().fold(0.0, |most, at| f64::max(most, at.force_n_rms));
    all.sort_by(|a, b| b.at_all_settings.cmp(&a.at_all_settings).then(force(b).total_cmp(&force(a))));
    all
}

fn at_setting(setting: f64, item: &InventoryItem, finding: Option<&Finding>) -> EffectAtSetting {
    EffectAtSetting {
        setting,
        probability: finding.map_or(item.probability, |finding| finding.confidence),
        force_n_rms: item.force_n_rms,
        status: item.status,
        is_named: finding.is_some(),
        replaces: item.replaces,
    }
}

fn of_finding(setting: f64, finding: &Finding) -> EffectAtSetting {
    EffectAtSetting {
        setting,
        probability: finding.confidence,
        force_n_rms: finding.force_n_rms,
        status: Status::Added,
        is_named: true,
        replaces: None,
    }
}

/// Formats the range of probabilities in percent, from the lowest to the highest.
fn percents(probabilities: impl Iterator<Item = f64>) -> String {
    let percent = |probability: f64| (100.0 * probability).round();
    let (low, high) =
        probabilities.fold((f64::MAX, 0.0), |(low, high): (f64, f64), p| (low.min(percent(p)), high.max(percent(p))));
    if low == high { format!("{low} %") } else { format!("{low}–{high} %") }
}

/// Summarizes the missing effects and the changes with their settings. `open` lists the settings at which model and
/// records disagree and no effect explains it.
fn summarize(
    effects: &[EffectOverSettings],
    changes: &[ChangeOverSettings],
    open: &[f64],
    (count, unit, is_against): (usize, &str, bool),
) -> Vec<Sentence> {
    let over = |at: Vec<f64>, all: Template, some: Template| match at.len() == count {
        true => Sentence::from(all),
        false => {
            let names = at.iter().map(|setting| setting_in_words(*setting, unit));
            Sentence::from(some).with_names("names", names, phrases::COMMA)
        }
    };
    let mut said: Vec<Sentence> = Vec::new();
    for of in effects {
        let named: Vec<&EffectAtSetting> = of.settings.iter().filter(|at| at.is_named).collect();
        if named.is_empty() {
            continue;
        }
        let at = named.iter().map(|at| at.setting).collect();
        // If the effect replaces the same effect of the model at all these settings, the summary also names the
        // replaced effect.
        let mut replaced = named.iter().filter_map(|at| at.replaces);
        let first = replaced.next().filter(|first| replaced.all(|other| other == *first));
        let instead = first.map(|old| Sentence::from(phrases::INSTEAD_OF).with("effect", old));
        said.push(
            over(at, phrases::AT_ALL_SETTINGS, phrases::AT_SOME_SETTINGS)
                .with("effect", of.effect)
                .with("sure", percents(named.iter().map(|at| at.probability)))
                .with_any("instead", instead),
        );
    }
    for of in changes {
        let at = of.settings.iter().map(|at| at.setting).collect();
        said.push(
            over(at, phrases::CHANGED_AT_ALL_SETTINGS, phrases::CHANGED_AT_SOME_SETTINGS)
                .with("name", of.name)
                .with("sure", percents(of.settings.iter().map(|at| at.change.probability))),
        );
    }
    if said.is_empty() && open.is_empty() {
        said.push(if is_against { phrases::CHANGED_AT_NO_SETTING } else { phrases::AT_NO_SETTING }.into());
    }
    // Several effects may explain the records of one setting equally well, while a fit over all settings distinguishes
    // them by its shared numbers. Without this sentence, a user would remove such an effect.
    let is_only_together = |of: &&EffectOverSettings| {
        of.settings.len() == count && of.settings.iter().all(|at| at.status == Status::Removed)
    };
    let only_together: Vec<&str> = effects.iter().filter(is_only_together).map(|of| of.effect).collect();
    if count > 1 && !is_against && !only_together.is_empty() {
        said.push(Sentence::from(phrases::ONLY_TOGETHER).with_names("effects", only_together, phrases::COMMA));
    }
    if !open.is_empty() {
        said.push(over(open.to_vec(), phrases::NO_NAME_AT_ALL_SETTINGS, phrases::NO_NAME_AT_SOME_SETTINGS));
    }
    said
}

#[cfg(test)]
mod tests {
    use super::*;

    fn effect(effect: &'static str, status: &[(f64, Status)]) -> EffectOverSettings {
        let at = |(setting, status): &(f64, Status)| EffectAtSetting {
            setting: *setting,
            probability: 0.9 + 0.02 * setting,
            force_n_rms: 10.0,
            status: *status,
            is_named: *status == Status::Added,
            replaces: None,
        };
        EffectOverSettings { effect, at_all_settings: false, is_found: true, settings: status.iter().map(at).collect() }
    }

    #[test]
    fn what_all_settings_show_is_said_once_and_anything_else_with_its_settings() {
        let all = [
            effect("free_play", &[(0.0, Status::Added), (1.0, Status::Added), (2.0, Status::Added)]),
            effect("cavitation", &[(1.0, Status::Added), (2.0, Status::Removed)]),
            effect("gas_preload", &[(0.0, Status::Kept), (1.0, Status::Kept), (2.0, Status::Kept)]),
        ];
        let summary = |effects: &[EffectOverSettings], changes: &[ChangeOverSettings], open: &[f64], against: bool| {
            let said = summarize(effects, changes, open, (3, "A", against));
            said.iter().map(ToString::to_string).collect::<Vec<String>>()
        };
        let said = summary(&all, &[], &[], false);
        assert_eq!(said.len(), 2, "{said:?}");
        assert!(said[0].contains("every setting") && said[0].contains("free_play (90–94 % sure)"), "{said:?}");
        assert!(said[1].contains("cavitation") && said[1].contains("at 1 A"), "{said:?}");
        // An effect that replaces another effect counts as one finding.
        let mut exchanged = effect("series_compliance", &[(0.0, Status::Added), (1.0, Status::Added)]);
        exchanged.settings.iter_mut().for_each(|at| at.replaces = Some("oil_compressibility"));
        let said = summary(&[exchanged], &[], &[], false);
        assert!(said[0].starts_with("series_compliance (90–92 % sure, instead of oil_compressibility)"), "{said:?}");
        let said = summary(&all[2..], &[], &[], false);
        assert!(said.len() == 1 && said[0].contains("no effect is missing"), "{said:?}");
        // An effect that the most probable model of a setting has, but that its diagnosis does not name, is no finding.
        let mut unnamed = effect("gas_preload", &[(1.0, Status::Added)]);
        unnamed.settings.iter_mut().for_each(|at| at.is_named = false);
        let said = summary(&[unnamed], &[], &[1.0], false);
        assert!(said.len() == 1 && said[0].starts_with("at 1 A something is missing"), "{said:?}");
        // An effect that the diagnosis of each setting removes may still be needed in a fit over all settings.
        let removed = effect("oil_compressibility", &[0.0, 1.0, 2.0].map(|setting| (setting, Status::Removed)));
        let said = summary(&[removed.clone()], &[], &[], false);
        assert!(said.len() == 2 && said[1].starts_with("no setting alone needs oil_compressibility"), "{said:?}");
        assert_eq!(summary(&[removed], &[], &[], true).len(), 1);
        // An unnamed disagreement of model and records counts as a finding.
        let said = summary(&all[2..], &[], &[2.0], false);
        assert!(said.len() == 1 && said[0].starts_with("at 2 A something is missing"), "{said:?}");
        let said = summary(&all[2..], &[], &[0.0, 1.0, 2.0], false);
        assert!(said.len() == 1 && said[0].contains("at every setting") && said[0].contains("no name"), "{said:?}");
        // With a reference, the summary reports the changes.
        let change = Change {
            name: "coulomb_force",
            reference: 20.0,
            value: 80.0,
            low: 79.0,
            high: 81.0,
            unit: "N",
            velocity_m_s: None,
            probability: 0.9,
            force_n_rms: 50.0,
        };
        let at = |setting: f64| ChangeAtSetting { setting, change: change.clone() };
        let over = |settings: &[f64]| ChangeOverSettings {
            name: "coulomb_force",
            at_all_settings: settings.len() == 3,
            settings: settings.iter().map(|setting| at(*setting)).collect(),
        };
        let said = summary(&all[2..], &[over(&[0.0, 1.0, 2.0])], &[], true);
        assert!(said.len() == 1 && said[0].contains("coulomb_force changed at every setting (90 % sure)"), "{said:?}");
        let said = summary(&all[2..], &[over(&[1.0])], &[], true);
        assert!(said.len() == 1 && said[0].contains("coulomb_force changed at 1 A"), "{said:?}");
        let said = summary(&all[2..], &[], &[], true);
        assert!(said.len() == 1 && said[0].contains("nothing has changed"), "{said:?}");
    }
}
