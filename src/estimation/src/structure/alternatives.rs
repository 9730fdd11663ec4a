//! Structures that remain probable in addition to the most probable one, and the wider intervals that they imply.
//!
//! An interval within one structure ignores the other structures. For example, a linear spring parallel to a gas column
//! may have a probability of a tenth. A structure with the gas column alone then assigns the stiffness of both to the
//! column. Therefore, the interval of a parameter is that of the average over the alternatives, weighted with their
//! probabilities (Hoeting et al., Bayesian Model Averaging, Stat. Sci. 14, 1999).

use super::context::Structure;
use super::search::{StructureSearch, Temperatures};
use crate::deviations::sandwich;
use crate::refit::Effort;
use crate::samples::Test;
use rayon::prelude::*;

/// Smallest probability at which an alternative is included. The probability assumes that the alternative and the best
/// structure are the only candidates. Below this probability, a 95 % interval may omit the alternative.
pub(crate) const LEAST: f64 = 0.05;
/// Largest number of alternatives. Each alternative costs a refit, and further alternatives are even less probable.
/// With 3, other forms of the same effects fill the list, and a spring parallel to a gas column is omitted (system test
/// `an_interval_holds_what_a_less_probable_structure_says`).
pub(crate) const MOST: usize = 5;

/// A structure that remains probable in addition to the most probable one.
pub struct Alternative {
    /// The structure, refitted.
    pub structure: Structure,
    /// Weight of the structure, relative to a weight of 1 for the best structure.
    pub weight: f64,
}

/// Computes the logarithm of the weight of a structure in averages over structures; `at` contains the divisors of its
/// log evidence and log prior.
fn log_weight(structure: &Structure, at: Temperatures) -> f64 {
    at.log_weight(structure.log_posterior, structure.log_prior)
}

/// Returns the probable structures that differ from `best` by one added, removed or exchanged effect. They are
/// refitted, and the most probable structure is first.
///
/// An alternative has a probability of at least 5 %, computed as if this alternative and `best` were the only
/// candidates. A 95 % interval must include such an alternative. `best` is the most probable structure of the search,
/// or that structure without some effects. In the second case, the most probable structure may be an alternative. At
/// most `MOST` alternatives are returned.
pub fn alternatives(search: &StructureSearch, best: &Structure, at: Temperatures, tests: &[Test]) -> Vec<Alternative> {
    // Refit `best` with the effort used for the alternatives: a more accurate integration changes the log posterior by
    // several units.
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
    // The search refitted a trial only with the accuracy that a comparison requires, so refit the alternatives again.
    let mut all: Vec<Structure> =
        all.par_iter().filter_map(|structure| structure.refitted(tests, Effort::JUDGE)).collect();
    all.retain(|structure| is_open(log_weight(structure, at)));
    all.sort_by(by_weight);
    all.into_iter()
        .map(|structure| Alternative { weight: libm::exp(log_weight(&structure, at) - own), structure })
        .collect()
}

/// Computes the ends of the 95 % intervals of a structure's free parameters, in their search coordinates and without
/// alternatives. Returns `None` if the covariance is unknown.
fn own_ends(structure: &Structure, tests: &[Test]) -> Option<Vec<[f64; 2]>> {
    let Structure { hypothesis, refit, .. } = structure;
    let (covariance, _) = sandwich(hypothesis, refit, tests)?;
    let of = |place: usize| hypothesis.interval(place, refit.theta[place], covariance[(place, place)].max(0.0).sqrt());
    Some((0..refit.theta.len()).map(of).collect())
}

/// Fraction of a distribution beyond each end of its 95 % interval. [`DEVIATIONS`] is the distance of an end from the
/// value, in standard deviations.
const BEYOND: f64 = 0.025;
const DEVIATIONS: f64 = 1.959_964;
/// Bisection steps for a quantile. Their accuracy is a billionth of the distance between the outermost ends of all
/// intervals.
const HALVES: usize = 30;

/// Estimate of a parameter by one structure: weight of the structure, value, and ends of the 95 % interval.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Part {
    /// Weight relative to the other structures.
    pub weight: f64,
    /// Value of the parameter in the structure.
    pub value: f64,
    /// Ends of the interval within this structure.
    pub ends: [f64; 2],
}

impl Part {
    /// Computes the probability that the parameter is below `x`. Each side of `value` is half of a normal distribution,
    /// whose standard deviation follows from the end on this side.
    fn below(&self, x: f64) -> f64 {
        let end = if x < self.value { self.ends[0] } else { self.ends[1] };
        let deviation = (end - self.value).abs() / DEVIATIONS;
        if deviation > 0.0 {
            0.5 * libm::erfc((self.value - x) / (deviation * std::f64::consts::SQRT_2))
        } else {
            f64::from(u8::from(x >= self.value))
        }
    }
}

/// Computes the ends of a parameter's 95 % interval over several structures. The result contains the interval of the
/// first structure, so alternatives never make it narrower. If an end of any structure is infinite, the result extends
/// from the lowest to the highest end. Returns `None` if `parts` is empty.
pub fn mixed_interval(parts: &[Part]) -> Option<[f64; 2]> {
    let first = parts.first()?;
    let outermost = parts.iter().fold(first.ends, |[low, high], p| [low.min(p.ends[0]), high.max(p.ends[1])]);
    if parts.len() == 1 || !outermost.iter().all(|end| end.is_finite()) {
        return Some(outermost);
    }
    let weight: f64 = parts.iter().map(|part| part.weight).sum();
    let quantile = |wanted: f64| {
        let [mut low, mut high] = outermost;
        for _ in 0..HALVES {
            let middle = 0.5 * (low + high);
            let below = parts.iter().map(|part| part.weight * part.below(middle)).sum::<f64>() / weight;
            if below < wanted { low = middle } else { high = middle }
        }
        0.5 * (low + high)
    };
    Some([quantile(BEYOND).min(first.ends[0]), quantile(1.0 - BEYOND).max(first.ends[1])])
}

/// Computes the ends of the 95 % intervals of a structure's free parameters over its alternatives. Returns `None` if
/// the covariance of `best` is unknown.
pub fn interval_ends(best: &Structure, others: &[Alternative], tests: &[Test]) -> Option<Vec<[f64; 2]>> {
    let part =
        |of: &Structure, weight: f64, place: usize, ends: [f64; 2]| Part { weight, value: of.refit.theta[place], ends };
    let ends = own_ends(best, tests)?;
    let mut parts: Vec<Vec<Part>> =
        ends.iter().enumerate().map(|(place, ends)| vec![part(best, 1.0, place, *ends)]).collect();
    for Alternative { structure, weight } in others {
        let Some(of_other) = own_ends(structure, tests) else { continue };
        for (number, parts) in best.hypothesis.numbers.iter().zip(&mut parts) {
            let Some(place) = structure.hypothesis.position(&number.free) else { continue };
            parts.push(part(structure, *weight, place, of_other[place]));
        }
    }
    parts.iter().map(|parts| mixed_interval(parts)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_interval_is_that_of_the_mean_over_the_structures() {
        let part = |weight: f64, value: f64| Part { weight, value, ends: [value - DEVIATIONS, value + DEVIATIONS] };
        let near = |a: Option<[f64; 2]>, b: [f64; 2]| a.unwrap().iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-3);
        assert_eq!(mixed_interval(&[part(1.0, 3.0)]), Some([3.0 - DEVIATIONS, 3.0 + DEVIATIONS]));
        // Two equal estimates give the interval of a single estimate.
        assert!(near(mixed_interval(&[part(1.0, 0.0), part(0.4, 0.0)]), [-DEVIATIONS, DEVIATIONS]));
        // A quarter of the weight is around 100. The upper end is 1.28 standard deviations above 100, so a tenth of
        // that quarter is above the interval.
        assert!(near(mixed_interval(&[part(1.0, 0.0), part(1.0 / 3.0, 100.0)]), [-DEVIATIONS, 101.282]));
        // A structure with negligible weight does not widen the interval.
        assert!(near(mixed_interval(&[part(1.0, 0.0), part(1e-6, 100.0)]), [-DEVIATIONS, DEVIATIONS]));
        assert_eq!(mixed_interval(&[]), None);
    }
}
