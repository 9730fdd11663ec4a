//! Formatting of step limits for messages.

/// Formats a limit rounded down to three significant digits, or to an integer from 100 on.
pub(crate) fn plain(limit: f64) -> String {
    let digits = (2.0 - libm::log10(limit.abs().max(1e-9)).floor()).clamp(0.0, 9.0) as usize;
    let scale = 10f64.powi(digits as i32);
    format!("{}", (limit * scale * (1.0 + 1e-12)).floor() / scale)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_limit_is_never_told_larger_than_it_is() {
        for (limit, told) in
            [(6.5358, "6.53"), (0.81699, "0.816"), (0.5, "0.5"), (1234.56, "1234"), (0.00012349, "0.000123")]
        {
            assert_eq!(plain(limit), told);
        }
    }
}
