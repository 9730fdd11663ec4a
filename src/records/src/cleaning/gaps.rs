//! Finds gaps in time, from a paused logger or a lost buffer. The data on both sides are separate tests.

use super::cycles::{self, turning_points};
use crate::data::cycle::Cycle;
use crate::data::record::Note;
use crate::data::samples::Samples;
use crate::messages::phrases;
use crate::numbers::{median, range};
use crate::tuning::cleaning::FEWEST;
use crate::tuning::gaps::{AROUND, BEYOND, LONGER, TURNS};
use dashpot_messages::{Sentence, format_decimals};
use std::ops::Range;

/// Splits a test at its gaps, and removes pieces with too few samples. Inserts a note about the gaps before the other
/// notes.
pub(crate) fn split(mut samples: Samples) -> Vec<Samples> {
    let gaps = find(&samples.time);
    if gaps.is_empty() {
        return vec![samples];
    }
    let places: Vec<Sentence> = gaps
        .iter()
        .take(5)
        .map(|&i| {
            let (from, to) = (samples.time[i - 1], samples.time[i]);
            Sentence::from(phrases::GAP)
                .with("seconds", format_decimals(to - from, 4))
                .with("from", format_decimals(from, 4))
                .with("line", samples.lines[i])
        })
        .collect();
    let more = gaps.len() - places.len();
    let more = (more > 0).then(|| Sentence::from(phrases::MORE_GAPS).with("count", more));
    let bounds: Vec<usize> = std::iter::once(0).chain(gaps).chain([samples.len()]).collect();
    let pieces: Vec<std::ops::Range<usize>> = bounds.windows(2).map(|w| w[0]..w[1]).collect();
    let mut kept: Vec<&std::ops::Range<usize>> = pieces.iter().filter(|p| p.len() >= FEWEST).collect();
    let stumps = leave_out_stumps(&samples, &mut kept);
    let dropped: usize = pieces.iter().filter(|p| p.len() < FEWEST).map(std::iter::ExactSizeIterator::len).sum();
    let rest = (dropped > 0).then(|| Sentence::from(phrases::TOO_FEW_BETWEEN).with("count", dropped));
    let text = Sentence::from(phrases::GAPS)
        .with_list("places", places, phrases::COMMA)
        .with_any("more", more)
        .with("count", kept.len())
        .with_any("rest", rest);
    samples.notes.insert(0, Note { kind: "gap", text });
    if let Some(text) = stumps {
        samples.notes.insert(1, Note { kind: "gap", text });
    }
    if kept.len() < 2 {
        if let [only] = kept[..] {
            samples.select(&only.clone().collect::<Vec<_>>());
        }
        return vec![samples];
    }
    kept.iter()
        .enumerate()
        .map(|(k, range)| {
            let mut piece = samples.piece((*range).clone());
            piece.name = format!("{} part {}", samples.name, k + 1);
            let part = format!("part {} of {}", k + 1, kept.len());
            piece.at.part = Some(samples.at.part.as_ref().map_or(part.clone(), |p| format!("{p}, {part}")));
            piece
        })
        .collect()
}

/// Removes pieces without a whole cycle if other pieces have cycles. Returns a note about the removed pieces.
///
/// Such a piece is a motion that the gap interrupts. A piece with a larger range or more turning points is a motion of
/// another kind and stays.
fn leave_out_stumps(samples: &Samples, kept: &mut Vec<&Range<usize>>) -> Option<Sentence> {
    let x = samples.displacement.as_deref().filter(|x| x.iter().all(|x| x.is_finite()))?;
    let stroke = |span: &Range<usize>| {
        let cycles = cycles::find(&samples.time[span.clone()], &x[span.clone()]);
        cycles.iter().map(Cycle::stroke).reduce(f64::max)
    };
    let strokes: Vec<Option<f64>> = kept.iter().map(|span| stroke(span)).collect();
    let largest = strokes.iter().flatten().copied().fold(0.0, f64::max);
    let is_stump = |span: &Range<usize>| {
        let x = &x[span.clone()];
        range(x) <= BEYOND * largest && turning_points(x, 0.3 * largest).len() <= TURNS
    };
    let without = kept.iter().zip(&strokes).filter(|(span, stroke)| stroke.is_none() && is_stump(span));
    let stumps: Vec<Range<usize>> = without.map(|(span, _)| (*span).clone()).collect();
    kept.retain(|span| !stumps.contains(span));
    let place = |span: &Range<usize>| {
        Sentence::from(phrases::FROM_TO)
            .with("from", format_decimals(samples.time[span.start], 4))
            .with("to", format_decimals(samples.time[span.end - 1], 4))
    };
    (!stumps.is_empty()).then(|| {
        Sentence::from(phrases::STUMPS).with("count", stumps.len()).with_list(
            "places",
            stumps.iter().take(5).map(place).collect(),
            phrases::COMMA,
        )
    })
}

/// Returns the indices of the samples that follow a gap.
fn find(time: &[f64]) -> Vec<usize> {
    let steps: Vec<f64> = time.windows(2).map(|w| w[1] - w[0]).collect();
    let typical = median(&mut steps.clone());
    (0..steps.len())
        // The comparison with the typical step of the whole record is fast and selects few candidates.
        .filter(|&k| steps[k] > LONGER * typical)
        .filter(|&k| {
            let side = |range: std::ops::Range<usize>| {
                let mut around: Vec<f64> = steps[range].to_vec();
                (!around.is_empty()).then(|| median(&mut around))
            };
            let before = side(k.saturating_sub(AROUND)..k);
            let after = side(k + 1..(k + 1 + AROUND).min(steps.len()));
            [before, after].into_iter().flatten().all(|around| steps[k] > LONGER * around)
        })
        .map(|k| k + 1)
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fixtures::SineTest;

    #[test]
    fn a_pause_makes_two_tests_and_is_told_first() {
        let mut samples = SineTest::default().samples();
        samples.note("other", phrases::TIME_OF_DAY.into());
        let n = samples.len();
        for t in &mut samples.time[n / 2..] {
            *t += 3.0;
        }
        let pieces = split(samples);
        assert_eq!(pieces.len(), 2);
        assert_eq!(pieces[0].len() + pieces[1].len(), n);
        assert_eq!(pieces[1].name, "test part 2");
        assert_eq!(pieces[1].at.to_string(), "test.csv (part 2 of 2)");
        for piece in &pieces {
            assert_eq!(piece.notes[0].kind, "gap");
            assert!({
                let text = piece.notes[0].text.to_string();
                text.contains("3.0050 s without samples") && text.contains("2 tests")
            });
        }
    }

    #[test]
    fn lost_samples_and_a_change_of_rate_are_no_gaps() {
        let mut samples = SineTest::default().samples();
        samples.retain(|i| !(300..308).contains(&i));
        let n = samples.len();
        // In the second half, only every fortieth sample remains.
        samples.retain(|i| i < n / 2 || i % 40 == 0);
        assert_eq!(split(samples).len(), 1);
    }

    #[test]
    fn scraps_are_left_out() {
        let mut samples = SineTest::default().samples();
        for t in &mut samples.time[5..] {
            *t += 10.0;
        }
        let n = samples.len();
        let pieces = split(samples);
        assert_eq!(pieces.len(), 1);
        assert_eq!(pieces[0].len(), n - 5);
        assert!(pieces[0].notes[0].text.to_string().contains("too few"));
    }

    #[test]
    fn a_stump_without_a_whole_cycle_is_left_out() {
        let sine = SineTest { frequency: 4.0, ..SineTest::default() };
        let mut samples = sine.samples();
        // The gap leaves a first piece without a whole cycle.
        let at = ((sine.steady_from() + 0.3) * 200.0) as usize;
        let (from, to) = (at.min(samples.len() / 4), samples.len());
        let step = samples.time[1] - samples.time[0];
        samples.time[from..to].iter_mut().for_each(|t| *t += 40.0 * step);
        let pieces = split(samples.clone());
        assert_eq!(pieces.len(), 1, "{:?}", pieces.iter().map(Samples::len).collect::<Vec<_>>());
        assert_eq!(pieces[0].len(), to - from);
        assert!(pieces[0].notes[1].text.to_string().contains("no whole cycle"), "{}", pieces[0].notes[1].text);
        // If the pieces before and after the gap have whole cycles, they are two tests.
        let mut halves = sine.samples();
        let middle = halves.len() / 2;
        halves.time[middle..].iter_mut().for_each(|t| *t += 40.0 * step);
        assert_eq!(split(halves).len(), 2);
    }

    #[test]
    fn a_slower_rate_is_no_gap_from_sixteen_steps_on() {
        // A logger at 200 Hz that records some samples at 5 Hz. The middle one of 15 slow steps has more fast than slow
        // steps on either side.
        let time = |slow: usize| {
            let mut t = 0.0;
            let steps = (0..200 + slow).map(|k| if (100..100 + slow).contains(&k) { 0.2 } else { 0.005 });
            let later = steps.map(|step| {
                t += step;
                t
            });
            std::iter::once(0.0).chain(later).collect::<Vec<f64>>()
        };
        assert_eq!(find(&time(15)), [108]);
        assert!(find(&time(16)).is_empty());
    }

    /// Returns how many pieces remain of two: whole cycles of a sine of 20 mm stroke, and the motion `other`, mm.
    fn pieces_with(other: &[f64]) -> usize {
        let mut x: Vec<f64> =
            (0..1000).map(|i| 0.01 * libm::sin(std::f64::consts::TAU * f64::from(i) / 200.0)).collect();
        let sine = x.len();
        x.extend(other.iter().map(|x| 1e-3 * x));
        let samples = crate::fixtures::moving(200.0, x);
        let (time, x) = (&samples.time, samples.displacement.as_deref().unwrap());
        assert!(cycles::find(&time[sine..], &x[sine..]).is_empty());
        let (first, second) = (0..sine, sine..samples.len());
        let mut kept = vec![&first, &second];
        leave_out_stumps(&samples, &mut kept);
        kept.len()
    }

    #[test]
    fn a_larger_motion_without_a_cycle_is_no_stump() {
        let ramp = |range: f64| -> Vec<f64> { (0..200).map(|i| range * f64::from(i) / 199.0).collect() };
        assert_eq!((pieces_with(&ramp(21.0)), pieces_with(&ramp(23.0))), (1, 2));
    }

    #[test]
    fn a_motion_of_many_turns_without_a_cycle_is_no_stump() {
        // Strokes of very different duration are no cycles.
        let strokes = |count: usize| -> Vec<f64> {
            let lengths = [100, 25, 160, 40, 15, 130, 60, 20, 90].into_iter().take(count);
            let ends = lengths.enumerate().map(|(k, n)| (n, if k % 2 == 0 { [0.0, 18.0] } else { [18.0, 0.0] }));
            ends.flat_map(|(n, [from, to])| (0..n).map(move |i| from + (to - from) * f64::from(i) / f64::from(n)))
                .collect()
        };
        assert_eq!((pieces_with(&strokes(4)), pieces_with(&strokes(8))), (1, 2));
    }
}
