//! Inputs of a structure search, and the refitted structures that it compares.

use super::component::Component;
use super::curve_at_rest::with_other_form;
use super::curve_points::with_enough_points;
use super::evidence::{Evidence, noise_chi2};
use super::prior_odds::log_prior;
use super::series_restart::{has_implausible_series, restart_series};
use crate::hypothesis::{Free, Hypothesis};
use crate::prior_set::PriorSet;
use crate::refit::{Effort, Refit, refit};
use crate::samples::Test;
use crate::situation::Situation;
use crate::unknowns::{CurveName, Unknown};
use crate::vocabulary::Candidate;
use dashpot_records::Record;

/// Names of an effect and of its form.
pub type Form = (&'static str, &'static str);

/// Inputs of a structure search.
pub struct SearchContext<'a> {
    /// The records of the campaign.
    pub records: &'a [&'a Record],
    /// Tests of the records.
    pub tests: &'a [Test],
    /// Whether a candidate may be part of the structure.
    pub is_allowed: &'a (dyn Fn(&Candidate, &Situation) -> bool + Sync),
    /// Candidates in addition to the vocabulary: changes relative to a reference damper.
    pub changes: &'a [Candidate],
    /// Priors from known facts about this damper.
    pub priors: &'a PriorSet,
    /// Largest number of rare effects that may be added, such as faults. With 0, no effect is added.
    pub most: usize,
    /// Callback for the progress of the search, 0 to 1.
    pub progress: &'a (dyn Fn(f64) + Sync),
}

/// A model with its effects, refitted.
#[derive(Clone)]
pub struct Structure {
    /// The model with its free parameters.
    pub hypothesis: Hypothesis,
    /// Result of the refit.
    pub refit: Refit,
    /// Effects of the structure.
    pub components: Vec<Component>,
    /// Evidence from the residuals.
    pub evidence: Evidence,
    /// Log posterior, up to a constant that all structures of a search share.
    pub log_posterior: f64,
    /// The part of the log posterior that is independent of the records: prior odds of the effects and prior of the
    /// parameter values.
    pub log_prior: f64,
}

impl Structure {
    /// Makes a structure from a hypothesis and its refit.
    pub fn new(hypothesis: Hypothesis, refit: Refit, components: Vec<Component>, tests: &[Test]) -> Structure {
        let hypothesis = hypothesis.starting_at(&refit.theta);
        let numbers = numbers(&hypothesis, &components);
        let evidence = Evidence::new(&hypothesis, &refit.theta, &refit.residual, tests, numbers);
        let effects: Vec<_> = components.iter().map(|c| (c.effect, c.form, c.is_of_measurement())).collect();
        let odds = log_prior(&effects, &hypothesis.priors);
        let log_posterior = evidence.log_evidence() + odds;
        let log_prior = odds - evidence.negative_log_prior;
        Structure { hypothesis, refit, components, evidence, log_posterior, log_prior }
    }

    /// Fits a hypothesis with its components from its start. Returns `None` if the model gives no finite force.
    pub fn fit(
        hypothesis: Hypothesis,
        components: Vec<Component>,
        tests: &[Test],
        effort: Effort,
    ) -> Option<Structure> {
        let end = refit(&hypothesis, tests, &hypothesis.start(), None, effort)?;
        Some(Structure::new(hypothesis, end, components, tests))
    }

    /// Counts the free parameters. Weakly determined parameters count half.
    pub fn numbers(&self) -> f64 {
        numbers(&self.hypothesis, &self.components)
    }

    /// Returns the effects of the structure with their forms, sorted.
    pub fn key(&self) -> Vec<Form> {
        key(self.components.iter())
    }

    /// Returns the key of the structure without the effect with the index `place`.
    pub fn key_without(&self, place: usize) -> Vec<Form> {
        key(self.components.iter().enumerate().filter(|(k, _)| *k != place).map(|(_, component)| component))
    }

    /// Returns the structure without the effect with the index `place`, refitted. Returns `None` if the model gives no
    /// finite force.
    pub fn without(&self, place: usize, tests: &[Test], effort: Effort) -> Option<Structure> {
        let hypothesis = self.components[place].remove(&self.hypothesis, &self.refit.theta);
        let mut components = self.components.clone();
        components.remove(place);
        Structure::fit(hypothesis, components, tests, effort)
    }

    /// Returns the structure without the effect with the index `place`, refitted. The refit ends after a few steps if
    /// the log posterior is then more than `reach` below that of this structure. Returns `None` if the model gives no
    /// finite force.
    pub fn without_within(&self, place: usize, tests: &[Test], reach: f64) -> Option<Structure> {
        let first = self.without(place, tests, Effort::SCREEN)?;
        if first.log_posterior < self.log_posterior - reach {
            return Some(first);
        }
        let judged = first.refitted(tests, Effort::JUDGE).filter(|judged| judged.log_posterior > first.log_posterior);
        Some(judged.unwrap_or(first))
    }

    /// Removes effects of zero strength. The forces stay unchanged, and reports contain no effect of 0 N.
    pub fn without_absent(self, tests: &[Test]) -> Structure {
        let absent = self.components.iter().position(|c| c.is_absent(&self.hypothesis, &self.refit.theta));
        match absent.and_then(|place| self.without(place, tests, Effort::JUDGE)) {
            Some(less) => less.without_absent(tests),
            None => self,
        }
    }

    /// Refits from the current parameters. Returns `None` if the model gives no finite force.
    pub fn refitted(&self, tests: &[Test], effort: Effort) -> Option<Structure> {
        Structure::fit(self.hypothesis.clone(), self.components.clone(), tests, effort)
    }

    /// Refits from the current parameters, and adds points to the FV curve where they reduce χ² enough. The refit also
    /// tries the other form of the curve at zero velocity, and restarts an implausible series element.
    pub fn refined(&self, tests: &[Test], effort: Effort) -> Structure {
        let Some(mut fine) = refit(&self.hypothesis, tests, &self.refit.theta, None, effort) else {
            return self.clone();
        };
        if has_implausible_series(&self.hypothesis, tests, &fine.theta) {
            fine = restart_series(&self.hypothesis, tests, fine);
        }
        let now = likelier_at_rest((self.hypothesis.clone().starting_at(&fine.theta), fine), tests, effort);
        let finer = with_enough_points(now.clone(), tests, noise_chi2(tests));
        let of = |(hypothesis, refit): (Hypothesis, Refit)| {
            Structure::new(hypothesis, refit, self.components.clone(), tests)
        };
        let (plain, finer) = (of(now), of(finer));
        if finer.log_posterior > plain.log_posterior { finer } else { plain }
    }
}

/// Refits with the other form of the FV curve at zero velocity, and returns the form with the smaller χ².
fn likelier_at_rest(now: (Hypothesis, Refit), tests: &[Test], effort: Effort) -> (Hypothesis, Refit) {
    let other = with_other_form(&now.0).and_then(|other| {
        let refitted = refit(&other, tests, &now.1.theta, None, effort)?;
        Some((other.starting_at(&refitted.theta), refitted))
    });
    match other {
        Some(other) if other.1.chi2 < now.1.chi2 => other,
        _ => now,
    }
}

/// Returns effects with their forms, sorted.
fn key<'c>(components: impl Iterator<Item = &'c Component>) -> Vec<Form> {
    let mut key: Vec<Form> = components.map(|c| (c.effect, c.form)).collect();
    key.sort_unstable();
    key
}

/// Counts the free parameters, with weakly determined ones as half. Points of the FV curve also count as parameters.
fn numbers(hypothesis: &Hypothesis, components: &[Component]) -> f64 {
    let points = hypothesis
        .numbers
        .iter()
        .filter(|n| matches!(n.free, Free::Model(Unknown::Rise { curve: CurveName::Fv, .. })))
        .count();
    points as f64 + components.iter().map(|c| c.numbers).sum::<f64>()
}
