//! Tests that code reads files of the user only through `dashpot_records::read_small`, `read_regular` and their variants for text. These
//! functions accept only regular files up to a stated size, because a pipe blocks forever, and a device may never end. Crate `rig` has its
//! own functions.

use dashpot_test_support::rust_files;
use dashpot_tests::library::root;

/// Source files that may open files in another manner, with the reason.
const ALLOWED: [(&str, &str); 7] = [
    ("src/records/src/source.rs", "the functions themselves"),
    ("src/rig/src/files.rs", "the functions of crate rig"),
    ("src/output/src/guard.rs", "an output that is a regular file of limited size"),
    ("src/output/src/lock.rs", "locks files that it made"),
    ("src/report/src/made.rs", "hashes regular files in blocks"),
    ("src/hosts/src/fmu/mod.rs", "outputs of the compiler"),
    ("src/records/src/formats/mat/version73.rs", "a file in memory"),
];
const CALLS: [&str; 3] = ["fs::read(", "fs::read_to_string(", "File::open("];

#[test]
fn files_of_the_user_are_read_in_one_place() {
    let (mut wrong, mut used) = (Vec::new(), Vec::new());
    for file in rust_files(&root().join("src")).unwrap() {
        let name = file.strip_prefix(root()).unwrap().display().to_string();
        // The test excludes tests, programs for developers and build scripts.
        let own = ["/tests/", "/tests.rs", "/examples/", "build.rs", "/ui_tests/", "src/proving/", "src/severity/"];
        if own.iter().any(|own| name.contains(own)) {
            continue;
        }
        let text = std::fs::read_to_string(&file).unwrap();
        // Test modules are at the end of a file and are not checked.
        let code = text.split("#[cfg(test)]\nmod tests").next().unwrap_or_default();
        for (number, line) in code.lines().enumerate() {
            if !line.trim_start().starts_with("//") && CALLS.iter().any(|call| line.contains(call)) {
                match ALLOWED.iter().find(|(allowed, _)| *allowed == name) {
                    Some((allowed, _)) => used.push(*allowed),
                    None => wrong.push(format!("{name}:{}: {}", number + 1, line.trim())),
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
    for (allowed, _) in ALLOWED {
        assert!(used.contains(&allowed), "{allowed} opens no file; take it off the list");
    }
}
