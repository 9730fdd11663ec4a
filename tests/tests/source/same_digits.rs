//! Tests that all shipped code uses the elementary functions (exp, sin, ...) of crate `libm`. A fit then gives equal
//! digits on every system and in every thread.
//!
//! Rust's standard library calls the elementary functions of the system's C library. glibc selects an implementation by
//! the processor. MinGW on Windows uses the x87 unit, whose precision differs between the main thread and threads
//! started later.

use dashpot_test_support::rust_files;
use dashpot_tests::library::root;

/// Functions of Rust's standard library that call the system's C library. Square roots, rounding, remainders and fused
/// products are not among them, because they are exact everywhere.
const SYSTEMS: [&str; 25] = [
    "powf", "exp", "exp2", "exp_m1", "ln", "ln_1p", "log", "log2", "log10", "sin", "cos", "tan", "sin_cos", "asin",
    "acos", "atan", "atan2", "sinh", "cosh", "tanh", "asinh", "acosh", "atanh", "hypot", "cbrt",
];

/// Files whose calls are methods of numbers with derivatives (automatic differentiation). These methods have the names
/// of the functions in [`SYSTEMS`]. The test covers the files that define the methods.
const OF_NUMBERS_WITH_DERIVATIVES: [&str; 1] = ["src/other_lab/src/protocol/waveform.rs"];

/// Returns the name from [`SYSTEMS`] that a line of code calls, or `None` if it calls none.
fn calls(line: &str) -> Option<&'static str> {
    let code = line.split("//").next().unwrap_or(line);
    // Two dots do not begin a method call: `..log(x)` sets the other fields of a structure.
    let as_method = |name: &str| {
        let call = format!(".{name}(");
        code.match_indices(&call).any(|(at, _)| !code[..at].ends_with('.'))
    };
    let as_function = |name: &str| {
        code.split("f64::").skip(1).any(|after| {
            after.strip_prefix(name).is_some_and(|rest| !rest.starts_with(|c: char| c.is_alphanumeric() || c == '_'))
        })
    };
    SYSTEMS.into_iter().find(|name| as_method(name) || as_function(name))
}

#[test]
fn nothing_that_ships_computes_with_the_systems_functions() {
    let (mut looked_at, mut wrong) = (0, Vec::new());
    for file in rust_files(&root().join("src")).unwrap() {
        let name = file.strip_prefix(root()).unwrap().display().to_string();
        if name.contains("/tests/") {
            continue;
        }
        // The kernel does not use the standard library. Its numbers with derivatives define methods with the names in
        // [`SYSTEMS`].
        if name.starts_with("src/core/") || OF_NUMBERS_WITH_DERIVATIVES.contains(&name.as_str()) {
            continue;
        }
        looked_at += 1;
        let text = std::fs::read_to_string(&file).unwrap();
        // Unit tests are at the end of a file and are not checked.
        let ships = text.split("#[cfg(test)]\nmod ").next().unwrap_or(&text);
        wrong.extend(
            ships.lines().enumerate().filter_map(|(k, line)| Some(format!("{name}:{}: `{}`", k + 1, calls(line)?))),
        );
    }
    assert!(looked_at > 300, "only {looked_at} files were looked at");
    assert!(wrong.is_empty(), "these are to be taken from crate libm:\n{}", wrong.join("\n"));
}

#[test]
fn a_call_of_the_systems_function_is_seen() {
    assert_eq!(calls("let x = 2.0 * (a + b).powf(c);"), Some("powf"));
    assert_eq!(calls("values.fold(0.0, f64::hypot)"), Some("hypot"));
    assert_eq!(calls("let x = libm::exp(y).sqrt(); // y.exp()"), None);
    assert_eq!(calls("f64::expected(x)"), None);
    assert_eq!(calls("Fresh { deviation, ..log(number) }"), None);
}
