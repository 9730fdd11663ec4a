//! A test without cycles: a road signal.

use super::noise::independence;
use super::{Test, allowed, segment};
use crate::motion::Motion;
use crate::records::Record;
use dashpot_core::Input;

/// Most samples of it.
const PER_ROAD: usize = 1000;

pub fn road(place: usize, record: &Record, motion: &Motion) -> Test {
    let n = record.time.len();
    let stride = n.div_ceil(PER_ROAD).max(1);
    let picks: Vec<usize> = (0..n).step_by(stride).collect();
    let lead = (picks.len() / 20).max(1);
    let dt = std::iter::once(0.0).chain(picks.windows(2).map(|w| record.time[w[1]] - record.time[w[0]])).collect();
    let (input, force) = picks
        .iter()
        .map(|i| {
            let input = Input {
                displacement: Some(motion.displacement[*i]),
                velocity: motion.velocity[*i],
                side_force: record.side_force.as_ref().map_or(0.0, |c| c[*i]),
                temperature: record.temperature.as_ref().map_or(20.0, |c| c[*i]),
            };
            (input, record.force[*i])
        })
        .unzip();
    let lag1 = record.noise.lag1.clamp(0.0, 0.99);
    let mean_noise = record.noise.force_rms;
    let thinned = independence(lag1.powi(stride as i32));
    let noise = mean_noise.powi(2) / thinned;
    let segment = segment(record, dt, input, force, lead, noise);
    Test {
        record: place,
        allowed: allowed::on_a_road(&segment, noise, mean_noise),
        segment,
        mean_noise,
        independence: thinned,
        growth: 0.0,
        noise_freedom: n as f64 * independence(lag1),
        frequency: 0.0,
        clock: 0.5 * (record.time[0] + record.time[n - 1]),
    }
}
