//! What an adjustable damper was set to in a test: the current of its valve, or the clicks of its adjuster. A channel tells it, or the name
//! of the test.

use serde::{Deserialize, Serialize};

use super::numbers::quantile;

/// A setting of an adjustable damper.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Setting {
    /// What is set: `current` or `clicks`.
    pub name: String,
    /// Its unit: `A`, or empty for clicks.
    pub unit: String,
    /// Its value in that unit.
    pub value: f64,
}

/// How far a channel may vary within a test and still be one setting.
///
/// As a share of its value, and in A, for noise of the sensor and the ripple of the current supply.
const STEADY: (f64, f64) = (0.1, 0.05);
/// Share of samples on either side that may be spikes or the switching on.
const SPIKES: f64 = 0.05;
/// Values that differ by less than this are one setting, A or clicks: supplies are set to hundredths.
pub(crate) const SAME: f64 = 0.02;

impl Setting {
    /// The setting that a channel of current, A, shows; the lowest and highest value where it is not steady.
    pub(crate) fn of_current(current: &[f64]) -> Result<Option<Setting>, (f64, f64)> {
        let mut values: Vec<f64> = current.iter().copied().filter(|v| v.is_finite()).collect();
        if values.is_empty() {
            return Ok(None);
        }
        let (low, high) = (quantile(&mut values, SPIKES), quantile(&mut values, 1.0 - SPIKES));
        let middle = quantile(&mut values, 0.5);
        if high - low > STEADY.1.max(STEADY.0 * middle.abs()) {
            return Err((low, high));
        }
        // Written as a supply is set, not with the noise of the sensor.
        let value = (middle / SAME).round() * SAME;
        Ok(Some(Setting { name: "current".into(), unit: "A".into(), value: (value * 1e4).round() / 1e4 }))
    }

    /// The setting that a part of a test's name states: `1.6A`, `800mA`, `12clicks`.
    fn of_part(part: &str) -> Option<Setting> {
        let part = part.trim_start_matches(['I', 'i', '=']).replace(',', ".");
        let digits = part.find(|c: char| !c.is_ascii_digit() && c != '.' && c != '-')?;
        let (number, unit) = part.split_at(digits);
        let value: f64 = number.parse().ok()?;
        let (name, unit, factor) = match unit {
            "A" | "Amp" | "amp" | "amps" => ("current", "A", 1.0),
            "mA" => ("current", "A", 1e-3),
            "clk" | "clks" | "click" | "clicks" | "klick" | "klicks" | "Klicks" => ("clicks", "", 1.0),
            _ => return None,
        };
        Some(Setting { name: name.into(), unit: unit.into(), value: value * factor })
    }

    /// The setting in a name; nothing where its parts state several.
    pub(crate) fn of_name(name: &str) -> Option<Setting> {
        let parts = name.split(|c: char| "_ ()[]/;".contains(c) || c == '\u{a0}');
        let mut found: Vec<Setting> = parts.filter_map(Setting::of_part).collect();
        if found.len() == 1 { found.pop() } else { None }
    }

    pub(crate) fn is_same(&self, other: &Setting) -> bool {
        self.name == other.name && (self.value - other.value).abs() < SAME
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn settings_are_found_in_names() {
        let of = |name: &str| Setting::of_name(name).map(|s| (s.name, s.unit, s.value));
        let current = |value| Some(("current".to_owned(), "A".to_owned(), value));
        assert_eq!(of("SH_25mm_0.3Hz_1.6A"), current(1.6));
        assert_eq!(of("SH_25mm_I0,4A"), current(0.4));
        assert_eq!(of("sine 800mA 2Hz"), current(0.8));
        assert_eq!(of("a25_12clicks"), Some(("clicks".to_owned(), String::new(), 12.0)));
        for none in ["a25mm_v0131mm_s", "test_A", "1.6A_0.4A", "part2", "0.3Hz", "12B"] {
            assert_eq!(of(none), None, "{none}");
        }
    }

    #[test]
    fn a_steady_current_is_a_setting_and_a_changing_one_is_none() {
        let noisy: Vec<f64> = (0..1000).map(|k| 0.8 + 0.01 * libm::sin(f64::from(k))).collect();
        assert_eq!(Setting::of_current(&noisy).unwrap().map(|s| s.value), Some(0.8));
        let swept: Vec<f64> = (0..1000).map(|k| 1e-3 * f64::from(k)).collect();
        assert!(Setting::of_current(&swept).is_err());
        assert_eq!(Setting::of_current(&[f64::NAN]), Ok(None));
    }
}
