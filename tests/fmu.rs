//! FMUs that tests export.

use crate::cli::done;
use crate::library::directory;
use std::path::Path;

/// Exports `damper.fmu` of one corner or four of a model, beside its model file.
pub fn exported(at: &Path, text: &str, fmi: &str, four: bool, more: &[&str]) {
    // The static library beside the command.
    directory();
    std::fs::write(at.join("model.toml"), text).expect("a model file");
    let mut export = vec!["export", "fmu", "model.toml", "-o", "damper.fmu", "--fmi", fmi];
    export.extend(four.then_some("--four"));
    export.extend(more);
    done(at, &export);
}

/// One test of each kind of FMU: both versions of FMI, with one corner and with four.
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
