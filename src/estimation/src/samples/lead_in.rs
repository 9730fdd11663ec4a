//! The motion that runs ahead of a mean cycle, so that what the damper remembers is its own.
//!
//! A rig has run a test for many cycles before the first that counts. On a soft mount or a soft oil column the mean of the
//! force goes on moving for as long as the slow valves take to bleed the spring, which at 25 Hz may be ten cycles.

use super::Test;
use crate::segment::Segment;
use crate::sensitivity::forces;
use dashpot_core::{Model, Params};
use rayon::prelude::*;

/// Shortest lead-in of the motion, s, and its shortest and longest length in cycles.
///
/// A longer internal state begins at rest in the middle of the stroke, as it does on a rig.
const TIME: f64 = 0.15;
const CYCLES: (f64, f64) = (1.5, 3.5);
/// Fraction of a cycle just before the scored samples in which the lead-in uses every sample.
///
/// Before that it uses one of `COARSER`: an error there has died out.
const FINE: f64 = 0.25;
const COARSER: usize = 4;
/// Most cycles that it is made longer by.
const MORE: usize = 20;
/// What may be left of the start, in allowed errors.
const LEFT: f64 = 0.1;
/// Ratio of one cycle's change to the one's before from which the damper warms or drifts, which no run-in ends.
const SLOWEST: f64 = 0.95;

/// Initial length of the lead-in of a cycle of `count` samples, in samples.
pub fn initial_length(period: f64, count: usize) -> usize {
    let half_cycles = (2.0 * (TIME / period).clamp(CYCLES.0, CYCLES.1)).round();
    (0.5 * half_cycles * count as f64) as usize
}

/// Sample indices, from the start of the lead-in, of a lead-in of `lead` samples and its cycle of `count`.
pub fn places(lead: usize, count: usize) -> Vec<usize> {
    let near = (FINE * count as f64) as usize;
    let is_taken = |k: &usize| *k + near >= lead || (lead - near - k).is_multiple_of(COARSER);
    (0..lead + count).filter(is_taken).collect()
}

/// The tests with a run-in as long as the damper remembers.
pub fn as_long_as_remembered(tests: Vec<Test>, params: &Params) -> Vec<Test> {
    let Ok(model) = Model::new(params) else { return tests };
    tests
        .into_par_iter()
        .map(|test| match further_cycles(&test, &model) {
            0 => test,
            cycles => {
                let lead = initial_length(1.0 / test.frequency, test.count()) + cycles * test.count();
                Test { segment: led_in(&test, &places(lead, test.count()), lead), ..test }
            }
        })
        .collect()
}

/// The scored cycle run through `places`, of which the first `lead` samples lead in.
fn led_in(test: &Test, places: &[usize], lead: usize) -> Segment {
    let (whole, count) = (&test.segment, test.count());
    let turned = |k: usize| whole.from + (k + count - lead % count) % count;
    let since = |pair: &[usize]| (pair[0] + 1..=pair[1]).map(|k| whole.dt[turned(k)]).sum();
    Segment {
        dt: std::iter::once(0.0).chain(places.windows(2).map(since)).collect(),
        input: places.iter().map(|k| whole.input[turned(*k)]).collect(),
        force: places.iter().map(|k| whole.force[turned(*k)]).collect(),
        from: places.len() - count,
        ..whole.clone()
    }
}

/// How many cycles the run-in must be longer, for the force to be that of a motion that has gone on.
fn further_cycles(test: &Test, model: &Model) -> usize {
    let count = test.count();
    if test.frequency <= 0.0 || count <= COARSER {
        return 0;
    }
    let usual = initial_length(1.0 / test.frequency, count);
    // The cycle that would count, and those after it, at the same phases in each.
    let from = usual % count;
    let places: Vec<usize> =
        (0..usual + (MORE + 2) * count).filter(|k| ((k + count - from) % count).is_multiple_of(COARSER)).collect();
    let first = places.partition_point(|k| *k < usual);
    let in_cycle = places.len().saturating_sub(first) / (MORE + 2);
    let all = forces(model, &led_in(test, &places, usual));
    let cycles: Vec<&[f64]> = all[first..].chunks_exact(in_cycle).collect();
    let changes: Vec<f64> = cycles
        .windows(2)
        .map(|pair| pair[0].iter().zip(pair[1]).map(|(a, b)| (b - a).abs()).fold(0.0, f64::max))
        .collect();
    // Changes that shrink by r from cycle to cycle sum up to the last one's r/(1 − r).
    let is_run_in = |pair: &[f64]| {
        let ratio = if pair[0] > 0.0 { pair[1] / pair[0] } else { 0.0 };
        ratio > SLOWEST || pair[0] / (1.0 - ratio) < LEFT * test.segment.scale
    };
    changes.windows(2).position(is_run_in).unwrap_or(MORE)
}

#[cfg(test)]
mod tests {
    use super::*;
    use dashpot_core::Input;
    use dashpot_core::{element, list, number};
    use std::f64::consts::TAU;

    const COUNT: usize = 100;

    /// A cycle of 1 mm that starts anywhere in it, with the usual run-in.
    fn cycle(frequency: f64) -> Test {
        let dt = 1.0 / (frequency * COUNT as f64);
        let input = |k: usize| {
            let phase = TAU * (k as f64 / COUNT as f64 + 0.07);
            let (x, v) = (1e-3 * libm::sin(phase), 1e-3 * TAU * frequency * libm::cos(phase));
            Input { displacement: Some(x), ..Input::motion(x, v) }
        };
        let segment = Segment {
            name: String::new(),
            dt: vec![dt; COUNT],
            input: (0..COUNT).map(input).collect(),
            setting: None,
            force: vec![0.0; COUNT],
            from: 0,
            scale: 2.0,
            top: 300.0,
            peak_velocity: 0.16,
            amplitude: 1e-3,
            clock: 0.0,
        };
        let test = Test {
            record: 0,
            segment,
            allowed: vec![2.0; COUNT],
            mean_noise: 2.0,
            independence: 1.0,
            growth: 0.0,
            noise_freedom: 100.0,
            frequency,
            weight: 1.0,
        };
        let lead = initial_length(1.0 / frequency, COUNT);
        Test { segment: led_in(&test, &places(lead, COUNT), lead), ..test }
    }

    fn on_a_mount(stiffness: f64) -> Params {
        let mut params = Params::new();
        params.enable(element!("series_compliance"), true);
        params.set(number!("series_stiffness"), stiffness).unwrap();
        // Three times as hard in rebound as in compression: its mean force moves until the spring has taken it up.
        params.set_list(list!("fv_velocity"), &[-2.0, 0.0, 2.0]).unwrap();
        params.set_list(list!("fv_force"), &[-6e3, 0.0, 18e3]).unwrap();
        params
    }

    #[test]
    fn the_run_in_lasts_until_the_mean_force_on_a_soft_mount_has_settled() {
        let test = cycle(25.0);
        for (stiffness, is_soft) in [(1e6, false), (6e4, true)] {
            let params = on_a_mount(stiffness);
            let model = Model::new(&params).unwrap();
            let led = &as_long_as_remembered(vec![test.clone()], &params)[0];
            assert_eq!(led.segment.from > test.segment.from, is_soft, "{stiffness}");
            assert_eq!((led.inputs(), led.count()), (test.inputs(), test.count()));
            let lead = initial_length(1.0 / 25.0, COUNT) + 60 * COUNT;
            let long = led_in(&test, &places(lead, COUNT), lead);
            let off = |segment: &Segment| {
                let (all, settled) = (forces(&model, segment), forces(&model, &long));
                let pairs = all[segment.from..].iter().zip(&settled[long.from..]);
                pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
            };
            assert!(off(&led.segment) < 2.0 * LEFT * led.segment.scale, "{stiffness}: {} N", off(&led.segment));
            assert!(!is_soft || off(&test.segment) > 5.0 * led.segment.scale, "{} N", off(&test.segment));
        }
    }
}
