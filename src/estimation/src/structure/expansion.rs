//! All structures that have one more effect than a given structure.

use super::budget::Budget;
use super::component::Component;
use super::context::{Form, SearchContext, Structure};
use super::evidence::Evidence;
use super::halving::{Entrant, Field, Rating, halve};
use super::nearby::Nearby;
use super::prior_odds::log_prior;
use super::screening::{Projection, Screened, screen};

use crate::cancel;
use crate::refit::Refit;
use crate::samples::Test;
use crate::sensitivity::Accuracy;
use crate::situation::Situation;
use crate::vocabulary::{Candidate, Unnamed, candidates};
use rayon::prelude::*;
use std::collections::BTreeMap;

/// A structure with one more effect or one more unnamed error.
#[derive(Clone)]
pub struct Trial {
    /// Effect and form.
    pub form: Form,
    /// Kind of the unnamed error, if the trial adds one.
    pub unnamed: Option<Unnamed>,
    /// The structure.
    pub structure: Structure,
}

/// Refitted structures with one more effect than a given structure, and the visibility of the effects.
pub struct Expansion {
    /// Refitted structures, most probable first.
    pub trials: Vec<Trial>,
    /// Effects and their visibility: the squared norm of the part of an effect's response that other parameters cannot
    /// reproduce. The response is in units of the allowed errors.
    pub visible: Vec<(&'static str, f64)>,
}

/// Refits structures with one more effect than `from`, within a budget. Only candidates for which `is_tried` is true
/// are tried. Returns `None` if the model gives no finite force.
pub fn expand(
    context: &SearchContext,
    from: &Structure,
    is_tried: &(dyn Fn(&Candidate) -> bool + Sync),
    budget: Budget,
) -> Option<Expansion> {
    let tests: &[Test] = context.tests;
    let hypothesis = &from.hypothesis;
    let at = match hypothesis.jacobian(Accuracy::Derivatives, tests, &from.refit.theta) {
        Some(jacobian) => Refit { jacobian, ..from.refit.clone() },
        None => from.refit.clone(),
    };
    let nearby = Nearby::new(hypothesis, &at, tests)?;
    let projection = Projection::new(hypothesis, &at);
    let situation = Situation::new(&hypothesis.params(&at.theta), context.records, tests);
    let list: Vec<Candidate> = candidates(&situation)
        .into_iter()
        .chain(context.changes.iter().cloned())
        .filter(|c| from.components.iter().all(|own| own.effect != c.effect))
        .filter(|c| (context.is_allowed)(c, &situation) && is_tried(c))
        .collect();
    let screened = screen(hypothesis, &at, &projection, &list, tests, &nearby);
    let entrants: Vec<Entrant> = choose(&screened, &list, budget)
        .par_iter()
        .filter_map(|place| {
            if cancel::asked() {
                return None;
            }
            let s = &screened[*place];
            let residual_at = |theta: &[f64]| nearby.residual(&s.hypothesis, tests, theta);
            let (mut start, mut residual) = (s.start.clone(), residual_at(&s.start)?);
            if !s.moved && residual.norm_squared() > at.residual.norm_squared() {
                // The first-order step of the base parameters may be too large. Then, the start without this step may
                // have a smaller residual.
                let still = s.hypothesis.start();
                let there = residual_at(&still)?;
                if there.norm_squared() < residual.norm_squared() {
                    (start, residual) = (still, there);
                }
            }
            let jacobian = nearby.jacobian(&s.hypothesis, tests, &start, &residual)?;
            Some(Entrant { screened: *place, start, jacobian })
        })
        .collect();
    let structure_of = |place: usize, refit: Refit| {
        let candidate = &list[screened[place].candidate];
        let mut components = from.components.clone();
        components.push(Component::of_candidate(candidate));
        Structure::new(screened[place].hypothesis.clone(), refit, components, tests)
    };
    let field = Field { screened: &screened, list: &list, tests, nearby: &nearby, budget };
    let own: Vec<_> = from.components.iter().map(|c| (c.effect, c.form, c.is_of_measurement())).collect();
    let prior_with = |candidate: &Candidate| {
        let mut all = own.clone();
        all.push((candidate.effect, candidate.form, candidate.is_artefact()));
        log_prior(&all, context.priors)
    };
    let log_likelihood = from.evidence.log_likelihood();
    let rate = |place: usize, refit: &Refit| {
        let candidate = &list[screened[place].candidate];
        let numbers = from.numbers() + Component::of_candidate(candidate).numbers;
        let hypothesis = &screened[place].hypothesis;
        let evidence = Evidence::new(hypothesis, &refit.theta, &refit.residual, tests, numbers);
        Rating {
            log_posterior: evidence.log_evidence() + prior_with(candidate),
            rise: evidence.log_likelihood() - log_likelihood,
        }
    };
    let mut trials: Vec<Trial> = halve(entrants, &field, &rate)
        .into_iter()
        .map(|(place, refit)| {
            let candidate = &list[screened[place].candidate];
            Trial {
                form: (candidate.effect, candidate.form),
                unnamed: candidate.unnamed,
                structure: structure_of(place, refit),
            }
        })
        .collect();
    trials.sort_by(|a, b| b.structure.log_posterior.total_cmp(&a.structure.log_posterior));
    let mut visible: Vec<(&'static str, f64)> = Vec::new();
    for s in &screened {
        let candidate = &list[s.candidate];
        if candidate.unnamed.is_some() {
            continue;
        }
        match visible.iter_mut().find(|(name, _)| *name == candidate.effect) {
            Some((_, seen)) => *seen = seen.max(s.visible),
            None => visible.push((candidate.effect, s.visible)),
        }
    }
    Some(Expansion { trials, visible })
}

/// Selects the starts to refit by first-order gain: the best starts of every form, then the best of all forms up to the
/// budget. The best start of every effect is always included, because the first-order gain is too small for effects
/// that act only beyond a threshold.
fn choose(screened: &[Screened], list: &[Candidate], budget: Budget) -> Vec<usize> {
    let mut order: Vec<usize> = (0..screened.len()).collect();
    order.sort_by(|a, b| screened[*b].gain.total_cmp(&screened[*a].gain));
    let mut counts: BTreeMap<(Form, bool), usize> = BTreeMap::new();
    order.retain(|place| {
        let s = &screened[*place];
        let candidate = &list[s.candidate];
        let count = counts.entry(((candidate.effect, candidate.form), s.moved)).or_default();
        *count += 1;
        *count <= budget.starts[usize::from(s.moved)]
    });
    let mut effects: BTreeMap<&str, usize> = BTreeMap::new();
    let mut taken = 0;
    order.retain(|place| {
        let count = effects.entry(list[screened[*place].candidate].effect).or_default();
        *count += 1;
        let is_kept = taken < budget.entrants || *count == 1;
        taken += usize::from(is_kept);
        is_kept
    });
    order
}
