//! Sentences about the priors that follow from the dimensions of one damper: the priors that the fit used, and the priors that the records
//! contradict.

use crate::phrases;
use crate::short::in_words;
use crate::{Estimate, Standing};
use dashpot_estimation::prior_set::{DamperPrior, PriorSet};
use dashpot_messages::Sentence;
use dashpot_records::reading_unit;

/// Formats a sentence for each estimate whose number has a prior in `priors`: the value expected from the prior, or its contradiction with
/// the records.
pub fn describe_priors(priors: &PriorSet, estimates: &[Estimate]) -> Vec<Sentence> {
    let own = |estimate: &Estimate| {
        let row = priors.rows().iter().find(|row| row.number.name() == estimate.name)?;
        Some(if is_contradiction(row, estimate) { contradiction(row, estimate) } else { expectation(row) })
    };
    estimates.iter().filter_map(own).collect()
}

/// Returns whether the records identify a number, and the 95 % interval of its estimate does not overlap the 95 % interval of its prior.
pub(crate) fn is_contradiction(row: &DamperPrior, estimate: &Estimate) -> bool {
    let (low, high) = row.interval();
    let is_outside = |(from, to): (f64, f64)| to < low || from > high;
    estimate.standing == Standing::Identified && estimate.low.zip(estimate.high).is_some_and(is_outside)
}

/// Formats the expected value of a number, with the 95 % interval of its prior and the dimensions from which the prior follows.
pub(crate) fn expectation(row: &DamperPrior) -> Sentence {
    let (low, high) = row.interval();
    let (factor, unit) = reading_unit(row.center(), row.number.parameter().unit);
    Sentence::from(phrases::EXPECTED)
        .with("name", row.number)
        .with("value", in_words(factor * row.center()))
        .with("unit", unit)
        .with("low", in_words(factor * low))
        .with("high", in_words(factor * high))
        .with("facts", row.facts())
}

/// Formats the contradiction between the records and the prior of a number: the identified value, the expected value and their ratio.
/// The identified value has the digits and the unit of the table of numbers.
pub(crate) fn contradiction(row: &DamperPrior, estimate: &Estimate) -> Sentence {
    let (factor, _) = reading_unit(estimate.value, estimate.unit);
    let reading = estimate.reading();
    Sentence::from(phrases::CONTRADICTS)
        .with("name", row.number)
        .with("value", reading.value)
        .with("unit", reading.unit)
        .with("ratio", format!("{:.2}", estimate.value / row.center()))
        .with("expected", in_words(factor * row.center()))
        .with("facts", row.facts())
}

#[cfg(test)]
mod tests {
    use super::*;
    use dashpot_core::number;
    use dashpot_estimation::priors::Distribution;

    #[test]
    fn a_number_far_from_its_prior_contradicts_it_by_so_much() {
        let number = number!("gas_force");
        let source = "gas_pressure_bar, rod_mm: Dixon 2007, chapter 5".to_owned();
        let priors = PriorSet::new(vec![DamperPrior { number, expected: Distribution::Place(114.0, 8.0), source }]);
        let estimate = |value: f64| Estimate {
            name: "gas_force",
            index: None,
            value,
            low: Some(value - 5.0),
            high: Some(value + 5.0),
            unit: "N",
            from: Sentence::from(phrases::NO_TEST),
            standing: Standing::Identified,
        };
        let said = |value: f64| describe_priors(&priors, &[estimate(value)])[0].to_string();
        assert!(said(240.0).contains("240.0 N are 2.11 times the 114.0 N that gas_pressure_bar, rod_mm give"));
        assert!(said(120.0).contains("was expected at 114.0 N (95 %: 98.32 to 129.7)"), "{}", said(120.0));
        assert!(describe_priors(&PriorSet::default(), &[estimate(240.0)]).is_empty());
    }
}
