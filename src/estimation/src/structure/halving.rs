//! Successive halving: many short refits, then longer ones of the best, then full ones of the very best.

use super::budget::Budget;
use super::coordinate_search::minimize;
use super::nearby::Nearby;
use super::screening::Screened;
use super::series_restart::{has_implausible_series, restart_series};
use crate::refit::{Effort, Refit, refit, refit_by};
use crate::samples::Test;
use crate::vocabulary::Candidate;
use nalgebra::DMatrix;
use rayon::prelude::*;
use std::collections::BTreeSet;

/// Largest distance from the most probable form after the second stage, in units of the log posterior, for a full refit.
///
/// A full refit rarely gains more.
const REACH: f64 = 8.0;

/// A start with the Jacobian there.
pub struct Entrant {
    /// Index among the screened starts.
    pub screened: usize,
    /// Numbers that it starts from.
    pub start: Vec<f64>,
    /// Derivatives there.
    pub jacobian: DMatrix<f64>,
}

/// What the refits work on.
pub struct Field<'a> {
    /// The screened starts.
    pub screened: &'a [Screened],
    /// Their candidates.
    pub list: &'a [Candidate],
    /// The tests.
    pub tests: &'a [Test],
    /// Residuals of the cheap integration, corrected by its error at the base.
    pub nearby: &'a Nearby<'a>,
    /// How many go on.
    pub budget: Budget,
}

/// Refits in three heats; returns one refit a form.
pub fn halve(
    entrants: Vec<Entrant>,
    field: &Field,
    log_posterior: &(dyn Fn(usize, &Refit) -> f64 + Sync),
) -> Vec<(usize, Refit)> {
    let Field { screened, list, tests, nearby, budget } = *field;
    let of = |place: usize| &screened[place].hypothesis;
    let form_of = |place: usize| screened[place].candidate;
    let by_posterior = |refits: &mut Vec<(f64, usize, Refit)>| refits.sort_by(|a, b| b.0.total_cmp(&a.0));
    let short = |entrant: Entrant| {
        let place = entrant.screened;
        let residual = |theta: &[f64]| nearby.residual(of(place), tests, theta);
        let end = refit_by(of(place), tests, &entrant.start, Some(entrant.jacobian), Effort::SCREEN, &residual)?;
        Some((log_posterior(place, &end), place, end))
    };
    let mut ahead: Vec<(f64, usize, Refit)> = entrants.into_par_iter().filter_map(short).collect();
    by_posterior(&mut ahead);
    let mut forms: BTreeSet<usize> = BTreeSet::new();
    ahead.retain(|(_, place, _)| forms.insert(form_of(*place)));
    let rest = ahead.split_off(budget.forms.min(ahead.len()));
    let longer = |(_, place, known): (f64, usize, Refit)| {
        let residual = |theta: &[f64]| nearby.residual(of(place), tests, theta);
        let jacobian = Some(known.jacobian.clone());
        let end = refit_by(of(place), tests, &known.theta, jacobian, Effort::COMPARE, &residual).unwrap_or(known);
        (log_posterior(place, &end), place, end)
    };
    let mut refits: Vec<(f64, usize, Refit)> = ahead.into_par_iter().map(longer).collect();
    by_posterior(&mut refits);
    let best = refits.first().map_or(f64::NEG_INFINITY, |r| r.0);
    let finals: Vec<bool> = refits.iter().enumerate().map(|(k, r)| k < budget.finals && best - r.0 < REACH).collect();
    let full = |((_, place, known), is_final): ((f64, usize, Refit), bool)| {
        if !is_final {
            return (place, known);
        }
        let candidate = &list[form_of(place)];
        let start = if candidate.jumps {
            let fresh = known.theta.len() - candidate.fresh.len()..known.theta.len();
            minimize(of(place), &known, fresh, &|theta| nearby.residual(of(place), tests, theta))
        } else {
            known.theta.clone()
        };
        let judged = refit(of(place), tests, &start, None, Effort::JUDGE).unwrap_or(known);
        let judged = if has_implausible_series(of(place), tests, &judged.theta) {
            restart_series(of(place), tests, judged)
        } else {
            judged
        };
        (place, judged)
    };
    let mut all: Vec<(usize, Refit)> = refits.into_par_iter().zip(finals).map(full).collect();
    all.extend(rest.into_iter().map(|(_, place, refit)| (place, refit)));
    all
}
