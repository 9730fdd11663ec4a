//! At every setting, a family (an adjustable damper) equals the ordinary damper with the interpolated parameters, for
//! all elements.
//!
//! Further tests check the actuator, which changes the setting over time.

use crate::common::{any_params, describe, params, paths, sine};
use dashpot_core::evaluate::partials;
use dashpot_core::family::{Axis, Delay, Family};
use dashpot_core::parameter::{Number, Shape, table};
use dashpot_core::step::step;
use dashpot_core::{Input, Model, Output, Params, Reason, State, element, evaluate, list, number};
use dashpot_test_support::drawn;
use proptest::prelude::*;
use std::sync::atomic::{AtomicUsize, Ordering};

pub const GRID: [f64; 5] = [0.0, 0.4, 0.8, 1.2, 1.6];

/// Returns the forces of the FV table, N, increased by the fraction 0.3 `size` near standstill, and by up to 1.3 `size`
/// at speed.
fn forces(params: &Params, size: f64) -> Vec<f64> {
    let (v, f) = (params.list(list!("fv_velocity")), params.list(list!("fv_force")));
    v.iter().zip(f).map(|(v, f)| f * (1.0 + size * (0.3 + v.abs() / (0.2 + v.abs())))).collect()
}

/// Makes a setting over whose grid the FV forces and `numbers` grow, by unequal amounts between the grid values.
pub fn over(params: &Params, numbers: &[Number]) -> Axis {
    let mut axis = Axis::NONE;
    axis.set_grid(&GRID).unwrap();
    let sizes = [0.0, 0.1, 0.6, 0.65, 1.4];
    for (index, size) in sizes.iter().enumerate() {
        axis.set_forces(index, &forces(params, *size)).unwrap();
    }
    for number in numbers {
        let value = params.number(*number);
        axis.set_values(*number, &sizes.map(|size| number.inside(value * (1.0 + 0.4 * size)))).unwrap();
    }
    axis
}

/// Returns the numeric parameters of the elements that are on, without those of forms that are not chosen.
pub fn numbers_of(params: &Params) -> Vec<Number> {
    table()
        .filter(|row| row.element().is_some() && params.counts(row) && matches!(row.parameter.shape, Shape::Scalar))
        .filter_map(|row| Number::try_from(row).ok())
        .collect()
}

/// Makes a family on the heap, because it is large.
pub fn family(params: &Params, axis: &Axis) -> Result<Box<Family>, dashpot_core::Fault> {
    let mut family = Box::new(Family::OFF);
    family.set(params, axis)?;
    Ok(family)
}

/// Returns the largest difference, N, between the forces of a family at a constant setting and those of the ordinary
/// damper `model`. Also returns the largest force, N.
///
/// With `begins_anew`, every step begins from the ordinary damper's state. Otherwise rounding errors may grow without
/// bound if the damper is almost undamped.
fn apart(family: &Family, model: &Model, setting: f64, dt: f64, begins_anew: bool) -> (f64, f64) {
    let model = model.with_integration(family.model().integration());
    let motion = sine(0.02, 4.0);
    let start = Input::motion(0.0, 0.0);
    let (mut own, mut plain) = (family.steady_state(&start, Some(setting)), model.steady_state(&start));
    let mut delay = Delay::UNSET;
    let (mut off, mut largest) = (0.0f64, 0.0f64);
    for k in 1..=300 {
        let (x, v) = motion(f64::from(k) * dt);
        let to = Input { temperature: 45.0, side_force: 300.0, ..Input::motion(x, v) };
        let mut output = Output::ZERO;
        if begins_anew {
            own = family.laid_out(&plain, Some(setting));
        }
        assert!(family.step_in_place(&mut own, &mut delay, &to, Some(setting), dt, &mut output, true));
        let (next, wanted) = step(&model, &plain, &to, dt);
        plain = next;
        off = off.max((output.force - wanted.force).abs());
        largest = largest.max(wanted.force.abs());
    }
    (off, largest)
}

#[test]
fn a_constant_setting_is_the_ordinary_damper_of_the_interpolated_numbers() {
    let mut all = vec![("default", params(&[])), ("euler", params(&[("method", 2.0)]))];
    let mut beside = params(&[]);
    for element in [
        "coulomb_friction",
        "side_force_friction",
        "gas_warming",
        "presliding_friction",
        "gas_spring",
        "moving_mass",
        "bump_stop",
        "rebound_stop",
    ] {
        beside.enable(dashpot_core::parameter::Element::find(element).unwrap(), true);
    }
    all.push(("all beside", beside));
    beside.set(number!("moving_mass_place"), 1.0).unwrap();
    all.push(("mass inside", beside));
    let mut knees = params(&[]);
    knees.set(number!("fv_form"), 1.0).unwrap();
    all.push(("knees", knees));
    all.push(("no curve", {
        let mut p = params(&[]);
        p.enable(element!("fv_curve"), false);
        p
    }));
    all.extend(paths());
    let mut compared = 0;
    for (name, params) in all {
        for numbers in [
            vec![],
            numbers_of(&params)
                .into_iter()
                .filter(|number| number.name() != "bushing_slow_stiffness" && !number.name().starts_with("oil_"))
                .take(24)
                .collect(),
        ] {
            let mut axis = over(&params, &numbers);
            let curve = params.is_on(element!("fv_curve")) && params.number(number!("fv_form")) == 0.0;
            if !curve {
                // A damper without an FV table cannot have forces over the setting.
                let mut without = Axis::NONE;
                without.set_grid(&GRID).unwrap();
                for number in &numbers {
                    without.set_values(*number, axis.values(*number).unwrap()).unwrap();
                }
                axis = without;
            }
            let family = match family(&params, &axis) {
                Ok(family) => family,
                Err(fault) => panic!(
                    "{name}: {fault:?} {:?}",
                    table().nth(fault.parameter as usize).map(|row| row.parameter.name)
                ),
            };
            for setting in [0.0, 0.13, 0.4, 0.71, 1.6] {
                let ordinary = axis.params_at(&params, setting);
                let model = Model::new(&ordinary).unwrap();
                let (off, largest) = apart(&family, &model, setting, 1e-3, false);
                assert!(
                    off <= 1e-8 * largest.max(1.0),
                    "{name} at {setting}, {} numbers: {off} of {largest} N",
                    numbers.len()
                );
                compared += 1;
            }
        }
    }
    assert!(compared > 400, "{compared}");
}

#[test]
fn the_force_is_exact_on_the_grid_monotone_and_smooth_over_the_setting() {
    let params = params(&[]);
    let axis = over(&params, &[number!("stribeck_coulomb_force")]);
    let family = family(&params, &axis).unwrap();
    for v in [-1.8, -0.4, -0.03, 0.01, 0.2, 0.9, 2.0] {
        let to = Input::motion(0.0, v);
        let force = |setting: f64| {
            let mut output = Output::ZERO;
            let mut state = family.steady_state(&to, Some(setting));
            assert!(family.step_in_place(
                &mut state,
                &mut Delay::default(),
                &to,
                Some(setting),
                0.0,
                &mut output,
                true
            ));
            output.force
        };
        for setting in GRID {
            let wanted = Model::new(&axis.params_at(&params, setting)).unwrap().static_output(&to).force;
            assert!((force(setting) - wanted).abs() < 1e-9 * wanted.abs(), "{setting}: {} {wanted}", force(setting));
        }
        let mut last = force(0.0);
        for k in 1..=1600 {
            let now = force(f64::from(k) * 1e-3);
            assert!((now - last) * v >= -1e-9, "turns at {k} mA, {v} m/s");
            last = now;
        }
        // Outside the grid the setting is clamped.
        assert_eq!((force(-1.0), force(5.0)), (force(0.0), force(1.6)));
        let derivative = |setting: f64| {
            family
                .d_force_d_setting(&family.steady_state(&to, Some(setting)), &Delay::UNSET, &to, Some(setting), 0.0)
                .unwrap()
        };
        for setting in [0.4, 0.8, 1.2] {
            let (before, after) = (derivative(setting - 1e-4), derivative(setting + 1e-4));
            assert!(
                (before - after).abs() < 0.02 * (before.abs() + after.abs()) + 0.1,
                "{before} {after} at {setting}, {v}"
            );
            // The derivative of the force with respect to the setting is nonzero at the grid values, so a controller
            // has a gain there.
            assert!(v.abs() < 0.1 || derivative(setting).abs() > 10.0, "{} at {setting}, {v}", derivative(setting));
        }
    }
}

/// Number of dampers in which rounding errors decide the result of a step.
static DECIDED_BY_ROUNDING: AtomicUsize = AtomicUsize::new(0);

proptest! {
    #![proptest_config(drawn(150))]

    /// A family with any elements and any varying parameters equals the ordinary damper with the interpolated
    /// parameters, at a constant setting.
    ///
    /// In about one of a thousand dampers, rounding errors decide the result of a step. Stribeck friction behind the
    /// series spring has two equilibria, stuck and sliding. In other dampers, an iteration may stop one step earlier.
    #[test]
    fn any_family_is_the_ordinary_damper_at_a_constant_setting(params in any_params(), setting in 0.0..1.6f64, which in any::<u64>()) {
        let numbers: Vec<Number> = numbers_of(&params)
            .into_iter()
            .enumerate()
            .filter(|(i, number)| which >> (i % 64) & 1 == 1 && !number.name().starts_with("bushing_slow") && !number.name().starts_with("oil_"))
            .map(|(_, number)| number)
            .take(32)
            .collect();
        let mut axis = over(&params, &numbers);
        if !params.is_on(element!("fv_curve")) || params.number(number!("fv_form")) == 1.0 {
            let mut without = Axis::NONE;
            without.set_grid(&GRID).unwrap();
            for number in &numbers {
                without.set_values(*number, axis.values(*number).unwrap()).unwrap();
            }
            axis = without;
        }
        let Ok(family) = family(&params, &axis) else { return Ok(()) };
        let Ok(model) = Model::new(&axis.params_at(&params, setting)) else { return Err(TestCaseError::fail("no model between two")) };
        let (off, largest) = apart(&family, &model, setting, 5e-4, true);
        if off > 1e-7 * largest.max(1.0) {
            let found = DECIDED_BY_ROUNDING.fetch_add(1, Ordering::Relaxed) + 1;
            prop_assert!(found <= 3, "{off} of {largest} N in {found} dampers: {}", describe(&params));
        }
    }
}

/// Makes a setting with all parameters of an actuator.
fn moved(params: &Params) -> Axis {
    let mut axis = over(params, &[number!("gas_force"), number!("series_damping")]);
    for (index, value) in [0.4, 8e-3, 20e-3, 5e-3, 200.0, 100.0, 0.03].into_iter().enumerate() {
        axis.set_number(index, value).unwrap();
    }
    axis
}

#[test]
fn the_valve_follows_a_command_in_its_time_up_and_down() {
    let params = params(&[]);
    let mut axis = moved(&params);
    for (index, none) in [(4, 0.0), (5, 0.0), (6, 0.0)] {
        axis.set_number(index, none).unwrap();
    }
    let family = family(&params, &axis).unwrap();
    let input = Input::motion(0.0, 0.3);
    for (from, to, time) in [(0.4, 1.2, 8e-3), (1.2, 0.4, 20e-3)] {
        let mut state = family.steady_state(&input, Some(from));
        let mut delay = family.steady_delay(Some(from));
        let dt = 0.25e-3;
        let mut reached = None;
        for k in 1..=400 {
            let mut output = Output::ZERO;
            assert!(family.step_in_place(&mut state, &mut delay, &input, Some(to), dt, &mut output, true));
            let way = (family.setting_of(&state, Some(to)) - from) / (to - from);
            assert!((0.0..=1.0).contains(&way));
            if way >= 1.0 - (-1.0f64).exp() && reached.is_none() {
                reached = Some(f64::from(k) * dt);
            }
        }
        let wanted = 5e-3 + time;
        assert!((reached.unwrap() - wanted).abs() < 1e-3, "{reached:?} {wanted}");
    }
}

/// A run that continues from a copied state and dead-time buffer gives, bit by bit, the forces of the original run.
#[test]
fn a_copy_of_state_and_dead_time_is_all_that_a_run_needs() {
    let params = params(&[]);
    let family = family(&params, &moved(&params)).unwrap();
    let motion = sine(0.02, 3.0);
    let run = |from: (State, Delay), steps: core::ops::Range<i32>| {
        let (mut state, mut delay) = from;
        let mut forces = Vec::new();
        for k in steps {
            let (x, v) = motion(f64::from(k) * 1e-3);
            let mut output = Output::ZERO;
            let setting = Some(0.2 + 0.1 * f64::from(k % 13));
            assert!(family.step_in_place(
                &mut state,
                &mut delay,
                &Input::motion(x, v),
                setting,
                1e-3,
                &mut output,
                true
            ));
            forces.push(output.force);
        }
        (forces, (state, delay))
    };
    let start = (family.steady_state(&Input::motion(0.0, 0.0), None), Delay::UNSET);
    let (all, _) = run(start, 1..400);
    let (_, half) = run(start, 1..200);
    let (rest, _) = run(half, 200..400);
    assert_eq!(all[199..], rest);
}

/// Steps of 2 µs and the integral of the state derivatives, computed with equal steps, give equal states within the
/// tolerance.
#[test]
fn rates_are_what_the_steps_integrate() {
    let params = params(&[("internal_mass", 5.0), ("series_stiffness", 5e5)]);
    let mut axis = moved(&params);
    axis.set_number(3, 0.0).unwrap();
    let family = family(&params, &axis).unwrap();
    let motion = sine(0.02, 2.0);
    let input = |k: i32, dt: f64| {
        let (x, v) = motion(f64::from(k) * dt);
        Input::motion(x, v)
    };
    let mut stepped = family.steady_state(&input(0, 0.0), Some(0.0));
    let mut integrated = stepped;
    let dt = 2e-6;
    for k in 0..5000 {
        let mut output = Output::ZERO;
        let at = input(k, dt);
        let (_, rate) = family.evaluate(&integrated, &at, Some(1.5));
        integrated.displacement = at.displacement.unwrap();
        integrated.mass_displacement += dt * rate.mass_displacement;
        integrated.mass_velocity += dt * rate.mass_velocity;
        for (z, rate) in integrated.internal.iter_mut().zip(rate.internal) {
            *z += dt * rate;
        }
        assert!(family.step_in_place(
            &mut stepped,
            &mut Delay::default(),
            &input(k + 1, dt),
            Some(1.5),
            dt,
            &mut output,
            false
        ));
    }
    let near = |a: f64, b: f64, size: f64| (a - b).abs() < 2e-3 * size;
    assert!(near(stepped.internal[0], integrated.internal[0], 1.0), "{stepped:?} {integrated:?}");
    assert!(near(stepped.internal[1], integrated.internal[1], 1.0), "{stepped:?} {integrated:?}");
    assert!(near(stepped.mass_velocity, integrated.mass_velocity, 0.3), "{stepped:?} {integrated:?}");
    assert!(stepped.internal[0] > 0.5);
}

#[test]
fn partials_of_a_family_are_differences_of_its_rates() {
    let mut p = params(&[]);
    p.enable(element!("gas_spring"), true);
    p.enable(element!("oil_compressibility"), true);
    let family = family(&p, &moved(&p)).unwrap();
    let input = Input::motion(0.004, 0.2);
    let mut state = family.steady_state(&Input::motion(0.0, 0.18), Some(0.7));
    state.mass_velocity += 0.02;
    state.internal[2] = 0.63;
    state.internal[3] = 0.2;
    let (own, by_setting) = family.partials(&state, &input, Some(1.1));
    assert_eq!(family.states(), 6);
    assert_eq!(
        (family.state_name(4), family.state_name(5)),
        (Some(("setting", "setting")), Some(("setting_hysteresis", "-")))
    );
    assert_eq!(family.state_name(6), None);
    let numbers = |state: &State, input: &Input, setting: f64| {
        let (output, rate) = family.evaluate(state, input, Some(setting));
        let mut all = vec![output.force, rate.mass_displacement, rate.mass_velocity];
        all.extend(rate.internal);
        all
    };
    let near = |exact: f64, seen: f64, size: f64| (exact - seen).abs() < 2e-4 * (size + seen.abs());
    for k in 0..6 {
        let moved = |by: f64| {
            let mut state = state;
            match k {
                0 => state.mass_displacement += by,
                1 => state.mass_velocity += by,
                _ => state.internal[k - 2] += by,
            }
            numbers(&state, &input, 1.1)
        };
        let size = [1e-8, 1e-6, 1e-7, 1e-7, 1e-6, 1e-6][k];
        let (plus, minus) = (moved(size), moved(-size));
        let seen: Vec<f64> = plus.iter().zip(&minus).map(|(a, b)| (a - b) / (2.0 * size)).collect();
        assert!(near(own.d_force_d_state[k], seen[0], 1.0), "force by {k}: {} {}", own.d_force_d_state[k], seen[0]);
        for i in 0..6 {
            assert!(
                near(own.d_rate_d_state[i][k], seen[1 + i], 1.0),
                "rate {i} by {k}: {} {}",
                own.d_rate_d_state[i][k],
                seen[1 + i]
            );
        }
    }
    let (plus, minus) = (numbers(&state, &input, 1.1 + 1e-6), numbers(&state, &input, 1.1 - 1e-6));
    for i in 0..6 {
        let seen = (plus[1 + i] - minus[1 + i]) / 2e-6;
        assert!(near(by_setting.rate[i], seen, 1.0), "rate {i} by setting: {} {seen}", by_setting.rate[i]);
    }
    assert_eq!(by_setting.force, 0.0);
    // Without an actuator, the command acts immediately, so the force has a derivative with respect to it.
    let axis = over(&p, &[number!("gas_force")]);
    let at_once = self::family(&p, &axis).unwrap();
    let state = at_once.steady_state(&Input::motion(0.0, 0.18), Some(0.7));
    let (_, by_setting) = at_once.partials(&state, &input, Some(0.7));
    let force = |setting: f64| at_once.evaluate(&state, &input, Some(setting)).0.force;
    assert!(near(by_setting.force, (force(0.7 + 1e-5) - force(0.7 - 1e-5)) / 2e-5, 1.0), "{}", by_setting.force);
    // The derivatives with respect to motion and states equal those of the ordinary damper at this setting.
    let model = Model::new(&axis.params_at(&p, 0.7)).unwrap();
    let (wanted, got) =
        (partials(&model, &model.laid_out(&state), &input), at_once.partials(&state, &input, Some(0.7)).0);
    assert!(
        near(got.d_force_d_input[0], wanted.d_force_d_input[0], 1.0)
            && near(got.d_rate_d_state[1][1], wanted.d_rate_d_state[1][1], 1.0)
    );
    let (output, _) = evaluate(&model, &model.laid_out(&state), &input);
    assert!(near(output.force, force(0.7), 1.0));
}

/// A state of an ordinary damper can be used in a family and back. Each internal state stays with its element.
#[test]
fn a_state_of_the_ordinary_damper_is_one_of_the_family() {
    let mut p = params(&[]);
    p.enable(element!("gas_spring"), true);
    let (family, model) = (family(&p, &moved(&p)).unwrap(), Model::new(&p).unwrap());
    let mut state = model.steady_state(&Input::motion(0.01, 0.0));
    state.internal[0] *= 0.5;
    let own = family.laid_out(&state, Some(0.8));
    assert_eq!((own.internal[0], own.internal[1], own.internal[2]), (state.internal[0], 0.8, 0.0));
    let back = model.laid_out(&own);
    assert_eq!(back.internal[0], state.internal[0]);
    let mut output = Output::ZERO;
    assert!(family.step_in_place(
        &mut state,
        &mut Delay::default(),
        &Input::motion(0.01, 0.0),
        Some(0.8),
        1e-3,
        &mut output,
        true
    ));
    assert!((family.setting_of(&state, None) - 0.8).abs() < 1e-12);
}

#[test]
fn what_is_no_family_is_rejected_with_the_number_at_fault() {
    let p = params(&[]);
    let mut axis = Axis::NONE;
    for grid in
        [&[][..], &[1.0], &[1.0, 1.0], &[2.0, 1.0], &[0.0, f64::NAN], &[0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0]]
    {
        assert_eq!(axis.set_grid(grid).unwrap_err().reason, Reason::SettingGrid, "{grid:?}");
    }
    axis.set_grid(&[0.0, 1.0]).unwrap();
    let reason = |fault: Result<(), dashpot_core::Fault>| fault.unwrap_err().reason;
    assert_eq!(reason(axis.set_values(number!("gas_force"), &[1.0])), Reason::SettingCount);
    assert_eq!(reason(axis.set_values(number!("gas_force"), &[1.0, 1e9])), Reason::OutOfBounds);
    assert_eq!(reason(axis.set_values(number!("fv_form"), &[0.0, 1.0])), Reason::SettingFixed);
    assert_eq!(reason(axis.set_values(number!("substeps"), &[0.0, 1.0])), Reason::SettingFixed);
    assert_eq!(reason(axis.set_forces(2, &[0.0, 1.0])), Reason::SettingCount);
    assert_eq!(reason(axis.set_number(1, -1.0)), Reason::OutOfBounds);
    axis.set_forces(0, &[0.0, 1.0]).unwrap();
    assert_eq!(reason(axis.set_forces(1, &[0.0, 1.0, 2.0])), Reason::CurveLengths);
    assert_eq!(axis.check().unwrap_err(), list!("fv_force").fault(Reason::SettingCount));
    axis.set_forces(1, &[0.0, 1.0]).unwrap();
    // The FV table has different numbers of velocities and forces.
    assert_eq!(Family::check(&p, &axis).unwrap_err(), list!("fv_force").fault(Reason::CurveLengths));
    axis.set_grid(&[0.0, 1.0]).unwrap();
    let mut falling = forces(&p, 1.0);
    falling.reverse();
    axis.set_forces(0, &forces(&p, 0.0)).unwrap();
    axis.set_forces(1, &falling).unwrap();
    assert_eq!(Family::check(&p, &axis).unwrap_err(), list!("fv_force").fault(Reason::ForceDecreases));
    axis.set_grid(&[0.0, 1.0]).unwrap();
    axis.set_number(0, 1.5).unwrap();
    assert_eq!(Family::check(&p, &axis).unwrap_err().reason, Reason::OutOfBounds);
    axis.set_number(0, 0.5).unwrap();
    let mut bushing = p;
    bushing.enable(element!("bushing"), true);
    axis.set_values(number!("bushing_slow_stiffness"), &[0.0, 0.4]).unwrap();
    assert_eq!(
        Family::check(&bushing, &axis).unwrap_err(),
        number!("bushing_slow_stiffness").fault(Reason::SettingStates)
    );
    assert_eq!(Family::check(&p, &Axis::NONE).unwrap_err().reason, Reason::SettingGrid);
}

/// A family made from one damper per setting, for example by a fit, equals each damper at its setting.
#[test]
fn a_family_through_dampers_is_each_of_them_at_its_setting() {
    let grid = [0.0, 0.5, 1.6];
    let sets: Vec<Params> = [0.0, 0.4, 1.5]
        .into_iter()
        .map(|size| {
            let mut p = params(&[("gas_force", 80.0 + 10.0 * size), ("series_damping", 200.0)]);
            let f = forces(&p, size);
            p.set_list(list!("fv_force"), &f).unwrap();
            p
        })
        .collect();
    let (base, axis) = Axis::through(&grid, &sets).unwrap();
    assert_eq!(axis.numbers().len(), 1);
    for (setting, set) in grid.iter().zip(&sets) {
        assert_eq!(&axis.params_at(&base, *setting), set);
    }
    family(&base, &axis).unwrap();
    let mut other = sets.clone();
    other[1].enable(element!("bump_stop"), true);
    assert_eq!(Axis::through(&grid, &other).unwrap_err().reason, Reason::SettingFixed);
    let mut other = sets.clone();
    other[1].set_list(list!("fv_velocity"), &[-1.0, 1.0]).unwrap();
    assert_eq!(Axis::through(&grid, &other).unwrap_err(), list!("fv_velocity").fault(Reason::SettingFixed));
    assert_eq!(Axis::through(&grid, &sets[..2]).unwrap_err().reason, Reason::SettingCount);
}
