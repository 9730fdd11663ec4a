//! Tests of the source shims for CarMaker, CarSim and Simulink. The shims are compiled with this project's own
//! declarations of the host interfaces. The tests call them in the way the hosts do.

use dashpot_tests::bridge::{MODEL, bridge_host, map};
use dashpot_tests::library::{root, succeed};
use std::process::Command;

const SANITIZERS: [&str; 2] = ["-fsanitize=address,undefined", "-fno-sanitize-recover=all"];

/// Returns the model file of an adjustable damper.
fn family() -> std::path::PathBuf {
    root().join("examples/semi_active.toml")
}

fn runs(host: &str, shim: &str, defines: &[&str], map: Option<&str>) {
    let directory = tempfile::tempdir().expect("a directory");
    let model = directory.path().join("model.toml");
    std::fs::write(&model, MODEL).expect("a model file");
    let source = root().join("vi-crt-bridge").join(shim);
    let include = format!("-I{}", root().join("tests/hosts").display());
    let mut flags = vec![source.to_str().expect("a path in UTF-8"), &include];
    flags.extend(SANITIZERS);
    flags.extend(defines);
    let mut host = Command::new(bridge_host(host, &flags, directory.path()));
    host.arg(&model);
    let Some(map) = map else {
        succeed(host.arg(family()));
        return;
    };
    let map = root().join("vi-crt-bridge").join(map);
    let program = host.get_program().to_owned();
    succeed(host.arg(&map));
    // This copy of the map also names a variable of the simulator for the setting of each corner.
    let with_setting = directory.path().join("setting.toml");
    let text = std::fs::read_to_string(&map).expect("a map") + "setting = \"CURRENT_{corner}\"\n";
    std::fs::write(&with_setting, text).expect("a map");
    succeed(Command::new(program).arg(family()).arg(&map).arg(with_setting));
}

#[test]
fn carmaker_in_both_generations() {
    let header = "-DDASHPOT_CARMAKER_HEADER=\"carmaker_declarations.h\"";
    for api in ["-DDASHPOT_CARMAKER_API=13", "-DDASHPOT_CARMAKER_API=15"] {
        runs("carmaker.c", "carmaker/susp_damper.c", &[header, api], None);
    }
}

#[test]
fn carsim_in_its_own_units() {
    let header = "-DDASHPOT_VS_HEADER=\"vs_declarations.h\"";
    runs("carsim.c", "carsim/vs_damper.c", &[header], Some("maps/carsim.toml"));
}

/// Checks the keys `position_offset_` of a channel map, which state the zero position of the rig for an axle or a
/// corner.
#[test]
fn the_zero_of_the_rig_is_where_the_map_says() {
    let directory = tempfile::tempdir().expect("a directory");
    let at = directory.path();
    std::fs::write(
        at.join("model.toml"),
        MODEL.replace("gas_force = 141.5", "gas_force = 141.5\nspring_linear = 5000"),
    )
    .expect("a model file");
    let text = "format = 1\nmotion_positive = \"compression\"\nforce_positive = \"compression\"\njounce = \"x_{corner}\"\n\
                jounce_rate = \"v_{corner}\"\nforce = \"f_{corner}\"\nposition_offset_1 = -0.012\nposition_offset_R2 = 0.02\n";
    std::fs::write(at.join("map.toml"), text).expect("a map");
    let host = bridge_host("offset.c", &SANITIZERS, at);
    succeed(Command::new(&host).arg(at.join("model.toml")).arg(at.join("map.toml")));
    // A map with a position offset in mm instead of m is rejected.
    std::fs::write(at.join("mm.toml"), text.replace("-0.012", "-12")).expect("a map");
    let ran = Command::new(&host).arg(at.join("model.toml")).arg(at.join("mm.toml")).status().expect("the host runs");
    assert_eq!(ran.code(), Some(2));
}

/// Checks the S-function, compiled against the stand-in headers in `tests/hosts/simulink` instead of Simulink's
/// headers.
#[test]
fn simulink_tries_steps_and_takes_them() {
    let directory = tempfile::tempdir().expect("a directory");
    let at = directory.path();
    let model = at.join("model.toml");
    std::fs::write(&model, MODEL).expect("a model file");
    let block = root().join("vi-crt-bridge/simulink/dashpot_sfun.c");
    let folders = ["tests/hosts/simulink", "tests/hosts"].map(|f| format!("-I{}", root().join(f).display()));
    let mut flags = vec!["-DMATLAB_MEX_FILE", &folders[0], &folders[1]];
    flags.extend(SANITIZERS);
    let program = bridge_host(block.to_str().expect("a path in UTF-8"), &flags, at);
    let setting = at.join("setting.toml");
    let channels = "format = 1\nmotion_positive = \"compression\"\nforce_positive = \"compression\"\njounce = \"x_{corner}\"\n\
                    jounce_rate = \"v_{corner}\"\nsetting = \"i_{corner}\"\nforce = \"f_{corner}\"\n";
    std::fs::write(&setting, channels).expect("a map");
    succeed(Command::new(program).arg(&model).arg(map(at)).arg(family()).arg(setting));
}
