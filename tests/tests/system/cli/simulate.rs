//! Tests of `dashpot simulate`: the force for any motion equals the kernel's.

use dashpot_core::step::step;
use dashpot_core::{Input, Model, Params};
use dashpot_tests::cli::{done, refused, run, table};
use std::f64::consts::TAU;
use std::fmt::Write as _;
use std::path::Path;

const COLUMNS: [&str; 4] = ["time_s", "displacement_m", "velocity_m_s", "force_N"];
const MODEL: &str = "format = 1\n\
    elements = [\"fv_curve\", \"series_compliance\", \"coulomb_friction\", \"gas_preload\", \"parallel_spring\"]\n\
    gas_force = 180\nspring_linear = 400\nspring_quadratic = 0\nseries_stiffness = 4e6\n";

/// Makes a folder with the model file.
fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("m.toml"), MODEL).unwrap();
    folder
}

fn model() -> Model {
    let mut params = Params::new();
    dashpot_core::model_file::read(MODEL.as_bytes(), &mut params).unwrap();
    Model::new(&params).unwrap()
}

/// Returns displacement, m, and velocity, m/s, of a sum of two sines at the time `t`, s.
fn motion(t: f64) -> (f64, f64) {
    let (a, b) = (2.0 * TAU, 13.0 * TAU);
    (0.02 * (a * t).sin() + 0.001 * (b * t).sin(), 0.02 * a * (a * t).cos() + 0.001 * b * (b * t).cos())
}

/// Writes a motion file with the given columns at the given times.
fn write(path: &Path, columns: &[&str], times: impl Iterator<Item = f64>) {
    let mut text = columns.join(",") + "\n";
    for t in times {
        let (x, v) = motion(t);
        let cells: Vec<String> = columns
            .iter()
            .map(|c| match *c {
                "time_s" => format!("{t:?}"),
                "displacement_m" => format!("{x:?}"),
                _ => format!("{v:?}"),
            })
            .collect();
        let _ = writeln!(text, "{}", cells.join(","));
    }
    std::fs::write(path, text).unwrap();
}

fn forces(dir: &Path, args: &[&str]) -> Vec<f64> {
    done(dir, &[&["simulate", "m.toml"], args, &["-o", "out.csv"]].concat());
    let (header, rows) = table(&dir.join("out.csv"));
    assert_eq!(header, COLUMNS);
    rows.iter().map(|r| r[3]).collect()
}

fn apart(a: &[f64], b: &[f64]) -> f64 {
    assert_eq!(a.len(), b.len());
    let peak = a.iter().fold(0.0_f64, |m, f| m.max(f.abs()));
    a.iter().zip(b).fold(0.0_f64, |m, (a, b)| m.max((a - b).abs())) / peak
}

#[test]
fn numbers_of_an_element_that_is_off_are_told_by_every_verb() {
    let folder = folder();
    let dir = folder.path();
    write(&dir.join("in.csv"), &COLUMNS[..3], (0..300).map(|i| 1e-3 * f64::from(i)));
    std::fs::write(dir.join("idle.toml"), MODEL.to_owned() + "presliding_force = 60\npresliding_length = 1e-4\n")
        .unwrap();
    for args in [
        &["simulate", "idle.toml", "in.csv", "-o", "out.csv"][..],
        &["check", "idle.toml"],
        &["export", "dpr", "idle.toml", "-o", "curve.dpr"],
    ] {
        let out = run(dir, args);
        let told = out.err;
        assert!(out.code == Some(0), "{args:?}: {told}");
        assert!(
            told.contains("note: idle.toml: the model file gives presliding_force, presliding_length, but the element presliding_friction is off"),
            "{args:?}: {told}"
        );
        let out =
            run(dir, &args.iter().map(|arg| if *arg == "idle.toml" { "m.toml" } else { arg }).collect::<Vec<_>>());
        assert!(!out.err.contains("is off"), "{}", out.err);
    }
}

#[test]
fn the_force_is_the_kernels_to_the_bit() {
    let folder = folder();
    let dir = folder.path();
    // The time steps are uneven: 1.2, 1.2 and 0.6 ms in turn.
    let times: Vec<f64> = (0..600).map(|i| 1e-3 * f64::from(i) + 2e-4 * f64::from(i % 3)).collect();
    write(&dir.join("both.csv"), &["time_s", "displacement_m", "velocity_m_s"], times.iter().copied());
    let answered = forces(dir, &["both.csv"]);
    let model = model();
    let input = |t: f64| Input::motion(motion(t).0, motion(t).1);
    let mut state = model.steady_state(&input(times[0]));
    let mut expected = vec![dashpot_core::evaluate::force(&model, &state, &input(times[0])).force];
    for t in times.windows(2) {
        let (next, output) = step(&model, &state, &input(t[1]), t[1] - t[0]);
        state = next;
        expected.push(output.force);
    }
    assert_eq!(answered, expected);
    // Standard output contains the same table and nothing else.
    let out = done(dir, &["simulate", "m.toml", "both.csv", "-o", "-"]);
    assert_eq!(out, std::fs::read_to_string(dir.join("out.csv")).unwrap());
}

#[test]
fn every_form_of_a_motion_and_every_step_agree() {
    let folder = folder();
    let dir = folder.path();
    let times = || (0..=1000).map(|i| 1e-3 * f64::from(i));
    write(&dir.join("both.csv"), &["time_s", "displacement_m", "velocity_m_s"], times());
    write(&dir.join("x.csv"), &["time_s", "displacement_m"], times());
    write(&dir.join("v.csv"), &["time_s", "velocity_m_s"], times());
    let both = forces(dir, &["both.csv"]);
    assert!(apart(&both, &forces(dir, &["x.csv"])) < 1e-3);
    assert!(apart(&both, &forces(dir, &["v.csv"])) < 5e-3);
    for file in ["both.csv", "x.csv", "v.csv"] {
        let own = forces(dir, &[file, "--step", "0.001"]);
        let half: Vec<f64> = forces(dir, &[file, "--step", "0.0005"]).into_iter().step_by(2).collect();
        assert!(apart(&own, &half) < 5e-3, "{file}: {}", apart(&own, &half));
    }
}

#[test]
fn at_rest_there_are_gas_and_spring_alone() {
    let folder = folder();
    let dir = folder.path();
    let file = dir.join("rest.csv");
    std::fs::write(&file, "time_s,velocity_m_s\n0,0\n0.5,0\n5,0\n").unwrap();
    for (position, force) in [("0", -180.0), ("0.02", -172.0), ("-0.05", -200.0)] {
        for answer in forces(dir, &["rest.csv", "--initial-position", position]) {
            // The spring is in series with the compliance, whose deflection reduces the force by a ten-thousandth.
            assert!((answer - force).abs() < 0.01, "{position}: {answer}");
        }
    }
    let (_, rows) = table(&dir.join("out.csv"));
    assert_eq!(rows[2][..3], [5.0, -0.05, 0.0]);
}

#[test]
fn huge_steps_and_wild_motions_stay_finite() {
    let folder = folder();
    let dir = folder.path();
    let file = dir.join("wild.csv");
    std::fs::write(&file, "time_s,displacement_m\n0,0.01\n1e6,-0.05\n1.000001e6,0.5\n3e9,-0.5\n3.1e9,0\n").unwrap();
    assert!(forces(dir, &["wild.csv"]).iter().all(|f| f.is_finite()));
    std::fs::write(&file, "time_s,velocity_m_s\n0,0\n0.001,50\n0.002,-50\n1000,0\n").unwrap();
    let ran = run(dir, &["simulate", "m.toml", "wild.csv", "-o", "-"]);
    assert!(ran.err.contains("2 of 4 rows are faster than the FV curve reaches"), "{}", ran.err);
    std::fs::write(&file, "time_s,displacement_m\n0,-1e300\n1e-9,1e300\n").unwrap();
    assert!(refused(dir, &["simulate", "m.toml", "wild.csv", "-o", "new.csv"]).contains("stays within ±1000 m"));
}

#[test]
fn records_are_motions_whatever_their_units() {
    let folder = folder();
    let dir = folder.path();
    std::fs::write(dir.join("si.csv"), "time_s,displacement_m,force_N\n0,0,1\n0.01,0.001,2\n0.02,0.004,3\n").unwrap();
    std::fs::write(dir.join("mm.csv"), "Zeit;Hub [mm];Load\n0;0;1\n10;1,0;2\n20;4,0;3\n").unwrap();
    let si = forces(dir, &["si.csv"]);
    let mm =
        forces(dir, &["mm.csv", "--column", "time=Zeit", "--unit", "time=ms", "--column", "displacement=Hub [mm]"]);
    assert!(apart(&si, &mm) < 1e-12);
}

#[test]
fn a_wrong_motion_is_refused_with_its_place() {
    let folder = folder();
    let dir = folder.path();
    let file = dir.join("a.csv");
    let says = |text: &str, more: &[&str]| {
        std::fs::write(&file, text).unwrap();
        refused(dir, &[&["simulate", "m.toml", "a.csv", "-o", "out.csv"], more].concat())
    };
    let good = "time_s,displacement_m\n0,0\n1,0.01\n";
    for (text, more, wanted) in [
        ("time_s,displacement_m\n0,0\n1,nan\n", &[][..], "a.csv, line 3"),
        ("time_s,displacement_m\n0,0\n0,0\n", &[], "a.csv, line 3: time does not increase"),
        ("time_s,displacement_m\n0,0\n", &[], "at least two"),
        (good, &["--initial-position", "0.1"], "--ignore displacement"),
        (good, &["--ignore", "displacement"], "no column for displacement or velocity"),
        (good, &["--ignore", "time"], "no column for time"),
        (good, &["--step", "0"], "above zero"),
        (good, &["--step", "-1"], "above zero"),
        (good, &["--step", "2"], "longer than the motion"),
        (good, &["--step", "1e-12"], "at most"),
        (good, &["--unit", "displacement=N"], "displacement"),
    ] {
        let message = says(text, more);
        assert!(message.contains(wanted), "{text:?} {more:?}: {message}");
    }
    assert!(refused(dir, &["simulate", "m.toml", "a.csv", "-o", "none/out.csv"]).contains("there is no folder none"));
    assert!(refused(dir, &["simulate", "m.toml", "a.csv", "-o", "."]).contains("it is a folder"));
    assert!(refused(dir, &["simulate", "m.toml", "b.csv", "-o", "out.csv"]).contains("b.csv: there is no such file"));
}
