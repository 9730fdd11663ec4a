//! The lead-in: motion before a mean cycle that brings the internal state of the damper to its steady state.
//!
//! A rig runs a test for many cycles before the first scored cycle. With a soft mount or a soft oil column, the mean
//! force changes until flow through the valves has relaxed the spring. At 25 Hz, this may take ten cycles.

use super::Test;
use crate::segment::Segment;
use crate::sensitivity::forces;
use dashpot_core::{Model, Params};
use rayon::prelude::*;

/// Shortest duration of the lead-in, s. [`CYCLES`] contains the smallest and the largest length of the lead-in, in
/// cycles.
///
/// An internal state that is slower than the lead-in starts in equilibrium at the middle of the stroke, as on a rig.
const TIME: f64 = 0.15;
const CYCLES: (f64, f64) = (1.5, 3.5);
/// Fraction of a cycle, directly before the scored samples, in which the lead-in uses every sample.
///
/// Before that fraction, the lead-in uses only every fourth sample ([`COARSER`]), because the resulting error decays.
const FINE: f64 = 0.25;
const COARSER: usize = 4;
/// Largest number of cycles by which the lead-in is extended.
const MORE: usize = 20;
/// Largest remaining influence of the initial state on the force, in units of the typical allowed error.
const LEFT: f64 = 0.1;
/// Ratio of one cycle's change to the previous change above which warming or drift is the cause. A longer lead-in does
/// not end such a change, so the lead-in is then not extended.
const SLOWEST: f64 = 0.95;

/// Computes the initial length of the lead-in, in samples, of a cycle of `count` samples that lasts `period`, s.
pub fn initial_length(period: f64, count: usize) -> usize {
    let half_cycles = (2.0 * (TIME / period).clamp(CYCLES.0, CYCLES.1)).round();
    (0.5 * half_cycles * count as f64) as usize
}

/// Selects sample indices, counted from the start of the lead-in, for a lead-in of `lead` samples and a scored cycle of
/// `count` samples.
pub fn places(lead: usize, count: usize) -> Vec<usize> {
    let near = (FINE * count as f64) as usize;
    let is_taken = |k: &usize| *k + near >= lead || (lead - near - k).is_multiple_of(COARSER);
    (0..lead + count).filter(is_taken).collect()
}

/// Extends the lead-in of each test until the internal state of the damper reaches its steady state, by at most
/// `MORE` cycles.
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

/// Repeats the scored cycle at the indices `places`, which count from the start of a lead-in of `lead` samples.
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

/// Returns the number of further cycles of lead-in after which the force is that of the steady state, at most [`MORE`].
/// Returns 0 for a test without cycles or with too few samples.
fn further_cycles(test: &Test, model: &Model) -> usize {
    let count = test.count();
    if test.frequency <= 0.0 || count <= COARSER {
        return 0;
    }
    let usual = initial_length(1.0 / test.frequency, count);
    // Compare the cycle that would be scored with later cycles at equal phases.
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
    // If changes decrease by a ratio r from cycle to cycle, their sum is a geometric series, 1/(1 − r) times the first
    // change.
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

    /// Makes a test of one sine cycle of 1 mm, which starts at 7 % of its period. The lead-in has its initial length.
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
        // The damper is three times as stiff in rebound as in compression: its mean force changes until the spring
        // carries the mean force.
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
