//! Force at peak velocity: the points of a damper's FV diagram (PVP, peak velocity pick-off).

use dashpot_records::{Record, smoothing};
use serde::{Deserialize, Serialize};

/// Fraction of a stroke's highest velocity above which a sample counts as being at peak velocity.
///
/// On a sine, these samples lie within 11.5° of the peak, which is two or three samples even at forty samples per cycle. Within these
/// samples, a smooth curve changes its force by less than 2 %.
const AT_PEAK: f64 = 0.98;

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
                let top = cycle.clone().map(|i| sign * velocity[i]).fold(0.0, f64::max);
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
}
