//! Every reader of files under a fuzzer that follows which branches its input takes, some seconds each; `tests/fuzz/run` has the time as its
//! argument. DASHPOT_FUZZ says how many seconds this test gives.

use dashpot_test_support::skipped;
use dashpot_tests::cli::program;
use dashpot_tests::library::root;
use std::process::Command;

/// Seconds a reader: enough to run through the inputs that a longer run has kept.
const SECONDS: &str = "5";

#[test]
fn no_reader_breaks_under_the_fuzzer() {
    let seconds = std::env::var("DASHPOT_FUZZ").unwrap_or_else(|_| SECONDS.to_owned());
    let mut run = Command::new(root().join("tests/fuzz/run"));
    // The compiler that runs this test is asked for in these, and another one is wanted.
    for name in ["RUSTUP_TOOLCHAIN", "RUSTC", "CARGO", "RUSTC_WRAPPER", "CARGO_TARGET_DIR"] {
        run.env_remove(name);
    }
    // For sound FMUs.
    let out = run.arg(seconds).env("DASHPOT", program()).output().expect("bash");
    let told = String::from_utf8_lossy(&out.stdout).into_owned() + &String::from_utf8_lossy(&out.stderr);
    match out.status.code() {
        // Tools that are not here; the last line says which.
        Some(3) => skipped(told.trim().lines().last().unwrap_or_default()),
        code => assert_eq!(code, Some(0), "{told}"),
    }
}
