//! Correction of the setting of one test by the user, as a rule for the name of this test.

use std::collections::BTreeSet;

use crate::data::record::Record;
use crate::messages::phrases;
use crate::quantities::setting_rules::SettingRules;
use crate::quantities::setting_value::{setting_in_unit, with_setting_name};
use crate::quantities::stated_setting::StatedSetting;
use crate::tuning::options::LARGEST_SETTING;
use dashpot_messages::{Sentence, format_number};

/// Returns name and unit of a test's setting, constant or changing.
fn quantity(record: &Record) -> Option<(&str, &str)> {
    let constant = record.setting.as_ref().map(|of| (of.name.as_str(), of.unit.as_str()));
    constant.or_else(|| record.setting_signal.as_ref().map(|of| (of.name.as_str(), of.unit.as_str())))
}

/// Returns the rules with the setting of a test as the user typed it: `0.8`, `800 mA` or `none`. An empty text means no
/// setting.
///
/// A number without a unit is in the unit of the test's own setting, else of the other tests, else of the model. The
/// argument `of_model` has the name and the unit of the model's setting.
///
/// # Errors
/// The text is not a setting, it is of another quantity than the tests' setting, or the tests have several settings.
pub fn correct_setting(
    rules: &SettingRules,
    records: &[Record],
    test: &Record,
    typed: &str,
    of_model: Option<(&str, &str)>,
) -> Result<SettingRules, Sentence> {
    let unread = || {
        let text = Sentence::from(phrases::SETTING_TYPED).with_foreign("text", typed.trim());
        text.with("largest", format_number(LARGEST_SETTING))
    };
    let mut stated = match typed.trim() {
        "" => StatedSetting::Without,
        text => text.parse().map_err(|_| unread())?,
    };
    if !stated.is_possible() {
        return Err(unread());
    }
    let known = || std::iter::once(test).chain(records).filter_map(quantity);
    let name = match &rules.name {
        Some(name) => name.clone(),
        None => {
            // The name in the rules applies to every setting column, so it would rename other settings.
            let names: BTreeSet<&str> = known().map(|(name, _)| name).collect();
            if names.len() > 1 {
                let names = names.into_iter().collect::<Vec<_>>().join(", ");
                return Err(Sentence::from(phrases::SETTING_QUANTITIES).with("names", names));
            }
            let of_unit = setting_in_unit(stated.unit()).map(|(name, ..)| name);
            let of_model = of_model.map(|(name, _)| name).filter(|name| !name.is_empty());
            match names.into_iter().next().or(of_unit).or(of_model) {
                Some(name) => name.to_owned(),
                // Without any setting, there is none to remove.
                None if stated == StatedSetting::Without => return Ok(rules.clone()),
                None => return Err(unread()),
            }
        }
    };
    let mut units = known().chain(of_model).filter(|(of, _)| *of == name).map(|(_, unit)| unit);
    let unit = units.next().unwrap_or(&rules.unit);
    if let StatedSetting::Value(_, own) = &mut stated
        && own.is_empty()
    {
        unit.clone_into(own);
    }
    if !stated.is_of(&name, unit) || !stated.is_of(&name, &rules.unit) {
        let text = Sentence::from(phrases::SETTING_QUANTITY).with_foreign("text", typed.trim());
        return Err(with_setting_name(text, "setting", &name));
    }
    if let StatedSetting::Value(_, own) = &mut stated
        && *own == rules.unit
    {
        own.clear();
    }
    let mut corrected = rules.clone();
    corrected.name = Some(name);
    corrected.values.insert(test.name.clone(), stated);
    Ok(corrected)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::data::setting_signal::SettingSignal;
    use crate::quantities::setting_value::Setting;
    use crate::settings::assignment::assign_settings;

    fn test(name: &str, setting: Option<(&str, &str, f64)>) -> Record {
        let setting = setting.map(|(name, unit, value)| Setting { name: name.into(), unit: unit.into(), value });
        Record { name: name.into(), setting, ..Record::default() }
    }

    /// Corrects the setting of the first record, and returns all settings with the corrected rules.
    fn corrected(
        rules: &SettingRules,
        records: &[Record],
        typed: &str,
        of_model: Option<(&str, &str)>,
    ) -> Result<(SettingRules, Vec<Option<Setting>>), String> {
        let rules = correct_setting(rules, records, &records[0], typed, of_model).map_err(|e| e.to_string())?;
        rules.check()?;
        let mut records = records.to_vec();
        assign_settings(&mut records, &rules, &mut Vec::new());
        Ok((rules, records.into_iter().map(|record| record.setting).collect()))
    }

    #[test]
    fn a_typed_setting_is_that_of_its_test_alone() {
        let records = [test("a_1.6A", Some(("current", "A", 1.6))), test("b_0.8A", Some(("current", "A", 0.8)))];
        let none = SettingRules::default();
        for (typed, value) in
            [("0.4", Some(0.4)), ("0,4 A", Some(0.4)), ("400mA", Some(0.4)), ("", None), ("none", None)]
        {
            let (rules, found) = corrected(&none, &records, typed, None).unwrap();
            // The name of a test does not count if the rules state that it has no setting.
            assert_eq!(found[0].as_ref().map(|of| of.value), value, "{typed}");
            assert_eq!(found[1].as_ref().map(|of| (of.value, of.unit.as_str())), Some((0.8, "A")), "{typed}");
            // The unit in the rules stays empty, so that the headings still state the units of their columns.
            assert_eq!((rules.name.as_deref(), rules.unit.as_str(), rules.values.len()), (Some("current"), "", 1));
        }
        // A rule of the profile keeps its unit, and a second correction replaces the first.
        let profile = SettingRules { name: Some("current".into()), unit: "A".into(), ..SettingRules::default() };
        let (first, _) = corrected(&profile, &records, "0.4", None).unwrap();
        let (second, found) = corrected(&first, &records, "0.6", None).unwrap();
        assert_eq!(second.values["a_1.6A"], StatedSetting::Value(0.6, String::new()));
        assert_eq!((second.values.len(), found[0].as_ref().map(|of| of.value)), (1, Some(0.6)));
    }

    #[test]
    fn a_test_whose_setting_changes_becomes_one_at_a_setting() {
        let of_bar = |name: &str| test(name, Some(("pressure", "bar", 15.0)));
        let mut records = [test("steps", None), of_bar("a_15bar"), of_bar("b_15bar")];
        records[0].setting_signal = Some(SettingSignal::new("pressure", "psi", &[75.0, 150.0]));
        let (_, found) = corrected(&SettingRules::default(), &records, "145.04", None).unwrap();
        let found = found[0].as_ref().unwrap();
        assert!(found.unit == "bar" && (found.value - 10.0).abs() < 1e-3, "{found:?}");
    }

    #[test]
    fn without_a_setting_the_unit_or_the_model_names_it() {
        let records = [test("a", None), test("b", None)];
        let of = |typed: &str, of_model| {
            corrected(&SettingRules::default(), &records, typed, of_model).map(|(rules, found)| {
                (rules.name, found[0].as_ref().map(|of| (of.unit.clone(), of.value)), found[1].is_some())
            })
        };
        let found = |name: &str, unit: &str, value| (Some(name.to_owned()), Some((unit.to_owned(), value)), false);
        assert_eq!(of("12 clicks", None).unwrap(), found("clicks", "", 12.0));
        assert_eq!(of("12", Some(("clicks", ""))).unwrap(), found("clicks", "", 12.0));
        assert_eq!(of("3", Some(("pilot", "bar"))).unwrap(), found("pilot", "bar", 3.0));
        assert_eq!(of("", None).unwrap(), (None, None, false));
        for typed in ["12", "hard", "1e300 A"] {
            let message = of(typed, None).unwrap_err();
            assert!(message.contains(typed) && message.contains("12 clicks"), "{message}");
        }
    }

    #[test]
    fn another_quantity_is_rejected() {
        let records = [test("a", Some(("current", "A", 1.6))), test("b", None)];
        let message = corrected(&SettingRules::default(), &records, "3 bar", None).unwrap_err();
        assert!(message.contains("3 bar is no current"), "{message}");
        let two = [test("a", Some(("current", "A", 1.6))), test("b", Some(("clicks", "", 2.0)))];
        let message = corrected(&SettingRules::default(), &two, "0.4", None).unwrap_err();
        assert!(message.contains("clicks, current"), "{message}");
    }
}
