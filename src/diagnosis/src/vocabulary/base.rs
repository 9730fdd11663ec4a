//! The numbers of the model that is diagnosed.

use dashpot_core::Params;
use dashpot_estimation::hypothesis::{Number, number};
use dashpot_estimation::unknowns::Unknown;

/// The numbers of the base model that a refit may change.
pub fn base_numbers(base: &Params) -> Vec<Number> {
    use dashpot_estimation::unknowns::{CurveName, Unknowns};
    let mut list = Vec::new();
    let on = |name: &str| base.is_on(name);
    let mut add = |unknown: Unknown| list.push(number(base, unknown));
    for rise in Unknowns::rises(base, CurveName::Fv) {
        add(rise);
    }
    if on("series_compliance") {
        // What a rod with all that moves with it has is a matter of its prior: a bound would call the rest a mass of the rig.
        add(Unknown::Log("internal_mass"));
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
    list
}
