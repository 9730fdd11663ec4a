//! Tests of the accuracy of the simulator bridge (`vi-crt-bridge`) at host steps from 0.25 to 2 ms. The reference is
//! the converged solution over the test matrix.

use dashpot_core::{Model, Params, model_file};
use dashpot_rig::Matrix;
use dashpot_simulation::accuracy::radau::PrescribedMotion as _;
use dashpot_simulation::accuracy::{Errors, References, Sine, errors, worst};
use dashpot_tests::bridge::bridge_host;
use std::fs::File;
use std::path::Path;
use std::process::Command;

/// Step lengths of real-time hosts, s.
const STEPS: [f64; 4] = [FINEST, 0.5e-3, 1e-3, 2e-3];
const FINEST: f64 = 0.25e-3;

/// Returns every second test of the matrix above 1.5 Hz, including the fastest test. Slower tests are accurate at any
/// of these steps.
fn matrix() -> Vec<Sine> {
    let all = Matrix::default();
    let fast = all.points().iter().filter(|p| p.frequency_hz > 1.5).rev().step_by(2);
    fast.map(|p| Sine { amplitude: p.amplitude_m, frequency: p.frequency_hz }).collect()
}

fn doubles(bytes: &[u8]) -> Vec<f64> {
    bytes.chunks_exact(8).map(|b| f64::from_le_bytes(b.try_into().expect("eight bytes"))).collect()
}

/// Returns the forces of the bridge, N, tension positive, for several tests with the step `dt`, s. Each test starts
/// from its own equilibrium.
fn through_the_bridge(program: &Path, model: &Path, tests: &[(Sine, usize)], dt: f64) -> Vec<Vec<f64>> {
    let folder = model.parent().expect("a folder");
    let mut requests: Vec<u8> = Vec::new();
    for (sine, steps) in tests {
        let motion = sine.motion();
        for k in 0..=*steps {
            let (x, v) = motion.evaluate(k as f64 * dt);
            let host = [if k == 0 { -1.0 } else { dt }, -x, -v];
            requests.extend(host.iter().flat_map(|n| n.to_le_bytes()));
        }
    }
    std::fs::write(folder.join("requests"), requests).expect("a file");
    let mut bridge = Command::new(program);
    bridge.arg(model).stdin(File::open(folder.join("requests")).expect("the requests"));
    bridge.stdout(File::create(folder.join("answers")).expect("a file"));
    assert!(bridge.status().expect("the host runs").success());
    let answers = doubles(&std::fs::read(folder.join("answers")).expect("the answers"));
    let mut all = answers.chunks_exact(3).map(|answer| -answer[0]);
    tests.iter().map(|(_, steps)| all.by_ref().take(steps + 1).collect()).collect()
}

/// Returns the largest rms and maximum errors of a model over all tests at each host step, relative to the largest
/// force of the test.
fn measured(program: &Path, text: &str, tests: &[Sine]) -> Vec<Errors> {
    let folder = tempfile::tempdir().expect("a directory");
    let file = folder.path().join("model.toml");
    std::fs::write(&file, text).expect("a model file");
    let mut params = Params::new();
    model_file::read(text.as_bytes(), &mut params).expect("the model file");
    let model = Model::new(&params).expect("a model");
    let references = References::solve(&model, tests, FINEST);
    STEPS
        .iter()
        .map(|dt| {
            let every = (dt / FINEST).round() as usize;
            let exact: Vec<(Sine, Vec<f64>)> =
                references.forces().map(|(sine, f)| (sine, f.iter().copied().step_by(every).collect())).collect();
            let asked: Vec<(Sine, usize)> = exact.iter().map(|(sine, f)| (*sine, f.len() - 1)).collect();
            let got = through_the_bridge(program, &file, &asked, *dt);
            let of_each: Vec<(Sine, Errors)> =
                got.iter().zip(&exact).map(|(f, (sine, e))| (*sine, errors(f, e))).collect();
            worst(&of_each)
        })
        .collect()
}

/// Elements in addition to FV curve and series spring, and further lines of the model file. Cavitation is excluded,
/// because the steps of the reference solution (Radau method) do not resolve the impact of a closing void. The kernel's
/// own tests cover cavitation.
const MODELS: [(&str, &str); 19] = [
    ("parallel_spring\", \"stribeck_friction\", \"viscous_friction\", \"gas_preload", ""),
    ("gas_preload", "series_stiffness = 1e7\ninternal_mass = 0.1"),
    ("gas_preload", "series_stiffness = 5e7\ninternal_mass = 0.1"),
    ("gas_preload", "series_stiffness = 1e8\ninternal_mass = 0.5"),
    ("gas_preload", "series_stiffness = 9.6e7\ninternal_mass = 0.5"),
    ("gas_preload", "series_stiffness = 1e8\ninternal_mass = 2"),
    ("gas_preload", "series_stiffness = 3e7\ninternal_mass = 2"),
    ("gas_preload", "series_stiffness = 1e8\ninternal_mass = 0.05\nseries_damping = 0"),
    ("gas_preload", "series_stiffness = 5e5\nseries_damping = 1000\ninternal_mass = 2"),
    ("oil_compressibility", ""),
    ("oil_compressibility\", \"valve_hysteresis", "series_stiffness = 3e7\ninternal_mass = 0.1"),
    ("valve_hysteresis", ""),
    ("frequency_selective_damping", ""),
    ("frequency_selective_damping", "fsd_form = \"stroke\""),
    ("presliding_friction\", \"gas_spring\", \"gas_preload", ""),
    ("bushing", "series_stiffness = 3e7\ninternal_mass = 0.1"),
    ("oil_compressibility\", \"aeration", ""),
    ("free_play", ""),
    ("moving_mass", ""),
];

/// Checks that the accuracy that the kernel guarantees at 1 ms holds at every host step. The error relative to the
/// largest force is below 0.1 % rms and 1 % at most.
#[test]
fn every_host_step_is_as_exact_as_the_kernels_table_says() {
    let folder = tempfile::tempdir().expect("a directory");
    let program = bridge_host("serve.c", &["-O2"], folder.path());
    let (tests, mut missed) = (matrix(), Vec::new());
    for (elements, more) in MODELS {
        let name = format!("{elements} {more}").replace(['"', '\n'], " ");
        let text = format!("format = 1\nelements = [\"fv_curve\", \"series_compliance\", \"{elements}\"]\n{more}\n");
        print!("{name}:");
        for (dt, worst) in STEPS.iter().zip(measured(&program, &text, &tests)) {
            print!("  {} ms {:.4} {:.4} %", 1e3 * dt, 100.0 * worst.rms, 100.0 * worst.largest);
            if worst.rms > 1e-3 || worst.largest > 1e-2 {
                missed.push(format!("{name} at {dt} s: {worst:?}"));
            }
        }
        println!();
    }
    assert!(missed.is_empty(), "{missed:#?}");
}
