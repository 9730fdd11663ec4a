//! A test whose setting changes: short steps of the model during the response of the valve to a command, long steps
//! otherwise.

use super::Test;
use super::road::ROAD;
use super::sampling::{Sampling, input_at};
use crate::segment::Segment;
use dashpot_core::Input;
use dashpot_records::smoothing::Motion;
use dashpot_records::{Record, SettingPattern, SettingSignal};

/// Largest step of the model at constant command, s. A longer step would not resolve changes of the internal state.
const STEP: f64 = 2e-3;
/// Largest step of the model during the response of the valve to a command, s: a fraction of the response time.
const ANSWER_STEP: f64 = 5e-4;
/// Longest response of a valve to a change of its command, s.
const ANSWER: f64 = 0.3;
/// Stride, in steps, of the scored samples outside the responses of the valve.
const SCORED: usize = 5;
/// Largest number of steps of a test. A record with more samples has longer steps.
const MOST: usize = 40_000;
/// Ratio of the number of steps of a test to the number of steps of its lead-in.
const LEAD: usize = 20;

/// Selects the samples that become steps of the model. A flag marks samples during the response of the valve to a
/// command.
fn picks(record: &Record, signal: &SettingSignal, stride: usize) -> Vec<(usize, bool)> {
    let n = record.time.len();
    let fine = ((ANSWER_STEP / step(record)) as usize).max(n.div_ceil(MOST)).max(1);
    let mut picks = vec![(0, false)];
    let mut answers_until = f64::NEG_INFINITY;
    let mut at = 0;
    while at + 1 < n {
        let near = at + fine.min(n - 1 - at);
        if signal.swing(at..(at + stride + 1).min(n)) > 0.0 {
            answers_until = record.time[at] + ANSWER;
        }
        let answers = record.time[near] <= answers_until;
        at = if answers { near } else { at + stride.min(n - 1 - at) };
        picks.push((at, answers));
    }
    picks
}

/// Computes the time between samples, s.
fn step(record: &Record) -> f64 {
    let n = record.time.len();
    ((record.time[n - 1] - record.time[0]) / (n - 1).max(1) as f64).max(1e-9)
}

/// Computes the command of each step between picked samples, in the unit of the setting: the mean over the samples of
/// the step.
fn commands(signal: &SettingSignal, picks: &[(usize, bool)]) -> Vec<f64> {
    let first = picks.first().map(|(first, _)| signal.command(*first));
    let mean = |pair: &[(usize, bool)]| {
        let passed = pair[0].0 + 1..=pair[1].0;
        let count = passed.clone().count().max(1) as f64;
        passed.map(|sample| signal.command(sample)).sum::<f64>() / count
    };
    first.into_iter().chain(picks.windows(2).map(mean)).collect()
}

/// Makes the test of a record whose setting changes.
pub fn test(place: usize, record: &Record, motion: &Motion, signal: &SettingSignal) -> Test {
    let n = record.time.len();
    let stride = ((STEP / step(record)) as usize).max(n.div_ceil(MOST)).max(1);
    let picks = picks(record, signal, stride);
    let lead = (picks.len() / LEAD).max(1);
    let answers = |k: usize| picks.get(lead + k).is_some_and(|(_, answers)| *answers);
    let samples: Vec<usize> = picks.iter().map(|(sample, _)| *sample).collect();
    let clock = record.clock_s + 0.5 * (record.time[0] + record.time[n - 1]);
    let sampling = Sampling { picks: &samples, lead, apart: stride * SCORED, clock, weight: ROAD };
    let is_scored = |k: usize| k % SCORED == 0 || answers(k);
    match signal.pattern {
        SettingPattern::Steps => {
            let test = sampling.test(place, record, motion, None, is_scored);
            with_steps_until_changes(test, record, motion, signal, &samples)
        }
        SettingPattern::Varying => sampling.test(place, record, motion, Some(commands(signal, &picks)), is_scored),
    }
}

/// Splits the steps of a test at the times at which the command changes from one value to another.
///
/// A change may occur anywhere between two samples. The split is midway between them. A mean command over that step
/// would spread the change over a sample, with a dead time of half a sample. The model could then not represent an
/// instantaneous valve, and the estimated lag would be a sixteenth of a sample too short.
fn with_steps_until_changes(
    mut test: Test,
    record: &Record,
    motion: &Motion,
    signal: &SettingSignal,
    samples: &[usize],
) -> Test {
    let Segment { dt, input, force, from, .. } = test.segment.clone();
    let (old_input, old_force, old_allowed) = (input, force, std::mem::take(&mut test.allowed));
    let (mut steps, mut first) = (vec![(dt[0], old_input[0], old_force[0], signal.values[samples[0]])], from);
    test.allowed.extend(old_allowed.first().filter(|_| from == 0));
    for (k, pair) in samples.windows(2).enumerate() {
        let mut at = record.time[pair[0]];
        for change in (pair[0] + 1..=pair[1]).filter(|sample| signal.values[*sample] != signal.values[sample - 1]) {
            let (before, after) = (record.time[change - 1], record.time[change]);
            let ends = [change - 1, change].map(|sample| input_at(record, motion, sample));
            let force = 0.5 * (record.force[change - 1] + record.force[change]);
            let middle = 0.5 * (before + after);
            steps.push((middle - at, between(ends, after - before), force, signal.values[change - 1]));
            at = middle;
            // The added step has no measured force, so it is not scored.
            if k < from { first += 1 } else { test.allowed.push(f64::INFINITY) }
        }
        steps.push((record.time[pair[1]] - at, old_input[k + 1], old_force[k + 1], signal.values[pair[1]]));
        test.allowed.extend((k + 1).checked_sub(from).map(|scored| old_allowed[scored]));
    }
    test.segment.dt = steps.iter().map(|step| step.0).collect();
    test.segment.input = steps.iter().map(|step| step.1).collect();
    test.segment.force = steps.iter().map(|step| step.2).collect();
    test.segment.setting = Some(steps.iter().map(|step| step.3).collect());
    test.segment.from = first;
    test
}

/// Interpolates the input of the damper in the middle between two samples `dt`, s, apart.
fn between([a, b]: [Input; 2], dt: f64) -> Input {
    let middle = |a: f64, b: f64| 0.5 * (a + b);
    // This is the cubic Hermite interpolation between both samples with their velocities.
    let displacement =
        a.displacement.zip(b.displacement).map(|(x, y)| middle(x, y) + dt / 8.0 * (a.velocity - b.velocity));
    Input {
        displacement,
        velocity: middle(a.velocity, b.velocity),
        side_force: middle(a.side_force, b.side_force),
        temperature: middle(a.temperature, b.temperature),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use dashpot_records::smoothing::smooth;

    #[test]
    fn steps_are_short_where_the_valve_answers_and_no_command_is_lost() {
        let n = 8000;
        let time: Vec<f64> = (0..n).map(|k| 2.5e-4 * k as f64).collect();
        let current: Vec<f64> = (0..n).map(|k| if k < 4000 { 0.2 } else { 1.4 }).collect();
        let signal = SettingSignal::new("current", "A", &current);
        let record = Record {
            displacement: time.iter().map(|t| 0.02 * libm::sin(5.0 * t)).collect(),
            velocity: time.iter().map(|t| 0.1 * libm::cos(5.0 * t)).collect(),
            force: vec![100.0; n],
            amplitude: 0.02,
            peak_velocity: 0.1,
            time,
            ..Record::default()
        };
        let test = test(0, &record, &smooth(&record), &signal);
        let (dt, setting) = (&test.segment.dt, test.segment.setting.as_ref().unwrap());
        assert!((dt.iter().sum::<f64>() - record.time[n - 1]).abs() < 1e-9);
        let mean: f64 = dt.iter().zip(setting).map(|(dt, s)| dt * s).sum::<f64>() / record.time[n - 1];
        let true_mean = (1..n).map(|k| signal.command(k)).sum::<f64>() / (n - 1) as f64;
        assert!((mean - true_mean).abs() < 1e-9, "{mean} {true_mean}");
        // The step in which the command changes is split, so the command is constant within every step.
        assert!(setting.iter().all(|s| *s == 0.2 || *s == 1.4), "a command between the levels");
        let switched = setting.iter().position(|s| *s == 1.4).unwrap();
        let time: f64 = dt[..switched].iter().sum();
        assert!((time - 3999.5 * 2.5e-4).abs() < 1e-12, "{time}");
        let unscored = test.allowed[switched - 1 - test.segment.from];
        assert!(unscored.is_infinite() && test.allowed.len() == test.count());
        let at = |x: f64| 0.02 * libm::sin(5.0 * x);
        let there = test.segment.input[switched - 1];
        assert!((there.displacement.unwrap() - at(time)).abs() < 1e-7, "{there:?}");
        let shortest = dt.iter().skip(1).fold(1.0, |m: f64, dt| m.min(*dt));
        let longest = dt.iter().fold(0.0, |m: f64, dt| m.max(*dt));
        assert!(shortest < 0.6e-3 && longest > 1.9e-3, "{shortest} {longest}");
    }
}
