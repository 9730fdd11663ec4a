//! Tests of directional derivatives of an FMU whose dampers have internal states, compared with finite differences in
//! FMPy.

use dashpot_tests::cli::done;
use dashpot_tests::fmu::runtimes;
use dashpot_tests::library::{root, succeed};
use dashpot_tests::python::{has_python, python};
use std::process::Command;

/// Elements in addition to FV curve and series spring, further lines of the model file, and the number of internal
/// states.
const DAMPERS: [(&str, &str, u32); 16] = [
    ("oil_compressibility", "", 1),
    ("valve_hysteresis", "", 1),
    ("frequency_selective_damping", "", 1),
    ("frequency_selective_damping", "fsd_form = \"stroke\"", 1),
    ("presliding_friction", "", 1),
    ("gas_spring", "", 1),
    ("bushing", "", 1),
    ("oil_compressibility\", \"aeration", "", 1),
    ("lagged_polynomial", "polynomial = [0.0, 400.0, 0.0, 30.0]", 1),
    ("moving_mass", "", 1),
    ("temperature_fade", "fade_source = \"self_heating\"", 1),
    ("position_dependent_damping", "", 0),
    ("oil_compressibility\", \"valve_hysteresis\", \"bushing\", \"frequency_selective_damping", "", 4),
    ("bump_stop\", \"rebound_stop", "bump_stop_clearance = 0.02\nrebound_stop_clearance = 0.02", 0),
    ("free_play", "", 0),
    ("stribeck_friction\", \"viscous_friction\", \"parallel_spring", "spring_quadratic = 20000", 0),
];

fn derivatives(fmi: &str) {
    if !has_python() {
        return;
    }
    let folder = tempfile::tempdir().expect("a directory");
    let at = folder.path();
    runtimes();
    for four in DAMPERS.chunks_exact(4) {
        let names = ["l1.toml", "r1.toml", "l2.toml", "r2.toml"];
        for ((elements, more, _), name) in four.iter().zip(names) {
            let text =
                format!("format = 1\nelements = [\"fv_curve\", \"series_compliance\", \"{elements}\"]\n{more}\n");
            std::fs::write(at.join(name), text).expect("a model file");
        }
        let mut export = vec!["export", "fmu"];
        export.extend(names);
        export.extend(["-o", "car.fmu", "--fmi", fmi]);
        done(at, &export);
        let mut host = Command::new(python());
        host.arg(root().join("tests/hosts/fmu_partials.py")).arg(at.join("car.fmu"));
        let told = succeed(host.current_dir(at));
        print!("{told}");
        for (line, (elements, _, states)) in told.lines().zip(four) {
            let moved: u32 = line.split(' ').nth(1).expect("a number").parse().expect("a number");
            assert_eq!(moved, *states, "private states of {elements} that moved: a test that sees none tests none");
        }
    }
}

#[test]
fn of_fmi_2() {
    derivatives("2");
}

#[test]
fn of_fmi_3() {
    derivatives("3");
}
