//! Rules of the user for the setting of each test, by the names of the tests.

use std::collections::BTreeMap;

use crate::glob;
use crate::quantities::setting_value::Setting;
use crate::quantities::stated_setting::StatedSetting;
use crate::tuning::options::LARGEST_SETTING;
use dashpot_messages::format_number;

/// Rules of the user for the setting of each test.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct SettingRules {
    /// Name of the setting.
    pub name: Option<String>,
    /// Unit of the values that state none, and of the columns of the setting.
    pub unit: String,
    /// Settings by test names. `*` matches any text.
    pub values: BTreeMap<String, StatedSetting>,
}

impl SettingRules {
    /// Returns these rules if they name a setting, else those of the profile.
    pub(crate) fn over(&self, profile: &SettingRules) -> SettingRules {
        if self.name.is_some() { self.clone() } else { profile.clone() }
    }

    /// Checks that values have the name of their setting, are finite, and have units of this setting.
    ///
    /// # Errors
    /// A message about the invalid rule.
    pub(crate) fn check(&self) -> Result<(), String> {
        let Some(name) = &self.name else {
            return match self.values.is_empty() {
                true => Ok(()),
                false => {
                    Err("settings are given, but not of what: add setting = \"current\", or another name".to_owned())
                }
            };
        };
        for (pattern, stated) in &self.values {
            if !stated.is_possible() {
                let StatedSetting::Value(value, _) = stated else { continue };
                let (number, largest) = (format_number(*value), format_number(LARGEST_SETTING));
                return Err(format!(
                    "settings: {number} of {pattern:?} is no number that a damper is set to; give -{largest} to {largest}"
                ));
            }
            if !stated.is_of(name, &self.unit) {
                let of = format!("{name} {}", self.unit);
                return Err(format!("settings: {stated} of {pattern:?} is not in a unit of {}", of.trim_end()));
            }
        }
        Ok(())
    }

    /// Returns what the rules state for a test, or `None` if no rule applies to it. A rule with the exact name of the
    /// test has precedence over a pattern, and a longer pattern over a shorter one.
    pub(crate) fn find(&self, test: &str) -> Option<&StatedSetting> {
        let matching = self.values.iter().filter(|(pattern, _)| glob::matches(pattern, test));
        matching.max_by_key(|(pattern, _)| (*pattern == test, pattern.chars().count())).map(|(_, stated)| stated)
    }

    /// Returns the setting that the rules state for a test. Returns `None` if no rule applies, or if the rule states no
    /// setting.
    pub(crate) fn setting_of(&self, test: &str) -> Option<Setting> {
        self.find(test)?.to_setting(self.name.as_deref()?, &self.unit)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rules(values: &[(&str, StatedSetting)]) -> SettingRules {
        let values = values.iter().map(|(pattern, stated)| ((*pattern).to_owned(), stated.clone())).collect();
        SettingRules { name: Some("current".into()), unit: "A".into(), values }
    }

    fn value(value: f64) -> StatedSetting {
        StatedSetting::Value(value, String::new())
    }

    #[test]
    fn the_longest_pattern_says_the_setting() {
        let given = rules(&[
            ("*", value(0.0)),
            ("*hard*", StatedSetting::Value(1600.0, "mA".into())),
            ("*h*a*r*d*2*", value(0.4)),
            ("a_hard2", value(0.8)),
            ("warm*", StatedSetting::Without),
        ]);
        let of = |name: &str| given.setting_of(name).map(|s| s.value);
        assert_eq!((of("a_hard"), of("a_soft"), of("b_hard2")), (Some(1.6), Some(0.0), Some(0.4)));
        // The exact name has precedence over a pattern with more characters than the name.
        assert_eq!(of("a_hard2"), Some(0.8));
        assert_eq!((of("warm"), given.find("warm")), (None, Some(&StatedSetting::Without)));
        assert_eq!((SettingRules::default().setting_of("a"), SettingRules::default().find("a")), (None, None));
    }

    #[test]
    fn settings_beyond_their_bounds_are_rejected() {
        let check = |value: f64| rules(&[("*hard*", StatedSetting::Value(value, String::new()))]).check();
        for value in [1e308, -1e308, 1.1e9, f64::NAN, f64::INFINITY] {
            let message = check(value).unwrap_err();
            assert!(message.contains("\"*hard*\"") && message.ends_with("give -1e9 to 1e9"), "{message}");
            assert!(message.contains(&format_number(value)) && message.len() < 300, "{message}");
        }
        assert!(check(0.0).is_ok() && check(-1e9).is_ok() && check(1e-308).is_ok());
        let message = rules(&[("*", StatedSetting::Value(3.0, "bar".into()))]).check().unwrap_err();
        assert!(message.contains("3.0 bar of \"*\"") && message.ends_with("current A"), "{message}");
    }
}
