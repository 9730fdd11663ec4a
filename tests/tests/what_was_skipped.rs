//! Prints the last line of a whole test run: the number of tests that could not run on this machine, and the reasons.
//!
//! This file is not a test, but a program that cargo runs like a test. Cargo runs the test programs in the order of
//! their packages and names, and then the documentation examples. This program verifies that it is the last one.

use dashpot_tests::library::root;
use std::path::Path;

fn main() {
    let own = Path::new(file!()).file_name().expect("a name").to_owned();
    for entry in
        std::fs::read_dir(root().join("tests/tests")).expect("the tests").map(|e| e.expect("an entry").file_name())
    {
        assert!(entry <= own, "{} runs after the count of skipped tests: call it otherwise", entry.to_string_lossy());
    }
    let read = |manifest: &Path| -> toml::Table {
        std::fs::read_to_string(manifest).unwrap_or_else(|e| panic!("{}: {e}", manifest.display())).parse().unwrap()
    };
    let workspace = read(&root().join("Cargo.toml"));
    for member in workspace["workspace"]["members"].as_array().expect("members") {
        let folder = root().join(member.as_str().expect("a folder"));
        let manifest = read(&folder.join("Cargo.toml"));
        let name = manifest["package"]["name"].as_str().expect("a name");
        assert!(name <= env!("CARGO_PKG_NAME"), "{name} is tested after the count of skipped tests: call it otherwise");
        let doctest = manifest.get("lib").and_then(|lib| lib.get("doctest")).and_then(toml::Value::as_bool);
        let library = folder.join("src/lib.rs").is_file() || manifest.get("lib").is_some();
        assert!(
            !library || doctest == Some(false),
            "{name}: examples in documentation run last; make it a test, doctest = false"
        );
    }
    // The line is printed only in a whole test run, without filters or a request for the list of tests.
    if std::env::args().len() == 1 {
        println!("{}", dashpot_test_support::counted());
    }
}
