//! Range of a parameter over dampers and rigs. A value outside the range is rare, so a user must not interpret it as a
//! property of the damper.

use crate::distribution::Distribution;
use crate::priors::distribution;
use crate::scale::Scale;
use dashpot_core::number;
use dashpot_core::parameter::Number;

/// Number of standard deviations from the center of its prior at which a value is rare.
pub const RARE: f64 = 2.5;

/// Largest force, N, by which the gas of a car's damper may seem to pull the rod in.
///
/// Gas pushes the rod out. If the zero of the load cell was set with the damper in the rig, it shows some newtons of
/// either sign.
const PULL: f64 = 5.0;

/// Returns the range of a parameter over dampers of a size and their rigs. Returns `None` for a parameter without a
/// prior. The range of a strength begins at zero, because an effect may be absent.
pub fn prior_range(number: Number, scale: Scale) -> Option<(f64, f64)> {
    let prior = distribution(number, scale)?;
    let (low, high) = prior.interval(RARE);
    Some(match prior {
        Distribution::Strength(..) => (0.0, high),
        _ if number == number!("gas_force") => (-PULL * scale.of_number(number), high),
        _ => (low, high),
    })
}

/// Returns whether a value is outside the [`prior_range`] of its parameter. Only the size of a strength counts, not its sign.
pub fn is_rare_value(number: Number, value: f64, scale: Scale) -> bool {
    let is_strength = matches!(distribution(number, scale), Some(Distribution::Strength(..)));
    let value = if is_strength { value.abs() } else { value };
    prior_range(number, scale).is_some_and(|(low, high)| !(low..=high).contains(&value))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::priors::PRIORS;

    #[test]
    fn what_no_damper_shows_is_rare() {
        let is_rare_value = |number, value| is_rare_value(number, value, Scale::CAR);
        assert!(is_rare_value(number!("oil_stiffness"), 2.0e4) && !is_rare_value(number!("oil_stiffness"), 3.0e6));
        assert!(is_rare_value(number!("oil_compression"), 39.07));
        assert!(is_rare_value(number!("gas_force"), -10.76) && is_rare_value(number!("gas_force"), 1500.0));
        assert!(!is_rare_value(number!("gas_force"), -1.0) && !is_rare_value(number!("gas_force"), 400.0));
        // Little friction is no friction, and nothing rare.
        assert!(!is_rare_value(number!("coulomb_force"), 0.0) && is_rare_value(number!("coulomb_force"), 4000.0));
        assert!(!is_rare_value(number!("fv_rebound_c1"), 1e9));
    }

    #[test]
    fn the_center_of_every_prior_is_not_rare_at_any_size() {
        for scale in [0.01, 1.0, 40.0].map(|times| Scale::of_force(1500.0 * times)) {
            for prior in PRIORS {
                let center = distribution(prior.number, scale).unwrap().center();
                assert!(!super::is_rare_value(prior.number, center, scale), "{}", prior.number.name());
            }
        }
    }
}
