//! Tests that the example C program (`examples/damper.c`) gives the forces of the kernel, and reports errors in an
//! invalid model file.

use dashpot_core::number;
use dashpot_core::{Input, Model, Params, step};
use dashpot_identification::model_file::flat;
use dashpot_tests::library;
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

/// Compiles the example as a user does, and returns the path of the program.
fn example(folder: &Path) -> PathBuf {
    let source = library::root().join("examples/damper.c");
    library::host(source.to_str().unwrap(), library::Language::C, library::Linkage::Static, &[], folder)
}

fn run(program: &Path, model: &Path, input: &str) -> Output {
    let mut child = Command::new(program)
        .arg(model)
        .args(["0.001", "-0.02"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    // A program that rejects its model file exits before it reads.
    let _ = child.stdin.take().unwrap().write_all(input.as_bytes());
    child.wait_with_output().unwrap()
}

#[test]
fn the_example_gives_the_kernels_forces() {
    let folder = tempfile::tempdir().unwrap();
    let program = example(folder.path());
    let mut params = Params::new();
    params.set(number!("gas_force"), 123.4).unwrap();
    params.set(number!("series_stiffness"), 4.1e6).unwrap();
    let file = folder.path().join("damper.toml");
    std::fs::write(&file, flat(&params, |_| String::new())).unwrap();

    let velocities: Vec<f64> = (0..500).map(|i| 0.6 * (0.05 * f64::from(i)).sin()).collect();
    let text: String = velocities.iter().map(|v| format!("{v:?}\n")).collect();
    let out = run(&program, &file, &text);
    assert!(out.status.success(), "{}", String::from_utf8_lossy(&out.stderr));
    let got: Vec<f64> = String::from_utf8(out.stdout).unwrap().lines().map(|l| l.parse().unwrap()).collect();

    let model = Model::new(&params).unwrap();
    let mut state = model.steady_state(&Input::motion(-0.02, 0.0));
    let want: Vec<f64> = velocities
        .iter()
        .map(|v| {
            let (next, output) = step(&model, &state, &Input::velocity(*v), 1e-3);
            state = next;
            output.force
        })
        .collect();
    assert_eq!(got, want);
}

#[test]
fn a_bad_model_file_is_named_with_its_line() {
    let folder = tempfile::tempdir().unwrap();
    let program = example(folder.path());
    let file = folder.path().join("damper.toml");
    std::fs::write(&file, "format = 1\nelements = []\ngas_force = 1e9\n").unwrap();
    let out = run(&program, &file, "0.1\n");
    let words = String::from_utf8_lossy(&out.stderr).into_owned();
    assert!(!out.status.success() && words.contains("line 3") && words.contains("gas_force"), "{words}");
    assert!(out.stdout.is_empty());
}
