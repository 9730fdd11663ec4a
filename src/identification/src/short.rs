//! Numbers in comments and sentences.

/// Four significant digits: enough for a comment or a sentence.
pub(super) fn short(value: f64) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    let digits = (3 - value.abs().log10().floor() as i32).max(0) as usize;
    if value.abs() >= 1e5 { format!("{value:.3e}") } else { format!("{value:.digits$}") }
}
