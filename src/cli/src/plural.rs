//! Formatting of counts.

/// Formats a number of tests: `1 test`, `5 tests`.
pub fn count_tests(count: usize) -> String {
    if count == 1 { "1 test".to_owned() } else { format!("{count} tests") }
}
