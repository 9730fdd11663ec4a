//! Structures beside the most probable one that the records do not rule out, and how far they leave its numbers open.
//!
//! An interval within one structure says nothing of the others: where a linear spring beside a gas column has one chance in ten, the gas column that
//! stands for both is stiffer by the whole spring. So the interval of a number holds those of the alternatives (Hoeting et al., Bayesian Model
//! Averaging, Stat. Sci. 14, 1999).

use super::context::Structure;
use super::search::{StructureSearch, Temperatures};
use crate::deviations::sandwich;
use crate::refit::Effort;
use crate::samples::Test;
use rayon::prelude::*;

/// Probability beside the best from which an alternative counts: that which a 95 % interval may leave out.
const LEAST: f64 = 0.05;
/// Most alternatives; those behind them are less probable still, and each costs a refit.
const MOST: usize = 3;

/// Log weight of a structure.
fn log_weight(structure: &Structure, at: Temperatures) -> f64 {
    at.log_weight(structure.log_posterior, structure.log_prior)
}

/// Structures with one effect more than `best`, one less or one exchanged, refitted and most probable first.
///
/// Each is at least as probable beside it as an interval may leave out. `best` is the most probable structure of the search, or what is left of it:
/// then the whole is an alternative.
pub fn alternatives(search: &StructureSearch, best: &Structure, at: Temperatures, tests: &[Test]) -> Vec<Structure> {
    // As exactly as the others are judged: more exact integration moves the log posterior by units.
    let judged = best.refitted(tests, Effort::JUDGE);
    let own = log_weight(judged.as_ref().unwrap_or(best), at);
    let is_open = |weight: f64| 1.0 / (1.0 + libm::exp(own - weight)) >= LEAST;
    let added = search.last.iter().chain(&search.rivals).filter(|trial| trial.unnamed.is_none());
    let added = added.map(|trial| &trial.structure).chain(std::iter::once(&search.best));
    let mut all: Vec<Structure> = Vec::new();
    for structure in added.filter(|structure| is_open(log_weight(structure, at))) {
        if structure.key() != best.key() && all.iter().all(|known| known.key() != structure.key()) {
            all.push(structure.clone());
        }
    }
    let removed = (0..best.components.len()).filter(|place| {
        let row = search.table.get(&best.key_without(*place));
        row.is_some_and(|row| is_open(at.log_weight(row.log_posterior, row.log_prior)))
    });
    all.extend(removed.filter_map(|place| best.without(place, tests, Effort::COMPARE)));
    let by_weight = |a: &Structure, b: &Structure| log_weight(b, at).total_cmp(&log_weight(a, at));
    all.sort_by(by_weight);
    all.truncate(MOST);
    // A trial was refitted as far as a comparison needs.
    let mut all: Vec<Structure> =
        all.par_iter().filter_map(|structure| structure.refitted(tests, Effort::JUDGE)).collect();
    all.retain(|structure| is_open(log_weight(structure, at)));
    all.sort_by(by_weight);
    all
}

/// Ends of the 95 % intervals of the free numbers of a structure by itself; `None` where nothing is known of them.
fn own_ends(structure: &Structure, tests: &[Test]) -> Option<Vec<[f64; 2]>> {
    let Structure { hypothesis, refit, .. } = structure;
    let (covariance, _) = sandwich(hypothesis, refit, tests)?;
    let of = |place: usize| hypothesis.interval(place, refit.theta[place], covariance[(place, place)].max(0.0).sqrt());
    Some((0..refit.theta.len()).map(of).collect())
}

/// Ends of the 95 % intervals of the free numbers of a structure, which hold those of its alternatives; `None` where nothing is known of them.
pub fn interval_ends(best: &Structure, others: &[Structure], tests: &[Test]) -> Option<Vec<[f64; 2]>> {
    let mut ends = own_ends(best, tests)?;
    for other in others {
        let Some(of_other) = own_ends(other, tests) else { continue };
        for (number, [low, high]) in best.hypothesis.numbers.iter().zip(&mut ends) {
            let Some(place) = other.hypothesis.position(&number.free) else { continue };
            let [from, to] = of_other[place];
            (*low, *high) = (low.min(from), high.max(to));
        }
    }
    Some(ends)
}
