//! Computes the motion `delay` seconds before every force sample, for a delayed force channel.

use std::ops::Range;

/// Channel values `delay` seconds before each sample. Covers the samples for which the record contains that time.
pub(crate) struct DelayedMotion<'a> {
    time: &'a [f64],
    delay: f64,
    /// The samples for which the record contains the earlier time. All other samples have no motion.
    pub range: Range<usize>,
}

impl<'a> DelayedMotion<'a> {
    /// Prepares a shift of channels by `delay` seconds. `time` contains the times of the samples, s.
    pub fn new(time: &'a [f64], delay: f64) -> DelayedMotion<'a> {
        let (first, last) = (time.first().copied().unwrap_or(0.0), time.last().copied().unwrap_or(0.0));
        let from = time.partition_point(|t| t - delay < first);
        let to = time.partition_point(|t| t - delay <= last).max(from);
        DelayedMotion { time, delay, range: from..to }
    }

    /// Returns the shifted values of a smooth channel by interpolation. The force is never shifted, because
    /// interpolation would correlate its noise.
    pub fn values(&self, of: &[f64]) -> Vec<f64> {
        let mut at = 0;
        let value = |t: &f64| {
            let wanted = t - self.delay;
            while at + 2 < self.time.len() && self.time[at + 1] <= wanted {
                at += 1;
            }
            between(self.time, of, at, wanted)
        };
        self.time[self.range.clone()].iter().map(value).collect()
    }

    /// Returns the shifted values of a channel with jumps. Each is the value of the last sample before the shifted
    /// time, without interpolation.
    pub fn previous_values(&self, of: &[f64]) -> Vec<f64> {
        let value = |t: &f64| {
            // If the delay is a whole number of samples, its rounding error must not shift the channel by a further
            // sample.
            let after = self.time.partition_point(|time| *time <= t - self.delay + 1e-9);
            of[after.max(1) - 1]
        };
        self.time[self.range.clone()].iter().map(value).collect()
    }

    /// Returns the values of an unshifted channel, without the samples whose earlier motion was not recorded.
    pub fn kept(&self, of: &[f64]) -> Vec<f64> {
        of[self.range.clone()].to_vec()
    }
}

/// Interpolates `values` at the time `t` after the sample `at`, with the cubic through four samples. If possible, two
/// of these samples are before `t` and two after it.
fn between(time: &[f64], values: &[f64], at: usize, t: f64) -> f64 {
    let n = time.len();
    let from = at.saturating_sub(1).min(n.saturating_sub(4));
    let to = (from + 4).min(n);
    (from..to)
        .map(|i| {
            let weight: f64 = (from..to).filter(|&k| k != i).map(|k| (t - time[k]) / (time[i] - time[k])).product();
            weight * values[i]
        })
        .sum()
}
