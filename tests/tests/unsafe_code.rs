//! Every block of unsafe code says why it is sound, where it stands. Clippy asks the same (`undocumented_unsafe_blocks` is denied in
//! `Cargo.toml`); this test also runs where there is no clippy.

use dashpot_tests::library::root;
use std::path::{Path, PathBuf};

fn sources(folder: &Path, all: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).unwrap().map(|e| e.unwrap().path()) {
        match entry.file_name().and_then(|n| n.to_str()) {
            Some("target" | ".git" | ".venv") => {}
            _ if entry.is_dir() => sources(&entry, all),
            _ if entry.extension().is_some_and(|e| e == "rs") => all.push(entry),
            _ => {}
        }
    }
}

/// The code of a line, without its comment.
fn code(line: &str) -> &str {
    line.split("//").next().unwrap_or(line)
}

/// Whether a block of unsafe code, or an implementation of an unsafe trait, begins in this line.
fn begins_unsafe(line: &str) -> bool {
    let code = code(line);
    code.contains("unsafe {") || code.contains("unsafe impl")
}

/// Lines of unsafe code without a reason: none in the comment above their statement.
fn without_reason(text: &str) -> Vec<usize> {
    let lines: Vec<&str> = text.lines().collect();
    let is_comment = |k: usize| lines[k].trim_start().starts_with("//");
    let unreasoned = |k: usize| {
        // A statement may run over several lines, and several of them begin unsafe code in it.
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
        sources(&root().join(folder), &mut files);
    }
    let (mut blocks, mut wrong) = (0, Vec::new());
    for file in &files {
        let text = std::fs::read_to_string(file).unwrap();
        if file.file_name().is_some_and(|n| n == "unsafe_code.rs") {
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
