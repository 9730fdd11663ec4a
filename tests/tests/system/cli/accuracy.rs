//! Tests the accuracy of models that are fitted to records of the virtual rig, whose equations differ from those of the
//! model. The fit uses half of the tests, the comparison uses all tests.

use dashpot_tests::cli::{done, json, number};
use serde_json::Value;
use std::path::Path;

/// Limits of the mean error in percent of each test's largest force. [`LARGE_STROKES`] applies to the tests of each
/// amplitude from 15 mm up. [`ONE_MILLIMETRE`] applies to the tests of 1 mm, and [`SLOW`] to slow tests.
const LARGE_STROKES: f64 = 1.5;
const ONE_MILLIMETRE: f64 = 5.0;
const SLOW: f64 = 10.0;

/// Fits the records of a folder without every second test, and compares the model with all tests.
fn half_fitted(dir: &Path) -> Value {
    let mut names: Vec<String> = std::fs::read_dir(dir.join("records"))
        .unwrap()
        .map(|e| e.unwrap().path())
        .filter(|p| p.extension().is_some_and(|e| e == "csv"))
        .map(|p| p.file_stem().unwrap().to_string_lossy().into_owned())
        .collect();
    names.sort();
    let held_out: Vec<String> = names.into_iter().skip(1).step_by(2).collect();
    done(dir, &["fit", "records", "-o", "m.toml", "--hold-out", &held_out.join(",")]);
    done(dir, &["validate", "m.toml", "records", "--json", "v.json"]);
    let validation = json(&dir.join("v.json"));
    let tests = validation["tests"].as_array().unwrap();
    assert_eq!(tests.iter().filter(|t| t["used_in_fit"] == false).count(), held_out.len());
    validation
}

/// Averages the relative error of the tests that `choose` selects, percent.
fn mean(validation: &Value, choose: impl Fn(&Value) -> bool) -> f64 {
    let chosen: Vec<f64> = validation["tests"]
        .as_array()
        .unwrap()
        .iter()
        .filter(|t| choose(t))
        .map(|t| number(t, "error_percent"))
        .collect();
    assert!(!chosen.is_empty());
    chosen.iter().sum::<f64>() / chosen.len() as f64
}

fn within_limits(validation: &Value) {
    let slow = |t: &Value| number(t, "peak_velocity_m_s") < 6e-3;
    let stroke = |t: &Value, mm: f64| !slow(t) && (number(t, "amplitude_m") - 1e-3 * mm).abs() < 1e-4 * mm;
    for mm in [50.0, 40.0, 30.0, 25.0, 15.0] {
        if validation["tests"].as_array().unwrap().iter().any(|t| stroke(t, mm)) {
            let error = mean(validation, |t| stroke(t, mm));
            assert!(error <= LARGE_STROKES, "{mm} mm: {error} %");
        }
    }
    let error = mean(validation, |t| stroke(t, 1.0));
    assert!(error <= ONE_MILLIMETRE, "1 mm: {error} %");
    let error = mean(validation, slow);
    assert!(error <= SLOW, "slow: {error} %");
    for group in ["overall", "left_out"] {
        let errors = &validation[group];
        let (model, curve) = (number(errors, "error_percent"), number(&errors["fv_only"], "error_percent"));
        assert!(model < 0.5 * curve, "{group}: {model} % against {curve} % of the FV curve");
    }
}

fn campaign(seed: &str, matrix: &[&str]) {
    let folder = tempfile::tempdir().unwrap();
    let dir = folder.path();
    done(dir, &[&["matrix", "-o", "matrix.csv"], matrix].concat());
    done(dir, &["rig", "-o", "records", "--seed", seed, "--matrix", "matrix.csv"]);
    within_limits(&half_fitted(dir));
}

#[test]
fn default_damper() {
    campaign("0", &[]);
}

#[test]
#[ignore = "10 s, for the night; every run checks the default damper"]
fn second_damper() {
    campaign("1", &[]);
}

#[test]
#[ignore = "half a minute, for the night; every run checks the default damper"]
fn third_damper() {
    campaign("2", &[]);
}

#[test]
fn a_matrix_of_fewer_strokes() {
    campaign("4", &["--amplitudes", "50,25,5,1", "--peak-velocities", "52,131,262,393,524,1047"]);
}

#[test]
#[ignore = "13 s, for the night; every run follows the default damper"]
fn a_slower_rig() {
    campaign("5", &["--frequency-limit", "12"]);
}
