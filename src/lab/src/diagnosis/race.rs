//! Refits in heats, so that the unlikely cost little.

use super::edges::settle;
use super::nearby::Nearby;
use super::refit::{Effort, Refit, refit, refit_by};
use super::samples::{Test, Thin};
use super::screening::Screened;
use super::unbent::{is_bent, unbent};
use super::vocabulary::Candidate;
use nalgebra::DMatrix;
use rayon::prelude::*;
use std::collections::BTreeSet;

/// Starts that go on after the first steps of a refit.
const GO_ON: usize = 8;
/// Effects whose best forms are refitted with a Jacobian of their own, forms of each, and the share of the best one's fall of
/// χ² from which further ones are: they may change places yet.
const JUDGED: usize = 3;
const FORMS_JUDGED: usize = 2;
const NEARLY: f64 = 0.9;
/// Share of the best one's fall of χ² that is worth it.
const WORTH: f64 = 0.4;
/// Shares of the excess that must be explained after the first and after the second heat to go on: what brings less will
/// not be named.
const STARTED: f64 = 0.05;
const HALFWAY: f64 = 0.15;

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
    /// Cheap residuals at all of them.
    pub nearby: &'a Nearby<'a>,
    /// Half of the samples.
    pub thin: &'a Thin,
    /// Cheap residuals at those.
    pub roughly: &'a Nearby<'a>,
}

/// Refits in three heats: by the cheap integration a few steps for all at half of the samples, and more at all samples for
/// the best; then exactly, with a Jacobian of their own, the best forms of the likeliest effects, since an updated one stops
/// short of the best; those that make the force jump from where a search without derivatives has put the jump. `before` is
/// the cost without any of them, at all samples and at half of them, `excess` what of it is no noise.
pub fn race(started: Vec<Started>, course: &Course, before: (f64, f64), excess: f64) -> Vec<(usize, Refit)> {
    let Course { screened, list, tests, nearby, thin, roughly } = *course;
    let of = |place: usize| &screened[place].hypothesis;
    let (before, before_thin) = before;
    let first_heat = |s: Started| {
        let residual = |theta: &[f64]| roughly.residual(of(s.place), &thin.tests, theta);
        Some((s.place, refit_by(of(s.place), &thin.tests, &s.start, Some(s.jacobian), Effort::LOOK, &residual)?))
    };
    let mut ahead: Vec<(usize, Refit)> = started.into_par_iter().filter_map(first_heat).collect();
    let by_cost = |refits: &mut Vec<(usize, Refit)>| refits.sort_by(|a, b| a.1.cost.total_cmp(&b.1.cost));
    by_cost(&mut ahead);
    let worth = |r: &(usize, Refit)| thin.share * (before_thin - r.1.cost) > STARTED * excess;
    let go_on = ahead.iter().filter(|r| worth(r)).count().min(GO_ON);
    let rest = ahead.split_off(go_on);
    let second_heat = |(place, known): (usize, Refit)| {
        let residual = |theta: &[f64]| nearby.residual(of(place), tests, theta);
        Some((place, refit_by(of(place), tests, &known.theta, None, Effort::COMPARE, &residual)?))
    };
    let as_it_is = |(place, known): (usize, Refit)| {
        let residual = nearby.residual(of(place), tests, &known.theta)?;
        let jacobian = nearby.jacobian(of(place), tests, &known.theta, &residual)?;
        Some((place, Refit::at(of(place), known.theta, residual, jacobian)))
    };
    // Of an effect that stays behind, the best start says enough.
    let effect_of = |r: &(usize, Refit)| list[screened[r.0].candidate].effect;
    let mut effects: BTreeSet<&str> = ahead.iter().map(effect_of).collect();
    let rest: Vec<(usize, Refit)> = rest.into_iter().filter(|r| effects.insert(effect_of(r))).collect();
    let mut refits: Vec<(usize, Refit)> = ahead.into_par_iter().filter_map(second_heat).collect();
    refits.par_extend(rest.into_par_iter().filter_map(as_it_is));
    by_cost(&mut refits);
    let best = refits.first().map_or(0.0, |best| before - best.1.cost);
    let (mut effects, mut forms): (Vec<&str>, Vec<usize>) = (Vec::new(), Vec::new());
    let finals: Vec<bool> = refits
        .iter()
        .map(|(place, known)| {
            let form = screened[*place].candidate;
            let effect = list[form].effect;
            let of_effect = forms.iter().filter(|f| list[**f].effect == effect).count();
            let fall = before - known.cost;
            let is_among_forms = of_effect < FORMS_JUDGED || fall > NEARLY * best;
            if fall < (WORTH * best).max(HALFWAY * excess) || forms.contains(&form) || !is_among_forms {
                return false;
            }
            if !effects.contains(&effect) {
                if effects.len() >= JUDGED {
                    return false;
                }
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
