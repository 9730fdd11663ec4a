//! Remarks on values outside the range of dampers and rigs. Such a value compensates for an effect that the model
//! lacks.

use crate::phrases;
use crate::{Estimate, Standing};
use dashpot_core::Params;
use dashpot_core::parameter::Number;
use dashpot_estimation::prior_range::{is_rare_value, prior_range};
use dashpot_estimation::prior_set::PriorSet;
use dashpot_estimation::scale::Scale;
use dashpot_messages::Sentence;
use dashpot_records::Reading;

/// Formats a remark if an identified or assumed value is outside the range of dampers and rigs ([`prior_range`]).
///
/// Returns `None` for a number without effect. Also returns `None` for a number with a prior of this damper in `own`,
/// because this prior is more specific than the range of all dampers.
pub(crate) fn describe_rare(estimate: &Estimate, params: &Params, own: &PriorSet) -> Option<Sentence> {
    let number = Number::find(estimate.name).ok()?;
    let has_own = own.rows().iter().any(|row| row.number == number);
    let scale = Scale::from_params(params);
    if estimate.index.is_some()
        || has_own
        || !params.counts(number.row())
        || !is_rare_value(number, estimate.value, scale)
    {
        return None;
    }
    let (low, high) = prior_range(number, scale)?;
    let said = |value: f64| Reading::single(value, estimate.unit).with_unit();
    let rare = match estimate.standing {
        Standing::NotIdentified => phrases::RARE_ASSUMED,
        _ => phrases::RARE_VALUE,
    };
    let text = Sentence::from(rare).with("name", estimate.name).with("value", estimate.reading().with_unit());
    Some(text.with("low", said(low)).with("high", said(high)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use dashpot_core::{element, number};
    use dashpot_estimation::prior_set::DamperPrior;
    use dashpot_estimation::priors::Distribution;

    #[test]
    fn a_value_that_no_damper_shows_is_reported_with_the_range_of_dampers() {
        let estimate = |name: &'static str, value: f64, unit: &'static str, standing: Standing| Estimate {
            name,
            index: None,
            value,
            low: None,
            high: None,
            unit,
            from: Sentence::from(phrases::NO_TEST),
            standing,
        };
        let mut params = Params::new();
        params.disable_all();
        params.enable(element!("fv_curve"), true);
        params.enable(element!("oil_compressibility"), true);
        params.enable(element!("gas_preload"), true);
        let none = PriorSet::default();
        let oil = estimate("oil_stiffness", 2.01e4, "N/m", Standing::Identified);
        let said = describe_rare(&oil, &params, &none).unwrap().to_string();
        assert!(
            said.starts_with("oil_stiffness is 20.10 N/mm, outside what dampers of this force and rigs show (192"),
            "{said}"
        );
        let gas = |value: f64| estimate("gas_force", value, "N", Standing::NotIdentified);
        let said = describe_rare(&gas(-10.76), &params, &none).unwrap().to_string();
        assert!(said.starts_with("gas_force is assumed at -10.76 N"), "{said}");
        assert!(describe_rare(&gas(150.0), &params, &none).is_none());
        // There is no remark if this damper has its own prior of the gas force, or if the element of the gas force is
        // off.
        let source = "gas_pressure_bar: drawing".to_owned();
        let expected = Distribution::Place(-10.0, 1.0);
        let own = PriorSet::new(vec![DamperPrior { number: number!("gas_force"), expected, source }]);
        assert!(describe_rare(&gas(-10.76), &params, &own).is_none());
        params.enable(element!("gas_preload"), false);
        assert!(describe_rare(&gas(-10.76), &params, &none).is_none());
    }
}
