//! Number formats of the report: significant digits only, in a damper engineer's units.

use crate::plot::ticks::number;
use crate::words::Words;
use dashpot_records::Reading;
use dashpot_records::newtons::places;

/// Formats a force, N, without decimals. Below 10 N it has two digits, for small dampers.
pub fn force(newton: f64) -> String {
    number(newton, places(newton, 0))
}

/// Formats a difference of forces, N, with one decimal. Below 1 N the text has two digits, because the whole error of a small damper may be
/// below 1 N.
pub fn error(newton: f64) -> String {
    number(newton, places(newton, 1))
}

/// Formats a percentage with two decimals.
pub fn percent(value: f64) -> String {
    number(value, 2)
}

/// Formats a displacement, m, in mm, or a velocity, m/s, in mm/s, with three digits.
pub fn milli(si: f64) -> String {
    digits(1e3 * si, 3)
}

/// Formats a frequency, Hz, with three digits.
pub fn frequency(hertz: f64) -> String {
    digits(hertz, 3)
}

/// Formats a value with `significant` digits. Very large and very small values have a power of ten.
pub fn digits(value: f64, significant: i32) -> String {
    typographic(&dashpot_records::digits(value, significant))
}

/// Replaces the ASCII minus of a number.
pub(crate) fn typographic(number: &str) -> String {
    number.replace('-', "\u{2212}")
}

/// Formats a value with the decimals that give `reference` three digits. Figures in one comparison then end at the same decimal. Values
/// that are negligible relative to `reference` appear as zero.
pub fn comparable(value: f64, reference: f64) -> String {
    let exponent = if reference == 0.0 { 0.0 } else { libm::log10(reference.abs()).floor() };
    number(value, (2.0 - exponent).clamp(0.0, 6.0) as usize)
}

/// Formats a value in the SI unit `unit` with four digits, in the unit that engineers use for the quantity: mm, N/mm, ms.
pub fn with_unit(value: f64, unit: &str) -> String {
    let reading = Reading::single(value, unit);
    spaced(typographic(&reading.value), &reading.unit)
}

/// Formats a value and its interval, given in the SI unit `unit`, in one unit: `2.41 N/mm` and `2.37 to 2.45 N/mm`.
pub fn with_interval(value: f64, low: f64, high: f64, unit: &str, words: &Words) -> (String, String) {
    reading(&Reading::new(value, low, high, unit), words)
}

/// Formats a reading as the texts of two cells: the value, and the ends of its interval.
pub fn reading(of: &Reading, words: &Words) -> (String, String) {
    let [value, low, high] = [&of.value, &of.low, &of.high].map(|text| typographic(text));
    let ends = words.fill_as_is(words.range, &[("low", &low), ("high", &high)]);
    (spaced(value, &of.unit), spaced(ends, &of.unit))
}

fn spaced(figures: String, unit: &str) -> String {
    if unit.is_empty() { figures } else { format!("{figures}\u{a0}{unit}") }
}

/// Formats a fraction in percent, without decimals.
pub fn fraction(value: f64) -> String {
    if value.is_finite() { format!("{}\u{a0}%", number(100.0 * value, 0)) } else { "–".into() }
}

/// Formats the closed fraction of a gap between error and noise, in percent, and returns whether the gap became smaller. If the gap became
/// larger, the text states its growth in percent. An error below the noise counts as a fraction of 100 %.
pub fn closed_gap(closed: f64) -> (String, bool) {
    (fraction(closed.min(1.0).abs()), closed >= 0.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::words::EN;

    #[test]
    fn a_gap_is_closed_by_all_of_it_at_most_and_a_larger_error_is_growth() {
        let of = |closed| {
            closed_gap(closed).0.replace('\u{a0}', " ") + if closed_gap(closed).1 { " closed" } else { " more" }
        };
        assert_eq!([0.9, 3.26, -0.79].map(of), ["90 % closed", "100 % closed", "79 % more"]);
    }

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
        assert_eq!(
            [comparable(-12.94, -12.94), comparable(6.6e-13, -12.94), comparable(1102.4, 999.0)],
            ["−12.9", "0.0", "1102"]
        );
        assert_eq!([error(-1e-12), error(-0.04), error(0.997), error(23.46)], ["0.0", "−0.040", "1.0", "23.5"]);
        assert_eq!([force(0.0), force(3.04), force(13.4), force(-2100.6)], ["0", "3.0", "13", "−2101"]);
    }

    #[test]
    fn parameters_are_written_in_the_units_of_the_workshop() {
        let cases = [
            (0.0125, "m", "12.50 mm"),
            (66.528, "N/m", "0.06653 N/mm"),
            (2.4e6, "N/m", "2400 N/mm"),
            (0.00031, "s", "0.3100 ms"),
            (640.0, "s", "640.0 s"),
            (2023.15, "N s/m", "2023 N·s/m"),
            (12.0, "N s^2/m^2", "12.00 N·s²/m²"),
            (0.4, "-", "0.4000"),
        ];
        for (value, unit, text) in cases {
            assert_eq!(with_unit(value, unit).replace('\u{a0}', " "), text);
        }
        let plain = |(a, b): (String, String)| (a.replace('\u{a0}', " "), b.replace('\u{a0}', " "));
        let of = |value, low, high, unit| plain(with_interval(value, low, high, unit, &EN));
        assert_eq!(of(2412.0, 2371.0, 2453.0, "N/m"), ("2.412 N/mm".into(), "2.371 to 2.453 N/mm".into()));
        assert_eq!(of(66.5, 50.9, 82.1, "N/m"), ("0.067 N/mm".into(), "0.051 to 0.082 N/mm".into()));
        assert_eq!(of(140.0, 139.9, 140.1, "N"), ("140.0 N".into(), "139.9 to 140.1 N".into()));
        assert_eq!(of(1.0, f64::NEG_INFINITY, f64::INFINITY, "N"), ("1.000 N".into(), "– to – N".into()));
    }
}
