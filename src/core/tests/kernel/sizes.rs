//! If a damper is scaled in proportion, its forces scale by the same factor.
//!
//! The other tests check dampers within the bounds of a passenger car. Because of this property, their results hold for
//! allowed dampers of all sizes. Oil, voids and valves contain small constant forces (a leakage, a laminar flow, a
//! contact) that do not scale. For these elements, the random search in crate `dashpot-abi` draws dampers of all sizes.

use crate::common::{any_params, describe};
use dashpot_core::parameter::{List, Number, table};
use dashpot_core::step::step;
use dashpot_core::{Input, Model, Params, Reason, element, number};
use proptest::prelude::*;

/// Scales all parameters that grow with the damper by `size`; `None` if the parameter table does not allow a result.
fn of_size(params: &Params, size: f64) -> Option<Params> {
    let mut other = *params;
    for row in table() {
        // The largest value of `fade_laminar_force` means that the whole force is laminar, and is not scaled.
        let laminar = row.parameter.name == "fade_laminar_force" && params.get(&row)[0] < row.parameter.high;
        if !row.parameter.grows && !laminar {
            continue;
        }
        let values: Vec<f64> = params.get(&row).iter().map(|value| size * value).collect();
        match Number::try_from(row) {
            Ok(number) => other.set(number, values[0]).ok()?,
            Err(_) => other.set_list(List::find(row.parameter.name).unwrap(), &values).ok()?,
        }
    }
    Some(other)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 300, ..ProptestConfig::default() })]

    #[test]
    fn a_damper_of_another_size_moves_alike(
        params in any_params(),
        // The factors are powers of four. Rounding is then equal in both dampers, and every difference comes from the
        // model.
        size in prop::sample::select(vec![1.0 / 256.0, 1.0 / 16.0, 4.0, 64.0]),
        amplitude in 0.0005..0.05f64,
        frequency in 0.5..20.0f64,
        dt in prop::sample::select(vec![1e-4, 1e-3, 5e-3]),
    ) {
        let mut params = params;
        for own in [
            element!("oil_compressibility"),
            element!("aeration"),
            element!("cavitation"),
            element!("position_dependent_damping"),
            element!("frequency_selective_damping"),
            element!("valve_hysteresis"),
        ] {
            params.enable(own, false);
        }
        let Some(other) = of_size(&params, size) else { return Ok(()) };
        let (Ok(a), Ok(b)) = (Model::new(&params), Model::new(&other)) else { return Ok(()) };
        let x = |t: f64| amplitude * (std::f64::consts::TAU * frequency * t).sin();
        let start = Input::motion(0.0, 0.0);
        let (mut one, mut two) = (a.steady_state(&start), b.steady_state(&start));
        let mut largest = 1e-3f64;
        for i in 1..=200 {
            let (t, before) = (i as f64 * dt, (i - 1) as f64 * dt);
            let input = Input::motion(x(t), (x(t) - x(before)) / dt);
            let (first, second);
            (one, first) = step(&a, &one, &input, dt);
            (two, second) = step(&b, &two, &input, dt);
            largest = largest.max(first.force.abs());
            let off = second.force / size - first.force;
            prop_assert!(off.abs() <= 1e-6 * largest, "{i}: {} N, {size} times the size {} N: {}", first.force, second.force, describe(&params));
        }
    }
}

#[test]
fn dampers_of_any_size_are_allowed_whole() {
    for factor in [1.01e-3, 0.02, 1.0, 99.0] {
        Model::check(&of_size(&Params::new(), factor).unwrap()).unwrap();
    }
}

#[test]
fn a_number_of_another_size_is_named() {
    let mut params = of_size(&Params::new(), 0.01).unwrap();
    params.set(number!("internal_mass"), 1e-4).unwrap();
    Model::check(&params).unwrap();
    params.set(number!("series_stiffness"), 1e7).unwrap();
    let refused = Model::check(&params).unwrap_err();
    assert_eq!(refused, number!("internal_mass").fault(Reason::OutOfProportion));
    let mut params = Params::new();
    params.set(number!("series_stiffness"), 2e8).unwrap();
    params.set(number!("gas_force"), 2e4).unwrap();
    Model::check(&params).unwrap();
    params.set(number!("internal_mass"), 5e-3).unwrap();
    assert_eq!(Model::check(&params).unwrap_err().reason, Reason::OutOfProportion);
}

/// Numbers at the ends of a car damper's bounds may violate other conditions, but the check of proportion accepts them.
#[test]
fn what_a_car_may_have_goes_together() {
    for low in [true, false] {
        let mut params = Params::new();
        for (i, row) in table().enumerate() {
            if let Ok(number) = Number::try_from(row) {
                let (least, most) = row.parameter.of_a_car;
                params.set(number, if low == (i % 2 == 0) { least } else { most }).unwrap();
            }
        }
        let refused = Model::check(&params).err();
        assert!(refused.is_none_or(|fault| fault.reason != Reason::OutOfProportion), "{refused:?}");
    }
}

/// The check of proportion ignores the parameters of forms that are not chosen.
#[test]
fn numbers_of_other_forms_have_no_part_in_it() {
    let mut params = of_size(&Params::new(), 1.01e-3).unwrap();
    params.set(number!("fv_rebound_c1"), 1e6).unwrap();
    Model::check(&params).unwrap();
    params.set(number!("fv_form"), 1.0).unwrap();
    assert_eq!(Model::check(&params).unwrap_err().reason, Reason::OutOfProportion);
}
