//! The search for the most probable family.
//!
//! Each setting is first searched as an ordinary damper. Each structure from these searches gives a start in which
//! every parameter varies with the setting if possible. Parameters that do not depend on the setting are then shared by
//! all settings. From each start, the search makes moves. A move makes one quantity vary with the setting or shared,
//! removes an effect, or adds an effect from the search of a setting. The moves from a start end when the log posterior
//! no longer rises. The result is the most probable family over all starts.

use super::alternatives::{Rival, distinct_rivals};
use super::pattern::{Site, sites};
use super::prediction::Linearization;
use super::problem::{FamilyHypothesis, SettingTests};
use super::structure::FamilyStructure;
use super::template::{varying_family, velocities, with_effect};
use crate::cancel;
use crate::refit::{self, Effort};
use crate::structure::context::{Form, Structure};
use crate::structure::curve_at_rest::with_other_form;
use crate::structure::search::StructureSearch;
use rayon::prelude::*;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::atomic::{AtomicUsize, Ordering};

/// Smallest rise of the log posterior at which the search makes a move.
const RISE: f64 = 0.5;
/// Largest deficit of a family's predicted log posterior, relative to the current one, at which the family is refitted.
const PREDICTED: f64 = 3.0;
/// Largest number of predicted families that are refitted in each iteration.
const REFITTED: usize = 3;
/// Largest deficit of log posterior, relative to the best structure of a setting, at which the family search tries a
/// structure's effect.
const ASKED_FOR: f64 = 15.0;
/// Largest number of effects that are tried in addition to those of the best structures.
const EFFECTS: usize = 16;
/// Largest number of moves from one start.
const MOVES: usize = 24;

/// Number of moves after which the search is usually half done. It only scales the displayed progress, because the
/// number of moves is unknown in advance.
const USUAL_MOVES: usize = 8;

/// Dependence of a quantity on the setting, with the log odds of the dependence.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Dependence {
    /// The quantity.
    pub site: Site,
    /// Whether the quantity varies in the most probable family.
    pub varies: bool,
    /// Log posterior of the family in which the quantity varies, minus that of the family in which it is shared. The
    /// log posterior of the family that the search did not choose is a first-order estimate.
    pub log_odds: f64,
}

/// Result of the search for the most probable family.
pub struct FamilySearch {
    /// The most probable family.
    pub best: FamilyStructure,
    /// Other families that the search refitted, the most probable first.
    pub rivals: Vec<Rival>,
}

/// Searches for the most probable family. `found` contains the search of each setting alone. Returns `None` if no start
/// gives a finite force.
pub fn search_family(
    settings: &[SettingTests],
    found: &[StructureSearch],
    progress: &(dyn Fn(f64) + Sync),
) -> Option<FamilySearch> {
    let at_settings: Vec<&Structure> = found.iter().map(|search| &search.best).collect();
    let mut keys: BTreeSet<Vec<Form>> = BTreeSet::new();
    let distinct: Vec<&Structure> = at_settings.iter().copied().filter(|s| keys.insert(s.key())).collect();
    let velocities = velocities(settings, &at_settings);
    let starts: Vec<FamilyStructure> = distinct
        .into_par_iter()
        .filter_map(|from| {
            let (hypothesis, components) = varying_family(from, &at_settings, settings, &velocities)?;
            let start = FamilyStructure::fit(hypothesis, components, settings, Effort::JUDGE)?;
            Some(share(start, settings))
        })
        .collect();
    progress(0.3);
    let asked_for = asked_for(found);
    let moves = AtomicUsize::new(0);
    let report_move = || {
        let done = 1 + moves.fetch_add(1, Ordering::Relaxed);
        progress(0.3 + 0.7 * done as f64 / (done + USUAL_MOVES) as f64);
    };
    let ends: Vec<(FamilyStructure, Vec<Rival>)> =
        starts.into_par_iter().map(|start| climb(start, settings, &asked_for, &report_move)).collect();
    progress(1.0);
    let mut rivals = Vec::new();
    let mut ended: Vec<FamilyStructure> = Vec::new();
    for (end, own) in ends {
        rivals.extend(own);
        rivals.push(Rival::from(&end));
        ended.push(end);
    }
    let best = ended.into_iter().max_by(|a, b| a.log_posterior.total_cmp(&b.log_posterior))?;
    let (best, other) = by_form_at_rest(best, settings);
    rivals.extend(other.as_ref().map(Rival::from));
    let rivals = distinct_rivals(rivals, &best);
    Some(FamilySearch { best, rivals })
}

/// Returns the family with the more probable of the two forms of the FV curve at zero velocity, then the family with
/// the other form. The second is `None` if the other form does not apply or gives no finite force. Both forms have the
/// same number of parameters, so the smaller χ² decides.
fn by_form_at_rest(now: FamilyStructure, settings: &[SettingTests]) -> (FamilyStructure, Option<FamilyStructure>) {
    let other = with_other_form(&now.hypothesis.template).and_then(|template| {
        let hypothesis = FamilyHypothesis { template, ..now.hypothesis.clone() };
        FamilyStructure::fit(hypothesis, now.components.clone(), settings, Effort::JUDGE)
    });
    let chi2 = |of: &FamilyStructure| of.refit.residuals.iter().map(refit::chi2).sum::<f64>();
    match other {
        Some(other) if chi2(&other) < chi2(&now) => (other, Some(now)),
        other => (now, other),
    }
}

/// Makes moves as long as the log posterior rises, but at most [`MOVES`]. Also returns the other families that were
/// refitted during the moves.
fn climb(
    start: FamilyStructure,
    settings: &[SettingTests],
    asked_for: &[&Structure],
    report_move: &(dyn Fn() + Sync),
) -> (FamilyStructure, Vec<Rival>) {
    let mut best = start;
    let mut tried = BTreeSet::new();
    let mut rivals = Vec::new();
    for _ in 0..MOVES {
        if cancel::asked() {
            break;
        }
        let mut better = |among: Vec<FamilyStructure>| {
            rivals.extend(among.iter().map(Rival::from));
            better(&best, among)
        };
        let next = better(toggle(&best, settings))
            .or_else(|| better(remove(&best, settings)))
            .or_else(|| better(add(&best, settings, asked_for, &mut tried)));
        report_move();
        let Some(next) = next else { break };
        rivals.push(Rival::from(&best));
        best = next;
    }
    (best, rivals)
}

/// Shares, in one step, all quantities whose separate values are unnecessary. A quantity is shared if the predicted log
/// posterior does not fall. The FV curve stays separate at each setting.
fn share(start: FamilyStructure, settings: &[SettingTests]) -> FamilyStructure {
    let varying = start.varying();
    let linear = Linearization::new(&start, settings);
    let without = |site: &Site| -> Vec<Site> { varying.iter().copied().filter(|other| other != site).collect() };
    let is_needed = |site: &Site| {
        *site == Site::Curve
            || linear.predict(&without(site)).is_none_or(|less| less.log_posterior < start.log_posterior)
    };
    let needed: Vec<Site> = varying.iter().copied().filter(is_needed).collect();
    if needed.len() == varying.len() {
        return start;
    }
    let Some(predicted) = linear.predict(&needed) else { return start };
    match FamilyStructure::fit(predicted.hypothesis, start.components.clone(), settings, Effort::JUDGE) {
        Some(less) if less.log_posterior > start.log_posterior => less,
        _ => start,
    }
}

/// Returns the quantities that vary after `site` has changed between varying and shared.
fn toggled(varying: &[Site], site: Site) -> Vec<Site> {
    if varying.contains(&site) {
        varying.iter().copied().filter(|other| *other != site).collect()
    } else {
        varying.iter().copied().chain([site]).collect()
    }
}

/// Refits the families in which one quantity changes between varying and shared, and that the prediction does not
/// exclude.
fn toggle(from: &FamilyStructure, settings: &[SettingTests]) -> Vec<FamilyStructure> {
    let varying = from.varying();
    let linear = Linearization::new(from, settings);
    let mut predicted: Vec<_> = sites(&from.hypothesis.template)
        .into_iter()
        .filter_map(|site| linear.predict(&toggled(&varying, site)))
        .filter(|predicted| predicted.log_posterior > from.log_posterior - PREDICTED)
        .collect();
    predicted.sort_by(|a, b| b.log_posterior.total_cmp(&a.log_posterior));
    predicted.truncate(REFITTED);
    predicted
        .into_par_iter()
        .filter_map(|p| FamilyStructure::fit(p.hypothesis, from.components.clone(), settings, Effort::JUDGE))
        .collect()
}

/// Refits the family without one of its effects, for each effect.
fn remove(from: &FamilyStructure, settings: &[SettingTests]) -> Vec<FamilyStructure> {
    (0..from.components.len())
        .into_par_iter()
        .filter_map(|place| from.without(place, settings, Effort::JUDGE))
        .collect()
}

/// Refits the family with each effect of `asked_for` that the family lacks and that was not `tried` before.
fn add(
    from: &FamilyStructure,
    settings: &[SettingTests],
    asked_for: &[&Structure],
    tried: &mut BTreeSet<(Form, Vec<Form>)>,
) -> Vec<FamilyStructure> {
    let mut key: Vec<Form> = from.components.iter().map(|c| (c.effect, c.form)).collect();
    key.sort_unstable();
    let mut list = Vec::new();
    for source in asked_for {
        for component in &source.components {
            let form = (component.effect, component.form);
            let is_there = from.components.iter().any(|own| own.effect == component.effect);
            if !is_there && tried.insert((form, key.clone())) {
                list.push((*source, component.effect));
            }
        }
    }
    let more = list.into_par_iter().flat_map_iter(|(source, effect)| {
        // Try the effect with shared parameters, and with separate parameters at each setting.
        [false, true].into_iter().filter_map(move |varies| {
            let (hypothesis, components) = with_effect(from, source, effect, varies)?;
            FamilyStructure::fit(hypothesis, components, settings, Effort::JUDGE)
        })
    });
    more.collect()
}

/// Returns the most probable of the families if it is clearly more probable than `from`.
fn better(from: &FamilyStructure, among: Vec<FamilyStructure>) -> Option<FamilyStructure> {
    let best = among.into_iter().max_by(|a, b| a.log_posterior.total_cmp(&b.log_posterior))?;
    (best.log_posterior > from.log_posterior + RISE).then_some(best)
}

/// Returns structures of single settings with effects to try in the family. Structures with a higher log posterior,
/// relative to the best structure of their setting, come first.
fn asked_for(found: &[StructureSearch]) -> Vec<&Structure> {
    let mut by_form: BTreeMap<Form, (f64, &Structure)> = BTreeMap::new();
    let mut note = |form: Form, gain: f64, structure| {
        let best = by_form.entry(form).or_insert((gain, structure));
        if best.0 < gain {
            *best = (gain, structure);
        }
    };
    for search in found {
        for component in &search.best.components {
            note((component.effect, component.form), f64::INFINITY, &search.best);
        }
        for trial in search.last.iter().filter(|trial| trial.unnamed.is_none()) {
            let gain = trial.structure.log_posterior - search.best.log_posterior;
            if gain > -ASKED_FOR {
                note(trial.form, gain, &trial.structure);
            }
        }
    }
    let mut all: Vec<(f64, &Structure)> = by_form.into_values().collect();
    all.sort_by(|a, b| b.0.total_cmp(&a.0));
    let beyond = all.iter().filter(|(gain, _)| *gain == f64::INFINITY).count() + EFFECTS;
    all.into_iter().take(beyond).map(|(_, structure)| structure).collect()
}

/// Returns for each quantity whether it depends on the setting, with the log odds of the dependence.
pub fn dependences(of: &FamilyStructure, settings: &[SettingTests]) -> Vec<Dependence> {
    let varying = of.varying();
    let linear = Linearization::new(of, settings);
    let of_site = |site: Site| {
        let varies = varying.contains(&site);
        let other = linear.predict(&toggled(&varying, site)).map_or(f64::NEG_INFINITY, |p| p.log_posterior);
        let rise = of.log_posterior - other;
        Dependence { site, varies, log_odds: if varies { rise } else { -rise } }
    };
    sites(&of.hypothesis.template).into_iter().map(of_site).collect()
}
