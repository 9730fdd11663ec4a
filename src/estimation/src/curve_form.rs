//! Error of the FV curve between its points, estimated from the records.
//!
//! A cubic through a dozen points on each stroke rounds the knee of a valve. The fit moves the points near the knee so
//! that the curve between them is closest to the records. The confidence intervals of these points contain the true
//! force only if they include the error of the curve.

use crate::samples::Test;

/// Number of parts into which each interval between two points is divided. Without parts, an error that changes its
/// sign within an interval would cancel in the mean residual of the interval.
const PARTS: usize = 2;
/// Number of standard errors of a mean residual that count as noise.
const NOISE: f64 = 2.0;

/// Sums for a weighted mean of the residuals of a fit, N, and for its variance.
#[derive(Debug, Clone, Copy, Default)]
struct Mean {
    sum: f64,
    weight: f64,
    /// Sum over the tests of the variance of each test's weighted sum of residuals.
    variance: f64,
}

impl Mean {
    /// Returns the part of the mean that noise does not explain, N.
    fn beyond_noise(&self) -> f64 {
        if self.weight <= 0.0 {
            return 0.0;
        }
        let (mean, noise) = (self.sum / self.weight, NOISE * self.variance.sqrt() / self.weight);
        (mean * mean - noise * noise).max(0.0).sqrt()
    }
}

/// Computes the error of a curve, N, at each of its points; `velocities` are the velocities of the points, m/s. The
/// error at a point is the largest error in the parts of the two neighboring intervals. An interval has two parts.
///
/// `residual` contains the residuals of a fit at the scored samples of all tests, in units of their allowed errors.
/// Samples have the weights that they have in the fit. Hysteresis is not an error of the curve, because its residuals
/// during acceleration and deceleration cancel in the mean.
pub fn misses(velocities: &[f64], tests: &[Test], residual: &[f64]) -> Vec<f64> {
    let mut parts = vec![Mean::default(); velocities.len().saturating_sub(1) * PARTS];
    let mut first = 0;
    for test in tests {
        // Sums of weighted residuals of this test alone, because its fraction of independent samples applies only to
        // this test.
        let mut own = vec![(0.0, 0.0, 0.0); parts.len()];
        for (place, (input, allowed)) in test.inputs().iter().zip(&test.allowed).enumerate() {
            let Some(part) = part_of(velocities, input.velocity).filter(|_| allowed.is_finite()) else { continue };
            let weight = 1.0 / (allowed * allowed);
            let (sum, total, squares) = &mut own[part];
            *sum += weight * residual.get(first + place).copied().unwrap_or(0.0) * allowed;
            *total += weight;
            *squares += weight * weight;
        }
        let noise = test.mean_noise.powi(2) / test.independence.max(1e-9);
        for (part, (sum, total, squares)) in parts.iter_mut().zip(own) {
            part.sum += sum;
            part.weight += total;
            part.variance += squares * noise;
        }
        first += test.count();
    }
    (0..velocities.len())
        .map(|point| {
            let (from, to) = (point.saturating_sub(1) * PARTS, ((point + 1) * PARTS).min(parts.len()));
            parts.get(from..to).unwrap_or(&[]).iter().map(Mean::beyond_noise).fold(0.0, f64::max)
        })
        .collect()
}

/// Returns the index of the part that contains a velocity, m/s, counted over all intervals between points. Returns
/// `None` outside the points.
fn part_of(velocities: &[f64], at: f64) -> Option<usize> {
    let right = velocities.partition_point(|v| *v <= at);
    let (from, to) = (*velocities.get(right.checked_sub(1)?)?, *velocities.get(right)?);
    let part = (PARTS as f64 * (at - from) / (to - from)) as usize;
    Some((right - 1) * PARTS + part.min(PARTS - 1))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::hypothesis::Hypothesis;
    use crate::prior_set::PriorSet;
    use crate::sines::measured;
    use crate::vocabulary::base_numbers;
    use dashpot_core::Params;

    #[test]
    fn a_miss_shows_beside_its_points_and_noise_nowhere() {
        let base = Params::new();
        let of = Hypothesis { base, numbers: base_numbers(&base), heating: None, priors: PriorSet::default() };
        let tests = measured(&of, &[(0.01, 4.0), (0.02, 2.0)]);
        let velocities = [-0.3, -0.15, 0.0, 0.1, 0.2, 0.3];
        let samples: Vec<(f64, f64)> = tests
            .iter()
            .flat_map(|test| test.inputs().iter().zip(&test.allowed).map(|(input, allowed)| (input.velocity, *allowed)))
            .collect();
        // The residuals are ±1 allowed error with alternating signs.
        let noise: Vec<f64> = (0..samples.len()).map(|k| if k % 2 == 0 { 1.0 } else { -1.0 }).collect();
        assert_eq!(misses(&velocities, &tests, &noise), [0.0; 6]);
        // The model has an error of 20 N between 0.15 and 0.2 m/s, during acceleration and deceleration.
        let is_missed = |v: f64| (0.15..0.2).contains(&v);
        let missed: Vec<f64> =
            samples.iter().map(|(v, allowed)| if is_missed(*v) { 20.0 / allowed } else { 0.0 }).collect();
        let found = misses(&velocities, &tests, &missed);
        for (point, miss) in found.iter().enumerate() {
            let bounds_the_miss = point == 3 || point == 4;
            assert!(if bounds_the_miss { (18.0..=20.0).contains(miss) } else { *miss == 0.0 }, "{found:?}");
        }
    }
}
