//! Tests that every block of unsafe code has a comment that justifies it. Clippy requires this, too
//! (`undocumented_unsafe_blocks` is denied in `Cargo.toml`), but this test also runs without Clippy. If the tools are
//! available, the C interface runs with memory checks.

use dashpot_test_support::{rust_files, skipped};
use dashpot_tests::library::root;
use std::process::Command;

/// Returns the code of a line, without its comment.
fn code(line: &str) -> &str {
    line.split("//").next().unwrap_or(line)
}

/// Returns whether a line begins a block of unsafe code, or an implementation of an unsafe trait.
fn begins_unsafe(line: &str) -> bool {
    let code = code(line);
    code.contains("unsafe {") || code.contains("unsafe impl")
}

/// Returns the numbers of the lines of a Rust file that begin unsafe code without `SAFETY:` in the comment above their
/// statement.
fn without_reason(text: &str) -> Vec<usize> {
    let lines: Vec<&str> = text.lines().collect();
    let is_comment = |k: usize| lines[k].trim_start().starts_with("//");
    let unreasoned = |k: usize| {
        // A statement may have several lines, so the comment may be up to four lines above the line with `unsafe`.
        let mut above = k;
        while above > 0 && !is_comment(above) && k - above < 4 {
            above -= 1;
        }
        let mut reason = false;
        while is_comment(above) {
            reason |= lines[above].contains("SAFETY:");
            if above == 0 {
                break;
            }
            above -= 1;
        }
        !reason
    };
    (0..lines.len()).filter(|k| begins_unsafe(lines[*k]) && unreasoned(*k)).map(|k| k + 1).collect()
}

#[test]
fn every_block_of_unsafe_code_says_why_it_is_sound() {
    let mut files = Vec::new();
    for folder in ["src", "tests", "examples", "adams-usersub", "vi-crt-bridge"] {
        files.extend(rust_files(&root().join(folder)).unwrap());
    }
    let (mut blocks, mut wrong) = (0, Vec::new());
    for file in &files {
        let text = std::fs::read_to_string(file).unwrap();
        if file.file_name().is_some_and(|n| n == "memory_safety.rs") {
            continue;
        }
        blocks += text.lines().filter(|line| begins_unsafe(line)).count();
        wrong.extend(without_reason(&text).into_iter().map(|line| format!("{}, line {line}", file.display())));
    }
    assert!(blocks > 50, "{blocks} blocks of unsafe code in {} files: are these the sources?", files.len());
    assert!(wrong.is_empty(), "no line SAFETY: above\n  {}", wrong.join("\n  "));
}

#[test]
fn a_block_without_a_reason_is_found() {
    assert_eq!(without_reason("let a = 1;\nlet b = unsafe { *p };"), [2]);
    assert!(without_reason("// SAFETY: p is ours.\nlet b = unsafe { *p };").is_empty());
    assert_eq!(without_reason("// p is ours.\nlet b = unsafe { *p };"), [2]);
    assert!(without_reason("// unsafe { in words }").is_empty());
}

/// Runs the tests of the C interface (`src/abi/tests/memory/main.rs`) with Rust's nightly compiler, which memory checks
/// require.
///
/// Returns `None` if cargo fails with the arguments `asks_for`, because a component is missing. Otherwise returns
/// whether the tests passed, and the output of the run.
fn watched(asks_for: &[&str], run: &[&str], flags: &str, folder: &str) -> Option<(bool, String)> {
    let cargo = |args: &[&str]| {
        let mut command = Command::new("cargo");
        // These variables select the compiler of this test run. The checks need another compiler.
        for name in ["RUSTUP_TOOLCHAIN", "RUSTC", "CARGO", "RUSTC_WRAPPER"] {
            command.env_remove(name);
        }
        command
            .arg("+nightly")
            .args(args)
            .current_dir(root())
            .env("CARGO_TARGET_DIR", root().join("target").join(folder));
        // Without optimization and incremental compilation, the kernel compiles in a fifth of the time.
        command
            .env("CARGO_PROFILE_DEV_OPT_LEVEL", "0")
            .env("CARGO_PROFILE_DEV_DEBUG", "0")
            .env("CARGO_INCREMENTAL", "0");
        command.env("RUSTFLAGS", flags).output()
    };
    if !cargo(asks_for).is_ok_and(|out| out.status.success()) {
        return None;
    }
    let out = cargo(run).unwrap();
    let told = String::from_utf8_lossy(&out.stdout).into_owned() + &String::from_utf8_lossy(&out.stderr);
    Some((out.status.success() && told.contains("7 passed"), told))
}

#[test]
fn miri_finds_no_fault_in_the_interface() {
    // Miri does not execute assembly, so crate `libm` is compiled without it.
    let run = "miri test -p dashpot-core -p dashpot-abi --features libm/force-soft-floats --test memory";
    match watched(&["miri", "--version"], &run.split(' ').collect::<Vec<_>>(), "", "miri") {
        None => skipped("no Miri (rustup toolchain install nightly --component miri,rust-src)"),
        Some((holds, told)) => assert!(holds, "{told}"),
    }
}

#[test]
fn the_address_sanitizer_finds_no_fault_in_the_interface() {
    let target = format!("{}-unknown-linux-gnu", std::env::consts::ARCH);
    let run = ["test", "-p", "dashpot-abi", "--target", &target, "--test", "memory"];
    match watched(&["--version"], &run, "-Zsanitizer=address", "asan") {
        None => skipped("no nightly Rust (rustup toolchain install nightly)"),
        Some((holds, told)) => assert!(holds, "{told}"),
    }
}
