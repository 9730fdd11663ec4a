//! Formats of numbers and sentences in the language and the units on screen.

use crate::restated;
use crate::units::{Shown, Units};
use crate::words::{Language, Words, texts};
use dashpot_messages::Sentence;
use dashpot_records::{Reading, reading_unit};
use dashpot_report::numbers;
use dashpot_report::words::Words as ReportWords;

/// Language and units in which a view formats numbers and sentences.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Format {
    /// Language of the texts.
    pub language: Language,
    /// Units of the numbers.
    pub units: Units,
}

impl Format {
    /// Returns the texts of the window.
    pub fn texts(self) -> &'static Words {
        texts(self.language)
    }

    /// Returns the texts of the reports.
    pub fn words(self) -> &'static ReportWords {
        self.language.words()
    }

    /// Formats a sentence.
    pub fn say(self, sentence: &Sentence) -> String {
        restated::restate_sentence(sentence, self.units, self.words())
    }

    /// Formats a text of the reports, which states SI units and contains no names of tests.
    pub fn restate(self, text: &str) -> String {
        restated::restate_text(text, self.units, self.words())
    }

    /// Formats a quantity, given in an SI unit, with four digits.
    pub fn quantity(self, value: f64, si: &str) -> String {
        self.interval(value, f64::NAN, f64::NAN, si).0
    }

    /// Formats a quantity and the ends of its interval, given in an SI unit. The width of the interval determines the digits.
    pub fn interval(self, value: f64, low: f64, high: f64, si: &str) -> (String, String) {
        let Shown { factor, symbol } = self.unit(value, si);
        let reading = Reading::in_unit([value, low, high].map(|number| factor * number), &symbol);
        let (value, interval) = numbers::reading(&reading, self.words());
        (self.words().number(&value), self.words().number(&interval))
    }

    /// Formats a quantity with its interval in brackets.
    pub fn with_interval(self, value: f64, low: f64, high: f64, si: &str) -> String {
        let (value, interval) = self.interval(value, low, high, si);
        format!("{value} ({interval})")
    }

    /// Formats a difference of forces, given in N, with the digits of the reports.
    pub fn error(self, newton: f64) -> String {
        let Shown { factor, symbol } = self.units.force();
        let figures = match newton.is_finite() {
            // The reports state N with fixed decimals. With these decimals, a small error in a larger unit would be rounded to zero.
            true if factor == 1.0 => numbers::error(newton),
            true => numbers::digits(factor * newton, 3),
            false => "–".to_owned(),
        };
        format!("{}\u{a0}{symbol}", self.words().number(&figures))
    }

    /// Returns the unit of a quantity: the selected unit, or otherwise the unit of the reports, which depends on the magnitude of `value`.
    fn unit(self, value: f64, si: &str) -> Shown {
        if self.units.is_selected(si) {
            return self.units.shown(si);
        }
        let (factor, symbol) = reading_unit(value, si);
        Shown { factor, symbol }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::units::{Force, Velocity};

    #[test]
    fn quantities_have_the_selected_units_and_the_digits_of_their_intervals() {
        let of = |velocity, force| Format { language: Language::English, units: Units { velocity, force } };
        let plain = |text: String| text.replace('\u{a0}', " ");
        let pounds = of(Velocity::InchesPerSecond, Force::Pounds);
        let kilo = of(Velocity::MillimetersPerSecond, Force::Kilonewtons);
        let usual = of(Velocity::MetersPerSecond, Force::Newtons);
        for (format, wanted) in [
            (usual, ["151.9 N", "4655 N/mm", "0.09230 m/s", "2.000 ms"]),
            (kilo, ["0.1519 kN", "4.655 kN/mm", "92.30 mm/s", "2.000 ms"]),
            (pounds, ["34.15 lbf", "26581 lbf/in", "3.634 in/s", "2.000 ms"]),
        ] {
            let all = [(151.9, "N"), (4.655e6, "N/m"), (0.0923, "m/s"), (0.002, "s")];
            assert_eq!(all.map(|(value, si)| plain(format.quantity(value, si))), wanted);
        }
        assert_eq!(plain(kilo.with_interval(140.0, 130.0, 150.0, "N")), "0.140 kN (0.130 to 0.150 kN)");
        assert_eq!(plain(usual.error(23.46)), "23.5 N");
        assert_eq!(plain(kilo.error(2.346)), "0.00235 kN");
    }
}
