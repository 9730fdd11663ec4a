//! The last line of a whole run of the tests: how many could not run on this machine, and why.
//!
//! No test program, but one that cargo runs like one. Cargo runs them in the order of their packages' and their own names, and examples in
//! documentation after all of them: this one looks itself that nothing comes after it.

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
    // Whoever lists or filters tests asks for none of this.
    if std::env::args().len() == 1 {
        println!("{}", dashpot_test_support::counted());
    }
}
