//! The MEX function in GNU Octave: the example runs and gives the kernel's forces.

use dashpot_core::{Input, Model, Params, model_file, step};
use dashpot_test_support::skipped;
use dashpot_tests::bridge::MODEL;
use dashpot_tests::library::{root, static_library};
use std::process::{Command, Stdio};

#[test]
fn the_example_gives_the_kernels_forces() {
    if Command::new("mkoctfile").arg("--version").stdout(Stdio::null()).status().is_err() {
        skipped("needs GNU Octave; .ci/run installs it by apt-get install octave octave-dev");
        return;
    }
    let folder = tempfile::tempdir().expect("a directory");
    let at = folder.path();
    let bridge = root().join("vi-crt-bridge");
    std::fs::write(at.join("damper.toml"), MODEL).expect("a model file");
    std::fs::copy(bridge.join("octave/rig_test.m"), at.join("rig_test.m")).expect("the example");
    let built = Command::new("mkoctfile")
        .current_dir(at)
        .arg("--mex")
        .arg(format!("-I{}", root().join("include").display()))
        .arg(format!("-I{}", bridge.join("bridge").display()))
        .args([bridge.join("octave/dashpot_step.c"), bridge.join("bridge/corner.c"), static_library()])
        .output()
        .expect("mkoctfile runs");
    assert!(built.status.success(), "{}", String::from_utf8_lossy(&built.stderr));
    let ran = Command::new("octave-cli").current_dir(at).args(["-qf", "rig_test.m"]).output().expect("octave-cli runs");
    let told = String::from_utf8_lossy(&ran.stdout).into_owned();
    let forces: Vec<f64> = told.lines().map(|line| line.parse().expect("a force")).collect();
    assert_eq!(forces.len(), 501, "{told}{}", String::from_utf8_lossy(&ran.stderr));

    let mut params = Params::new();
    model_file::read(MODEL.as_bytes(), &mut params).expect("the model file");
    let model = Model::new(&params).expect("a model");
    let mut state = model.steady_state(&Input::motion(0.0, 0.0));
    let peak = forces.iter().fold(0.0_f64, |m, f| m.max(f.abs()));
    assert!(peak > 100.0, "{peak}");
    let w = std::f64::consts::TAU * 12.0;
    for (k, force) in forces.iter().enumerate().skip(1) {
        let t = k as f64 * 1e-3;
        let input = Input::motion(0.002 * (1.0 - (w * t).cos()), 0.002 * w * (w * t).sin());
        let (next, answer) = step(&model, &state, &input, 1e-3);
        state = next;
        // Octave's sine may differ in the last digit.
        assert!((force - answer.force).abs() < 1e-6 * peak, "sample {k}: {force} {}", answer.force);
    }
}
