//! Whether the records of a campaign were measured on one clock, so that heat and drifts carry over from test to test.

use dashpot_records::Record;

/// Whether the records' clocks run through the campaign: no two of them overlap. Where each file has a clock of its own, all begin at the same time.
pub fn clock_runs_on(records: &[&Record]) -> bool {
    let mut spans: Vec<(f64, f64)> = records.iter().filter_map(|r| Some((*r.time.first()?, *r.time.last()?))).collect();
    spans.sort_by(|a, b| a.0.total_cmp(&b.0));
    spans.len() > 1 && spans.windows(2).all(|w| w[0].1 <= w[1].0 + 1e-9)
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
        assert!(of(&[[0.0, 2.0], [7.0, 9.0], [2.0, 5.0]]));
        assert!(!of(&[[0.0, 2.0], [0.0, 9.0]]) && !of(&[[0.0, 2.0], [1.0, 9.0]]) && !of(&[[0.0, 2.0]]));
    }
}
