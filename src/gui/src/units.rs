//! Conversion between SI and the units on screen. The module contains all conversions of the window.

/// A unit on screen.
#[derive(Debug, Clone, PartialEq)]
pub struct Shown {
    /// Displayed value divided by the SI value.
    pub factor: f64,
    /// Symbol; empty for a pure number.
    pub symbol: String,
}

/// Unit of velocities, which also selects the unit of lengths.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Velocity {
    /// m/s, and mm.
    #[default]
    MetersPerSecond,
    /// mm/s, and mm.
    MillimetersPerSecond,
    /// in/s, and in.
    InchesPerSecond,
}

/// Unit of forces.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Force {
    /// N.
    #[default]
    Newtons,
    /// kN.
    Kilonewtons,
    /// Pounds of force.
    Pounds,
}

impl Velocity {
    /// All units of velocity.
    pub const ALL: [Velocity; 3] =
        [Velocity::MetersPerSecond, Velocity::MillimetersPerSecond, Velocity::InchesPerSecond];
}

impl Force {
    /// All units of force.
    pub const ALL: [Force; 3] = [Force::Newtons, Force::Kilonewtons, Force::Pounds];
}

/// Length of an inch, m, by definition.
const INCH: f64 = 0.0254;
/// Pound-force, N, by definition (0.45359237 kg times 9.80665 m/s²).
const POUND: f64 = 4.448_221_615_260_5;

/// The units that the user chose.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Units {
    /// Unit of velocities and lengths.
    pub velocity: Velocity,
    /// Unit of forces.
    pub force: Force,
}

impl Units {
    /// Returns the displayed unit of velocities.
    pub fn velocity(self) -> Shown {
        Shown::new(match self.velocity {
            Velocity::MetersPerSecond => (1.0, "m/s"),
            Velocity::MillimetersPerSecond => (1e3, "mm/s"),
            Velocity::InchesPerSecond => (1.0 / INCH, "in/s"),
        })
    }

    /// Returns the displayed unit of lengths.
    pub fn length(self) -> Shown {
        Shown::new(if self.velocity == Velocity::InchesPerSecond { (1.0 / INCH, "in") } else { (1e3, "mm") })
    }

    /// Returns the displayed unit of forces.
    pub fn force(self) -> Shown {
        Shown::new(match self.force {
            Force::Newtons => (1.0, "N"),
            Force::Kilonewtons => (1e-3, "kN"),
            Force::Pounds => (1.0 / POUND, "lbf"),
        })
    }

    /// Returns the displayed unit of work: J for N and kN, because 1 J is 1 N m and 1 kN mm. For pounds, it is the product of the length
    /// unit and the pound-force.
    pub fn energy(self) -> Shown {
        match self.force {
            Force::Newtons | Force::Kilonewtons => Shown::new((1.0, "J")),
            Force::Pounds => {
                let (force, length) = (self.force(), self.length());
                Shown { factor: force.factor * length.factor, symbol: format!("{}·{}", length.symbol, force.symbol) }
            }
        }
    }

    /// Returns whether the displayed unit of an SI unit follows from the selected units.
    pub fn is_selected(self, unit: &str) -> bool {
        let of_force = ["N", "N/m", "N/m^2", "N/m^3", "N/m^4", "N s/m", "N s^2/m^2", "N/K"];
        of_force.contains(&unit) || ["m", "m/s", "s/m"].contains(&unit)
    }

    /// Returns the displayed unit for an SI unit. The unit does not depend on the value, so it stays constant while a slider moves.
    pub fn shown(self, unit: &str) -> Shown {
        let (force, length, velocity) = (self.force(), self.length(), self.velocity());
        let per_length = |power: i32, mark: &str| Shown {
            factor: force.factor / length.factor.powi(power),
            symbol: format!("{}/{}{mark}", force.symbol, length.symbol),
        };
        let way = velocity.symbol.trim_end_matches("/s").to_owned();
        match unit {
            "m" => length,
            "m/s" => velocity,
            "N" => force,
            "s" => Shown::new((1e3, "ms")),
            "N/m" => per_length(1, ""),
            "N/m^2" => per_length(2, "²"),
            "N/m^3" => per_length(3, "³"),
            "N/m^4" => per_length(4, "⁴"),
            "N s/m" => Shown { factor: force.factor / velocity.factor, symbol: format!("{}·s/{way}", force.symbol) },
            "N s^2/m^2" => Shown {
                factor: force.factor / velocity.factor.powi(2),
                symbol: format!("{}·s²/{way}²", force.symbol),
            },
            "s/m" => Shown { factor: 1.0 / velocity.factor, symbol: format!("s/{way}") },
            "N/K" => Shown { factor: force.factor, symbol: format!("{}/K", force.symbol) },
            "-" => Shown::new((1.0, "")),
            other => {
                let raised = other.replace("^2", "²").replace("^3", "³").replace("^4", "⁴").replace("^k", "ᵏ");
                Shown { factor: 1.0, symbol: raised.replace(' ', "·") }
            }
        }
    }
}

impl Shown {
    fn new((factor, symbol): (f64, &str)) -> Shown {
        Shown { factor, symbol: symbol.to_owned() }
    }
}

/// Formats a number with four significant digits.
pub fn digits(value: f64) -> String {
    dashpot_report::numbers::digits(value, 4)
}

/// Formats a number for an input field, with six significant digits and without trailing zeros. Very large and very small numbers have an
/// exponent.
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

/// Parses the text of an input field. Accepts a decimal comma or point in every language, and any minus sign.
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
            for (velocity, force) in Velocity::ALL.into_iter().flat_map(|v| Force::ALL.map(|f| (v, f))) {
                let shown = Units { velocity, force }.shown(row.parameter.unit);
                assert!(shown.factor > 0.0 && !shown.symbol.contains('^'), "{}", row.parameter.unit);
            }
        }
        assert_eq!(Units::default().shown("N s/m").symbol, "N·s/m");
        assert_eq!(Units::default().shown("N/m"), Shown { factor: 1e-3, symbol: "N/mm".into() });
    }

    #[test]
    fn chosen_units_are_those_of_the_trade() {
        let pounds = Units { velocity: Velocity::InchesPerSecond, force: Force::Pounds };
        let near = |shown: Shown, factor: f64, symbol: &str| {
            assert!((shown.factor / factor - 1.0).abs() < 1e-6 && shown.symbol == symbol, "{shown:?}");
        };
        // 1 m/s is 39.37 in/s, 1000 N are 224.809 lbf, 1 N/mm is 5.710147 lbf/in, 1 N·s/m is 0.005710147 lbf·s/in.
        near(pounds.velocity(), 39.370_078_7, "in/s");
        near(pounds.shown("N"), 0.224_808_943, "lbf");
        near(pounds.shown("m"), 39.370_078_7, "in");
        near(pounds.shown("N/m"), 0.005_710_147, "lbf/in");
        near(pounds.shown("N s/m"), 0.005_710_147, "lbf·s/in");
        // 1 J is 8.850746 in·lbf.
        near(pounds.energy(), 8.850_746, "in·lbf");
        let kilo = Units { velocity: Velocity::MillimetersPerSecond, force: Force::Kilonewtons };
        near(kilo.shown("N s/m"), 1e-6, "kN·s/mm");
        near(kilo.shown("m/s"), 1e3, "mm/s");
        near(kilo.shown("N/m^2"), 1e-9, "kN/mm²");
        near(kilo.energy(), 1.0, "J");
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
