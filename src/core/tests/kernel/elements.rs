//! Tests of the damper's elements: symmetry, peaks and limits of their forces, and no effect of an element that is off.

use crate::common::*;
use dashpot_core::parameter::{Acts, Element, List, Number, Shape, acts, table};
use dashpot_core::step::{Integration, Method, step};
use dashpot_core::{Input, Model, Params, State, evaluate};
use dashpot_core::{element, number};
use dashpot_core::{element::OperatingPoint, parameter::names};
use dashpot_test_support::drawn;
use proptest::prelude::*;

fn force(model: &Model, v: f64) -> f64 {
    evaluate(model, &State::ZERO, &Input { side_force: 500.0, ..Input::motion(0.0, v) }).0.force
}

proptest! {
    #![proptest_config(drawn(100))]

    #[test]
    fn friction_is_odd(params in any_params(), v in (-7.0..1.0f64).prop_map(|d| 10f64.powf(d))) {
        for element in Element::all().filter(|element| acts(element.place()) == Acts::Friction) {
            let mut p = params;
            p.disable_all();
            p.enable(element, true);
            let model = Model::new(&p).unwrap();
            prop_assert_eq!(force(&model, v), -force(&model, -v), "{} at {}", element.name(), v);
            prop_assert_eq!(force(&model, 0.0), 0.0);
        }
    }

    /// The cheap step uses the short form of the elements. Where an element has a short form, its force equals that of
    /// the full form bit by bit.
    #[test]
    fn a_quick_answer_is_the_full_answer(params in any_params(), x in -0.05..0.05f64, v in (-6.0..0.5f64).prop_map(|d| 10f64.powf(d)), sign in any::<bool>()) {
        let at = OperatingPoint { displacement: x, velocity: if sign { v } else { -v }, side_force: 300.0, temperature: 20.0 };
        let mut quick = 0;
        for element in names() {
            let mut p = params;
            p.disable_all();
            p.enable(Element::find(element).unwrap(), true);
            // The random parameters of an element that was off may be invalid.
            let Ok(model) = Model::new(&p) else { continue };
            let e = model.elements();
            for (at_once, full) in [
                (e.friction_at_once(&at), e.friction(&at)),
                (e.inner_at_once(&at), e.inner(&at)),
                (e.preload_at_once(&at), e.preload(&at)),
            ] {
                if let Some(answer) = at_once {
                    prop_assert_eq!(answer, full, "{} at {:?}", element, at);
                    quick += 1;
                }
            }
        }
        prop_assert!(quick > 0);
    }

    #[test]
    fn an_element_that_is_off_contributes_nothing(params in any_params(), x in -0.02..0.02f64, v in -1.0..1.0f64) {
        for (group, element) in names().enumerate() {
            let mut p = params;
            p.enable(Element::find(element).unwrap(), false);
            if element == "series_compliance" {
                p.enable(element!("free_play"), false);
                p.enable(element!("bushing"), false);
            }
            let before = Model::new(&p).unwrap();
            for row in table().filter(|row| row.group == group) {
                match row.parameter.shape {
                    Shape::List(_) => p.set_list(List::find(row.parameter.name).unwrap(), &[]).unwrap(),
                    Shape::Choice(_) => {}
                    Shape::Scalar => p.set(Number::find(row.parameter.name).unwrap(), row.parameter.high).unwrap(),
                }
            }
            // An automatic number of substeps would depend on the stiffness and mass of an element that is off.
            p.set(number!("substeps"), 1.0).unwrap();
            let after = Model::new(&p).unwrap();
            let one = Integration::fixed(Method::Fourth, 1);
            let run = |m: Model| {
                let m = m.with_integration(one);
                step(&m, &m.steady_state(&Input::motion(0.0, 0.0)), &Input::motion(x, v), 1e-3)
            };
            prop_assert_eq!(run(before), run(after), "{} is off", element);
        }
    }

    #[test]
    fn without_series_compliance_the_damper_is_algebraic(params in any_params(), x in -0.02..0.02f64, v in -1.0..1.0f64, dt in 1e-5..1e-2f64) {
        let mut p = params;
        p.enable(element!("series_compliance"), false);
        for element in WITH_STATES.into_iter().chain(["free_play"]) {
            p.enable(Element::find(element).unwrap(), false);
        }
        let model = Model::new(&p).unwrap();
        let input = Input::motion(x, v);
        let stepped = step(&model, &model.steady_state(&Input::motion(0.0, 0.0)), &input, dt).1;
        let direct = evaluate(&model, &State::ZERO, &input).0;
        // The flow through a groove is solved iteratively, so the forces of step and evaluation agree only to a
        // millionth.
        let grooved = p.is_on(element!("position_dependent_damping")) && p.number(number!("bypass_form")) == 1.0;
        let allowed = if grooved { 1e-6 } else { 1e-12 };
        prop_assert!((stepped.force - direct.force).abs() <= allowed * (1.0 + direct.force.abs()));
    }

    #[test]
    fn simplified_stribeck_peaks_at_breakaway(peak in 20.0..500.0f64, share in 0.2..0.95f64, v in 1e-4..0.1f64) {
        let coulomb = share * peak;
        let model = only(&["stribeck_friction"], &[
            ("stribeck_breakaway_force", peak), ("stribeck_coulomb_force", coulomb), ("stribeck_breakaway_velocity", v),
        ]);
        let (at, top) = (1..4000).map(|i| i as f64 * v / 1000.0).map(|u| (u, force(&model, u)))
            .fold((0.0, 0.0), |best: (f64, f64), now| if now.1 > best.1 { now } else { best });
        prop_assert!((top - peak).abs() < 1e-3 * peak, "peak {top} for {peak}");
        prop_assert!((at / v - 1.0).abs() < 0.02, "peak at {at} for {v}");
        prop_assert!((force(&model, 30.0 * v) - coulomb).abs() < 1e-9 * peak);
        // The force does not jump at the velocity `edge`, above which the exponentials are omitted.
        let edge = v * (2.0f64 * 40.0).sqrt();
        prop_assert!((force(&model, edge * 1.000_001) - force(&model, edge * 0.999_999)).abs() < 1e-9 * peak);
    }

    #[test]
    fn full_stribeck_runs_from_rest_over_the_peak_to_the_level(peak in 60.0..500.0f64, share in 0.2..0.95f64) {
        let level = share * peak;
        let model = only(&["stribeck_friction"], &[
            ("stribeck_form", 1.0), ("stribeck_breakaway_force", peak), ("stribeck_coulomb_force", level),
            ("stribeck_breakaway_velocity", 1e-4), ("stribeck_velocity", 0.1),
        ]);
        prop_assert_eq!(force(&model, 0.0), 0.0);
        // At 1 mm/s, between the velocity scales of rise (0.1 mm/s) and fall (0.1 m/s), the force is close to the peak.
        prop_assert!((force(&model, 1e-3) - peak).abs() < 2e-4 * peak);
        prop_assert!((force(&model, 1.0) - level).abs() < 1e-9 * peak);
        let top = (1..10_000).map(|i| force(&model, i as f64 * 1e-4)).fold(0.0, f64::max);
        prop_assert!(top <= peak * (1.0 + 1e-12));
    }

    #[test]
    fn side_force_friction_follows_the_size_of_the_side_force(side in -3000.0..3000.0f64, k in 0.01..0.5f64) {
        let model = only(&["side_force_friction"], &[("side_force_coefficient", k)]);
        let force = |v: f64| evaluate(&model, &State::ZERO, &Input { side_force: side, ..Input::motion(0.0, v) }).0.force;
        prop_assert!((force(0.5) - k * side.abs()).abs() < 1e-9 * (1.0 + side.abs()));
        prop_assert!((force(-0.5) + k * side.abs()).abs() < 1e-9 * (1.0 + side.abs()));
    }
}

#[test]
fn warm_gas_pushes_the_rod_out_harder() {
    let model = only(&["gas_warming"], &[("gas_warming_rate", 0.7), ("gas_warming_reference", 25.0)]);
    for (temperature, force) in [(25.0, 0.0), (85.0, -42.0), (-15.0, 28.0)] {
        let output = evaluate(&model, &State::ZERO, &Input { temperature, ..Input::motion(0.01, 0.2) }).0;
        assert!((output.force - force).abs() < 1e-12 && output.gas_force == output.force, "{temperature}");
    }
}

#[test]
fn lag_answers_a_velocity_step_as_the_exponential() {
    let mut p = Params::new();
    p.disable_all();
    p.enable(element!("lagged_polynomial"), true);
    p.set(number!("lag_slow"), 0.004).unwrap();
    p.set(number!("lag_v1"), 0.5).unwrap();
    p.set(number!("lag_v2"), 0.6).unwrap();
    let target = 3000.0 * 0.2;
    for (method, tolerance) in [(Method::Euler, 0.05), (Method::Second, 2e-3), (Method::Fourth, 2e-5)] {
        let model = Model::new(&p).unwrap().with_integration(Integration::fixed(method, 1));
        // The motion starts from rest, with a constant velocity from the first step on.
        let mut state = State { velocity: 0.2, ..model.steady_state(&Input::motion(0.0, 0.0)) };
        for i in 1..=20 {
            let t = i as f64 * 1e-3;
            let (next, output) = step(&model, &state, &Input::motion(0.2 * t, 0.2), 1e-3);
            state = next;
            let exact = target * (1.0 - (-t / 0.004f64).exp());
            assert!(
                (output.force - exact).abs() < tolerance * target,
                "{method:?} at {t}: {} for {exact}",
                output.force
            );
        }
    }
}

/// Returns the travel, m, on which the force stays below 3 N in one cycle of a sine of 3 mm and 0.5 Hz.
fn travel_without_force(model: &Model) -> f64 {
    let (steps, dt) = (8000, 2.5e-4);
    let motion = sine(3e-3, 0.5);
    let forces = step_forces(model, &motion, dt, steps, false);
    let from = |i: usize| motion((i + 1) as f64 * dt).0;
    (1..steps).filter(|i| forces[*i].abs() < 3.0).map(|i| (from(i) - from(i - 1)).abs()).sum()
}

/// Play in an eye that carries the whole force occurs where the total force of the damper, including friction, is zero.
/// Play in series with the hydraulic force alone occurs where the hydraulic force is zero, and thus at a force of the
/// damper.
#[test]
fn play_in_an_eye_is_where_the_force_is_nothing() {
    let play = |load: f64| {
        let mut p = params(&[
            ("free_play_gap", 2e-4),
            ("free_play_force", 0.5),
            ("gas_force", 0.0),
            ("coulomb_force", 40.0),
            ("series_stiffness", 5e6),
            ("series_load", load),
        ]);
        for (element, on) in [("free_play", true), ("coulomb_friction", true), ("stribeck_friction", false)] {
            p.enable(Element::find(element).unwrap(), on);
        }
        travel_without_force(&Model::new(&p).unwrap())
    };
    // The gap of 0.2 mm is crossed twice in a cycle.
    let (whole, hydraulic) = (play(1.0), play(0.0));
    assert!(whole > 2e-4 && whole < 5e-4, "{whole}");
    assert!(hydraulic < 0.3 * whole, "{hydraulic} beside {whole}");
}

/// With a very stiff series spring, friction and gas behind this spring give the forces of friction and gas parallel to
/// the damper.
#[test]
fn behind_a_stiff_series_spring_friction_and_gas_act_as_beside_it() {
    let forces = |load: f64| {
        let model = with(
            &["coulomb_friction", "side_force_friction"],
            &[("series_stiffness", 1e8), ("internal_mass", 0.05), ("series_load", load), ("series_damping", 3e3)],
        );
        step_forces(&model, &sine(0.02, 2.0), 1e-4, 5000, false)
    };
    let (whole, beside) = (forces(1.0), forces(0.0));
    let top = beside.iter().fold(0.0f64, |m, f| m.max(f.abs()));
    for (i, (a, b)) in whole.iter().zip(&beside).enumerate().skip(200) {
        // Samples near a reversal of the friction are excluded.
        let turns = (i % 2500) < 40 || (i % 2500) > 2460;
        assert!(turns || (a - b).abs() < 2e-3 * top, "{i}: {a}, {b}");
    }
}

/// A parameter of a form that is not chosen does not change the force.
#[test]
fn numbers_of_other_forms_do_not_count() {
    for row in table().filter(|row| row.parameter.form.is_some()) {
        let (choice, words) = row.parameter.form.unwrap();
        let choice = Number::find(choice).unwrap();
        let Shape::Choice(all) = choice.parameter().shape else { panic!("{choice}") };
        for (place, word) in all.iter().enumerate() {
            let mut params = Params::new();
            params.enable(row.element().unwrap(), true);
            params.set(choice, place as f64).unwrap();
            let forces = |params: &Params| -> Vec<f64> {
                let model = Model::new(params).unwrap();
                let mut state = model.steady_state(&Input::motion(0.0, 0.0));
                let motion = crate::common::sine(0.03, 4.0);
                let mut heated = |i: usize| {
                    let (x, v) = motion(i as f64 * 1e-3);
                    let output;
                    (state, output) = step(&model, &state, &Input { temperature: 60.0, ..Input::motion(x, v) }, 1e-3);
                    output.force
                };
                (1..500).map(&mut heated).collect()
            };
            let now = forces(&params);
            let mut differs = false;
            for share in [0.3, 0.7] {
                let mut other = params;
                let (low, high) = row.parameter.of_a_car;
                match row.parameter.shape {
                    Shape::List(_) => {
                        let list = List::find(row.parameter.name).unwrap();
                        let values: Vec<f64> = params.list(list).iter().map(|v| (1.0 + share) * v).collect();
                        other.set_list(list, &values).unwrap();
                    }
                    // Use a value near the default. Values between the bounds could be invalid together for the
                    // derivatives and knees of the FV curve.
                    Shape::Scalar => {
                        let number = Number::find(row.parameter.name).unwrap();
                        let near = number.default() * (0.5 + share);
                        other
                            .set(number, if near > low { near.min(high) } else { low + share * (high - low) })
                            .unwrap();
                    }
                    Shape::Choice(_) => other.set(Number::find(row.parameter.name).unwrap(), 1.0).unwrap(),
                }
                if let Ok(true) = Model::check(&other).map(|()| forces(&other) != now) {
                    differs = true;
                }
            }
            let counts = params.counts(&row);
            assert_eq!(counts, words.contains(word));
            assert!(counts || !differs, "{} counts with {word} of {choice}", row.parameter.name);
        }
    }
}
