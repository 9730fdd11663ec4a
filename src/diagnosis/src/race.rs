//! Refits in heats, so that the unlikely cost little.

use super::decisions::SUSPECTED;
use super::edges::settle;
use super::evidence::Weighed;
use super::nearby::Nearby;
use super::screening::Screened;
use super::unbent::{is_bent, unbent};
use super::vocabulary::Candidate;
use dashpot_estimation::refit::{Effort, Refit, refit, refit_by};
use dashpot_estimation::samples::{Test, Thin};
use nalgebra::DMatrix;
use rayon::prelude::*;
use std::collections::{BTreeMap, BTreeSet};

/// Starts of one form that go on after the first steps of a refit: those steps say little of where a refit ends, but the worst of many
/// starts rarely win.
const GO_ON: usize = 2;
/// How many times the cost of the best start of its form a second one may have to go on.
const NEARLY: f64 = 1.15;
/// Forms of an effect that are refitted to the end.
const FORMS_JUDGED: usize = 2;
/// How far behind the best, in the units of [`REACH`], a second form of an effect may lie for that.
const SECOND_FORM: f64 = 4.0;
/// Effects that are refitted to the end at least, and how far, in units of the logarithm of the odds at two independent samples a test,
/// another may lie behind the best to be refitted too: a refit to the end rarely gains more.
const JUDGED: usize = 4;
const REACH: f64 = 8.0;

/// A start with the Jacobian there.
pub struct Started {
    /// Which of those screened.
    pub place: usize,
    /// The numbers it starts from.
    pub start: Vec<f64>,
    /// Derivatives there.
    pub jacobian: DMatrix<f64>,
}

/// Who runs, and on what.
pub struct Course<'a> {
    /// The starts screened.
    pub screened: &'a [Screened],
    /// Their candidates.
    pub list: &'a [Candidate],
    /// All samples.
    pub tests: &'a [Test],
    /// Strangeness of the explanation that they extend.
    pub strangeness: f64,
    /// Cheap residuals at all of them.
    pub nearby: &'a Nearby<'a>,
    /// A part of the samples.
    pub thin: &'a Thin,
    /// Cheap residuals at those.
    pub roughly: &'a Nearby<'a>,
}

/// Refits in three heats: by the cheap integration a few steps for all at a part of the samples, and more for the best starts of every
/// form; then exactly, with a Jacobian of their own, the best forms of every effect that may still turn out likeliest, since an updated
/// one stops short of the best; those that make the force jump from where a search without derivatives has put the jump.
pub fn race(started: Vec<Started>, course: &Course) -> Vec<(usize, Refit)> {
    let Course { screened, list, tests, strangeness, nearby, thin, roughly } = *course;
    let of = |place: usize| &screened[place].hypothesis;
    let first_heat = |s: Started| {
        let residual = |theta: &[f64]| roughly.residual(of(s.place), &thin.tests, theta);
        Some((s.place, refit_by(of(s.place), &thin.tests, &s.start, Some(s.jacobian), Effort::LOOK, &residual)?))
    };
    let by_cost = |refits: &mut Vec<(usize, Refit)>| refits.sort_by(|a, b| a.1.cost.total_cmp(&b.1.cost));
    let form_of = |r: &(usize, Refit)| screened[r.0].candidate;
    let mut ahead: Vec<(usize, Refit)> = started.into_par_iter().filter_map(first_heat).collect();
    by_cost(&mut ahead);
    let mut of_form: BTreeMap<usize, (usize, f64)> = BTreeMap::new();
    ahead.retain(|r| {
        let (count, best) = of_form.entry(form_of(r)).or_insert((0, r.1.cost));
        *count += 1;
        *count == 1 || *count <= GO_ON && r.1.cost < NEARLY * *best
    });
    let second_heat = |(place, known): (usize, Refit)| {
        let residual = |theta: &[f64]| roughly.residual(of(place), &thin.tests, theta);
        Some((place, refit_by(of(place), &thin.tests, &known.theta, None, Effort::COMPARE, &residual)?))
    };
    let mut refits: Vec<(usize, Refit)> = ahead.into_par_iter().filter_map(second_heat).collect();
    by_cost(&mut refits);
    let mut seen: BTreeSet<usize> = BTreeSet::new();
    refits.retain(|r| seen.insert(form_of(r)));
    let as_it_is = |(place, known): (usize, Refit)| {
        let residual = nearby.residual(of(place), tests, &known.theta)?;
        Some((place, Refit::at(of(place), known.theta, residual, known.jacobian)))
    };
    let mut refits: Vec<(usize, Refit)> = refits.into_par_iter().filter_map(as_it_is).collect();
    by_cost(&mut refits);
    let odds = |r: &(usize, Refit)| {
        let numbers = list[form_of(r)].numbers();
        Weighed::new(of(r.0), &r.1, tests, numbers, strangeness).log_evidence(SUSPECTED)
    };
    let best = refits.iter().map(odds).fold(f64::NEG_INFINITY, f64::max);
    let (mut effects, mut forms): (Vec<&str>, Vec<usize>) = (Vec::new(), Vec::new());
    let finals: Vec<bool> = refits
        .iter()
        .map(|r| {
            let form = form_of(r);
            let effect = list[form].effect;
            let of_effect = forms.iter().filter(|f| list[**f].effect == effect).count();
            let is_new = !effects.contains(&effect);
            let behind = best - odds(r);
            let is_out = if is_new { effects.len() >= JUDGED && behind > REACH } else { behind > SECOND_FORM };
            if of_effect >= FORMS_JUDGED || is_out {
                return false;
            }
            if is_new {
                effects.push(effect);
            }
            forms.push(form);
            true
        })
        .collect();
    refits
        .into_par_iter()
        .zip(finals)
        .map(|(one, is_final)| {
            if !is_final {
                return one;
            }
            let (place, known) = one;
            let candidate = &list[screened[place].candidate];
            let start = if candidate.jumps {
                let fresh = known.theta.len() - candidate.fresh.len()..known.theta.len();
                settle(of(place), &known, fresh, &|theta| nearby.residual(of(place), tests, theta))
            } else {
                known.theta.clone()
            };
            let judged = refit(of(place), tests, &start, None, Effort::JUDGE).unwrap_or(known);
            let straight =
                if is_bent(of(place), tests, &judged.theta) { unbent(of(place), tests, judged) } else { judged };
            (place, straight)
        })
        .collect()
}
