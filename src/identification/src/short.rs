//! Formatting of numbers in comments and sentences.

/// Returns the number of decimals that show four significant digits. The result is negative if the digits end before the decimal point.
fn decimals(value: f64) -> i32 {
    3 - libm::log10(value.abs()).floor() as i32
}

/// Formats a number with four significant digits for a comment of a model file. From 1e5 on, the number has an exponent.
pub(super) fn short(value: f64) -> String {
    if value.abs() >= 1e5 { format!("{value:.3e}") } else { in_words(value) }
}

/// Formats a number with four significant digits and without an exponent, for sentences of any language.
pub(super) fn in_words(value: f64) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    match decimals(value) {
        places @ 0.. => format!("{value:.0$}", places as usize),
        places => {
            let scale = 10f64.powi(-places);
            format!("{:.0}", (value / scale).round() * scale)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn four_digits_count_whatever_the_size() {
        for (value, words, code) in [
            (0.0, "0", "0"),
            (0.000_152_53, "0.0001525", "0.0001525"),
            (-12.3456, "-12.35", "-12.35"),
            (99_999.0, "100000", "100000"),
            (2_008_349.0, "2008000", "2.008e6"),
        ] {
            assert_eq!((in_words(value), short(value)), (words.to_owned(), code.to_owned()), "{value}");
        }
    }
}
