//! The actuator's motion during one test: rest, ramp up, whole cycles at full amplitude, ramp down, rest.

use std::f64::consts::TAU;

use crate::TestPoint;

/// Rest before the motion and after it, s.
const REST_S: f64 = 0.25;
/// A ramp lasts whole cycles, but not less than this, s: an actuator does not start at 25 Hz in one cycle.
const SHORTEST_RAMP_S: f64 = 0.3;
/// Tests slower than this ramp over half a cycle only, Hz: half a cycle takes ten seconds and more.
const SLOW_FREQUENCY_HZ: f64 = 0.05;

/// The motion of one test.
#[derive(Debug, Clone)]
pub struct Drive {
    mean: f64,
    amplitude: f64,
    omega: f64,
    ramp: f64,
    /// Start and end of the whole cycles at full amplitude.
    full: (f64, f64),
}

impl Drive {
    pub fn new(point: &TestPoint) -> Self {
        let period = 1.0 / point.frequency_hz;
        let ramp = if point.frequency_hz < SLOW_FREQUENCY_HZ {
            0.5 * period
        } else {
            period * (SHORTEST_RAMP_S / period).ceil().max(1.0)
        };
        let start = REST_S + ramp;
        Self {
            mean: point.mean_displacement_m,
            amplitude: point.amplitude_m,
            omega: TAU * point.frequency_hz,
            ramp,
            full: (start, start + f64::from(point.cycles) * period),
        }
    }

    /// Time at which the rig is at rest again for good, s.
    pub fn duration_s(&self) -> f64 {
        self.full.1 + self.ramp + REST_S
    }

    /// First and last time of the whole cycles at full amplitude, s. They begin and end at the mean displacement, extending.
    pub fn full_cycles_s(&self) -> (f64, f64) {
        self.full
    }

    /// Displacement (m) and velocity (m/s) at a time (s).
    pub fn motion(&self, time: f64) -> (f64, f64) {
        let (start, end) = self.full;
        let (envelope, envelope_rate) = if time < start {
            let (value, slope) = smooth_step((time - (start - self.ramp)) / self.ramp);
            (value, slope / self.ramp)
        } else if time <= end {
            (1.0, 0.0)
        } else {
            let (value, slope) = smooth_step((time - end) / self.ramp);
            (1.0 - value, -slope / self.ramp)
        };
        let (sin, cos) = (self.omega * (time - start)).sin_cos();
        (
            self.mean + self.amplitude * envelope * sin,
            self.amplitude * (envelope_rate * sin + envelope * self.omega * cos),
        )
    }
}

/// From 0 to 1 with no jump in velocity or acceleration, and its slope.
fn smooth_step(share: f64) -> (f64, f64) {
    let s = share.clamp(0.0, 1.0);
    (s * s * s * (10.0 + s * (6.0 * s - 15.0)), 30.0 * s * s * (1.0 - s) * (1.0 - s))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Matrix;

    #[test]
    fn whole_cycles_reach_amplitude_and_peak_velocity() {
        for point in Matrix::default().points() {
            let drive = Drive::new(point);
            let (start, end) = drive.full_cycles_s();
            let period = 1.0 / point.frequency_hz;
            assert!(((end - start) / period - f64::from(point.cycles)).abs() < 1e-9);
            for time in [start, end] {
                let (x, v) = drive.motion(time);
                assert!(x.abs() < 1e-9 && (v - point.peak_velocity_m_s).abs() < 1e-9);
            }
            let (x, v) = drive.motion(start + 0.25 * period);
            assert!((x - point.amplitude_m).abs() < 1e-9 && v.abs() < 1e-9);
        }
    }

    #[test]
    fn rests_at_the_mean_and_never_overshoots() {
        for point in Matrix::default().points() {
            let point = TestPoint { mean_displacement_m: 0.01, ..point.clone() };
            let drive = Drive::new(&point);
            let end = drive.duration_s();
            for time in [0.0, 0.5 * REST_S, end - 0.5 * REST_S, end] {
                assert_eq!(drive.motion(time), (0.01, 0.0));
            }
            for i in 0..=4000 {
                let (x, v) = drive.motion(end * f64::from(i) / 4000.0);
                assert!((x - 0.01).abs() <= point.amplitude_m * (1.0 + 1e-9));
                assert!(v.abs() <= 1.1 * point.peak_velocity_m_s, "{}: {v}", point.name);
            }
        }
    }

    #[test]
    fn velocity_is_the_slope_of_displacement() {
        let drive = Drive::new(&Matrix::default().points()[6]);
        let h = 1e-6;
        for i in 1..2000 {
            let t = drive.duration_s() * f64::from(i) / 2000.0;
            let slope = (drive.motion(t + h).0 - drive.motion(t - h).0) / (2.0 * h);
            assert!((slope - drive.motion(t).1).abs() < 1e-5);
        }
    }
}
