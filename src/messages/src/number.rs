//! Numbers of the user in error messages.

/// Range of magnitudes of numbers without an exponent. In this range, plain digits are not longer than the form with an exponent.
const PLAIN: std::ops::Range<f64> = 1e-4..1e9;

/// Formats a number with the fewest digits that identify it. Very large and very small numbers have an exponent instead of hundreds of zeros.
pub fn format_number(value: f64) -> String {
    if value == 0.0 || !value.is_finite() || PLAIN.contains(&value.abs()) {
        // The sum removes the sign of a negative zero.
        return format!("{}", value + 0.0);
    }
    format!("{value:e}")
}

/// Formats a number with this number of decimals, without the sign of a negative zero. From a magnitude of 1e9 on, it has an exponent
/// instead.
pub fn format_decimals(value: f64, decimals: usize) -> String {
    if value.abs() >= PLAIN.end && value.is_finite() {
        return format!("{value:.3e}");
    }
    let text = format!("{value:.decimals$}");
    match text.strip_prefix('-') {
        Some(rest) if rest.bytes().all(|byte| matches!(byte, b'0' | b'.')) => rest.to_owned(),
        _ => text,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_of_any_size_are_short_and_exact() {
        for (value, text) in [
            (0.0, "0"),
            (-0.0, "0"),
            (0.0001, "0.0001"),
            (-999_999_999.5, "-999999999.5"),
            (1e9, "1e9"),
            (1e308, "1e308"),
            (-1e308, "-1e308"),
            (1e-308, "1e-308"),
            (f64::NAN, "NaN"),
            (f64::INFINITY, "inf"),
        ] {
            assert_eq!(format_number(value), text);
        }
        assert_eq!(format_decimals(1.0 / 3.0, 2), "0.33");
        assert_eq!([1e308, -1e9, 1e-308].map(|value| format_decimals(value, 1)), ["1.000e308", "-1.000e9", "0.0"]);
        assert_eq!([-0.004, -0.0, -0.006].map(|value| format_decimals(value, 2)), ["0.00", "0.00", "-0.01"]);
        for value in [f64::MAX, f64::MIN_POSITIVE, 5e-324, 0.1 + 0.2, -1.0 / 3e7] {
            let text = format_number(value);
            assert!(text.len() < 26 && text.parse() == Ok(value), "{text}");
        }
    }
}
