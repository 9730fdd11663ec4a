//! Tests of the Python examples in independent multibody programs.
//!
//! The motion of a mass dropped on a spring and a damper must match a simulation with the kernel. The kernel's steps
//! are so short that the integration method is irrelevant.

use dashpot_core::{Input, Model, Params, model_file, step};
use dashpot_tests::library::{root, shared, succeed};
use dashpot_tests::python::python_with;
use std::process::Command;

const MODEL: &str = "format = 1\nelements = [\"fv_curve\", \"series_compliance\", \"parallel_spring\", \"stribeck_friction\", \"gas_preload\"]\n\
                     gas_force = 141.5\n";

/// Computes position of the mass, m, and damper force, N, every 10 ms of 1 s, with the parameters of the examples.
fn kernel() -> Vec<[f64; 2]> {
    const MASS: f64 = 100.0;
    const STIFFNESS: f64 = 24000.0;
    const DROP: f64 = 0.03;
    const STEP: f64 = 2e-6;
    let mut params = Params::new();
    model_file::read(MODEL.as_bytes(), &mut params).expect("the model");
    let model = Model::new(&params).expect("a model");
    let at_rest = |x: f64| {
        let state = model.steady_state(&Input::motion(x, 0.0));
        (state, step(&model, &state, &Input::motion(x, 0.0), 0.0).1.force)
    };
    let rest = at_rest(0.0).1;
    let (mut state, mut force) = at_rest(DROP);
    let (mut x, mut v) = (DROP, 0.0);
    let mut told = Vec::new();
    for k in 1..=500_000 {
        v -= STEP * (STIFFNESS * x + force - rest) / MASS;
        x += STEP * v;
        let (next, output) = step(&model, &state, &Input::motion(x, v), STEP);
        (state, force) = (next, output.force);
        if k % 5000 == 0 {
            told.push([x, force]);
        }
    }
    told
}

fn agrees(package: &str, example: &str) {
    let Some(python) = python_with(package) else { return };
    let folder = tempfile::tempdir().expect("a directory");
    let model = folder.path().join("model.toml");
    std::fs::write(&model, MODEL).expect("a model file");
    let mut host = Command::new(python);
    host.current_dir(folder.path()).arg(root().join("examples").join(example)).arg(shared()).arg(&model);
    host.env("PYTHONDONTWRITEBYTECODE", "1");
    let rows: Vec<Vec<f64>> = succeed(&mut host)
        .lines()
        .map(|line| line.split(' ').map(|n| n.parse().unwrap_or_else(|_| panic!("{line}"))).collect())
        .filter(|row: &Vec<f64>| row[0] > 0.0)
        .collect();
    let kernel = kernel();
    assert_eq!(rows.len(), kernel.len());
    let largest = |column: usize| kernel.iter().map(|row| row[column].abs()).fold(0.0, f64::max);
    for column in 0..2 {
        let off = rows.iter().zip(&kernel).map(|(a, b)| (a[column + 1] - b[column]).abs()).fold(0.0, f64::max);
        println!("{package}, {}: {:.3} %", ["position", "force"][column], 100.0 * off / largest(column));
        assert!(off < 0.01 * largest(column), "{package}: {off} of {}", largest(column));
    }
}

#[test]
fn exudyn() {
    agrees("exudyn==1.13.6", "exudyn_drop.py");
}

#[test]
fn drake() {
    agrees("drake==1.51.1", "drake_drop.py");
}
