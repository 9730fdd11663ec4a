//! Tests of parameters that a host sets one after the other, so that the set of parameters may be inconsistent in
//! between.
//!
//! The test checks the FMU's reaction to an inconsistent set, in a host that receives every status and message.

use dashpot_tests::fmu::exported;
use dashpot_tests::library::{root, succeed};
use dashpot_tests::python::{has_python, python};
use std::process::Command;

const MODEL: &str = "format = 1\nelements = [\"fv_curve\", \"series_compliance\", \"stribeck_friction\", \"gas_preload\"]\n\
                     fv_velocity = [-1.0, -0.1, 0.0, 0.1, 1.0]\nfv_force = [-600.0, -250.0, 0.0, 400.0, 1300.0]\n";

fn is_tuned(fmi: &str, four: bool) {
    if !has_python() {
        return;
    }
    let folder = tempfile::tempdir().expect("a directory");
    exported(folder.path(), MODEL, fmi, four, &["--no-sources"]);
    let mut host = Command::new(python());
    host.arg(root().join("tests/hosts/fmu_tuned.py")).arg(folder.path().join("damper.fmu"));
    succeed(host.current_dir(folder.path()));
}

dashpot_tests::each_fmu!(is_tuned);
