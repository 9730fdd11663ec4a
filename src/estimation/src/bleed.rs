//! Prior of the initial slope of an FV curve.
//!
//! Up to the knee, the oil flows through the bleed, so the force at a lower speed is below that at the knee. The prior
//! standard deviation of the first rise of the curve follows from a line from zero to the largest force at the slowest
//! knee.
//!
//! If records have no motion below their slowest speed, they do not distinguish a step of the curve at zero velocity
//! from dry friction. Without this prior, a free curve absorbs all friction.

use crate::scale::largest_force;
use crate::unknowns::{CurveName, Unknown, anchor, towards_zero};
use dashpot_core::{Params, list};

/// Slowest knee of shim valves, m/s (Dixon, The Shock Absorber Handbook, 2007, chapter 6: 0.03 to 0.2 m/s). With a
/// smaller value, the curve contains a part of the friction. With a larger value, the estimated bleed force of firm
/// race dampers is too low.
const SLOWEST_KNEE: f64 = 0.03;

/// Returns the prior standard deviation of the rise of the FV curve from zero velocity to a neighboring point, N.
///
/// The scale assumes that the force rises linearly to the largest force at [`SLOWEST_KNEE`]. Returns `None` for any
/// other unknown, and for a model without a force.
pub fn prior_rise(params: &Params, unknown: &Unknown) -> Option<f64> {
    let Unknown::Rise { curve: CurveName::Fv, point } = *unknown else { return None };
    let velocity = params.list(list!("fv_velocity"));
    let zero = anchor(velocity);
    if towards_zero(point, zero) != zero {
        return None;
    }
    let usual = largest_force(params) * (velocity[point].abs() / SLOWEST_KNEE).min(1.0);
    (usual > 0.0).then_some(usual)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_the_points_beside_rest_have_a_usual_rise() {
        let params = Params::new();
        let velocity = params.list(list!("fv_velocity"));
        let zero = anchor(velocity);
        for point in (0..velocity.len()).filter(|point| *point != zero) {
            let usual = prior_rise(&params, &Unknown::Rise { curve: CurveName::Fv, point });
            assert_eq!(usual.is_some(), point.abs_diff(zero) == 1, "{point}");
        }
    }
}
