//! The programs in Python that stand beside this test.

use crate::page;
use dashpot_test_support::skipped;
use std::io::Write as _;
use std::path::Path;
use std::process::{Command, Stdio};

/// What a program says of the page; `None` where there is no Python, which is told.
pub fn run(program: &str, asked: &str) -> Option<String> {
    let program = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/equations").join(program);
    let mut python = Command::new("python3");
    // Without compiled files beside the sources.
    python.arg("-B").args([program, page::path()]);
    let piped = python.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let Ok(mut python) = piped.spawn() else {
        skipped("no python3");
        return None;
    };
    // It reads to the end before it answers; where it stops before, what it says is told below.
    let _ = python.stdin.take().expect("a way in").write_all(asked.as_bytes());
    let ran = python.wait_with_output().expect("an end");
    assert!(ran.status.success(), "{}", String::from_utf8_lossy(&ran.stderr));
    Some(String::from_utf8(ran.stdout).expect("text"))
}
