//! Selection of tests from a very large campaign for the fit of a damper family.

use super::settings::SettingRecords;
use crate::phrases;
use dashpot_estimation::samples::selection::{MOST_CHANGING, most_at_setting, select_at_most};
use dashpot_messages::Sentence;
use dashpot_records::Record;

/// Selects tests of every kind of motion at each setting, and among those with a changing setting. Removes all other tests from both
/// arguments. Returns a note if tests are left out.
pub fn select_tests(settings: &mut [SettingRecords], changing: &mut Vec<&Record>) -> Option<Sentence> {
    let count = |settings: &[SettingRecords], changing: &[&Record]| {
        settings.iter().map(|of| of.records.len()).sum::<usize>() + changing.len()
    };
    let all = count(settings, changing);
    let most = most_at_setting(settings.len());
    let reduce = |records: &mut Vec<&Record>, most: usize| {
        if let Some(places) = select_at_most(records, most) {
            *records = places.iter().map(|place| records[*place]).collect();
        }
    };
    for of in settings.iter_mut() {
        reduce(&mut of.records, most);
    }
    reduce(changing, MOST_CHANGING);
    let selected = count(settings, changing);
    (selected < all).then(|| {
        let note = Sentence::from(phrases::FAMILY_SELECTED).with("all", all).with("selected", selected);
        note.with("most", most).with("changing", changing.len())
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use dashpot_records::SettingSignal;

    #[test]
    fn every_setting_keeps_its_kinds_of_motion() {
        let record = |k: usize, signal: Option<SettingSignal>| Record {
            amplitude: 0.01,
            peak_velocity: if k == 700 { 1.5 } else { 0.2 },
            setting_signal: signal,
            cycles: vec![0..1, 1..2],
            ..Record::default()
        };
        let soft: Vec<Record> = (0..1000).map(|k| record(k, None)).collect();
        let hard: Vec<Record> = (0..20).map(|k| record(k, None)).collect();
        let step: Vec<f64> = (0..40).map(|i| if i < 20 { 0.0 } else { 1.0 }).collect();
        let signal = SettingSignal::new("current", "A", &step);
        let steps: Vec<Record> = (0..100).map(|k| record(k, Some(signal.clone()))).collect();
        let mut settings = vec![
            SettingRecords { value: 0.0, records: soft.iter().collect() },
            SettingRecords { value: 1.0, records: hard.iter().collect() },
        ];
        let mut changing: Vec<&Record> = steps.iter().collect();
        let note = select_tests(&mut settings, &mut changing).unwrap().to_string();
        let counts: Vec<usize> = settings.iter().map(|of| of.records.len()).collect();
        assert_eq!((counts, changing.len()), (vec![240, 20], 24));
        assert!(settings[0].records.iter().any(|record| record.peak_velocity > 1.0));
        assert!(note.contains("1120 tests") && note.contains("284 of them"), "{note}");
        assert!(select_tests(&mut settings, &mut changing).is_none());
    }
}
