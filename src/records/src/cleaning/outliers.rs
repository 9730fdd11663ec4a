//! Replaces spikes: one to three samples far from both neighbors, or from the neighbor at an end of the record. No
//! mechanical motion produces them.

use crate::data::samples::Samples;
use crate::messages::phrases;
use crate::quantities::channel::Channel;
use crate::signal::noise::difference_noise;
use crate::tuning::outliers::{FRACTION, LONGEST};
use dashpot_messages::{Sentence, format_decimals};

/// Replaces spikes in force and motion by straight lines. A channel with too many spikes stays unchanged.
///
/// Returns a sentence for each channel with spikes. The caller adds it as a note if the channel is used.
#[must_use]
pub(crate) fn replace(samples: &mut Samples) -> Vec<(Channel, Sentence)> {
    let mut found = Vec::new();
    for channel in [Channel::Force, Channel::Displacement, Channel::Velocity] {
        let Some(values) = samples.channel_mut(channel) else {
            continue;
        };
        let spikes = find(values);
        let count: usize = spikes.iter().map(|s| s.1).sum();
        if count == 0 {
            continue;
        }
        if count as f64 > (FRACTION * values.len() as f64).max(3.0) {
            let percent = 100.0 * count as f64 / values.len() as f64;
            let text = Sentence::from(phrases::SPIKY).with_sentence("channel", channel.message());
            found.push((channel, text.with("percent", format_decimals(percent, 1))));
            continue;
        }
        let mut largest = 0.0_f64;
        for &(start, length) in &spikes {
            // At an end of the record, the line is constant.
            let before = start.checked_sub(1).and_then(|k| values.get(k));
            let after = values.get(start + length);
            let Some((from, to)) = before.or(after).copied().zip(after.or(before).copied()) else { continue };
            for k in 0..length {
                let line = from + (to - from) * (k + 1) as f64 / (length + 1) as f64;
                largest = largest.max((values[start + k] - line).abs());
                values[start + k] = line;
            }
        }
        let line = samples.lines[spikes[0].0];
        // The message is in the unit of the file, because the user searches the spike there.
        let own = samples.units.iter().find(|(of, _)| *of == channel).map(|(_, unit)| *unit);
        let (factor, unit) = own.map_or((1.0, channel.si()), |unit| (unit.to_si(1.0), unit.name()));
        let text = Sentence::from(phrases::SPIKES)
            .with("count", count)
            .with_sentence("channel", channel.message())
            .with("spikes", spikes.len())
            .with("line", line)
            .with("largest", format_decimals(largest / factor, 4))
            .with("unit", unit);
        found.push((channel, text));
    }
    found
}

/// Smallest number of steps between the samples after a spike at the start of a record. With fewer steps, their largest
/// is unreliable, so no spike is sought there.
const FEWEST_STEPS: usize = 20;

/// Returns start and length of every spike.
///
/// A spike leaves the band between its neighbors and returns. After a reversal of friction, the force does not return.
/// At the knee of a blow-off, only the slope of the force changes. A break-away peak leaves the band by less than its
/// friction step.
fn find(values: &[f64]) -> Vec<(usize, usize)> {
    let n = values.len();
    let sigma = difference_noise(values);
    let steps: Vec<f64> = values.windows(2).map(|w| (w[1] - w[0]).abs()).collect();
    let mut spikes: Vec<(usize, usize)> = Vec::new();
    let mut i = 1;
    while i + 1 < n {
        let mut length_found = None;
        // Only a step well above the noise can begin a spike.
        if steps[i - 1] > 8.0 * sigma {
            for length in 1..=LONGEST.min(n - 1 - i) {
                if is_spike(values, &steps, sigma, i, length) {
                    length_found = Some(length);
                    break;
                }
            }
        }
        if let Some(length) = length_found {
            spikes.push((i, length));
            i += length + 1;
        } else {
            i += 1;
        }
    }
    let first = at_start(&steps, sigma);
    let last = at_start(&steps.iter().rev().copied().collect::<Vec<_>>(), sigma);
    if let Some(length) = first.filter(|length| spikes.first().is_none_or(|spike| spike.0 > *length)) {
        spikes.insert(0, (0, length));
    }
    if let Some(length) = last.filter(|length| spikes.last().is_none_or(|spike| spike.0 + spike.1 < n - length)) {
        spikes.push((n - length, length));
    }
    spikes
}

/// Returns the length, in samples, of a spike at the start of a record. `steps` are the absolute differences between
/// adjacent samples, and `sigma` is the standard deviation of the noise.
///
/// The step from the spike to the record must be by far the largest. A reversal of friction at the start is not a
/// spike, because the next reversal causes an equally large step. Within a spike, the steps are smaller.
fn at_start(steps: &[f64], sigma: f64) -> Option<usize> {
    /// Smallest ratio of the step from the spike to the largest step of the record.
    const LARGER: f64 = 1.5;
    (1..=LONGEST.min(steps.len().saturating_sub(FEWEST_STEPS))).find(|length| {
        let step = steps[length - 1];
        let largest = steps[*length..].iter().fold(0.0_f64, |most, step| most.max(*step));
        let nearby = steps[*length..].iter().take(8).fold(0.0_f64, |most, step| most.max(*step));
        let within = steps[..length - 1].iter().sum::<f64>();
        step > 8.0 * sigma && step > LARGER * largest && step > 3.0 * nearby && step > 2.0 * within
    })
}

fn is_spike(values: &[f64], steps: &[f64], sigma: f64, start: usize, length: usize) -> bool {
    let n = values.len();
    let (left, right) = (values[start - 1], values[start + length]);
    let before = &values[start.saturating_sub(2)..start];
    let after = &values[start + length..(start + length + 2).min(n)];
    let band = before.iter().chain(after).fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), &v| (l.min(v), h.max(v)));
    let inside = &values[start..start + length];
    let above = inside.iter().map(|v| v - band.1).fold(f64::INFINITY, f64::min);
    let below = inside.iter().map(|v| band.0 - v).fold(f64::INFINITY, f64::min);
    let off = above.max(below);
    // Largest step near the spike, excluding the steps of the spike itself.
    let nearby = steps[start.saturating_sub(8)..start - 1]
        .iter()
        .chain(steps.get(start + length..(start + length + 7).min(steps.len())).unwrap_or_default())
        .fold(0.0_f64, |most, &s| most.max(s));
    off > 8.0 * sigma && off > 3.0 * nearby && off > 1.2 * (right - left).abs() && off > 0.0
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fixtures::{Random, SineTest};

    #[test]
    fn spikes_are_replaced_and_nothing_else() {
        let sound = SineTest::default().samples();
        let mut samples = sound.clone();
        for (at, length, height) in [(300, 1, 900.0), (555, 2, -700.0), (801, 3, 1500.0)] {
            samples.force[at..at + length].iter_mut().for_each(|f| *f += height);
        }
        samples.displacement.as_mut().unwrap()[640] = 0.0;
        let found = replace(&mut samples);
        assert_eq!(
            found.iter().map(|(channel, _)| *channel).collect::<Vec<_>>(),
            [Channel::Force, Channel::Displacement]
        );
        let changed: Vec<usize> = (0..sound.len()).filter(|&i| samples.force[i] != sound.force[i]).collect();
        assert_eq!(changed, [300, 555, 556, 801, 802, 803]);
        for i in changed {
            assert!((samples.force[i] - sound.force[i]).abs() < 60.0, "{i}");
        }
        let (a, b) = (samples.displacement.unwrap()[640], sound.displacement.unwrap()[640]);
        assert!((a - b).abs() < 2e-4, "{a} {b}");
    }

    #[test]
    fn wrong_samples_at_an_end_are_replaced_and_a_reversal_at_the_start_is_not() {
        let sound = SineTest::default().samples();
        let n = sound.len();
        for (at, height) in [(0..1, 900.0), (0..2, -900.0), (n - 1..n, 900.0), (n - 3..n, -2000.0)] {
            let mut samples = sound.clone();
            samples.force[at.clone()].iter_mut().for_each(|f| *f += height);
            let found = replace(&mut samples);
            assert_eq!(found.len(), 1, "{found:?}");
            let off = |k: usize| (samples.force[k] - sound.force[k]).abs();
            assert!((0..n).all(|k| if at.contains(&k) { off(k) < 60.0 } else { off(k) == 0.0 }), "{at:?}");
        }
        // Friction that reverses after the first sample, and again every 50 samples, is not a spike.
        let force: Vec<f64> = (0..200).map(|k| if k == 0 || (k / 50) % 2 == 1 { -40.0 } else { 40.0 }).collect();
        assert!(find(&force).is_empty());
    }

    /// Checks that effects of a damper do not count as spikes. The effects are friction that reverses within a sample,
    /// break-away peaks of one and a half times the friction, and a blow-off knee. The test covers several sampling
    /// rates, with and without noise.
    #[test]
    fn reversals_break_away_and_knees_stay() {
        for per_cycle in [20, 47, 200, 1000] {
            for noise in [0.0, 1.0, 10.0] {
                let mut random = Random::new(5);
                let mut since_reversal = 0;
                let mut last = 1.0;
                let force: Vec<f64> = (0..6 * per_cycle)
                    .map(|i| {
                        let v = libm::cos(std::f64::consts::TAU * (f64::from(i) + 0.3) / f64::from(per_cycle));
                        since_reversal = if v.signum() == last { since_reversal + 1 } else { 0 };
                        last = v.signum();
                        let friction = if since_reversal == 0 { 75.0 } else { 50.0 };
                        let valve =
                            if v.abs() < 0.5 { 800.0 * v } else { v.signum() * (400.0 + 60.0 * (v.abs() - 0.5)) };
                        friction * v.signum() + valve + noise * random.normal()
                    })
                    .collect();
                assert_eq!(find(&force), [], "{per_cycle} per cycle, noise {noise}");
            }
        }
    }

    #[test]
    fn a_channel_full_of_spikes_is_left_alone_but_told() {
        let mut samples = SineTest::default().samples();
        for i in (30..samples.len() - 30).step_by(40) {
            samples.force[i] += 800.0;
        }
        let before = samples.force.clone();
        let found = replace(&mut samples);
        assert_eq!(samples.force, before);
        assert!(found[0].1.to_string().contains("left as they are"));
    }
}
