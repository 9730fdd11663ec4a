//! The search for the most probable structure.
//!
//! From several starts, moves add, remove, swap and change the form of an effect. Every structure that was refitted stays in a table with
//! its log posterior; the search ends where no move from the best raises it. Probabilities of effects are sums over that table.

use super::component::Component;
use super::curve_points::with_enough_points;
use super::evidence::{Evidence, log_sum_exp, noise_chi2};
use super::expansion::{Budget, Expansion, Trial, expand};
use super::prior_odds::log_prior;
use super::series_restart::{is_bent, unbent};
use crate::cancel;
use crate::hypothesis::{Free, Hypothesis};
use crate::refit::{Effort, Refit, refit};
use crate::samples::Test;
use crate::situation::Situation;
use crate::unknowns::{CurveName, Unknown};
use crate::vocabulary::{Candidate, Unnamed};
use dashpot_core::list;
use dashpot_records::Record;
use rayon::prelude::*;
use std::collections::{BTreeMap, BTreeSet};

/// An effect with its form.
pub type Form = (&'static str, &'static str);

/// What a search works on.
pub struct SearchContext<'a> {
    /// The records.
    pub records: &'a [&'a Record],
    /// Their tests.
    pub tests: &'a [Test],
    /// Whether a candidate may be part of the structure.
    pub is_allowed: &'a (dyn Fn(&Candidate, &Situation) -> bool + Sync),
    /// Candidates beside the vocabulary: changes against a reference.
    pub changes: &'a [Candidate],
    /// Most effects that may be added.
    pub most: usize,
    /// Told how far the search is, 0 to 1.
    pub progress: &'a (dyn Fn(f64) + Sync),
}

/// A model with its effects, refitted.
#[derive(Clone)]
pub struct Structure {
    /// The model with its free numbers.
    pub hypothesis: Hypothesis,
    /// Where its refit ended.
    pub refit: Refit,
    /// Its effects.
    pub components: Vec<Component>,
    /// Its residuals.
    pub evidence: Evidence,
    /// Log posterior, up to a constant that all structures of a search share.
    pub log_posterior: f64,
}

impl Structure {
    /// From a refit.
    pub fn new(hypothesis: Hypothesis, refit: Refit, components: Vec<Component>, tests: &[Test]) -> Structure {
        let hypothesis = hypothesis.starting_at(&refit.theta);
        let numbers = numbers(&hypothesis, &components);
        let evidence = Evidence::new(&hypothesis, &refit.theta, &refit.residual, tests, numbers);
        let effects: Vec<_> = components.iter().map(|c| (c.effect, c.form, c.is_of_measurement())).collect();
        let log_posterior = evidence.log() + log_prior(&effects);
        Structure { hypothesis, refit, components, evidence, log_posterior }
    }

    /// Free numbers, weakly informed ones counted half.
    pub fn numbers(&self) -> f64 {
        numbers(&self.hypothesis, &self.components)
    }

    /// Its effects with their forms, sorted.
    pub fn key(&self) -> Vec<Form> {
        let mut key: Vec<Form> = self.components.iter().map(|c| (c.effect, c.form)).collect();
        key.sort_unstable();
        key
    }

    /// Without one of its effects, refitted.
    pub fn without(&self, place: usize, tests: &[Test], effort: Effort) -> Option<Structure> {
        let hypothesis = self.components[place].remove(&self.hypothesis, &self.refit.theta);
        let mut components = self.components.clone();
        components.remove(place);
        let refit = refit(&hypothesis, tests, &hypothesis.start(), None, effort)?;
        Some(Structure::new(hypothesis, refit, components, tests))
    }

    /// Refitted from where it stands, with more points on the FV curve where those are worth it.
    pub fn refined(&self, tests: &[Test], effort: Effort) -> Structure {
        let Some(mut fine) = refit(&self.hypothesis, tests, &self.refit.theta, None, effort) else {
            return self.clone();
        };
        if is_bent(&self.hypothesis, tests, &fine.theta) {
            fine = unbent(&self.hypothesis, tests, fine);
        }
        let now = (self.hypothesis.clone().starting_at(&fine.theta), fine);
        let finer = with_enough_points(now.clone(), tests, noise_chi2(tests));
        let of = |(hypothesis, refit): (Hypothesis, Refit)| {
            Structure::new(hypothesis, refit, self.components.clone(), tests)
        };
        let (plain, finer) = (of(now), of(finer));
        if finer.log_posterior > plain.log_posterior { finer } else { plain }
    }
}

/// Points of the FV curve and of the spring table are numbers too.
fn numbers(hypothesis: &Hypothesis, components: &[Component]) -> f64 {
    let points = hypothesis
        .numbers
        .iter()
        .filter(|n| matches!(n.free, Free::Model(Unknown::Rise { curve: CurveName::Fv, .. })))
        .count();
    points as f64 + components.iter().map(|c| c.numbers).sum::<f64>()
}

/// A row of the table of visited structures.
#[derive(Debug, Clone)]
pub struct Visited {
    /// Log posterior of the best refit.
    pub log_posterior: f64,
    /// Mean square residual.
    pub mean_square: f64,
}

/// Where a search ended.
pub struct StructureSearch {
    /// The most probable structure.
    pub best: Structure,
    /// All structures that were refitted.
    pub table: BTreeMap<Vec<Form>, Visited>,
    /// Errors without a name that were tried beside the best structure, with their log posterior.
    pub unnamed: Vec<(Unnamed, f64)>,
    /// The last expansion of the best structure.
    pub last: Vec<Trial>,
    /// Structures with a rival in the place of an effect of the best, most probable first.
    pub rivals: Vec<Trial>,
    /// Effects that leave no trace, with the squared norm of their response in σ².
    pub visible: Vec<(&'static str, f64)>,
    /// The starts, refitted, in the order given.
    pub starts: Vec<Structure>,
}

/// Rise of the log posterior below which a move is not made.
const RISE: f64 = 0.5;
/// Log posterior below the best expansion within which a form is tried again beside other effects.
const PROMISING: f64 = 25.0;
/// Forms of an effect that are tried again.
const FORMS: usize = 2;
/// Log posterior that a removal may cost for the effect's rivals to be tried in its place.
const CONTESTED: f64 = 12.0;
/// Rounds of add, remove and swap.
const ROUNDS: usize = 8;

impl StructureSearch {
    /// Searches from several starts: hypotheses with their components.
    pub fn run(context: &SearchContext, starts: Vec<(Hypothesis, Vec<Component>)>) -> Option<StructureSearch> {
        let tests = context.tests;
        let refitted: Vec<Structure> = starts
            .into_par_iter()
            .filter_map(|(hypothesis, components)| {
                let end = refit(&hypothesis, tests, &hypothesis.start(), None, Effort::JUDGE)?;
                Some(Structure::new(hypothesis, end, components, tests))
            })
            .collect();
        let first = refitted.iter().max_by(|a, b| a.log_posterior.total_cmp(&b.log_posterior))?.clone();
        let best = first.refined(tests, Effort::JUDGE);
        let mut search = StructureSearch {
            best,
            table: BTreeMap::new(),
            unnamed: Vec::new(),
            last: Vec::new(),
            rivals: Vec::new(),
            visible: Vec::new(),
            starts: refitted,
        };
        for structure in &search.starts {
            record(&mut search.table, structure);
        }
        search.climb(context);
        Some(search)
    }

    fn climb(&mut self, context: &SearchContext) {
        record(&mut self.table, &self.best);
        let mut promising: Option<BTreeSet<Form>> = None;
        let mut is_swapped = BTreeSet::new();
        let mut is_unchecked = true;
        for round in 0..ROUNDS {
            (context.progress)(round as f64 / ROUNDS as f64);
            if cancel::asked() {
                return;
            }
            if is_unchecked {
                self.remove_needless(context);
                is_unchecked = false;
            }
            let is_tried = |c: &Candidate| {
                c.unnamed.is_some() || promising.as_ref().is_none_or(|forms| forms.contains(&(c.effect, c.form)))
            };
            let budget = if promising.is_none() { Budget::WIDE } else { Budget::NARROW };
            let Some(Expansion { trials, visible }) = expand(context, &self.best, &is_tried, budget) else { return };
            self.note(&trials);
            if promising.is_none() {
                self.visible = visible;
            }
            let forms = promising.get_or_insert_with(BTreeSet::new);
            if forms.is_empty() {
                *forms = select_promising(&trials);
            }
            self.last = trials.clone();
            if std::env::var("DP").is_ok() {
                eprintln!(
                    "round {round} best {:.1} ms {:.2} {:?}",
                    self.best.log_posterior,
                    self.best.evidence.mean(),
                    self.best.key()
                );
                for t in trials
                    .iter()
                    .enumerate()
                    .filter(|(k, t)| *k < 8 || std::env::var("DF").is_ok_and(|f| t.form.0 == f))
                    .map(|x| x.1)
                {
                    eprintln!(
                        "   + {:?} {:.1} ms {:.2} impl {:.1}",
                        t.form,
                        t.structure.log_posterior,
                        t.structure.evidence.mean(),
                        t.structure.evidence.implausibility
                    );
                }
            }
            let added = trials.iter().find(|t| t.unnamed.is_none());
            if let Some(trial) = added.filter(|t| t.structure.log_posterior > self.best.log_posterior - 3.0) {
                let next = trial.structure.refined(context.tests, Effort::JUDGE);
                record(&mut self.table, &next);
                let next = self
                    .best_removal(context, &next)
                    .filter(|less| less.log_posterior > next.log_posterior)
                    .unwrap_or(next);
                if next.log_posterior > self.best.log_posterior + RISE {
                    self.best = next;
                    continue;
                }
            }
            if !self.swap(context, forms, &mut is_swapped) {
                return;
            }
            is_unchecked = true;
        }
    }

    /// Enters trials into the table.
    fn note(&mut self, trials: &[Trial]) {
        for trial in trials {
            match trial.unnamed {
                Some(unnamed) => self.unnamed.push((unnamed, trial.structure.log_posterior)),
                None => record(&mut self.table, &trial.structure),
            }
        }
    }

    /// The best structure with one effect less.
    fn best_removal(&mut self, context: &SearchContext, from: &Structure) -> Option<Structure> {
        let less: Vec<Structure> = (0..from.components.len())
            .into_par_iter()
            .filter_map(|place| from.without(place, context.tests, Effort::JUDGE))
            .collect();
        for structure in &less {
            record(&mut self.table, structure);
        }
        less.into_iter().max_by(|a, b| a.log_posterior.total_cmp(&b.log_posterior))
    }

    /// Removes effects as long as that raises the posterior.
    fn remove_needless(&mut self, context: &SearchContext) {
        while let Some(less) = self.best_removal(context, &self.best.clone()) {
            if less.log_posterior <= self.best.log_posterior {
                return;
            }
            if std::env::var("DP").is_ok() {
                eprintln!("removed -> {:?} {:.1}", less.key(), less.log_posterior);
            }
            self.best = less;
        }
    }

    /// Tries the rivals of every contested effect in its place. Returns whether one was better.
    fn swap(&mut self, context: &SearchContext, forms: &BTreeSet<Form>, done: &mut BTreeSet<Vec<Form>>) -> bool {
        for place in 0..self.best.components.len() {
            let Some(less) = self.best.without(place, context.tests, Effort::JUDGE) else { continue };
            if self.best.log_posterior - less.log_posterior > CONTESTED
                && self.best.components.len() > 1
                && self.best.components[place].form.is_empty()
            {
                continue;
            }
            if !done.insert(less.key()) {
                continue;
            }
            let own = self.best.components[place].effect;
            let is_tried =
                |c: &Candidate| c.unnamed.is_none() && (c.effect == own || forms.contains(&(c.effect, c.form)));
            let Some(Expansion { trials, .. }) = expand(context, &less, &is_tried, Budget::RIVALS) else { continue };
            self.note(&trials);
            self.rivals.extend(trials.iter().filter(|t| t.form.0 != own).take(2).cloned());
            if std::env::var("DP").is_ok() {
                eprintln!("swap {own} ({:.1})", less.log_posterior);
                for t in trials.iter().take(3) {
                    eprintln!(
                        "   + {:?} {:.1} ms {:.2}",
                        t.form,
                        t.structure.log_posterior,
                        t.structure.evidence.mean()
                    );
                }
            }
            let Some(trial) = trials.first() else { continue };
            if trial.structure.log_posterior > self.best.log_posterior - 2.0 && trial.structure.key() != self.best.key()
            {
                let next = trial.structure.refined(context.tests, Effort::JUDGE);
                record(&mut self.table, &next);
                if next.log_posterior > self.best.log_posterior + RISE {
                    self.best = next;
                    return true;
                }
            }
        }
        false
    }

    /// Probability of every effect: sums over the table, where posteriors are divided by `temperature`.
    pub fn probabilities(&self, temperature: f64) -> BTreeMap<&'static str, f64> {
        let logs: Vec<(&Vec<Form>, f64)> =
            self.table.iter().map(|(key, row)| (key, row.log_posterior / temperature)).collect();
        let whole = log_sum_exp(&logs.iter().map(|l| l.1).collect::<Vec<_>>());
        let mut all = BTreeMap::new();
        for (key, log) in logs {
            let effects: BTreeSet<&'static str> = key.iter().map(|form| form.0).collect();
            for effect in effects {
                *all.entry(effect).or_insert(0.0) += libm::exp(log - whole);
            }
        }
        all
    }
}

fn record(table: &mut BTreeMap<Vec<Form>, Visited>, structure: &Structure) {
    let row = Visited { log_posterior: structure.log_posterior, mean_square: structure.evidence.mean() };
    let known = table.entry(structure.key()).or_insert_with(|| row.clone());
    if known.log_posterior < row.log_posterior {
        *known = row;
    }
}

/// The forms of every effect that come near the most probable: those that are tried again beside other effects.
fn select_promising(trials: &[Trial]) -> BTreeSet<Form> {
    let best = trials.first().map_or(0.0, |t| t.structure.log_posterior);
    let mut counts: BTreeMap<&str, usize> = BTreeMap::new();
    let mut forms = BTreeSet::new();
    for trial in trials.iter().filter(|t| t.unnamed.is_none()) {
        let count = counts.entry(trial.form.0).or_default();
        *count += 1;
        if *count <= FORMS && best - trial.structure.log_posterior < PROMISING || *count == 1 {
            forms.insert(trial.form);
        }
    }
    forms
}

/// Names of the FV curve's parameter lists, for messages.
pub fn curve_points(structure: &Structure) -> usize {
    structure.hypothesis.base.list(list!("fv_velocity")).len()
}
