//! The numbers of the model that is diagnosed.

use dashpot_core::Params;
use dashpot_core::elements::GROUPS;
use dashpot_core::parameter::Shape;
use dashpot_estimation::hypothesis::{Number, number};
use dashpot_estimation::priors::{self, Usual};
use dashpot_estimation::unknowns::Unknown;

/// Factor by which the internal mass may leave that of the model: two standard deviations of what dampers show. A rod does not get heavier, so
/// that records which ask for more than that disagree with the model, and the mass has a name; free, it would take up any mass of the rig. Held
/// to what the rods of one laboratory have, whatever the model says, it would make a mass of the rig of every heavier rod.
const NEAR: f64 = 1.8 * 1.8;
/// Least mass, kg, that it may go to and from: below it no record tells one from another.
const LEAST: f64 = 0.05;

fn internal_mass(base: &Params) -> Number {
    let own = base.scalar("internal_mass").max(LEAST);
    let mut from = *base;
    let _ = from.set("internal_mass", own);
    let bounds = ((own / NEAR).max(LEAST).ln(), (own * NEAR).ln());
    Number { bounds, ..number(&from, Unknown::Log("internal_mass")) }
}

/// Elements whose numbers [`base_numbers`] lists by itself.
const LISTED: [&str; 8] = [
    "fv_curve",
    "series_compliance",
    "parallel_spring",
    "gas_preload",
    "coulomb_friction",
    "stribeck_friction",
    "viscous_friction",
    "side_force_friction",
];

/// Standard deviations off what dampers show from which a number is there to switch something off: no damper is meant by it.
const SWITCHED_OFF: f64 = 5.0;

/// Numbers of the elements beyond those: of what a fit or an earlier diagnosis has put into the model, as presliding friction. Held, they
/// would leave it to another effect to give way in their place.
fn of_other_elements(base: &Params) -> Vec<Unknown> {
    let mut all = Vec::new();
    for group in GROUPS.iter().filter(|g| base.is_on(g.name) && !LISTED.contains(&g.name)) {
        for p in group.parameters.iter().filter(|p| matches!(p.shape, Shape::Scalar)) {
            let (value, Some(prior)) = (base.scalar(p.name), priors::of(p.name)) else { continue };
            // What a temperature does to a test is counted beside the model.
            let is_heat = p.name == "heat_capacity";
            if value == 0.0 || prior.usual.off(value).abs() > SWITCHED_OFF || is_heat {
                continue;
            }
            all.push(if matches!(prior.usual, Usual::Size(..)) {
                Unknown::Log(p.name)
            } else {
                Unknown::Linear(p.name)
            });
        }
    }
    all
}

/// The numbers of the base model that a refit may change.
pub fn base_numbers(base: &Params) -> Vec<Number> {
    use dashpot_estimation::unknowns::{CurveName, Unknowns};
    let mut list = Vec::new();
    let on = |name: &str| base.is_on(name);
    if on("series_compliance") {
        list.push(internal_mass(base));
    }
    let mut add = |unknown: Unknown| list.push(number(base, unknown));
    for rise in Unknowns::rises(base, CurveName::Fv) {
        add(rise);
    }
    if on("series_compliance") {
        add(Unknown::Log("series_stiffness"));
        add(Unknown::Linear("series_damping"));
    }
    if on("parallel_spring") {
        for name in ["spring_linear", "spring_quadratic", "spring_cubic", "spring_quartic"] {
            if base.scalar(name) != 0.0 {
                add(Unknown::Linear(name));
            }
        }
        if base.list("spring_displacement").len() > 2 {
            for rise in Unknowns::rises(base, CurveName::Spring) {
                add(rise);
            }
        }
    }
    if on("gas_preload") {
        add(Unknown::Linear("gas_force"));
    }
    if on("coulomb_friction") {
        add(Unknown::Linear("coulomb_force"));
        add(Unknown::Log("coulomb_steepness"));
    }
    if on("stribeck_friction") {
        add(Unknown::Linear("stribeck_coulomb_force"));
        add(Unknown::Above("stribeck_breakaway_force", "stribeck_coulomb_force"));
        add(Unknown::Log("stribeck_breakaway_velocity"));
    }
    if on("viscous_friction") {
        add(Unknown::Linear("viscous_coefficient"));
    }
    if on("side_force_friction") {
        add(Unknown::Linear("side_force_coefficient"));
    }
    of_other_elements(base).into_iter().for_each(add);
    list
}

#[cfg(test)]
mod tests {
    use super::*;
    use dashpot_estimation::hypothesis::Free;

    fn free(base: &Params) -> Vec<&'static str> {
        let name = |number: Number| match number.free {
            Free::Model(Unknown::Log(name) | Unknown::Linear(name) | Unknown::Above(name, _)) => Some(name),
            _ => None,
        };
        base_numbers(base).into_iter().filter_map(name).collect()
    }

    #[test]
    fn what_a_fit_or_a_diagnosis_has_put_into_the_model_is_refitted_with_the_rest() {
        let mut base = Params::new();
        assert!(!free(&base).contains(&"presliding_force"));
        base.enable("presliding_friction", true).unwrap();
        base.set("presliding_power", 1.0).unwrap();
        let names = free(&base);
        assert!(names.contains(&"presliding_force") && names.contains(&"presliding_length"), "{names:?}");
        // A creep that no seal has: the default, which means none.
        assert!(!names.contains(&"presliding_creep"), "{names:?}");
    }

    #[test]
    fn what_is_there_to_switch_something_off_stays() {
        let mut base = Params::new();
        base.enable("bushing", true).unwrap();
        base.set("bushing_loss_time", 1e3).unwrap();
        base.set("bushing_stop_stiffness", 0.0).unwrap();
        base.set("bushing_slip", 1e-4).unwrap();
        let names = free(&base);
        assert!(names.contains(&"bushing_hardening") && names.contains(&"bushing_slip"), "{names:?}");
        assert!(!names.contains(&"bushing_loss_time") && !names.contains(&"bushing_stop_stiffness"), "{names:?}");
    }

    #[test]
    fn no_number_is_there_twice() {
        let mut base = Params::new();
        for element in dashpot_core::elements::names() {
            base.enable(element, true).unwrap();
        }
        let mut names = free(&base);
        let count = names.len();
        names.sort_unstable();
        names.dedup();
        assert_eq!(names.len(), count, "{names:?}");
    }
}
