//! How the report writes figures: as many digits as mean something, in a damper engineer's units.

use crate::plot::ticks::number;

/// A force, N.
pub fn force(newton: f64) -> String {
    number(newton, 0)
}

/// A difference of forces, N, to a tenth.
pub fn error(newton: f64) -> String {
    number(newton, 1)
}

/// A percentage, to a hundredth.
pub fn percent(value: f64) -> String {
    number(value, 2)
}

/// A displacement in mm or a velocity in mm/s from SI, three digits.
pub fn milli(si: f64) -> String {
    digits(1e3 * si, 3)
}

/// A frequency, Hz, three digits.
pub fn frequency(hertz: f64) -> String {
    digits(hertz, 3)
}

/// A value to so many significant digits; very large and very small ones as a power of ten.
pub fn digits(value: f64, significant: i32) -> String {
    if value == 0.0 || !value.is_finite() {
        return if value == 0.0 { "0".into() } else { "–".into() };
    }
    // Rounding may reach the next power of ten (999.6 is 1000), so read the exponent of the rounded value.
    let rounded = format!("{value:.*e}", (significant - 1).max(0) as usize);
    let (mantissa, exponent) = rounded.split_once('e').unwrap_or((&rounded, "0"));
    let exponent: i32 = exponent.parse().unwrap_or(0);
    if (-4..6).contains(&exponent) {
        return number(value, (significant - 1 - exponent).max(0) as usize);
    }
    format!("{}\u{b7}10{}", mantissa.replace('-', "\u{2212}"), superscript(exponent))
}

/// A value with as many decimals as give `reference` three digits: figures compared with each other end at the same
/// place, and what is nothing beside the reference reads as nothing.
pub fn beside(value: f64, reference: f64) -> String {
    let exponent = if reference == 0.0 { 0.0 } else { reference.abs().log10().floor() };
    number(value, (2.0 - exponent).clamp(0.0, 6.0) as usize)
}

/// A whole number in raised digits.
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
    fn significant_digits_survive_every_size() {
        let cases = [
            (1571.2, "1571"),
            (52.36, "52.4"),
            (0.0063694, "0.00637"),
            (999.96, "1000"),
            (-0.5, "−0.500"),
            (2.5e8, "2.50·10⁸"),
            (-3e-7, "−3.00·10⁻⁷"),
            (0.0, "0"),
            (f64::NAN, "–"),
        ];
        for (value, text) in cases {
            assert_eq!(digits(value, 3), text);
        }
        assert_eq!(milli(0.05), "50.0");
        assert_eq!([beside(-12.94, -12.94), beside(6.6e-13, -12.94), beside(1102.4, 999.0)], ["−12.9", "0.0", "1102"]);
        assert_eq!(error(-0.04), "0.0");
    }
}
