//! Structures beside the most probable one that the records do not rule out, and how far they leave its numbers open.
//!
//! An interval within one structure says nothing of the others: where a linear spring beside a gas column has one chance in ten, the gas column that
//! stands for both is stiffer by the whole spring. So the interval of a number is that of the mean over the alternatives, each with its probability
//! (Hoeting et al., Bayesian Model Averaging, Stat. Sci. 14, 1999).

use super::context::Structure;
use super::search::{StructureSearch, Temperatures};
use crate::deviations::sandwich;
use crate::refit::Effort;
use crate::samples::Test;
use rayon::prelude::*;

/// Probability beside the best from which an alternative counts: that which a 95 % interval may leave out.
const LEAST: f64 = 0.05;
/// Most alternatives; those behind them are less probable still, and each costs a refit. With 3, other forms of the effects crowd out a spring
/// beside a gas column (system test `an_interval_holds_what_a_less_probable_structure_says`).
const MOST: usize = 5;

/// A structure that the records do not rule out.
pub struct Alternative {
    /// The structure, refitted.
    pub structure: Structure,
    /// Its weight beside that of the best, whose own is 1.
    pub weight: f64,
}

/// Log weight of a structure.
fn log_weight(structure: &Structure, at: Temperatures) -> f64 {
    at.log_weight(structure.log_posterior, structure.log_prior)
}

/// Structures with one effect more than `best`, one less or one exchanged, refitted and most probable first.
///
/// Each is at least as probable beside it as an interval may leave out. `best` is the most probable structure of the search, or what is left of it:
/// then the whole is an alternative.
pub fn alternatives(search: &StructureSearch, best: &Structure, at: Temperatures, tests: &[Test]) -> Vec<Alternative> {
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
    all.into_iter()
        .map(|structure| Alternative { weight: libm::exp(log_weight(&structure, at) - own), structure })
        .collect()
}

/// Ends of the 95 % intervals of the free numbers of a structure by itself; `None` where nothing is known of them.
fn own_ends(structure: &Structure, tests: &[Test]) -> Option<Vec<[f64; 2]>> {
    let Structure { hypothesis, refit, .. } = structure;
    let (covariance, _) = sandwich(hypothesis, refit, tests)?;
    let of = |place: usize| hypothesis.interval(place, refit.theta[place], covariance[(place, place)].max(0.0).sqrt());
    Some((0..refit.theta.len()).map(of).collect())
}

/// Share of a 95 % interval's distribution beyond each end, and standard deviations from its value to an end.
const BEYOND: f64 = 0.025;
const DEVIATIONS: f64 = 1.959_964;
/// Halves of the distance between the outermost ends in which a quantile is found: to a thousandth of a millionth of it.
const HALVES: usize = 30;

/// What one structure says of a number: its weight, the value and the ends of its 95 % interval.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Part {
    /// Weight among the others.
    pub weight: f64,
    /// Value.
    pub value: f64,
    /// Ends of its own interval.
    pub ends: [f64; 2],
}

impl Part {
    /// Probability that the number lies below `x`: each side is half a normal distribution.
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

/// Ends of the 95 % interval of a number of which several structures speak. It holds that of the first, which others do not make surer.
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

/// Ends of the 95 % intervals of the free numbers of a structure over its alternatives; `None` where nothing is known of them.
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
        // Two that agree are one.
        assert!(near(mixed_interval(&[part(1.0, 0.0), part(0.4, 0.0)]), [-DEVIATIONS, DEVIATIONS]));
        // A quarter lies around 100: its upper tenth is beyond, 1.28 deviations off.
        assert!(near(mixed_interval(&[part(1.0, 0.0), part(1.0 / 3.0, 100.0)]), [-DEVIATIONS, 101.282]));
        // What has hardly any weight widens nothing.
        assert!(near(mixed_interval(&[part(1.0, 0.0), part(1e-6, 100.0)]), [-DEVIATIONS, DEVIATIONS]));
        assert_eq!(mixed_interval(&[]), None);
    }
}
