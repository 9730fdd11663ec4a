//! Tests of the damper inside a solver: a stand-in for Adams loads the shipped library, and the forces are compared
//! with those of the kernel.

use dashpot_core::{Input, Model, Params, State, evaluate::evaluate, model_file};
use dashpot_tests::adams::{
    Accepted, FULL, FULL_STATES, PLAIN, PLAIN_STATES, ROUTINES, Surroundings, deviation, kernel, model_of, run, solver,
    started, with, written,
};
use std::f64::consts::TAU;
use std::path::Path;

/// Returns the test matrix of the thesis up to 25 Hz, with two slow tests, as pairs of amplitude, mm, and frequency,
/// Hz.
fn matrix() -> Vec<(f64, f64)> {
    let amplitudes = [50.0, 40.0, 30.0, 25.0, 15.0, 5.0, 2.0, 1.0];
    let peaks = [1.0 / 6.0, 5.0 / 12.0, 5.0 / 6.0, 1.25, 5.0 / 3.0, 10.0 / 3.0, 5.0].map(|f| TAU * 50.0 * f);
    let pairs = amplitudes.iter().flat_map(|a| peaks.iter().map(move |v| (*a, v / (TAU * a))));
    let mut points: Vec<(f64, f64)> = pairs.filter(|(_, f)| *f < 25.03).collect();
    points.extend([(10.0, 0.041), (10.0, 0.006369)]);
    points
}

#[test]
fn agrees_with_the_kernel_over_the_test_matrix() {
    let folder = tempfile::tempdir().unwrap();
    let solver = solver();
    let path = written(folder.path(), PLAIN);
    let model = model_of(PLAIN);
    let mut worst = 0.0_f64;
    for (amplitude, frequency) in matrix() {
        let cycles = if frequency < 0.1 { 0.6 } else { 1.5 };
        let more = [
            format!("amplitude={amplitude:?}"),
            format!("frequency={frequency:?}"),
            format!("end={:?}", cycles / frequency),
            format!("hmax={:?}", 0.005 / frequency),
        ];
        let more: Vec<&str> = more.iter().map(String::as_str).collect();
        for routine in ["gse", "sfo", "gfo"] {
            let got = started(&solver, routine, &with(&path, &more)).accepted();
            let share = deviation(&got, &kernel(&model, &got, amplitude, frequency, Surroundings::NONE));
            worst = worst.max(share);
            assert!(got.len() > 100 && share < 1e-3, "{routine} {amplitude} mm {frequency} Hz: {:.4} %", 100.0 * share);
        }
    }
    println!("worst deviation {:.5} % of the largest force", 100.0 * worst);
}

#[test]
fn private_states_and_side_force_agree_too() {
    let folder = tempfile::tempdir().unwrap();
    let solver = solver();
    let path = written(folder.path(), FULL);
    let model = model_of(FULL);
    let states = format!("ns={FULL_STATES}");
    let more = ["amplitude=15", "frequency=4", "end=0.4", "side=600", "ni=3", &states, "bad=1"];
    for (routine, side_force) in [("gse", 600.0), ("gfo", 600.0), ("sfo", 0.0)] {
        let got = started(&solver, routine, &with(&path, &more)).accepted();
        let share =
            deviation(&got, &kernel(&model, &got, 15.0, 4.0, Surroundings { side_force, ..Surroundings::NONE }));
        assert!(share < 1e-3, "{routine}: {:.4} %", 100.0 * share);
    }
}

/// Simulates a mass on a spring and a damper by a fourth-order method with short steps, from the kernel's state
/// derivatives. Returns the SFORCE (Adams's single-component force), N, at the accepted time points.
fn coupled(model: &Model, accepted: &[Accepted]) -> Vec<f64> {
    const MASS: f64 = 40.0;
    const SPRING: f64 = 30e3;
    let (amplitude, w) = (0.02, TAU * 3.0);
    let road = |t: f64| (amplitude * (w * t).cos(), -amplitude * w * (w * t).sin());
    type Y = (f64, f64, State);
    let rates = |t: f64, y: &Y| {
        let (r, rv) = road(t);
        let (output, rate) = evaluate(model, &y.2, &Input::motion(y.0 - r, y.1 - rv));
        ((y.1, (-output.force - SPRING * y.0) / MASS, rate), output.force)
    };
    let plus = |y: &Y, k: &Y, h: f64| {
        let mut z = (y.0 + h * k.0, y.1 + h * k.1, y.2);
        z.2.mass_displacement += h * k.2.mass_displacement;
        z.2.mass_velocity += h * k.2.mass_velocity;
        z
    };
    // Bisection finds the static equilibrium of the mass with the actuator at +amplitude, because the force rises with
    // displacement.
    let (mut low, mut high) = (-0.05, 0.05);
    for _ in 0..200 {
        let z = 0.5 * (low + high);
        let f = -model.static_output(&Input::motion(z - amplitude, 0.0)).force - SPRING * z;
        if f > 0.0 { low = z } else { high = z }
    }
    let mut y: Y = (low, 0.0, model.steady_state(&Input::motion(low - amplitude, 0.0)));
    let mut t = 0.0;
    accepted
        .iter()
        .map(|point| {
            let n = ((point.t - t) / 1e-5).ceil().max(1.0);
            let h = (point.t - t) / n;
            for _ in 0..n as usize {
                let k1 = rates(t, &y).0;
                let k2 = rates(t + h / 2.0, &plus(&y, &k1, h / 2.0)).0;
                let k3 = rates(t + h / 2.0, &plus(&y, &k2, h / 2.0)).0;
                let k4 = rates(t + h, &plus(&y, &k3, h)).0;
                y = plus(&plus(&plus(&plus(&y, &k1, h / 6.0), &k2, h / 3.0), &k3, h / 3.0), &k4, h / 6.0);
                t += h;
            }
            t = point.t;
            -rates(t, &y).1
        })
        .collect()
}

#[test]
fn a_mass_on_the_damper_moves_as_with_the_kernel_whatever_the_steps() {
    let folder = tempfile::tempdir().unwrap();
    let solver = solver();
    let path = written(folder.path(), PLAIN);
    let model = model_of(PLAIN);
    for routine in ROUTINES {
        for hmax in ["5e-3", "5e-4"] {
            // With bad=1, the solver also evaluates time points that it does not accept. With late=1, it accepts a time
            // point without a preceding evaluation.
            for bad in ["bad=0", "bad=1", "late=1"] {
                let limit = format!("hmax={hmax}");
                let settings = with(&path, &["mass=1", "frequency=3", "end=0.7", bad, &limit]);
                let run = started(&solver, routine, &settings);
                let got = run.accepted();
                let share = deviation(&got, &coupled(&model, &got));
                assert!(share < 1e-3, "{routine} {hmax} {bad}: {:.4} %", 100.0 * share);
            }
        }
    }
}

#[test]
fn with_partials_nothing_is_differenced_and_nothing_iterates_more() {
    let folder = tempfile::tempdir().unwrap();
    let solver = solver();
    for (text, states) in [(PLAIN, PLAIN_STATES), (FULL, FULL_STATES)] {
        let path = written(folder.path(), text);
        let states = format!("ns={states}");
        for routine in ROUTINES {
            let settings = |partials| with(&path, &["mass=1", "frequency=3", "end=0.5", "ni=4", &states, partials]);
            let differenced = started(&solver, routine, &settings("partials=0"));
            let handed = started(&solver, routine, &settings("partials=1"));
            assert!(differenced.count("differencing") > 0);
            assert_eq!(handed.count("differencing"), 0, "{routine}");
            let (more, less) = (handed.count("iterations"), differenced.count("iterations"));
            assert!(more <= less + less / 100, "{routine}: {more} iterations with partials, {less} without");
        }
    }
}

#[test]
fn trials_that_are_taken_back_leave_no_trace() {
    let folder = tempfile::tempdir().unwrap();
    let solver = solver();
    let path = written(folder.path(), FULL);
    let states = format!("ns={FULL_STATES}");
    for routine in ROUTINES {
        let runs = ["bad=0", "bad=1"].map(|bad| {
            let settings = with(&path, &["mass=1", "frequency=3", "end=0.4", &states, bad]);
            started(&solver, routine, &settings).accepted()
        });
        assert_eq!(runs[0], runs[1], "{routine}");
    }
}

#[test]
fn a_reloaded_run_repeats_the_first_to_the_last_bit() {
    let folder = tempfile::tempdir().unwrap();
    let solver = solver();
    let path = written(folder.path(), FULL);
    let states = format!("ns={FULL_STATES}");
    for routine in ROUTINES {
        let run = started(&solver, routine, &with(&path, &["mass=1", "frequency=3", "end=0.4", &states, "save=1"]));
        let part = |from: &str, to: &str| {
            let after = run.text.split(from).nth(1).unwrap();
            let lines: Vec<&str> = after.split(to).next().unwrap().lines().filter(|l| l.starts_with("at ")).collect();
            lines.join("\n")
        };
        let (first, second) = (part("first\n", "second\n"), part("second\n", "calls"));
        assert!(first.lines().count() > 20, "{routine}");
        assert_eq!(first, second, "{routine}");
    }
}

#[test]
fn dynamics_begin_where_statics_end() {
    let folder = tempfile::tempdir().unwrap();
    let solver = solver();
    for (text, states) in [(PLAIN, PLAIN_STATES), (FULL, FULL_STATES)] {
        let path = written(folder.path(), text);
        let model = model_of(text);
        let states = format!("ns={states}");
        for routine in ROUTINES {
            let run = started(&solver, routine, &with(&path, &["mass=1", "frequency=1", "end=0.01", &states]));
            let (x, sforce) = run.statics();
            let want = -model.static_output(&Input::motion(1e-3 * x, 0.0)).force;
            assert!((sforce - want).abs() < 1e-3, "{routine}: {sforce} and {want}");
            let first = run.accepted();
            assert!((first[0].sforce - sforce).abs() < 1e-6, "{routine}");
            // The force must not jump from the static equilibrium to the first step. The first steps take microseconds,
            // and only friction reacts to velocities of micrometers per second.
            assert!((first[1].sforce - sforce).abs() < 0.5, "{routine}: {:?} after {sforce}", first[1]);
        }
    }
}

#[test]
fn rebound_gives_a_negative_sforce() {
    let folder = tempfile::tempdir().unwrap();
    let solver = solver();
    let path = written(folder.path(), PLAIN);
    for routine in ROUTINES {
        let run = started(&solver, routine, &with(&path, &["amplitude=50", "frequency=2", "end=0.5"]));
        let accepted = run.accepted();
        let (rebound, compression): (Vec<Accepted>, Vec<Accepted>) =
            accepted.into_iter().filter(|a| a.v.abs() > 200.0).partition(|a| a.v > 0.0);
        assert!(!rebound.is_empty() && rebound.iter().all(|a| a.sforce < 0.0), "{routine}");
        assert!(!compression.is_empty() && compression.iter().all(|a| a.sforce > 0.0), "{routine}");
    }
}

/// Returns the argument `ns=` of the stand-in solver with the number of states of a GSE (Adams's general state
/// equation) for this model file. The library's message for a GSE without states contains the number.
fn states_wanted(solver: &Path, path: &Path) -> String {
    let refused = run(solver, "gse", &with(path, &["ns=0"]));
    let (_, after) = refused.text.split_once("needs NS=").unwrap_or_else(|| panic!("{}", refused.text));
    format!("ns={}", after.lines().next().unwrap())
}

#[test]
fn every_element_of_the_model_agrees() {
    let folder = tempfile::tempdir().unwrap();
    let solver = solver();
    let elements = dashpot_core::parameter::GROUPS.iter().map(|group| group.name);
    for element in elements {
        for base in ["\"fv_curve\"", "\"fv_curve\", \"series_compliance\""] {
            if base.contains(element) {
                continue;
            }
            let text = format!("format = 1\nelements = [{base}, \"{element}\"]\n");
            let mut params = Params::new();
            if model_file::read(text.as_bytes(), &mut params).is_err() || Model::new(&params).is_err() {
                continue;
            }
            let path = written(folder.path(), &text);
            let model = model_of(&text);
            let states = states_wanted(&solver, &path);
            for routine in ["gse", "sfo"] {
                let more = ["amplitude=25", "frequency=3", "end=0.5", "hmax=1e-3", &states];
                let got = started(&solver, routine, &with(&path, &more)).accepted();
                let share = deviation(&got, &kernel(&model, &got, 25.0, 3.0, Surroundings::NONE));
                assert!(share < 1e-3, "{element} after {base}, {routine}: {:.4} %", 100.0 * share);
                // The static analysis of a mass on the damper must find the equilibrium of the kernel.
                let run = started(&solver, routine, &with(&path, &["mass=1", "end=0.002", &states]));
                let (x, sforce) = run.statics();
                let want = -model.static_output(&Input::motion(1e-3 * x, 0.0)).force;
                assert!((sforce - want).abs() < 1e-3, "{element} after {base}, {routine}: {sforce} and {want}");
                assert!((run.accepted()[1].sforce - sforce).abs() < 0.5, "{element} after {base}, {routine} jumps");
            }
        }
    }
}

/// Checks that the Adams command LINEAR (analysis mode 7) linearizes the damper without dry friction.
///
/// The expected eigenvalues follow from the kernel's derivatives without dry friction. In a dynamic analysis, the
/// system matrix contains the stiffness of sticking friction, which would lock the damper.
#[test]
fn a_linearisation_is_not_locked_by_stuck_friction() {
    const MASS: f64 = 40.0;
    const SPRING: f64 = 30e3;
    let text = "format = 1\nelements = [\"fv_curve\", \"series_compliance\", \"stribeck_friction\", \"coulomb_friction\", \"side_force_friction\", \
                \"presliding_friction\", \"parallel_spring\", \"gas_preload\"]\nspring_linear = 2000.0\npresliding_force = 60.0\n";
    let frictionless = text
        .replace("\"stribeck_friction\", \"coulomb_friction\", \"side_force_friction\", ", "")
        .replace("\"presliding_friction\", ", "")
        .replace("presliding_force = 60.0\n", "");
    let folder = tempfile::tempdir().unwrap();
    let solver = solver();
    let path = written(folder.path(), text);
    let model = model_of(&frictionless);
    let (mut pairs, locked) = (Vec::new(), 130e3);
    for routine in ROUTINES {
        let matrices = |mode: u32| {
            let run = started(
                &solver,
                routine,
                &with(&path, &["mass=1", "ni=4", "ns=3", "side=200", "amplitude=0.5", &format!("linear={mode}")]),
            );
            ["differenced", "handed"].map(|name| {
                let line =
                    run.text.lines().find_map(|l| l.strip_prefix(name)).unwrap_or_else(|| panic!("{}", run.text));
                let numbers: Vec<f64> = line.split_whitespace().map(|n| n.parse().unwrap()).collect();
                let n = (numbers.len() as f64).sqrt() as usize;
                nalgebra::DMatrix::from_row_slice(n, n, &numbers)
            })
        };
        let x = {
            let run = started(
                &solver,
                routine,
                &with(&path, &["mass=1", "ni=4", "ns=3", "side=200", "amplitude=0.5", "end=0.001"]),
            );
            1e-3 * run.statics().0
        };
        let force = |x: f64, v: f64| model.static_output(&Input::motion(x, v)).force;
        let stiffness = SPRING + (force(x + 1e-6, 0.0) - force(x - 1e-6, 0.0)) / 2e-6;
        let damping = (force(x, 1e-6) - force(x, -1e-6)) / 2e-6;
        for matrix in matrices(7) {
            let values: Vec<_> = matrix.complex_eigenvalues().iter().copied().collect();
            // The expected eigenvalues are those of a mass with `stiffness` and `damping`. The damper's part of both is the derivative of
            // the kernel's static force.
            let (half, rest) = (-0.5 * damping / MASS, stiffness / MASS - (0.5 * damping / MASS).powi(2));
            let wanted: Vec<(f64, f64)> = if rest > 0.0 {
                vec![(half, rest.sqrt()), (half, -rest.sqrt())]
            } else {
                vec![(half + (-rest).sqrt(), 0.0), (half - (-rest).sqrt(), 0.0)]
            };
            // A GSE also contains the series spring, which changes the fast mode. The slow mode, the motion of the mass
            // on the damper, is compared.
            for (re, im) in if routine == "gse" { &wanted[..1] } else { &wanted[..] } {
                let nearest = values.iter().map(|v| (v.re - re).hypot(v.im - im)).fold(f64::MAX, f64::min);
                assert!(nearest < 0.02 * re.hypot(*im), "{routine}: {values:?} for {wanted:?}");
            }
            assert!(values.iter().all(|v| v.re < 1e-6), "{routine}: {values:?}");
            pairs.push(values);
        }
        // In a dynamic analysis (mode 4), the system matrix contains the derivatives of the friction.
        let [dynamic, _] = matrices(4);
        if routine != "gse" {
            assert!(
                -dynamic[(1, 0)] * MASS > SPRING + locked || -dynamic[(1, 1)] * MASS > 3.0 * damping,
                "{routine}: {dynamic}"
            );
        }
    }
    println!("{pairs:?}");
}

/// Checks the setting of an adjustable damper in Adams. The setting is the fifth input of a GSE. For an SFORCE or
/// GFORCE, it is a VARIABLE with a given id.
#[test]
fn a_variable_of_the_solver_is_the_setting() {
    let folder = tempfile::tempdir().unwrap();
    let solver = solver();
    let text = std::fs::read_to_string(dashpot_tests::library::root().join("examples/semi_active.toml")).unwrap();
    let path = written(folder.path(), &text);
    let file = dashpot_identification::model_file::family_of_text(&text, &path).unwrap();
    let mut family = Box::new(dashpot_core::family::Family::OFF);
    family.set(&file.params, &file.axis).unwrap();
    let last = |got: &[Accepted]| got.last().unwrap().sforce;
    let mut ends: Vec<[f64; 3]> = Vec::new();
    for routine in ROUTINES {
        // The library reports the required number of states of a GSE.
        let asked = run(&solver, routine, &with(&path, &["ns=1", "ni=5"])).text;
        let states = asked
            .split("needs NS=")
            .nth(1)
            .map_or("2", |rest| rest.split(|c: char| !c.is_ascii_digit()).next().unwrap());
        let states = format!("ns={states}");
        let settings = |setting: &str, more: &[&str]| {
            let own = ["amplitude=15", "frequency=2", "end=0.4", "ni=5", "variable=31", setting, &states];
            with(&path, &[&own[..], more].concat())
        };
        let mut constant = Vec::new();
        for setting in [0.2, 1.4] {
            let run = started(&solver, routine, &settings(&format!("setting={setting}"), &[]));
            let got = run.accepted();
            let model = Model::new(&file.definition().params_at(setting)).unwrap();
            let share = deviation(&got, &kernel(&model, &got, 15.0, 2.0, Surroundings::NONE));
            assert!(share < 2e-3, "{routine} at {setting}: {:.4} %", 100.0 * share);
            constant.push(last(&got));
        }
        // The setting switches in the middle of the run, and the actuator reaches its steady state within the second
        // half.
        let switched = started(&solver, routine, &settings("setting=0.2", &["later=1.4"])).accepted();
        let [soft, hard] = constant[..] else { panic!() };
        assert!(
            (last(&switched) - hard).abs() < 0.02 * (hard - soft).abs(),
            "{routine}: {} of {soft} to {hard}",
            last(&switched)
        );
        ends.push([soft, hard, last(&switched)]);
        if routine != "gse" {
            let repeated = started(&solver, routine, &settings("setting=0.2", &["later=1.4", "save=1"])).text;
            let part = |from: &str, to: &str| -> Vec<String> {
                let part = repeated.split(from).nth(1).unwrap().split(to).next().unwrap();
                part.lines().filter(|line| line.starts_with("at ")).map(str::to_owned).collect()
            };
            assert!(part("first\n", "second\n") == part("second\n", "calls"), "{routine}");
            let handed = started(&solver, routine, &settings("setting=0.6", &["mass=1", "partials=1"]));
            assert!(handed.by_variable().is_finite() && handed.count("differencing") == 0, "{routine}");
            let lost = run(&solver, routine, &settings("setting=0.6", &["npar=1"]));
            assert!(lost.code == Some(3) && lost.text.contains("VARIABLE"), "{routine}: {}", lost.text);
        }
    }
    let top = ends[0][1].abs();
    for other in &ends[1..] {
        for (a, b) in other.iter().zip(&ends[0]) {
            assert!((a - b).abs() < 0.01 * top, "{ends:?}");
        }
    }
}
