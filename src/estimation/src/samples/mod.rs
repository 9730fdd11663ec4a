//! Samples of the tests for a fit or a diagnosis: as a rule the mean cycle of a test, and its accuracy under noise.
//!
//! Averaging over cycles at equal phase removes most of the noise and preserves the damper's force. A long test is
//! first cut into a few stretches, so that slow changes (heating, drift) stay visible from stretch to stretch.

mod allowed;
mod changing;
mod cycle;
mod lead_in;
mod noise;
pub mod road;
mod sampling;
pub mod selection;
mod whole;

pub use lead_in::as_long_as_remembered;
pub use sampling::input_at;
pub use whole::segments;

use crate::segment::Segment;
use dashpot_core::Input;
use dashpot_records::Record;
use dashpot_records::restrict;
use dashpot_records::smoothing::smooth;
use rayon::prelude::*;
use road::Extent;

/// Shortest duration of a test that is cut into stretches, s. A stretch has at least [`STRETCH_CYCLES`] cycles, and a
/// test has at most [`MOST_STRETCHES`] stretches.
const LONG: f64 = 20.0;
const STRETCH_CYCLES: usize = 3;
const MOST_STRETCHES: usize = 4;

/// One test, or one stretch of a long test.
#[derive(Debug, Clone)]
pub struct Test {
    /// Index of the test's record in the list of records.
    pub record: usize,
    /// Motion and mean measured force. [`Segment::scale`] is the typical allowed error.
    pub segment: Segment,
    /// Allowed error of every scored sample, N: noise of the mean, form of the FV curve, timing.
    pub allowed: Vec<f64>,
    /// Standard deviation of the noise of one sample of the mean cycle, N.
    pub mean_noise: f64,
    /// Fraction of independent samples among the scored samples, 1 for white noise.
    pub independence: f64,
    /// Significance of the relative growth of the force from cycle to cycle, in standard deviations.
    pub growth: f64,
    /// Number of independent deviations from which the noise was estimated.
    pub noise_freedom: f64,
    /// Frequency, Hz, or 0 if there are no cycles.
    pub frequency: f64,
    /// Number of tests that this test represents. A stretch of a road represents a fraction of several tests, see
    /// [`road`].
    pub weight: f64,
}

impl Test {
    /// Returns the number of scored samples.
    pub fn count(&self) -> usize {
        self.segment.force.len() - self.segment.from
    }

    /// Returns the number of independent samples among the scored samples.
    pub fn independent_count(&self) -> f64 {
        self.count() as f64 * self.independence
    }

    /// Computes the error of one sample of the mean, N, due to noise and to the form error of curves through a dozen
    /// points.
    pub fn unit(&self) -> f64 {
        allowed::typical(self.mean_noise.powi(2), self.segment.top)
    }

    /// Returns the scored inputs.
    pub fn inputs(&self) -> &[Input] {
        &self.segment.input[self.segment.from..]
    }

    /// Returns the scored forces.
    pub fn forces(&self) -> &[f64] {
        &self.segment.force[self.segment.from..]
    }
}

/// Makes the tests of all records, in their order.
pub fn tests(records: &[&Record]) -> Vec<Test> {
    let extent = Extent::in_campaign(records.len());
    let of_each: Vec<Vec<Test>> =
        records.par_iter().enumerate().map(|(place, r)| of_record(place, r, MOST_STRETCHES, extent)).collect();
    of_each.into_iter().flatten().collect()
}

/// Makes the tests to which tests without cycles of another campaign are compared: each such record whole, and every
/// stretch of it. The stretches that a fit chooses depend on the noise and on the number of records. So two campaigns
/// with the same road may choose different ones.
pub fn of_all_extents(records: &[&Record]) -> Vec<Test> {
    let of = |(place, record): (usize, &&Record)| {
        let motion = smooth(record);
        [Extent::Whole, Extent::Every].map(|extent| road::tests(place, record, &motion, extent)).concat()
    };
    let of_each: Vec<Vec<Test>> = records.par_iter().enumerate().filter(|(_, r)| is_road(r)).map(of).collect();
    of_each.into_iter().flatten().collect()
}

/// Returns whether a record has neither cycles nor a changing setting.
pub fn is_road(record: &Record) -> bool {
    record.setting_signal.is_none() && record.cycles.is_empty()
}

/// Makes the tests of a record. These are at most `most` stretches of its cycles, a road in the given extent, or one
/// test with a changing setting.
fn of_record(place: usize, record: &Record, most: usize, extent: Extent) -> Vec<Test> {
    let motion = smooth(record);
    let cycles = record.cycles.len();
    if let Some(signal) = &record.setting_signal {
        return vec![changing::test(place, record, &motion, signal)];
    }
    if cycles == 0 {
        return road::tests(place, record, &motion, extent);
    }
    let end = |k: usize| record.cycles[k].end.min(record.time.len() - 1);
    let duration = record.time[end(cycles - 1)] - record.time[record.cycles[0].start];
    let stretches = if duration >= LONG { restrict(cycles / STRETCH_CYCLES, 1, most) } else { 1 };
    (0..stretches)
        .map(|k| {
            let range = k * cycles / stretches..(k + 1) * cycles / stretches;
            cycle::mean_cycle(place, record, &motion, &record.cycles[range])
        })
        .collect()
}

/// Makes a segment of a record at the time `clock` of the campaign's clock, s. Scored samples begin at index `from`.
/// `noise` is the variance of a sample divided by the fraction of independent samples, N².
fn segment(
    record: &Record,
    clock: f64,
    dt: Vec<f64>,
    input: Vec<Input>,
    force: Vec<f64>,
    from: usize,
    noise: f64,
) -> Segment {
    let top = force.iter().fold(0.0f64, |m, f| m.max(f.abs()));
    Segment {
        name: record.name.clone(),
        dt,
        input,
        setting: None,
        force,
        from,
        scale: allowed::typical(noise, top),
        top,
        peak_velocity: record.peak_velocity,
        amplitude: record.amplitude,
        clock,
    }
}
