//! Tests of the MEX function in GNU Octave: the example must give the forces of the kernel.

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
        // Octave's sine function may differ from Rust's in the last digit.
        assert!((force - answer.force).abs() < 1e-6 * peak, "sample {k}: {force} {}", answer.force);
    }
    over_a_setting(at);
}

/// Compares two runs of the example's adjustable damper: with the current as one number, and with one number per
/// sample.
fn over_a_setting(at: &std::path::Path) {
    let text = std::fs::read_to_string(root().join("examples/semi_active.toml")).expect("the example");
    std::fs::write(at.join("family.toml"), &text).expect("a model file");
    let script = "t = (0:400)' * 1e-3; w = 2 * pi * 5; x = 0.01 * (1 - cos(w * t)); v = 0.01 * w * sin(w * t);\n\
                  a = dashpot_step('family.toml', x, v, 1e-3, 0.8);\n\
                  b = dashpot_step('family.toml', x, v, 1e-3, 0.8 * (t < 0.2) + 1.6 * (t >= 0.2));\n\
                  printf('%.17g %.17g\\n', [a, b]');\n\
                  try, dashpot_step('family.toml', x, v, 1e-3, [1 2]); catch e, printf('%s\\n', e.message); end\n";
    std::fs::write(at.join("over.m"), script).expect("a script");
    let ran = Command::new("octave-cli").current_dir(at).args(["-qf", "over.m"]).output().expect("octave-cli runs");
    let told = String::from_utf8_lossy(&ran.stdout).into_owned();
    let rows: Vec<[f64; 2]> = told
        .lines()
        .filter_map(|line| {
            let mut numbers = line.split(' ').map(|number| number.parse().ok());
            Some([numbers.next()??, numbers.next()??])
        })
        .collect();
    assert_eq!(rows.len(), 401, "{told}{}", String::from_utf8_lossy(&ran.stderr));
    assert!(told.contains("one for every sample"), "{told}");
    let file = dashpot_identification::model_file::family_of_text(&text, "family.toml".as_ref()).expect("a family");
    let model = Model::new(&file.definition().params_at(0.8)).expect("a model");
    let mut state = model.steady_state(&Input::motion(0.0, 0.0));
    let peak = rows.iter().fold(0.0_f64, |peak, row| peak.max(row[0].abs()));
    let w = std::f64::consts::TAU * 5.0;
    for (k, [constant, stepped]) in rows.iter().enumerate().skip(1) {
        let t = k as f64 * 1e-3;
        let input = Input::motion(0.01 * (1.0 - (w * t).cos()), 0.01 * w * (w * t).sin());
        let (next, answer) = step(&model, &state, &input, 1e-3);
        state = next;
        // The integration method of a family may differ from that of an ordinary damper. The resulting difference is
        // 0.03 N at 1 ms, and a twentieth of this value at 0.1 ms.
        assert!((constant - answer.force).abs() < 2e-4 * peak, "sample {k}: {constant} {}", answer.force);
        assert!(k >= 200 || constant == stepped, "sample {k}");
    }
    assert!(rows[220..].iter().any(|[constant, stepped]| (constant - stepped).abs() > 0.1 * peak));
}
