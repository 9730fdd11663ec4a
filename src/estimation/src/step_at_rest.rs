//! A step of an FV curve at zero velocity, converted to dry friction and gas force.
//!
//! Tests at constant speeds contain no motion between rest and the slowest speed. In such a campaign, the points of a
//! free FV curve absorb friction and gas force. After the conversion, friction and gas force can change independently.

use crate::unknowns::anchor;
use dashpot_core::{Params, element, list, number};

/// Returns whether a model has dry friction that does not depend on the side force.
pub fn has_dry_friction(params: &Params) -> bool {
    let kinds = [element!("presliding_friction"), element!("coulomb_friction"), element!("stribeck_friction")];
    kinds.iter().any(|friction| params.is_on(*friction))
}

/// Moves the step of the FV curve at zero velocity to Coulomb friction and gas force.
///
/// The total force at all other points of the curve stays unchanged. Returns `None` if the curve has too few points, or
/// if its step is small or has the wrong sign. Small means friction below the fraction `LEAST` of the force at the
/// slowest speed.
pub fn read_step(params: &Params) -> Option<Params> {
    /// Smallest friction that is converted, as a fraction of the force at the slowest speed. A smaller friction cannot
    /// be distinguished from the effect of a bleed, so the curve stays unchanged.
    const LEAST: f64 = 0.3;
    let (velocity, force) = (params.list(list!("fv_velocity")), params.list(list!("fv_force")));
    let zero = anchor(velocity);
    // Force, N, extrapolated to zero velocity, on the line through the two slowest points of a side.
    let toward_rest = |first: usize, second: usize| {
        let derivative = (force[second] - force[first]) / (velocity[second] - velocity[first]);
        force[first] - derivative * velocity[first]
    };
    if zero < 2 || zero + 2 >= velocity.len() {
        return None;
    }
    let (rebound, compression) = (toward_rest(zero + 1, zero + 2), toward_rest(zero - 1, zero - 2));
    let (friction, middle) = (0.5 * (rebound - compression), 0.5 * (rebound + compression));
    let slowest = 0.5 * (force[zero + 1] - force[zero - 1]);
    if rebound < 0.0 || compression > 0.0 || friction < LEAST * slowest {
        return None;
    }
    let lowered: Vec<f64> = (0..force.len())
        .map(|k| if k == zero { force[k] } else { force[k] - middle - friction.copysign(velocity[k]) })
        .collect();
    let mut read = *params;
    let gas = if read.is_on(element!("gas_preload")) { read.number(number!("gas_force")) } else { 0.0 };
    read.enable(element!("gas_preload"), true);
    read.enable(element!("coulomb_friction"), true);
    read.set(number!("gas_force"), gas - middle).ok()?;
    read.set(number!("coulomb_force"), friction).ok()?;
    read.set_list(list!("fv_force"), &lowered).ok()?;
    Some(read)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn step_is_friction_and_gas_and_the_force_stays() {
        let mut params = Params::new();
        params.disable_all();
        params.enable(element!("fv_curve"), true);
        params.set_list(list!("fv_velocity"), &[-0.2, -0.02, -0.01, 0.0, 0.01, 0.02, 0.2]).unwrap();
        params.set_list(list!("fv_force"), &[-360.0, -270.0, -260.0, 0.0, 140.0, 150.0, 330.0]).unwrap();
        let read = read_step(&params).unwrap();
        assert!((read.number(number!("coulomb_force")) - 190.0).abs() < 1e-9);
        assert!((read.number(number!("gas_force")) - 60.0).abs() < 1e-9);
        let force = read.list(list!("fv_force"));
        assert!((force[4] + 190.0 - 60.0 - 140.0).abs() < 1e-9 && (force[0] - 190.0 - 60.0 + 360.0).abs() < 1e-9);
        params.set_list(list!("fv_force"), &[-360.0, -36.0, -18.0, 0.0, 16.0, 33.0, 330.0]).unwrap();
        assert!(read_step(&params).is_none());
    }
}
