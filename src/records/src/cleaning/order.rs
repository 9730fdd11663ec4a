//! Handles time stamps that repeat or step back.

use crate::data::samples::Samples;
use crate::error::{RecordError, SampleError};
use crate::messages::phrases;
use crate::numbers::{range, sample_time};
use crate::tuning::order::{REACH, STALE};
use dashpot_messages::{Sentence, format_number};

/// Removes rows at the beginning that belong to an earlier run.
///
/// A logger may write out its buffer before new data replace the old. The old rows then come first, and the clock of
/// the later rows does not continue that of the old rows.
pub(crate) fn drop_stale(samples: &mut Samples) {
    let time = &samples.time;
    let mut back = (1..time.len()).filter(|&i| time[i] < time[i - 1]);
    let (Some(first), None) = (back.next(), back.next()) else { return };
    // If the clock steps back, but not to before the first row, the rows are out of order and not from an earlier run.
    // Rows from an earlier run that exceed the fraction [`STALE`] may be a separate test.
    if time[first] >= time[0] || first as f64 > STALE * time.len() as f64 {
        return;
    }
    // A small backward step of the clock means rows out of order, not rows of an earlier run.
    let step = sample_time(&time[first..]);
    if first <= REACH && time[0] - time[first] <= REACH as f64 * step {
        return;
    }
    let (line, from) = (samples.lines[first - 1], time[first - 1]);
    samples.retain(|i| i >= first);
    samples.note(
        "stale",
        Sentence::from(phrases::STALE_ROWS)
            .with("count", first)
            .with("line", line)
            .with("from", format_number(from))
            .with("to", format_number(samples.time[0])),
    );
}

/// Makes time strictly increasing: reorders single rows and spreads rows that share a time stamp.
///
/// # Errors
/// All time stamps are equal, or a row is more than [`REACH`] rows out of order. It is also an error if more than 2 %
/// of the rows (20 in short records) are out of order.
pub(crate) fn restore(samples: &mut Samples) -> Result<(), RecordError> {
    if range(&samples.time) == 0.0 && samples.len() > 1 {
        return Err(SampleError::ConstantTime { at: samples.at.clone(), time: samples.time[0] }.into());
    }
    let back: Vec<usize> = (1..samples.len()).filter(|&i| samples.time[i] < samples.time[i - 1]).collect();
    if let Some(&first) = back.first() {
        let mut order: Vec<usize> = (0..samples.len()).collect();
        order.sort_by(|&a, &b| samples.time[a].total_cmp(&samples.time[b])); // stable
        let moved = order.iter().enumerate().filter(|(i, from)| i != *from).count();
        let reach = order.iter().enumerate().map(|(i, &from)| i.abs_diff(from)).max().unwrap_or(0);
        if reach > REACH || moved as f64 > (0.02 * samples.len() as f64).max(2.0 * REACH as f64) {
            return Err(SampleError::TimeBackwards {
                at: samples.at.clone(),
                line: samples.lines[first],
                from: samples.time[first - 1],
                to: samples.time[first],
            }
            .into());
        }
        let line = samples.lines[first];
        samples.select(&order);
        samples.note(
            "out_of_order",
            Sentence::from(phrases::OUT_OF_ORDER).with("count", back.len()).with("line", line).with("moved", moved),
        );
    }
    spread(samples);
    Ok(())
}

/// Spreads rows that share a time stamp up to the next stamp. The logging interval of such rows is shorter than the
/// resolution of the stamps.
fn spread(samples: &mut Samples) {
    let n = samples.len();
    let shared = (1..n).filter(|&i| samples.time[i] == samples.time[i - 1]).count();
    if shared == 0 {
        return;
    }
    let stamps: Vec<f64> = samples.time.chunk_by(|a, b| a == b).map(|run| run[0]).collect();
    let typical = sample_time(&stamps);
    let mut spread = Vec::with_capacity(n);
    for (k, run) in samples.time.chunk_by(|a, b| a == b).enumerate() {
        let step = stamps.get(k + 1).map_or(typical, |next| next - run[0]) / run.len() as f64;
        spread.extend((0..run.len()).map(|j| run[0] + step * j as f64));
    }
    samples.time = spread;
    samples.note("time_resolution", Sentence::from(phrases::SHARED_STAMPS).with("count", shared).with("rows", n));
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fixtures::SineTest;

    #[test]
    fn rows_of_an_earlier_run_are_left_out() {
        let sound = SineTest::default().samples();
        for (stale, from) in [(7, 33.45), (1, 1e4), (30, 5.0)] {
            let mut samples = sound.clone();
            for k in 0..stale {
                samples.time.insert(k, from + 0.011 * k as f64);
                samples.lines.insert(k, 0);
                samples.force.insert(k, 0.02);
                samples.displacement.as_mut().unwrap().insert(k, 0.04);
                samples.velocity.as_mut().unwrap().insert(k, 0.0);
            }
            drop_stale(&mut samples);
            assert_eq!((samples.time.clone(), samples.force.clone()), (sound.time.clone(), sound.force.clone()));
            let note = samples.notes.last().unwrap();
            let first = if stale == 1 { "the first row (".to_owned() } else { format!("the first {stale} rows (") };
            assert!(note.kind == "stale" && note.text.to_string().contains(&first), "{}", note.text);
        }
        // Two consecutive tests, and rows slightly out of order, do not count as stale rows.
        let mut two = sound.clone();
        for i in 0..two.len() / 2 {
            two.time[i] += 100.0;
        }
        drop_stale(&mut two);
        let mut swapped = sound.clone();
        swapped.time.swap(0, 1);
        drop_stale(&mut swapped);
        assert!(two.len() == sound.len() && swapped.len() == sound.len());
    }

    #[test]
    fn swapped_rows_are_put_back() {
        let sound = SineTest::default().samples();
        let mut samples = sound.clone();
        let mut order: Vec<usize> = (0..samples.len()).collect();
        order.swap(300, 302);
        order.swap(700, 701);
        samples.select(&order);
        restore(&mut samples).unwrap();
        assert_eq!((&samples.time, &samples.force), (&sound.time, &sound.force));
        let text = samples.notes[0].text.to_string();
        assert!(text.contains("line 303"), "{text}");
    }

    #[test]
    fn time_going_back_by_a_block_is_refused() {
        let mut samples = SineTest::default().samples();
        for time in &mut samples.time[400..] {
            *time -= 1.5;
        }
        let error = restore(&mut samples).unwrap_err().to_string();
        assert!(error.contains("line 402") && error.contains("apart 'test'"), "{error}");
    }

    #[test]
    fn constant_time_is_refused() {
        let mut samples = SineTest::default().samples();
        samples.time.fill(3.0);
        assert!(matches!(restore(&mut samples), Err(RecordError::Sample(SampleError::ConstantTime { time: 3.0, .. }))));
    }

    #[test]
    fn coarse_stamps_are_spread_evenly() {
        let mut samples = SineTest { frequency: 2.0, ..SineTest::default() }.samples();
        let true_time = samples.time.clone(); // 400 Hz
        for time in &mut samples.time {
            *time = (*time * 100.0 + 1e-9).floor() / 100.0;
        }
        restore(&mut samples).unwrap();
        assert!(samples.time.windows(2).all(|w| w[1] > w[0]));
        assert!(samples.time.iter().zip(&true_time).all(|(a, b)| (a - b).abs() < 1e-6));
        assert_eq!(samples.notes[0].kind, "time_resolution");
    }

    #[test]
    fn a_row_far_out_of_its_place_is_another_block() {
        let restored = |places: usize| {
            let mut samples = SineTest::default().samples();
            samples.time[100..=100 + places].rotate_left(1);
            restore(&mut samples).is_ok()
        };
        assert!(restored(7) && !restored(14));
    }
}
