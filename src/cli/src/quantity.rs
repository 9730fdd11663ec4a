//! Numbers of the command line with an optional unit: 5ms, 0.4in, 1.2kN. Numbers without a unit are in SI units.

use anyhow::bail;
use dashpot_core::family::{Axis, LARGEST_SETTING};
use dashpot_messages::format_number;
use dashpot_records::{Dimension, Unit, setting_factor, setting_in_words, split_unit};
use std::path::Path;
use std::str::FromStr;

/// Parses a time such as `0.005`, `5ms` or `5 ms`. Returns seconds.
///
/// # Errors
/// The text is not a time.
pub fn seconds(text: &str) -> Result<f64, String> {
    read(text, Dimension::Time, "a time in s, or with its unit, such as 5ms")
}

/// Parses a length such as `0.005`, `5mm` or `0.2in`. Returns meters.
///
/// # Errors
/// The text is not a length.
pub fn metres(text: &str) -> Result<f64, String> {
    read(text, Dimension::Length, "a length in m, or with its unit, such as 5mm")
}

/// Parses a force such as `120`, `0.12kN` or `27lbf`. Returns newtons.
///
/// # Errors
/// The text is not a force.
pub fn newtons(text: &str) -> Result<f64, String> {
    read(text, Dimension::Force, "a force in N, or with its unit, such as 0.12kN")
}

fn read(text: &str, dimension: Dimension, expected: &str) -> Result<f64, String> {
    let refusal = || format!("{text:?} is not {expected}");
    let (value, unit) = split_unit(text.trim()).ok_or_else(refusal)?;
    if unit.is_empty() {
        return Ok(value);
    }
    match unit.parse::<Unit>() {
        Ok(unit) if unit.dimension() == dimension => Ok(unit.to_si(value)),
        _ => Err(refusal()),
    }
}

/// Value of a damper's setting as written on the command line, with or without a unit: `0.6`, `0.6A` or `600mA`.
#[derive(Debug, Clone, PartialEq)]
pub struct SettingText {
    value: f64,
    unit: String,
}

impl FromStr for SettingText {
    type Err = String;

    fn from_str(text: &str) -> Result<SettingText, String> {
        let refusal =
            || format!("{text:?} is not a number, alone or with the unit of the setting, such as 0.6 or 0.6A");
        // A decimal comma is allowed, as in records.
        let point = if text.contains('.') { text.to_owned() } else { text.replacen(',', ".", 1) };
        let (value, unit) = split_unit(point.trim()).ok_or_else(refusal)?;
        Ok(SettingText { value, unit: unit.to_owned() })
    }
}

impl SettingText {
    /// Converts the value to the unit of a damper's setting. `model` is the damper's model file.
    ///
    /// # Errors
    /// Returns the errors of [`SettingText::in_unit_of`], or the value lies outside the damper's settings.
    pub fn within(&self, axis: &Axis, model: &Path) -> anyhow::Result<f64> {
        let setting = self.in_unit_of(axis)?;
        let (low, high) = axis.range();
        if !(low..=high).contains(&setting) {
            let [setting, low, high] = [setting, low, high].map(|value| setting_in_words(value, axis.unit()));
            bail!("the setting {setting} lies outside those of {}, {low} to {high}: check its unit", model.display());
        }
        Ok(setting)
    }

    /// Converts the value to the unit of a damper's setting.
    ///
    /// # Errors
    /// The unit belongs to another quantity, or the damper's setting has no unit.
    pub fn in_unit_of(&self, axis: &Axis) -> anyhow::Result<f64> {
        let own = axis.unit();
        // A setting in clicks has the name `clicks` and no unit, so the text may use `clicks` as its unit.
        let is_clicks = own.is_empty() && axis.name() == "clicks" && setting_factor(&self.unit, "clicks").is_some();
        let given = format!("{} {}", format_number(self.value), self.unit);
        let value = match setting_factor(&self.unit, own) {
            Some(factor) if is_clicks => factor * self.value,
            Some(factor) if self.unit.is_empty() || !own.is_empty() => factor * self.value,
            _ if own.is_empty() => {
                bail!("{given}: the setting of this damper has no unit; give the number alone")
            }
            _ => bail!("{given}: the setting of this damper is counted in {own}"),
        };
        if !(value.abs() <= LARGEST_SETTING) {
            let largest = format_number(LARGEST_SETTING);
            bail!("the setting {} is beyond that of any damper; give -{largest} to {largest}", given.trim_end());
        }
        Ok(value)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_may_bear_its_unit() {
        for (text, value) in [("5ms", 0.005), ("5 ms", 0.005), ("1e-3s", 1e-3), ("-0.005", -0.005), ("2us", 2e-6)] {
            assert_eq!(seconds(text), Ok(value), "{text}");
        }
        assert_eq!(metres("412.5mm"), Ok(0.4125));
        assert_eq!(metres("2in"), Ok(0.0508));
        assert_eq!(newtons("1.2 kN"), Ok(1200.0));
    }

    #[test]
    fn a_setting_is_in_the_unit_of_its_damper() {
        let mut clicks = Axis::NONE;
        clicks.set_name("clicks").unwrap();
        let three = |text: &str| text.parse::<SettingText>().unwrap().in_unit_of(&clicks);
        assert_eq!(three("3clicks").unwrap(), 3.0);
        assert!(three("3A").is_err());
        let mut axis = Axis::NONE;
        axis.set_grid(&[0.0, 1.6]).unwrap();
        axis.set_unit("A").unwrap();
        let value = |text: &str| text.parse::<SettingText>().unwrap().in_unit_of(&axis);
        assert!((value("600mA").unwrap() - 0.6).abs() < 1e-12);
        assert_eq!(["0.6", "0.6 A", "0,6", "0,6A"].map(|text| value(text).unwrap()), [0.6; 4]);
        assert!(value("12 clicks").unwrap_err().to_string().contains("counted in A"));
        assert!("high".parse::<SettingText>().unwrap_err().contains("0.6A"));
    }

    #[test]
    fn a_setting_beyond_that_of_any_damper_is_rejected() {
        let mut axis = Axis::NONE;
        axis.set_grid(&[0.0, 1.6]).unwrap();
        axis.set_unit("A").unwrap();
        let value = |text: &str| match text.parse::<SettingText>() {
            Ok(setting) => setting.in_unit_of(&axis).map_err(|why| why.to_string()),
            Err(why) => Err(why),
        };
        for text in ["1e308", "-1e308", "1e308A", "1.1e9", "nan", "inf"] {
            let message = value(text).unwrap_err();
            assert!(message.contains(text.trim_end_matches('A')) && message.len() < 300, "{message}");
        }
        assert_eq!((value("1e-308"), value("0"), value("-1e9")), (Ok(1e-308), Ok(0.0), Ok(-1e9)));
    }

    #[test]
    fn what_is_no_such_quantity_is_refused_with_an_example() {
        for text in ["5mm", "ms", "", "nan", "inf", "5 parsecs", "0,005"] {
            assert!(seconds(text).unwrap_err().contains("5ms"), "{text}");
        }
        assert!(metres("5 N").is_err() && newtons("5 m").is_err());
    }
}
