//! Force at peak velocity: the points of a damper's FV diagram (PVP, peak velocity pick-off).

use dashpot_records::{Record, smoothing};
use serde::{Deserialize, Serialize};

/// Fraction of a stroke's highest velocity above which a sample counts as being at peak velocity.
///
/// On a sine, these samples lie within 11.5° of the peak, which is two or three samples even at forty samples per cycle. Within these
/// samples, a smooth curve changes its force by less than 2 %.
const AT_PEAK: f64 = 0.98;

/// Fraction of the samples of a cycle that lie above the level by which [`highest`] limits the highest velocity.
///
/// It is half the fraction of a sine at peak velocity, so that level is 0.995 of the peak of a sine. A lower fraction would let the noise
/// of the samples beside the corners of a fast triangular motion count as its velocity.
///
/// Test: `the_speed_of_a_triangle_is_not_that_of_its_corners`.
const ABOVE_LEVEL: f64 = 0.032;

/// Largest ratio of the highest velocity to the level of [`ABOVE_LEVEL`].
///
/// For a sine of at least forty samples per cycle, the ratio is between 1.005 and 1.013. The limit therefore changes the samples at the
/// peaks of a sine only if the noise raises the highest sample.
///
/// Test: `the_speed_of_a_triangle_is_not_that_of_its_corners`.
const ABOVE: f64 = 1.01;

/// Force at the peak velocity of one stroke of a test, mean over its whole cycles.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Peak {
    /// Velocity, m/s, rebound positive. It is the mean of the samples at peak velocity, so it lies slightly below the highest velocity.
    pub velocity_m_s: f64,
    /// Force, N, tension positive.
    pub force_n: f64,
}

/// Indices of the samples at peak velocity, in both strokes.
#[derive(Debug, Clone)]
pub struct AtPeak {
    /// Smoothed velocity, m/s.
    velocity: Vec<f64>,
    rebound: Vec<usize>,
    compression: Vec<usize>,
}

impl AtPeak {
    /// Finds the samples at peak velocity. Returns `None` if the record has no whole cycles, or if it does not move in both directions.
    pub fn find(record: &Record) -> Option<Self> {
        if record.cycles.is_empty() {
            return None;
        }
        let velocity = smoothing::smooth(record).velocity;
        // The first cycle may still be transient, so it is skipped if there are more than two.
        let settled = &record.cycles[usize::from(record.cycles.len() > 2)..];
        let stroke = |sign: f64| -> Vec<usize> {
            let samples = settled.iter().flat_map(|cycle| {
                let top = highest(cycle.clone().map(|i| sign * velocity[i]).collect());
                let velocity = &velocity;
                cycle.clone().filter(move |i| top > 0.0 && sign * velocity[*i] >= AT_PEAK * top)
            });
            samples.collect()
        };
        let (rebound, compression) = (stroke(1.0), stroke(-1.0));
        (!rebound.is_empty() && !compression.is_empty()).then_some(Self { velocity, rebound, compression })
    }

    /// Returns the peaks of a force in rebound and in compression, in this order. `force` contains the force at the record's samples, N.
    pub fn pick(&self, force: &[f64]) -> [Peak; 2] {
        let mean = |samples: &[usize], of: &[f64]| samples.iter().map(|i| of[*i]).sum::<f64>() / samples.len() as f64;
        [&self.rebound, &self.compression]
            .map(|samples| Peak { velocity_m_s: mean(samples, &self.velocity), force_n: mean(samples, force) })
    }
}

/// Returns the highest velocity, m/s, of the velocities of one cycle; 0 if none is positive.
///
/// It is the maximum of a smooth motion. If single samples rise above the others by more than those of a sine, the maximum is the noise of
/// these samples. Then the returned velocity is the level that [`ABOVE_LEVEL`] of the samples exceed, times [`ABOVE`].
fn highest(mut velocities: Vec<f64>) -> f64 {
    velocities.sort_by(|a, b| b.total_cmp(a));
    let at = (ABOVE_LEVEL * velocities.len() as f64) as usize;
    match (velocities.first(), velocities.get(at)) {
        (Some(&top), Some(&level)) => top.min(ABOVE * level).max(0.0),
        _ => 0.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_noisy_sine_gives_the_force_of_the_curve_at_its_peaks() {
        let (n, cycles, w) = (400, 5, 10.0_f64);
        let mut record = Record { frequency: w / std::f64::consts::TAU, peak_velocity: 0.5, ..Record::default() };
        record.cycles = (0..cycles).map(|c| n * c..n * (c + 1)).collect();
        for i in 0..n * cycles {
            let phase = std::f64::consts::TAU * i as f64 / n as f64;
            let noise = ((i * 7919) % 101) as f64 / 101.0 - 0.5;
            record.time.push(phase / w);
            record.displacement.push(0.05 * libm::sin(phase));
            record.velocity.push(0.5 * libm::cos(phase) + 0.01 * noise);
            // The force has a hysteresis loop about the curve. The mean of the loop is zero, because the samples lie on both sides of the
            // peak.
            let force = if libm::cos(phase) > 0.0 { 2000.0 } else { 800.0 } * 0.5 * libm::cos(phase);
            record.force.push(force + 60.0 * libm::sin(phase) + 20.0 * noise);
        }
        let [rebound, compression] = AtPeak::find(&record).unwrap().pick(&record.force);
        assert!((rebound.velocity_m_s - 0.4965).abs() < 2e-3, "{rebound:?}");
        assert!((rebound.force_n - 2000.0 * rebound.velocity_m_s).abs() < 5.0, "{rebound:?}");
        assert!((compression.force_n - 800.0 * compression.velocity_m_s).abs() < 5.0, "{compression:?}");
        record.cycles.clear();
        assert!(AtPeak::find(&record).is_none());
    }

    /// Checks a triangular motion whose velocity overshoots by a tenth in the first sample after each corner.
    #[test]
    fn the_speed_of_a_triangle_is_not_that_of_its_corners() {
        let (n, cycles, speed) = (150, 3, 0.4);
        let mut record = Record { frequency: 1.0 / 0.3, peak_velocity: speed, ..Record::default() };
        record.cycles = (0..cycles).map(|c| n * c..n * (c + 1)).collect();
        let mut place = 0.0;
        for i in 0..n * cycles {
            let phase = i % (n / 2);
            let sign = if i % n < n / 2 { 1.0 } else { -1.0 };
            let overshoot = if phase == 0 { 1.1 } else { 1.0 };
            record.time.push(0.002 * i as f64);
            record.velocity.push(sign * speed * overshoot);
            record.displacement.push(place);
            // Beside a corner, the force is not yet that of the speed.
            record.force.push(sign * if phase == 0 { 500.0 } else { 650.0 });
            place += 0.002 * sign * speed;
        }
        for peak in AtPeak::find(&record).unwrap().pick(&record.force) {
            assert!((peak.velocity_m_s.abs() - speed).abs() < 0.01 * speed, "{peak:?}");
            assert!((peak.force_n.abs() - 650.0).abs() < 10.0, "{peak:?}");
        }
        // The highest of the samples of a sine counts, at any phase of the samples.
        for shift in 0..10 {
            let velocity = |i: i32| libm::cos(std::f64::consts::TAU * (f64::from(i) + 0.1 * f64::from(shift)) / 40.0);
            let samples: Vec<f64> = (0..40).map(velocity).collect();
            let top = samples.iter().copied().fold(0.0, f64::max);
            assert!(highest(samples) > 0.997 * top, "{shift}");
        }
    }
}
