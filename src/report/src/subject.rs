//! Test object, operator and date of the measurement, from the files. Missing entries stay blank for handwriting.

use super::numbers::digits;
use crate::words::Words;
use dashpot_messages::Message;
use dashpot_records::{Record, TestMetadata, clock};

/// Largest number of different values of an entry, such as the serial number, that are listed individually.
const LISTED: usize = 3;
/// Smallest start time of a record, s since 1970-01-01, that includes a date. A smaller value is a time of an unknown day.
const DAY: f64 = 86_400.0;

/// Returns one line each for part, serial number, date and operator, which a certificate requires. Rig and temperature follow if they are
/// known.
pub fn lines(records: &[&Record], words: &Words) -> Vec<String> {
    let said = |of: fn(&TestMetadata) -> &Option<String>| {
        let mut values: Vec<String> = Vec::new();
        for value in records.iter().filter_map(|record| of(&record.about).clone()) {
            if !values.contains(&value) {
                values.push(value);
            }
        }
        in_short(&values, words)
    };
    let needed = |text: Message, value: Option<String>| {
        words.fill(text, &[("text", value.as_deref().unwrap_or(words.to_fill_in))])
    };
    let mut lines = vec![
        needed(words.subject_part, said(|about| &about.part)),
        needed(words.subject_serial, said(|about| &about.serial)),
        needed(words.subject_measured, when(records, words)),
        needed(words.subject_tester, said(|about| &about.tester)),
    ];
    lines.extend(said(|about| &about.rig).map(|rig| words.fill(words.subject_rig, &[("text", &rig)])));
    lines.extend(temperature(records, words));
    lines
}

/// Lists values. If there are more than [`LISTED`], lists only the first, the last and the number of values. Returns `None` without values.
fn in_short(values: &[String], words: &Words) -> Option<String> {
    match values {
        [] => None,
        [first, .., last] if values.len() > LISTED => Some(format!("{first} … {last} ({})", values.len())),
        few => Some(few.join(words.comma)),
    }
}

/// Returns the day of the measurement, or the first and the last day. Returns `None` if no record has a date.
fn when(records: &[&Record], words: &Words) -> Option<String> {
    let begins = records.iter().filter_map(|record| record.begins).filter(|seconds| *seconds >= DAY);
    let (first, last) = begins.fold((f64::MAX, f64::MIN), |(low, high), s| (low.min(s), high.max(s)));
    if first > last {
        return None;
    }
    let day = |seconds: f64| clock::written(seconds).split(' ').next().unwrap_or_default().to_owned();
    let (first, last) = (day(first), day(last));
    Some(if first == last { first } else { words.fill(words.range, &[("low", &first), ("high", &last)]) })
}

fn temperature(records: &[&Record], words: &Words) -> Option<String> {
    let values = records.iter().filter_map(|record| record.temperature.as_ref()).flatten().filter(|t| t.is_finite());
    let (low, high) = values.fold((f64::MAX, f64::MIN), |(low, high), t| (low.min(*t), high.max(*t)));
    let write = |value: f64| digits(value, 3);
    (low <= high).then(|| words.fill(words.subject_temperature, &[("low", &write(low)), ("high", &write(high))]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::words::{DE, EN};

    #[test]
    fn what_the_files_say_is_told_and_the_rest_is_left_to_be_filled_in() {
        let mut a = Record { begins: Some(20_000.5 * DAY), temperature: Some(vec![22.0, 24.54]), ..Record::default() };
        a.about.part = Some("8K0 513 035 A".into());
        let mut b = Record { begins: Some(20_001.5 * DAY), ..a.clone() };
        b.about.tester = Some("K. Brandt".into());
        let german = lines(&[&a, &b], &DE);
        assert_eq!(
            german,
            [
                "Teil: 8K0 513 035 A",
                "Seriennummer: ______________________________",
                "Gemessen am: 2024-10-04 bis 2024-10-05",
                "Prüfer: K. Brandt",
                "Temperatur bei der Messung: 22,0 bis 24,5 °C",
            ]
        );
        // A time on an unknown day does not give a date.
        let clock = Record { begins: Some(3600.0), ..Record::default() };
        let empty = lines(&[&clock], &EN);
        assert_eq!(empty.len(), 4);
        assert!(empty.iter().all(|line| line.ends_with(EN.to_fill_in)), "{empty:?}");
    }

    #[test]
    fn many_values_are_told_in_short() {
        let values: Vec<String> = (1..6).map(|k| k.to_string()).collect();
        assert_eq!(in_short(&values, &EN).unwrap(), "1 … 5 (5)");
        assert_eq!(in_short(&values[..2], &EN).unwrap(), "1, 2");
        assert!(in_short(&[], &EN).is_none());
    }
}
