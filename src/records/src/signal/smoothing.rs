//! Removes measurement noise from the recorded motion before the motion drives a model.
//!
//! A stiff series spring converts micrometers of displacement noise into newtons, so raw channels must not drive a
//! model. Displacement and velocity are two noisy measurements of one smooth motion. The estimator is the
//! Rauch–Tung–Striebel smoother for a constant-acceleration model with white jerk (AIAA J. 3, 1965). The noise of the
//! channels determines the amount of smoothing. Noise-free channels stay nearly unchanged.

use crate::Record;
use nalgebra::{Matrix2, Matrix2x3, Matrix3, Vector2, Vector3};
use std::f64::consts::TAU;

/// Consistent displacement, velocity and acceleration of a record's motion at its samples.
#[derive(Debug, Clone)]
pub struct Motion {
    /// Displacement, m.
    pub displacement: Vec<f64>,
    /// Velocity, m/s.
    pub velocity: Vec<f64>,
    /// Acceleration, m/s².
    pub acceleration: Vec<f64>,
    /// Standard deviation of the noise found in the displacement channel, m.
    pub displacement_noise: f64,
    /// Standard deviation of the noise found in the velocity channel, m/s.
    pub velocity_noise: f64,
}

/// Estimates the standard deviation of the white noise of a smooth channel, in its unit, from the median absolute
/// fourth difference. With forty samples per cycle, the fourth differences of the motion itself nearly vanish. Returns
/// 0 for fewer than five samples.
pub(crate) fn channel_noise(y: &[f64]) -> f64 {
    let mut d: Vec<f64> = y.windows(5).map(|w| (w[0] - 4.0 * w[1] + 6.0 * w[2] - 4.0 * w[3] + w[4]).abs()).collect();
    if d.is_empty() {
        return 0.0;
    }
    let middle = d.len() / 2;
    let (_, median, _) = d.select_nth_unstable_by(middle, f64::total_cmp);
    // √70 is the gain of the fourth difference for white noise. 0.6745 is the median of |N(0, 1)|.
    *median / (0.6745 * 70f64.sqrt())
}

/// Smooths the motion of a record.
pub fn smooth(record: &Record) -> Motion {
    let (t, x, v) = (&record.time, &record.displacement, &record.velocity);
    let n = t.len();
    let (sx, sv) = (channel_noise(x), channel_noise(v));
    let w = if record.frequency > 0.0 {
        TAU * record.frequency
    } else {
        // If there are no cycles, use the frequency of a sine with the amplitude and peak velocity of the record.
        (record.peak_velocity / record.amplitude.max(1e-9)).max(1.0)
    };
    let peak = record.peak_velocity.max(1e-9);
    // Lower limits of the noise, so that the covariances stay regular. They are far below the noise of any sensor.
    let rx = (sx.max(1e-9 * peak / w)).powi(2);
    let rv = (sv.max(1e-9 * peak)).powi(2);
    // Spectral density, m²/s⁵, of the jerk of a sine with this peak velocity and the angular frequency `w`, rad/s. It
    // is the squared amplitude of the jerk times a correlation time of 1/`w`.
    let q = peak * peak * w.powi(3);
    let h = Matrix2x3::new(1.0, 0.0, 0.0, 0.0, 1.0, 0.0);
    let r = Matrix2::new(rx, 0.0, 0.0, rv);
    let mut mean: Vector3<f64> = Vector3::new(x[0], v[0], 0.0);
    let mut cov = Matrix3::from_diagonal(&Vector3::new(rx, rv, (peak * w).powi(2)));
    let mut filtered = Vec::with_capacity(n);
    let mut predicted = Vec::with_capacity(n);
    for i in 0..n {
        if i > 0 {
            let (a, noise) = transition(t[i] - t[i - 1], q);
            mean = a * mean;
            cov = a * cov * a.transpose() + noise;
        }
        predicted.push((mean, cov));
        let innovation = Vector2::new(x[i], v[i]) - h * mean;
        let s = h * cov * h.transpose() + r;
        if let Some(inverse) = s.try_inverse() {
            let gain = cov * h.transpose() * inverse;
            mean += gain * innovation;
            let keep = Matrix3::identity() - gain * h;
            // Joseph's form keeps the covariance symmetric and positive despite rounding.
            cov = keep * cov * keep.transpose() + gain * r * gain.transpose();
        }
        filtered.push((mean, cov));
    }
    let mut displacement = vec![0.0; n];
    let mut velocity = vec![0.0; n];
    let mut acceleration = vec![0.0; n];
    let (mut mean, _) = filtered[n - 1];
    (displacement[n - 1], velocity[n - 1], acceleration[n - 1]) = (mean[0], mean[1], mean[2]);
    for i in (0..n - 1).rev() {
        let (a, _) = transition(t[i + 1] - t[i], q);
        let (forward, cov) = filtered[i];
        let (ahead, ahead_cov) = predicted[i + 1];
        mean = match ahead_cov.try_inverse() {
            Some(inverse) => forward + cov * (a.transpose() * (inverse * (mean - ahead))),
            None => forward,
        };
        (displacement[i], velocity[i], acceleration[i]) = (mean[0], mean[1], mean[2]);
    }
    Motion { displacement, velocity, acceleration, displacement_noise: sx, velocity_noise: sv }
}

/// Returns the transition matrix of displacement, velocity and acceleration over the time `dt`, s. Also returns the
/// covariance that white jerk of spectral density `q`, m²/s⁵, adds in this time.
fn transition(dt: f64, q: f64) -> (Matrix3<f64>, Matrix3<f64>) {
    let (d2, d3) = (dt * dt, dt * dt * dt);
    let a = Matrix3::new(1.0, dt, 0.5 * d2, 0.0, 1.0, dt, 0.0, 0.0, 1.0);
    let noise = Matrix3::new(
        d3 * d2 / 20.0,
        d2 * d2 / 8.0,
        d3 / 6.0,
        d2 * d2 / 8.0,
        d3 / 3.0,
        d2 / 2.0,
        d3 / 6.0,
        d2 / 2.0,
        dt,
    ) * q;
    (a, noise)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sine(noise: f64) -> (Record, Vec<f64>, Vec<f64>) {
        let (a, f) = (0.005, 8.0);
        let w = TAU * f;
        let time: Vec<f64> = (0..800).map(|i| i as f64 * 1e-3).collect();
        let x: Vec<f64> = time.iter().map(|t| a * libm::sin(w * t)).collect();
        let v: Vec<f64> = time.iter().map(|t| a * w * libm::cos(w * t)).collect();
        // A fixed pseudo-random sequence makes the test deterministic.
        let mut seed = 1u64;
        let mut random = || {
            seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            (seed >> 11) as f64 / (1u64 << 52) as f64 - 1.0
        };
        let record = Record {
            displacement: x.iter().map(|x| x + noise * a * random()).collect(),
            velocity: v.iter().map(|v| v + noise * a * w * random()).collect(),
            time,
            amplitude: a,
            frequency: f,
            peak_velocity: a * w,
            ..Record::default()
        };
        (record, x, v)
    }

    fn rms(a: &[f64], b: &[f64]) -> f64 {
        (a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum::<f64>() / a.len() as f64).sqrt()
    }

    #[test]
    fn clean_channels_come_back() {
        let (record, x, v) = sine(0.0);
        let m = smooth(&record);
        assert!(rms(&m.displacement, &x) < 1e-5 * 0.005);
        assert!(rms(&m.velocity, &v) < 1e-4 * record.peak_velocity);
    }

    #[test]
    fn noise_is_reduced_and_its_size_known() {
        let (record, x, v) = sine(0.002);
        let m = smooth(&record);
        let before = rms(&record.displacement, &x);
        assert!((m.displacement_noise / before - 1.0).abs() < 0.2);
        // The velocity channel reduces the displacement noise strongly. The displacement channel reduces the velocity
        // noise only a little.
        assert!(rms(&m.displacement, &x) < 0.3 * before);
        assert!(rms(&m.velocity, &v) < 0.95 * rms(&record.velocity, &v));
    }
}
