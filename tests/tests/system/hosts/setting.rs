//! Tests of an adjustable damper in host programs: the examples `skyhook.c` and `skyhook.py`, and their control loop
//! through an FMU.

use dashpot_test_support::skipped;
use dashpot_tests::cli::program;
use dashpot_tests::library::{Language, Linkage, directory, host, root, shared, succeed};
use std::path::Path;
use std::process::Command;

fn model() -> std::path::PathBuf {
    root().join("examples/semi_active.toml")
}

/// Returns the numbers after `word` in the lines that begin with `line`.
fn numbers(text: &str, line: &str, word: &str) -> Vec<f64> {
    let lines = text.lines().filter(|row| row.starts_with(line));
    let behind = lines.filter_map(|row| row.split(word).nth(1)?.split_whitespace().next()?.parse().ok());
    behind.collect()
}

#[test]
fn a_skyhook_controller_is_calmer_than_the_damper_at_a_constant_setting_in_c_and_in_python() {
    let folder = tempfile::tempdir().expect("a directory");
    let source = root().join("examples/skyhook.c");
    let program =
        host(source.to_str().expect("a path in UTF-8"), Language::C, Linkage::Static, &["-lm"], folder.path());
    let four = succeed(Command::new(&program).arg(model()).arg("4"));
    let rms = |way: &str| numbers(&four, way, "acceleration");
    let [soft, start, sky] = ["soft", "start", "skyhook"].map(rms);
    assert!(sky.len() == 4 && soft.len() == 4 && start.len() == 4, "{four}");
    for corner in 0..4 {
        assert!(sky[corner] < soft[corner] && sky[corner] < 0.85 * start[corner], "{four}");
    }
    let tire = |way: &str| numbers(&four, way, "tire");
    assert!(tire("skyhook").iter().zip(tire("soft")).all(|(sky, soft)| *sky < soft), "{four}");
    // The output for one corner equals that of the first of four corners. The output of the Python example equals that
    // of the C example.
    let one = succeed(Command::new(&program).arg(model()).arg("1"));
    assert!(four.contains(one.lines().next().expect("a line")), "{one} {four}");
    let script = root().join("examples/skyhook.py");
    if Command::new("python3").arg("--version").output().is_err() {
        skipped("python3");
        return;
    }
    // The comparison covers whole lines of all corners: acceleration, its spectrum in bands, and tire deflection.
    for (corners, of_c) in [("1", &one), ("4", &four)] {
        let python = succeed(Command::new("python3").arg(&script).arg(shared()).arg(model()).arg(corners));
        assert_eq!(&python, of_c);
    }
}

#[test]
fn the_same_loop_through_an_fmu_gives_the_same_numbers() {
    if Command::new("python3").arg("--version").output().is_err() {
        skipped("python3");
        return;
    }
    let folder = tempfile::tempdir().expect("a directory");
    let library = directory().join("libdashpot.a");
    let export = |name: &str, options: &[&str]| {
        let fmu = folder.path().join(name);
        let mut export = Command::new(program());
        export.args(["export", "fmu"]).arg(model()).arg("-o").arg(&fmu).arg("--from-source").arg("--library");
        succeed(export.arg(&library).args(options));
        fmu
    };
    let fmus = [export("fmi_2.fmu", &[]), export("fmi_3.fmu", &["--fmi", "3"]), export("vehicle.fmu", &["--four"])];
    let script: &Path = &root().join("tests/hosts/setting_fmu.py");
    let told = succeed(Command::new("python3").arg(script).arg(shared()).arg(model()).args(fmus));
    assert!(told.contains("the same to the bit"), "{told}");
}
