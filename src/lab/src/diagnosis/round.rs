//! One look at what is left: which effects are likely, everything refitted with each, and how well each then stands.

use super::evidence::{Evidence, effective_count, is_unsettled, left_out};
use super::far_fetched::{Plausibility, plausibility};
use super::hypothesis::Hypothesis;
use super::nearby::Nearby;
use super::race::{Course, Started, race};
use super::refit::Refit;
use super::samples::{Test, Thin};
use super::screening::{Projection, Screened, screen};
use super::search::{Added, QUIET};
use super::situation::Situation;
use super::vocabulary::{Candidate, candidates};
use crate::identification::sensitivity::Accuracy;
use crate::records::Record;
use rayon::prelude::*;
use std::collections::BTreeSet;

/// Effects whose best start is refitted in full.
const REFITTED: usize = 7;
/// Confidence from which an effect is added.
pub const NAMED: f64 = 0.5;

/// What is looked at, and what may be tried.
pub struct Ground<'a> {
    /// The records.
    pub records: &'a [&'a Record],
    /// Their tests.
    pub tests: &'a [Test],
    /// Expected χ² of noise.
    pub floor: f64,
    /// What χ² was above that before anything was added.
    pub original: f64,
    /// Whether an effect may be tried.
    pub allowed: &'a (dyn Fn(&str) -> bool + Sync),
}

/// An effect that was tried by a full refit.
#[derive(Clone)]
pub struct Tried {
    /// The form tried.
    pub candidate: Candidate,
    /// The explanation with it.
    pub hypothesis: Hypothesis,
    /// Where the refit ended.
    pub refit: Refit,
    /// What it brought.
    pub evidence: Evidence,
    /// Probability that its name is the right one.
    pub confidence: f64,
}

impl Tried {
    /// Whether it may be named.
    pub fn convinces(&self) -> bool {
        self.candidate.unnamed.is_none() && self.confidence >= NAMED && self.evidence.is_admissible()
    }
}

/// One round: what was tried, likeliest first; one entry per effect.
pub struct Round {
    /// χ² before.
    pub before: f64,
    /// All effects that were refitted, each in the form that fits best.
    pub tried: Vec<Tried>,
    /// Their other forms, as far as those were refitted.
    pub other_forms: Vec<Tried>,
    /// Effects that leave no trace in these tests, with what is left of their response, in σ².
    pub invisible: Vec<(&'static str, f64)>,
}

impl Round {
    /// Those tried that have a name, likeliest first.
    pub fn named(&self) -> impl Iterator<Item = &Tried> {
        self.tried.iter().filter(|t| t.candidate.unnamed.is_none())
    }
}

/// Effects that differ in their curvature only are no rivals: whichever fits better speaks for both.
fn family(effect: &str) -> &str {
    match effect {
        "gas_spring" | "parallel_spring" => "spring",
        other => other,
    }
}

/// One round of screening, refitting and judging; `None` where the explanation makes no finite force.
pub fn look(ground: &Ground, last: &(Hypothesis, Refit), added: &[Added], progress: &dyn Fn(&str)) -> Option<Round> {
    let tests = ground.tests;
    let (hypothesis, at) = last;
    let at = match hypothesis.jacobian(Accuracy::Cheap, tests, &at.theta) {
        Some(jacobian) => Refit { jacobian, ..at.clone() },
        None => at.clone(),
    };
    let nearby = Nearby::new(hypothesis, &at, tests)?;
    let thin = Thin::new(tests);
    let at_thin = Refit::at(
        hypothesis,
        at.theta.clone(),
        at.residual.select_rows(&thin.rows),
        at.jacobian.select_rows(&thin.rows),
    );
    let projection = Projection::new(hypothesis, &at_thin);
    let situation = Situation::new(&hypothesis.params(&at.theta), ground.records, tests);
    let list: Vec<Candidate> = candidates(&situation)
        .into_iter()
        .filter(|c| {
            (c.unnamed.is_some() || (ground.allowed)(c.effect)) && !added.iter().any(|a| a.candidate.effect == c.effect)
        })
        .collect();
    let roughly = Nearby::new(hypothesis, &at_thin, &thin.tests)?;
    let screened = screen(hypothesis, &at_thin, &projection, &list, &thin.tests, &roughly);
    progress("refitting everything with each likely effect");
    let chosen = choose(&screened, &list);
    let started: Vec<Started> = chosen
        .par_iter()
        .filter_map(|place| {
            let s = &screened[*place];
            let residual_at = |theta: &[f64]| roughly.residual(&s.hypothesis, &thin.tests, theta);
            let (mut start, mut residual) = (s.start.clone(), residual_at(&s.start)?);
            if !s.moved && residual.norm_squared() > at_thin.residual.norm_squared() {
                // The base gave way to first order, which may be further than it goes: then it had better stay.
                let still = s.hypothesis.start();
                let there = residual_at(&still)?;
                if there.norm_squared() < residual.norm_squared() {
                    (start, residual) = (still, there);
                }
            }
            let jacobian = roughly.jacobian(&s.hypothesis, &thin.tests, &start, &residual)?;
            Some(Started { place: *place, start, jacobian })
        })
        .collect();
    let excess = (at.chi2 - ground.floor).max(1e-9);
    let course = Course { screened: &screened, list: &list, tests, nearby: &nearby, thin: &thin, roughly: &roughly };
    let refits = race(started, &course, (at.cost, at_thin.cost), excess);
    let unsettled = is_unsettled(tests) && !added.iter().any(|a| a.candidate.remembers);
    let base_left_out = left_out(tests, &at);
    let count = effective_count(tests).ln();
    let judged = |(place, refit): (usize, Refit)| {
        let s = &screened[place];
        let candidate = &list[s.candidate];
        let chi2_fall = at.cost - refit.cost;
        // Numbers that are held near an expected value cost less than free ones.
        let free = candidate.fresh.iter().map(|f| if f.deviation.is_some() { 0.5 } else { 1.0 }).sum::<f64>();
        let predicted = left_out(tests, &refit);
        let gains: Vec<f64> = base_left_out.iter().zip(&predicted).map(|(a, b)| (a / b).ln()).collect();
        let first = s.hypothesis.numbers.len() - candidate.fresh.len();
        let Plausibility { share: plausible, contrary } = plausibility(candidate, first, &s.hypothesis, &refit);
        let evidence = Evidence {
            chi2_fall,
            bic_fall: chi2_fall - free * count,
            share: chi2_fall / excess.max(QUIET * effective_count(tests)),
            of_all: chi2_fall / ground.original.max(QUIET * effective_count(tests)),
            size: (chi2_fall.max(0.0) / effective_count(tests)).sqrt(),
            margin: 0.0,
            left_out_gain: gains.iter().sum::<f64>() / gains.len().max(1) as f64,
            tests_better: gains.iter().filter(|g| **g > 0.0).count() as f64 / gains.len().max(1) as f64,
            excess: (excess / effective_count(tests)).sqrt(),
            numbers: candidate.fresh.len(),
            free,
            plausible,
            contrary,
            sponge: candidate.sponge,
            later: !added.is_empty(),
            unsettled: unsettled && !candidate.remembers,
        };
        Tried { candidate: candidate.clone(), hypothesis: s.hypothesis.clone(), refit, evidence, confidence: 0.0 }
    };
    let judged: Vec<Tried> = refits.into_par_iter().map(judged).collect();
    let (mut tried, mut other_forms): (Vec<Tried>, Vec<Tried>) = (Vec::new(), Vec::new());
    for entry in judged {
        match tried.iter_mut().find(|t| t.candidate.effect == entry.candidate.effect) {
            Some(other) if other.evidence.bic_fall >= entry.evidence.bic_fall => other_forms.push(entry),
            Some(other) => other_forms.push(std::mem::replace(other, entry)),
            None => tried.push(entry),
        }
    }
    tried.sort_by(|a, b| b.evidence.bic_fall.total_cmp(&a.evidence.bic_fall));
    let rivals = tried.iter().filter(|t| t.evidence.is_rival());
    let scores: Vec<(&str, f64)> = rivals.map(|t| (family(t.candidate.effect), t.evidence.standing())).collect();
    for entry in &mut tried {
        let own = family(entry.candidate.effect);
        let rival = scores.iter().filter(|(other, _)| *other != own).map(|s| s.1).fold(0.0, f64::max);
        entry.evidence.margin = entry.evidence.standing() - rival;
        entry.confidence = entry.evidence.confidence();
    }
    // What fits best is not always likeliest: it may need numbers that no damper shows.
    tried.sort_by(|a, b| b.evidence.log_odds().total_cmp(&a.evidence.log_odds()));
    // What may not be named gives way to what may, if that is of its family or it is no rival.
    let gives_way = |t: &Tried, to: &Tried| {
        !t.convinces() && (family(t.candidate.effect) == family(to.candidate.effect) || !t.evidence.is_rival())
    };
    let speaks = |k: &usize| tried[*k].convinces() && tried[..*k].iter().all(|t| gives_way(t, &tried[*k]));
    if let Some(speaker) = (1..tried.len()).find(speaks) {
        tried[..=speaker].rotate_right(1);
    }
    let mut invisible: Vec<(&'static str, f64)> = Vec::new();
    for candidate in list.iter().filter(|c| c.unnamed.is_none()) {
        let seen = screened
            .iter()
            .filter(|s| list[s.candidate].effect == candidate.effect)
            .map(|s| thin.share * s.visible)
            .fold(0.0, f64::max);
        if !invisible.iter().any(|(name, _)| *name == candidate.effect) {
            invisible.push((candidate.effect, seen));
        }
    }
    other_forms.sort_by(|a, b| b.evidence.bic_fall.total_cmp(&a.evidence.bic_fall));
    Some(Round { before: at.chi2, tried, other_forms, invisible })
}

/// Starts of each form that moved the base: what they answer to a step says little of where they end.
const MOVED: usize = 4;
/// Forms of an effect, and the share of the best start's gain from which a second one of the same form is tried as well.
const FORMS: usize = 2;
const NEARLY: f64 = 0.7;

/// The starts worth a refit: the best of the likeliest effects, and of the starts that moved the base the best of each
/// form.
fn choose(screened: &[Screened], list: &[Candidate]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..screened.len()).collect();
    order.sort_by(|a, b| screened[*b].gain.total_cmp(&screened[*a].gain));
    let mut chosen: Vec<usize> = Vec::new();
    let mut effects: Vec<&str> = Vec::new();
    for place in &order {
        let s = &screened[*place];
        let candidate = &list[s.candidate];
        if s.gain <= 0.0 && !s.moved {
            continue;
        }
        if s.moved {
            let of_form = chosen.iter().filter(|c| screened[**c].moved && screened[**c].candidate == s.candidate);
            if of_form.count() < MOVED {
                chosen.push(*place);
            }
            continue;
        }
        let of_effect = |c: &&usize| {
            let other = &screened[**c];
            !other.moved && list[other.candidate].effect == candidate.effect
        };
        let of_form = |c: &&usize| screened[**c].candidate == s.candidate;
        let forms: BTreeSet<usize> = chosen.iter().filter(of_effect).map(|c| screened[*c].candidate).collect();
        let same_form: Vec<&usize> = chosen.iter().filter(of_effect).filter(of_form).collect();
        let is_worth = match same_form[..] {
            [] => forms.len() < FORMS,
            [best] => s.gain > NEARLY * screened[*best].gain,
            _ => false,
        };
        if !is_worth {
            continue;
        }
        if !effects.contains(&candidate.effect) {
            if effects.len() >= REFITTED {
                continue;
            }
            effects.push(candidate.effect);
        }
        chosen.push(*place);
    }
    chosen
}
