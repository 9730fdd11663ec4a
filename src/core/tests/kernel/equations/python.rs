//! Runs the Python programs in the folder of this test.

use super::page;
use dashpot_test_support::skipped;
use std::io::Write as _;
use std::path::Path;
use std::process::{Command, Stdio};

/// Runs a Python program with the page of equations as its argument and `asked` as its input, and returns its output.
/// Without Python, reports the skipped test and returns `None`.
pub fn run(program: &str, asked: &str) -> Option<String> {
    let program = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/kernel/equations").join(program);
    let mut python = Command::new("python3");
    // The option `-B` prevents compiled files next to the sources.
    python.arg("-B").args([program, page::path()]);
    let piped = python.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let Ok(mut python) = piped.spawn() else {
        skipped("no python3");
        return None;
    };
    // The program reads all input before it writes. If it stops earlier, its message is reported below.
    let _ = python.stdin.take().expect("a way in").write_all(asked.as_bytes());
    let ran = python.wait_with_output().expect("an end");
    assert!(ran.status.success(), "{}", String::from_utf8_lossy(&ran.stderr));
    Some(String::from_utf8(ran.stdout).expect("text"))
}
