//! Effects that got no name but explain a part of the disagreement: beside the names, and in the place of one.

use super::outcome::Rival;
use super::wording::percent;
use super::{effects, phrases};
use dashpot_estimation::structure::context::Structure;
use dashpot_estimation::structure::search::{StructureSearch, Visited};
use dashpot_messages::Sentence;
use std::collections::BTreeMap;

/// Most rivals and suspects that are listed.
pub(super) const LISTED: usize = 4;
/// Probability below which an effect is no suspect.
const SUSPECT: f64 = 0.03;
/// Fraction of the disagreement that a suspect explains at least.
///
/// Without it, a model that leaves less than its allowed error was said to miss the friction that most dampers have.
const EXPLAINING: f64 = 0.01;

/// Fraction of what is beyond the noise that is explained: of mean squares in units of what noise and curves leave.
pub(super) fn explained(before: f64, after: f64) -> f64 {
    if before > 1.0 { ((before - after) / (before - 1.0)).clamp(-1.0, 1.0) } else { 0.0 }
}

/// What a search says of the effects that are not in its best structure.
pub(super) struct Open<'a> {
    pub search: &'a StructureSearch,
    /// The given model, or the reference's, refitted.
    pub start: &'a Structure,
    /// The most probable structure, refitted.
    pub best: &'a Structure,
    pub probability: &'a dyn Fn(&str) -> f64,
}

impl Open<'_> {
    /// Suspects: effects that are not in the best structure, most probable first.
    pub fn suspects(&self) -> Vec<Rival> {
        let before = self.best.evidence.mean();
        let mut all: Vec<Rival> = Vec::new();
        for trial in self.search.last.iter().filter(|t| t.unnamed.is_none() && self.is_open(t.form.0)) {
            let effect = trial.form.0;
            if all.iter().all(|r| r.effect != effect) {
                all.push(self.rival(effect, explained(before, trial.structure.evidence.mean())));
            }
        }
        // Rivals of a swap are in the table alone.
        for (effect, row) in self.best_rows(None) {
            if all.iter().all(|r| r.effect != effect) {
                all.push(self.rival(effect, explained(self.start.evidence.mean(), row.mean_square)));
            }
        }
        all.retain(is_listed);
        all.sort_by(|a, b| b.confidence.total_cmp(&a.confidence).then(a.effect.cmp(b.effect)));
        all.truncate(LISTED);
        all
    }

    /// Effects that explain the records in the place of a named one, most probable first, each in its most probable structure.
    pub fn rivals(&self, named: &str) -> Vec<Rival> {
        let mut rows: Vec<(&'static str, &Visited)> = self.best_rows(Some(named)).into_iter().collect();
        rows.sort_by(|(a, one), (b, other)| other.log_posterior.total_cmp(&one.log_posterior).then(a.cmp(b)));
        let before = self.start.evidence.mean();
        let all = rows.into_iter().map(|(effect, row)| self.rival(effect, explained(before, row.mean_square)));
        all.filter(is_listed).take(LISTED).collect()
    }

    /// Whether an effect might be missing: it has a card and is not in the best structure.
    fn is_open(&self, effect: &str) -> bool {
        self.best.components.iter().all(|c| c.effect != effect) && effects::card(effect).is_some()
    }

    /// The most probable structure of the table with each effect that is open, of those without another effect.
    fn best_rows(&self, without: Option<&str>) -> BTreeMap<&'static str, &Visited> {
        let mut best: BTreeMap<&'static str, &Visited> = BTreeMap::new();
        for (key, row) in self.search.table.iter().filter(|(key, _)| key.iter().all(|form| Some(form.0) != without)) {
            for effect in key.iter().map(|form| form.0).filter(|effect| self.is_open(effect)) {
                let known = best.entry(effect).or_insert(row);
                if known.log_posterior < row.log_posterior {
                    *known = row;
                }
            }
        }
        best
    }

    fn rival(&self, effect: &'static str, explained: f64) -> Rival {
        let fraction = explained.max(0.0);
        let why = Sentence::from(phrases::EXPLAINS).with("percent", percent(fraction));
        Rival { effect, confidence: (self.probability)(effect), fraction, why }
    }
}

/// What explains nothing is probable because most dampers have it, and misses in none of these tests.
fn is_listed(rival: &Rival) -> bool {
    rival.confidence >= SUSPECT && rival.fraction >= EXPLAINING
}
