//! Sorting of a campaign's records by their setting, and reasons why no family can be fitted.

use crate::FitError;
use crate::phrases;
use dashpot_core::family::interpolation::MAX_GRID;
use dashpot_messages::Sentence;
use dashpot_records::{Record, is_same_setting, records_without_setting, unread_current};

/// Largest number of test names that an error message lists.
const NAMES: usize = 6;

/// Reason why no family can be fitted to a campaign.
#[derive(Debug, thiserror::Error)]
#[error("{}", self.sentence())]
pub enum FamilyError {
    /// No record has a setting with the requested name.
    NoSetting {
        /// Requested name.
        name: String,
        /// Names of the settings in the records.
        known: Vec<String>,
        /// Note about a column in a unit of current that was not read.
        unread: Option<Sentence>,
    },
    /// Some records lack the setting.
    Without {
        /// Name of the setting.
        name: String,
        /// Names of the tests without the setting.
        tests: Vec<String>,
        /// Note about a column in a unit of current that was not read.
        unread: Option<Sentence>,
    },
    /// The setting changes within all records.
    OnlyChanging {
        /// Name of the setting.
        name: String,
        /// Number of records.
        count: usize,
    },
    /// All records have the same setting.
    One {
        /// Name of the setting.
        name: String,
        /// Value of the setting.
        value: f64,
    },
    /// There are more settings than a model can contain.
    TooMany {
        /// Name of the setting.
        name: String,
        /// Number of settings.
        count: usize,
    },
    /// No ordinary damper can be fitted at one of the settings.
    At {
        /// Name of the setting.
        name: String,
        /// Value of the setting.
        value: f64,
        /// Error of the fit at the setting.
        why: FitError,
    },
    /// The numbers at all settings do not form a valid family.
    Kernel {
        /// The invalid parameter.
        parameter: &'static str,
        /// Reason why the parameter is invalid.
        why: &'static str,
    },
    /// The fit of all settings together gives no finite forces.
    NotFinite,
}

impl FamilyError {
    /// Returns the error and its remedy as a sentence that can be translated.
    pub fn sentence(&self) -> Sentence {
        match self {
            FamilyError::NoSetting { name, known, unread } if known.is_empty() => {
                Sentence::from(phrases::FAMILY_NO_SETTING).with("name", name).with_any("unread", also(unread))
            }
            FamilyError::NoSetting { name, known, .. } => Sentence::from(phrases::FAMILY_OTHER_SETTING)
                .with("name", name)
                .with_names("known", known.iter(), phrases::COMMA),
            FamilyError::Without { name, tests, unread } => Sentence::from(phrases::FAMILY_WITHOUT)
                .with("name", name)
                .with("count", tests.len())
                .with_names("tests", tests.iter().take(NAMES), phrases::COMMA)
                .with_any("unread", also(unread)),
            FamilyError::OnlyChanging { name, count } => {
                Sentence::from(phrases::FAMILY_ONLY_CHANGING).with("name", name).with("count", count)
            }
            FamilyError::One { name, value } => {
                Sentence::from(phrases::FAMILY_ONE).with("name", name).with("value", value)
            }
            FamilyError::TooMany { name, count } => {
                Sentence::from(phrases::FAMILY_TOO_MANY).with("name", name).with("count", count).with("most", MAX_GRID)
            }
            FamilyError::At { name, value, why } => Sentence::from(phrases::FAMILY_AT)
                .with("name", name)
                .with("value", value)
                .with_sentence("why", why.sentence()),
            FamilyError::Kernel { parameter, why } => {
                Sentence::from(phrases::FAMILY_KERNEL).with("parameter", parameter).with("why", why)
            }
            FamilyError::NotFinite => phrases::FAMILY_NOT_FINITE.into(),
        }
    }
}

/// Returns a note as the end of an error message.
fn also(note: &Option<Sentence>) -> Option<Sentence> {
    note.clone().map(|note| Sentence::from(phrases::FAMILY_UNREAD).with_sentence("note", note))
}

/// Setting over which records were measured.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SettingAxis {
    /// Name of the setting, such as `current`.
    pub name: String,
    /// Unit of the setting, or empty without a unit.
    pub unit: String,
}

/// Records at one value of a setting.
#[derive(Debug, Clone)]
pub struct SettingRecords<'a> {
    /// Value of the setting.
    pub value: f64,
    /// Records at the value.
    pub records: Vec<&'a Record>,
}

/// Splits records by the setting `name`: records with a constant setting or none, and records in which it changes.
pub fn split_changing<'a>(records: &[&'a Record], name: &str) -> (Vec<&'a Record>, Vec<&'a Record>) {
    records.iter().partition(|record| record.setting_signal.as_ref().is_none_or(|signal| signal.name != name))
}

/// Sorts records by the value of the setting `name`. The lowest value comes first.
///
/// # Errors
/// A record lacks the setting, there is a single setting, or there are more settings than a model can contain.
pub fn by_setting<'a>(
    records: &[&'a Record],
    name: &str,
) -> Result<(SettingAxis, Vec<SettingRecords<'a>>), FamilyError> {
    let unread = || unread_current(records.iter().copied());
    let own = |record: &'a Record| record.setting.as_ref().filter(|setting| setting.name == name);
    let Some(first) = records.iter().find_map(|record| own(record)) else {
        let mut known: Vec<String> =
            records.iter().filter_map(|record| Some(record.setting.as_ref()?.name.clone())).collect();
        let without = records_without_setting(records.iter().copied(), name);
        if known.is_empty() && !without.is_empty() {
            let tests = without.iter().map(|record| record.name.clone()).collect();
            return Err(FamilyError::Without { name: name.to_owned(), tests, unread: unread() });
        }
        known.sort();
        known.dedup();
        return Err(FamilyError::NoSetting { name: name.to_owned(), known, unread: unread() });
    };
    let without: Vec<String> =
        records.iter().filter(|record| own(record).is_none()).map(|record| record.name.clone()).collect();
    if !without.is_empty() {
        return Err(FamilyError::Without { name: name.to_owned(), tests: without, unread: unread() });
    }
    let mut valued: Vec<(f64, &Record)> =
        records.iter().filter_map(|record| Some((own(record)?.value, *record))).collect();
    // The sort is stable, so the records at one setting keep their order.
    valued.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut sorted: Vec<SettingRecords> = Vec::new();
    for (value, record) in valued {
        match sorted.last_mut() {
            Some(last) if is_same_setting(last.value, value) => last.records.push(record),
            _ => sorted.push(SettingRecords { value, records: vec![record] }),
        }
    }
    match sorted.len() {
        1 => Err(FamilyError::One { name: name.to_owned(), value: sorted[0].value }),
        count if count > MAX_GRID => Err(FamilyError::TooMany { name: name.to_owned(), count }),
        _ => Ok((SettingAxis { name: name.to_owned(), unit: first.unit.clone() }, sorted)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use dashpot_records::{Note, Setting};

    fn record(name: &str, value: Option<f64>) -> Record {
        let setting = value.map(|value| Setting { name: "current".into(), unit: "A".into(), value });
        Record { name: name.into(), setting, ..Record::default() }
    }

    #[test]
    fn records_are_sorted_by_their_setting() {
        let all = [record("a", Some(1.6)), record("b", Some(0.0)), record("c", Some(1.6)), record("d", Some(0.8))];
        let (axis, sorted) = by_setting(&all.iter().collect::<Vec<_>>(), "current").unwrap();
        assert_eq!((axis.name.as_str(), axis.unit.as_str()), ("current", "A"));
        let names: Vec<Vec<&str>> =
            sorted.iter().map(|s| s.records.iter().map(|r| r.name.as_str()).collect()).collect();
        assert_eq!(names, [vec!["b"], vec!["d"], vec!["a", "c"]]);
    }

    #[test]
    fn what_is_wrong_is_said_with_the_names() {
        let refused =
            |all: &[Record], name: &str| by_setting(&all.iter().collect::<Vec<_>>(), name).unwrap_err().to_string();
        let two = [record("a", Some(1.6)), record("b", Some(0.0))];
        assert!(refused(&two, "clicks").contains("current"));
        assert!(refused(&[record("a", None)], "current").contains("campaign.toml"));
        let mut unread = record("a", None);
        unread.notes = vec![Note { kind: "unread_current", text: Sentence::as_it_is("column 'Signal 7' in A") }];
        assert!(refused(&[unread], "current").ends_with("; column 'Signal 7' in A"));
        assert!(refused(&[record("a", Some(1.0)), record("lost", None)], "current").contains("lost"));
        assert!(refused(&[record("a", Some(1.0)), record("b", Some(1.0))], "current").contains("have the same, 1"));
        let many: Vec<Record> = (0..9).map(|k| record("a", Some(f64::from(k)))).collect();
        let text = refused(&many, "current");
        assert!(text.contains('9') && text.contains('8'), "{text}");
    }
}
