//! Assigns the tests of a campaign to settings of an adjustable damper. One model describes one setting, so a note
//! warns about several settings.

use std::collections::BTreeMap;

use super::unstated_settings::together;
use crate::data::record::{Note, Record, UNREAD_CURRENT};
use crate::messages::phrases;
use crate::quantities::setting_rules::SettingRules;
use crate::quantities::setting_value::{SAME, Setting, as_set, restate_in_unit, setting_in_words, with_setting_name};
use crate::quantities::stated_setting::WITHOUT_SETTING;
use dashpot_messages::Sentence;

/// Assigns settings from the user's rules, else from channels, else from the names of the tests. Merges measured
/// settings that differ only by scatter, and uses one unit for each setting. Adds notes about names that contradict
/// channels, and about several settings.
///
/// In a name, a number with a single letter may be the number of the test. If each name states a different value, the
/// names count only with decimals or with a unit of several letters.
pub(crate) fn assign_settings(records: &mut [Record], rules: &SettingRules, notes: &mut Vec<Note>) {
    merge_currents(records);
    merge_scattered(records);
    let is_given = |record: &Record| rules.find(&record.name).is_some();
    notes.extend(contradicted_names(records.iter().filter(|record| !is_given(record))));
    for record in records.iter_mut() {
        if is_given(record) {
            record.setting = rules.setting_of(&record.name);
            record.setting_signal = None;
        }
    }
    name_settings(records, &is_given);
    unite_units(records);
    note_settings(records, notes);
}

/// Converts the settings with equal names, constant or changing, to the unit of most tests. For example, one damper may
/// have tests at 75 psi and at 15 bar.
fn unite_units(records: &mut [Record]) {
    let mut units: BTreeMap<(String, String), usize> = BTreeMap::new();
    for setting in records.iter().filter_map(|record| record.setting.as_ref()) {
        *units.entry((setting.name.clone(), setting.unit.clone())).or_default() += 1;
    }
    let most = |name: &str| {
        let own = units.iter().filter(|((known, _), _)| known == name);
        own.max_by_key(|(_, count)| **count).map(|((_, unit), _)| unit)
    };
    for record in records {
        if let Some(setting) = &mut record.setting
            && let Some(unit) = most(&setting.name).filter(|unit| **unit != setting.unit)
        {
            restate_in_unit(&mut setting.unit, unit, [&mut setting.value]);
        }
        if let Some(signal) = &mut record.setting_signal
            && let Some(unit) = most(&signal.name).filter(|unit| **unit != signal.unit)
        {
            restate_in_unit(&mut signal.unit, unit, signal.values.iter_mut().chain(&mut signal.range));
        }
    }
}

/// Largest difference between measured values of one setting, relative to the largest value of all settings with this
/// name. A pressure regulator or a drifting supply causes such differences.
const SCATTER: f64 = 0.02;

/// Replaces measured settings that scatter about one value by their mean. Excludes currents, which [`merge_currents`]
/// merges, because set currents are multiples of 0.01 A.
fn merge_scattered(records: &mut [Record]) {
    let mut all: Vec<&mut Setting> =
        records.iter_mut().filter_map(|record| record.setting.as_mut()).filter(|of| of.name != "current").collect();
    all.sort_by(|a, b| (a.name.as_str(), a.unit.as_str()).cmp(&(&b.name, &b.unit)).then(a.value.total_cmp(&b.value)));
    for of_name in all.chunk_by_mut(|a, b| a.name == b.name && a.unit == b.unit) {
        let largest = of_name.iter().map(|of| of.value.abs()).fold(0.0, f64::max);
        // Clicks are whole numbers, so values half a click apart stay separate.
        let width = if of_name[0].unit.is_empty() { (SCATTER * largest).min(0.5) } else { SCATTER * largest };
        let mut place = 0;
        while place < of_name.len() {
            let first = of_name[place].value;
            let count = of_name[place..].iter().take_while(|of| of.value - first < width).count().max(1);
            let alike = &mut of_name[place..place + count];
            if alike.iter().any(|of| of.value != first) {
                let mean = alike.iter().map(|of| of.value).sum::<f64>() / count as f64;
                let value = as_set(mean, &alike[0].unit);
                alike.iter_mut().for_each(|of| of.value = value);
            }
            place += count;
        }
    }
}

/// Largest difference between neighboring measured currents of one setting, A. [`WIDEST`] is the largest difference
/// between the extremes.
///
/// Set currents are multiples of 0.01 A, and the zero of a channel drifts by a similar amount.
const NEXT: f64 = 1.25 * SAME;
const WIDEST: f64 = 2.5 * SAME;
/// Largest deviation of a setting channel from the setting in the test's name, relative to the larger one. A note
/// reports a larger deviation as a contradiction, because supplies and measured coil currents stay within a tenth.
const NAMED: f64 = 0.1;

/// Returns the setting in the name of a test and the setting of its channel if they differ, else `None`.
fn contradicted_name(record: &Record) -> Option<(&Record, Setting, &Setting)> {
    let shown = record.setting.as_ref()?;
    let (named, is_sure) = Setting::of_name(&record.name)?;
    let is_off = (named.value - shown.value).abs() > NAMED * named.value.abs().max(shown.value.abs());
    let contradicts =
        is_sure && named.name == shown.name && named.unit == shown.unit && is_off && !named.is_same(shown);
    contradicts.then_some((record, named, shown))
}

/// Makes a note if names of tests state other settings than their channels.
fn contradicted_names<'r>(records: impl Iterator<Item = &'r Record>) -> Option<Note> {
    let mut all = records.filter_map(contradicted_name);
    let (record, named, shown) = all.next()?;
    let words = |of: &Setting| setting_in_words(of.value, &of.unit);
    let text = Sentence::from(phrases::SETTING_NAME)
        .with("test", &record.name)
        .with("named", words(&named))
        .with("shown", words(shown))
        .with("count", 1 + all.count());
    Some(Note { kind: "setting_name", text: with_setting_name(text, "setting", &shown.name) })
}

/// Replaces measured currents by their median if they differ only by rounding.
///
/// Because of zero error and noise, 0.41 A may be measured as 0.40 A in one test and as 0.42 A in another.
fn merge_currents(records: &mut [Record]) {
    let is_current = |of: &&mut Setting| of.name == "current";
    let mut all: Vec<&mut Setting> =
        records.iter_mut().filter_map(|record| record.setting.as_mut()).filter(is_current).collect();
    all.sort_by(|a, b| a.unit.cmp(&b.unit).then(a.value.total_cmp(&b.value)));
    let mut place = 0;
    while place < all.len() {
        let (first, unit) = (all[place].value, all[place].unit.clone());
        let mut end = place + 1;
        while end < all.len()
            && all[end].unit == unit
            && all[end].value - all[end - 1].value < NEXT
            && all[end].value - first < WIDEST
        {
            end += 1;
        }
        let median = all[(place + end) / 2].value;
        all[place..end].iter_mut().for_each(|of| of.value = median);
        place = end;
    }
}

/// Removes the note about several settings, and makes one note for each group that still has several settings.
pub(crate) fn note_settings_of_groups<'a>(groups: impl Iterator<Item = &'a [Record]>, notes: &mut Vec<Note>) {
    notes.retain(|note| note.text.template() != phrases::SEVERAL_SETTINGS);
    groups.for_each(|records| note_settings(records, notes));
}

/// Assigns settings from names to tests without a setting, if the names of all these tests state one.
///
/// If some tests have a setting channel, names count only if they state the same quantity. For example, a campaign may
/// step the current in some tests and name it in other tests. The names of tests to which a rule of the user applies
/// (`is_given`) do not count.
fn name_settings(records: &mut [Record], is_given: &dyn Fn(&Record) -> bool) {
    let of_channel = |record: &Record| {
        let constant = record.setting.as_ref().map(|of| of.name.clone());
        constant.or_else(|| record.setting_signal.as_ref().map(|of| of.name.clone()))
    };
    let known: Vec<String> = records.iter().filter_map(of_channel).collect();
    let mut open: Vec<&mut Record> =
        records.iter_mut().filter(|record| record.setting.is_none() && record.setting_signal.is_none()).collect();
    open.retain(|record| !is_given(record));
    let named: Option<Vec<(Setting, bool)>> = open.iter().map(|record| Setting::of_name(&record.name)).collect();
    let names_tests = |all: &[(Setting, bool)]| {
        let unsure = all.iter().all(|(_, is_sure)| !is_sure);
        unsure && all.iter().enumerate().all(|(i, (a, _))| all[..i].iter().all(|(b, _)| !a.is_same(b)))
    };
    let is_of_channel = |all: &[(Setting, bool)]| all.iter().all(|(own, _)| known.iter().all(|name| *name == own.name));
    if let Some(named) = named.filter(|all| !all.is_empty() && !names_tests(all) && is_of_channel(all)) {
        open.iter_mut().zip(named).for_each(|(record, (setting, _))| record.setting = Some(setting));
    }
}

/// Returns the note about a column in a unit of current that was not read, if a record has such a note.
///
/// An error about a missing setting adds the note, because the column may contain the setting.
pub fn unread_current<'r>(records: impl IntoIterator<Item = &'r Record>) -> Option<Sentence> {
    let notes = records.into_iter().flat_map(|record| &record.notes);
    notes.filter(|note| note.kind == UNREAD_CURRENT).map(|note| note.text.clone()).next()
}

/// Returns the records without any setting, if names of other records state the setting `name`. A single such record
/// prevents the use of all names.
pub fn records_without_setting<'r>(records: impl Iterator<Item = &'r Record> + Clone, name: &str) -> Vec<&'r Record> {
    let is_named = |record: &&Record| Setting::of_name(&record.name).is_some_and(|(of, _)| of.name == name);
    if !records.clone().any(|record| is_named(&record)) {
        return Vec::new();
    }
    let is_without = |record: &&Record| record.setting.is_none() && record.setting_signal.is_none();
    records.filter(|record| is_without(record) && !is_named(record)).collect()
}

/// Warns if the tests of a campaign have several settings.
fn note_settings(records: &[Record], notes: &mut Vec<Note>) {
    let all: Vec<&Record> = records.iter().collect();
    notes.extend(several_settings(&all).map(|text| Note { kind: "settings", text }));
}

/// Returns a sentence about the settings of the tests and the options for them. Returns `None` unless the tests have
/// several settings.
pub fn several_settings(records: &[&Record]) -> Option<Sentence> {
    let mut settings: Vec<(Setting, Vec<usize>)> = Vec::new();
    for (k, record) in records.iter().enumerate() {
        let Some(setting) = &record.setting else { continue };
        match settings.iter_mut().find(|(known, _)| known.is_same(setting)) {
            Some((_, tests)) => tests.push(k),
            None => settings.push((setting.clone(), vec![k])),
        }
    }
    settings.sort_by(|(a, _), (b, _)| a.name.cmp(&b.name).then(a.value.total_cmp(&b.value)));
    let (first, _) = settings.first().filter(|_| settings.len() > 1)?;
    let names: Vec<&str> = records.iter().map(|record| record.name.as_str()).collect();
    let listed = settings.iter().map(|(setting, tests)| {
        Sentence::from(phrases::SETTING_AT)
            .with("value", setting_in_words(setting.value, &setting.unit))
            .with_sentence("names", together(&names, tests))
    });
    let text = Sentence::from(phrases::SEVERAL_SETTINGS).with("count", settings.len()).with("option", &first.name);
    let text = with_setting_name(text, "name", &first.name);
    Some(text.with_list("settings", listed.collect(), phrases::SEMICOLON))
}

/// Returns the reason not to fit one damper without a setting to tests at several settings. Returns `None` unless the
/// tests have several settings.
pub fn not_one_damper(records: &[&Record]) -> Option<Sentence> {
    let settings = several_settings(records)?;
    Some(Sentence::from(phrases::NOT_ONE_DAMPER).with_sentence("settings", settings).with("none", WITHOUT_SETTING))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::data::setting_signal::SettingSignal;

    fn record(name: &str) -> Record {
        Record { name: name.into(), ..Record::default() }
    }

    #[test]
    fn tests_of_several_settings_are_told_and_numbered_tests_are_not() {
        let settled = |names: &[&str]| {
            let mut records: Vec<Record> = names.iter().map(|name| record(name)).collect();
            let mut notes = Vec::new();
            assign_settings(&mut records, &SettingRules::default(), &mut notes);
            (records, notes)
        };
        let (records, notes) = settled(&["a_0A", "b_0A", "a_1.6A", "b_1.6A"]);
        assert_eq!(records[2].setting.as_ref().map(|s| s.value), Some(1.6));
        let told = notes[0].text.to_string();
        assert!(notes[0].kind == "settings" && told.contains("2 settings of current"), "{told}");
        assert!(told.contains("0 A: all of '*0A' (2)") || told.contains("0 A: all of '*_0A' (2)"), "{told}");
        // The pattern contains the whole number, so that it does not match a number with the same last digits.
        let (_, notes) = settled(&["a_0.4A", "b_0.4A", "a_1.6A", "b_1.6A"]);
        let told = notes[0].text.to_string();
        assert!(told.contains("'*0.4A' (2)") || told.contains("'*_0.4A' (2)"), "{told}");
        // Groups by current have one setting each and give no note. Groups by damper still have two settings each and
        // give two notes.
        let (mut records, mut notes) = settled(&["a_0A", "b_0A", "a_1.6A", "b_1.6A"]);
        let mut of_dampers = notes.clone();
        note_settings_of_groups([&records[..2], &records[2..]].into_iter(), &mut notes);
        assert!(notes.is_empty());
        records.swap(1, 2);
        note_settings_of_groups([&records[..2], &records[2..]].into_iter(), &mut of_dampers);
        assert_eq!(of_dampers.len(), 2);
        // If a test has a setting channel, names count only if they state the same quantity.
        for (name, expected) in [("voltage", Some(1.98)), ("current", None)] {
            let mut records = vec![record("a_1.98V"), record("b_1.98V"), record("steps")];
            records[2].setting_signal = Some(SettingSignal::new(name, "", &[0.0, 1.0]));
            assign_settings(&mut records, &SettingRules::default(), &mut Vec::new());
            assert_eq!(records[0].setting.as_ref().map(|s| s.value), expected);
            assert!(records[2].setting.is_none());
        }
        // Rounding gives two measured values, 0.40 A and 0.42 A, for one set value.
        let values = [0.4, 0.42, 0.42, 0.0, 0.02, 0.0, 0.8, 1.2];
        let of = |value: f64| Some(Setting { name: "current".into(), unit: "A".into(), value });
        let mut records: Vec<Record> = values.map(|value| Record { setting: of(value), ..record("a") }).into();
        assign_settings(&mut records, &SettingRules::default(), &mut Vec::new());
        let now: Vec<f64> = records.iter().filter_map(|record| Some(record.setting.as_ref()?.value)).collect();
        assert_eq!(now, [0.42, 0.42, 0.42, 0.0, 0.0, 0.0, 0.8, 1.2]);
        let values = [0.39, 0.42, 0.4, 0.41, 0.41];
        let mut drifting: Vec<Record> = values.map(|value| Record { setting: of(value), ..record("a") }).into();
        assign_settings(&mut drifting, &SettingRules::default(), &mut Vec::new());
        assert!(drifting.iter().all(|record| record.setting == of(0.41)), "{drifting:?}");
        // A note reports a name that states the same quantity as the channel with a clearly different value.
        for (name, value, is_noted) in [("a_1.6A", 0.4, true), ("a_1.6A", 1.52, false), ("a_12clicks", 0.4, false)] {
            let setting = Setting { name: "current".into(), unit: "A".into(), value };
            let mut records = vec![Record { setting: Some(setting), ..record(name) }];
            let mut notes = Vec::new();
            assign_settings(&mut records, &SettingRules::default(), &mut notes);
            assert_eq!(notes.iter().any(|note| note.kind == "setting_name"), is_noted, "{name} {notes:?}");
            assert_eq!(records[0].setting.as_ref().map(|s| s.value), Some(value));
        }
        for names in [&["t_1A", "t_2A", "t_3A"][..], &["a_0.4A", "b_0.4A"], &["a_0.4A", "b"]] {
            assert!(settled(names).1.is_empty(), "{names:?}");
        }
    }

    #[test]
    fn pressures_are_one_setting_in_one_unit_and_within_their_scatter() {
        let mut named: Vec<Record> = ["a_75psi", "b_15bar", "a_15bar", "b_5.17bar"].map(record).into();
        assign_settings(&mut named, &SettingRules::default(), &mut Vec::new());
        let found: Vec<(f64, &str)> =
            named.iter().filter_map(|r| r.setting.as_ref()).map(|s| (s.value, s.unit.as_str())).collect();
        assert!(found.iter().all(|(_, unit)| *unit == "bar"), "{found:?}");
        assert!((found[0].0 - 5.171).abs() < 1e-3 && found[1].0 == 15.0, "{found:?}");
        // Some tests have constant pressures in bar, and one has steps in psi.
        let mut stepped = vec![record("a_15bar"), record("b_5bar"), record("steps")];
        stepped[2].setting_signal = Some(SettingSignal::new("pressure", "psi", &[75.0, 75.0, 150.0]));
        assign_settings(&mut stepped, &SettingRules::default(), &mut Vec::new());
        let signal = stepped[2].setting_signal.as_ref().unwrap();
        assert!(signal.unit == "bar" && (signal.range[1] - 10.342).abs() < 1e-3, "{signal:?}");
        assert!((signal.values[0] - 5.171).abs() < 1e-3, "{signal:?}");
        let measured = |values: &[f64], name: &str, unit: &str| {
            let setting = |value: &f64| Some(Setting { name: name.into(), unit: unit.into(), value: *value });
            let mut records: Vec<Record> =
                values.iter().map(|value| Record { setting: setting(value), ..record("a") }).collect();
            assign_settings(&mut records, &SettingRules::default(), &mut Vec::new());
            records.iter().filter_map(|r| r.setting.as_ref()).map(|s| s.value).collect::<Vec<f64>>()
        };
        assert_eq!(measured(&[4.9, 35.1, 5.1, 34.9, 20.0], "pressure", "bar"), [5.0, 35.0, 5.0, 35.0, 20.0]);
        // Settings that are close together stay separate.
        assert_eq!(measured(&[0.0, 1.0, 60.0], "clicks", ""), [0.0, 1.0, 60.0]);
        assert_eq!(measured(&[0.5, 0.54, 3.0], "current", "A"), [0.5, 0.54, 3.0]);
    }
}
