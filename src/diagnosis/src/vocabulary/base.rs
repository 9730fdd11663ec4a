//! The numbers of the model that is diagnosed.

use dashpot_core::Params;
use dashpot_estimation::hypothesis::{Number, number};
use dashpot_estimation::unknowns::Unknown;

/// Masses of a rod with what moves with it, kg. A free internal mass would stand for any mass on the rig.
const ROD: (f64, f64) = (0.05, 0.6);

fn rod_mass(base: &Params) -> Number {
    let mut base = *base;
    let _ = base.set("internal_mass", base.scalar("internal_mass").clamp(ROD.0, ROD.1));
    Number { bounds: (ROD.0.ln(), ROD.1.ln()), ..number(&base, Unknown::Log("internal_mass")) }
}

/// The numbers of the base model that a refit may change.
pub fn base_numbers(base: &Params) -> Vec<Number> {
    use dashpot_estimation::unknowns::{CurveName, Unknowns};
    let mut list = Vec::new();
    let on = |name: &str| base.is_on(name);
    if on("series_compliance") {
        list.push(rod_mass(base));
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
    list
}
