//! Tests of the elements in hosts whose displacement is not the integral of their velocity.
//!
//! Such hosts advance the displacement with the velocity at one end of the step. This is the new velocity
//! (semi-implicit: MuJoCo's Euler, game engines) or the old velocity. Every element must behave as in a host that
//! samples a motion.

use crate::common::*;
use dashpot_core::step::step;
use dashpot_core::{Input, Model, Params};
use std::f64::consts::TAU;

/// Velocity with which the host advances the displacement: that at the end of the step, or that at its start.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Advances {
    New,
    Old,
}

const HOSTS: [Advances; 2] = [Advances::New, Advances::Old];
const STEP: f64 = 1e-3;

/// Returns the forces, N, in a host that has the velocities of `motion` and advances the displacement itself.
fn in_host(model: &Model, motion: &impl Fn(f64) -> (f64, f64), host: Advances, steps: usize) -> Vec<f64> {
    let (mut x, mut v) = motion(0.0);
    let mut state = model.steady_state(&Input::motion(x, v));
    (1..=steps)
        .map(|i| {
            let old = v;
            v = motion(STEP * i as f64).1;
            x += STEP * if host == Advances::New { v } else { old };
            let (next, output) = step(model, &state, &Input::motion(x, v), STEP);
            state = next;
            output.force
        })
        .collect()
}

/// In both kinds of host, a moving mass of 2 kg acts as 2 kg. This mass is computed from the force component in phase
/// with the acceleration over whole cycles.
#[test]
fn two_kilograms_act_as_two_kilograms() {
    for (inside, time) in [(0.0, 2e-4), (1.0, 2e-4), (0.0, 1e-4), (0.0, 1e-3)] {
        let changes = [("moving_mass", 2.0), ("moving_mass_place", inside), ("moving_mass_time", time)];
        let model = only(&["moving_mass"], &changes);
        for frequency in [1.0, 5.0, 12.5, 20.0] {
            let w = TAU * frequency;
            let cycle = (1.0 / frequency / STEP).round() as usize;
            for host in HOSTS {
                let forces = in_host(&model, &sine(1.0 / w, frequency), host, 3 * cycle);
                let (mut along, mut square) = (0.0, 0.0);
                for (i, force) in forces.iter().enumerate().skip(cycle) {
                    let acceleration = w * (w * STEP * (i + 1) as f64).cos();
                    along += force * acceleration;
                    square += acceleration * acceleration;
                }
                let mass = along / square;
                assert!((mass - 2.0).abs() < 0.05, "{frequency} Hz, {time} s, {host:?}: {mass} kg");
            }
        }
    }
}

/// At a constant acceleration, the force of a moving mass equals mass times acceleration from the sixth step on.
#[test]
fn a_constant_acceleration_gives_the_mass_to_the_slack() {
    let model = only(&["moving_mass"], &[]);
    for host in HOSTS {
        for force in in_host(&model, &|t| (5.0 * t * t, 10.0 * t), host, 40).iter().skip(5) {
            assert!((force - 20.0).abs() < 0.25, "{host:?}: {force} N");
        }
    }
}

/// Returns named parameter sets with all elements and forms, alone and together.
fn cases() -> Vec<(String, Params)> {
    let mut all: Vec<(String, Params)> = paths().into_iter().map(|(name, p)| (name.to_owned(), p)).collect();
    for name in dashpot_core::parameter::names() {
        let mut p =
            params(&[("gas_thermal_time", 0.05), ("bump_stop_clearance", 0.004), ("rebound_stop_clearance", 0.004)]);
        p.enable(dashpot_core::parameter::Element::find(name).unwrap(), true);
        if Model::new(&p).is_ok() {
            all.push((name.to_owned(), p));
        }
    }
    all
}

/// Tolerance of the forces, relative to the largest force, for all elements except the valve with mass (spool) without
/// series compliance.
///
/// The spool has the tolerance `SPOOL_WITHIN`, because it responds immediately to the mean velocity of the
/// displacement. A lag of half a step changes its opening and thus the peak of the force.
const WITHIN: f64 = 0.03;
const SPOOL_WITHIN: f64 = 0.2;

/// In both kinds of host, the force lies within the extremes of the exact force in a window around the end of the step.
/// The window begins one and a half steps before that time and ends one and a half steps after it.
///
/// The displacement in the host leads or lags by half a step, so the force may also lead or lag.
#[test]
fn every_element_is_no_more_than_a_step_early_or_late() {
    const FINER: usize = 50;
    const STEPS: usize = 240;
    let mut worst: Vec<(f64, String)> = Vec::new();
    for (name, params) in cases() {
        let model = Model::new(&params).unwrap();
        for (amplitude, frequency) in [(0.006, 12.0), (0.01, 3.0), (0.001, 25.0)] {
            let motion = sine(amplitude, frequency);
            let exact = step_forces(&model, &motion, STEP / FINER as f64, (STEPS + 3) * FINER, false);
            let top = exact.iter().fold(0.0f64, |m, f| m.max(f.abs()));
            for host in HOSTS {
                let mut most = 0.0f64;
                for (i, force) in in_host(&model, &motion, host, STEPS).into_iter().enumerate().skip(20) {
                    let at = (i + 1) * FINER - 1;
                    let band = &exact[at - 3 * FINER / 2..=at + 3 * FINER / 2];
                    let (low, high) = band.iter().fold((f64::MAX, f64::MIN), |(l, h), f| (l.min(*f), h.max(*f)));
                    most = most.max((low - force).max(force - high) / top);
                }
                worst.push((most, format!("{name}, {amplitude} m at {frequency} Hz, {host:?}")));
            }
        }
    }
    assert!(worst.len() > 300);
    for (most, what) in worst {
        let within = if what.starts_with("valve with mass alone") { SPOOL_WITHIN } else { WITHIN };
        assert!(most < within, "{most} {what}");
    }
}
