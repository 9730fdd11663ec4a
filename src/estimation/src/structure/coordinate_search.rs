//! Coordinate search for the parameters of an effect that makes the force jump.
//!
//! If the computed position of a jump is wrong, the force is wrong between the computed and the measured position. The
//! derivative of the force is nonzero only at the computed position. Therefore, a step based on derivatives moves the
//! jump by a sample or two, and the search ends too early. A pattern search (Hooke & Jeeves, J. ACM 8, 1961) evaluates
//! the whole residual.

use crate::hypothesis::{Hypothesis, Residual};
use crate::refit::{Refit, chi2, prior_cost};
use dashpot_records::restrict;
use std::ops::Range;

/// Step sizes of the successive sweeps, relative to the typical step of a parameter.
const STEPS: [f64; 5] = [0.8, 0.4, 0.2, 0.1, 0.05];
/// Number of model evaluations after which no further sweep over the parameters begins.
const RUNS: usize = 60;

/// Returns the parameters, from those of `at`, that minimize the cost of `residual`. Only the parameters with the
/// indices `places` change.
pub fn minimize(
    hypothesis: &Hypothesis,
    at: &Refit,
    places: Range<usize>,
    residual: &dyn Fn(&[f64]) -> Option<Residual>,
) -> Vec<f64> {
    let cost = |theta: &[f64]| residual(theta).map_or(f64::INFINITY, |r| chi2(&r) + prior_cost(hypothesis, theta));
    let (mut theta, mut best) = (at.theta.clone(), at.cost);
    let mut runs = 0;
    for step in STEPS {
        let mut moves = true;
        while moves && runs < RUNS {
            moves = false;
            for place in places.clone() {
                let number = &hypothesis.numbers[place];
                for sign in [1.0, -1.0] {
                    let mut tried = theta.clone();
                    tried[place] = restrict(tried[place] + sign * step * number.step, number.bounds.0, number.bounds.1);
                    runs += 1;
                    let there = cost(&tried);
                    if there < best {
                        (theta, best, moves) = (tried, there, true);
                        break;
                    }
                }
            }
        }
    }
    theta
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::hypothesis::number;
    use crate::prior_set::PriorSet;
    use crate::unknowns::Unknown;
    use dashpot_core::Params;
    use dashpot_core::{element, number};
    use nalgebra::{DMatrix, DVector};

    #[test]
    fn a_jump_is_found_where_no_derivative_tells_of_it() {
        let mut base = Params::new();
        base.enable(element!("free_play"), false);
        base.set(number!("free_play_gap"), 1e-4).unwrap();
        let number = number(&base, Unknown::Log(number!("free_play_gap")));
        let hypothesis = Hypothesis { base, numbers: vec![number], heating: None, priors: PriorSet::default() };
        // The force jumps at a sample that depends on the gap. The force is constant on both sides of the jump.
        let jump = |theta: &[f64]| (4e5 * libm::exp(theta[0])) as usize;
        let residual = |theta: &[f64]| {
            let (from, to) = (jump(theta).min(90), jump(theta).max(90));
            Some(DVector::from_fn(400, |k, _| if (from..to).contains(&k) { 30.0 } else { 0.1 }))
        };
        for gap in [0.4e-4f64, 1.5e-4, 2.2e-4, 6e-4] {
            let start = vec![libm::log(gap)];
            let at = Refit::from_point(&hypothesis, start.clone(), residual(&start).unwrap(), DMatrix::zeros(400, 1));
            let found = minimize(&hypothesis, &at, 0..1, &residual);
            assert!(jump(&found).abs_diff(90) <= 1, "{gap}: {} of 90", jump(&found));
        }
    }
}
