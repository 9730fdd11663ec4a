//! Tests of an exported FMU in co-simulation hosts other than FMPy.
//!
//! The hosts are libcosim of the Open Simulation Platform, which uses the FMI Library, and Ecos, which has its own FMI
//! library. The force of every step must equal that of the C library `libdashpot`.

use dashpot_tests::fmu::exported;
use dashpot_tests::library::{directory, root};
use dashpot_tests::python::python_with;
use std::process::Command;

const MODEL: &str =
    "format = 1\nelements = [\"fv_curve\", \"series_compliance\", \"presliding_friction\", \"gas_spring\"]\n";

/// Runs three motions of an FMU in the host that `script` starts. The forces must equal those of the C library. Returns
/// the host's messages.
fn the_force_is_that_of_the_library(packages: &str, script: &str, fmi: &str) -> Option<String> {
    let python = python_with(packages)?;
    let at = tempfile::tempdir().expect("a directory");
    exported(at.path(), MODEL, fmi, false, &["--no-sources"]);
    let library = directory().join("libdashpot.so");
    let mut host = Command::new(python);
    host.arg(root().join("tests/hosts").join(script)).args([
        "damper.fmu".as_ref(),
        library.as_os_str(),
        "model.toml".as_ref(),
    ]);
    let ran = host.current_dir(at.path()).output().expect("a process");
    let (out, err) = (String::from_utf8_lossy(&ran.stdout), String::from_utf8_lossy(&ran.stderr));
    assert!(ran.status.success(), "{out}{err}");
    assert_eq!(out.matches("largest difference").count(), 3, "{out}");
    Some(format!("{out}{err}"))
}

#[test]
fn the_force_in_libcosim_is_that_of_the_library() {
    let Some(said) = the_force_is_that_of_the_library("libcosimpy==0.0.6", "cosim.py", "2") else { return };
    // The host prints errors that it finds in the FMU and continues, so its output is searched for them.
    assert_eq!(said.lines().find(|line| line.contains("[error]")), None);
}

#[test]
fn the_force_in_ecos_is_that_of_the_library() {
    for fmi in ["2", "3"] {
        let Some(said) = the_force_is_that_of_the_library("ecospy==0.7.2 tbb==2023.2.0", "ecos.py", fmi) else {
            return;
        };
        println!("FMI {fmi} in Ecos\n{said}");
        assert_eq!(said.lines().find(|line| line.contains("[error]")), None);
    }
}
