//! An exported FMU in libcosim, the co-simulation host of the Open Simulation Platform, which is built on the FMI Library: the force of every
//! step is that of the library itself.

use dashpot_tests::fmu::exported;
use dashpot_tests::library::{directory, root};
use dashpot_tests::python::python_with;
use std::process::Command;

const MODEL: &str =
    "format = 1\nelements = [\"fv_curve\", \"series_compliance\", \"presliding_friction\", \"gas_spring\"]\n";

#[test]
fn the_force_in_libcosim_is_that_of_the_library() {
    let Some(python) = python_with("libcosimpy==0.0.6") else { return };
    let at = tempfile::tempdir().expect("a directory");
    exported(at.path(), MODEL, "2", false, &["--no-sources"]);
    let library = directory().join("libdashpot.so");
    let mut host = Command::new(python);
    host.arg(root().join("tests/hosts/cosim.py")).args([
        "damper.fmu".as_ref(),
        library.as_os_str(),
        "model.toml".as_ref(),
    ]);
    let ran = host.current_dir(at.path()).output().expect("a process");
    let (out, err) = (String::from_utf8_lossy(&ran.stdout), String::from_utf8_lossy(&ran.stderr));
    assert!(ran.status.success(), "{out}{err}");
    assert_eq!(out.matches("largest difference").count(), 3, "{out}");
    // It tells what it finds wrong with the page of an FMU, and goes on.
    let complaint = err.lines().chain(out.lines()).find(|line| line.contains("[error]"));
    assert_eq!(complaint, None);
}
