//! Text of a measured number with its interval. Tables and sentences use this text, so that they state the same digits.

use super::reading_unit::reading_unit;
use dashpot_messages::format_decimals;

/// Significant digits of a number without an interval.
const DIGITS: i32 = 4;

/// A value and the ends of its interval as text, in one unit. Negative numbers have an ASCII minus.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Reading {
    /// The value.
    pub value: String,
    /// Lower end of the interval.
    pub low: String,
    /// Upper end of the interval.
    pub high: String,
    /// The unit, empty for a ratio.
    pub unit: String,
}

impl Reading {
    /// Formats a value and its interval, given in an SI unit, in the unit that engineers use for the quantity.
    pub fn new(value: f64, low: f64, high: f64, si: &str) -> Reading {
        let (factor, unit) = reading_unit(value, si);
        Reading::in_unit([value, low, high].map(|number| factor * number), &unit)
    }

    /// Formats a value and the ends of its interval, which are already in the unit `unit`.
    pub fn in_unit([value, low, high]: [f64; 3], unit: &str) -> Reading {
        // Digits after the first two of the interval's half width are not significant.
        let half = 0.5 * (high - low).abs();
        let has_width = half.is_finite() && half > 0.0 && (1e-4..1e6).contains(&value.abs());
        let decimals = has_width.then(|| {
            let kept = (1.0 - libm::log10(half).floor()) as i32;
            let most = DIGITS - 1 - libm::log10(value.abs()).floor() as i32;
            kept.min(most).clamp(0, 9) as usize
        });
        let write = |number: f64| match decimals {
            Some(decimals) => format_decimals(number, decimals),
            None => digits(number, DIGITS),
        };
        Reading { value: write(value), low: write(low), high: write(high), unit: unit.to_owned() }
    }

    /// Formats a number without an interval, given in an SI unit.
    pub fn single(value: f64, si: &str) -> Reading {
        Reading::new(value, f64::NAN, f64::NAN, si)
    }

    /// Returns the value with its unit.
    pub fn with_unit(&self) -> String {
        format!("{} {}", self.value, self.unit).trim_end().to_owned()
    }
}

/// Formats a number with `significant` digits. Very large and very small numbers have a power of ten.
pub fn digits(value: f64, significant: i32) -> String {
    if value == 0.0 || !value.is_finite() {
        return if value == 0.0 { "0".into() } else { "–".into() };
    }
    // Rounding may reach the next power of ten (999.6 is 1000), so read the exponent of the rounded value.
    let rounded = format!("{value:.*e}", (significant - 1).max(0) as usize);
    let (mantissa, exponent) = rounded.split_once('e').unwrap_or((&rounded, "0"));
    let exponent: i32 = exponent.parse().unwrap_or(0);
    if (-4..6).contains(&exponent) {
        return format_decimals(value, (significant - 1 - exponent).max(0) as usize);
    }
    format!("{mantissa}\u{b7}10{}", superscript(exponent))
}

/// Formats a round number, such as one of a proposed test. The text has two significant digits without trailing zeros,
/// and no power of ten.
pub fn round_figure(value: f64) -> String {
    if value == 0.0 || !value.is_finite() {
        return "0".to_owned();
    }
    let decimals = 1 - libm::log10(value.abs()).floor() as i32;
    let scale = 10f64.powi(decimals);
    let text = format_decimals((value * scale).round() / scale, decimals.max(0) as usize);
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
}

/// Formats a whole number as a superscript.
fn superscript(value: i32) -> String {
    const RAISED: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let digits = value.unsigned_abs().to_string();
    let raised = digits.bytes().map(|digit| RAISED[usize::from(digit - b'0')]);
    if value < 0 { std::iter::once('⁻').chain(raised).collect() } else { raised.collect() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digits_of_value_and_ends_follow_the_width_of_the_interval() {
        let of = |value, low, high, si| {
            let r = Reading::new(value, low, high, si);
            [r.value, r.low, r.high, r.unit]
        };
        assert_eq!(of(4.82e6, 4.418e6, 4.939e6, "N/m"), ["4820", "4418", "4939", "N/mm"]);
        assert_eq!(of(0.000_635, 0.0005, 0.0007, "s"), ["0.64", "0.50", "0.70", "ms"]);
        assert_eq!(of(-832.4, -960.0, -472.0, "N"), ["-832", "-960", "-472", "N"]);
        assert_eq!(of(1e-9, 0.0, 0.0, "m/s"), ["1.000·10⁻⁶", "0", "0", "mm/s"]);
        assert_eq!(Reading::single(140.0, "N").with_unit(), "140.0 N");
        assert_eq!(Reading::single(0.4, "-").with_unit(), "0.4000");
        assert_eq!(
            [0.05, 30.0, 1000.0, 94.2, 0.0197, 0.0].map(round_figure),
            ["0.05", "30", "1000", "94", "0.02", "0"]
        );
    }
}
