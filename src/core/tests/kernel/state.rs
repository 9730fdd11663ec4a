//! A state contains all data of a run, so a run can be copied, restored, repeated and paused.

use crate::common::*;
use dashpot_core::parameter::Element;
use dashpot_core::step::{Integration, step, step_batch};
use dashpot_core::{Input, Model, Output, State, element, list};
use dashpot_test_support::drawn;
use proptest::prelude::*;
use std::f64::consts::PI;

/// Returns the bits of a state's displacements, velocities and internal states, and of all numbers of an output except
/// stop force and oil temperature.
fn bits(state: &State, output: &Output) -> Vec<u64> {
    let s = [state.displacement, state.velocity, state.mass_displacement, state.mass_velocity];
    let o = [
        output.force,
        output.d_force_d_displacement,
        output.d_force_d_velocity,
        output.primary_force,
        output.spring_force,
        output.friction_force,
        output.gas_force,
        output.series_deflection,
    ];
    s.iter().chain(&state.internal).chain(&o).map(|f| f.to_bits()).collect()
}

proptest! {
    #![proptest_config(drawn(100))]

    #[test]
    fn a_copied_state_continues_bit_for_bit(
        params in any_params(),
        motion in prop::collection::vec((-0.05..0.05f64, -1.0..1.0f64), 40),
        at in 1usize..39,
    ) {
        let model = Model::new(&params).unwrap();
        let run = |mut state: State, part: &[(f64, f64)]| {
            let mut seen = vec![];
            let mut states = vec![];
            for (x, v) in part {
                let (next, output) = step(&model, &state, &Input::motion(*x, *v), 1e-3);
                seen.push(bits(&next, &output));
                states.push(next);
                state = next;
            }
            (seen, states)
        };
        let start = model.steady_state(&Input::motion(0.0, 0.0));
        let (first, states) = run(start, &motion);
        prop_assert_eq!(&run(start, &motion).0, &first, "a second run differs");
        prop_assert_eq!(&run(states[at - 1], &motion[at..]).0[..], &first[at..], "the restored run differs");
    }

    #[test]
    fn a_step_of_no_time_is_the_static_answer(params in any_params(), x in -0.05..0.05f64, v in -1.0..1.0f64) {
        let model = Model::new(&params).unwrap();
        let from = model.steady_state(&Input::motion(0.3 * x, 0.0));
        let (state, output) = step(&model, &from, &Input::motion(x, v), 0.0);
        prop_assert_eq!(state, from);
        let settled = model.steady_state_from(&from, &Input::motion(x, v));
        let wanted = dashpot_core::evaluate(&model, &settled, &Input::motion(x, v)).0.force;
        prop_assert!((output.force - wanted).abs() <= 1e-9 * (1.0 + wanted.abs()));
    }

    #[test]
    fn a_batch_gives_the_bits_of_single_steps(
        params in any_params(),
        motion in prop::collection::vec((-0.05..0.05f64, -1.0..1.0f64), 8),
    ) {
        let model = Model::new(&params).unwrap();
        let inputs: Vec<Input> = motion.iter().map(|(x, v)| Input::motion(*x, *v)).collect();
        let from: Vec<State> = motion.iter().map(|(x, _)| model.steady_state(&Input::motion(0.9 * x, 0.0))).collect();
        let mut states = [State::ZERO; 8];
        let mut outputs = [Output::ZERO; 8];
        step_batch(&model, &from, &inputs, 1e-3, &mut states, &mut outputs);
        for i in 0..8 {
            let (state, output) = step(&model, &from[i], &inputs[i], 1e-3);
            prop_assert_eq!(bits(&states[i], &outputs[i]), bits(&state, &output));
        }
    }
}

/// If an element is switched on or off, no internal state may become the state of another element.
///
/// An earlier version interpreted a friction contact's deflection of 0.3 mm as newtons and returned a force of 24 MN.
#[test]
fn a_state_outlives_a_switch_of_elements() {
    for switched in WITH_STATES {
        let mut p = params(&[("fade_source", 1.0)]);
        p.enable(Element::find(switched).unwrap(), true);
        // Switch on as many other elements as a state can store.
        for element in WITH_STATES {
            let on = p.is_on(Element::find(element).unwrap());
            p.enable(Element::find(element).unwrap(), true);
            if Model::new(&p).is_err() {
                p.enable(Element::find(element).unwrap(), on);
            }
        }
        let with = Model::new(&p).unwrap();
        p.enable(Element::find(switched).unwrap(), false);
        let Ok(without) = Model::new(&p) else { continue };
        let named = |model: &Model, state: &State| {
            let name = |k: usize| model.state_name(k).unwrap().0;
            (2..model.states()).map(|k| (name(k), state.internal[k - 2])).collect::<Vec<_>>()
        };
        let motion = sine(0.01, 4.0);
        let mut state = with.steady_state(&Input::motion(-0.01, 0.0));
        for k in 1..=70 {
            let (x, v) = motion(f64::from(k) * 1e-3);
            state = step(&with, &state, &Input::motion(x, v), 1e-3).0;
        }
        let before = named(&with, &state);
        let there = without.laid_out(&state);
        for (name, value) in named(&without, &there) {
            assert!(before.contains(&(name, value)), "{switched}: {name} {value} of {before:?}");
        }
        let back = with.laid_out(&there);
        let kept = named(&with, &back).iter().zip(&before).filter(|(a, b)| a == b).count();
        assert!(kept >= named(&without, &there).len(), "{switched}: {before:?} {back:?}");
        // In the next step, the dampers with and without the element have forces within 3 kN of each other.
        let (x, v) = motion(0.071);
        let to = Input::motion(x, v);
        let (with_it, without_it) = (step(&with, &state, &to, 1e-3).1.force, step(&without, &state, &to, 1e-3).1.force);
        assert!((with_it - without_it).abs() < 3e3, "{switched} off: {with_it} {without_it}");
        assert_eq!(dashpot_core::evaluate(&without, &state, &to), dashpot_core::evaluate(&without, &there, &to));
    }
}

/// Steps of zero length must keep the friction state, and return the derivatives of the force at standstill.
#[test]
fn a_pause_keeps_the_friction_of_a_bent_contact() {
    for elements in [&["presliding_friction"][..], &["presliding_friction", "oil_compressibility"]] {
        let mut p = params(&[("presliding_force", 40.0), ("presliding_length", 3e-4)]);
        for element in elements {
            p.enable(Element::find(element).unwrap(), true);
        }
        p.enable(element!("stribeck_friction"), false);
        let model = Model::new(&p).unwrap();
        let mut state = model.steady_state(&Input::motion(0.0, 0.0));
        // The motion covers ten millimeters in 0.2 s with smooth ends, followed by standstill.
        let motion = |t: f64| {
            let share = (t / 0.2).min(1.0);
            (5e-3 * (1.0 - (PI * share).cos()), if share < 1.0 { 5e-3 * PI / 0.2 * (PI * share).sin() } else { 0.0 })
        };
        let mut held = 0.0;
        for k in 1..=2000 {
            let (x, v) = motion(f64::from(k) * 1e-3);
            let (next, output) = step(&model, &state, &Input::motion(x, v), 1e-3);
            (state, held) = (next, output.force);
        }
        let here = Input::motion(state.displacement, 0.0);
        let (same, output) = step(&model, &state, &here, 0.0);
        assert_eq!(same, state);
        assert!((output.force - held).abs() < 1e-3 && output.friction_force > 39.0, "{elements:?}: {held} {output:?}");
        // The displacement derivative contains the friction contact's mean stiffness over both directions. The velocity
        // derivative is that of the FV curve at zero velocity.
        let moved = |by: f64| step(&model, &state, &Input::motion(state.displacement + by, 0.0), 0.0).1.force;
        let by_x = (moved(1e-7) - moved(-1e-7)) / 2e-7;
        assert!((output.d_force_d_displacement - by_x).abs() < 1e-2 * by_x, "{elements:?}: {by_x} {output:?}");
        let by_v = model.elements().paths.fv_curve.evaluate(0.0).derivative;
        assert!((output.d_force_d_velocity - by_v).abs() < 1e-2 * by_v, "{elements:?}: {by_v} {output:?}");
    }
}

#[test]
fn static_derivatives_are_those_of_the_static_force() {
    let model = model(&[]);
    let force = |x: f64, v: f64| step(&model, &State::ZERO, &Input::motion(x, v), 0.0).1.force;
    for (x, v) in [(0.02, 0.3), (-0.03, -0.7), (0.01, 0.02)] {
        let output = step(&model, &State::ZERO, &Input::motion(x, v), 0.0).1;
        let by_x = (force(x + 1e-6, v) - force(x - 1e-6, v)) / 2e-6;
        let by_v = (force(x, v + 1e-6) - force(x, v - 1e-6)) / 2e-6;
        assert!((output.d_force_d_displacement - by_x).abs() < 1e-5 * (by_x.abs() + 1.0), "{by_x} {output:?}");
        assert!((output.d_force_d_velocity - by_v).abs() < 1e-5 * (by_v.abs() + 1.0), "{by_v} {output:?}");
    }
}

#[test]
fn the_run_has_these_digits_on_every_platform() {
    // This test does not check the model. It combines the bits of a run with every method into one number, which must
    // be equal on every platform.
    let mut sum = 0u64;
    for method in METHODS {
        let model = model(&[]).with_integration(Integration::fixed(method, 2));
        let mut state = model.steady_state(&Input::motion(0.0, 0.0));
        for i in 0..500 {
            // The velocity is a sawtooth, because the digits of a sine would depend on a library.
            let phase = (i % 100) as f64 / 100.0;
            let v = if phase < 0.5 { phase } else { phase - 1.0 };
            let (next, output) = step(&model, &state, &Input::velocity(v), 1e-3);
            sum = bits(&next, &output).iter().fold(sum, |s, b| s.rotate_left(5) ^ b);
            state = next;
        }
    }
    assert_eq!(sum, DIGITS, "got {sum:#x}");
}

const DIGITS: u64 = 0x1d17_67ef_1080_69d5;

/// With every method, the series spring balances an FV curve that has 150 N at zero velocity, both at rest and in
/// steady motion.
#[test]
fn what_is_settled_on_a_curve_with_a_force_at_rest_stays() {
    let mut p = params(&[("fv_form", 0.0), ("spring_linear", 2e4)]);
    p.enable(element!("parallel_spring"), true);
    p.set_list(list!("fv_velocity"), &[-1.0, -0.1, 0.0, 0.1, 1.0]).unwrap();
    p.set_list(list!("fv_force"), &[-700.0, -100.0, 150.0, 400.0, 1000.0]).unwrap();
    let compliant = Model::new(&p).unwrap();
    p.enable(element!("series_compliance"), false);
    let stiff = Model::new(&p).unwrap();
    for method in METHODS {
        let model = compliant.with_integration(Integration::fixed(method, 1));
        let at = Input::motion(0.01, 0.0);
        let mut state = model.steady_state(&at);
        let wanted = dashpot_core::evaluate(&model, &state, &at).0.force;
        for _ in 0..20 {
            let (after, output) = step(&model, &state, &at, 1e-3);
            assert!((output.force - wanted).abs() < 1e-9 * wanted, "{method:?}: {} of {wanted}", output.force);
            assert!((output.primary_force - 150.0).abs() < 1e-6, "{method:?}: {} of the curve", output.primary_force);
            state = after;
        }
        let (v, mut force) = (0.3, 0.0);
        for k in 1..=100 {
            let (after, output) = step(&model, &state, &Input::motion(0.01 + 1e-3 * v * f64::from(k), v), 1e-3);
            (state, force) = (after, output.force);
        }
        // In steady motion, the force is the sum of FV curve, parallel spring and friction, as without the series
        // spring. The parallel spring acts at the displacement of the mass.
        let at = Input::motion(state.mass_displacement, v);
        let wanted = dashpot_core::evaluate(&stiff, &State::ZERO, &at).0.force;
        assert!((force - wanted).abs() < 5e-3 * wanted, "{method:?}: {force} of {wanted} at {v} m/s");
    }
}

/// The static force balances its components, and a run at rest converges to it. With a groove parallel to a valve, the
/// force rises steeply. In an earlier version, the iteration for the state of frequency-selective damping therefore
/// oscillated without end.
///
/// The static force of that version was 83 kN, although the valves had 0.3 kN.
#[test]
fn a_static_answer_is_balanced_where_a_state_overshoots_what_it_is_drawn_to() {
    let mut p = params(&[
        ("bypass_share", -4.0),
        ("bypass_centre", 1.5991e-4),
        ("bypass_half_width", 0.45479),
        ("bypass_blend", 5e-4),
        ("bypass_form", 1.0),
        ("bypass_flow", 0.236584),
        ("fsd_share", 0.84012),
        ("series_stiffness", 1.41e6),
    ]);
    p.enable(element!("position_dependent_damping"), true);
    p.enable(element!("frequency_selective_damping"), true);
    for knee in [-0.004, 0.001, 0.0088, 0.02] {
        p.set_list(list!("fv_velocity"), &[-0.05, knee, 0.05]).unwrap();
        p.set_list(list!("fv_force"), &[-2e4, -2e4, 2e4]).unwrap();
        let model = Model::new(&p).unwrap();
        for x in [-0.3, -0.02, 0.0, 1e-3, 0.03, 0.2] {
            let hold = Input::motion(x, 0.0);
            let at = model.static_output(&hold);
            let beside = at.friction_force + at.gas_force;
            let left = at.force - beside - at.primary_force - at.spring_force;
            assert!(left.abs() < 1e-6 * (at.primary_force.abs() + 1.0), "{knee} {x}: {at:?}");
            let mut state = model.steady_state(&hold);
            for _ in 0..2000 {
                state = step(&model, &state, &hold, 1e-3).0;
            }
            let held = step(&model, &state, &hold, 1e-3).1;
            assert!((held.force - at.force).abs() < 1e-5 * 2e4, "{knee} {x}: {held:?}, static {at:?}");
        }
    }
}
