//! Check whether the step of a host resolves the oscillation of the internal mass on its series spring.

use crate::limit::plain;
use dashpot_core::Model;

/// Returns a remark for a damper in host steps of `step`, s.
///
/// The remark states that the internal mass oscillates on its series spring, and that the steps do not resolve the oscillation. Returns
/// `None` if they resolve it.
pub fn remark(model: &Model, step: f64) -> Option<String> {
    let integration = model.integration();
    let longest = integration.longest_that_follows();
    (step > longest).then(|| {
        let becomes = if integration.quiets() {
            "its swing is damped away, and the force may be off by a few per cent"
        } else {
            "its swing may fall in with the motion, with several times the force that the damper makes"
        };
        format!(
            "The mass inside rings on its series spring, which hardly anything damps, faster than the substeps of a host step of {} ms follow: {becomes}. \
             Steps of {} ms or less follow it; the method automatic without substeps of its own follows it in the longest steps. If the real damper \
             does not ring, give series_damping a value.",
            1e3 * step,
            plain(1e3 * longest)
        )
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use dashpot_core::{Params, element, list, number};

    fn model(damps: f64, method: f64, substeps: f64) -> Model {
        let mut params = Params::new();
        params.set(number!("method"), method).unwrap();
        params.set(number!("series_damping"), 0.0).unwrap();
        params.set(number!("substeps"), substeps).unwrap();
        let forces: Vec<f64> = params.list(list!("fv_force")).iter().map(|force| damps * force).collect();
        params.set_list(list!("fv_force"), &forces).unwrap();
        Model::new(&params).unwrap()
    }

    #[test]
    fn a_damped_mass_needs_no_remark() {
        for substeps in [0.0, 1.0] {
            assert_eq!(remark(&model(1.0, 1.0, substeps), 0.1), None);
        }
    }

    #[test]
    fn what_the_remark_advises_helps() {
        let mut params = Params::new();
        params.enable(element!("fv_curve"), false);
        for (damping, rings) in [(0.0, true), (100.0, true), (200.0, false)] {
            params.set(number!("series_damping"), damping).unwrap();
            assert_eq!(remark(&Model::new(&params).unwrap(), 0.01).is_some(), rings, "{damping}");
        }
    }

    #[test]
    fn the_remark_says_what_becomes_of_the_swing() {
        assert!(remark(&model(0.02, 1.0, 1.0), 0.01).unwrap().contains("damped away"));
        let mut params = Params::new();
        params.enable(element!("oil_compressibility"), true);
        params.set(number!("internal_mass"), 20.0).unwrap();
        params.set(number!("series_stiffness"), 1e8).unwrap();
        let told = remark(&Model::new(&params).unwrap(), 0.05).unwrap();
        assert!(told.contains("several times"), "{told}");
    }

    #[test]
    fn a_mass_that_rings_is_told_in_steps_longer_than_its_substeps_follow() {
        let (automatic, one, five) = (model(0.02, 0.0, 0.0), model(0.02, 1.0, 1.0), model(0.02, 1.0, 5.0));
        // Each substep resolves 1 rad of the oscillation of the internal mass, whose angular frequency is 2450 rad/s.
        for (model, substeps) in [(&automatic, 16.0), (&one, 1.0), (&five, 5.0)] {
            let longest = substeps / (3e6f64 / 0.5).sqrt();
            assert_eq!(remark(model, 0.999 * longest), None);
            let told = remark(model, 1.001 * longest).unwrap();
            assert!(
                told.contains("rings") && told.contains(&format!("Steps of {} ms or less", plain(1e3 * longest))),
                "{told}"
            );
        }
    }
}
