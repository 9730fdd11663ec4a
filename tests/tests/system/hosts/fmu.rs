//! Tests of exported FMUs in an independent host. FMPy validates and runs all four kinds: FMI 2 and 3, each with one
//! corner and with four.

use dashpot_core::parameter::{Shape, table};
use dashpot_core::{Model, Params, model_file};
use dashpot_test_support::skipped;
use dashpot_tests::bridge::{MODEL, bridge_host, map};
use dashpot_tests::cli::{refused, run_with};
use dashpot_tests::fmu::{exported, runtimes};
use dashpot_tests::library::{root, succeed};
use dashpot_tests::python::{has_python, python};
use serde_json::Value;
use std::path::Path;
use std::process::Command;

fn runs(fmi: &str, four: bool) {
    if !has_python() {
        return;
    }
    let folder = tempfile::tempdir().expect("a directory");
    let at = folder.path();
    exported(at, MODEL, fmi, four, &[]);
    let first = std::fs::read(at.join("damper.fmu")).expect("the FMU");
    exported(at, MODEL, fmi, four, &[]);
    assert!(std::fs::read(at.join("damper.fmu")).expect("the FMU") == first, "the same model gives the same bytes");

    let bridge = bridge_host("bridge.c", &[], at);
    let trace = succeed(Command::new(bridge).arg(at.join("model.toml")).arg(map(at)).arg(if four { "4" } else { "1" }));
    std::fs::write(at.join("trace.txt"), trace).expect("a file");
    let mut host = Command::new(python());
    host.arg(root().join("tests/hosts/fmu.py")).arg(at.join("damper.fmu")).arg(at.join("trace.txt"));
    print!("{}", succeed(host.current_dir(at)));
}

dashpot_tests::each_fmu!(runs);

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
    let library = ["export", "fmu", "model.toml", "-o", "x.fmu", "--from-source", "--library", "none.a"];
    assert!(refused(at, &library).contains("none.a"));
}

fn entries(fmu: &Path) -> Vec<String> {
    let list = "import sys, zipfile; print('\\n'.join(zipfile.ZipFile(sys.argv[1]).namelist()))";
    succeed(Command::new(python()).args(["-c", list]).arg(fmu)).lines().map(str::to_owned).collect()
}

/// Checks that an export needs no compiler. The program `dashpot` contains the runtime, which reads the model from the
/// FMU's resources.
#[test]
fn no_compiler_is_needed_and_sources_may_stay_at_home() {
    if !has_python() {
        return;
    }
    runtimes();
    let folder = tempfile::tempdir().expect("a directory");
    let at = folder.path();
    std::fs::write(at.join("model.toml"), MODEL).expect("a model file");
    for fmi in ["2", "3"] {
        for (name, more) in [("all.fmu", None), ("closed.fmu", Some("--no-sources"))] {
            let mut export = vec!["export", "fmu", "model.toml", "-o", name, "--fmi", fmi];
            export.extend(more);
            let ran = run_with(at, &export, &[("PATH", "")]);
            assert_eq!(ran.code, Some(0), "{}", ran.err);
        }
        let (all, closed) = (entries(&at.join("all.fmu")), entries(&at.join("closed.fmu")));
        assert!(
            all.iter().any(|n| n == "sources/kernel/core/src/lib.rs")
                && all.iter().any(|n| n == "sources/lib/kernel.o")
        );
        assert!(!closed.iter().any(|n| n.starts_with("sources/")), "{closed:?}");
        let platform = if fmi == "2" { "linux64" } else { "x86_64-linux" };
        for names in [&all, &closed] {
            assert!(names.contains(&format!("binaries/{platform}/dashpot_damper.so")), "{names:?}");
            assert!(names.contains(&"resources/model.toml".to_owned()));
        }
        unpacked(&at.join("closed.fmu"), &at.join("closed"));
        let description = std::fs::read_to_string(at.join("closed/modelDescription.xml")).expect("the description");
        assert!(!description.contains("SourceFiles"));
        std::fs::remove_dir_all(at.join("closed")).expect("removed");
    }
}

/// Asserts that an FMU with hidden parameters gives the forces of an open FMU bit for bit, without parameter values in
/// description or resources.
fn runs_hidden(fmi: &str, four: bool) {
    let folder = tempfile::tempdir().expect("a directory");
    let at = folder.path();
    // These numbers of the model occur nowhere else in the files of an FMU.
    let model = "format = 1\nelements = [\"fv_curve\", \"series_compliance\", \"stribeck_friction\", \"gas_preload\"]\n\
                 fv_velocity = [-1.0, -0.123457, 0.0, 0.123457, 1.0]\nfv_force = [-601.137, -251.731, 0.0, 401.373, 1301.917]\n\
                 series_stiffness = 1730411.0\ngas_force = 141.771\n";
    exported(at, model, fmi, four, &[]);
    std::fs::rename(at.join("damper.fmu"), at.join("open.fmu")).expect("renamed");
    exported(at, model, fmi, four, &["--hide-parameters"]);
    let mut host = Command::new(python());
    host.arg(root().join("tests/hosts/fmu_hidden.py")).args([at.join("open.fmu"), at.join("damper.fmu")]);
    print!("{}", succeed(host.args(["0.123457", "1301.917", "1730411", "141.771"])));
}

mod hidden {
    use super::runs_hidden;
    dashpot_tests::each_fmu!(runs_hidden);
}

/// Checks that the export rejects a shared library that the compiler has built for another operating system.
#[test]
fn a_library_for_another_system_is_refused() {
    runtimes();
    let folder = tempfile::tempdir().expect("a directory");
    let at = folder.path();
    std::fs::write(at.join("model.toml"), MODEL).expect("a model file");
    let cross = at.join("cross-cc");
    std::fs::write(&cross, "#!/bin/sh\nwhile [ $# -gt 1 ]; do [ \"$1\" = -o ] && printf MZ >\"$2\"; shift; done\n")
        .expect("a script");
    std::fs::set_permissions(&cross, std::os::unix::fs::PermissionsExt::from_mode(0o755)).expect("may run");
    dashpot_tests::library::directory();
    let export = ["export", "fmu", "model.toml", "-o", "x.fmu", "--from-source"];
    let ran = run_with(at, &export, &[("CC", cross.to_str().expect("a path in UTF-8"))]);
    assert!(ran.code == Some(2) && ran.err.contains("another platform"), "{ran:?}");
    assert!(!at.join("x.fmu").exists());
}

/// Checks that an importer that compiles the FMU's sources (`fmpy compile`) finds all required files in the
/// description. The forces must equal those of the bridge (`vi-crt-bridge`).
#[test]
fn fmpy_compiles_it() {
    if !has_python() {
        return;
    }
    if Command::new("cmake").arg("--version").output().is_err() {
        skipped("needs cmake");
        return;
    }
    let folder = tempfile::tempdir().expect("a directory");
    let at = folder.path();
    let bridge = bridge_host("bridge.c", &[], at);
    for fmi in ["2", "3"] {
        exported(at, MODEL, fmi, false, &[]);
        let trace = succeed(Command::new(&bridge).arg(at.join("model.toml")).arg(map(at)).arg("1"));
        std::fs::write(at.join("trace.txt"), trace).expect("a file");
        let build = "import os, sys, fmpy, fmpy.util, shutil\nfrom fmpy.build import build_platform_binary\n\
                     folder = fmpy.extract(sys.argv[1])\nshutil.rmtree(os.path.join(folder, 'binaries'))\n\
                     build_platform_binary(folder)\nshutil.make_archive(sys.argv[2], 'zip', folder)\n";
        succeed(Command::new(python()).args(["-c", build]).arg(at.join("damper.fmu")).arg(at.join("compiled")));
        std::fs::rename(at.join("compiled.zip"), at.join("compiled.fmu")).expect("renamed");
        let mut host = Command::new(python());
        host.arg(root().join("tests/hosts/fmu.py")).arg(at.join("compiled.fmu")).arg(at.join("trace.txt")).arg("quick");
        succeed(host.current_dir(at));
    }
}

fn unpacked(fmu: &Path, to: &Path) {
    let unzip = "import sys, zipfile; zipfile.ZipFile(sys.argv[1]).extractall(sys.argv[2])";
    succeed(Command::new(python()).args(["-c", unzip]).arg(fmu).arg(to));
}

/// Checks that the FMU's description contains exactly the rows of the kernel's parameter table for the enabled
/// elements, with unchanged values.
#[test]
fn the_description_is_the_parameter_table() {
    if !has_python() {
        return;
    }
    const EVERY_KIND_OF_ROW: &str = "format = 1\nelements = [\"fv_curve\", \"series_compliance\", \"stribeck_friction\", \"gas_spring\", \
                                     \"bump_stop\", \"temperature_fade\", \"lagged_polynomial\", \"frequency_selective_damping\"]\n\
                                     polynomial = [0.0, 400.0, 0.0, 30.0]\nstribeck_form = \"full\"\ngas_stiffness = 700\n";
    let mut params = Params::new();
    model_file::read(EVERY_KIND_OF_ROW.as_bytes(), &mut params).expect("the model");
    for (fmi, four) in [("2", false), ("2", true), ("3", false), ("3", true)] {
        let folder = tempfile::tempdir().expect("a directory");
        let at = folder.path();
        exported(at, EVERY_KIND_OF_ROW, fmi, four, &[]);
        let mut host = Command::new(python());
        host.arg(root().join("tests/hosts/fmu_description.py")).arg(at.join("damper.fmu"));
        let told: Value = serde_json::from_str(&succeed(&mut host)).expect("JSON");

        assert_eq!(told["messages"], Value::Array(Vec::new()));
        assert_eq!(told["version"], format!("{fmi}.0"));
        for kind in ["cs", "me"] {
            let can = |what: &str| told["kinds"][kind][what].as_bool().expect("told");
            assert!(can("canGetAndSetFMUstate") && can("canSerializeFMUstate") && can("providesDirectionalDerivative"));
            assert!(!can("canBeInstantiatedOnlyOncePerProcess") && !can("needsExecutionTool"));
            assert!(kind == "me" || can("canHandleVariableCommunicationStepSize"));
        }
        // The states of a corner are displacement of the damper, deflection and velocity of the internal mass, and the
        // states of the elements.
        let corners: &[&str] = if four { &["L1.", "R1.", "L2.", "R2."] } else { &[""] };
        let memories = Model::new(&params).expect("a model").elements().memories();
        assert!(memories > 1);
        let states = corners.len() * (3 + memories);
        assert_eq!(told["states"], states);

        let page = {
            unpacked(&at.join("damper.fmu"), &at.join("unpacked"));
            std::fs::read_to_string(at.join("unpacked/documentation/index.html")).expect("the page")
        };
        let icon = if fmi == "2" { "model.png" } else { "terminalsAndIcons/icon.png" };
        assert!(std::fs::read(at.join("unpacked").join(icon)).expect("the icon").starts_with(b"\x89PNG"));

        let variables = told["variables"].as_object().expect("variables");
        let (mut expected, mut rows) = (0, 0);
        for row in table() {
            let (p, on) = (row.parameter, row.element().is_none_or(|element| params.is_on(element)));
            for corner in corners {
                let list = matches!(p.shape, Shape::List(_));
                let first = format!("{corner}{}{}", p.name, if list { "[1]" } else { "" });
                if !on {
                    assert!(!variables.contains_key(&first), "{first} belongs to an element that is off");
                    continue;
                }
                for (k, value) in params.get(&row).iter().enumerate() {
                    let name = if list { format!("{corner}{}[{}]", p.name, k + 1) } else { first.clone() };
                    let v = &variables[&name];
                    expected += 1;
                    assert_eq!(
                        (&v["causality"], &v["description"]),
                        (&"parameter".into(), &p.meaning.into()),
                        "{name}"
                    );
                    let start: f64 = v["start"].as_str().expect("a start value").parse().expect("a number");
                    assert_eq!(start, *value, "{name}");
                    if let Shape::Choice(words) = p.shape {
                        let items: Vec<&str> =
                            v["items"].as_array().expect("items").iter().filter_map(Value::as_str).collect();
                        assert_eq!((items, &v["variability"]), (words.to_vec(), &"fixed".into()), "{name}");
                    } else {
                        let bound = |end: &str| -> f64 { v[end].as_str().expect("a bound").parse().expect("a number") };
                        assert_eq!((bound("min"), bound("max")), (p.low, p.high), "{name}");
                        assert_eq!(v["variability"], "tunable", "{name}");
                        assert_eq!(v["unit"].as_str().unwrap_or("-"), p.unit, "{name}");
                    }
                    assert!(page.contains(&format!("<td>{name}</td>")), "{name} is missing on the page");
                    rows += 1;
                }
            }
        }
        let own = ["motion_scale", "force_scale", "position_offset", "displacement_given", "initial_position"];
        let parameters = variables.values().filter(|v| v["causality"] == "parameter").count();
        // The number 1 is for the parameter inputs_between_points, which belongs to the whole FMU.
        assert_eq!(parameters, expected + corners.len() * own.len() + 1, "parameters that are in no table");
        assert!(rows > 30 * corners.len(), "{rows}");
        for (name, v) in variables {
            assert!(!v["description"].as_str().unwrap_or("").is_empty(), "{name} is not described");
            let input_or_state = v["causality"] == "input" || v["causality"] == "output" && v["type"] != "Integer";
            if input_or_state && !matches!(v["type"].as_str(), Some("Int32")) {
                assert!(v["unit"].is_string(), "{name} has no unit");
            }
        }
    }
}

/// Checks that an FMU that is recompiled from its unpacked sources gives the bridge's forces bit for bit.
///
/// The test links the compiled kernel in the FMU, and a kernel compiled from the sources in the FMU.
#[test]
fn its_sources_are_all_it_needs() {
    if !has_python() {
        return;
    }
    let folder = tempfile::tempdir().expect("a directory");
    let at = folder.path();
    let bridge = bridge_host("bridge.c", &[], at);
    for (fmi, four, kernel) in [("2", true, ""), ("3", false, "cargo")] {
        exported(at, MODEL, fmi, four, &[]);
        let trace =
            succeed(Command::new(&bridge).arg(at.join("model.toml")).arg(map(at)).arg(if four { "4" } else { "1" }));
        std::fs::write(at.join("trace.txt"), trace).expect("a file");
        let unpack = at.join(format!("unpacked-{fmi}"));
        unpacked(&at.join("damper.fmu"), &unpack);
        let binary =
            unpack.join("binaries").join(if fmi == "2" { "linux64" } else { "x86_64-linux" }).join("dashpot_damper.so");
        std::fs::remove_file(&binary).expect("the binary lies where it belongs");
        let mut build = Command::new("sh");
        build
            .arg(unpack.join("sources/build.sh"))
            .env("KERNEL", kernel)
            .env_remove("CARGO_TARGET_DIR")
            .env_remove("TARGET");
        if kernel.is_empty() {
            // The variable PATH has the folders of the C compiler, and no cargo is available, so the build must not
            // need Rust.
            build.env("CARGO", "none").env("PATH", "/usr/bin:/bin");
        }
        succeed(&mut build);
        assert!(binary.is_file());
        let zip = "import sys, shutil; shutil.make_archive(sys.argv[1], 'zip', sys.argv[2])";
        let _ = std::fs::remove_dir_all(unpack.join("sources/kernel/target"));
        succeed(Command::new(python()).args(["-c", zip]).arg(at.join("again")).arg(&unpack));
        std::fs::rename(at.join("again.zip"), at.join("again.fmu")).expect("renamed");
        let mut host = Command::new(python());
        host.arg(root().join("tests/hosts/fmu.py")).arg(at.join("again.fmu")).arg(at.join("trace.txt")).arg("quick");
        succeed(host.current_dir(at));
    }
}

/// Builds the host program for Windows and writes the trace of the bridge's forces. Returns the GUID of the FMU.
/// Reports a skipped test and returns `None` if wine or mingw-w64 is missing.
fn windows_host(at: &Path) -> Option<String> {
    let there = |program: &str| Command::new(program).arg("--version").output().is_ok();
    if !there("wine") || !there("x86_64-w64-mingw32-gcc") {
        skipped("needs wine and mingw-w64");
        return None;
    }
    let bridge = bridge_host("bridge.c", &[], at);
    let trace = succeed(Command::new(bridge).arg(at.join("model.toml")).arg(map(at)).arg("1"));
    std::fs::write(at.join("trace.txt"), trace).expect("a file");
    let mut build = Command::new("x86_64-w64-mingw32-gcc");
    build.args(["-O1", "-Wall", "-Wextra"]).arg(format!("-I{}", root().join("vi-crt-bridge/fmu").display()));
    succeed(build.arg(root().join("tests/hosts/fmu_windows.c")).arg("-o").arg(at.join("host.exe")));
    let description = std::fs::read_to_string(at.join("unpacked/modelDescription.xml")).expect("the description");
    description.split("guid=\"").nth(1).and_then(|rest| rest.split('"').next()).map(str::to_owned)
}

/// Asserts that the FMU's library for Windows gives the bridge's forces bit for bit in wine.
fn runs_on_windows(at: &Path, guid: &str, dll: &Path, resources: &str) {
    let mut wine = Command::new("wine");
    wine.current_dir(at).env("WINEPREFIX", at.join("wine")).env("WINEDEBUG", "-all");
    wine.arg("host.exe").arg(dll.strip_prefix(at).expect("below")).args([guid, "trace.txt", resources]);
    assert!(succeed(&mut wine).contains("1001 steps"), "{resources}");
}

/// Checks that the runtime for Windows finds the model for every form of the resources path that importers use.
#[test]
fn the_runtime_for_windows_reads_its_resources() {
    if !has_python() {
        return;
    }
    let folder = tempfile::tempdir().expect("a directory");
    let at = folder.path();
    exported(at, MODEL, "2", false, &["--no-sources"]);
    unpacked(&at.join("damper.fmu"), &at.join("unpacked"));
    let dll = at.join("unpacked/binaries/win64/dashpot_damper.dll");
    if !dll.is_file() {
        skipped("the command holds no runtime for Windows");
        return;
    }
    let Some(guid) = windows_host(at) else { return };
    std::fs::create_dir(at.join("a folder")).expect("a folder");
    for file in ["contents.txt", "model.toml"] {
        std::fs::copy(at.join("unpacked/resources").join(file), at.join("a folder").join(file)).expect("copied");
    }
    // Wine's drive Z: is the root of this computer's file system.
    let slashes = at.join("a folder").display().to_string();
    let backslashes = slashes.replace('/', "\\");
    for resources in [
        format!("file:///Z:{}", slashes.replace(' ', "%20")),
        format!("Z:{slashes}/"),
        format!("\\\\?\\Z:{backslashes}"),
        format!("\\\\?\\Z:{backslashes}/"),
    ] {
        runs_on_windows(at, &guid, &dll, &resources);
    }
}

/// Checks that a binary for Windows, built with a cross compiler, is added to the FMU for this computer.
#[test]
fn a_binary_for_another_platform_goes_inside() {
    if !has_python() {
        return;
    }
    let folder = tempfile::tempdir().expect("a directory");
    let at = folder.path();
    exported(at, MODEL, "2", false, &[]);
    std::fs::write(at.join("foreign.dll"), "no such thing").expect("a file");
    let foreign = ["export", "fmu", "model.toml", "-o", "x.fmu", "--binary", "win64=foreign.dll"];
    assert!(refused(at, &foreign).contains("not compiled from the sources of this FMU"));
    assert!(
        refused(at, &["export", "fmu", "model.toml", "-o", "x.fmu", "--binary", "win64"]).contains("PLATFORM=FILE")
    );

    let installed = Command::new("rustup").args(["target", "list", "--installed"]).output();
    let target = "x86_64-pc-windows-gnu";
    let rust = installed.is_ok_and(|told| String::from_utf8_lossy(&told.stdout).contains(target));
    let gcc = Command::new("x86_64-w64-mingw32-gcc").arg("--version").output().is_ok();
    if !rust || !gcc {
        skipped(format!("needs mingw-w64 and rustup target add {target}"));
        return;
    }
    unpacked(&at.join("damper.fmu"), &at.join("unpacked"));
    let mut build = Command::new("sh");
    build.arg(at.join("unpacked/sources/build.sh")).env("TARGET", target).env("CC", "x86_64-w64-mingw32-gcc");
    succeed(build.env_remove("CARGO_TARGET_DIR"));
    let dll = at.join("unpacked/binaries/win64/dashpot_damper.dll");
    let told = succeed(Command::new("x86_64-w64-mingw32-objdump").arg("-p").arg(&dll));
    assert!(
        told.contains("fmi2DoStep") && told.contains("fmi2GetDerivatives") && !told.contains("dashpot_step"),
        "{told}"
    );
    // The DLL needs only libraries that every Windows has.
    let needs: Vec<&str> = told.lines().filter_map(|l| l.trim().strip_prefix("DLL Name: ")).collect();
    assert!(
        needs.iter().all(|n| n.starts_with("KERNEL32") || n.starts_with("msvcrt") || n.starts_with("api-ms-win-crt")),
        "{needs:?}"
    );
    if let Some(guid) = windows_host(at) {
        runs_on_windows(at, &guid, &dll, "");
    }
    exported(at, MODEL, "2", false, &["--binary", &format!("win64={}", dll.display())]);
    let mut host = Command::new(python());
    host.arg(root().join("tests/hosts/fmu_description.py")).arg(at.join("damper.fmu"));
    let told: Value = serde_json::from_str(&succeed(&mut host)).expect("JSON");
    let files: Vec<&str> = told["files"].as_array().expect("files").iter().filter_map(Value::as_str).collect();
    assert!(
        files.contains(&"binaries/win64/dashpot_damper.dll") && files.contains(&"binaries/linux64/dashpot_damper.so")
    );
}

#[test]
fn the_page_says_that_a_damper_chatters_in_a_host_that_holds_its_force() {
    if !has_python() {
        return;
    }
    let with = |steepness: u32| {
        format!(
            "format = 1\nelements = [\"fv_curve\", \"coulomb_friction\"]\nfv_velocity = [-1.0, 0.0, 1.0]\n\
             fv_force = [-900.0, 0.0, 1500.0]\ncoulomb_force = 40.0\ncoulomb_steepness = {steepness}.0\n"
        )
    };
    for (steepness, chatters) in [(5000, true), (50, false)] {
        let folder = tempfile::tempdir().expect("a directory");
        let at = folder.path();
        exported(at, &with(steepness), "2", false, &[]);
        unpacked(&at.join("damper.fmu"), &at.join("unpacked"));
        let page = std::fs::read_to_string(at.join("unpacked/documentation/index.html")).expect("the page");
        assert_eq!(
            page.contains("This damper.") && page.contains("At a host step of 1 ms and 40 kg"),
            chatters,
            "{page}"
        );
        assert!(!page.contains("REMARKS"));

        // Front and rear dampers have the same model, so their common remark appears once.
        let car = run_with(at, &["export", "fmu", "model.toml", "model.toml", "-o", "car.fmu"], &[]);
        assert_eq!(car.code, Some(0), "{}", car.err);
        unpacked(&at.join("car.fmu"), &at.join("car"));
        let page = std::fs::read_to_string(at.join("car/documentation/index.html")).expect("the page");
        assert_eq!(page.matches("At a host step of 1 ms and 40 kg").count(), usize::from(chatters), "{page}");
    }
}
