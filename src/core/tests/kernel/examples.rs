//! Test of the code examples in the documentation comments, including those that must not compile.
//!
//! Cargo would run the examples after the test that counts the skipped tests. Therefore this test runs them instead,
//! and `doctest = false` in the manifest switches Cargo's run off.

use std::path::{Path, PathBuf};
use std::process::Command;

/// Returns the most recently compiled library of a crate. Cargo stores one library for each set of options.
fn library(folder: &Path, name: &str) -> PathBuf {
    let prefix = format!("lib{name}-");
    let files = std::fs::read_dir(folder).expect("the folder of this test").map(|entry| entry.expect("an entry"));
    let libraries = files.filter(|file| {
        let file = file.file_name().into_string().expect("a name in ASCII");
        file.starts_with(&prefix) && file.ends_with(".rlib")
    });
    libraries.max_by_key(|file| file.metadata().and_then(|m| m.modified()).expect("a time")).expect("a library").path()
}

#[test]
fn examples_compile_or_are_refused_as_they_say() {
    let own = std::env::current_exe().expect("the path of this test");
    let folder = own.parent().expect("its folder");
    let mut rustdoc = Command::new(std::env::var_os("RUSTDOC").unwrap_or_else(|| "rustdoc".into()));
    rustdoc.current_dir(env!("CARGO_MANIFEST_DIR"));
    // Only a library compiled for both panic strategies can be linked into a program that aborts.
    rustdoc.args(["--test", "src/lib.rs", "--crate-name", "dashpot_core", "--edition", "2024", "-C", "panic=abort"]);
    rustdoc.arg("-L").arg(format!("dependency={}", folder.display()));
    for name in ["dashpot_core", "libm"] {
        rustdoc.arg("--extern").arg(format!("{name}={}", library(folder, name).display()));
    }
    let ran = rustdoc.output().expect("rustdoc runs");
    let (out, err) = (String::from_utf8_lossy(&ran.stdout), String::from_utf8_lossy(&ran.stderr));
    assert!(ran.status.success(), "{out}{err}");
    let count = |what: &str| out.lines().filter(|line| line.ends_with(what)).count();
    let (refused, all) = (count("compile fail ... ok"), count("... ok"));
    assert!(refused > 0 && all > refused, "{out}{err}");
}
