//! The two forms of the FV curve at zero velocity: one derivative for both sides, or a kink with one derivative on each
//! side.
//!
//! Rebound and compression of a damper have different valves, so its curve has a kink at zero velocity. A model from
//! another source may be smooth there. Both forms have the same parameters, so the form with the smaller residual is
//! more probable.

use crate::hypothesis::{Free, Hypothesis};
use crate::unknowns::{CurveName, Unknown};
use dashpot_core::curve::Interpolation;
use dashpot_core::elements::fv_curve::{choice_of_interpolation, fv_interpolation};
use dashpot_core::{Params, number};

/// Returns the model with the other form of its FV curve at zero velocity. Returns `None` if the curve is piecewise
/// linear.
pub fn with_other_form_at_rest(params: &Params) -> Option<Params> {
    let other = match fv_interpolation(params) {
        Interpolation::MonotoneCubic => Interpolation::CubicEachSide,
        Interpolation::CubicEachSide => Interpolation::MonotoneCubic,
        Interpolation::Linear => return None,
    };
    let mut params = *params;
    params.set(number!("fv_interpolation"), choice_of_interpolation(other)).ok()?;
    Some(params)
}

/// Returns the hypothesis with the other form of its FV curve at zero velocity. Returns `None` if the curve is
/// piecewise linear. Also returns `None` if no force of the curve is free, for example because the curve of a reference
/// damper is used.
pub fn with_other_form(of: &Hypothesis) -> Option<Hypothesis> {
    let is_point = |free: &Free| matches!(free, Free::Model(Unknown::Rise { curve: CurveName::Fv, .. }));
    of.numbers.iter().find(|number| is_point(&number.free))?;
    let base = with_other_form_at_rest(&of.base)?;
    Some(Hypothesis { base, ..of.clone() })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn smooth_curves_have_another_form_and_straight_ones_none() {
        let smooth = Params::new();
        let kinked = with_other_form_at_rest(&smooth).unwrap();
        assert_eq!(fv_interpolation(&kinked), Interpolation::CubicEachSide);
        assert_eq!(
            with_other_form_at_rest(&kinked).map(|params| fv_interpolation(&params)),
            Some(Interpolation::MonotoneCubic)
        );
        let mut straight = smooth;
        straight.set(number!("fv_interpolation"), choice_of_interpolation(Interpolation::Linear)).unwrap();
        assert!(with_other_form_at_rest(&straight).is_none());
    }
}
