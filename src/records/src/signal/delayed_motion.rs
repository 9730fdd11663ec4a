//! The motion of a moment ago at every sample of the force, for a force channel that comes late.

use std::ops::Range;

/// Values `delay` seconds before each sample that has such a moment in its record.
pub(crate) struct DelayedMotion<'a> {
    time: &'a [f64],
    delay: f64,
    /// The samples that have it; the rest has no partner.
    pub range: Range<usize>,
}

impl<'a> DelayedMotion<'a> {
    /// For samples at these times.
    pub fn new(time: &'a [f64], delay: f64) -> DelayedMotion<'a> {
        let (first, last) = (time.first().copied().unwrap_or(0.0), time.last().copied().unwrap_or(0.0));
        let from = time.partition_point(|t| t - delay < first);
        let to = time.partition_point(|t| t - delay <= last).max(from);
        DelayedMotion { time, delay, range: from..to }
    }

    /// A channel of the motion there. It is interpolated, since motion is smooth; the force, whose noise interpolation would colour,
    /// is never moved.
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

    /// A channel that jumps there: its value at the sample before.
    pub fn previous_values(&self, of: &[f64]) -> Vec<f64> {
        let value = |t: &f64| {
            // Rounding of a delay of whole samples must not move the channel by one.
            let after = self.time.partition_point(|time| *time <= t - self.delay + 1e-9);
            of[after.max(1) - 1]
        };
        self.time[self.range.clone()].iter().map(value).collect()
    }

    /// A channel that stays where it is, without the samples that have no partner.
    pub fn kept(&self, of: &[f64]) -> Vec<f64> {
        of[self.range.clone()].to_vec()
    }
}

/// The value at a time after sample `at`: of the cubic through four samples, where there are as many on both sides.
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
