//! The setting that a rule of the user states for a test: a value, a value with its unit, or none.

use std::fmt;
use std::str::FromStr;

use serde::de::{self, Visitor};
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use crate::numbers::split_unit;
use crate::quantities::setting_value::{NAMES, Setting, restate_in_unit, setting_factor, setting_in_unit};
use crate::tuning::options::LARGEST_SETTING;

/// Word that stands for no setting. As the name of a setting, it means that tests at several settings are fitted as one
/// damper.
pub const WITHOUT_SETTING: &str = "none";

/// The setting that a rule states for a test.
#[derive(Debug, Clone, PartialEq)]
pub enum StatedSetting {
    /// A value, and its unit. Without a unit, the value is in the unit of the rules.
    Value(f64, String),
    /// No setting, whatever channel and name of the test state.
    Without,
}

impl StatedSetting {
    /// Returns the unit, or an empty text if the rule states none.
    pub(crate) fn unit(&self) -> &str {
        match self {
            StatedSetting::Value(_, unit) => unit,
            StatedSetting::Without => "",
        }
    }

    /// Returns whether the value is a number to which a damper can be set.
    pub(crate) fn is_possible(&self) -> bool {
        match self {
            StatedSetting::Value(value, _) => value.abs() <= LARGEST_SETTING,
            StatedSetting::Without => true,
        }
    }

    /// Returns whether the unit measures the quantity with this name and this unit.
    pub(crate) fn is_of(&self, name: &str, unit: &str) -> bool {
        let known = setting_in_unit(self.unit());
        let is_other = |(own, ..): (&str, &str, f64)| NAMES.contains(&name) && own != name;
        !known.is_some_and(is_other) && setting_factor(self.unit(), unit).is_some()
    }

    /// Returns the setting with this name, or `None` if the rule states none. `unit` applies to a value without a unit.
    pub(crate) fn to_setting(&self, name: &str, unit: &str) -> Option<Setting> {
        let StatedSetting::Value(value, own) = self else { return None };
        let mut setting = Setting { name: name.to_owned(), unit: own.clone(), value: *value };
        if own.is_empty() {
            unit.clone_into(&mut setting.unit);
        } else if let Some((_, base, _)) = setting_in_unit(own) {
            // Clicks have an empty unit, and the conversion to an empty unit keeps the stated unit. Therefore, also set
            // the unit.
            restate_in_unit(&mut setting.unit, base, [&mut setting.value]);
            base.clone_into(&mut setting.unit);
        }
        Some(setting)
    }
}

impl FromStr for StatedSetting {
    type Err = String;

    fn from_str(text: &str) -> Result<StatedSetting, String> {
        let text = text.trim();
        if text == WITHOUT_SETTING {
            return Ok(StatedSetting::Without);
        }
        // A decimal comma and the minus sign of typesetting are allowed, as in records.
        let plain = if text.contains('.') { text.to_owned() } else { text.replacen(',', ".", 1) };
        let plain = plain.replace('\u{2212}', "-");
        let (value, unit) = split_unit(&plain).ok_or_else(|| {
            format!("{text:?} is neither a number, alone or with its unit such as \"0.8 A\", nor {WITHOUT_SETTING:?}")
        })?;
        Ok(StatedSetting::Value(value, unit.to_owned()))
    }
}

impl fmt::Display for StatedSetting {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            // The shortest text that reads back to the same number.
            StatedSetting::Value(value, unit) if unit.is_empty() => write!(out, "{value:?}"),
            StatedSetting::Value(value, unit) => write!(out, "{value:?} {unit}"),
            StatedSetting::Without => out.write_str(WITHOUT_SETTING),
        }
    }
}

impl Serialize for StatedSetting {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        match self {
            StatedSetting::Value(value, unit) if unit.is_empty() => to.serialize_f64(*value),
            _ => to.collect_str(self),
        }
    }
}

impl<'de> Deserialize<'de> for StatedSetting {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<StatedSetting, D::Error> {
        from.deserialize_any(Reader)
    }
}

/// Reads a [`StatedSetting`] from a number or a text.
struct Reader;

impl Visitor<'_> for Reader {
    type Value = StatedSetting;

    fn expecting(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(out, "a number, a number with its unit such as \"0.8 A\", or {WITHOUT_SETTING:?}")
    }

    fn visit_f64<E: de::Error>(self, value: f64) -> Result<StatedSetting, E> {
        Ok(StatedSetting::Value(value, String::new()))
    }

    fn visit_i64<E: de::Error>(self, value: i64) -> Result<StatedSetting, E> {
        self.visit_f64(value as f64)
    }

    fn visit_str<E: de::Error>(self, text: &str) -> Result<StatedSetting, E> {
        text.parse().map_err(E::custom)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn value(value: f64, unit: &str) -> StatedSetting {
        StatedSetting::Value(value, unit.to_owned())
    }

    #[test]
    fn a_stated_setting_is_read_with_or_without_its_unit() {
        for (text, stated) in [
            ("0.8", value(0.8, "")),
            (" 0,8 ", value(0.8, "")),
            ("\u{2212}2 A", value(-2.0, "A")),
            ("800mA", value(800.0, "mA")),
            ("12 clicks", value(12.0, "clicks")),
            ("40 %", value(40.0, "%")),
            ("none", StatedSetting::Without),
        ] {
            assert_eq!(text.parse::<StatedSetting>().unwrap(), stated, "{text}");
            assert_eq!(stated.to_string().parse::<StatedSetting>().unwrap(), stated, "{text}");
        }
        for text in ["", "hard", "A", "nan", "inf A"] {
            assert!(text.parse::<StatedSetting>().unwrap_err().contains("0.8 A"), "{text}");
        }
    }

    #[test]
    fn a_unit_of_the_rule_precedes_the_unit_of_all_rules_and_is_restated() {
        let of = |stated: StatedSetting, name: &str, unit: &str| {
            stated.to_setting(name, unit).map(|of| (of.name, of.unit, of.value))
        };
        let found = |name: &str, unit: &str, value: f64| Some((name.to_owned(), unit.to_owned(), value));
        assert_eq!(of(value(700.0, "mA"), "current", "A"), found("current", "A", 0.7));
        assert_eq!(of(value(0.7, ""), "current", "A"), found("current", "A", 0.7));
        assert_eq!(of(value(12.0, "clicks"), "clicks", ""), found("clicks", "", 12.0));
        assert_eq!(of(value(40.0, "%"), "duty", ""), found("duty", "%", 40.0));
        assert_eq!(of(StatedSetting::Without, "current", "A"), None);
    }

    #[test]
    fn a_unit_of_another_quantity_is_found() {
        for (stated, name, unit, is_of) in [
            (value(3.0, "bar"), "pressure", "psi", true),
            (value(3.0, "bar"), "pilot", "psi", true),
            (value(3.0, "bar"), "current", "A", false),
            (value(3.0, "bar"), "current", "", false),
            (value(3.0, "A"), "pilot", "bar", false),
            (value(3.0, ""), "current", "A", true),
            (StatedSetting::Without, "current", "A", true),
        ] {
            assert_eq!(stated.is_of(name, unit), is_of, "{stated} {name} {unit}");
        }
    }
}
