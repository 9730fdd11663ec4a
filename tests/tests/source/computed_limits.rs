//! Tests that no code calls `clamp` with computed limits. `clamp` panics if the lower limit exceeds the upper one, and
//! a panic ends the program. For computed limits, code uses `dashpot_records::restrict`, or `max` and `min` in crates
//! that do not use crate `dashpot-records`.

use dashpot_test_support::rust_files;
use dashpot_tests::library::root;

/// Returns whether the text of a limit is a literal number, a constant (also with `.0` or `.1`) or `0.5 * STEP`.
fn is_written(limit: &str) -> bool {
    let limit = limit.trim().trim_start_matches('-');
    let is_number = limit.replace('_', "").parse::<f64>().is_ok();
    let constant = limit.trim_end_matches(".0").trim_end_matches(".1");
    let is_constant =
        !constant.is_empty() && constant.chars().all(|c| c.is_ascii_uppercase() || c.is_ascii_digit() || c == '_');
    is_number || is_constant || limit == "0.5 * STEP"
}

/// Returns the limits in a call of `clamp`, from the text after the opening parenthesis of the call.
fn limits(text: &str) -> Vec<String> {
    let (mut depth, mut found) = (0, vec![String::new()]);
    for letter in text.chars() {
        match letter {
            '(' | '[' => depth += 1,
            ')' | ']' if depth == 0 => break,
            ')' | ']' => depth -= 1,
            ',' if depth == 0 => {
                found.push(String::new());
                continue;
            }
            _ => {}
        }
        found.last_mut().unwrap().push(letter);
    }
    found
}

#[test]
fn limits_of_clamp_are_written_in_the_code() {
    assert_eq!(limits("0.0, last(x, 1)) + 2"), ["0.0", " last(x, 1)"]);
    assert!(
        is_written("-1.5") && is_written("SLOW.1") && is_written("1e-3") && !is_written("low") && !is_written("n - 1")
    );
    let (mut seen, mut wrong) = (0, Vec::new());
    for file in rust_files(&root().join("src")).unwrap() {
        let name = file.strip_prefix(root()).unwrap().display().to_string();
        if name.contains("/tests/") {
            continue;
        }
        let text = std::fs::read_to_string(&file).unwrap();
        // Test modules are at the end of a file and are not checked.
        let code = text.split("#[cfg(test)]\nmod tests").next().unwrap_or_default();
        for (at, call) in code.match_indices(".clamp(") {
            seen += 1;
            let limits = limits(&code[at + call.len()..]);
            if limits.len() == 2 && !limits.iter().all(|limit| is_written(limit)) {
                let line = code[..at].matches('\n').count() + 1;
                wrong.push(format!("{name}:{line}: {}", limits.join(",")));
            }
        }
    }
    assert!(seen > 20, "only {seen} calls were seen");
    assert!(wrong.is_empty(), "limits that are computed: {wrong:#?}");
}
