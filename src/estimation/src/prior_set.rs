//! Priors of one damper, which replace those that all dampers share.

use crate::distribution::Distribution;
use crate::priors;
use crate::scale::Scale;
use crate::unknowns::Unknown;
use dashpot_core::parameter::Number;
use std::sync::Arc;

/// What is known of one parameter of one damper before its records are seen.
#[derive(Debug, Clone, PartialEq)]
pub struct DamperPrior {
    /// Parameter.
    pub number: Number,
    /// What is expected of it, in its own unit.
    pub expected: Distribution,
    /// Where that comes from: what is known of the damper, a colon, and the publication of the formula.
    pub source: String,
}

impl DamperPrior {
    /// What is known of the damper, without the publication of the formula.
    pub fn facts(&self) -> &str {
        self.source.split_once(": ").map_or(self.source.as_str(), |(facts, _)| facts)
    }

    /// The ends of its 95 % interval, in the parameter's own unit.
    pub fn interval(&self) -> (f64, f64) {
        self.expected.interval(Z)
    }

    /// Its center, in the parameter's own unit.
    pub fn center(&self) -> f64 {
        self.expected.center()
    }

    /// Logarithm of how many times narrower it is than what all dampers show.
    fn sharpness(&self, unknown: &Unknown, scale: Scale) -> f64 {
        let spread = |usual: Distribution| usual.in_search(matches!(unknown, Unknown::Log(_))).1;
        let shared =
            priors::distribution(self.number, scale).map_or(1.0, |usual| spread(usual) / spread(self.expected));
        libm::log(shared.max(1.0))
    }
}

/// Half-width of a 95 % interval in standard deviations.
const Z: f64 = 1.96;

/// The priors of one damper; empty where nothing is known of it.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct PriorSet {
    rows: Arc<[DamperPrior]>,
    is_against_reference: bool,
}

impl PriorSet {
    /// From its rows.
    pub fn new(rows: Vec<DamperPrior>) -> PriorSet {
        PriorSet { rows: rows.into(), is_against_reference: false }
    }

    /// Priors of a damper that is compared with a reference: it has the effects of that one, and any other is new on it.
    pub fn against_reference(self) -> PriorSet {
        PriorSet { is_against_reference: true, ..self }
    }

    /// Whether an effect of the damper would be one that its reference lacks.
    pub fn is_against_reference(&self) -> bool {
        self.is_against_reference
    }

    /// Its rows.
    pub fn rows(&self) -> &[DamperPrior] {
        &self.rows
    }

    /// The row of a parameter.
    pub fn find(&self, number: Number) -> Option<&DamperPrior> {
        self.rows.iter().find(|row| row.number == number)
    }

    /// What is expected of a parameter: of this damper, or else of all dampers of its size.
    pub fn distribution(&self, number: Number, scale: Scale) -> Option<Distribution> {
        self.find(number).map(|row| row.expected).or_else(|| priors::distribution(number, scale))
    }

    /// Mean and standard deviation of a free number where a search moves it; `None` where nothing is known of this damper.
    pub fn in_search(&self, unknown: &Unknown) -> Option<(f64, f64)> {
        match unknown {
            Unknown::Log(number) => self.find(*number).map(|row| row.expected.in_search(true)),
            Unknown::Linear(number) => self.find(*number).map(|row| row.expected.in_search(false)),
            Unknown::Above(..) | Unknown::Rise { .. } | Unknown::Entry(..) => None,
        }
    }

    /// Log odds that a free number need not cost, since its prior is narrower than that of all dampers.
    ///
    /// A number costs the logarithm of how many times wider its prior is than what the records leave of it (the Occam factor: MacKay, Neural
    /// Comput. 4, 1992); `cost` is that under the shared prior. A prior that is narrower than the records costs nothing, and gains nothing.
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
