//! Ticks of an axis and their number format.

use crate::words::Words;
use dashpot_messages::format_decimals;

/// Ticks of an axis with their labels.
#[derive(Debug, Clone, PartialEq)]
pub struct Ticks {
    /// Position in the axis's unit, and label, of each tick.
    pub at: Vec<(f64, String)>,
}

impl Ticks {
    /// Returns about `wanted` ticks at multiples of 1, 2, 2.5 or 5 times a power of ten inside `low..=high`.
    pub fn linear(low: f64, high: f64, wanted: usize) -> Self {
        let span = high - low;
        if !(span.is_finite() && span > 0.0) {
            return Self { at: vec![] };
        }
        let rough = span / wanted.max(1) as f64;
        let decade = libm::pow(10f64, libm::log10(rough).floor());
        let factor = [1.0, 2.0, 2.5, 5.0, 10.0].into_iter().find(|f| f * decade >= rough * 0.999).unwrap_or(10.0);
        let step = factor * decade;
        let quarter = usize::from(factor == 2.5);
        let decimals = (-libm::log10(decade).round()).max(-(quarter as f64)) as i32 + quarter as i32;
        let decimals = if factor == 10.0 { decimals - 1 } else { decimals }.clamp(0, 12) as usize;
        let first = (low / step - 1e-9).ceil() as i64;
        let last = (high / step + 1e-9).floor() as i64;
        Self { at: (first..=last).map(|i| (i as f64 * step, number(i as f64 * step, decimals))).collect() }
    }

    /// Returns the ticks of a logarithmic axis inside `low..=high`, which must be positive. The ticks are powers of ten. If `high` is at
    /// most 2000 times `low`, 2 and 5 times a power of ten are included.
    pub fn logarithmic(low: f64, high: f64) -> Self {
        let factors: &[f64] = if high / low > 2e3 { &[1.0] } else { &[1.0, 2.0, 5.0] };
        let mut at = Vec::new();
        for exponent in libm::log10(low).floor() as i32..=libm::log10(high).ceil() as i32 {
            for factor in factors {
                let value = factor * 10f64.powi(exponent);
                if (low * 0.999..=high * 1.001).contains(&value) {
                    at.push((value, number(value, (-exponent).max(0) as usize)));
                }
            }
        }
        Self { at }
    }

    /// Returns about `wanted` ticks of an axis from `low` to `high` with a signed square-root scale.
    ///
    /// The ticks are zero and round values on both sides of it, with space for the labels.
    pub fn root(low: f64, high: f64, wanted: usize) -> Self {
        let place = |value: f64| value.signum() * value.abs().sqrt();
        let room = (place(high) - place(low)) / wanted.max(1) as f64;
        let mut at = Vec::new();
        if !(room.is_finite() && room > 0.0) {
            return Self { at };
        }
        if low <= 0.0 && high >= 0.0 {
            at.push((0.0, number(0.0, 0)));
        }
        for (sign, end) in [(1.0, high), (-1.0, -low)] {
            // Larger values come first, so that values near the ends of the axis get their ticks before values near zero.
            let mut last = f64::INFINITY;
            let mut exponent = libm::log10(end.max(f64::MIN_POSITIVE)).floor() as i32;
            while place(10f64.powi(exponent + 1)) >= 0.8 * room {
                for factor in [5.0, 2.0, 1.0] {
                    let value = sign * factor * 10f64.powi(exponent);
                    let here = place(value.abs());
                    if (low..=high).contains(&value) && here >= 0.8 * room && last - here >= 0.8 * room {
                        at.push((value, number(value, (-exponent).max(0) as usize)));
                        last = here;
                    }
                }
                exponent -= 1;
            }
        }
        at.sort_by(|a, b| a.0.total_cmp(&b.0));
        Self { at }
    }

    /// Returns the ticks with labels in the number format of a language.
    pub fn localized(self, words: &Words) -> Self {
        Self { at: self.at.into_iter().map(|(value, label)| (value, words.number(&label))).collect() }
    }
}

/// Formats a number with a typographic minus and without negative zero.
pub fn number(value: f64, decimals: usize) -> String {
    format_decimals(value, decimals).replace('-', "\u{2212}")
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    fn labels(ticks: &Ticks) -> Vec<&str> {
        ticks.at.iter().map(|(_, label)| label.as_str()).collect()
    }

    #[test]
    fn steps_are_round_and_labels_say_what_is_marked() {
        assert_eq!(labels(&Ticks::linear(-2100.0, 4050.0, 6)), ["−2000", "0", "2000", "4000"]);
        assert_eq!(labels(&Ticks::linear(-0.55, 0.55, 4)), ["−0.5", "0.0", "0.5"]);
        assert_eq!(labels(&Ticks::linear(0.0, 1.0, 4)), ["0.00", "0.25", "0.50", "0.75", "1.00"]);
        assert_eq!(labels(&Ticks::linear(0.0, 100.0, 4)), ["0", "25", "50", "75", "100"]);
        assert_eq!(labels(&Ticks::logarithmic(0.5, 50.0)), ["0.5", "1", "2", "5", "10", "20", "50"]);
    }

    #[test]
    fn any_range_gets_a_few_distinct_marks_inside_it() {
        for exponent in -6..7 {
            for part in 1..40 {
                let high = f64::from(part) * 0.37 * 10f64.powi(exponent);
                let low = -0.61 * high;
                let ticks = Ticks::linear(low, high, 5);
                assert!((2..=7).contains(&ticks.at.len()), "{high}: {ticks:?}");
                let distinct: BTreeSet<_> = ticks.at.iter().map(|(_, label)| label).collect();
                assert_eq!(distinct.len(), ticks.at.len(), "{high}: {ticks:?}");
                for (value, label) in &ticks.at {
                    assert!((low * 1.001..=high * 1.001).contains(value));
                    let read: f64 = label.replace('\u{2212}', "-").parse().unwrap();
                    assert!((read - value).abs() < 1e-9 * high.max(1.0), "{label} marks {value}");
                }
            }
        }
    }

    #[test]
    fn a_root_axis_is_marked_on_both_sides_of_zero() {
        assert_eq!(labels(&Ticks::root(-1600.0, 1600.0, 9)), ["−1000", "−500", "−200", "0", "200", "500", "1000"]);
        assert_eq!(labels(&Ticks::root(3.0, 30.0, 4)).len(), 3);
        assert!(Ticks::root(0.0, 0.0, 5).at.is_empty());
    }

    #[test]
    fn an_empty_range_has_no_marks() {
        assert!(Ticks::linear(1.0, 1.0, 5).at.is_empty() && Ticks::linear(0.0, f64::NAN, 5).at.is_empty());
    }
}
