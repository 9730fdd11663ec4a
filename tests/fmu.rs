//! Functions that export FMUs (Functional Mock-up Units) for tests.

use crate::cli::{build_program, done, program, run};
use crate::library::{directory, root, succeed};
use std::path::Path;
use std::process::Command;
use std::sync::OnceLock;

/// Ensures that the program `dashpot` contains the FMU runtime and the Adams library.
///
/// If the program lacks them, they are compiled and the program is rebuilt.
pub fn runtimes() {
    static HELD: OnceLock<()> = OnceLock::new();
    HELD.get_or_init(|| {
        let at = tempfile::tempdir().expect("a directory");
        std::fs::write(at.path().join("m.toml"), "format = 1\nelements = [\"fv_curve\"]\n").expect("a model file");
        let export = ["export", "fmu", "m.toml", "-o", "m.fmu"];
        let ran = run(at.path(), &export);
        let holds_none = ran.err.contains("holds no compiled FMU runtime") || ran.err.contains("holds no FMU runtime");
        if ran.code == Some(0) && !holds_none {
            return;
        }
        assert!(holds_none, "{}", ran.err);
        succeed(Command::new("sh").arg(root().join("vi-crt-bridge/runtimes.sh")).env(
            "DASHPOT_RUNTIMES",
            // The path of the program is target/<profile>/dashpot.
            program().ancestors().nth(2).expect("a target directory").join("runtimes"),
        ));
        build_program();
        done(at.path(), &export);
    });
}

/// Writes the model file `text` into the folder `at` and exports it as `damper.fmu` into this folder. The FMU has the
/// dampers of four corners if `four` is true, and otherwise of one corner.
pub fn exported(at: &Path, text: &str, fmi: &str, four: bool, more: &[&str]) {
    // If the program compiles the FMU from source, the static library must be in the folder of the program.
    directory();
    runtimes();
    std::fs::write(at.join("model.toml"), text).expect("a model file");
    let mut export = vec!["export", "fmu", "model.toml", "-o", "damper.fmu", "--fmi", fmi];
    export.extend(four.then_some("--four"));
    export.extend(more);
    done(at, &export);
}

/// Expands to one test per kind of FMU: FMI 2 and FMI 3, each with one corner and with four corners.
#[macro_export]
macro_rules! each_fmu {
    ($runs:ident) => {
        #[test]
        fn fmi_2_one_corner() {
            $runs("2", false);
        }

        #[test]
        fn fmi_2_four_corners() {
            $runs("2", true);
        }

        #[test]
        fn fmi_3_one_corner() {
            $runs("3", false);
        }

        #[test]
        fn fmi_3_four_corners() {
            $runs("3", true);
        }
    };
}
