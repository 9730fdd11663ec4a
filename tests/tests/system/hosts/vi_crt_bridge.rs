//! Tests of the simulator bridge: four dampers with the host's signs and channel names, without operations that a
//! real-time loop forbids.

use dashpot_test_support::skipped;
use dashpot_tests::bridge::{MODEL, bridge_host, map, sources};
use dashpot_tests::library::{root, succeed};
use std::path::Path;
use std::process::Command;

#[test]
fn does_what_its_header_says() {
    let directory = tempfile::tempdir().expect("a directory");
    let model = directory.path().join("model.toml");
    std::fs::write(&model, MODEL).expect("a model file");
    let flags: [&[&str]; 2] = [&[], &["-fsanitize=address,undefined", "-fno-sanitize-recover=all"]];
    for flags in flags {
        let program = bridge_host("bridge.c", flags, directory.path());
        succeed(Command::new(program).arg(&model).arg(map(directory.path())));
    }
}

/// Checks that the message about the shipped channel map asks the user for the missing force channel.
#[test]
fn the_unknown_channel_is_asked_for() {
    let directory = tempfile::tempdir().expect("a directory");
    let model = directory.path().join("model.toml");
    std::fs::write(&model, MODEL).expect("a model file");
    let program = bridge_host("bridge.c", &[], directory.path());
    let shipped = root().join("vi-crt-bridge/maps/vi-carrealtime.toml");
    let output = Command::new(program).arg(&model).arg(shipped).output().expect("the host runs");
    let text = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(!output.status.success() && text.contains("force must name the host's input channel"), "{text}");
}

/// Checks that a step of the bridge neither allocates memory, nor accesses files, nor locks.
#[test]
fn only_create_and_destroy_allocate_and_read() {
    let directory = tempfile::tempdir().expect("a directory");
    let mut calls = Vec::new();
    for source in sources("bridge") {
        let object = directory.path().join("object.o");
        let mut gcc = dashpot_tests::library::compiler(dashpot_tests::library::Language::C);
        succeed(gcc.args(["-O2", "-ffunction-sections", "-c", &source, "-o"]).arg(&object));
        let text = succeed(Command::new("objdump").arg("-dr").arg(&object));
        let mut section = String::new();
        for line in text.lines() {
            if let Some(name) = line.strip_prefix("Disassembly of section .text.") {
                section = name.trim_end_matches(':').to_owned();
            } else if let Some(target) = line.split("R_X86_64_PLT32").nth(1) {
                calls.push((section.clone(), target.trim().split('-').next().expect("a name").to_owned()));
            }
        }
    }
    assert!(calls.iter().any(|(from, to)| from.contains("create") && to == "calloc"), "{calls:?}");
    let mut reached = vec![
        "dashpot_bridge_step".to_owned(),
        "dashpot_bridge_step_vector".to_owned(),
        "dashpot_bridge_init".to_owned(),
        "dashpot_bridge_save".to_owned(),
        "dashpot_bridge_restore".to_owned(),
        "dashpot_corner_step".to_owned(),
    ];
    let mut at = 0;
    while at < reached.len() {
        let from = reached[at].clone();
        for (_, to) in calls.iter().filter(|(f, _)| *f == from) {
            if !reached.contains(to) {
                reached.push(to.clone());
            }
        }
        at += 1;
    }
    let ours = |name: &String| name.starts_with("dashpot_") || name == "unpack" || name == "pack";
    let foreign: Vec<&String> = reached.iter().filter(|n| !ours(n)).collect();
    assert!(foreign.iter().all(|n| ["memset", "memcpy", "__stack_chk_fail"].contains(&n.as_str())), "{foreign:?}");
    assert!(reached.iter().any(|n| n == "dashpot_step"), "{reached:?}");
}

/// Checks a simulation of two minutes of driving through the bridge; `tests/hosts/soak.c` describes a run of half an
/// hour.
///
/// `settings` are the soft and the firm setting of a damper that depends on one. A controller switches between them.
fn long_drive(model: &Path, settings: &[&str]) {
    let directory = tempfile::tempdir().expect("a directory");
    let program = bridge_host("soak.c", &["-O2"], directory.path());
    let output = Command::new(program).arg(model).arg("120").args(settings).output().expect("the host runs");
    if output.status.code() == Some(3) {
        skipped(String::from_utf8_lossy(&output.stderr).trim());
        return;
    }
    assert!(output.status.success(), "{output:?}: a signal says that the loop made a system call");
    let text = String::from_utf8(output.stdout).expect("text");
    print!("{text}");
    let figure = |name: &str| -> f64 {
        let line = text.lines().find_map(|l| l.strip_prefix(name)).unwrap_or_else(|| panic!("{name} in {text}"));
        line.trim().parse().expect("a number")
    };
    assert_eq!((figure("steps "), figure("missed ")), (120_000.0, 0.0));
    // If mlockall() is allowed, there are no page faults. Otherwise, one or two occur at first accesses.
    assert!(figure("page_faults ") <= 2.0, "{text}");
    // The host integrates displacement by its own rule, which differs from the bridge's by half a step of velocity.
    // This difference must not accumulate.
    assert!(figure("drift_mm ") < 1.0, "{text}");
    assert!((figure("rms_late_n ") / figure("rms_early_n ") - 1.0).abs() < 0.2, "{text}");
    assert_eq!(figure("switches ") > 1000.0, !settings.is_empty(), "{text}");
}

#[test]
fn a_long_drive_neither_drifts_nor_grows_nor_calls_the_system() {
    let directory = tempfile::tempdir().expect("a directory");
    let model = directory.path().join("model.toml");
    std::fs::write(&model, MODEL).expect("a model file");
    long_drive(&model, &[]);
}

#[test]
fn nor_does_a_long_drive_with_controlled_dampers_and_their_valves() {
    long_drive(&root().join("examples/semi_active.toml"), &["0.1", "1.4"]);
}
