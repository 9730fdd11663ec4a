//! Successive halving: many short refits, then longer refits of the better starts, then full refits of the best starts.

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
use std::cmp::Ordering;
use std::collections::BTreeSet;

/// Largest deficit of log posterior, relative to the most probable form after the second stage, at which a form is
/// fully refitted. A full refit rarely raises the log posterior by more.
const REACH: f64 = 8.0;

/// Rise of the log likelihood above which an effect counts as explaining a part of the records. Such effects come first
/// in every stage, and only they are fully refitted. Every parameter costs at least 1, so an effect with a smaller rise
/// does not pay for its parameters.
///
/// Without this threshold, effects near zero strength would use up the budget, because their prior cost is small.
const BEGUN: f64 = 0.5;

/// Quality of a refit.
#[derive(Debug, Clone, Copy)]
pub struct Rating {
    /// Log posterior, up to a constant.
    pub log_posterior: f64,
    /// Rise of the log likelihood relative to the structure without the effect.
    pub rise: f64,
}

impl Rating {
    /// Returns whether the effect explains a part of the records so far.
    fn has_begun(&self) -> bool {
        self.rise > BEGUN
    }

    /// Orders refits, better refits first. Refits that explain a part of the records come first, then the log posterior
    /// decides.
    fn compare(&self, other: &Rating) -> Ordering {
        other.has_begun().cmp(&self.has_begun()).then(other.log_posterior.total_cmp(&self.log_posterior))
    }
}

/// Start of a refit, with the Jacobian at the start.
pub struct Entrant {
    /// Index among the screened starts.
    pub screened: usize,
    /// Parameters at the start.
    pub start: Vec<f64>,
    /// Derivatives of the weighted forces with respect to the parameters, at the start.
    pub jacobian: DMatrix<f64>,
}

/// Inputs that all refits share.
pub struct Field<'a> {
    /// The screened starts.
    pub screened: &'a [Screened],
    /// Candidates of the screened starts.
    pub list: &'a [Candidate],
    /// The tests.
    pub tests: &'a [Test],
    /// Residuals of the low-accuracy integration, corrected by its error at the hypothesis without the candidate.
    pub nearby: &'a Nearby<'a>,
    /// Numbers of refits in each stage.
    pub budget: Budget,
}

/// Refits the starts in three stages. Returns for each form the index of its screened start, and its refit.
pub fn halve(
    entrants: Vec<Entrant>,
    field: &Field,
    rate: &(dyn Fn(usize, &Refit) -> Rating + Sync),
) -> Vec<(usize, Refit)> {
    let Field { screened, list, tests, nearby, budget } = *field;
    let of = |place: usize| &screened[place].hypothesis;
    let form_of = |place: usize| screened[place].candidate;
    let sort = |refits: &mut Vec<(Rating, usize, Refit)>| refits.sort_by(|a, b| a.0.compare(&b.0));
    let short = |entrant: Entrant| {
        let place = entrant.screened;
        let residual = |theta: &[f64]| nearby.residual(of(place), tests, theta);
        let end = refit_by(of(place), tests, &entrant.start, Some(entrant.jacobian), Effort::SCREEN, &residual)?;
        Some((rate(place, &end), place, end))
    };
    let mut ahead: Vec<(Rating, usize, Refit)> = entrants.into_par_iter().filter_map(short).collect();
    sort(&mut ahead);
    let mut forms: BTreeSet<usize> = BTreeSet::new();
    ahead.retain(|(_, place, _)| forms.insert(form_of(*place)));
    let rest = ahead.split_off(budget.forms.min(ahead.len()));
    let longer = |(_, place, known): (Rating, usize, Refit)| {
        let residual = |theta: &[f64]| nearby.residual(of(place), tests, theta);
        let jacobian = Some(known.jacobian.clone());
        let end = refit_by(of(place), tests, &known.theta, jacobian, Effort::COMPARE, &residual).unwrap_or(known);
        (rate(place, &end), place, end)
    };
    let mut refits: Vec<(Rating, usize, Refit)> = ahead.into_par_iter().map(longer).collect();
    sort(&mut refits);
    let best = refits.first().map_or(f64::NEG_INFINITY, |r| r.0.log_posterior);
    let is_final = |(k, (rating, ..)): (usize, &(Rating, usize, Refit))| {
        k < budget.finals && rating.has_begun() && best - rating.log_posterior < REACH
    };
    let finals: Vec<bool> = refits.iter().enumerate().map(is_final).collect();
    let full = |((_, place, known), is_final): ((Rating, usize, Refit), bool)| {
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_has_begun_to_explain_goes_before_what_costs_little() {
        let rating = |log_posterior: f64, rise: f64| Rating { log_posterior, rise };
        let (absent, begun, better) = (rating(-3.0, 0.0), rating(-3.6, 8.0), rating(-2.0, 9.0));
        let mut all = [absent, begun, better];
        all.sort_by(Rating::compare);
        assert_eq!(all.map(|r| r.log_posterior), [-2.0, -3.6, -3.0]);
        assert!(!absent.has_begun() && begun.has_begun());
    }
}
