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

/// Number of forms with the largest rise of the log likelihood that are fully refitted, whatever their log posterior.
///
/// The short refits of the first stages keep the Jacobian, and do not converge for an effect such as a lagging valve, whose force
/// depends on its parameters in a strongly nonlinear way. Its prior then counts in full, but its likelihood only in part.
/// Test: `what_explains_most_so_far_is_fully_refitted_although_its_prior_is_low`. Without it, a lagging valve got no name
/// in campaigns of other authors. Each costs one full refit in an iteration.
const LEADING: usize = 2;

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
    let ratings: Vec<Rating> = refits.iter().map(|(rating, ..)| *rating).collect();
    let finals = choose_finals(&ratings, budget.finals);
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

/// Returns which refits of the second stage are fully refitted, from their ratings in descending order.
///
/// They are the `most` best ones within [`REACH`], and the [`LEADING`] ones that explain most of the records so far.
fn choose_finals(ratings: &[Rating], most: usize) -> Vec<bool> {
    let best = ratings.first().map_or(f64::NEG_INFINITY, |rating| rating.log_posterior);
    let mut by_rise: Vec<usize> = (0..ratings.len()).collect();
    by_rise.sort_by(|a, b| ratings[*b].rise.total_cmp(&ratings[*a].rise));
    by_rise.truncate(LEADING);
    let is_final = |(k, rating): (usize, &Rating)| {
        let is_near = k < most && best - rating.log_posterior < REACH;
        rating.has_begun() && (is_near || by_rise.contains(&k))
    };
    ratings.iter().enumerate().map(is_final).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_explains_most_so_far_is_fully_refitted_although_its_prior_is_low() {
        let rating = |log_posterior: f64, rise: f64| Rating { log_posterior, rise };
        // The third effect has many parameters, and its short refit is not at its minimum yet.
        let ratings =
            [rating(-134.8, 1.3), rating(-139.5, 0.8), rating(-142.9, 1.5), rating(-145.8, 0.6), rating(-138.2, 0.0)];
        assert_eq!(choose_finals(&ratings, 2), [true, true, true, false, false]);
        // Nothing is refitted that explains nothing.
        assert_eq!(choose_finals(&[rating(-1.0, 0.0), rating(-2.0, 0.1)], 2), [false; 2]);
    }

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
