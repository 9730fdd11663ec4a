//! Tests of the readers in C with damaged channel maps and FMU resources, under the compiler's memory checks.
//!
//! Each file must be accepted or rejected, without memory access outside of the block that contains the file.

use dashpot_test_support::skipped;
use dashpot_tests::bridge::MODEL;
use dashpot_tests::fmu::exported;
use dashpot_tests::hostile::rounds;
use dashpot_tests::library::{Language, compiler, root, static_library, succeed};
use dashpot_tests::python::{has_python, python};
use std::path::{Path, PathBuf};
use std::process::Command;

/// Compiles the program that damages and reads files. Returns `None` if the compiler has no memory checks.
fn watched(at: &Path) -> Option<PathBuf> {
    let program = at.join("damaged");
    let mut build = compiler(Language::C);
    build.args(["-fsanitize=address,undefined", "-fno-sanitize-recover=undefined"]);
    std::fs::write(at.join("probe.c"), "int main(void) { return 0; }\n").expect("a file");
    let mut probe = compiler(Language::C);
    probe.arg("-fsanitize=address,undefined").arg(at.join("probe.c")).arg("-o").arg(at.join("probe"));
    if !probe.output().is_ok_and(|made| made.status.success()) {
        skipped("the compiler has no -fsanitize=address,undefined");
        return None;
    }
    let bridge = root().join("vi-crt-bridge");
    build.arg("-I").arg(bridge.join("fmu")).arg("-I").arg(bridge.join("bridge"));
    build.arg(root().join("tests/hosts/damaged.c"));
    for name in ["bridge/channel_map.c", "bridge/corner.c"] {
        build.arg(bridge.join(name));
    }
    for entry in std::fs::read_dir(bridge.join("fmu")).expect("the sources") {
        let path = entry.expect("an entry").path();
        if path.extension().is_some_and(|e| e == "c") {
            build.arg(path);
        }
    }
    build.arg(static_library()).args(["-lm", "-lpthread", "-ldl", "-o"]).arg(&program);
    succeed(&mut build);
    Some(program)
}

#[test]
fn damaged_maps_and_resources_are_taken_or_refused() {
    if !has_python() {
        return;
    }
    let folder = tempfile::tempdir().expect("a directory");
    let at = folder.path();
    let Some(program) = watched(at) else { return };
    let map = root().join("vi-crt-bridge/maps/carsim.toml");
    print!("{}", succeed(Command::new(&program).args([&rounds(20_000).to_string(), "map"]).arg(map)));
    for (name, more) in [("open", &[][..]), ("hidden", &["--hide-parameters"])] {
        let own = at.join(name);
        std::fs::create_dir(&own).expect("a folder");
        exported(&own, MODEL, "2", false, more);
        let unzip = "import sys, zipfile; zipfile.ZipFile(sys.argv[1]).extractall(sys.argv[2])";
        succeed(Command::new(python()).args(["-c", unzip]).arg(own.join("damper.fmu")).arg(&own));
        let resources = own.join("resources");
        let contents = std::fs::read_to_string(resources.join("contents.txt")).expect("the contents");
        let guid = contents.lines().find_map(|line| line.strip_prefix("guid ")).expect("a GUID");
        print!(
            "{}",
            succeed(Command::new(&program).args([&rounds(1500).to_string(), "fmu"]).arg(&resources).arg(guid))
        );
    }
}
