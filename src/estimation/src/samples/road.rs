//! A test without cycles: a road signal, or one whose setting changes.

use super::noise::independence;
use super::{Test, allowed, segment};
use dashpot_core::Input;
use dashpot_records::smoothing::Motion;
use dashpot_records::{Record, SettingSignal};

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

/// Largest step of the model while the valve answers a command, s: a fraction of its response.
const ANSWER_STEP: f64 = 5e-4;
/// Time for which a valve may answer a change of its command, s.
const ANSWER: f64 = 0.3;
/// One of so many samples counts where the valve has answered.
const STILL_SCORED: usize = 5;

/// Samples that become steps of the model where the setting changes, and whether the valve answers a command there.
fn picks_of_signal(record: &Record, signal: &SettingSignal) -> Vec<(usize, bool)> {
    let n = record.time.len();
    let step = ((record.time[n - 1] - record.time[0]) / (n - 1).max(1) as f64).max(1e-9);
    let crowd = n.div_ceil(MOST);
    let fine = ((ANSWER_STEP / step) as usize).max(crowd).max(1);
    let coarse = stride(record);
    let mut picks = vec![(0, false)];
    let mut answers_until = f64::NEG_INFINITY;
    let mut at = 0;
    while at + 1 < n {
        let near = at + fine.min(n - 1 - at);
        if signal.swing(at..(at + coarse + 1).min(n)) > 0.0 {
            answers_until = record.time[at] + ANSWER;
        }
        let answers = record.time[near] <= answers_until;
        at = if answers { near } else { at + coarse.min(n - 1 - at) };
        picks.push((at, answers));
    }
    picks
}

/// Command of each step between picked samples: the mean over those that it passes.
fn commands(signal: &SettingSignal, picks: &[usize]) -> Vec<f64> {
    let first = picks.first().map(|first| signal.command(*first));
    let mean = |pair: &[usize]| {
        let passed = pair[0] + 1..=pair[1];
        let count = passed.clone().count().max(1) as f64;
        passed.map(|sample| signal.command(sample)).sum::<f64>() / count
    };
    first.into_iter().chain(picks.windows(2).map(mean)).collect()
}

/// The one test of a record without cycles.
pub fn road(place: usize, record: &Record, motion: &Motion) -> Test {
    let n = record.time.len();
    let stride = stride(record);
    let of_signal = record.setting_signal.as_ref().map(|signal| picks_of_signal(record, signal));
    let picks: Vec<usize> = match &of_signal {
        Some(picks) => picks.iter().map(|(sample, _)| *sample).collect(),
        None => (0..n).step_by(stride).collect(),
    };
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
    let every = if of_signal.is_some() { STILL_SCORED } else { (picks.len() / SCORED).max(1) };
    let thinned = independence(lag1.powi((stride * every) as i32));
    let noise = mean_noise.powi(2) / thinned;
    let clock = record.clock_s + 0.5 * (record.time[0] + record.time[n - 1]);
    let mut segment = segment(record, clock, dt, input, force, lead, noise);
    segment.setting = record.setting_signal.as_ref().map(|signal| commands(signal, &picks));
    let mut allowed = allowed::on_a_road(&segment, noise, mean_noise);
    // The model goes through all of it; samples between the scored ones count nothing.
    let answers =
        |k: usize| of_signal.as_ref().and_then(|picks| picks.get(lead + k)).is_some_and(|(_, answers)| *answers);
    for (k, allowed) in allowed.iter_mut().enumerate() {
        if k % every != 0 && !answers(k) {
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
            setting: None,
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
