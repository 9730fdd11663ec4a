//! Plausible values: those that occur in dampers and rigs.

use super::wording::physical;
use dashpot_estimation::hypothesis::{Free, Hypothesis, Number};
use dashpot_estimation::prior_range::{RARE, is_rare_value};
use dashpot_estimation::scale::Scale;
use dashpot_estimation::unknowns::Unknown;

/// Returns whether the value of a free parameter is plausible. `k` is its index, `theta` are the search coordinates.
///
/// A parameter of the model follows the rule of the fit, [`is_rare_value`]. A parameter of the rig, and one with a prior of this
/// damper, must be within [`RARE`] standard deviations of the mean of its prior. Without a prior, any value is plausible.
pub(super) fn is_plausible(hypothesis: &Hypothesis, k: usize, theta: &[f64]) -> bool {
    let Number { free, prior, .. } = &hypothesis.numbers[k];
    match free {
        Free::Model(unknown @ (Unknown::Log(number) | Unknown::Linear(number)))
            if hypothesis.priors.in_search(unknown).is_none() =>
        {
            !is_rare_value(*number, physical(free, theta[k]), Scale::from_params(&hypothesis.base))
        }
        _ => prior.is_none_or(|(mean, deviation)| ((theta[k] - mean) / deviation).abs() < RARE),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use dashpot_core::{Params, number};
    use dashpot_estimation::prior_set::{DamperPrior, PriorSet};
    use dashpot_estimation::priors::Distribution;

    fn hypothesis(free: Free, prior: Option<(f64, f64)>, priors: PriorSet) -> Hypothesis {
        let number = Number { free, start: 0.0, step: 1.0, bounds: (-1e9, 1e9), prior };
        Hypothesis { base: Params::new(), numbers: vec![number], heating: None, priors }
    }

    #[test]
    fn a_parameter_of_the_model_has_the_range_that_the_fit_states() {
        let gas = || Free::Model(Unknown::Linear(number!("gas_force")));
        // A gas force of −11 N is within the wide prior of a search. It is outside the range of dampers, because gas
        // pushes the rod out.
        let at = |value: f64| is_plausible(&hypothesis(gas(), Some((150.0, 100.0)), PriorSet::default()), 0, &[value]);
        assert!(at(150.0) && at(-1.0) && !at(-11.0) && !at(1500.0));
        let oil = || Free::Model(Unknown::Log(number!("oil_stiffness")));
        let at = |value: f64| is_plausible(&hypothesis(oil(), None, PriorSet::default()), 0, &[libm::log(value)]);
        assert!(at(3.0e6) && !at(2.0e4));
    }

    #[test]
    fn the_drawing_of_a_damper_decides_what_is_plausible_for_it() {
        let gas = || Free::Model(Unknown::Linear(number!("gas_force")));
        let (number, expected) = (number!("gas_force"), Distribution::Place(2000.0, 100.0));
        let priors = PriorSet::new(vec![DamperPrior { number, expected, source: "drawing".to_owned() }]);
        let own = hypothesis(gas(), None, priors.clone()).with_priors(&priors);
        assert!(is_plausible(&own, 0, &[2050.0]) && !is_plausible(&own, 0, &[150.0]));
    }
}
