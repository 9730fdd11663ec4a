//! Tests of FMUs that start in motion, of inputs at the beginning of a step, and of messages on steps that are too
//! long.

use dashpot_core::model_file;
use dashpot_core::{Model, Params};
use dashpot_simulation::stiffness::{explicit_step, fastest_rate};
use dashpot_tests::cli::{done, refused};
use dashpot_tests::fmu::exported;
use dashpot_tests::library::{root, succeed};
use dashpot_tests::python::{has_python, python};
use std::process::Command;

const MODEL: &str =
    "format = 1\nelements = [\"fv_curve\", \"series_compliance\", \"gas_preload\"]\ngas_force = 120.0\n";
/// Lines of a model file for a damper so stiff that an explicit solver diverges. With a less stiff damper, the solver
/// would only oscillate.
const FAST: &str = "series_stiffness = 3e7\ninternal_mass = 0.05\n";

fn starts(fmi: &str) {
    if !has_python() {
        return;
    }
    let folder = tempfile::tempdir().expect("a directory");
    let at = folder.path();
    let text = MODEL.to_owned() + FAST;
    for inputs in ["begin", "end"] {
        exported(at, &text, fmi, false, &["--no-sources", "--inputs", inputs]);
        std::fs::rename(at.join("damper.fmu"), at.join(format!("{inputs}.fmu"))).expect("renamed");
    }
    let mut params = Params::new();
    model_file::read(text.as_bytes(), &mut params).expect("the model");
    let step = explicit_step(fastest_rate(&Model::new(&params).expect("a model")));
    let mut host = Command::new(python());
    host.arg(root().join("tests/hosts/fmu_starts.py")).args([at.join("begin.fmu"), at.join("end.fmu")]);
    print!("{}", succeed(host.arg(format!("{}", 1e6 * step)).current_dir(at)));
}

#[test]
fn of_fmi_2() {
    starts("2");
}

#[test]
fn of_fmi_3() {
    starts("3");
}

/// Checks that an export without `--inputs` mentions a delay of the force by one step. This option states when the
/// importer sets the inputs.
#[test]
fn the_delay_is_told_where_nobody_said_when_inputs_come() {
    let folder = tempfile::tempdir().expect("a directory");
    let at = folder.path();
    exported(at, MODEL, "2", false, &["--no-sources"]);
    let export = ["export", "fmu", "model.toml", "-o", "damper.fmu", "--no-sources"];
    assert!(done(at, &export).contains("one step late: export with --inputs begin"));
    for inputs in ["begin", "end"] {
        assert!(!done(at, &[&export[..], &["--inputs", inputs]].concat()).contains("one step late"));
    }
    assert!(refused(at, &[&export[..], &["--inputs", "middle"]].concat()).contains("begin"));
}
