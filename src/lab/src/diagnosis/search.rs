//! Adding effects one after the other: screen, refit, judge, add, look again, and try to take each out again.

use super::evidence::{Evidence, effective_count, left_out, noise_chi2, noise_chi2_deviation};
use super::finer_curve::finer;
use super::hypothesis::{Free, Hypothesis};
use super::race::race;
use super::refit::{Effort, Refit, refit};
use super::samples::Test;
use super::screening::{Projection, Screened, screen};
use super::situation::Situation;
use super::vocabulary::{Candidate, candidates};
use crate::identification::unknowns::Unknown;
use crate::records::Record;
use nalgebra::DMatrix;
use rayon::prelude::*;

/// Effects whose best start is refitted in full.
const REFITTED: usize = 7;
/// Confidence from which an effect is added.
pub const NAMED: f64 = 0.5;
/// Mean excess per independent sample, in σ², below which nothing is missing that matters.
pub const QUIET: f64 = 0.1;
/// Standard deviations of the noise floor beyond that.
const SURE: f64 = 2.0;
/// Shares of the remaining and of the original excess that a later effect must explain: what is left after a right name is
/// often only the form of that effect, which another name would soak up.
const LATER_REMAINING: f64 = 0.25;
const LATER_ORIGINAL: f64 = 0.03;
/// Most independent samples a χ² difference may lose for an effect to be taken out again.
const REMOVABLE: f64 = 6.0;

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

/// One round: what was tried, best first; one entry per effect.
pub struct Round {
    /// χ² before.
    pub before: f64,
    /// All that were refitted.
    pub tried: Vec<Tried>,
    /// Effects that leave no trace in these tests, with what is left of their response, in σ².
    pub invisible: Vec<(&'static str, f64)>,
}

/// An effect in the explanation.
#[derive(Clone)]
pub struct Added {
    /// Which.
    pub candidate: Candidate,
    /// Evidence when it was added.
    pub evidence: Evidence,
    /// Confidence when it was added.
    pub confidence: f64,
    /// Places of its numbers.
    pub numbers: std::ops::Range<usize>,
}

/// The whole search.
pub struct Search {
    /// The base explanation and its refit.
    pub base: (Hypothesis, Refit),
    /// The last explanation and its refit.
    pub last: (Hypothesis, Refit),
    /// What it has added.
    pub added: Vec<Added>,
    /// All rounds; the last one added nothing.
    pub rounds: Vec<Round>,
    /// Expected χ² of noise.
    pub floor: f64,
    /// Mean excess per independent sample, in σ², below which nothing is missing that matters.
    pub quiet: f64,
    /// Names that were taken back in the end, since together they explain too little.
    pub taken_back: Vec<&'static str>,
}

/// What a search may do.
pub struct Limits<'a> {
    /// Most effects.
    pub effects: usize,
    /// Whether an effect may be tried.
    pub allowed: &'a (dyn Fn(&str) -> bool + Sync),
}

/// Runs the search from a base explanation.
pub fn search(
    base: Hypothesis,
    records: &[&Record],
    tests: &[Test],
    limits: &Limits,
    progress: &(dyn Fn(f64, &str) + Sync),
) -> Option<Search> {
    progress(0.05, "refitting the model as it is");
    let start = base.start();
    let first = refit(&base, tests, &start, None, Effort::FINE)?;
    let base = base.starting_at(&first.theta);
    let floor = noise_chi2(tests);
    let quiet = QUIET + SURE * noise_chi2_deviation(tests) / effective_count(tests);
    let (base, first) = with_enough_points(base, first, tests, floor);
    let mut found = Search {
        base: (base.clone(), first.clone()),
        last: (base, first),
        added: Vec::new(),
        rounds: Vec::new(),
        floor,
        quiet,
        taken_back: Vec::new(),
    };
    loop {
        let left = (found.last.1.chi2 - floor) / effective_count(tests);
        let original = (found.base.1.chi2 - floor) / effective_count(tests);
        if !found.added.is_empty() && (left < quiet || left < LATER_ORIGINAL * original) {
            break;
        }
        let done = 0.1 + 0.8 * found.added.len() as f64 / limits.effects.max(1) as f64;
        progress(done, "screening effects");
        let round = look(&found, records, tests, limits, &|text| progress(done + 0.1, text));
        let best = round.tried.first().cloned();
        let before = round.before;
        found.rounds.push(round);
        let Some(best) = best else { break };
        if found.added.len() >= limits.effects || best.confidence < NAMED || !best.evidence.is_admissible() {
            break;
        }
        if !found.added.is_empty() {
            let fall = before - best.refit.chi2;
            let original = (found.base.1.chi2 - floor).max(1e-9);
            if fall < LATER_REMAINING * (before - floor) || fall < LATER_ORIGINAL * original {
                break;
            }
        }
        let numbers = found.last.0.numbers.len()..best.hypothesis.numbers.len();
        let fine = refit(&best.hypothesis, tests, &best.refit.theta, Some(best.refit.jacobian.clone()), Effort::FINE)?;
        found.last = (best.hypothesis.clone().starting_at(&fine.theta), fine);
        found.added.push(Added {
            candidate: best.candidate.clone(),
            evidence: best.evidence,
            confidence: best.confidence,
            numbers,
        });
        take_out_what_is_not_needed(&mut found, tests);
    }
    Some(found)
}

/// Fall of χ² that a further point of the FV curve must bring, and share of the excess that all of them must.
const PER_POINT: f64 = 4.0;
const BY_POINTS: f64 = 0.15;

/// With more points on the FV curve where they are worth it.
fn with_enough_points(base: Hypothesis, first: Refit, tests: &[Test], floor: f64) -> (Hypothesis, Refit) {
    let excess = first.chi2 - floor;
    let worth = |added: usize| (PER_POINT * added as f64).max(BY_POINTS * excess);
    let count = |h: &Hypothesis| h.base.list("fv_velocity").len();
    if excess < worth(count(&base)) {
        return (base, first);
    }
    let Some(finer) = finer(&base, &first.theta) else { return (base, first) };
    match refit(&finer, tests, &finer.start(), None, Effort::JUDGE) {
        Some(refitted) if first.chi2 - refitted.chi2 > worth(count(&finer) - count(&base)) => {
            (finer.starting_at(&refitted.theta), refitted)
        }
        _ => (base, first),
    }
}

impl Search {
    /// Share of the excess that all names together explain.
    pub fn together(&self) -> f64 {
        (self.base.1.chi2 - self.last.1.chi2) / (self.base.1.chi2 - self.floor).max(1e-9)
    }

    /// Takes all names back.
    pub fn take_back(&mut self) {
        self.taken_back = self.added.drain(..).map(|a| a.candidate.effect).collect();
        self.last = self.base.clone();
    }
}

/// Effects that differ in their curvature only are no rivals: whichever fits better speaks for both.
fn family(effect: &str) -> &str {
    match effect {
        "gas_spring" | "parallel_spring" => "spring",
        other => other,
    }
}

/// One round of screening, refitting and judging.
fn look(found: &Search, records: &[&Record], tests: &[Test], limits: &Limits, progress: &dyn Fn(&str)) -> Round {
    let (hypothesis, at) = &found.last;
    let at = match hypothesis.jacobian(tests, &at.theta) {
        Some(jacobian) => Refit { jacobian, ..at.clone() },
        None => at.clone(),
    };
    let projection = Projection::new(hypothesis, &at);
    let situation = Situation::new(&hypothesis.params(&at.theta), records, tests);
    let list: Vec<Candidate> = candidates(&situation)
        .into_iter()
        .filter(|c| (limits.allowed)(c.effect) && !found.added.iter().any(|a| a.candidate.effect == c.effect))
        .collect();
    let screened = screen(hypothesis, &at, &projection, &list, tests);
    progress("refitting everything with each likely effect");
    let chosen = choose(&screened, &list);
    let started: Vec<(usize, DMatrix<f64>)> = chosen
        .par_iter()
        .filter_map(|place| {
            let s = &screened[*place];
            let first = hypothesis.numbers.len();
            let residual = s.hypothesis.residual(tests, &s.start)?;
            let mut jacobian = DMatrix::zeros(residual.len(), s.start.len());
            jacobian.columns_mut(0, first).copy_from(&at.jacobian);
            for k in first..s.start.len() {
                jacobian.set_column(k, &s.hypothesis.column(tests, &s.start, &residual, k)?);
            }
            Some((*place, jacobian))
        })
        .collect();
    let refits = race(started, &screened, &list, tests, at.cost);
    let base_left_out = left_out(tests, &at);
    let count = effective_count(tests).ln();
    let excess = (at.chi2 - found.floor).max(1e-9);
    let mut tried: Vec<Tried> = Vec::new();
    for (place, refit) in refits {
        let s = &screened[place];
        let candidate = &list[s.candidate];
        let fresh = candidate.fresh.len();
        let chi2_fall = at.cost - refit.cost;
        // Numbers that are held near an expected value cost less than free ones.
        let free = candidate.fresh.iter().map(|f| if f.deviation.is_some() { 0.5 } else { 1.0 }).sum::<f64>();
        let predicted = left_out(tests, &refit);
        let gains: Vec<f64> = base_left_out.iter().zip(&predicted).map(|(a, b)| (a / b).ln()).collect();
        let values = &refit.theta[refit.theta.len() - fresh..];
        let plausible = candidate
            .fresh
            .iter()
            .zip(values)
            .zip(&s.hypothesis.numbers[hypothesis.numbers.len()..])
            .filter(|((f, value), number)| {
                // At its bound a number would go on: it stands for something else.
                let (low, high) = number.bounds;
                let margin = 1e-3 * (high - low).min(number.step);
                let inside = **value > low + margin && **value < high - margin;
                let value = physical(&f.free, **value);
                inside && (f.plausible.0..=f.plausible.1).contains(&value)
            })
            .count() as f64
            / fresh.max(1) as f64;
        let evidence = Evidence {
            chi2_fall,
            bic_fall: chi2_fall - free * count,
            share: chi2_fall / excess.max(QUIET * effective_count(tests)),
            size: (chi2_fall.max(0.0) / effective_count(tests)).sqrt(),
            margin: 0.0,
            log_fall: (at.chi2 / refit.chi2.max(1e-9)).ln(),
            left_out_gain: gains.iter().sum::<f64>() / gains.len().max(1) as f64,
            tests_better: gains.iter().filter(|g| **g > 0.0).count() as f64 / gains.len().max(1) as f64,
            excess: (excess / effective_count(tests)).sqrt(),
            plausible,
            sponge: candidate.sponge,
            later: !found.added.is_empty(),
        };
        let entry =
            Tried { candidate: candidate.clone(), hypothesis: s.hypothesis.clone(), refit, evidence, confidence: 0.0 };
        match tried.iter_mut().find(|t| t.candidate.effect == candidate.effect) {
            Some(other) if other.evidence.bic_fall >= entry.evidence.bic_fall => {}
            Some(other) => *other = entry,
            None => tried.push(entry),
        }
    }
    tried.sort_by(|a, b| b.evidence.bic_fall.total_cmp(&a.evidence.bic_fall));
    let scores: Vec<(&str, f64)> = tried.iter().map(|t| (family(t.candidate.effect), t.evidence.bic_fall)).collect();
    for entry in &mut tried {
        let own = family(entry.candidate.effect);
        let rival = scores.iter().filter(|(other, _)| *other != own).map(|s| s.1).fold(0.0, f64::max);
        entry.evidence.margin = entry.evidence.bic_fall - rival;
        entry.confidence = entry.evidence.confidence();
    }
    let mut invisible: Vec<(&'static str, f64)> = Vec::new();
    for candidate in &list {
        let seen = screened
            .iter()
            .filter(|s| list[s.candidate].effect == candidate.effect)
            .map(|s| s.visible)
            .fold(0.0, f64::max);
        if !invisible.iter().any(|(name, _)| *name == candidate.effect) {
            invisible.push((candidate.effect, seen));
        }
    }
    Round { before: at.chi2, tried, invisible }
}

/// Starts of each form that moved the base: what they answer to a step says little of where they end.
const MOVED: usize = 2;

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
        let forms = chosen.iter().filter(|c| {
            let other = &screened[**c];
            !other.moved && list[other.candidate].effect == candidate.effect
        });
        let same_form = forms.clone().any(|c| screened[*c].candidate == s.candidate);
        if same_form || forms.count() >= 2 {
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

/// A number in the unit that people use.
pub fn physical(free: &Free, value: f64) -> f64 {
    match free {
        Free::Model(Unknown::Log(_)) | Free::Cooling => value.exp(),
        _ => value,
    }
}

/// Takes out effects that later ones have made superfluous.
fn take_out_what_is_not_needed(found: &mut Search, tests: &[Test]) {
    let mut place = 0;
    while place + 1 < found.added.len() {
        let (hypothesis, at) = &found.last;
        let without = without(hypothesis, &at.theta, &found.added[place]);
        let refitted = refit(&without, tests, &without.start(), None, Effort::COMPARE);
        match refitted {
            Some(r) if r.cost - at.cost < REMOVABLE * found.added[place].candidate.fresh.len() as f64 => {
                let gone = found.added.remove(place);
                for other in &mut found.added {
                    if other.numbers.start >= gone.numbers.end {
                        let length = gone.numbers.len();
                        other.numbers = other.numbers.start - length..other.numbers.end - length;
                    }
                }
                found.last = (without.starting_at(&r.theta), r);
            }
            _ => place += 1,
        }
    }
}

/// An explanation without one of its effects.
pub fn without(from: &Hypothesis, theta: &[f64], added: &Added) -> Hypothesis {
    let mut to = from.clone().starting_at(theta);
    for element in added.candidate.elements {
        let _ = to.base.enable(element, false);
    }
    to.numbers.drain(added.numbers.clone());
    to
}
