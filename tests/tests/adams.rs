//! The damper inside a solver: the shipped library, loaded by a stand-in for Adams, against the kernel's own runs.

use dashpot_core::{Input, Model, Params, State, evaluate::evaluate, model_file, step};
use dashpot_tests::adams::{Accepted, Run, library, run, solver};
use std::f64::consts::TAU;
use std::path::{Path, PathBuf};
use std::process::Command;

/// What most dampers have.
const PLAIN: &str = "format = 1\nelements = [\"fv_curve\", \"series_compliance\", \"stribeck_friction\", \
                     \"viscous_friction\", \"parallel_spring\", \"gas_preload\"]\n";
/// Private states and side force as well.
const FULL: &str = "format = 1\nelements = [\"fv_curve\", \"series_compliance\", \"stribeck_friction\", \
                    \"side_force_friction\", \"gas_preload\", \"lagged_polynomial\"]\npolynomial = [3.0, 400.0, -25.0, 60.0]\n";
/// States of the two.
const PLAIN_STATES: u32 = 2;
const FULL_STATES: u32 = 3;

const ROUTINES: [&str; 4] = ["gse", "sfo", "gfo", "car"];

/// The thesis's matrix: amplitudes in mm at peak velocities in mm/s, up to 25 Hz.
fn matrix() -> Vec<(f64, f64)> {
    let amplitudes = [50.0, 40.0, 30.0, 25.0, 15.0, 5.0, 2.0, 1.0];
    let peaks = [1.0 / 6.0, 5.0 / 12.0, 5.0 / 6.0, 1.25, 5.0 / 3.0, 10.0 / 3.0, 5.0].map(|f| TAU * 50.0 * f);
    let pairs = amplitudes.iter().flat_map(|a| peaks.iter().map(move |v| (*a, v / (TAU * a))));
    let mut points: Vec<(f64, f64)> = pairs.filter(|(_, f)| *f < 25.03).collect();
    points.extend([(10.0, 0.041), (10.0, 0.006369)]);
    points
}

fn model_of(text: &str) -> Model {
    let mut params = Params::new();
    model_file::read(text.as_bytes(), &mut params).unwrap();
    Model::new(&params).unwrap()
}

fn written(folder: &Path, text: &str) -> PathBuf {
    let path = folder.join("damper.toml");
    std::fs::write(&path, text).unwrap();
    path
}

fn with(path: &Path, more: &[&str]) -> Vec<String> {
    let mut settings = vec![format!("model={}", path.display())];
    settings.extend(more.iter().map(|s| s.to_string()));
    settings
}

fn started(solver: &Path, routine: &str, settings: &[String]) -> Run {
    let run = run(solver, routine, settings);
    assert_eq!(run.code, Some(0), "{routine} {settings:?}: {}", run.text);
    run
}

/// The kernel's converged SFORCE at the accepted instants of a rig run.
fn kernel(model: &Model, accepted: &[Accepted], amplitude: f64, frequency: f64, side_force: f64) -> Vec<f64> {
    let w = TAU * frequency;
    let longest = (0.05 / frequency / 1000.0).min(2e-5).max(2e-5 / frequency.min(1.0) / 10.0);
    let at = |t: f64| Input {
        side_force,
        ..Input::motion(-1e-3 * amplitude * (w * t).cos(), 1e-3 * amplitude * w * (w * t).sin())
    };
    let mut state = model.settled(&at(0.0));
    let mut t = 0.0;
    let mut forces = Vec::new();
    for point in accepted {
        let steps = ((point.t - t) / longest).ceil().max(1.0);
        let mut force = model.static_output(&at(0.0)).force;
        if point.t > t {
            for i in 1..=steps as usize {
                let to = at(t + (point.t - t) * i as f64 / steps);
                let (next, output) = step(model, &state, &to, (point.t - t) / steps);
                (state, force) = (next, output.force);
            }
        }
        t = point.t;
        forces.push(-force);
    }
    forces
}

/// Largest deviation as a share of the largest force.
fn deviation(got: &[Accepted], want: &[f64]) -> f64 {
    let largest = want.iter().fold(0.0_f64, |m, f| m.max(f.abs()));
    got.iter().zip(want).fold(0.0_f64, |m, (g, w)| m.max((g.sforce - w).abs())) / largest
}

#[test]
fn exports_only_entry_names_and_they_hold_both_cases() {
    let listed = Command::new("nm").args(["-D", "--defined-only"]).arg(library()).output().unwrap();
    let text = String::from_utf8(listed.stdout).unwrap();
    let mut names: Vec<&str> = text.lines().filter_map(|l| l.split(' ').nth(2)).collect();
    names.sort_unstable();
    let entries = ["gfosub", "gse_deriv", "gse_output", "gse_samp", "gse_update", "reqsub", "sfo2001", "sfosub"];
    let mut want: Vec<String> = entries.iter().map(|e| format!("Dashpot_{e}")).collect();
    want.push("dashpot_adams_selftest".into());
    assert_eq!(names, want);
}

#[test]
fn asks_for_no_recent_system() {
    let listed = Command::new("nm").args(["-D", "--undefined-only"]).arg(library()).output().unwrap();
    let text = String::from_utf8(listed.stdout).unwrap();
    for line in text.lines().filter(|l| l.contains("@GLIBC_2.")) {
        let minor: u32 = line.split("@GLIBC_2.").nth(1).unwrap().split('.').next().unwrap().parse().unwrap();
        assert!(minor <= 28, "{line}");
    }
}

#[test]
fn agrees_with_the_kernel_over_the_test_matrix() {
    let folder = tempfile::tempdir().unwrap();
    let solver = solver(&[]);
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
            let share = deviation(&got, &kernel(&model, &got, amplitude, frequency, 0.0));
            worst = worst.max(share);
            assert!(got.len() > 100 && share < 1e-3, "{routine} {amplitude} mm {frequency} Hz: {:.4} %", 100.0 * share);
        }
    }
    println!("worst deviation {:.5} % of the largest force", 100.0 * worst);
}

#[test]
fn private_states_and_side_force_agree_too() {
    let folder = tempfile::tempdir().unwrap();
    let solver = solver(&[]);
    let path = written(folder.path(), FULL);
    let model = model_of(FULL);
    let states = format!("ns={FULL_STATES}");
    let more = ["amplitude=15", "frequency=4", "end=0.4", "side=600", "ni=3", &states, "bad=1"];
    for (routine, side_force) in [("gse", 600.0), ("gfo", 600.0), ("sfo", 0.0)] {
        let got = started(&solver, routine, &with(&path, &more)).accepted();
        let share = deviation(&got, &kernel(&model, &got, 15.0, 4.0, side_force));
        assert!(share < 1e-3, "{routine}: {:.4} %", 100.0 * share);
    }
}

/// A mass on spring and damper, integrated with the kernel's rates by a fourth-order method with short steps.
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
    // Static equilibrium with the actuator at +amplitude, by bisection: the force rises with displacement.
    let (mut low, mut high) = (-0.05, 0.05);
    for _ in 0..200 {
        let z = 0.5 * (low + high);
        let f = -model.static_output(&Input::motion(z - amplitude, 0.0)).force - SPRING * z;
        if f > 0.0 { low = z } else { high = z }
    }
    let mut y: Y = (low, 0.0, model.settled(&Input::motion(low - amplitude, 0.0)));
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
    let solver = solver(&[]);
    let path = written(folder.path(), PLAIN);
    let model = model_of(PLAIN);
    for routine in ROUTINES {
        for hmax in ["5e-3", "5e-4"] {
            for bad in ["bad=0", "bad=1"] {
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
    let solver = solver(&[]);
    for (text, states) in [(PLAIN, PLAIN_STATES), (FULL, FULL_STATES)] {
        let path = written(folder.path(), text);
        let states = format!("ns={states}");
        for routine in ["gse", "sfo", "car"] {
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
    let solver = solver(&[]);
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
    let solver = solver(&[]);
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
    let solver = solver(&[]);
    let path = written(folder.path(), PLAIN);
    let model = model_of(PLAIN);
    for routine in ROUTINES {
        let run = started(&solver, routine, &with(&path, &["mass=1", "frequency=1", "end=0.01"]));
        let (x, sforce) = run.statics();
        let want = -model.static_output(&Input::motion(1e-3 * x, 0.0)).force;
        assert!((sforce - want).abs() < 1e-3, "{routine}: {sforce} and {want}");
        let first = run.accepted();
        assert!((first[0].sforce - sforce).abs() < 1e-6, "{routine}");
        // No jump: the first steps are microseconds long, and friction alone answers the first micrometres a second.
        assert!((first[1].sforce - sforce).abs() < 0.5, "{routine}: {:?} after {sforce}", first[1]);
    }
}

#[test]
fn rebound_gives_a_negative_sforce() {
    let folder = tempfile::tempdir().unwrap();
    let solver = solver(&[]);
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

#[test]
fn the_gse_is_declared_threadsafe_and_is() {
    let folder = tempfile::tempdir().unwrap();
    let solver = solver(&[]);
    let path = written(folder.path(), PLAIN);
    let run = started(&solver, "gse", &with(&path, &["threads=1"]));
    assert_eq!(run.threads().len(), 4);
    for (alone, together) in run.threads() {
        assert_eq!(alone.to_bits(), together.to_bits());
    }
    for (routine, declared) in [("gse", true), ("sfo", false), ("gfo", false), ("car", false)] {
        let run = started(&solver, routine, &with(&path, &["end=0.001"]));
        assert_eq!(run.count("threadsafe") > 0, declared, "{routine}");
    }
}

#[test]
fn misuse_stops_the_run_with_a_message_that_helps() {
    let folder = tempfile::tempdir().unwrap();
    let solver = solver(&[]);
    let path = written(folder.path(), PLAIN);
    let bad = folder.path().join("bad.toml");
    std::fs::write(&bad, "format = 1\nelements = []\ngas_force = 1e9\n").unwrap();
    let wrong_file = format!("model={}", bad.display());
    let missing_file = "model=nowhere.toml";
    let all: &[(&[&str], &[&str])] = &[
        (&["string=0"], &["STRING/7", "model file"]),
        (&["par=7.5"], &["first USER value", "7.5", "STRING"]),
        (&["par=nan"], &["first USER value", "STRING"]),
        (&[missing_file], &["nowhere.toml", "cannot open"]),
        (&["model=mdids://acar_shared/dampers.tbl/a.toml"], &["mdids", "path"]),
        (&[&wrong_file], &["bad.toml, line 3", "gas_force"]),
        (&["npar=-1"], &["USER", "string"]),
        (&["npar=2"], &["USER", "string"]),
        (&["units=0"], &["UNITS"]),
        (&["mm=0"], &["units"]),
    ];
    for routine in ROUTINES {
        for (settings, words) in all {
            let run = run(&solver, routine, &with(&path, settings));
            assert_eq!(run.code, Some(3), "{routine} {settings:?}: {}", run.text);
            for word in *words {
                assert!(run.text.contains(word), "{routine} {settings:?} says nothing of {word}: {}", run.text);
            }
        }
    }
    for (setting, word) in [("ns=1", "NS=2"), ("ns=5", "NS=2"), ("ni=1", "NI=1"), ("no=0", "NO=0"), ("no=10", "NO=10")]
    {
        let run = run(&solver, "gse", &with(&path, &[setting]));
        assert!(run.code == Some(3) && run.text.contains(word), "{setting}: {}", run.text);
    }
    for iflag in ["iflag=2", "iflag=4", "iflag=11", "iflag=99"] {
        for routine in ROUTINES {
            let run = run(&solver, routine, &with(&path, &[iflag]));
            assert!(run.code == Some(0) && run.text.contains("force 0\n"), "{routine} {iflag}: {}", run.text);
        }
    }
}

#[test]
fn a_missing_utility_is_named() {
    let folder = tempfile::tempdir().unwrap();
    let path = written(folder.path(), PLAIN);
    let lacking = dashpot_tests::adams::solver(&["-DWITHOUT_TIMGET"]);
    for routine in ["sfo", "gfo", "car"] {
        let run = run(&lacking, routine, &with(&path, &[]));
        assert!(run.code == Some(3) && run.text.contains("c_timget"), "{routine}: {}", run.text);
    }
    assert_eq!(run(&lacking, "gse", &with(&path, &["end=0.01"])).code, Some(0), "a GSE does without it");
}

#[test]
fn a_request_shows_what_makes_the_force() {
    let folder = tempfile::tempdir().unwrap();
    let solver = solver(&[]);
    let path = written(folder.path(), PLAIN);
    for routine in ["sfo", "gfo", "car"] {
        let run = started(&solver, routine, &with(&path, &["amplitude=20", "frequency=2", "end=0.13"]));
        let last = *run.accepted().last().unwrap();
        let [force, deflection, mass_velocity, primary, spring, friction, gas, displacement] = run.request()[..] else {
            panic!("eight results");
        };
        assert_eq!(force, -last.sforce, "{routine}");
        assert!((displacement - last.x).abs() < 1e-9 && (mass_velocity - last.v).abs() < 0.05 * last.v.abs());
        // The series spring's force, 3000 N/mm and 0.2 N s/mm, is what friction and gas leave of the whole.
        let series = 3000.0 * deflection + 0.2 * (last.v - mass_velocity);
        assert!((series + friction + gas - force).abs() < 1e-6 * force.abs(), "{routine}");
        // The internal mass, half a kilogram, takes little.
        assert!((primary + spring - series).abs() < 0.02 * force.abs(), "{routine}: {primary} {spring} {series}");
        assert!(gas < 0.0 && friction > 0.0);
        let unknown = started(&solver, routine, &with(&path, &["end=0.01", "request=99"]));
        assert_eq!(unknown.request(), [0.0; 8]);
    }
}

#[test]
fn the_sources_are_cpp_too() {
    let folder = tempfile::tempdir().unwrap();
    let sources = dashpot_tests::library::root().join("adams-usersub/src");
    for source in std::fs::read_dir(&sources).unwrap().map(|e| e.unwrap().path()) {
        if source.extension().is_some_and(|e| e == "c") {
            let mut compiler = Command::new(std::env::var_os("CXX").unwrap_or("g++".into()));
            compiler.args(["-x", "c++", "-std=c++11", "-Wall", "-Wextra", "-Werror", "-c", "-I"]);
            compiler.arg(dashpot_tests::library::root().join("include")).arg(&source);
            dashpot_tests::library::succeed(compiler.arg("-o").arg(folder.path().join("x.o")));
        }
    }
}
