//! Estimates the delay of the force channel: the delay with which one force-velocity (FV) curve best explains the force
//! of all tests.
//!
//! A charge amplifier, a filter or a second converter delays the force relative to the motion. The delay causes a
//! force-velocity loop that grows with frequency. If the delay exceeds a quarter of a cycle, the damper seems to feed
//! energy. This module only estimates the delay. The records are shifted only at the user's request.

use nalgebra::{DMatrix, DVector};
use serde::{Deserialize, Serialize};

use crate::data::complete_test::CompleteTest;
use crate::tuning::delay::{BETTER, CLEARLY, LONGEST, NODES, SAMPLES, SHORTEST_REPORTED, STEP, TELLING, UNCLEAR};

/// Delay of the force channel, as the records of a campaign show it.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Delay {
    /// Delay of the force relative to the motion, s, in addition to the delay that the user stated.
    pub seconds: f64,
    /// Fraction of the force variance that an FV curve cannot explain, without a shift of the records.
    pub unexplained_as_recorded: f64,
    /// Fraction of the force variance that an FV curve cannot explain after correction of the delay.
    pub unexplained: f64,
}

/// One test after decimation.
struct Thinned<'a> {
    /// Index of the test in the campaign.
    index: usize,
    motion: &'a CompleteTest,
    /// Time, s, and force, N, of the selected samples.
    samples: Vec<(f64, f64)>,
    /// Standard deviation of the force of this test, N.
    scale: f64,
}

/// Evaluation of the tests for one assumed delay of the force.
struct Look {
    unexplained: f64,
    /// Normalized power of every test, -1 to 1: the correlation of force and velocity. It is negative if the test feeds
    /// energy.
    power: Vec<f64>,
}

impl Look {
    fn dissipates(&self) -> bool {
        self.power.iter().all(|p| *p > -UNCLEAR) && self.power.iter().any(|p| *p > UNCLEAR)
    }
}

/// Cause of tests that feed energy.
#[derive(Debug, PartialEq)]
pub(crate) enum Cause {
    /// A delay explains the tests clearly better than a reversed sign.
    Delay(Delay),
    /// Both a delay and a reversed sign may explain the tests.
    Either(Delay),
    /// A reversed sign explains the tests clearly better than a delay, or no delay explains them.
    Sign,
}

/// Returns the delay of tests that feed no energy. Returns `None` if no delay fits the tests, or if the delay is
/// shorter than [`SHORTEST_REPORTED`] or hardly reduces the unexplained force variance.
pub(crate) fn find(motions: &[CompleteTest]) -> Option<Delay> {
    let delay = best(&thin(motions), &[])?;
    (delay.seconds >= SHORTEST_REPORTED && delay.unexplained < BETTER * delay.unexplained_as_recorded).then_some(delay)
}

/// Determines why the tests with the indices `feeding` feed energy to the rig: a delay of the force or a reversed sign.
pub(crate) fn cause(motions: &[CompleteTest], feeding: &[usize]) -> Cause {
    let tests = thin(motions);
    // A delay with which an FV curve explains no force variance is not the cause. A reversed sign is then assumed.
    let Some(delay) = best(&tests, &[]).filter(|delay| delay.unexplained < 1.0) else { return Cause::Sign };
    match best(&tests, feeding) {
        Some(turned) if delay.unexplained >= CLEARLY * turned.unexplained => {
            if turned.unexplained < CLEARLY * delay.unexplained { Cause::Sign } else { Cause::Either(delay) }
        }
        _ => Cause::Delay(delay),
    }
}

/// Returns the delay with the smallest unexplained variance, among the delays that meet two conditions. With the delay,
/// no test clearly feeds energy to the rig, and at least one test clearly dissipates energy. Returns `None` if no delay
/// meets both conditions. In the tests with the indices `turned`, the sign of the force is reversed first.
fn best(tests: &[Thinned<'_>], turned: &[usize]) -> Option<Delay> {
    if tests.is_empty() {
        return None;
    }
    let count = (LONGEST / STEP).round() as usize;
    let looks: Vec<Look> = (0..=count).map(|k| look(tests, turned, STEP * k as f64)).collect();
    let least = (0..=count)
        .filter(|&k| looks[k].dissipates())
        .min_by(|&a, &b| looks[a].unexplained.total_cmp(&looks[b].unexplained))?;
    let at = |k: usize| looks[k].unexplained;
    let mut seconds = STEP * least as f64;
    if (1..count).contains(&least) {
        let (before, here, after) = (at(least - 1), at(least), at(least + 1));
        let bend = before - 2.0 * here + after;
        if bend > 0.0 {
            seconds += (0.5 * STEP * (before - after) / bend).clamp(-0.5 * STEP, 0.5 * STEP);
        }
    }
    Some(Delay { seconds, unexplained_as_recorded: at(0), unexplained: at(least) })
}

fn thin(motions: &[CompleteTest]) -> Vec<Thinned<'_>> {
    let telling = |motion: &CompleteTest| match (motion.cycles.first(), motion.cycles.last()) {
        (Some(first), Some(last)) => {
            let period = (last.end_time - first.start_time) / motion.cycles.len() as f64;
            LONGEST > TELLING * period
        }
        _ => true,
    };
    motions
        .iter()
        .enumerate()
        .filter(|(_, motion)| telling(motion))
        .map(|(index, motion)| {
            let span = motion.steady();
            // Begin at least the longest delay after the start, so that every delay is evaluated with the same samples.
            let begin = span.start.max(motion.time.partition_point(|t| *t < motion.time[0] + LONGEST));
            let every = ((span.end.max(begin) - begin) / SAMPLES).max(1);
            let samples: Vec<(f64, f64)> =
                (begin..span.end).step_by(every).map(|i| (motion.time[i], motion.force[i])).collect();
            let n = samples.len().max(1) as f64;
            let mean = samples.iter().map(|s| s.1).sum::<f64>() / n;
            let scale = (samples.iter().map(|s| (s.1 - mean).powi(2)).sum::<f64>() / n).sqrt();
            Thinned { index, motion, samples, scale }
        })
        .filter(|test| test.samples.len() >= 10 && test.scale > 0.0)
        .collect()
}

fn look(tests: &[Thinned<'_>], turned: &[usize], delay: f64) -> Look {
    let fastest = tests.iter().flat_map(|t| &t.motion.velocity).fold(0.0_f64, |m, v| m.max(v.abs()));
    // Number of coefficients: those of the FV curve (an even number of nodes and the node at zero), and the stiffness
    // of a spring.
    let size = 2 * NODES.len() + 2;
    let mut normal = DMatrix::<f64>::zeros(size, size);
    let mut right = DVector::<f64>::zeros(size);
    let (mut total, mut count) = (0.0, 0.0);
    let mut power = Vec::with_capacity(tests.len());
    for test in tests {
        let sign = if turned.contains(&test.index) { -1.0 } else { 1.0 };
        let (time, x, v) = (&test.motion.time, &test.motion.displacement, &test.motion.velocity);
        let weight = 1.0 / (test.scale * test.scale);
        let mut at = 0;
        let n = test.samples.len() as f64;
        let mean = test.samples.iter().map(|s| s.1).sum::<f64>() / n;
        let (mut sums, mut springs) = ([0.0; 3], [0.0; 2]);
        let centre = test.motion.displacement.iter().sum::<f64>() / test.motion.displacement.len() as f64;
        let mut points = Vec::with_capacity(test.samples.len());
        for &(t, force) in &test.samples {
            let wanted = t - delay;
            while at + 2 < time.len() && time[at + 1] <= wanted {
                at += 1;
            }
            let share = ((wanted - time[at]) / (time[at + 1] - time[at])).clamp(0.0, 1.0);
            let of = |values: &[f64]| values[at] + share * (values[at + 1] - values[at]);
            let (x, v) = (of(x) - centre, of(v));
            springs[0] += x * x;
            springs[1] += x * (force - mean);
            points.push((x, v, sign * force));
        }
        // Use the rule of `checks/sign.rs`. Over whole cycles, springs return their energy. Without whole cycles, a
        // linear fit removes the spring force.
        let stiffness = if test.motion.cycles.is_empty() && springs[0] > 0.0 { springs[1] / springs[0] } else { 0.0 };
        for &(x, v, force) in &points {
            let f = force - sign * (mean + stiffness * x);
            for (sum, term) in sums.iter_mut().zip([f * v, f * f, v * v]) {
                *sum += term;
            }
            let (node, share) = place(v / fastest);
            let entries = [(node, 1.0 - share), (node + 1, share), (size - 1, x)];
            for (i, a) in entries {
                for (j, b) in entries {
                    normal[(i, j)] += weight * a * b;
                }
                right[i] += weight * a * force;
            }
            total += weight * force * force;
            count += 1.0;
        }
        power.push(if sums[1] > 0.0 && sums[2] > 0.0 { sums[0] / (sums[1] * sums[2]).sqrt() } else { 0.0 });
    }
    for i in 0..size {
        // A small diagonal term keeps the force at nodes without samples at zero.
        normal[(i, i)] += 1e-9 * (1.0 + normal[(i, i)]);
    }
    let explained = normal.cholesky().map_or(0.0, |c| c.solve(&right).dot(&right));
    Look { unexplained: ((total - explained) / count).max(0.0), power }
}

/// Returns the index of the node below a velocity, and the fractional position between that node and the next, 0..1.
/// `share` is the velocity relative to the highest node. The nodes of [`NODES`] with both signs and zero count, in
/// ascending order.
fn place(share: f64) -> (usize, f64) {
    let side = NODES.len();
    let size = share.abs().min(1.0);
    let k = NODES.iter().position(|node| size <= *node).unwrap_or(side - 1);
    let low = if k == 0 { 0.0 } else { NODES[k - 1] };
    let part = (size - low) / (NODES[k] - low);
    if share >= 0.0 { (side + k, part) } else { (side - k - 1, 1.0 - part) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cleaning;
    use crate::fixtures::{Random, SineTest};
    use crate::options::Options;

    /// Makes tests at the given frequencies, Hz. The force has the delay `late`, s, and is multiplied by `factor`.
    fn tests(frequencies: &[f64], late: f64, factor: f64) -> Vec<CompleteTest> {
        frequencies
            .iter()
            .map(|&frequency| {
                let test =
                    SineTest { frequency, cycles: 8, amplitude: 0.1 / (1.0 + 4.0 * frequency), ..SineTest::default() };
                let mut samples = test.samples();
                let early = samples.force.clone();
                let step = test.period() / test.per_cycle as f64;
                for i in 0..samples.force.len() {
                    let at = (i as f64 - late / step).max(0.0);
                    let (k, share) = (at.floor() as usize, at.fract());
                    let next = early[(k + 1).min(early.len() - 1)];
                    samples.force[i] = factor * (early[k] + share * (next - early[k]));
                }
                cleaning::repair(samples, &Options::default()).unwrap()
            })
            .collect()
    }

    #[test]
    fn nodes_of_the_curve_join() {
        for (share, wanted) in
            [(0.0, (7, 0.0)), (1.0, (13, 1.0)), (-1.0, (0, 0.0)), (-0.0075, (6, 0.5)), (2.0, (13, 1.0))]
        {
            let (node, part) = place(share);
            assert!((node as f64 + part - (wanted.0 as f64 + wanted.1)).abs() < 1e-12, "{share}: {node} {part}");
        }
    }

    #[test]
    fn delays_are_found_to_a_millisecond_and_their_absence_too() {
        for late in [0.015, 0.0237, 0.045] {
            let delay = find(&tests(&[0.2, 1.0, 3.0, 8.0], late, 1.0)).unwrap();
            assert!((delay.seconds - late).abs() < 1e-3, "{late}: {delay:?}");
            assert!(delay.unexplained < 0.1, "{delay:?}");
        }
        assert_eq!(find(&tests(&[0.2, 1.0, 3.0, 8.0], 0.0, 1.0)), None);
    }

    #[test]
    fn a_turned_sign_is_told_from_a_delay() {
        let frequencies = [1.0, 3.0, 10.0];
        let feeding: Vec<usize> = vec![2];
        match cause(&tests(&frequencies, 0.045, 1.0), &feeding) {
            Cause::Delay(delay) => assert!((delay.seconds - 0.045).abs() < 1e-3, "{delay:?}"),
            other => panic!("{other:?}"),
        }
        assert_eq!(cause(&tests(&frequencies, 0.0, -1.0), &[0, 1, 2]), Cause::Sign);
        let mut one = tests(&frequencies, 0.0, 1.0);
        one[2].force.iter_mut().for_each(|f| *f = -*f);
        assert_eq!(cause(&one, &[2]), Cause::Sign);
        // If all tests have one frequency, a delay of half a cycle and a reversed sign are indistinguishable without
        // the run-up.
        let test = SineTest { frequency: 10.0, amplitude: 0.002, cycles: 12, ..SineTest::default() };
        let mut samples = test.samples();
        samples.force.rotate_right(test.per_cycle / 2);
        samples.select(&(600..2000).collect::<Vec<_>>());
        let steady = cleaning::repair(samples, &Options::default()).unwrap();
        let found = cause(&[steady], &[0]);
        assert!(matches!(found, Cause::Either(_)), "{found:?}");
    }

    #[test]
    fn slow_tests_tell_no_delay_and_long_ones_are_thinned_out() {
        let counted = |frequency: f64| thin(&tests(&[frequency], 0.0, 1.0)).len();
        assert_eq!((counted(0.5), counted(0.25)), (1, 0));
        let test = SineTest { frequency: 1.0, cycles: 20, per_cycle: 400, ..SineTest::default() };
        let long = [cleaning::repair(test.samples(), &Options::default()).unwrap()];
        let count = thin(&long)[0].samples.len();
        assert!((1500..=2000).contains(&count), "{count}");
    }

    #[test]
    fn power_near_zero_is_neither_dissipation_nor_its_contrary() {
        let dissipates = |power: &[f64]| Look { unexplained: 0.0, power: power.to_vec() }.dissipates();
        assert!(dissipates(&[0.12]) && !dissipates(&[0.08]));
        assert!(dissipates(&[0.5, -0.08]) && !dissipates(&[0.5, -0.12]));
    }

    #[test]
    fn a_delay_is_found_to_a_tenth_of_a_millisecond() {
        for late in [0.0104, 0.0237, 0.0306] {
            let delay = best(&thin(&tests(&[20.0], late, 1.0)), &[]).unwrap();
            assert!((delay.seconds - late).abs() < 1e-4, "{late}: {delay:?}");
        }
    }

    #[test]
    fn a_delay_that_explains_little_of_the_force_is_not_reported() {
        let reported = |noise: f64| {
            let mut motions = tests(&[1.0, 3.0, 8.0], 0.012, 1.0);
            let mut random = Random::new(3);
            motions.iter_mut().flat_map(|motion| &mut motion.force).for_each(|f| *f += noise * random.normal());
            find(&motions).is_some()
        };
        // The unexplained variance with the delay is 0.44 and 0.75 of that without.
        assert!(reported(50.0) && !reported(100.0));
    }
}
