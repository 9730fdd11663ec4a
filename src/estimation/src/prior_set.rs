//! Priors of one damper, which replace the priors of all dampers.

use crate::distribution::Distribution;
use crate::priors;
use crate::scale::Scale;
use crate::unknowns::Unknown;
use dashpot_core::parameter::Number;
use std::sync::Arc;

/// Prior of one parameter of one damper.
#[derive(Debug, Clone, PartialEq)]
pub struct DamperPrior {
    /// Parameter to which the prior applies.
    pub number: Number,
    /// Prior distribution of the parameter, in the unit of the parameter.
    pub expected: Distribution,
    /// Source: the known facts of the damper, a colon, and the publication of the formula.
    pub source: String,
}

impl DamperPrior {
    /// Returns the known facts of the damper, without the publication of the formula.
    pub fn facts(&self) -> &str {
        self.source.split_once(": ").map_or(self.source.as_str(), |(facts, _)| facts)
    }

    /// Returns the ends of the 95 % interval of the prior, in the unit of the parameter.
    pub fn interval(&self) -> (f64, f64) {
        self.expected.interval(Z)
    }

    /// Returns the center of the prior, in the unit of the parameter.
    pub fn center(&self) -> f64 {
        self.expected.center()
    }

    /// Computes the logarithm of the ratio of two prior standard deviations, at least 0: that over all dampers to that
    /// of this damper. It is 0 if there is no prior over all dampers.
    fn sharpness(&self, unknown: &Unknown, scale: Scale) -> f64 {
        let spread = |usual: Distribution| usual.in_search(matches!(unknown, Unknown::Log(_))).1;
        let shared =
            priors::distribution(self.number, scale).map_or(1.0, |usual| spread(usual) / spread(self.expected));
        libm::log(shared.max(1.0))
    }
}

/// Half-width of a 95 % interval in standard deviations.
const Z: f64 = 1.96;

/// Priors of one damper; empty if no facts about the damper are known.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct PriorSet {
    rows: Arc<[DamperPrior]>,
    is_against_reference: bool,
}

impl PriorSet {
    /// Makes a set from its rows.
    pub fn new(rows: Vec<DamperPrior>) -> PriorSet {
        PriorSet { rows: rows.into(), is_against_reference: false }
    }

    /// Marks the priors as those of a damper that is compared with a reference damper. The damper has the effects of
    /// the reference, so any other effect is new.
    pub fn against_reference(self) -> PriorSet {
        PriorSet { is_against_reference: true, ..self }
    }

    /// Returns whether the damper is compared with a reference damper. An added effect is then an effect that the
    /// reference does not have.
    pub fn is_against_reference(&self) -> bool {
        self.is_against_reference
    }

    /// Returns the rows of the set.
    pub fn rows(&self) -> &[DamperPrior] {
        &self.rows
    }

    /// Returns the row of a parameter, if this damper has a prior for it.
    pub fn find(&self, number: Number) -> Option<&DamperPrior> {
        self.rows.iter().find(|row| row.number == number)
    }

    /// Returns the prior of a parameter: the prior of this damper, or else the prior of all dampers of its size.
    pub fn distribution(&self, number: Number, scale: Scale) -> Option<Distribution> {
        self.find(number).map(|row| row.expected).or_else(|| priors::distribution(number, scale))
    }

    /// Returns mean and standard deviation of a free parameter in its search coordinate. Returns `None` if this damper
    /// has no prior for the parameter.
    pub fn in_search(&self, unknown: &Unknown) -> Option<(f64, f64)> {
        match unknown {
            Unknown::Log(number) => self.find(*number).map(|row| row.expected.in_search(true)),
            Unknown::Linear(number) => self.find(*number).map(|row| row.expected.in_search(false)),
            Unknown::Above(..) | Unknown::Rise { .. } | Unknown::Entry(..) => None,
        }
    }

    /// Computes the reduction of a free parameter's cost, in log odds, if its prior is narrower than the prior of all
    /// dampers.
    ///
    /// A parameter costs the logarithm of the ratio of its prior width to its posterior width (the Occam factor:
    /// MacKay, Neural Comput. 4, 1992). `cost` is that logarithm under the prior of all dampers. A narrower prior
    /// reduces the cost, but never by more than the cost itself. The reduction equals the cost if the prior is narrower
    /// than the posterior from the records alone.
    pub fn relief(&self, unknown: &Unknown, scale: Scale, cost: f64) -> f64 {
        let (Unknown::Log(number) | Unknown::Linear(number)) = unknown else { return 0.0 };
        self.find(*number).map_or(0.0, |row| row.sharpness(unknown, scale).min(cost))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use dashpot_core::number;

    fn set(factor: f64) -> PriorSet {
        let number = number!("oil_stiffness");
        let source = "bore_mm, rod_mm: Merritt 1967".to_owned();
        PriorSet::new(vec![DamperPrior { number, expected: Distribution::Size(9e6, factor), source }])
    }

    #[test]
    fn a_row_replaces_that_of_all_dampers_and_no_other() {
        let own = set(1.3);
        let (oil, gas) = (number!("oil_stiffness"), number!("gas_force"));
        assert_eq!(own.distribution(oil, Scale::CAR), Some(Distribution::Size(9e6, 1.3)));
        assert_eq!(own.distribution(gas, Scale::CAR), priors::distribution(gas, Scale::CAR));
        assert_eq!(own.rows()[0].facts(), "bore_mm, rod_mm");
        let (low, high) = own.rows()[0].interval();
        assert!(low < 9e6 / 1.6 && high > 9e6 * 1.6);
    }

    #[test]
    fn a_narrower_prior_costs_less_and_never_less_than_nothing() {
        let relief = |factor: f64| set(factor).relief(&Unknown::Log(number!("oil_stiffness")), Scale::CAR, 1.9);
        assert_eq!(relief(3.0), 0.0);
        assert_eq!(relief(10.0), 0.0);
        assert!(relief(1.5) > 0.9 && relief(1.5) < 1.1);
        assert_eq!(relief(1.01), 1.9);
        assert_eq!(set(1.1).relief(&Unknown::Linear(number!("gas_force")), Scale::CAR, 1.9), 0.0);
    }
}
