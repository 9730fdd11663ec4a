//! Removes blocks of rows that an export or a logger buffer wrote twice.

use std::collections::HashMap;

use crate::data::samples::Samples;
use crate::messages::phrases;
use crate::numbers::{median, range};
use crate::quantities::channel::Channel;
use crate::tuning::duplicates::BLOCK;
use dashpot_messages::Sentence;

/// Largest number of positions in one search that are checked for a repeated block. Each check takes a time
/// proportional to the number of rows.
const LOOKS: usize = 200;

/// Removes repeated rows. One note reports rows with equal time stamps, and another note reports blocks with new time
/// stamps.
pub(crate) fn remove(samples: &mut Samples) {
    same_time(samples);
    new_time(samples);
}

/// Returns a hash of one row's values, exact to the last bit.
fn row_key(samples: &Samples, i: usize, channels: &[Channel]) -> u64 {
    // FNV-1a over the bits. Equality is decided by the values, not by the hash.
    channels.iter().filter_map(|&c| samples.channel(c)).fold(0xcbf2_9ce4_8422_2325, |hash: u64, values| {
        let mixed = (hash ^ values[i].to_bits()).wrapping_mul(0x0000_0100_0000_01b3);
        mixed ^ (mixed >> 29)
    })
}

fn equal(samples: &Samples, i: usize, j: usize, channels: &[Channel]) -> bool {
    channels.iter().filter_map(|&c| samples.channel(c)).all(|values| values[i] == values[j])
}

/// Removes rows that equal an earlier row in time, force and motion.
fn same_time(samples: &mut Samples) {
    let channels = [Channel::Time, Channel::Force, Channel::Displacement, Channel::Velocity];
    let mut seen: HashMap<u64, usize> = HashMap::with_capacity(samples.len());
    let mut repeated = vec![false; samples.len()];
    for (i, repeated) in repeated.iter_mut().enumerate() {
        let first = *seen.entry(row_key(samples, i, &channels)).or_insert(i);
        *repeated = first != i && equal(samples, first, i, &channels);
    }
    let count = repeated.iter().filter(|&&r| r).count();
    if count == 0 {
        return;
    }
    let first = repeated.iter().position(|&r| r).unwrap_or(0);
    let blocks = repeated.chunk_by(|a, b| a == b).filter(|run| run[0]).count();
    let line = samples.lines[first];
    samples.retain(|i| !repeated[i]);
    samples.note(
        "duplicated",
        Sentence::from(phrases::REPEATED_ROWS).with("count", count).with("blocks", blocks).with("line", line),
    );
}

/// Removes blocks that repeat the rows just before them under new time stamps (a buffer written twice).
///
/// A noise-free periodic record repeats itself too, so one of two further conditions must hold. The first is that the
/// motion jumps where the block begins. The second is that other rows one block length apart are similar but differ in
/// the last digit, so that the record is not noise-free.
fn new_time(samples: &mut Samples) {
    let channels = [Channel::Force, Channel::Displacement, Channel::Velocity];
    let mut removed: Vec<(usize, usize, usize)> = Vec::new();
    while let Some((start, length)) = find_block(samples, &channels) {
        let line = samples.lines[start];
        // The rows after the block were measured earlier than their time stamps state.
        let shift = samples.time[start] - samples.time[start - length];
        for time in &mut samples.time[start + length..] {
            *time -= shift;
        }
        samples.retain(|i| !(start..start + length).contains(&i));
        removed.push((line, length, samples.len()));
        if removed.len() >= 100 {
            break;
        }
    }
    if let Some(&(line, length, _)) = removed.first() {
        let rows: usize = removed.iter().map(|r| r.1).sum();
        samples.note(
            "duplicated",
            Sentence::from(phrases::REPEATED_BLOCKS)
                .with("blocks", removed.len())
                .with("rows", rows)
                .with("first", length)
                .with("line", line),
        );
    }
}

/// Finds the first block `start..start + length` that equals the `length` rows before it and is not due to a periodic
/// motion.
fn find_block(samples: &Samples, channels: &[Channel]) -> Option<(usize, usize)> {
    let n = samples.len();
    let mut last: HashMap<u64, usize> = HashMap::with_capacity(n);
    let mut i = 0;
    let mut looked_at = 0;
    while i < n {
        let Some(before) = last.insert(row_key(samples, i, channels), i) else {
            i += 1;
            continue;
        };
        let lag = i - before;
        // A block cannot begin inside a run of repeated rows, so only the first row of a run is checked. [`LOOKS`]
        // limits the number of checks.
        let inside = i > lag && equal(samples, i - 1, i - 1 - lag, channels);
        if lag >= BLOCK && !inside && looked_at < LOOKS {
            looked_at += 1;
            let run = (i..n).take_while(|&k| equal(samples, k, k - lag, channels)).count();
            let changing = samples.force[i - lag..i].windows(2).filter(|w| w[0] != w[1]).count() > lag / 4;
            if run >= lag && changing && (breaks_motion(samples, i, lag) || rest_is_noisy(samples, i, lag, run)) {
                return Some((i, lag));
            }
        }
        i += 1;
    }
    None
}

/// Returns whether the motion jumps between row `i - 1` and row `i`, in comparison with its steps in the block before.
fn breaks_motion(samples: &Samples, i: usize, lag: usize) -> bool {
    [Channel::Displacement, Channel::Velocity].iter().filter_map(|&c| samples.channel(c)).any(|values| {
        let block = &values[i - lag..i];
        let step = block.windows(2).map(|w| (w[1] - w[0]).abs()).fold(0.0, f64::max);
        let seam = (values[i] - values[i - 1]).abs();
        seam > 4.0 * step && step > 0.0
    })
}

/// Returns whether rows at a distance of `lag` rows, outside the repeated run, differ only by noise. A smooth
/// difference, such as the run-up of a noise-free record, does not count.
fn rest_is_noisy(samples: &Samples, i: usize, lag: usize, run: usize) -> bool {
    let force = &samples.force;
    let scale = 0.2 * range(force);
    let difference = |k: usize| force[k] - force[k - lag];
    let outside = (lag + 1..i).chain(i + run + 1..force.len());
    let (mut sizes, mut steps) = (Vec::new(), Vec::new());
    for k in outside {
        sizes.push(difference(k).abs());
        steps.push((difference(k) - difference(k - 1)).abs());
    }
    let (size, step) = (median(&mut sizes), median(&mut steps));
    sizes.len() >= lag && size > 0.0 && size < scale && step > 0.3 * size
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fixtures::SineTest;

    /// Repeats the rows `range` of a test. With `new_stamps`, the time of the second copy continues to increase.
    fn doubled(sound: &Samples, range: std::ops::Range<usize>, new_stamps: bool) -> Samples {
        let order: Vec<usize> = (0..range.end).chain(range.start..sound.len()).collect();
        let mut samples = sound.clone();
        samples.select(&order);
        if new_stamps {
            let step = sound.time[1] - sound.time[0];
            samples.time = (0..samples.len()).map(|i| i as f64 * step).collect();
        }
        samples
    }

    #[test]
    fn doubled_blocks_are_removed() {
        let sound = SineTest::default().samples();
        // The first range is part of a cycle. The second is a whole cycle, after which the motion does not jump.
        for range in [500..560, 600..800] {
            for new_stamps in [false, true] {
                let mut samples = doubled(&sound, range.clone(), new_stamps);
                remove(&mut samples);
                assert_eq!(samples.force, sound.force, "{range:?} {new_stamps}");
                assert!(samples.time.iter().zip(&sound.time).all(|(a, b)| (a - b).abs() < 1e-9));
                assert_eq!(samples.notes.len(), 1);
                assert_eq!(samples.notes[0].kind, "duplicated");
            }
        }
    }

    #[test]
    fn sound_and_noise_free_records_are_left_alone() {
        for noise in [0.0, 4.0] {
            let mut samples = SineTest { noise, ..SineTest::default() }.samples();
            // Round the values to the digits of a file, so that noise-free cycles are equal to the last digit.
            for values in [Channel::Force, Channel::Displacement, Channel::Velocity] {
                samples.channel_mut(values).unwrap().iter_mut().for_each(|v| *v = (*v * 1e6).round() / 1e6);
            }
            let before = samples.force.clone();
            remove(&mut samples);
            assert_eq!(samples.force, before);
            assert!(samples.notes.is_empty());
        }
    }

    #[test]
    fn a_short_block_is_no_repetition() {
        let sound = SineTest::default().samples();
        let removed = |length: usize| {
            let mut samples = doubled(&sound, 500..500 + length, true);
            remove(&mut samples);
            samples.len() == sound.len()
        };
        assert!(removed(14) && !removed(7));
    }
}
