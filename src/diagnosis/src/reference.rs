//! Correction based on a reference: the same tests on a good damper. The residual of the model on these tests is its
//! form error, which the diagnosed damper shares. After the correction, only changes of the damper remain.

use dashpot_core::Input;
use dashpot_estimation::gap::rms;
use dashpot_estimation::samples::Test;
use std::f64::consts::TAU;

/// Largest relative difference of amplitude and frequency at which two tests count as equal.
///
/// `SAME_PLACE` is the largest difference of the mean displacement, relative to the amplitude. `SAME_SIDE` is the
/// largest difference of the side force, N.
const SAME: f64 = 0.05;
const SAME_PLACE: f64 = 0.1;
const SAME_SIDE: f64 = 25.0;

/// Operating point of a test.
struct At {
    frequency: f64,
    amplitude: f64,
    mean: f64,
    side: f64,
}

fn at(test: &Test) -> At {
    let x = || test.inputs().iter().filter_map(|i| i.displacement);
    let (low, high) = x().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), x| (l.min(x), h.max(x)));
    let count = test.count().max(1) as f64;
    At {
        frequency: test.frequency,
        amplitude: 0.5 * (high - low),
        mean: 0.5 * (high + low),
        side: test.inputs().iter().map(|i| i.side_force).sum::<f64>() / count,
    }
}

fn is_same(a: &At, b: &At) -> bool {
    let near = |a: f64, b: f64| (a - b).abs() <= SAME * a.abs().max(b.abs());
    a.frequency > 0.0
        && near(a.frequency, b.frequency)
        && near(a.amplitude, b.amplitude)
        && (a.mean - b.mean).abs() <= SAME_PLACE * a.amplitude.max(b.amplitude)
        && (a.side - b.side).abs() <= SAME_SIDE
}

/// Returns the phase of a sample in its cycle, rad, from 0 to 2π. It is 0 in rebound at the mean displacement.
fn phase(input: &Input, at: &At) -> f64 {
    let x = (input.displacement.unwrap_or(at.mean) - at.mean) / at.amplitude;
    let v = input.velocity / (TAU * at.frequency * at.amplitude);
    libm::atan2(x, v).rem_euclid(TAU)
}

/// Residual of one cycle, N, over its phase, rad.
struct Left {
    by_phase: Vec<(f64, f64)>,
}

impl Left {
    fn new(test: &Test, at: &At, residual: &[f64]) -> Left {
        let mut by_phase: Vec<(f64, f64)> =
            test.inputs().iter().zip(residual).map(|(input, r)| (phase(input, at), *r)).collect();
        by_phase.sort_by(|a, b| a.0.total_cmp(&b.0));
        Left { by_phase }
    }

    /// Interpolates the residual, N, linearly between the two samples around a phase, rad.
    fn at(&self, phase: f64) -> f64 {
        let n = self.by_phase.len();
        let right = self.by_phase.partition_point(|p| p.0 <= phase);
        let (a, b) = (self.by_phase[(right + n - 1) % n], self.by_phase[right % n]);
        let span = (b.0 - a.0).rem_euclid(TAU);
        let share = if span > 0.0 { (phase - a.0).rem_euclid(TAU) / span } else { 0.0 };
        a.1 + share.clamp(0.0, 1.0) * (b.1 - a.1)
    }
}

/// Result of the correction of tests by the form error from the reference.
pub struct Freed {
    /// All tests, corrected except those in `missing`.
    pub tests: Vec<Test>,
    /// Names of tests that have no counterpart of similar motion.
    pub missing: Vec<String>,
    /// Names of tests that were corrected with the nearest motion of the reference, because the reference does not
    /// contain the same test.
    pub shifted: Vec<String>,
}

/// Largest root mean square difference of the displacements of two tests with the same motion without cycles, such as a
/// road, relative to the amplitude.
const SAME_ROAD: f64 = 0.02;

/// Subtracts the residual of the same motion without cycles, sample by sample. `known` holds the reference tests with
/// their residuals, N. Returns the number of reference tests with this motion.
fn without_error_of_road(test: &mut Test, known: &[(&Test, &Vec<f64>)]) -> usize {
    let has_same_motion = |other: &&(&Test, &Vec<f64>)| {
        let (other, residual) = **other;
        let pairs = test.inputs().iter().zip(other.inputs());
        let differences = pairs.map(|(a, b)| Some(a.displacement? - b.displacement?)).collect::<Option<Vec<f64>>>();
        let amplitude = at(test).amplitude;
        other.frequency == 0.0
            && other.count() == test.count()
            && residual.len() == test.count()
            && (at(test).side - at(other).side).abs() <= SAME_SIDE
            && differences.is_some_and(|of| rms(&of) <= SAME_ROAD * amplitude)
    };
    let same: Vec<&(&Test, &Vec<f64>)> = known.iter().filter(has_same_motion).collect();
    let count = same.len();
    if count == 0 {
        return 0;
    }
    let noise = same.iter().map(|(other, _)| other.mean_noise.powi(2)).sum::<f64>().sqrt() / count as f64;
    let from = test.segment.from;
    for k in 0..test.count() {
        let left = same.iter().map(|(_, residual)| residual[k]).sum::<f64>() / count as f64;
        test.segment.force[from + k] -= left;
        let independent = noise * noise / test.independence.max(1e-3);
        test.allowed[k] = (test.allowed[k].powi(2) + independent).sqrt();
    }
    test.mean_noise = libm::hypot(test.mean_noise, noise);
    count
}

/// Largest logarithmic distance of two motions, in speed and amplitude, at which their form errors count as similar.
/// The value corresponds to a factor of two in both speed and amplitude.
const ALIKE: f64 = 0.98;

/// Returns the logarithmic distance of two motions in speed and amplitude. Returns `None` if one has no cycles, or if
/// they differ too much in mean displacement or side force.
fn distance(a: &At, b: &At) -> Option<f64> {
    let speed = |at: &At| at.amplitude * at.frequency;
    let is_comparable = a.frequency > 0.0
        && b.frequency > 0.0
        && (a.mean - b.mean).abs() <= 5.0 * SAME_PLACE * a.amplitude.max(b.amplitude)
        && (a.side - b.side).abs() <= SAME_SIDE;
    is_comparable.then(|| libm::hypot(libm::log(speed(a) / speed(b)), libm::log(a.amplitude / b.amplitude)))
}

/// Corrects each test by the residual of the model on the same test of the reference. Adds the noise of this residual
/// to the noise of the test.
///
/// If the reference does not contain the test, the correction uses the form error of the nearest motion. This error is
/// scaled with the ratio of the largest forces of the two tests. Half of this error counts as uncertain. A test without
/// a similar motion is not corrected. `residual` is measured minus computed force of every reference test, N.
pub fn without_shared_error(tests: Vec<Test>, reference: &[Test], residual: &[Vec<f64>]) -> Freed {
    let known: Vec<(At, Left, f64, f64)> = reference
        .iter()
        .zip(residual)
        .filter(|(test, _)| test.frequency > 0.0)
        .map(|(test, residual)| {
            let at = at(test);
            let left = Left::new(test, &at, residual);
            (at, left, test.mean_noise, test.segment.top)
        })
        .collect();
    let all: Vec<(&Test, &Vec<f64>)> = reference.iter().zip(residual).collect();
    let mut freed = Freed { tests: Vec::new(), missing: Vec::new(), shifted: Vec::new() };
    for mut test in tests {
        if test.frequency == 0.0 && without_error_of_road(&mut test, &all) > 0 {
            freed.tests.push(test);
            continue;
        }
        let own = at(&test);
        let mut same: Vec<&(At, Left, f64, f64)> = known.iter().filter(|(at, ..)| is_same(&own, at)).collect();
        let is_same = !same.is_empty();
        if !is_same {
            let near = known.iter().filter_map(|row| Some((distance(&own, &row.0)?, row)));
            let nearest = near.filter(|(d, _)| *d < ALIKE).min_by(|a, b| a.0.total_cmp(&b.0));
            match nearest {
                Some((_, row)) => {
                    freed.shifted.push(test.segment.name.clone());
                    same.push(row);
                }
                None => {
                    freed.missing.push(test.segment.name.clone());
                    freed.tests.push(test);
                    continue;
                }
            }
        }
        // Several repetitions of a test in the reference reduce the noise of the correction.
        let count = same.len() as f64;
        let noise = same.iter().map(|(_, _, noise, _)| noise * noise).sum::<f64>().sqrt() / count;
        let from = test.segment.from;
        let inputs: Vec<Input> = test.segment.input.clone();
        for (k, input) in inputs.iter().enumerate() {
            let phase = phase(input, &own);
            let scale = |top: f64| if is_same { 1.0 } else { test.segment.top / top.max(1e-9) };
            let left = same.iter().map(|(_, left, _, top)| scale(*top) * left.at(phase)).sum::<f64>() / count;
            let uncertain = if is_same { 0.0 } else { 0.5 * left };
            test.segment.force[k] -= left;
            if let Some(allowed) = k.checked_sub(from).and_then(|k| test.allowed.get_mut(k)) {
                let independent = noise * noise / test.independence.max(1e-3);
                *allowed = (*allowed * *allowed + independent + uncertain * uncertain).sqrt();
            }
        }
        test.mean_noise = libm::hypot(test.mean_noise, noise);
        freed.tests.push(test);
    }
    freed.missing.sort();
    freed.missing.dedup();
    freed
}

#[cfg(test)]
mod tests {
    use super::*;
    use dashpot_estimation::segment::Segment;

    fn sine(amplitude: f64, frequency: f64, start: f64, force: impl Fn(f64) -> f64) -> Test {
        let n = 100;
        let angle = |k: usize| start + TAU * k as f64 / n as f64;
        let input = (0..n)
            .map(|k| Input::motion(amplitude * libm::sin(angle(k)), amplitude * TAU * frequency * libm::cos(angle(k))))
            .collect();
        Test {
            record: 0,
            segment: Segment {
                name: format!("{amplitude} {frequency}"),
                dt: vec![1.0 / (frequency * n as f64); n],
                input,
                setting: None,
                force: (0..n).map(|k| force(angle(k))).collect(),
                from: 0,
                scale: 1.0,
                top: 100.0,
                peak_velocity: amplitude * TAU * frequency,
                amplitude,
                clock: 0.0,
            },
            allowed: vec![1.0; n],
            mean_noise: 1.0,
            independence: 1.0,
            growth: 0.0,
            noise_freedom: 100.0,
            frequency,
            weight: 1.0,
        }
    }

    #[test]
    fn what_both_share_goes_from_the_same_road_alone() {
        let road = |force: &dyn Fn(f64) -> f64| Test { frequency: 0.0, ..sine(0.01, 2.0, 0.3, force) };
        let shared = |angle: f64| 20.0 * libm::sin(2.0 * angle);
        let good = road(&shared);
        let residual = vec![good.segment.force.clone()];
        let worn = road(&|angle| shared(angle) + 7.0);
        let other = Test { frequency: 0.0, ..sine(0.01, 2.0, 1.3, shared) };
        let freed = without_shared_error(vec![worn, other], &[good], &residual);
        assert_eq!((freed.missing, freed.shifted), (vec!["0.01 2".to_owned()], vec![]));
        assert!(freed.tests[0].segment.force.iter().all(|force| (force - 7.0).abs() < 1e-9));
        assert!((freed.tests[0].allowed[0] - 2f64.sqrt()).abs() < 1e-12);
        assert_eq!(freed.tests[1].allowed[0], 1.0);
    }

    #[test]
    fn what_both_share_goes_whatever_the_phase_at_which_a_cycle_begins_and_what_has_no_counterpart_is_told() {
        let shared = |angle: f64| 20.0 * libm::sin(2.0 * angle);
        let good = sine(0.01, 2.0, 0.3, shared);
        let residual = vec![good.segment.force.clone()];
        let worn = sine(0.01, 2.0, 4.1, |angle| shared(angle) + 7.0);
        let other = sine(0.02, 2.0, 0.0, shared);
        let far = sine(0.05, 2.0, 0.0, shared);
        let freed = without_shared_error(vec![worn, other, far], &[good], &residual);
        assert_eq!(
            (freed.tests.len(), freed.missing, freed.shifted),
            (3, vec!["0.02 2".to_owned(), "0.05 2".to_owned()], vec![])
        );
        for force in &freed.tests[0].segment.force {
            assert!((force - 7.0).abs() < 0.05, "{force}");
        }
        assert!((freed.tests[0].mean_noise - 2f64.sqrt()).abs() < 1e-12);
    }
}
