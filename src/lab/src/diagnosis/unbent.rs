//! A series stiffness that the base bent to take up what was missing, and that stays bent once the effect is there.

use super::evidence::{effective_count, noise_chi2};
use super::hypothesis::{Free, Hypothesis};
use super::refit::{Effort, Refit, refit};
use super::samples::Test;
use super::search::QUIET;
use crate::identification::unknowns::Unknown;

/// How many times stiffer and softer is tried.
const TIMES: [f64; 2] = [6.0, 1.0 / 6.0];
/// Share of the excess that a few steps from there may lie above it to go on, and by which the end must lie below it.
const NEAR: f64 = 0.5;
const BETTER: f64 = 0.02;

/// The refit, or a better one from a series stiffness far off: between the two the fit gets worse first.
pub fn unbent(hypothesis: &Hypothesis, tests: &[Test], refitted: Refit) -> Refit {
    let place = hypothesis.numbers.iter().position(|n| n.free == Free::Model(Unknown::Log("series_stiffness")));
    let Some(place) = place else { return refitted };
    let mut best = refitted;
    for times in TIMES {
        let excess = best.chi2 - noise_chi2(tests);
        if excess < QUIET * effective_count(tests) {
            break;
        }
        let mut start = best.theta.clone();
        start[place] += f64::ln(times);
        let end = refit(hypothesis, tests, &start, None, Effort::LOOK)
            .filter(|there| there.cost < best.cost + NEAR * excess)
            .and_then(|there| refit(hypothesis, tests, &there.theta, None, Effort::FINE))
            .filter(|there| there.cost < best.cost - BETTER * excess);
        if let Some(end) = end {
            best = end;
        }
    }
    best
}
