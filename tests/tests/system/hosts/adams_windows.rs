//! Tests of the library for Adams on Windows: it is built on Linux with mingw-w64, inspected, and run with Wine if Wine
//! is available.

use dashpot_core::{Input, evaluate::force};
use dashpot_test_support::{skipped, target_folder};
use dashpot_tests::adams::{PLAIN, model_of, written};
use dashpot_tests::library::{root, succeed};
use std::path::{Path, PathBuf};
use std::process::Command;

const TARGET: &str = "x86_64-pc-windows-gnu";
const COMPILER: &str = "x86_64-w64-mingw32-gcc";

/// Returns the name of a missing tool for a Windows build, or `None` if all tools are available.
fn missing() -> Option<&'static str> {
    if Command::new(COMPILER).arg("--version").output().is_err() {
        return Some("x86_64-w64-mingw32-gcc (Debian: gcc-mingw-w64-x86-64)");
    }
    let folder = Command::new("rustc").args(["--print", "target-libdir", "--target", TARGET]).output().ok()?;
    let there = Path::new(String::from_utf8_lossy(&folder.stdout).trim()).is_dir();
    (!there).then_some("the Rust target (rustup target add x86_64-pc-windows-gnu)")
}

/// Builds the library for Adams as `adams-usersub/README.md` describes.
fn built(folder: &Path) -> PathBuf {
    let mut build = Command::new(env!("CARGO"));
    build.args(["build", "--release", "--quiet", "-p", "dashpot-dll", "--target", TARGET]).current_dir(root());
    succeed(&mut build);
    let archive = target_folder().join(TARGET).join("release/libdashpot.a");
    let library = folder.join("dashpot_adams.dll");
    let mut make = Command::new("make");
    make.arg("-s").arg("-C").arg(root().join("adams-usersub")).arg("windows");
    make.arg(format!("WINDOWS_LIBRARY={}", archive.display())).arg(format!("WINDOWS_OUTPUT={}", library.display()));
    make.arg("CFLAGS=-std=c99 -O2 -Wall -Wextra -Wpedantic -Werror");
    succeed(&mut make);
    library
}

/// Returns the names in the tables of a DLL: its exports, and the libraries that it requires.
fn tables(library: &Path) -> (Vec<String>, Vec<String>) {
    let text = succeed(Command::new("x86_64-w64-mingw32-objdump").arg("-p").arg(library));
    let (_, names) = text.split_once("[Ordinal/Name Pointer] Table").expect("an export table");
    let name = |line: &str| line.trim().starts_with('[').then(|| line.split_whitespace().last().unwrap().to_string());
    let mut exported: Vec<String> = names.lines().skip(1).map_while(name).collect();
    exported.sort_unstable();
    let needed = text.lines().filter_map(|l| l.trim().strip_prefix("DLL Name: ")).map(|n| n.to_lowercase()).collect();
    (exported, needed)
}

#[test]
fn the_windows_library_exports_its_entries_needs_only_windows_and_runs() {
    if let Some(what) = missing() {
        skipped(format!("no {what}"));
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let library = built(folder.path());
    let (exported, needed) = tables(&library);
    let entries = ["gfosub", "gse_deriv", "gse_output", "gse_samp", "gse_update", "reqsub", "sfosub"];
    let mut want: Vec<String> = entries.iter().map(|e| format!("Dashpot_{e}")).collect();
    want.push("dashpot_adams_selftest".into());
    assert_eq!(exported, want);
    assert_eq!(needed, ["kernel32.dll", "msvcrt.dll"]);

    let host = root().join("tests/adams/windows.c");
    for (name, flags) in [("AsUtility.dll", &["-shared", "-DUTILITIES"][..]), ("host.exe", &[][..])] {
        let mut compiler = Command::new(COMPILER);
        compiler.args(["-std=c99", "-O1", "-Wall", "-Wextra", "-Werror"]).args(flags).arg(&host);
        succeed(compiler.arg("-o").arg(folder.path().join(name)));
    }
    if Command::new("wine").arg("--version").output().is_err() {
        println!("built, not run: no wine");
        return;
    }
    written(folder.path(), PLAIN);
    let mut wine = Command::new("wine");
    wine.args(["host.exe", "AsUtility.dll", "dashpot_adams.dll", "damper.toml"]).current_dir(folder.path());
    let text = succeed(wine.env("WINEPREFIX", folder.path().join("wine")).env("WINEDEBUG", "-all"));
    // This command ends Wine's server of this test, if it still runs.
    Command::new("wineserver").arg("-k").env("WINEPREFIX", folder.path().join("wine")).output().unwrap();
    assert!(text.contains("selftest 0"), "{text}");
    assert!(text.contains("usrmes 1 INFO dashpot: model file damper.toml, 2 states"), "{text}");
    // The expected force is the kernel's steady force at the motion of `tests/adams/windows.c`, 10 mm and 150 mm/s.
    let (model, input) = (model_of(PLAIN), Input::motion(0.01, 0.15));
    let want = -force(&model, &model.steady_state(&input), &input).force;
    let line = text.lines().find_map(|l| l.trim().strip_prefix("sforce ")).unwrap();
    let got: f64 = line.parse().unwrap();
    assert!((got - want).abs() < 1e-9 * want.abs(), "{got} {want}");
}
