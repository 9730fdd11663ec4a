//! Finds channels clipped at the end of their measuring range: flat tops at an extreme value.

use crate::data::samples::Samples;
use crate::error::{RecordError, SampleError};
use crate::messages::phrases;
use crate::numbers::quantum;
use crate::quantities::channel::Channel;
use crate::tuning::clipped::{FORCE_FRACTION, ROUNDED_FRACTION, RUN, SHOWN};
use dashpot_messages::{Sentence, format_decimals};

/// Range of displacement, m, and velocity, m/s, over all tests of a campaign. A real end of the measuring range limits
/// all tests.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Reach {
    displacement: (f64, f64),
    velocity: (f64, f64),
}

impl Default for Reach {
    fn default() -> Self {
        let none = (f64::INFINITY, f64::NEG_INFINITY);
        Reach { displacement: none, velocity: none }
    }
}

impl Reach {
    /// Extends the range by a test.
    pub fn with(mut self, samples: &Samples) -> Reach {
        for (channel, ends) in
            [(Channel::Displacement, &mut self.displacement), (Channel::Velocity, &mut self.velocity)]
        {
            // `min` and `max` ignore NaN, so NaN does not change the range.
            let values = samples.channel(channel).unwrap_or_default();
            *ends = values.iter().fold(*ends, |(low, high), v| (low.min(*v), high.max(*v)));
        }
        self
    }

    /// Returns whether the range of the tests extends beyond the flat top by more than its estimated overshoot.
    fn goes_beyond(&self, channel: Channel, top: &FlatTop) -> bool {
        let (low, high) = if channel == Channel::Velocity { self.velocity } else { self.displacement };
        if top.up { high > top.value + top.overshoot } else { low < top.value - top.overshoot }
    }
}

/// Clipped samples of a channel.
#[derive(Debug, Default)]
struct FlatTops {
    clipped: Vec<bool>,
    count: usize,
    first: usize,
    value: f64,
    runs: Vec<FlatTop>,
}

/// Consecutive equal samples at an extreme of a channel that is clipped there.
#[derive(Debug, Clone)]
struct FlatTop {
    samples: std::ops::Range<usize>,
    value: f64,
    /// Whether the flat top is at the maximum of the channel, otherwise at the minimum.
    up: bool,
    /// Estimated height of the clipped part, in the unit of the channel, from the slopes before and after the flat top.
    overshoot: f64,
}

impl FlatTops {
    /// Marks the samples of the flat tops `runs` as clipped, in a channel with `n` samples.
    fn of(n: usize, runs: Vec<FlatTop>) -> FlatTops {
        let mut tops = FlatTops { clipped: vec![false; n], first: n, ..FlatTops::default() };
        for run in &runs {
            tops.count += run.samples.len();
            if run.samples.start < tops.first {
                (tops.first, tops.value) = (run.samples.start, run.value);
            }
            tops.clipped[run.samples.clone()].fill(true);
        }
        FlatTops { runs, ..tops }
    }

    /// Removes the flat tops for which `is_none` is true.
    fn leave_out(&mut self, is_none: impl Fn(&FlatTop) -> bool) {
        let runs = std::mem::take(&mut self.runs).into_iter().filter(|run| !is_none(run)).collect();
        *self = FlatTops::of(self.clipped.len(), runs);
    }
}

/// Returns whether the other motion channel confirms that the motion really has the flat top. A constant velocity
/// between turning points, or a standstill between two ramps, is not clipping.
fn moved_so(channel: Channel, time: &[f64], other: &[f64], top: &FlatTop) -> bool {
    let (first, last) = (top.samples.start, top.samples.end - 1);
    let seconds = time[last] - time[first];
    let beyond = match channel {
        Channel::Velocity => (other[last] - other[first]) / seconds - top.value,
        // Largest distance, m, from the position at the start of the flat top.
        _ => {
            let mut at = 0.0;
            (first + 1..=last).fold(0.0f64, |most, k| {
                at += 0.5 * (other[k] + other[k - 1]) * (time[k] - time[k - 1]);
                most.max(at.abs())
            })
        }
    };
    seconds > 0.0 && beyond.abs() < SHOWN * top.overshoot
}

/// Handles clipped channels. Returns for each sample whether its force is clipped and thus unusable.
///
/// The motion is valid at clipped force samples, so the caller drops these samples only after completing the motion. A
/// clipped motion channel is dropped if the other motion channel can replace it. A few equal samples count as a rounded
/// peak, not as clipped, if other tests exceed them. `reach` is the range of the motion over all tests of the campaign.
///
/// # Errors
/// [`SampleError::Clipped`] if too many force samples are clipped, or if the only motion channel is clipped.
pub(crate) fn deal(samples: &mut Samples, reach: &Reach) -> Result<Vec<bool>, RecordError> {
    for (channel, other) in [(Channel::Velocity, Channel::Displacement), (Channel::Displacement, Channel::Velocity)] {
        let Some(mut tops) = samples.channel(channel).and_then(flat_tops) else {
            continue;
        };
        let moved = samples.channel(other);
        if let Some(moved) = moved {
            tops.leave_out(|top| moved_so(channel, &samples.time, moved, top));
            if tops.count == 0 {
                continue;
            }
        }
        let (count, line) = (tops.count, samples.lines[tops.first]);
        if count as f64 <= ROUNDED_FRACTION * samples.len() as f64 {
            let value = tops.value;
            tops.leave_out(|top| reach.goes_beyond(channel, top));
            if tops.count == 0 {
                samples.note(
                    "rounded",
                    Sentence::from(phrases::ROUNDED)
                        .with_sentence("channel", channel.message())
                        .with("value", format_decimals(value, 5))
                        .with("unit", channel.si())
                        .with("count", count)
                        .with("line", line),
                );
                continue;
            }
        }
        let percent = 100.0 * tops.count as f64 / samples.len() as f64;
        let value = tops.value;
        if samples.channel(other).is_none() {
            return Err(SampleError::Clipped {
                at: samples.at.clone(),
                line: samples.lines[tops.first],
                channel,
                value,
                percent,
                advice: phrases::NO_OTHER_MOTION,
            }
            .into());
        }
        let line = samples.lines[tops.first];
        match channel {
            Channel::Velocity => samples.velocity = None,
            _ => samples.displacement = None,
        }
        samples.note(
            "clipped",
            Sentence::from(phrases::CLIPPED_MOTION)
                .with_sentence("channel", channel.message())
                .with("value", format_decimals(value, 5))
                .with("unit", channel.si())
                .with("percent", format_decimals(percent, 1))
                .with("line", line)
                .with_sentence("other", other.message()),
        );
    }
    let Some(tops) = flat_tops(&samples.force) else {
        return Ok(vec![false; samples.len()]);
    };
    let percent = 100.0 * tops.count as f64 / samples.len() as f64;
    let (line, value) = (samples.lines[tops.first], tops.value);
    if tops.count as f64 > FORCE_FRACTION * samples.len() as f64 {
        return Err(SampleError::Clipped {
            at: samples.at.clone(),
            line,
            channel: Channel::Force,
            value,
            percent,
            advice: phrases::LARGER_RANGE,
        }
        .into());
    }
    samples.note(
        "clipped",
        Sentence::from(phrases::CLIPPED_FORCE)
            .with("value", format_decimals(value, 1))
            .with("count", tops.count)
            .with("percent", format_decimals(percent, 2))
            .with("line", line),
    );
    Ok(tops.clipped)
}

/// Finds flat tops at the largest and the smallest value.
///
/// The top of a coarse sine is flat too. A signal is clipped if its slope at the edge of the flat top shows that it
/// would have risen further. With the slope s per sample at both edges of a top of m samples, a parabola rises by s·m/4
/// above the edges.
fn flat_tops(values: &[f64]) -> Option<FlatTops> {
    let n = values.len();
    let quantum = quantum(values);
    let mut tops = Vec::new();
    let (low, high) = values.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), &v| (l.min(v), h.max(v)));
    if low == high {
        return None;
    }
    for (extreme, up) in [(high, 1.0), (low, -1.0)] {
        let mut start = 0;
        for run in values.chunk_by(|a, b| a == b) {
            let end = start + run.len();
            // Compute the slope over half the length of the top. Next to a rounded top, a step of the last digit would
            // distort the slope over a shorter span.
            let reach = (run.len() / 2).max(3);
            if run[0] == extreme && run.len() >= RUN && start >= reach && end + reach <= n {
                let rise = up * (values[start] - values[start - reach]) / reach as f64;
                let fall = up * (values[end - 1] - values[end - 1 + reach]) / reach as f64;
                let overshoot = rise.min(fall) * run.len() as f64 / 4.0;
                if overshoot > 3.0 * quantum && overshoot > 1e-3 * (high - low) {
                    tops.push(FlatTop { samples: start..end, value: extreme, up: up > 0.0, overshoot });
                }
            }
            start = end;
        }
    }
    (!tops.is_empty()).then(|| FlatTops::of(n, tops))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fixtures::SineTest;

    #[test]
    fn a_little_clipped_force_is_masked_and_much_is_refused() {
        let sound = SineTest { noise: 1.0, ..SineTest::default() }.samples();
        let clip = |limit: f64| {
            let mut samples = sound.clone();
            samples.force.iter_mut().for_each(|f| *f = f.min(limit));
            samples
        };
        let top = sound.force.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let mut samples = clip(0.98 * top);
        let expected: Vec<bool> = samples.force.iter().map(|f| *f == 0.98 * top).collect();
        let masked = deal(&mut samples, &Reach::default()).unwrap();
        // Single noisy samples at the limit are not a flat top. All long runs are flat tops.
        let missed = masked.iter().zip(&expected).filter(|(m, e)| !**m && **e).count();
        let hits = masked.iter().filter(|m| **m).count();
        assert!(hits > 2 * missed && masked.iter().zip(&expected).all(|(m, e)| !*m || *e), "{hits} {missed}");
        assert_eq!(samples.notes[0].kind, "clipped");
        let error = deal(&mut clip(0.7 * top), &Reach::default()).unwrap_err().to_string();
        assert!(error.contains("force is clipped") && error.contains("load cell"), "{error}");
    }

    #[test]
    fn a_clipped_motion_channel_gives_way_to_the_other() {
        let mut samples = SineTest::default().samples();
        samples.velocity.as_mut().unwrap().iter_mut().for_each(|v| *v = v.clamp(-0.2, 0.2));
        deal(&mut samples, &Reach::default()).unwrap();
        assert!(samples.velocity.is_none() && samples.displacement.is_some());
        let mut samples = SineTest::default().samples();
        samples.velocity = None;
        samples.displacement.as_mut().unwrap().iter_mut().for_each(|x| *x = x.min(0.04));
        assert!(deal(&mut samples, &Reach::default()).unwrap_err().to_string().contains("no other motion channel"));
    }

    #[test]
    fn a_rounded_peak_is_none_where_other_tests_go_further() {
        let larger = SineTest { amplitude: 0.08, ..SineTest::default() }.samples();
        let reach = Reach::default().with(&larger);
        let clip = |share: f64| {
            let mut samples = SineTest::default().samples();
            samples.velocity = None;
            let x = samples.displacement.as_mut().unwrap();
            let top = x.iter().copied().fold(f64::NEG_INFINITY, f64::max);
            x.iter_mut().for_each(|x| *x = x.min(share * top));
            samples
        };
        let mut samples = clip(0.998);
        let own = Reach::default().with(&samples);
        assert!(deal(&mut samples, &own).is_err());
        deal(&mut samples, &reach).unwrap();
        assert!(samples.notes[0].kind == "rounded", "{:?}", samples.notes);
        // Many equal samples indicate the end of a measuring range, which may differ from the range of the other tests.
        assert!(deal(&mut clip(0.8), &reach).is_err());
    }

    #[test]
    fn coarse_tops_of_a_sine_are_not_clipped() {
        for quantum in [0.0, 5e-6, 2e-4, 2e-3] {
            let mut samples = SineTest { noise: 0.0, per_cycle: 2000, ..SineTest::default() }.samples();
            if quantum > 0.0 {
                samples.displacement.as_mut().unwrap().iter_mut().for_each(|x| *x = (*x / quantum).round() * quantum);
                samples.force.iter_mut().for_each(|f| *f = (*f / quantum / 1e4).round() * quantum * 1e4);
            }
            assert!(!deal(&mut samples, &Reach::default()).unwrap().contains(&true), "{quantum}");
            assert!(samples.notes.is_empty());
        }
    }

    /// Checks that the plateaus of a velocity stay if the displacement confirms them. If the displacement goes further,
    /// the plateaus count as clipped. The velocity is recorded without noise.
    #[test]
    fn a_plateau_that_the_displacement_confirms_is_no_clipping() {
        let (rate, frequency, speed) = (1000.0, 5.0, 0.05);
        let mut samples = SineTest::default().samples();
        let n = samples.len();
        // The motion turns within about sixteen samples. Over two samples, the slope would not differ from a step of
        // the last digit.
        let of = |t: f64| speed * (4.0 * libm::sin(std::f64::consts::TAU * frequency * t)).clamp(-1.0, 1.0);
        samples.time = (0..n).map(|i| i as f64 / rate).collect();
        let velocity: Vec<f64> = samples.time.iter().map(|t| of(*t)).collect();
        let moved = |v: &[f64]| v.iter().scan(0.0, |x, v| (*x += v / rate, Some(*x)).1).collect::<Vec<f64>>();
        samples.displacement = Some(moved(&velocity));
        samples.velocity = Some(velocity.clone());
        samples.force = velocity.iter().map(|v| 1500.0 * v + libm::sin(v * 7e3)).collect();
        deal(&mut samples, &Reach::default()).unwrap();
        assert!(samples.velocity.is_some(), "{:?}", samples.notes);
        // The velocity channel is unchanged, but the displacement is that of a faster motion than the plateaus show.
        let went_on = |t: f64| 4.0 * speed * libm::sin(std::f64::consts::TAU * frequency * t);
        let real: Vec<f64> = samples.time.iter().map(|t| went_on(*t)).collect();
        samples.displacement = Some(moved(&real));
        samples.velocity = Some(real.iter().map(|v| v.clamp(-speed, speed)).collect());
        deal(&mut samples, &Reach::default()).unwrap();
        assert!(samples.velocity.is_none(), "{:?}", samples.notes);
    }
}
