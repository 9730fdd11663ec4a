//! What the numbers of an explanation cost it where they are far from what dampers show.

use crate::bleed::usual_rise;
use crate::hypothesis::{Free, Hypothesis};
use crate::priors::{of, price};
use crate::scale::Scale;
use crate::unknowns::Unknown;
use dashpot_core::number;
use dashpot_core::parameter::Number;

/// How far off each number of an explanation is from what is usual; those without a prior are not in it.
pub fn off(hypothesis: &Hypothesis, theta: &[f64]) -> Vec<(Number, f64)> {
    let params = hypothesis.params(theta);
    let scale = Scale::of(&hypothesis.base);
    let mut all = Vec::new();
    for (number, value) in hypothesis.numbers.iter().zip(theta) {
        let (number, value) = match number.free {
            Free::Model(Unknown::Log(number) | Unknown::Linear(number)) => (number, params.number(number)),
            Free::Model(Unknown::Above(number, below)) => (number, params.number(number) - params.number(below)),
            Free::HeatCapacity => (number!("heat_capacity"), libm::exp(*value)),
            // A change from a reference is as probable as its prior in the refit says.
            Free::Shift(_)
            | Free::Curve(_)
            | Free::Rig(_)
            | Free::Cooling
            | Free::Model(Unknown::Rise { .. } | Unknown::Entry(..)) => continue,
        };
        if let Some(usual) = of(number, scale) {
            all.push((number, usual.off(value)));
        }
    }
    all
}

/// What the numbers of an explanation cost it, in units of the logarithm of the odds.
pub fn implausibility(hypothesis: &Hypothesis, theta: &[f64]) -> f64 {
    let params = hypothesis.params(theta);
    let steep = hypothesis.numbers.iter().zip(theta).filter_map(|(number, rise)| {
        let Free::Model(unknown) = &number.free else { return None };
        usual_rise(&params, unknown).map(|usual| price(rise / usual))
    });
    off(hypothesis, theta).iter().map(|(_, off)| price(*off)).chain(steep).sum()
}
