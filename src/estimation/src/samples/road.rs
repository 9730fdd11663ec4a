//! A test without cycles: a road signal.

use super::noise::independence;
use super::{Test, allowed, segment};
use dashpot_core::Input;
use dashpot_records::Record;
use dashpot_records::smoothing::Motion;

/// Smallest number of scored samples of a road, and largest step of the model, s.
///
/// Between two scored samples the internal state advances. A record of more samples than `MOST` has longer steps.
const SCORED: usize = 1000;
const STEP: f64 = 2e-3;
const MOST: usize = 40_000;

/// Samples of a record that become one step of the model.
fn stride(record: &Record) -> usize {
    let n = record.time.len();
    let step = (record.time[n - 1] - record.time[0]) / (n - 1).max(1) as f64;
    ((STEP / step.max(1e-9)) as usize).max(n.div_ceil(MOST)).max(1)
}

/// The one test of a record without cycles.
pub fn road(place: usize, record: &Record, motion: &Motion) -> Test {
    let n = record.time.len();
    let stride = stride(record);
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
    let every = (picks.len() / SCORED).max(1);
    let thinned = independence(lag1.powi((stride * every) as i32));
    let noise = mean_noise.powi(2) / thinned;
    let clock = record.clock_s + 0.5 * (record.time[0] + record.time[n - 1]);
    let segment = segment(record, clock, dt, input, force, lead, noise);
    let mut allowed = allowed::on_a_road(&segment, noise, mean_noise);
    // The model goes through all of it; samples between the scored ones count nothing.
    for (k, allowed) in allowed.iter_mut().enumerate() {
        if k % every != 0 {
            *allowed = f64::INFINITY;
        }
    }
    let share = allowed.iter().filter(|a| a.is_finite()).count() as f64 / allowed.len().max(1) as f64;
    Test {
        record: place,
        allowed,
        segment,
        mean_noise,
        independence: thinned * share,
        growth: 0.0,
        noise_freedom: n as f64 * independence(lag1),
        frequency: 0.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sensitivity::forces;
    use dashpot_core::{Model, Params};
    use dashpot_records::smoothing::smooth;

    /// A record of the kernel itself, sampled at 1 kHz for half a minute: at coarser steps the model would miss its own forces.
    #[test]
    fn a_long_road_is_gone_through_at_its_own_rate() {
        let model = Model::new(&Params::new()).unwrap();
        let n = 30_000;
        let time: Vec<f64> = (0..n).map(|k| 1e-3 * k as f64).collect();
        let parts = [(0.02, 1.3, 0.1), (0.004, 6.1, 1.0), (0.0015, 13.7, 2.0)];
        let sum = |t: f64, of: fn(f64, f64, f64) -> f64| -> f64 {
            parts
                .iter()
                .map(|(a, f, phase)| of(*a, std::f64::consts::TAU * f, std::f64::consts::TAU * f * t + phase))
                .sum()
        };
        let displacement: Vec<f64> = time.iter().map(|t| sum(*t, |a, _, angle| a * libm::sin(angle))).collect();
        let velocity: Vec<f64> = time.iter().map(|t| sum(*t, |a, w, angle| a * w * libm::cos(angle))).collect();
        let mut record = Record {
            time,
            displacement,
            velocity,
            force: vec![0.0; n],
            amplitude: 0.02,
            peak_velocity: 0.4,
            ..Record::default()
        };
        let whole: Vec<Input> =
            record.displacement.iter().zip(&record.velocity).map(|(x, v)| Input::motion(*x, *v)).collect();
        let all = crate::segment::Segment {
            name: String::new(),
            dt: (0..n).map(|k| if k == 0 { 0.0 } else { 1e-3 }).collect(),
            input: whole,
            force: vec![0.0; n],
            from: 0,
            scale: 1.0,
            top: 1.0,
            peak_velocity: 0.4,
            amplitude: 0.02,
            clock: 0.0,
        };
        record.force = forces(&model, &all);
        let test = road(0, &record, &smooth(&record));
        let computed = forces(&model, &test.segment);
        let top = record.force.iter().fold(0.0f64, |m, f| m.max(f.abs()));
        let (mut sum, mut count) = (0.0, 0.0);
        for (k, _) in test.allowed.iter().enumerate().filter(|(_, a)| a.is_finite()) {
            let at = test.segment.from + k;
            sum += (computed[at] - test.segment.force[at]).powi(2);
            count += 1.0;
        }
        assert!(
            count > 0.9 * SCORED as f64 && f64::sqrt(sum / count) < 0.002 * top,
            "{} of {top}",
            f64::sqrt(sum / count)
        );
    }
}
