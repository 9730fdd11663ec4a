//! Refits in heats, so that the unlikely cost little.

use super::nearby::Nearby;
use super::refit::{Effort, Refit, refit, refit_by};
use super::samples::Test;
use super::screening::Screened;
use super::unbent::{is_bent, unbent};
use super::vocabulary::Candidate;
use nalgebra::DMatrix;
use rayon::prelude::*;

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

/// Refits in three heats: by the cheap integration a few steps for all and more for the better half, then exactly, with a
/// Jacobian of their own, the best forms of the likeliest effects, since an updated one stops short of the best. `before` is
/// the cost without any of them, `excess` what of it is no noise.
pub fn race(
    started: Vec<Started>,
    screened: &[Screened],
    list: &[Candidate],
    tests: &[Test],
    nearby: &Nearby,
    before: f64,
    excess: f64,
) -> Vec<(usize, Refit)> {
    let of = |place: usize| &screened[place].hypothesis;
    let look = |place: usize, start: &[f64], jacobian: DMatrix<f64>, effort: Effort| {
        let residual = |theta: &[f64]| nearby.residual(of(place), tests, theta);
        refit_by(of(place), tests, start, Some(jacobian), effort, &residual)
    };
    let mut refits: Vec<(usize, Refit)> = started
        .into_par_iter()
        .filter_map(|s| Some((s.place, look(s.place, &s.start, s.jacobian, Effort::LOOK)?)))
        .collect();
    let by_cost = |refits: &mut Vec<(usize, Refit)>| refits.sort_by(|a, b| a.1.cost.total_cmp(&b.1.cost));

    by_cost(&mut refits);
    let started = refits.iter().filter(|r| before - r.1.cost > STARTED * excess).count();
    let rest = refits.split_off(started.min(GO_ON));
    let mut refits: Vec<(usize, Refit)> = refits
        .into_par_iter()
        .filter_map(|(place, known)| Some((place, look(place, &known.theta, known.jacobian, Effort::COMPARE)?)))
        .collect();
    refits.extend(rest);
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
            let judged = refit(of(place), tests, &known.theta, None, Effort::JUDGE).unwrap_or(known);
            let straight =
                if is_bent(of(place), tests, &judged.theta) { unbent(of(place), tests, judged) } else { judged };
            (place, straight)
        })
        .collect()
}
