//! Tests of model exchange FMUs in a common solver, CVODE, with its default options.
//!
//! FMPy with CVODE sets the inputs at the ends of its steps and keeps them constant in between. Nevertheless, the error
//! of the force must stay below 1 % of the largest force.

use dashpot_core::parameter::{ELEMENTS, GROUPS};
use dashpot_tests::fmu::exported;
use dashpot_tests::library::{root, succeed};
use dashpot_tests::python::{has_python, python};
use std::process::Command;

/// Model file with the elements and the relevant parameters that `dashpot demo` identifies: a steep dry friction and a
/// soft series spring.
const DEMO: &str = "format = 1\nelements = [\"fv_curve\", \"series_compliance\", \"parallel_spring\", \"coulomb_friction\", \"gas_preload\"]\n\
    fv_form = \"table\"\nfv_velocity = [-1.57, -0.95, -0.57, -0.34, -0.21, -0.125, -0.0756, -0.0456, -0.0275, -0.0166, -0.01, 0, 0.01, \
    0.0166, 0.0275, 0.0456, 0.0756, 0.125, 0.21, 0.34, 0.57, 0.95, 1.57]\nfv_force = [-1627, -1134, -854, -673, -553, -461, -381, -249, \
    -107, -46, -14, 0, 13, 42, 109, 263, 598, 854, 1055, 1328, 1726, 2363, 3534]\nseries_stiffness = 4.15e6\ninternal_mass = 0.05\n\
    spring_linear = 359\ncoulomb_force = 44\ncoulomb_steepness = 13208\ngas_force = 152\n";

/// FMU of one comparison: name, text of the model file, FMI version, and tests as amplitude, m, and frequency, Hz.
type Fmu<'a> = (&'a str, &'a str, &'a str, &'a [&'a str]);

/// Compares FMUs within one process of Python, whose start with FMPy takes longer than a comparison.
fn within_one_percent(fmus: &[Fmu<'_>]) {
    let folder = tempfile::tempdir().expect("a directory");
    let mut host = Command::new(python());
    host.arg(root().join("tests/hosts/fmu_solvers.py")).arg("1");
    for (name, text, fmi, tests) in fmus {
        exported(folder.path(), text, fmi, false, &["--no-sources"]);
        let file = format!("{name} in FMI {fmi}.fmu");
        std::fs::rename(folder.path().join("damper.fmu"), folder.path().join(&file)).expect("renamed");
        host.arg(file).args(*tests);
    }
    println!("{}", succeed(host.current_dir(folder.path())));
}

/// Extreme tests of the rig matrix, as amplitude, m, and frequency, Hz.
const EDGES: [&str; 4] = ["0.05:0.3", "0.03:5.6", "0.005:20", "0.001:2"];

#[test]
fn the_damper_of_the_demo() {
    if !has_python() {
        return;
    }
    within_one_percent(&["2", "3"].map(|fmi| ("demo", DEMO, fmi, &EDGES[..])));
}

/// Checks a damper with each element in addition to FV curve, series spring and gas preload.
#[test]
fn every_element() {
    if !has_python() {
        return;
    }
    let text = |name: &str| {
        let mut on = vec!["fv_curve", "series_compliance", "gas_preload"];
        if !on.contains(&name) {
            on.push(name);
        }
        format!("format = 1\nelements = {on:?}\n")
    };
    let texts: Vec<(&str, String)> = GROUPS[..ELEMENTS].iter().map(|group| (group.name, text(group.name))).collect();
    let mut fmus: Vec<Fmu<'_>> = Vec::new();
    for (i, (name, text)) in texts.iter().enumerate() {
        // The FMI version alternates between elements. One version for each element suffices, because the solver calls
        // the same functions in both versions.
        let fmi = if i % 2 == 0 { "2" } else { "3" };
        // The motion has a long stroke, or a short and fast stroke, alternately for each FMI version.
        fmus.push((name, text, fmi, if i / 2 % 2 == 0 { &["0.03:5.6"] } else { &["0.002:12"] }));
    }
    within_one_percent(&fmus);
}

/// Checks a damper whose setting moves during the run. Hosts keep the setting constant between two points at which they set it. The
/// co-simulation with which the test compares also keeps the setting constant between these points.
#[test]
fn a_setting_that_moves() {
    if !has_python() {
        return;
    }
    let model = std::fs::read_to_string(root().join("examples/semi_active.toml")).expect("a model file");
    // In model exchange, the input of the FMU is the command after the dead time. The model of the comparison therefore has no dead time.
    let text = model.replace("setting_dead_time = 0.003", "setting_dead_time = 0.0");
    assert_ne!(text, model);
    let direct = text.replace("setting_time_", "# setting_time_").replace("setting_hysteresis", "# setting_hysteresis");
    let tests = ["0.03:1.5:0:1.6", "0.002:12:0.2:1.4"];
    let fmus = [("with an actuator", &text), ("without an actuator", &direct)];
    let each = fmus.into_iter().flat_map(|(name, text)| ["2", "3"].map(|fmi| (name, text.as_str(), fmi, &tests[..])));
    within_one_percent(&each.collect::<Vec<_>>());
}
