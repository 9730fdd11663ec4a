//! Tests of the parallel elements with internal states, and of the stops.

use crate::common::*;
use dashpot_core::step::{Integration, step};
use dashpot_core::{Input, Model, Reason, State, evaluate};
use std::f64::consts::TAU;

/// Returns displacement, m, and force, N, at each step of length `dt`, s, from the steady state at the start of the
/// motion.
fn run(model: &Model, motion: &impl Fn(f64) -> (f64, f64), dt: f64, steps: usize) -> Vec<(f64, f64)> {
    crate::common::run(model, motion, dt, steps).into_iter().map(|(x, _, output)| (x, output.force)).collect()
}

/// Computes the work, J, done on the damper over the last of `cycles` cycles of a sine.
fn loop_area(model: &Model, amplitude: f64, frequency: f64, cycles: usize) -> f64 {
    let n = 2000;
    let points = run(model, &sine(amplitude, frequency), 1.0 / frequency / n as f64, cycles * n);
    let last = &points[((cycles - 1) * n).saturating_sub(1)..];
    last.windows(2).map(|p| 0.5 * (p[0].1 + p[1].1) * (p[1].0 - p[0].0)).sum()
}

#[test]
fn presliding_does_not_know_the_speed() {
    let model = only(&["presliding_friction"], &[("presliding_force", 50.0), ("presliding_length", 2e-4)]);
    for amplitude in [1e-4, 3e-4, 5e-3] {
        let n = 2000;
        let of = |frequency: f64| run(&model, &sine(amplitude, frequency), 1.0 / frequency / n as f64, 2 * n);
        let (slow, fast) = (of(0.1), of(10.0));
        for ((x, a), (_, b)) in slow.iter().zip(&fast) {
            assert!((a - b).abs() < 1e-3 * 50.0, "at {x}: {a} {b}");
        }
    }
}

#[test]
fn presliding_turns_over_as_the_exponential_of_travel() {
    let (level, length) = (50.0, 2e-4);
    let model = only(&["presliding_friction"], &[("presliding_force", level), ("presliding_length", length)]);
    // At constant speed from the undeflected contact, F = F_c (1 − exp(−x/z_0)) at any step, with the level F_c and the
    // length z_0.
    for (v, dt) in [(0.001, 1e-3), (0.05, 1e-3), (0.05, 1e-4)] {
        let mut state = State { velocity: v, ..State::ZERO };
        for i in 1..=50 {
            let x = v * dt * i as f64;
            let (next, output) = step(&model, &state, &Input::motion(x, v), dt);
            state = next;
            let exact = level * (1.0 - (-x / length).exp());
            assert!((output.force - exact).abs() < 2e-3 * level, "at {x}: {} for {exact}", output.force);
            assert_eq!(output.friction_force, output.force);
        }
    }
}

#[test]
fn gas_is_soft_when_slow_and_stiff_when_fast() {
    let (k, length, index, time) = (500.0, 0.4, 1.4, 3.0);
    let model = only(
        &["gas_spring"],
        &[("gas_stiffness", k), ("gas_length", length), ("gas_adiabatic_index", index), ("gas_thermal_time", time)],
    );
    // In slow motion the pressure p times the volume V is constant, in fast motion p V^γ with the adiabatic index γ.
    for (frequency, e) in [(1e-4, 1.0), (30.0, index)] {
        let points = run(&model, &sine(0.05, frequency), 1.0 / frequency / 400.0, 400);
        let cold = (1.0 - 0.05 / length).powf(e - 1.0);
        for (x, force) in points {
            let ratio = 1.0 + x / length;
            let pressure = if e == 1.0 { 1.0 / ratio } else { cold * ratio.powf(-e) };
            let exact = k * length * (1.0 - pressure);
            // One fast cycle lasts a hundredth of the thermal time, so the gas is not exactly adiabatic, and the
            // tolerance is 1.5 %.
            assert!((force - exact).abs() < 0.015 * k * 0.05, "{frequency} Hz at {x}: {force} for {exact}");
        }
    }
    // Between these frequencies, heat through the wall dissipates energy, most where the angular frequency is one over
    // the thermal time.
    let area = |f: f64| loop_area(&model, 0.05, f, 4);
    let (slow, middle, fast) = (area(1e-3), area(1.0 / (TAU * time)), area(30.0));
    assert!(slow > 0.0 && middle > 3.0 * slow && middle > 3.0 * fast.abs(), "{slow} {middle} {fast}");
    // A step of zero length returns the equilibrium force, which is the isothermal force of the gas.
    let held = step(&model, &State::ZERO, &Input::motion(0.05, 0.0), 0.0).1;
    assert!((held.gas_force - k * length * (1.0 - 1.0 / (1.0 + 0.05 / length))).abs() < 1e-9);
}

#[test]
fn a_gas_spring_pressed_beyond_its_volume_stays_finite_and_rises() {
    let model = only(&["gas_spring"], &[("gas_length", 0.05), ("gas_stiffness", 1e6)]);
    let mut last = f64::MIN;
    for i in -400..=400 {
        let force = evaluate(&model, &State::ZERO, &Input::motion(i as f64 * 1e-3, 0.0)).0.force;
        assert!(force.is_finite() && force > last);
        last = force;
    }
}

/// The root mean square error of the force of a mass of 5 kg is below 6 % of the largest inertia force.
///
/// The motion goes up to 30 Hz, with host steps of 0.25 to 2 ms.
#[test]
fn moving_mass_is_a_mass() {
    let mass = 5.0;
    let model = only(&["moving_mass"], &[("moving_mass", mass)]);
    for frequency in [1.0, 5.0, 12.0, 20.0, 30.0] {
        let w = TAU * frequency;
        let amplitude = 1.0 / w;
        for dt in [0.25e-3, 0.5e-3, 1e-3, 2e-3] {
            let steps = (3.0 / frequency / dt) as usize;
            let forces = run(&model, &sine(amplitude, frequency), dt, steps);
            let skip = steps / 3;
            let (mut square, mut n) = (0.0, 0.0);
            for (i, (_, force)) in forces.iter().enumerate().skip(skip) {
                let exact = mass * w * (w * (i + 1) as f64 * dt).cos();
                square += (force - exact) * (force - exact);
                n += 1.0;
            }
            let off = (square / n).sqrt() / (mass * w);
            assert!(off < 0.06, "{frequency} Hz, {dt} s: {off}");
        }
    }
}

#[test]
fn a_mass_inside_is_internal_mass() {
    let own = [("internal_mass", 0.3), ("series_stiffness", 8e5)];
    let more = [("internal_mass", 2.3), ("series_stiffness", 8e5)];
    let inside = [own[0], own[1], ("moving_mass", 2.0), ("moving_mass_place", 1.0)];
    let (a, b) = (
        only(&["fv_curve", "series_compliance", "moving_mass"], &inside),
        only(&["fv_curve", "series_compliance"], &more),
    );
    for ((_, a), (_, b)) in run(&a, &sine(5e-3, 20.0), 5e-4, 200).iter().zip(&run(&b, &sine(5e-3, 20.0), 5e-4, 200)) {
        assert!((a - b).abs() < 1e-9 * b.abs().max(1.0), "{a} {b}");
    }
    // Without a series stiffness the piston moves with the moving end. A mass inside the damper then acts as a mass at
    // the moving end.
    let (a, b) = (
        only(&["moving_mass"], &[("moving_mass", 2.0), ("moving_mass_place", 1.0)]),
        only(&["moving_mass"], &[("moving_mass", 2.0)]),
    );
    assert_eq!(run(&a, &sine(5e-3, 20.0), 5e-4, 50), run(&b, &sine(5e-3, 20.0), 5e-4, 50));
}

#[test]
fn moving_mass_takes_no_energy_but_to_heat() {
    let model = only(&["moving_mass"], &[("moving_mass", 5.0), ("moving_mass_time", 1e-3)]);
    for frequency in [1.0, 10.0, 100.0] {
        assert!(loop_area(&model, 0.5 / frequency / TAU, frequency, 2) > 0.0);
    }
}

#[test]
fn a_contact_of_high_power_bends_before_it_slips() {
    let (level, length) = (50.0, 2e-4);
    let changes = [("presliding_force", level), ("presliding_length", length)];
    let dahl = only(&["presliding_friction"], &changes);
    let elastic = only(&["presliding_friction"], &[changes[0], changes[1], ("presliding_power", 8.0)]);
    let at = |model: &Model, travel: f64| {
        let (v, n) = (0.01, 400);
        let dt = travel / v / f64::from(n);
        let mut state = State { velocity: v, ..State::ZERO };
        let mut force = 0.0;
        for i in 1..=n {
            let (next, output) = step(model, &state, &Input::motion(v * dt * f64::from(i), v), dt);
            (state, force) = (next, output.force);
        }
        force
    };
    // A creeping contact has less friction at low speed, even after a long motion.
    let creeping = only(&["presliding_friction"], &[changes[0], changes[1], ("presliding_creep", 1e-3)]);
    for v in [3e-4, 1e-3, 0.1] {
        let settled = creeping.steady_state(&Input::motion(0.0, v));
        let (moved, output) = step(&creeping, &settled, &Input::motion(1e-3 * v, v), 1e-3);
        assert!((output.force / (level * v / (v * v + 1e-6f64).sqrt()) - 1.0).abs() < 1e-6, "{v}: {}", output.force);
        assert!((moved.internal[0] / settled.internal[0] - 1.0).abs() < 1e-9);
    }
    // After sliding, the force of Dahl's contact decreases over the displacement twice as fast as it increased from
    // zero. With an elastic return, both rates are equal.
    for (back, derivative) in [(0.0, 2.0), (1.0, 1.0)] {
        let model = only(&["presliding_friction"], &[changes[0], changes[1], ("presliding_return", back)]);
        let v = -0.01;
        let slid = State {
            velocity: v,
            internal: {
                let mut m = State::ZERO.internal;
                m[0] = length;
                m
            },
            ..State::ZERO
        };
        let travel = 0.02 * length;
        let dt = travel / -v;
        let force = step(&model, &slid, &Input::motion(-travel, v), dt).1.force;
        assert!(((level - force) / (level * 0.02) / derivative - 1.0).abs() < 0.03, "{back}: {force}");
    }
    // At half of `presliding_length`, the contact with n = 8 still acts as a spring; at twice that length it slides.
    assert!((at(&elastic, 0.5 * length) / (0.5 * level) - 1.0).abs() < 2e-3);
    assert!((at(&dahl, 0.5 * length) / (level * (1.0 - (-0.5f64).exp())) - 1.0).abs() < 2e-3);
    assert!((at(&elastic, 2.0 * length) / level - 1.0).abs() < 1e-2);
}

#[test]
fn a_stop_of_oil_is_felt_on_the_way_in_alone_by_speed_or_its_square() {
    let of = |flow: f64| {
        only(
            &["rebound_stop"],
            &[
                ("rebound_stop_clearance", 0.03),
                ("rebound_stop_stiffness", 0.0),
                ("rebound_stop_progression", 0.01),
                ("rebound_stop_damping", 3e3),
                ("rebound_stop_flow", flow),
            ],
        )
    };
    let force = |model: &Model, x: f64, v: f64| evaluate(model, &State::ZERO, &Input::motion(x, v)).0.force;
    for (flow, power) in [(0.0, 1), (1.0, 2)] {
        let model = of(flow);
        let (slow, fast) = (force(&model, 0.04, 0.5), force(&model, 0.04, 1.0));
        assert!((fast / slow - 2f64.powi(power)).abs() < 0.06, "{flow}: {slow} {fast}");
        // The damping is the force at the depth of the progression, 0.01 m, and 1 m/s. The contact is soft over half a
        // millimeter, so the force is a little smaller.
        assert!((fast / 3e3 - 1.0).abs() < 0.1, "{flow}: {fast}");
        assert_eq!(force(&model, 0.04, -1.0), 0.0);
        assert_eq!(force(&model, 0.029, 1.0), 0.0);
    }
}

#[test]
fn stops_act_beyond_their_clearance_alone_and_to_one_side() {
    for (element, sign) in [("bump_stop", -1.0), ("rebound_stop", 1.0)] {
        let name = |p: &str| format!("{element}_{p}");
        let changes = [
            (name("clearance"), 0.03),
            (name("stiffness"), 4e4),
            (name("progression"), 0.02),
            (name("loss"), 0.2),
            (name("damping"), 3e3),
        ];
        let changes: Vec<_> = changes.iter().map(|(n, v)| (n.as_str(), *v)).collect();
        let model = only(&[element], &changes);
        let at = |x: f64, v: f64| evaluate(&model, &State::ZERO, &Input::motion(sign * x, sign * v)).0;
        let force = |x: f64, v: f64| sign * at(x, v).force;
        for v in [-1.0, 0.0, 1.0] {
            assert_eq!(force(0.03, v), 0.0);
            assert_eq!(force(-0.1, v), 0.0);
            assert_eq!(at(0.05, v).force, at(0.05, v).stop_force);
        }
        // The force at standstill is that of the stiffening spring, reduced by the soft onset of the contact.
        let static_force = |d: f64| 4e4 * d * (1.0 + d / 0.02);
        let d = 0.02;
        let soft = d * d / (d + 5e-4);
        assert!((force(0.03 + d, 0.0) - static_force(soft)).abs() < 1e-6);
        assert!((force(0.03 + d, 0.0) / static_force(d) - 1.0).abs() < 0.04);
        // The loss of the spring acts in both directions, the oil only on the way into the stop.
        assert!((force(0.05, -1.0) / force(0.05, 0.0) - 0.8).abs() < 1e-9);
        assert!(force(0.05, 1.0) > 1.2 * force(0.05, 0.0) + 0.9 * 3e3);
        let mut last = 0.0;
        for i in 0..500 {
            let now = force(0.03 + i as f64 * 1e-4, 0.1);
            assert!(now >= last);
            last = now;
        }
        // The derivatives are continuous at the contact and at standstill.
        for (x, v, dx, dv) in [(0.03, 0.5, 1e-9, 0.0), (0.05, 0.0, 0.0, 1e-9)] {
            let (a, b) = (at(x - dx, v - dv), at(x + dx, v + dv));
            assert!((a.d_force_d_displacement - b.d_force_d_displacement).abs() < 1.0, "{element} {x}");
            assert!((a.d_force_d_velocity - b.d_force_d_velocity).abs() < 1e-2, "{element} {x}");
        }
        let area = loop_area(&model, 0.06, 1.0, 1);
        assert!(area > 0.0);
    }
}

/// The internal states have consecutive indices from 0, in the order of the element list.
#[test]
fn states_are_compact() {
    let model = only(&["moving_mass", "presliding_friction"], &[]);
    let settled = model.steady_state(&Input::motion(0.0, 0.3));
    assert_eq!(model.elements().memories(), 2);
    assert_eq!(settled.internal[..3], [3e-4, 0.3, 0.0]);
    assert!(!Reason::TooManyStates.text().is_empty());
}

/// Steps of 1 ms agree with a finer explicit solution, for each parallel element with the default damper.
#[test]
fn a_millisecond_step_is_within_a_thousandth_with_each_element() {
    for (elements, changes) in [
        (&["presliding_friction"][..], &[("presliding_force", 100.0)][..]),
        (&["gas_spring"], &[("gas_stiffness", 3e3)]),
        (&["moving_mass"], &[("moving_mass", 5.0), ("moving_mass_time", 1e-3)]),
        (&["bump_stop", "rebound_stop"], &[("bump_stop_clearance", 0.004), ("rebound_stop_clearance", 0.004)]),
    ] {
        let model = with(elements, changes);
        for (amplitude, peak) in [(0.05, 1.571), (0.01, 1.571), (0.002, 0.2618), (0.002, 0.052)] {
            let motion = sine(amplitude, peak / (TAU * amplitude));
            let exact = reference_forces(&model, &motion, 1e-3, 120, 500);
            let (rms, largest) = errors(&step_forces(&model, &motion, 1e-3, 120, false), &exact);
            assert!(rms <= 1e-3 && largest <= 1e-2, "{elements:?} {amplitude} {peak}: {rms:.2e} {largest:.2e}");
        }
    }
}

/// With each parallel element, the step converges with the order of the method, or with the lower order in the table
/// `orders`.
///
/// The presliding law has a kink of |v| at every reversal, so the motion of this test has no reversal.
#[test]
fn order_of_the_step_with_each_element() {
    for (elements, changes, orders) in [
        (&["gas_spring"][..], &[("gas_stiffness", 3e3), ("gas_thermal_time", 0.05)][..], [0.9, 1.9, 3.5, 2.8, 1.8]),
        // The order is 2 where the limit of the velocity's curvature, which lags by `moving_mass_time`, has the
        // opposite sign of the curvature.
        (&["moving_mass"], &[("moving_mass_time", 1e-2)], [0.9, 1.9, 1.9, 1.9, 1.8]),
        (&["presliding_friction"], &[("presliding_length", 5e-3)], [0.9, 1.9, 3.0, 2.8, 1.8]),
    ] {
        let model = only(elements, changes);
        // The motion has no reversal.
        let motion = |t: f64| (0.3 * t + 0.01 * (20.0 * t).sin(), 0.3 + 0.2 * (20.0 * t).cos());
        let exact = reference_forces(&model, &motion, 8e-3, 30, 2000);
        for (method, order) in METHODS.into_iter().zip(orders) {
            let model = model.with_integration(Integration::fixed(method, 1));
            let error = |finer: usize| {
                let forces = step_forces(&model, &motion, 8e-3 / finer as f64, 30 * finer, false);
                let forces: Vec<f64> = forces.into_iter().skip(finer - 1).step_by(finer).collect();
                errors(&forces, &exact).0
            };
            let (coarse, fine) = (error(1), error(2));
            let derivative = (coarse / fine).log2();
            // The order is at most 4, because the kernel's motion inside each step is a cubic.
            assert!(derivative > order || fine < 1e-9, "{elements:?} {method:?}: {coarse:.2e} {fine:.2e} {derivative}");
        }
    }
}
