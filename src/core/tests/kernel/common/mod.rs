//! Shared code of the property tests: motions, an independent reference and random models.
#![allow(dead_code)]

pub mod energy;

use dashpot_core::parameter::names;
use dashpot_core::parameter::{Element, Number, Shape, table};
use dashpot_core::step::{Method, step};
use dashpot_core::{Input, Model, Output, Params, State, evaluate};
use dashpot_core::{element, list};
use proptest::prelude::*;
use std::f64::consts::TAU;

pub const METHODS: [Method; 5] = [Method::Euler, Method::Second, Method::Fourth, Method::Third, Method::ThreeStage];

/// The elements that have internal states, in all or some of their forms.
pub const WITH_STATES: [&str; 11] = [
    "lagged_polynomial",
    "presliding_friction",
    "gas_spring",
    "moving_mass",
    "bushing",
    "oil_compressibility",
    "aeration",
    "cavitation",
    "temperature_fade",
    "frequency_selective_damping",
    "valve_hysteresis",
];

/// All elements of the hydraulic path.
pub const HYDRAULICS: [&str; 7] = [
    "oil_compressibility",
    "aeration",
    "cavitation",
    "position_dependent_damping",
    "temperature_fade",
    "frequency_selective_damping",
    "valve_hysteresis",
];

/// Returns named parameter sets with every element of the series and the hydraulic path, alone and together.
pub fn paths() -> Vec<(&'static str, Params)> {
    let of = |on: &[&str], changes: &[(&str, f64)]| {
        let mut p = params(changes);
        for element in on {
            p.enable(Element::find(element).unwrap(), true);
        }
        p
    };
    let without_series = |mut p: Params| {
        p.enable(element!("series_compliance"), false);
        p
    };
    let capped = [("cavitation_force", 900.0)];
    let gassy = [("cavitation_force", 900.0), ("cavitation_onset", 0.6), ("cavitation_expansion", 5e-4)];
    let heats = [("fade_source", 1.0), ("heat_capacity", 300.0)];
    let stroke = [("fsd_form", 1.0)];
    let groove = [("bypass_form", 1.0), ("bypass_half_width", 0.01)];
    let passage = [("fsd_form", 2.0)];
    let foot = [("cavitation_form", 1.0), ("cavitation_side", 1.0), ("cavitation_velocity", 0.1)];
    let play = [("valve_form", 1.0), ("valve_play", 150.0)];
    let spool = [("valve_form", 2.0), ("valve_damping", 0.5)];
    vec![
        ("free play", of(&["free_play"], &[])),
        ("free play under a load", of(&["free_play"], &[("free_play_load", 60.0)])),
        ("bushing", of(&["bushing"], &[("bushing_hardening", 5e-4)])),
        ("bushing with friction", of(&["bushing"], &[("bushing_slip", 1e-4), ("bushing_loss_time", 1e3)])),
        (
            "bushing with a stop",
            of(
                &["bushing"],
                &[
                    ("series_stiffness", 5e5),
                    ("bushing_stop", 7e-4),
                    ("bushing_stop_stiffness", 3.0),
                    ("bushing_slow_stiffness", 0.4),
                    ("bushing_slow_time", 0.1),
                ],
            ),
        ),
        ("both in series", of(&["free_play", "bushing"], &[])),
        ("an eye with play", of(&["free_play"], &[("series_load", 1.0)])),
        (
            "a mount before the oil",
            of(&["bushing", "oil_compressibility"], &[("series_load", 1.0), ("oil_stiffness", 2e6)]),
        ),
        ("the whole behind the series spring", of(&["coulomb_friction"], &[("series_load", 1.0)])),
        (
            "contacts and gas behind the series spring",
            of(&["presliding_friction", "gas_spring"], &[("series_load", 1.0), ("gas_stiffness", 5e3)]),
        ),
        (
            "contacts behind a mount",
            of(
                &["presliding_friction", "bushing"],
                &[("series_load", 1.0), ("presliding_power", 2.0), ("presliding_return", 1.0)],
            ),
        ),
        ("oil", of(&["oil_compressibility"], &[])),
        ("softer oil in compression", of(&["oil_compressibility"], &[("oil_compression", 0.3)])),
        ("oil alone", without_series(of(&["oil_compressibility"], &[]))),
        ("aeration", of(&["aeration"], &[])),
        ("less air in compression", of(&["aeration"], &[("aeration_compression", 0.4)])),
        ("oil and air alone", without_series(of(&["oil_compressibility", "aeration"], &[]))),
        ("cavitation", of(&["cavitation"], &capped)),
        ("cavitation alone", without_series(of(&["cavitation"], &capped))),
        (
            "cavitation in rebound, gas pushes",
            of(&["cavitation"], &[("cavitation_side", 1.0), ("cavitation_return", 1.0)]),
        ),
        ("cavitation with oil", of(&["cavitation", "oil_compressibility"], &capped)),
        ("void with gas", of(&["cavitation"], &gassy)),
        ("void with gas alone", without_series(of(&["cavitation"], &gassy))),
        ("void with gas and oil", of(&["cavitation", "oil_compressibility"], &gassy)),
        ("position", of(&["position_dependent_damping"], &[("bypass_half_width", 0.01)])),
        (
            "position, firmer in rebound",
            of(&["position_dependent_damping"], &[("bypass_share", -1.0), ("bypass_strokes", 1.0)]),
        ),
        ("fade", of(&["temperature_fade"], &[("fade_reference", 60.0)])),
        (
            "fade of the laminar part",
            of(&["temperature_fade"], &[("fade_reference", 60.0), ("fade_laminar_force", 800.0)]),
        ),
        ("self-heating", of(&["temperature_fade"], &heats)),
        ("fade by Vogel", of(&["temperature_fade"], &[("fade_reference", 60.0), ("fade_slackening", 6e-3)])),
        ("filter", of(&["frequency_selective_damping"], &[])),
        ("stroke", of(&["frequency_selective_damping"], &stroke)),
        ("stroke alone", without_series(of(&["frequency_selective_damping"], &stroke))),
        ("valve", of(&["valve_hysteresis"], &[])),
        ("valve, time alone", of(&["valve_hysteresis"], &[("valve_closing_ratio", 1.0), ("valve_time", 5e-3)])),
        ("groove", of(&["position_dependent_damping"], &groove)),
        ("groove alone", without_series(of(&["position_dependent_damping"], &groove))),
        ("passage", of(&["frequency_selective_damping"], &passage)),
        ("passage alone", without_series(of(&["frequency_selective_damping"], &passage))),
        ("shortening oil", of(&["oil_compressibility"], &[("oil_shortening", 8.0)])),
        (
            "two shortening chambers with air",
            without_series(of(&["oil_compressibility", "aeration"], &[("oil_shortening", 8.0), ("oil_chambers", 1.0)])),
        ),
        ("foot valve", of(&["cavitation"], &foot)),
        ("foot valve with oil", of(&["cavitation", "oil_compressibility"], &foot)),
        ("valve with play", of(&["valve_hysteresis"], &play)),
        ("valve with mass", of(&["valve_hysteresis"], &spool)),
        ("valve with mass alone", without_series(of(&["valve_hysteresis"], &spool))),
        ("valve with mass and oil", of(&["valve_hysteresis", "oil_compressibility"], &spool)),
        (
            "flows past",
            of(
                &HYDRAULICS,
                &[groove.as_slice(), &passage, &foot, &play, &[("fade_source", 1.0), ("oil_shortening", 5.0)]].concat(),
            ),
        ),
        ("hydraulics", of(&HYDRAULICS, &[("fade_source", 1.0), ("cavitation_force", 900.0), ("fsd_form", 1.0)])),
        (
            "paths and memory",
            of(
                &[
                    "free_play",
                    "bushing",
                    "oil_compressibility",
                    "cavitation",
                    "frequency_selective_damping",
                    "valve_hysteresis",
                    "presliding_friction",
                    "gas_spring",
                    "moving_mass",
                    "bump_stop",
                ],
                &[("bump_stop_clearance", 0.005)],
            ),
        ),
    ]
}

/// Makes the default model with some parameters changed.
pub fn model(changes: &[(&str, f64)]) -> Model {
    Model::new(&params(changes)).unwrap()
}

pub fn params(changes: &[(&str, f64)]) -> Params {
    let mut params = Params::new();
    for (name, value) in changes {
        params.set(Number::find(name).unwrap(), *value).unwrap();
    }
    params
}

/// Makes a sine motion that starts at rest at its lower end. It returns displacement, m, and velocity, m/s, at a time,
/// s; the frequency is in Hz.
pub fn sine(amplitude: f64, frequency: f64) -> impl Fn(f64) -> (f64, f64) {
    let w = TAU * frequency;
    move |t| (-amplitude * (w * t).cos(), amplitude * w * (w * t).sin())
}

/// Computes the forces, N, of steps of length `dt`, s, at the end of each step.
pub fn step_forces(
    model: &Model,
    motion: &impl Fn(f64) -> (f64, f64),
    dt: f64,
    steps: usize,
    velocity_only: bool,
) -> Vec<f64> {
    let (x, v) = motion(0.0);
    let mut state = model.steady_state(&Input::motion(x, v));
    (1..=steps)
        .map(|i| {
            let (x, v) = motion(i as f64 * dt);
            let input = if velocity_only { Input::velocity(v) } else { Input::motion(x, v) };
            let (next, output) = step(model, &state, &input, dt);
            state = next;
            output.force
        })
        .collect()
}

/// Computes reference forces, N, by the classical explicit Runge–Kutta method on the continuous equations, with `parts`
/// steps in each `dt`, s.
///
/// The reference shares only the right-hand side of the equations with [`step`], and uses the exact motion.
pub fn reference_forces(
    model: &Model,
    motion: &impl Fn(f64) -> (f64, f64),
    dt: f64,
    steps: usize,
    parts: usize,
) -> Vec<f64> {
    let input = |t: f64| {
        let (x, v) = motion(t);
        Input::motion(x, v)
    };
    let mut state = model.steady_state(&input(0.0));
    let h = dt / parts as f64;
    let moved = |state: &State, rate: &State, h: f64| {
        let mut to = *state;
        to.mass_displacement += h * rate.mass_displacement;
        to.mass_velocity += h * rate.mass_velocity;
        for (z, r) in to.internal.iter_mut().zip(&rate.internal) {
            *z += h * r;
        }
        to
    };
    (1..=steps)
        .map(|i| {
            for j in 0..parts {
                let t = ((i - 1) * parts + j) as f64 * h;
                let rate = |state: &State, t: f64| evaluate(model, state, &input(t)).1;
                let k1 = rate(&state, t);
                let k2 = rate(&moved(&state, &k1, 0.5 * h), t + 0.5 * h);
                let k3 = rate(&moved(&state, &k2, 0.5 * h), t + 0.5 * h);
                let k4 = rate(&moved(&state, &k3, h), t + h);
                for (k, share) in [(k1, 1.0 / 6.0), (k2, 1.0 / 3.0), (k3, 1.0 / 3.0), (k4, 1.0 / 6.0)] {
                    state = moved(&state, &k, share * h);
                }
            }
            evaluate(model, &state, &input(i as f64 * dt)).0.force
        })
        .collect()
}

/// Returns the root mean square and the largest of the differences between `forces` and `exact`, relative to the
/// largest exact force.
pub fn errors(forces: &[f64], exact: &[f64]) -> (f64, f64) {
    let top = exact.iter().fold(0.0f64, |m, f| m.max(f.abs()));
    let square: f64 = forces.iter().zip(exact).map(|(f, e)| (f - e) * (f - e)).sum();
    let largest = forces.iter().zip(exact).fold(0.0f64, |m, (f, e)| m.max((f - e).abs()));
    ((square / exact.len() as f64).sqrt() / top, largest / top)
}

/// Makes a model in which only these elements are on.
pub fn only(elements: &[&str], changes: &[(&str, f64)]) -> Model {
    let mut p = params(changes);
    p.disable_all();
    for element in elements {
        p.enable(Element::find(element).unwrap(), true);
    }
    Model::new(&p).unwrap()
}

/// Makes the default model with these elements on in addition.
pub fn with(elements: &[&str], changes: &[(&str, f64)]) -> Model {
    let mut p = params(changes);
    for element in elements {
        p.enable(Element::find(element).unwrap(), true);
    }
    Model::new(&p).unwrap()
}

/// Draws a random parameter set that the parameter table and the elements allow.
///
/// The logarithm of each number is uniform between the bounds of a car damper. If the lower bound is not positive, it
/// is replaced by a billionth of the upper bound. One number in twenty is its lower bound. The curves, the choices, the
/// elements that are on and the integration are also random.
pub fn any_params() -> impl Strategy<Value = Params> {
    let shares = prop::collection::vec(0.0..1.0f64, table().count());
    let points = prop::collection::vec((1e-4..1.0f64, 0.0..1.0f64), 2..20);
    let soft = prop::collection::vec((0.2..1.0f64, 0.0..1.0f64), 2..20);
    let on = prop::collection::vec(any::<bool>(), names().count());
    (shares, points, soft, on, any::<bool>(), any::<bool>()).prop_filter_map(
        "the elements refuse the set",
        |(shares, fv, spring, on, lookup, steep)| {
            let mut params = Params::new();
            for (row, share) in table().zip(&shares) {
                let p = row.parameter;
                match p.shape {
                    Shape::Choice(words) => {
                        params.set(Number::find(p.name).unwrap(), (share * words.len() as f64).floor()).ok()?
                    }
                    Shape::Scalar if p.name == "substeps" => {
                        params.set(Number::find(p.name).unwrap(), (share * 8.0).floor()).ok()?
                    }
                    Shape::Scalar => {
                        // Only values within the bounds of a car damper are drawn. The test `sizes` shows that dampers
                        // of other sizes behave in proportion.
                        let (least, most) = p.of_a_car;
                        let low = if least > 0.0 { least } else { 1e-9 * most };
                        let by_decade = low * (most / low).powf(*share);
                        let ends = if *share < 0.05 { least } else { by_decade };
                        params.set(Number::find(p.name).unwrap(), ends.clamp(least, most)).ok()?;
                    }
                    Shape::List(_) => {}
                }
            }
            let rising = |points: &[(f64, f64)], width: f64, height: f64| -> (Vec<f64>, Vec<f64>) {
                let (mut x, mut f) = (vec![0.0], vec![0.0]);
                for (dx, df) in points {
                    x.push(x.last().unwrap() + dx);
                    f.push(f.last().unwrap() + df * df * df);
                }
                let (xs, fs) = (*x.last().unwrap(), f.last().unwrap().max(1e-9));
                (
                    x.iter().map(|x| (2.0 * x / xs - 1.0) * width).collect(),
                    f.iter().map(|f| (2.0 * f / fs - 1.0) * height).collect(),
                )
            };
            let (u, f) = rising(&fv, if steep { 0.05 } else { 3.0 }, 2e4);
            params.set_list(list!("fv_velocity"), &u).ok()?;
            params.set_list(list!("fv_force"), &f).ok()?;
            if lookup {
                let (x, f) = rising(&spring, 0.2, 1e3);
                params.set_list(list!("spring_displacement"), &x).ok()?;
                params.set_list(list!("spring_force"), &f).ok()?;
            }
            for (name, on) in names().zip(&on) {
                params.enable(Element::find(name).unwrap(), *on);
            }
            Model::new(&params).ok().map(|_| params)
        },
    )
}

/// Formats the parameters of the elements that are on, for the message of a failure.
pub fn describe(params: &Params) -> String {
    let mut text = String::new();
    for row in table() {
        let group = dashpot_core::parameter::GROUPS[row.group].name;
        if Element::find(group).map_or(true, |element| params.is_on(element)) {
            text += &format!("{} {:?}; ", row.parameter.name, params.get(&row));
        }
    }
    text
}

/// Simulates a motion with steps of length `dt`, s, from the steady state at its start. Returns displacement, velocity and
/// output at each step.
pub fn run(model: &Model, motion: &impl Fn(f64) -> (f64, f64), dt: f64, steps: usize) -> Vec<(f64, f64, Output)> {
    let (x, v) = motion(0.0);
    let mut state = model.steady_state(&Input::motion(x, v));
    (1..=steps)
        .map(|i| {
            let (x, v) = motion(i as f64 * dt);
            let (next, output) = step(model, &state, &Input::motion(x, v), dt);
            state = next;
            (x, v, output)
        })
        .collect()
}
