//! Reports slow changes of mean displacement and force over the cycles. No change is removed.

use crate::data::cycle::Cycle;
use crate::data::record::Note;
use crate::messages::phrases;
use crate::signal::noise;
use dashpot_messages::{Sentence, format_decimals};

/// Adds notes about significant drifts of the cycle means of displacement and force. A drift is significant above 2 %
/// of the stroke or 1 % of the force range, and above three times the scatter. Fewer than three cycles give no notes.
pub(crate) fn report(time: &[f64], displacement: &[f64], force: &[f64], cycles: &[Cycle], notes: &mut Vec<Note>) {
    if cycles.len() < 3 {
        return;
    }
    let stroke = cycles.iter().map(Cycle::stroke).sum::<f64>() / cycles.len() as f64;
    let (shift, scatter) = trend(time, displacement, cycles);
    if shift.abs() > 0.02 * stroke && shift.abs() > 3.0 * scatter {
        notes.push(Note {
            kind: "drift",
            text: Sentence::from(phrases::DISPLACEMENT_DRIFTS)
                .with("drift", format_decimals(1e3 * shift, 3))
                .with("cycles", cycles.len())
                .with("percent", format_decimals(100.0 * shift / stroke, 1)),
        });
    }
    let span = cycles.iter().flat_map(|c| &force[c.start..c.end]);
    let (low, high) = span.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), &v| (l.min(v), h.max(v)));
    let (shift, scatter) = trend(time, force, cycles);
    let floor = noise::difference_noise(force) / (cycles[0].end - cycles[0].start) as f64;
    if shift.abs() > 0.01 * (high - low) && shift.abs() > 3.0 * scatter.max(floor) {
        notes.push(Note {
            kind: "drift",
            text: Sentence::from(phrases::FORCE_DRIFTS)
                .with("drift", format_decimals(shift, 1))
                .with("cycles", cycles.len())
                .with("percent", format_decimals(100.0 * shift / (high - low), 1)),
        });
    }
}

/// Fits a straight line over time to the cycle means of `values`. Returns the change from the first to the last cycle,
/// and the root mean square deviation from the line.
fn trend(time: &[f64], values: &[f64], cycles: &[Cycle]) -> (f64, f64) {
    let n = cycles.len() as f64;
    let means: Vec<f64> = cycles.iter().map(|c| time_mean(time, values, c.start, c.end)).collect();
    let at: Vec<f64> = cycles.iter().map(|c| c.start_time).collect();
    let (mean_t, mean_v) = (at.iter().sum::<f64>() / n, means.iter().sum::<f64>() / n);
    let stt: f64 = at.iter().map(|t| (t - mean_t).powi(2)).sum();
    let slope = at.iter().zip(&means).map(|(t, v)| (t - mean_t) * (v - mean_v)).sum::<f64>() / stt;
    let rest: f64 = at.iter().zip(&means).map(|(t, v)| (v - mean_v - slope * (t - mean_t)).powi(2)).sum();
    (slope * (at[cycles.len() - 1] - at[0]), (rest / n).sqrt())
}

/// Computes the mean over time from sample `start` to sample `end` by trapezoids, so that uneven sampling has no
/// influence.
pub(crate) fn time_mean(time: &[f64], values: &[f64], start: usize, end: usize) -> f64 {
    let last = end.min(time.len() - 1);
    if last <= start {
        return values[start];
    }
    let area: f64 = (start..last).map(|i| 0.5 * (values[i] + values[i + 1]) * (time[i + 1] - time[i])).sum();
    area / (time[last] - time[start])
}

#[cfg(test)]
mod tests {
    use super::super::cycles;
    use super::*;
    use crate::fixtures::SineTest;

    #[test]
    fn drift_is_told_with_its_size_and_absence_is_not() {
        let samples = SineTest { cycles: 10, ..SineTest::default() }.samples();
        let (time, mut x, mut force) = (samples.time, samples.displacement.unwrap(), samples.force);
        let mut notes = Vec::new();
        report(&time, &x, &force, &cycles::find(&time, &x), &mut notes);
        assert!(notes.is_empty(), "{notes:?}");
        for i in 0..time.len() {
            x[i] += 5e-4 * time[i];
            force[i] -= 6.0 * time[i];
        }
        report(&time, &x, &force, &cycles::find(&time, &x), &mut notes);
        assert_eq!(notes.len(), 2, "{notes:?}");
        // The distance between the first and the last cycle is nine periods of 1 s. Drifts of 0.5 mm/s and −6 N/s thus
        // give 4.5 mm and −54 N.
        assert!(notes[0].text.to_string().contains("drifts by 4.5"), "{}", notes[0].text);
        assert!(
            notes[1].text.to_string().contains("drifts by -54.")
                || notes[1].text.to_string().contains("drifts by -53."),
            "{}",
            notes[1].text
        );
    }
}
