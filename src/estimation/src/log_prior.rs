//! Negative log prior of the parameters of a hypothesis.

use crate::bleed::prior_rise;
use crate::hypothesis::{Free, Hypothesis, Number as FreeNumber};
use crate::priors::log_cost;
use crate::scale::Scale;
use crate::unknowns::Unknown;
use dashpot_core::parameter::Number;
use dashpot_core::{Params, number};

/// Computes the distance of each parameter of a hypothesis from its prior, in standard deviations; parameters without a
/// prior are omitted.
pub fn standard_scores(hypothesis: &Hypothesis, theta: &[f64]) -> Vec<(Number, f64)> {
    let params = hypothesis.params(theta);
    let scale = Scale::from_params(&hypothesis.base);
    let mut all = Vec::new();
    for (number, value) in hypothesis.numbers.iter().zip(theta) {
        let (number, value) = match number.free {
            Free::Model(Unknown::Log(number) | Unknown::Linear(number)) => (number, params.number(number)),
            Free::Model(Unknown::Above(number, below)) => (number, params.number(number) - params.number(below)),
            Free::HeatCapacity => (number!("heat_capacity"), libm::exp(*value)),
            // These parameters have no distribution over dampers. Their own prior, for example that of a change from a
            // reference damper, applies only in the refit. [`negative_log_prior`] adds the prior of a rise.
            Free::Shift(_)
            | Free::Curve(_)
            | Free::Rig(_)
            | Free::Cooling
            | Free::Model(Unknown::Rise { .. } | Unknown::Entry(..)) => continue,
        };
        if let Some(prior) = hypothesis.priors.distribution(number, scale) {
            all.push((number, prior.standard_score(value)));
        }
    }
    all.extend(fixed(hypothesis, &params));
    all
}

/// Returns the distances of fixed parameters from the damper's own priors, in standard deviations. An example is the
/// ratio of the oil columns of a twin tube, which its form may fix. A parameter of value zero disables its effect, so
/// it has no distance.
fn fixed<'h>(hypothesis: &'h Hypothesis, params: &'h Params) -> impl Iterator<Item = (Number, f64)> + 'h {
    let is_free = |number: Number| {
        let own = |n: &FreeNumber| matches!(n.free, Free::Model(Unknown::Log(n) | Unknown::Linear(n)) if n == number);
        hypothesis.numbers.iter().any(own)
    };
    let is_on = |number: Number| number.row().element().is_some_and(|element| params.is_on(element));
    let rows = hypothesis.priors.rows().iter();
    rows.filter(move |row| is_on(row.number) && !is_free(row.number) && params.number(row.number) != 0.0)
        .map(|row| (row.number, row.expected.standard_score(params.number(row.number))))
}

/// Computes the negative log prior of the parameters of a hypothesis. It is the sum of [`log_cost`] over their standard
/// scores and the initial rises of the FV curve.
pub fn negative_log_prior(hypothesis: &Hypothesis, theta: &[f64]) -> f64 {
    let params = hypothesis.params(theta);
    let steep = hypothesis.numbers.iter().zip(theta).filter_map(|(number, rise)| {
        let Free::Model(unknown) = &number.free else { return None };
        prior_rise(&params, unknown).map(|scale| log_cost(rise / scale))
    });
    standard_scores(hypothesis, theta).iter().map(|(_, score)| log_cost(*score)).chain(steep).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::distribution::Distribution;
    use crate::prior_set::{DamperPrior, PriorSet};
    use dashpot_core::element;

    #[test]
    fn what_a_form_fixes_against_the_drawing_costs_something() {
        let mut base = Params::new();
        base.enable(element!("oil_compressibility"), true);
        let row = |number, expected| DamperPrior { number, expected, source: String::new() };
        let priors = PriorSet::new(vec![
            row(number!("oil_compression"), Distribution::Size(0.05, 1.4)),
            row(number!("oil_shortening"), Distribution::Place(8.0, 1.0)),
        ]);
        let of = |priors: &PriorSet| {
            let hypothesis = Hypothesis { base, numbers: Vec::new(), heating: None, priors: PriorSet::default() }
                .with_priors(priors);
            negative_log_prior(&hypothesis, &[])
        };
        assert_eq!(of(&PriorSet::default()), 0.0);
        assert!((5.0..10.0).contains(&of(&priors)), "{}", of(&priors));
    }
}
