//! Effects that are not named but explain a part of the disagreement of model and records, in addition to named effects
//! or instead of one.

use super::outcome::Rival;
use super::wording::percent;
use super::{effects, phrases};
use dashpot_estimation::structure::context::{Form, Structure};
use dashpot_estimation::structure::search::{StructureSearch, Visited};
use dashpot_messages::Sentence;
use std::collections::{BTreeMap, BTreeSet};

/// Largest number of rivals and suspects that are listed.
pub(super) const LISTED: usize = 4;
/// Smallest probability at which an effect is listed as a rival or suspect.
const SUSPECT: f64 = 0.03;
/// Smallest explained fraction of the disagreement at which an effect is listed as a rival or suspect.
///
/// Without this threshold, an accurate model was reported as incomplete because most dampers have friction.
const EXPLAINING: f64 = 0.01;

/// Returns the fraction of the excess mean square that an effect explains, from −1 to 1. `before` and `after` are the
/// mean square residuals without and with the effect, relative to the error expected from noise and curve form. The
/// excess is the part of `before` above 1.
pub(super) fn explained(before: f64, after: f64) -> f64 {
    if before > 1.0 { ((before - after) / (before - 1.0)).clamp(-1.0, 1.0) } else { 0.0 }
}

/// Structure of the table of a search, with its evaluation.
type Row<'a> = (&'a [Form], &'a Visited);

/// Results of a search, for the evaluation of effects that are not in the best structure.
pub(super) struct Open<'a> {
    pub search: &'a StructureSearch,
    /// The given model, or the model that was fitted to the reference, after a refit.
    pub start: &'a Structure,
    /// The most probable structure, refitted.
    pub best: &'a Structure,
    pub probability: &'a dyn Fn(&str) -> f64,
}

impl Open<'_> {
    /// Returns the suspects: effects that are not in the best structure, most probable first.
    pub fn suspects(&self) -> Vec<Rival> {
        let mut all: Vec<Rival> = Vec::new();
        for trial in self.search.last.iter().filter(|t| t.unnamed.is_none() && self.is_open(t.form.0)) {
            let effect = trial.form.0;
            if all.iter().all(|r| r.effect != effect) {
                // A trial adds one effect to the structure that the search found most probable.
                let without = self.search.best.evidence.mean();
                all.push(self.rival(effect, explained(without, trial.structure.evidence.mean())));
            }
        }
        // Structures in which another effect replaces an effect of the best structure are only in the table of the
        // search. An effect that only replaces one, and explains no more than the best structure does, is not missing.
        let visited: BTreeSet<&'static str> = self.search.table.keys().flatten().map(|form| form.0).collect();
        for effect in visited.into_iter().filter(|effect| self.is_open(effect)) {
            if all.iter().all(|r| r.effect != effect) {
                all.extend(self.alone(effect).map(|own| self.rival(effect, own)));
            }
        }
        all.retain(is_listed);
        all.sort_by(|a, b| b.confidence.total_cmp(&a.confidence).then(a.effect.cmp(b.effect)));
        all.truncate(LISTED);
        all
    }

    /// Returns the effects that explain the records instead of the effect `named`, most probable first. The values of
    /// each effect are those of the most probable structure that contains it and not `named`.
    pub fn rivals(&self, named: &str) -> Vec<Rival> {
        let mut rows: Vec<(&'static str, Row<'_>)> = self.best_rows(named).into_iter().collect();
        rows.sort_by(|(a, one), (b, other)| other.1.log_posterior.total_cmp(&one.1.log_posterior).then(a.cmp(b)));
        let before = self.start.evidence.mean();
        let all = rows.into_iter().map(|(effect, (_, row))| self.rival(effect, explained(before, row.mean_square)));
        all.filter(is_listed).take(LISTED).collect()
    }

    /// Returns whether an effect may be missing: it has a description and is not in the best structure.
    fn is_open(&self, effect: &str) -> bool {
        self.best.components.iter().all(|c| c.effect != effect) && effects::card(effect).is_some()
    }

    /// Returns, for each open effect, the most probable structure of the table that contains this effect and does not
    /// contain `without`.
    fn best_rows(&self, without: &str) -> BTreeMap<&'static str, Row<'_>> {
        let mut best: BTreeMap<&'static str, Row<'_>> = BTreeMap::new();
        for (key, row) in self.search.table.iter().filter(|(key, _)| key.iter().all(|form| form.0 != without)) {
            for effect in key.iter().map(|form| form.0).filter(|effect| self.is_open(effect)) {
                let known = best.entry(effect).or_insert((key, row));
                if known.1.log_posterior < row.log_posterior {
                    *known = (key, row);
                }
            }
        }
        best
    }

    /// Returns the fraction of the disagreement that an effect alone explains, or `None` if the search did not show it.
    ///
    /// It follows from the most probable structure that the search visited with and without the effect. It is at most
    /// what this structure explains of the best one.
    fn alone(&self, effect: &str) -> Option<f64> {
        let best = self.best.evidence.mean();
        let pairs = self.search.table.iter().filter_map(|(key, row)| {
            let less: Vec<Form> = key.iter().filter(|form| form.0 != effect).copied().collect();
            let without = self.search.table.get(&less).filter(|_| less.len() < key.len())?;
            Some((row, without.mean_square))
        });
        let (row, without) = pairs.max_by(|(a, _), (b, _)| a.log_posterior.total_cmp(&b.log_posterior))?;
        Some(explained(without, row.mean_square).min(explained(best, row.mean_square)))
    }

    fn rival(&self, effect: &'static str, explained: f64) -> Rival {
        let fraction = explained.max(0.0);
        let why = Sentence::from(phrases::EXPLAINS).with("percent", percent(fraction));
        Rival { effect, confidence: (self.probability)(effect), fraction, why }
    }
}

/// Returns whether a rival is listed. An effect that explains nothing is not listed, although it may be probable
/// because most dampers have it.
fn is_listed(rival: &Rival) -> bool {
    rival.confidence >= SUSPECT && rival.fraction >= EXPLAINING
}
