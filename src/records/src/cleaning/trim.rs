//! Removes everything but whole cycles: standstill and run-up before them, run-down and standstill after them, and a
//! noisy last cycle.

use crate::data::complete_test::CompleteTest;
use crate::data::cycle::Cycle;
use crate::data::record::Note;
use crate::messages::phrases;
use crate::numbers::median;
use crate::signal::noise::cycle_deviations;
use crate::tuning::trim::NOISY;
use dashpot_messages::{Sentence, format_decimals};

/// Trims the test to its whole cycles, with notes. A test that is not periodic stays whole.
pub(crate) fn trim(motion: &mut CompleteTest) {
    let n = motion.time.len();
    if motion.cycles.is_empty() {
        motion.notes.push(Note { kind: "not_periodic", text: Sentence::from(phrases::NO_CYCLES).with("samples", n) });
        return;
    }
    drop_noisy_last(motion);
    let span = motion.steady();
    let first = &motion.cycles[0];
    let (before, after) = (motion.time[span.start] - motion.time[0], motion.time[n - 1] - motion.time[span.end - 1]);
    let count = motion.cycles.len();
    let frequency = count as f64 / motion.cycles.iter().map(Cycle::period).sum::<f64>();
    if span.start > 0 || span.end < n {
        // After the last whole cycle, the damper moves in an incomplete cycle or a run-down, or it stands still.
        let moved = super::range(&motion.displacement[span.end.min(n - 1)..]) > 0.1 * first.stroke();
        let tail = if moved { "an incomplete cycle or run-down" } else { "rest" };
        motion.notes.push(Note {
            kind: "trimmed",
            text: Sentence::from(phrases::TRIMMED)
                .with("before", format_decimals(before, 3))
                .with("samples_before", span.start)
                .with("after", format_decimals(after, 3))
                .with("samples_after", n - span.end)
                .with_word("tail", if span.end < n { tail } else { "nothing" })
                .with("cycles", count)
                .with("frequency", format_decimals(frequency, 4)),
        });
    }
    let runs = motion.cycles.windows(2).filter(|pair| pair[0].end != pair[1].start).count();
    if runs > 0 {
        motion.notes.push(Note { kind: "cycles", text: Sentence::from(phrases::UNLIKE_CYCLES).with("places", runs) });
    }
    let cut = |values: &mut Vec<f64>| {
        values.truncate(span.end);
        values.drain(..span.start);
    };
    for values in [&mut motion.time, &mut motion.displacement, &mut motion.velocity, &mut motion.force] {
        cut(values);
    }
    for values in [&mut motion.side_force, &mut motion.temperature].into_iter().flatten() {
        cut(values);
    }
    for cycle in &mut motion.cycles {
        cycle.start -= span.start;
        cycle.end -= span.start;
    }
}

/// Removes a last cycle that the stopping of the rig disturbs. The comparison with the other cycles requires four or
/// more cycles.
fn drop_noisy_last(motion: &mut CompleteTest) {
    let count = motion.cycles.len();
    if count < 4 {
        return;
    }
    let deviations = cycle_deviations(&motion.time, &motion.force, &motion.cycles[count.saturating_sub(9)..]);
    let last = deviations[deviations.len() - 1];
    let typical = median(&mut deviations[..deviations.len() - 1].to_vec());
    if last > NOISY * typical && typical > 0.0 {
        let seconds = motion.cycles[count - 1].start_time;
        motion.cycles.pop();
        motion.notes.push(Note {
            kind: "noisy_last_cycle",
            text: Sentence::from(phrases::NOISY_LAST)
                .with("start", format_decimals(seconds, 3))
                .with("last", format_decimals(last, 1))
                .with("typical", format_decimals(typical, 1)),
        });
    }
}
