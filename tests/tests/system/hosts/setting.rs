//! Tests of an adjustable damper in host programs.
//!
//! They are the examples `skyhook.c` and `skyhook.py`, their control loop through an FMU, and an FMU in model exchange
//! with its derivatives.

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

/// Elements, FV curve and series spring of the dampers of [`model_exchange_and_derivatives_of_a_moving_setting`].
const DAMPER: &str = "format = 1\nelements = [\"fv_curve\", \"series_compliance\", \"oil_compressibility\", \"stribeck_friction\", \"gas_preload\"]\n\
    setting = [0.0, 400.0, 800.0, 1200.0, 1600.0]\nsetting_name = \"current\"\nsetting_unit = \"mA\"\n\
    fv_velocity = [-1.5, -0.2, 0.0, 0.2, 1.5]\nfv_force = [[-700.0, -190.0, 0.0, 260.0, 1050.0], [-820.0, -280.0, 0.0, 450.0, 1400.0], \
    [-1000.0, -440.0, 0.0, 820.0, 1950.0], [-1250.0, -670.0, 0.0, 1350.0, 2700.0], [-1500.0, -870.0, 0.0, 1850.0, 3400.0]]\n\
    stribeck_coulomb_force = [35.0, 36.0, 38.0, 41.0, 45.0]\ngas_force = 90.0\nseries_stiffness = 1.5e6\ninternal_mass = 0.5\n";

/// Checks dampers with different actuators: the force in model exchange while the setting moves, and the directional derivatives.
///
/// The unit is mA, so that a difference with an absolute step is found.
#[test]
fn model_exchange_and_derivatives_of_a_moving_setting() {
    if Command::new("python3").arg("--version").output().is_err() {
        skipped("python3");
        return;
    }
    const LAGS: &str = "setting_time_up = 0.008\nsetting_time_down = 0.012\n";
    let folder = tempfile::tempdir().expect("a directory");
    let library = directory().join("libdashpot.a");
    for (name, actuator, dead_time) in [
        ("direct", String::new(), "0"),
        ("lag", LAGS.to_owned(), "0"),
        (
            "valve",
            format!(
                "{LAGS}setting_rate_up = 6e4\nsetting_rate_down = 3e4\nsetting_hysteresis = 40.0\nsetting_hysteresis_rest = 0.6\n"
            ),
            "0",
        ),
        ("late", format!("{LAGS}setting_dead_time = 0.003\n"), "0.003"),
    ] {
        let model = folder.path().join(format!("{name}.toml"));
        std::fs::write(&model, format!("{DAMPER}{actuator}")).expect("a model file");
        let fmus = ["2", "3"].map(|fmi| {
            let fmu = folder.path().join(format!("{name}_{fmi}.fmu"));
            let mut export = Command::new(program());
            export.args(["export", "fmu"]).arg(&model).arg("-o").arg(&fmu).args(["--fmi", fmi]);
            succeed(export.arg("--from-source").arg("--library").arg(&library));
            fmu
        });
        let mut host = Command::new("python3");
        host.arg(root().join("tests/hosts/setting_exchange.py")).arg(shared()).arg(&model);
        let printed = succeed(host.args([dead_time, "0", "1600"]).args(fmus));
        println!("{name}\n{printed}");
        // The derivatives with respect to the setting are not 0 inside the grid and at its ends, unless the rate limit acts. With a dead
        // time of 3 ms, the command of a step of 1 ms has no effect within this step.
        let found = numbers(&printed, "co-simulation", ": ");
        assert!(
            found.len() == 2 && found.iter().all(|n| if name == "late" { *n == 0.0 } else { *n >= 4.0 }),
            "{printed}"
        );
    }
}
