//! Numbers for people.

/// Five significant digits.
pub fn short(value: f64) -> String {
    if value == 0.0 || !(1e-3..1e6).contains(&value.abs()) {
        return if value == 0.0 { "0".to_owned() } else { format!("{value:.4e}") };
    }
    let digits = (4 - libm::log10(value.abs()).floor() as i32).max(0) as usize;
    format!("{value:.digits$}")
}
