//! The search for the most probable structure.
//!
//! Starting from several models, moves add, remove or replace an effect, or change its form. Every refitted structure
//! stays in a table with its log posterior. The search ends when no move from the best structure raises its log
//! posterior. Probabilities of effects are sums over that table.

use super::budget::Budget;
use super::context::{Form, SearchContext, Structure};
use super::evidence::log_sum_exp;
use super::expansion::{Expansion, Trial, expand};
use super::prior_odds::{are_alternatives, is_rare};
use super::starts::StartModel;
use crate::cancel;
use crate::curve_part::CurvePart;
use crate::refit::Effort;
use crate::vocabulary::{Candidate, Unnamed};
use rayon::prelude::*;
use std::collections::{BTreeMap, BTreeSet};

/// Result of a visited structure, as a row of the table of a search.
#[derive(Debug, Clone)]
pub struct Visited {
    /// Log posterior of the best refit.
    pub log_posterior: f64,
    /// Log prior of the effects and of their parameter values.
    pub log_prior: f64,
    /// Mean square residual over all tests, relative to noise and curve discretization.
    pub mean_square: f64,
}

/// Result of a search.
pub struct StructureSearch {
    /// The most probable structure.
    pub best: Structure,
    /// All structures that were refitted.
    pub table: BTreeMap<Vec<Form>, Visited>,
    /// Unnamed errors (measurement errors outside the vocabulary of effects) that were added to a best structure, with
    /// the log posterior of each.
    pub unnamed: Vec<(Unnamed, f64)>,
    /// Trials of the last expansion: the best structure at that time with one more effect.
    pub last: Vec<Trial>,
    /// Structures in which a competing effect, or another form of the same effect, replaces an effect of the best
    /// structure.
    pub rivals: Vec<Trial>,
    /// Effects screened in the first expansion, with the squared norm of their weighted response. A small norm means
    /// that the records cannot show the effect.
    pub visible: Vec<(&'static str, f64)>,
    /// The given model, refitted. `None` if there is no given model, or if it gives no finite force.
    pub start: Option<Structure>,
}

/// Smallest rise of the log posterior at which the search makes a move.
const RISE: f64 = 0.5;
/// Smallest rise of the log posterior at which an effect is exchanged for another. An exchange does not enlarge the
/// structure, so a much smaller rise than [`RISE`] suffices.
const EXCHANGED: f64 = 0.05;
/// Largest deficit of log posterior, relative to the best form of an expansion, at which a form is tried again after
/// other effects were added. The best form of each effect is always tried again.
///
/// The limit also applies to the refit without an effect. If its deficit, relative to the structure with the effect, is
/// larger, the refit ends before convergence.
const PROMISING: f64 = 25.0;
/// Largest number of forms of an effect that are tried again.
const FORMS: usize = 2;
/// Largest decrease of the log posterior, due to the removal of an effect, at which every promising effect is tried as
/// a replacement. If the decrease is larger, only competing effects and other forms of the removed effect are tried.
/// This limit does not apply to an effect with a named form, and to the only effect of a structure. They are always
/// compared with every promising replacement.
const CONTESTED: f64 = 12.0;
/// Largest deficit of log posterior, relative to the best structure, at which a structure with an added effect is
/// refined. More points on the FV curve and the removal of another effect typically raise the log posterior by this
/// much.
///
/// For a replaced effect, the limit is [`SWAPPED`].
const ADDED: f64 = 3.0;
const SWAPPED: f64 = 2.0;
/// Form of a change relative to a reference damper.
const CHANGED: &str = "changed";
/// Largest root mean square residual, relative to noise and curve discretization, at which a structure counts as
/// complete. With a larger residual, the search also adds two effects at once.
///
/// Above this value, the form error of the model is larger than the noise.
pub const QUIET: f64 = 1.5;
/// Number of first effects of a pair that are tried if no single effect raises the log posterior. To each of them, a
/// second effect is added.
///
/// If two effects are missing, the first one alone leaves the residual of the other, so its log posterior may fall.
/// With 1, only the most probable first effect would be tried. Each first effect costs an expansion. Test:
/// `two_changes_are_found_in_three_tests`.
const FIRSTS: usize = 2;
/// Largest number of iterations of add, remove and replace, as a safeguard. A search normally ends earlier, when no
/// move raises the log posterior. For four measurement faults, friction and a spring, a search from the records alone
/// requires up to a dozen iterations.
const ROUNDS: usize = 24;

/// Forms that an expansion of the search tries.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Forms {
    /// All forms of all effects, in the first expansion.
    All,
    /// Forms that explained much of the records when they were last tried.
    Promising,
    /// All other forms, where no promising form raises the log posterior.
    Remaining,
}

impl Forms {
    /// Returns whether an expansion tries a form.
    fn admit(self, form: &Form, promising: &BTreeSet<Form>) -> bool {
        match self {
            Forms::All => true,
            Forms::Promising => promising.contains(form),
            Forms::Remaining => !promising.contains(form),
        }
    }

    fn budget(self) -> Budget {
        match self {
            Forms::All => Budget::WIDE,
            Forms::Promising => Budget::NARROW,
            Forms::Remaining => Budget::REMAINING,
        }
    }
}

impl StructureSearch {
    /// Searches from starts based on the records alone, then from the given model if that is more probable. Thus, the
    /// given model has an influence only if it improves the result. Returns `None` if no start gives a finite force. If
    /// no effect may be added, a given model with a finite force is required.
    pub fn run(
        context: &SearchContext,
        given: Option<StartModel>,
        from_records: Vec<StartModel>,
    ) -> Option<StructureSearch> {
        let tests = context.tests;
        let fit = |(hypothesis, components): StartModel| {
            Structure::fit(hypothesis.with_priors(context.priors), components, tests, Effort::JUDGE)
        };
        let given = given.and_then(fit);
        let starts: Vec<Structure> = from_records.into_par_iter().filter_map(fit).collect();
        let best = most_probable(starts.iter()).or(given.as_ref())?.refined(tests, Effort::JUDGE);
        let mut search = StructureSearch {
            best,
            table: BTreeMap::new(),
            unnamed: Vec::new(),
            last: Vec::new(),
            rivals: Vec::new(),
            visible: Vec::new(),
            start: given,
        };
        for structure in starts.iter().chain(&search.start) {
            record(&mut search.table, structure);
        }
        if context.most == 0 {
            // If no effect may be added, keep the given model and try each possible addition once.
            search.best = search.start.clone()?;
            if let Some(Expansion { trials, visible }) = expand(context, &search.best, &|_| true, Budget::WIDE) {
                search.note(&trials);
                (search.last, search.visible) = (trials, visible);
            }
            return Some(search);
        }
        search.climb(context);
        let given =
            search.start.as_ref().filter(|_| !starts.is_empty()).map(|given| given.refined(tests, Effort::JUDGE));
        if let Some(given) = given.filter(|given| given.log_posterior > search.best.log_posterior + RISE) {
            search.best = given;
            search.climb(context);
        }
        search.split_nested(context);
        search.best = search.best.without_absent(tests);
        record(&mut search.table, &search.best);
        Some(search)
    }

    /// Moves to more probable structures until no move raises the log posterior.
    ///
    /// The first expansion tries all forms, later ones those that it found promising. What is promising depends on the
    /// structure: where a spring is missing, a stop of rubber explains more than a hydraulic one. So where none of them
    /// raises the log posterior, all other forms are tried again, before exchanges and pairs.
    /// Test: `a_hydraulic_stop_is_found_behind_a_spring_that_was_missing_first`.
    fn climb(&mut self, context: &SearchContext) {
        record(&mut self.table, &self.best);
        let mut promising = BTreeSet::new();
        let mut is_swapped = BTreeSet::new();
        let (mut is_unchecked, mut forms) = (true, Forms::All);
        for round in 0..ROUNDS {
            (context.progress)(round as f64 / ROUNDS as f64);
            if cancel::asked() {
                return;
            }
            if is_unchecked {
                self.remove_needless(context);
                is_unchecked = false;
            }
            let is_tried = |c: &Candidate| match c.unnamed {
                Some(_) => forms != Forms::Remaining,
                None => forms.admit(&(c.effect, c.form), &promising),
            };
            let Some(Expansion { trials, visible }) = expand(context, &self.best, &is_tried, forms.budget()) else {
                return;
            };
            self.note(&trials);
            if forms == Forms::All {
                self.visible = visible;
                promising = select_promising(&trials);
            }
            // The remaining forms are added to the promising ones, which were tried from the same structure.
            if forms != Forms::Remaining {
                self.last.clear();
            }
            self.last.extend(trials.iter().cloned());
            self.last.sort_by(|a, b| b.structure.log_posterior.total_cmp(&a.structure.log_posterior));
            if self.add(context, &trials) {
                (is_unchecked, forms) = (true, Forms::Promising);
            } else if forms == Forms::Promising {
                forms = Forms::Remaining;
            } else if self.swap(context, &promising, &mut is_swapped) || self.add_two(context, &promising) {
                (is_unchecked, forms) = (true, Forms::Promising);
            } else {
                return;
            }
        }
    }

    /// Adds the most probable effect among `trials` if that raises the log posterior. Returns whether it did.
    fn add(&mut self, context: &SearchContext, trials: &[Trial]) -> bool {
        let rare = count_rare(&self.best, context);
        // Unnamed errors compete with effects. A rare effect is added only if it is more probable than every unnamed
        // error, and if fewer than `context.most` rare effects are present.
        let unnamed = self.last.iter().filter(|t| t.unnamed.is_some()).map(|t| t.structure.log_posterior);
        let unnamed = unnamed.fold(f64::NEG_INFINITY, f64::max);
        let may = |t: &&Trial| {
            t.unnamed.is_none()
                && (!is_rare(t.form.0, t.form.1, context.priors)
                    || rare < context.most && t.structure.log_posterior > unnamed)
        };
        let Some(trial) = trials.iter().find(may) else { return false };
        if trial.structure.log_posterior <= self.best.log_posterior - ADDED {
            return false;
        }
        let next = trial.structure.refined(context.tests, Effort::JUDGE);
        record(&mut self.table, &next);
        let less = self.best_removal(context, &next).filter(|less| less.log_posterior > next.log_posterior);
        let next = less.unwrap_or(next);
        if next.log_posterior <= self.best.log_posterior + RISE {
            return false;
        }
        self.best = next;
        true
    }

    /// Adds two effects at once if the residual of the best structure exceeds the noise. The first one is among the
    /// trials of the last expansion. Returns whether a pair was better.
    fn add_two(&mut self, context: &SearchContext, forms: &BTreeSet<Form>) -> bool {
        if self.best.evidence.mean() < QUIET * QUIET {
            return false;
        }
        let may = |t: &&Trial| t.unnamed.is_none() && count_rare(&t.structure, context) <= context.most;
        let mut firsts: Vec<Trial> = Vec::new();
        for trial in self.last.iter().filter(may) {
            if firsts.len() < FIRSTS && firsts.iter().all(|first| first.form.0 != trial.form.0) {
                firsts.push(trial.clone());
            }
        }
        let is_tried = |c: &Candidate| c.unnamed.is_none() && forms.contains(&(c.effect, c.form));
        let mut pairs = Vec::new();
        for first in firsts {
            let first = first.structure.refined(context.tests, Effort::JUDGE);
            let Some(Expansion { trials, .. }) = expand(context, &first, &is_tried, Budget::NARROW) else { continue };
            self.note(&trials);
            pairs.extend(trials.iter().find(may).cloned());
        }
        let Some(pair) = most_probable(pairs.iter().map(|trial| &trial.structure)) else { return false };
        let next = pair.refined(context.tests, Effort::JUDGE);
        record(&mut self.table, &next);
        if next.log_posterior <= self.best.log_posterior + RISE {
            return false;
        }
        self.best = next;
        true
    }

    /// Replaces nested changes of the FV curve, such as both sides and rebound, by changes without overlap: rebound and
    /// compression.
    ///
    /// Both sets describe the same curves. In the nested set, neither number is the total change of its part of the
    /// curve, and the table of structures would count one model twice.
    fn split_nested(&mut self, context: &SearchContext) {
        let nested = |forms: &[Form]| -> Option<(&'static str, &'static str)> {
            let changed = || forms.iter().filter(|(_, form)| *form == CHANGED).map(|(effect, _)| *effect);
            changed().find_map(|whole| changed().find_map(|part| Some((whole, CurvePart::rest(whole, part)?))))
        };
        // Each replacement reduces the overlap, so there are fewer replacements than effects.
        for _ in 0..self.best.components.len() {
            let Some((whole, rest)) = nested(&self.best.key()) else { break };
            let Some(place) = self.best.components.iter().position(|own| own.effect == whole) else { break };
            let Some(less) = self.best.without(place, context.tests, Effort::JUDGE) else { break };
            let is_rest = |c: &Candidate| c.effect == rest && c.form == CHANGED;
            let Some(Expansion { trials, .. }) = expand(context, &less, &is_rest, Budget::RIVALS) else { break };
            let Some(trial) = trials.first() else { break };
            let next = trial.structure.refined(context.tests, Effort::JUDGE);
            record(&mut self.table, &next);
            if next.log_posterior < self.best.log_posterior - SWAPPED {
                break;
            }
            self.best = next;
        }
        if nested(&self.best.key()).is_none() {
            self.table.retain(|forms, _| nested(forms).is_none());
        }
    }

    /// Adds trials to the table.
    fn note(&mut self, trials: &[Trial]) {
        for trial in trials {
            if let Some(unnamed) = trial.unnamed {
                self.unnamed.push((unnamed, trial.structure.log_posterior));
            }
            record(&mut self.table, &trial.structure);
        }
    }

    /// Returns the best structure with one effect removed. Returns `None` if no removal gives a finite force.
    fn best_removal(&mut self, context: &SearchContext, from: &Structure) -> Option<Structure> {
        let less: Vec<Structure> = (0..from.components.len())
            .into_par_iter()
            .filter_map(|place| from.without_within(place, context.tests, PROMISING))
            .collect();
        for structure in &less {
            record(&mut self.table, structure);
        }
        most_probable(less.iter()).cloned()
    }

    /// Removes effects as long as each removal increases the log posterior.
    fn remove_needless(&mut self, context: &SearchContext) {
        while let Some(less) = self.best_removal(context, &self.best.clone()) {
            if less.log_posterior <= self.best.log_posterior {
                return;
            }
            self.best = less;
        }
    }

    /// Tries replacements of each effect of the best structure: competing effects, and other forms of the effect.
    /// Returns whether a replacement was better.
    fn swap(&mut self, context: &SearchContext, forms: &BTreeSet<Form>, done: &mut BTreeSet<Vec<Form>>) -> bool {
        for place in 0..self.best.components.len() {
            if !done.insert(self.best.key_without(place)) {
                continue;
            }
            let Some(less) = self.best.without(place, context.tests, Effort::JUDGE) else { continue };
            let is_needed = self.best.log_posterior - less.log_posterior > CONTESTED
                && self.best.components.len() > 1
                && self.best.components[place].form.is_empty();
            let own = self.best.components[place].effect;
            let is_tried = |c: &Candidate| {
                let is_promising = are_alternatives(own, c.effect) || !is_needed && forms.contains(&(c.effect, c.form));
                c.unnamed.is_none() && (c.effect == own || is_promising)
            };
            let Some(Expansion { trials, .. }) = expand(context, &less, &is_tried, Budget::RIVALS) else { continue };
            self.note(&trials);
            self.rivals.extend(trials.iter().filter(|t| t.form.0 != own).take(2).cloned());
            let form = self.best.components[place].form;
            self.rivals.extend(trials.iter().find(|t| t.form.0 == own && t.form.1 != form).cloned());
            let Some(trial) = trials.first() else { continue };
            if trial.structure.log_posterior > self.best.log_posterior - SWAPPED
                && trial.structure.key() != self.best.key()
            {
                let next = trial.structure.refined(context.tests, Effort::JUDGE);
                record(&mut self.table, &next);
                if next.log_posterior > self.best.log_posterior + EXCHANGED {
                    self.best = next;
                    return true;
                }
            }
        }
        false
    }

    /// Returns the probability that the damper has a form that satisfies a condition. It is the sum of the weights of
    /// the visited structures with such a form, divided by the sum of all weights.
    pub fn probability_of(&self, at: Temperatures, is_in: &dyn Fn(&Form) -> bool) -> f64 {
        let all: Vec<f64> = self.table.values().map(|row| at.log_weight(row.log_posterior, row.log_prior)).collect();
        let own: Vec<f64> = self
            .table
            .iter()
            .filter(|(key, _)| key.iter().any(is_in))
            .map(|(_, row)| at.log_weight(row.log_posterior, row.log_prior))
            .collect();
        if own.is_empty() { 0.0 } else { libm::exp(log_sum_exp(&own) - log_sum_exp(&all)) }
    }

    /// Returns the probability of every effect of the table.
    pub fn probabilities(&self, at: Temperatures) -> BTreeMap<&'static str, f64> {
        let effects: BTreeSet<&'static str> = self.table.keys().flatten().map(|form| form.0).collect();
        effects.into_iter().map(|effect| (effect, self.probability_of(at, &|form| form.0 == effect))).collect()
    }
}

/// Divisors of log evidence and log prior in the probabilities of structures.
///
/// No model has exactly the form of the damper, and the table contains only the best structures. Therefore, the
/// likelihood overstates the support of the records for a structure.
#[derive(Debug, Clone, Copy)]
pub struct Temperatures {
    records: f64,
    prior: f64,
}

impl Temperatures {
    /// Divisors without a reference damper. The prior, which is the frequency of effects and of their values, counts in
    /// full.
    ///
    /// This is a power posterior (Grünwald & van Ommen, Bayesian Anal. 12, 2017), calibrated with the calibration split
    /// of the second laboratory. With a divisor of the evidence of 1, named effects are correct less often than their
    /// probability states. With 4, half of the names are lost.
    pub const WITHOUT_REFERENCE: Temperatures = Temperatures { records: 2.5, prior: 1.0 };
    /// Divisors for a comparison with a reference damper. An error in the form of the model affects both dampers
    /// equally, and a change is likely because users compare for a reason. If the prior counted in full, a fifth of the
    /// correct names would be lost.
    pub const AGAINST_REFERENCE: Temperatures = Temperatures { records: 2.0, prior: 2.0 };

    /// Returns the logarithm of a structure's weight, up to a constant that all structures share.
    pub fn log_weight(self, log_posterior: f64, log_prior: f64) -> f64 {
        (log_posterior - log_prior) / self.records + log_prior / self.prior
    }
}

/// Returns the number of rare effects of a structure.
fn count_rare(of: &Structure, context: &SearchContext) -> usize {
    of.components.iter().filter(|c| is_rare(c.effect, c.form, context.priors)).count()
}

/// Returns the structure with the largest log posterior.
fn most_probable<'s>(among: impl Iterator<Item = &'s Structure>) -> Option<&'s Structure> {
    among.max_by(|a, b| a.log_posterior.total_cmp(&b.log_posterior))
}

fn record(table: &mut BTreeMap<Vec<Form>, Visited>, structure: &Structure) {
    let Structure { log_posterior, log_prior, .. } = *structure;
    let row = Visited { log_posterior, log_prior, mean_square: structure.evidence.mean() };
    let known = table.entry(structure.key()).or_insert_with(|| row.clone());
    if known.log_posterior < row.log_posterior {
        *known = row;
    }
}

/// Selects the forms of every effect with a log posterior near that of the most probable form, and the best form of
/// every effect. The search tries them again after other effects were added.
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
