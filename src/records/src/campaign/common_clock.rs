//! Puts the records of a campaign on one common time axis (clock) if all files state when their tests began.
//!
//! A model can then continue the states of temperature and drift from one file to the next.

use crate::data::record::{Note, Record};
use crate::dates::clock::{DAY, written};
use crate::messages::phrases;
use crate::tuning::common_clock::{WITH_DATE, WITHOUT_DATE};
use dashpot_messages::Sentence;
use std::cmp::Ordering;

/// Sets [`Record::clock_s`] of every record, so that all records have one common time axis. Adds a note that states the
/// common clock or why there is none. Changes nothing if fewer than two records exist, if no record states its start,
/// or if the records already have a common clock.
pub(crate) fn assign(records: &mut [Record], notes: &mut Vec<Note>) {
    let bearing = records.iter().filter(|record| record.begins.is_some()).count();
    if bearing == 0 || records.len() < 2 || apart(records.iter().filter_map(Record::span).collect()) {
        return;
    }
    let not = |reason: Sentence| Note {
        kind: "clock",
        text: Sentence::from(phrases::OWN_CLOCKS).with_sentence("why", reason),
    };
    if bearing < records.len() {
        let reason = Sentence::from(phrases::SOME_WITHOUT_DATE).with("count", bearing).with("all", records.len());
        return notes.push(not(reason));
    }
    let spans: Vec<(f64, f64)> =
        records.iter().filter_map(|r| Some((r.begins? + r.time.first()?, r.begins? + r.time.last()?))).collect();
    let first = spans.iter().map(|span| span.0).fold(f64::INFINITY, f64::min);
    let last = spans.iter().map(|span| span.1).fold(f64::NEG_INFINITY, f64::max);
    let dated = records.iter().filter(|record| record.begins >= Some(DAY)).count();
    if dated > 0 && dated < records.len() || last - first > if dated > 0 { WITH_DATE } else { WITHOUT_DATE } {
        return notes.push(not(phrases::TOO_FAR_APART.into()));
    }
    // A test whose start is stated in whole seconds may have begun up to one second later. An overlap of up to one
    // second is therefore accepted.
    let is_whole = records.iter().all(|record| record.begins.is_some_and(|s| s.fract() == 0.0));
    let later = if is_whole { 1.0 } else { 0.0 };
    if !apart(spans.iter().map(|(from, to)| (from + later, *to)).collect()) {
        return notes.push(not(phrases::CLOCKS_OVERLAP.into()));
    }
    let mut in_order: Vec<&mut Record> = records.iter_mut().collect();
    in_order.sort_by(|a, b| a.begins.partial_cmp(&b.begins).unwrap_or(Ordering::Equal));
    let mut end = f64::NEG_INFINITY;
    for record in in_order {
        let begins = record.begins.unwrap_or(first) - first;
        let [from, to] = [record.time.first(), record.time.last()].map(|t| t.copied().unwrap_or(0.0));
        record.clock_s = begins.max(end - from);
        end = record.clock_s + to;
    }
    let text = Sentence::from(phrases::ONE_CLOCK).with("first", written(first)).with("last", written(last));
    notes.push(Note { kind: "clock", text });
}

/// Returns whether there are at least two spans and no two of them overlap. A span is start and end, s. Overlaps up to
/// 1e-9 s count as rounding errors.
pub fn apart(mut spans: Vec<(f64, f64)>) -> bool {
    spans.sort_by(|a, b| a.0.total_cmp(&b.0));
    spans.len() > 1 && spans.windows(2).all(|w| w[0].1 <= w[1].0 + 1e-9)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(begins: &[Option<f64>]) -> (Vec<Record>, String) {
        let record = |begins: &Option<f64>| Record { begins: *begins, time: vec![0.5, 10.5], ..Record::default() };
        let mut records: Vec<Record> = begins.iter().map(record).collect();
        let mut notes = Vec::new();
        assign(&mut records, &mut notes);
        (records, notes.iter().map(|note| note.text.to_string()).collect())
    }

    #[test]
    fn dated_records_are_put_on_one_clock_from_the_first_sample_on() {
        let morning = crate::dates::clock::seconds("2026-11-25 10:00:00").unwrap();
        let (records, said) = of(&[Some(morning + 600.0), Some(morning), Some(morning + 60.0)]);
        assert_eq!(records.iter().map(|r| r.span().unwrap().0).collect::<Vec<_>>(), [600.0, 0.0, 60.0]);
        assert!(said.contains("2026-11-25 10:00:00") && said.contains("2026-11-25 10:10:10"), "{said}");
        // The files state the time in whole seconds and overlap by less than one second. The second test then begins at
        // the end of the first.
        let (records, said) = of(&[Some(morning + 9.0), Some(morning)]);
        assert_eq!(
            records.iter().map(|r| r.span().unwrap()).collect::<Vec<_>>(),
            [(10.0, 20.0), (0.0, 10.0)],
            "{said}"
        );
        assert!(of(&[Some(morning + 8.0), Some(morning)]).1.contains("overlap"));
        let (records, said) = of(&[Some(36_000.0), Some(36_060.0)]);
        assert_eq!(records[1].clock_s, 59.5);
        assert!(said.contains(" 10:00:00") && !said.contains("1970"), "{said}");
    }

    #[test]
    fn what_is_no_one_clock_is_said() {
        let day = 20_000.0 * DAY;
        for (begins, why) in [
            (&[Some(day), Some(day + 5.0)][..], "overlap"),
            (&[Some(day), None], "1 of 2"),
            (&[Some(day), Some(600.0)], "far apart"),
            (&[Some(86_000.0), Some(600.0)], "far apart"),
            (&[Some(day), Some(2.0 * day)], "far apart"),
        ] {
            let (records, said) = of(begins);
            assert!(said.contains(why) && records.iter().all(|r| r.clock_s == 0.0), "{begins:?}: {said}");
        }
        assert_eq!(of(&[None, None]).1 + &of(&[Some(day)]).1, "");
    }

    #[test]
    fn a_campaign_with_dates_lasts_a_year_at_most() {
        let day = 20_000.0 * DAY;
        let said = |days: f64| of(&[Some(day), Some(day + days * DAY)]).1;
        assert!(!said(200.0).contains("far apart") && said(400.0).contains("far apart"));
    }
}
