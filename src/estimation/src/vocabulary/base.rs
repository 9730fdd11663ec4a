//! Free parameters of the diagnosed model.

use crate::hypothesis::{Number as FreeNumber, number};
use crate::priors::{self, Distribution};
use crate::scale::Scale;
use crate::unknowns::Unknown;
use dashpot_core::Params;
use dashpot_core::parameter::{Element, Number, Row, Shape, table};
use dashpot_core::{element, list, number};

/// Largest ratio of the internal mass to its value in the given model: two standard deviations of its distribution over
/// dampers. If records require a larger mass, they contradict the model, and the mass becomes a separate effect.
/// Without this bound, the parameter would absorb any mass of the rig. If the bound came from the rods of one
/// laboratory, every heavier rod would count as a mass of the rig. There is no lower bound, because a lighter rod
/// cannot absorb an effect.
const NEAR: f64 = 1.8 * 1.8;
/// Smallest internal mass of a car damper, kg, as a bound and as a start. The inertia force of this mass is half a
/// newton at 16.7 Hz and 10 mm, below the noise of a rig. With a bound of 0.05 kg, the mass of a massless damper stayed
/// at the bound, and its series spring was 7 % too soft.
const LEAST: f64 = 0.005;

fn internal_mass(base: &Params) -> FreeNumber {
    let least = LEAST * Scale::from_params(base).force();
    let own = base.number(number!("internal_mass")).max(least);
    let mut from = *base;
    let _ = from.set(number!("internal_mass"), own);
    let bounds = (libm::log(least), libm::log(own * NEAR));
    FreeNumber { bounds, ..number(&from, Unknown::Log(number!("internal_mass"))) }
}

/// Elements with parameters that [`base_numbers`] lists explicitly.
const LISTED: [Element; 8] = [
    element!("fv_curve"),
    element!("series_compliance"),
    element!("parallel_spring"),
    element!("gas_preload"),
    element!("coulomb_friction"),
    element!("stribeck_friction"),
    element!("viscous_friction"),
    element!("side_force_friction"),
];

/// Distance of a parameter's value from its prior center, in standard deviations, beyond which the value is assumed to
/// disable a term of the element.
const SWITCHED_OFF: f64 = 5.0;

/// Returns the parameters of enabled elements that [`LISTED`] does not contain, such as presliding friction. A fit or
/// an earlier diagnosis has added these elements. If their parameters were fixed, other effects would absorb the errors
/// of the fixed values.
fn of_other_elements(base: &Params) -> Vec<Unknown> {
    let scale = Scale::from_params(base);
    let mut all = Vec::new();
    let own = |row: &Row| row.element().is_some_and(|e| base.is_on(e) && !LISTED.contains(&e));
    for row in table().filter(own).filter(|row| matches!(row.parameter.shape, Shape::Scalar)) {
        let Ok(number) = Number::try_from(row) else { continue };
        let (value, Some(usual)) = (base.number(number), priors::distribution(number, scale)) else { continue };
        // The temperature of a test is computed outside the model, so the heat capacity stays fixed.
        let is_heat = number == number!("heat_capacity");
        if value == 0.0 || usual.standard_score(value).abs() > SWITCHED_OFF || is_heat {
            continue;
        }
        all.push(if matches!(usual, Distribution::Size(..)) { Unknown::Log(number) } else { Unknown::Linear(number) });
    }
    all
}

/// Returns the parameters of the base model that a refit may change.
pub fn base_numbers(base: &Params) -> Vec<FreeNumber> {
    use crate::unknowns::{CurveName, Unknowns};
    let mut list = Vec::new();
    let on = |element| base.is_on(element);
    if on(element!("series_compliance")) {
        list.push(internal_mass(base));
    }
    let mut add = |unknown: Unknown| list.push(number(base, unknown));
    for rise in Unknowns::rises(base, CurveName::Fv) {
        add(rise);
    }
    if on(element!("series_compliance")) {
        add(Unknown::Log(number!("series_stiffness")));
        add(Unknown::Linear(number!("series_damping")));
    }
    if on(element!("parallel_spring")) {
        for power in
            [number!("spring_linear"), number!("spring_quadratic"), number!("spring_cubic"), number!("spring_quartic")]
        {
            if base.number(power) != 0.0 {
                add(Unknown::Linear(power));
            }
        }
        if base.list(list!("spring_displacement")).len() > 2 {
            for rise in Unknowns::rises(base, CurveName::Spring) {
                add(rise);
            }
        }
    }
    if on(element!("gas_preload")) {
        add(Unknown::Linear(number!("gas_force")));
    }
    if on(element!("coulomb_friction")) {
        add(Unknown::Linear(number!("coulomb_force")));
        add(Unknown::Log(number!("coulomb_steepness")));
    }
    if on(element!("stribeck_friction")) {
        add(Unknown::Linear(number!("stribeck_coulomb_force")));
        add(Unknown::Above(number!("stribeck_breakaway_force"), number!("stribeck_coulomb_force")));
        add(Unknown::Log(number!("stribeck_breakaway_velocity")));
    }
    if on(element!("viscous_friction")) {
        add(Unknown::Linear(number!("viscous_coefficient")));
    }
    if on(element!("side_force_friction")) {
        add(Unknown::Linear(number!("side_force_coefficient")));
    }
    of_other_elements(base).into_iter().for_each(add);
    list
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::hypothesis::Free;

    fn free(base: &Params) -> Vec<&'static str> {
        let name = |number: FreeNumber| match number.free {
            Free::Model(Unknown::Log(n) | Unknown::Linear(n) | Unknown::Above(n, _)) => Some(n.name()),
            _ => None,
        };
        base_numbers(base).into_iter().filter_map(name).collect()
    }

    #[test]
    fn what_a_fit_or_a_diagnosis_has_put_into_the_model_is_refitted_with_the_rest() {
        let mut base = Params::new();
        assert!(!free(&base).contains(&"presliding_force"));
        base.enable(element!("presliding_friction"), true);
        base.set(number!("presliding_power"), 1.0).unwrap();
        let names = free(&base);
        assert!(names.contains(&"presliding_force") && names.contains(&"presliding_length"), "{names:?}");
        // The default creep speed, which no seal has, disables creep.
        assert!(!names.contains(&"presliding_creep"), "{names:?}");
    }

    #[test]
    fn what_is_there_to_switch_something_off_stays() {
        let mut base = Params::new();
        base.enable(element!("bushing"), true);
        base.set(number!("bushing_loss_time"), 1e3).unwrap();
        base.set(number!("bushing_stop_stiffness"), 0.0).unwrap();
        base.set(number!("bushing_slip"), 1e-4).unwrap();
        let names = free(&base);
        assert!(names.contains(&"bushing_hardening") && names.contains(&"bushing_slip"), "{names:?}");
        assert!(!names.contains(&"bushing_loss_time") && !names.contains(&"bushing_stop_stiffness"), "{names:?}");
    }

    #[test]
    fn no_number_is_there_twice() {
        let mut base = Params::new();
        for element in Element::all() {
            base.enable(element, true);
        }
        let mut names = free(&base);
        let count = names.len();
        names.sort_unstable();
        names.dedup();
        assert_eq!(names.len(), count, "{names:?}");
    }
}
