//! SI inside, an engineer's units on the screen. The only place of the window where units change.

/// Factor from SI and the symbol that is shown.
#[derive(Debug, Clone, PartialEq)]
pub struct Shown {
    /// Shown = factor · SI.
    pub factor: f64,
    /// Symbol; empty for a pure number.
    pub symbol: String,
}

/// How a quantity of an SI unit is shown. One unit a parameter, whatever its value: a slider must not change it while it moves.
pub fn shown(unit: &str) -> Shown {
    let (factor, symbol) = match unit {
        "m" => (1e3, "mm"),
        "s" => (1e3, "ms"),
        "N/m" => (1e-3, "N/mm"),
        "N/m^2" => (1e-6, "N/mm²"),
        "N/m^3" => (1e-9, "N/mm³"),
        "N/m^4" => (1e-12, "N/mm⁴"),
        "-" => (1.0, ""),
        other => {
            let raised = other.replace("^2", "²").replace("^3", "³").replace("^4", "⁴").replace("^k", "ᵏ");
            return Shown { factor: 1.0, symbol: raised.replace(' ', "·") };
        }
    };
    Shown { factor, symbol: symbol.to_owned() }
}

/// A number with four significant digits, as people write it.
pub fn digits(value: f64) -> String {
    dashpot_report::numbers::digits(value, 4)
}

/// A number for a field that is typed into: as few digits as say it to six places.
pub fn typed(value: f64) -> String {
    if value == 0.0 {
        return "0".into();
    }
    let exponent = libm::log10(value.abs()).floor();
    if !(-5.0..7.0).contains(&exponent) {
        return format!("{value:.4e}");
    }
    let decimals = (5.0 - exponent).clamp(0.0, 9.0) as usize;
    let text = format!("{value:.decimals$}");
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
}

/// What was typed into a field: with a decimal comma or point, whatever the language, and any minus sign.
pub fn read(text: &str) -> Option<f64> {
    let plain = text.trim().replace(',', ".").replace('\u{2212}', "-");
    plain.parse().ok().filter(|value: &f64| value.is_finite())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::words::{Language, texts};

    #[test]
    fn numbers_are_shown_and_typed_as_the_language_writes_them() {
        for (language, shown, typed) in [
            (Language::English, "0.5123", "0.5123"),
            (Language::German, "0,5123", "0,5123"),
            (Language::French, "0,5123", "0,5123"),
            (Language::Chinese, "0.5123", "0.5123"),
        ] {
            let w = texts(language);
            assert_eq!((w.digits(0.5123).as_str(), w.typed(0.5123).as_str()), (shown, typed));
            for value in [0.0, -2345.678, 1.25e-4, 3e9, 0.5] {
                let back = read(&w.typed(value)).unwrap();
                assert!((back - value).abs() <= 1e-5 * value.abs(), "{value} {back}");
            }
        }
        assert_eq!(texts(Language::German).fixed(1.5, 2), "1,50");
        assert_eq!((read("1.5"), read("\u{2212}1,5"), read("x"), read("")), (Some(1.5), Some(-1.5), None, None));
    }

    #[test]
    fn every_unit_of_the_kernel_has_a_symbol() {
        for row in dashpot_core::parameter::table() {
            let shown = shown(row.parameter.unit);
            assert!(shown.factor > 0.0 && !shown.symbol.contains('^'), "{}", row.parameter.unit);
        }
        assert_eq!(shown("N s/m").symbol, "N·s/m");
    }

    #[test]
    fn typed_numbers_read_back() {
        for value in [0.0, 1.0, -2345.678, 1.25e-4, 3e9, 1e-9, 0.5] {
            let back: f64 = typed(value).parse().unwrap();
            assert!((back - value).abs() <= 1e-5 * value.abs(), "{value} {back}");
        }
        assert_eq!(typed(2500.0), "2500");
    }
}
