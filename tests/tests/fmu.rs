//! The FMU in a host that nobody here wrote: FMPy validates and runs all four kinds, with one corner and with four.

use dashpot_tests::bridge::{MODEL, bridge_host, map};
use dashpot_tests::cli::{done, refused};
use dashpot_tests::library::{directory, root, succeed};
use dashpot_tests::python::python;
use std::process::Command;

fn runs(fmi: &str, corners: &str) {
    let folder = tempfile::tempdir().expect("a directory");
    let at = folder.path();
    // The static library beside the command.
    directory();
    std::fs::write(at.join("model.toml"), MODEL).expect("a model file");
    let mut export = vec!["export", "fmu", "model.toml", "-o", "damper.fmu", "--fmi", fmi];
    if corners == "4" {
        export.push("--four");
    }
    done(at, &export);
    let first = std::fs::read(at.join("damper.fmu")).expect("the FMU");
    done(at, &export);
    assert!(std::fs::read(at.join("damper.fmu")).expect("the FMU") == first, "the same model gives the same bytes");

    let bridge = bridge_host("bridge.c", &[], at);
    let trace = succeed(Command::new(bridge).arg(at.join("model.toml")).arg(map(at)).arg(corners));
    std::fs::write(at.join("trace.txt"), trace).expect("a file");
    let mut host = Command::new(python());
    host.arg(root().join("tests/hosts/fmu.py")).arg(at.join("damper.fmu")).arg(at.join("trace.txt"));
    print!("{}", succeed(host.current_dir(at)));
}

#[test]
fn fmi_2_one_corner() {
    runs("2", "1");
}

#[test]
fn fmi_2_four_corners() {
    runs("2", "4");
}

#[test]
fn fmi_3_one_corner() {
    runs("3", "1");
}

#[test]
fn fmi_3_four_corners() {
    runs("3", "4");
}

#[test]
fn export_refuses_in_words() {
    let folder = tempfile::tempdir().expect("a directory");
    let at = folder.path();
    std::fs::write(at.join("model.toml"), MODEL).expect("a model file");
    std::fs::write(at.join("broken.toml"), "format = 1\nelements = [\"fv_curve\"]\ngas_forse = 3\n").expect("a file");
    let three = ["export", "fmu", "model.toml", "model.toml", "model.toml", "-o", "x.fmu"];
    assert!(refused(at, &three).contains("one model file, two"));
    assert!(refused(at, &["export", "fmu", "broken.toml", "-o", "x.fmu"]).contains("gas_forse"));
    let zero = ["export", "fmu", "model.toml", "-o", "x.fmu", "--motion-scale", "0"];
    assert!(refused(at, &zero).contains("--motion-scale"));
    let library = ["export", "fmu", "model.toml", "-o", "x.fmu", "--library", "none.a"];
    assert!(refused(at, &library).contains("none.a"));
}
