//! Common clock of the records of a campaign, with which a model can continue temperature and drift from test to test.

use dashpot_records::{Record, apart};

/// Returns whether the records have one common clock: there are several records, and no two overlap. If each file has
/// its own clock, all records begin at the same time and overlap.
pub fn clock_runs_on(records: &[&Record]) -> bool {
    apart(records.iter().filter_map(|record| record.span()).collect())
}

/// Returns the date and time at which the common clock was zero, s since 1970 by the rig's own clock. Returns `None` if
/// the records have no common clock or do not state consistent times.
pub fn clock_from(records: &[&Record]) -> Option<f64> {
    let mut from = records.iter().map(|record| Some(record.begins? - record.clock_s));
    let first = from.next()??;
    (clock_runs_on(records) && from.all(|other| other.is_some_and(|other| (other - first).abs() < 1e-3)))
        .then_some(first)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn clocks_that_start_anew_or_overlap_do_not_run_on() {
        let of = |spans: &[[f64; 2]]| {
            let records: Vec<Record> =
                spans.iter().map(|span| Record { time: span.to_vec(), ..Record::default() }).collect();
            clock_runs_on(&records.iter().collect::<Vec<_>>())
        };
        let with = |begins: f64, clock_s: f64| Record {
            begins: Some(begins),
            clock_s,
            time: vec![0.0, 2.0],
            ..Record::default()
        };
        assert_eq!(clock_from(&[&with(1e9, 0.0), &with(1e9 + 60.0, 60.0)]), Some(1e9));
        assert_eq!(clock_from(&[&with(1e9, 0.0), &with(1e9 + 70.0, 60.0)]), None);
        assert_eq!(clock_from(&[&with(1e9, 0.0), &with(1e9 + 1.0, 1.0)]), None);
        assert!(of(&[[0.0, 2.0], [7.0, 9.0], [2.0, 5.0]]));
        assert!(!of(&[[0.0, 2.0], [0.0, 9.0]]) && !of(&[[0.0, 2.0], [1.0, 9.0]]) && !of(&[[0.0, 2.0]]));
    }
}
