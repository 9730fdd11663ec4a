//! A test without cycles, which consists of selected samples of its record.

use super::noise::independence;
use super::{Test, allowed, segment};
use dashpot_core::Input;
use dashpot_records::Record;
use dashpot_records::smoothing::Motion;

/// Returns the input of the damper at a sample of a record. Unmeasured temperature and side force are 20 °C and zero.
pub fn input_at(record: &Record, motion: &Motion, sample: usize) -> Input {
    Input {
        displacement: Some(motion.displacement[sample]),
        velocity: motion.velocity[sample],
        side_force: record.side_force.as_ref().map_or(0.0, |c| c[sample]),
        temperature: record.temperature.as_ref().map_or(20.0, |c| c[sample]),
    }
}

/// Samples of a record that become steps of the model.
pub struct Sampling<'a> {
    /// Sample indices of the record.
    pub picks: &'a [usize],
    /// Number of steps of the lead-in.
    pub lead: usize,
    /// Number of samples of the record from one scored step to the next.
    pub apart: usize,
    /// Middle of the test on the campaign's clock, s.
    pub clock: f64,
    /// Number of tests that the selected samples represent.
    pub weight: f64,
}

impl Sampling<'_> {
    /// Makes the test. `setting` is the command of each step if it changes; `is_scored` is called for each step after
    /// the lead-in.
    pub fn test(
        &self,
        place: usize,
        record: &Record,
        motion: &Motion,
        setting: Option<Vec<f64>>,
        is_scored: impl Fn(usize) -> bool,
    ) -> Test {
        let Sampling { picks, lead, apart, clock, weight } = *self;
        let dt = std::iter::once(0.0).chain(picks.windows(2).map(|w| record.time[w[1]] - record.time[w[0]])).collect();
        let (input, force) = picks.iter().map(|i| (input_at(record, motion, *i), record.force[*i])).unzip();
        let lag1 = record.noise.lag1.clamp(0.0, 0.99);
        let mean_noise = record.noise.force_rms;
        let thinned = independence(lag1.powi(apart as i32));
        let noise = mean_noise.powi(2) / thinned;
        let mut segment = segment(record, clock, dt, input, force, lead, noise);
        segment.setting = setting;
        let mut allowed = allowed::on_a_road(&segment, noise, mean_noise);
        // The model simulates all steps; steps between the scored ones have no weight.
        for (k, allowed) in allowed.iter_mut().enumerate() {
            if !is_scored(k) {
                *allowed = f64::INFINITY;
            }
        }
        let fraction = allowed.iter().filter(|a| a.is_finite()).count() as f64 / allowed.len().max(1) as f64;
        Test {
            record: place,
            allowed,
            segment,
            mean_noise,
            independence: thinned * fraction,
            growth: 0.0,
            noise_freedom: record.time.len() as f64 * independence(lag1),
            frequency: 0.0,
            weight,
        }
    }
}
