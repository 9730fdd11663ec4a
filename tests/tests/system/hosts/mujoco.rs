//! Tests of MuJoCo as a host: the dampers act in its passive-force callback, with steps of 1 ms.

use dashpot_tests::bridge::{MODEL, bridge_host};
use dashpot_tests::library::{root, succeed};
use dashpot_tests::python::{has_python, python};
use std::process::Command;

/// Model file with the FV curve and the gas force of [`MODEL`], without its other elements.
const CURVE: &str = "format = 1\nelements = [\"fv_curve\", \"gas_preload\"]\ngas_force = 141.5\n";

/// Runs the host program, which compares MuJoCo's quarter car with its own integration and fails if a vehicle gains
/// energy.
#[test]
fn a_quarter_car_and_a_vehicle_run_on_dashpot() {
    if !has_python() {
        return;
    }
    let directory = tempfile::tempdir().expect("a directory");
    let at = directory.path();
    std::fs::write(at.join("model.toml"), MODEL).expect("a model file");
    std::fs::write(at.join("curve.toml"), CURVE).expect("a model file");
    let find = "import mujoco, os, glob; f = os.path.dirname(mujoco.__file__); print(f); print(glob.glob(f + '/libmujoco.so*')[0])";
    let found = succeed(Command::new(python()).args(["-c", find]));
    let (folder, library) = found.trim().split_once('\n').expect("two lines");
    // The flag -isystem suppresses warnings in MuJoCo's own headers.
    let flags = [
        "-isystem".to_owned(),
        format!("{folder}/include"),
        // The sources that call the library follow later on the command line, so the linker must keep the library.
        "-Wl,--no-as-needed".to_owned(),
        library.to_owned(),
        format!("-Wl,-rpath,{folder}"),
        "-Wno-pedantic".to_owned(),
    ];
    let flags: Vec<&str> = flags.iter().map(String::as_str).collect();
    let source = root().join("vi-crt-bridge/mujoco/vehicle.c");
    let program = bridge_host(source.to_str().expect("a path in UTF-8"), &flags, at);
    let family = root().join("examples/semi_active.toml");
    let told = succeed(Command::new(program).arg(at.join("model.toml")).arg(at.join("curve.toml")).arg(family));
    print!("{told}");
    let figures: Vec<f64> = told
        .lines()
        .filter(|line| line.starts_with("vehicle"))
        .map(|l| l.split("dissipated ").nth(1).and_then(|r| r.split(' ').next()).expect("a figure").parse().expect("J"))
        .collect();
    let heave = |name: &str| -> f64 {
        let line = told.lines().find(|line| line.starts_with(&format!("semi-active, {name}"))).expect("a line");
        line.split("acceleration ")
            .nth(1)
            .and_then(|rest| rest.split(' ').next())
            .expect("a figure")
            .parse()
            .expect("m/s^2")
    };
    // The setting of the host must affect the dampers.
    assert!(heave("soft") < heave("hard") && heave("skyhook") < heave("hard"), "{told}");
    assert!(figures.len() == 2 && figures[0] != figures[1], "the model is not its curve: {told}");
}
