//! The numbers of the model that is diagnosed.

use dashpot_core::Params;
use dashpot_estimation::hypothesis::{Number, number};
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
    list
}
