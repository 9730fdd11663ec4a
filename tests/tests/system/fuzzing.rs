//! Runs every reader of files for five seconds under a fuzzer guided by branch coverage, with the script
//! `tests/fuzz/run`. The environment variable DASHPOT_FUZZ sets another number of seconds per reader.

use dashpot_test_support::skipped;
use dashpot_tests::cli::program;
use dashpot_tests::library::root;
use std::process::Command;

/// Seconds per reader, enough to repeat the stored inputs of longer runs.
const SECONDS: &str = "5";

#[test]
fn no_reader_breaks_under_the_fuzzer() {
    let seconds = std::env::var("DASHPOT_FUZZ").unwrap_or_else(|_| SECONDS.to_owned());
    let mut run = Command::new(root().join("tests/fuzz/run"));
    // These variables select the compiler of this test run. The fuzzer needs another compiler.
    for name in ["RUSTUP_TOOLCHAIN", "RUSTC", "CARGO", "RUSTC_WRAPPER", "CARGO_TARGET_DIR"] {
        run.env_remove(name);
    }
    // The script exports valid FMUs as seeds with the program `dashpot`.
    let out = run.arg(seconds).env("DASHPOT", program()).output().expect("bash");
    let told = String::from_utf8_lossy(&out.stdout).into_owned() + &String::from_utf8_lossy(&out.stderr);
    match out.status.code() {
        // Exit code 3 means missing tools, which the last line of the output names.
        Some(3) => skipped(told.trim().lines().last().unwrap_or_default()),
        code => assert_eq!(code, Some(0), "{told}"),
    }
}
