//! Counts as the terminal says them.

/// `1 test`, `5 tests`.
pub fn count_tests(count: usize) -> String {
    if count == 1 { "1 test".to_owned() } else { format!("{count} tests") }
}
