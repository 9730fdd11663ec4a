//! The actuator's motion during one test: standstill, ramp up, whole cycles at full amplitude, ramp down, standstill.

use std::f64::consts::TAU;

use crate::TestPoint;
use crate::draw::Draw;

/// Duration of the standstill before and after the motion, s.
const REST_S: f64 = 0.25;
/// Shortest ramp of the amplitude, s. At 25 Hz, this ramp takes several cycles, because an actuator does not reach the
/// amplitude within one cycle.
const SHORTEST_RAMP_S: f64 = 0.3;
/// Frequency, Hz, below which the ramp of the amplitude lasts only half a cycle. It then takes at least ten seconds.
const SLOW_FREQUENCY_HZ: f64 = 0.05;
/// Shortest and longest standstill in a test of a short campaign, s. Within these limits, the standstill is a quarter
/// cycle.
const BRIEF_REST_S: (f64, f64) = (0.03, 0.25);
const BRIEF_RAMP_S: f64 = 0.08;

/// The motion of the actuator in one test.
#[derive(Debug, Clone)]
pub struct Drive {
    mean: f64,
    amplitude: f64,
    omega: f64,
    ramp: f64,
    rest: f64,
    /// Start and end of the whole cycles at full amplitude, s since the start of the test.
    full: (f64, f64),
    road: Option<Road>,
}

/// Displacement and its derivatives at one instant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct KinematicState {
    pub displacement_m: f64,
    pub velocity_m_s: f64,
    pub acceleration_m_s2: f64,
}

impl Drive {
    pub fn new(point: &TestPoint) -> Self {
        let period = 1.0 / point.frequency_hz;
        let ramp = if point.frequency_hz < SLOW_FREQUENCY_HZ {
            0.5 * period
        } else {
            period * (SHORTEST_RAMP_S / period).ceil().max(1.0)
        };
        Self::with(point, REST_S, ramp)
    }

    /// Makes the motion of a test with short standstills and ramps, for short campaigns.
    pub fn brief(point: &TestPoint) -> Self {
        let period = 1.0 / point.frequency_hz;
        let ramp = if point.frequency_hz < 2.0 * SLOW_FREQUENCY_HZ {
            0.5 * period
        } else {
            period * (BRIEF_RAMP_S / period).ceil().max(1.0)
        };
        Self::with(point, (0.25 * period).clamp(BRIEF_REST_S.0, BRIEF_REST_S.1), ramp)
    }

    fn with(point: &TestPoint, rest: f64, ramp: f64) -> Self {
        let start = rest + ramp;
        let end = start + f64::from(point.cycles) / point.frequency_hz;
        Self {
            mean: point.mean_displacement_m,
            amplitude: point.amplitude_m,
            omega: TAU * point.frequency_hz,
            ramp,
            rest,
            full: (start, end),
            road: point.road_seed.map(|seed| Road::new(seed, point, start..end)),
        }
    }

    /// Returns the duration of the test, s, including both standstills.
    pub fn duration_s(&self) -> f64 {
        self.full.1 + self.ramp + self.rest
    }

    /// Returns the start and end time of the whole cycles at full amplitude, s. In a sine test, the displacement is at
    /// its mean and increases at both times.
    pub fn full_cycles_s(&self) -> (f64, f64) {
        self.full
    }

    /// Computes displacement (m) and velocity (m/s) at a time (s).
    pub fn motion(&self, time: f64) -> (f64, f64) {
        let motion = self.motion_with_acceleration(time);
        (motion.displacement_m, motion.velocity_m_s)
    }

    /// Computes displacement (m), velocity (m/s) and acceleration (m/s²) at a time (s).
    pub fn motion_with_acceleration(&self, time: f64) -> KinematicState {
        let (start, end) = self.full;
        let (envelope, rate, curvature) = if time < start {
            let (value, slope, bend) = smooth_step((time - (start - self.ramp)) / self.ramp);
            (value, slope / self.ramp, bend / (self.ramp * self.ramp))
        } else if time <= end {
            (1.0, 0.0, 0.0)
        } else {
            let (value, slope, bend) = smooth_step((time - end) / self.ramp);
            (1.0 - value, -slope / self.ramp, -bend / (self.ramp * self.ramp))
        };
        let (shape, shape_rate, shape_curvature) = match &self.road {
            None => {
                let (sin, cos) = libm::sincos(self.omega * (time - start));
                (sin, self.omega * cos, -self.omega * self.omega * sin)
            }
            Some(road) => road.shape(time),
        };
        KinematicState {
            displacement_m: self.mean + self.amplitude * envelope * shape,
            velocity_m_s: self.amplitude * (rate * shape + envelope * shape_rate),
            acceleration_m_s2: self.amplitude
                * (curvature * shape + 2.0 * rate * shape_rate + envelope * shape_curvature),
        }
    }
}

/// A random motion with the spectrum of wheel travel on a road, as a sum of sines relative to the amplitude of the
/// test.
#[derive(Debug, Clone)]
struct Road {
    /// Relative amplitude, angular frequency (rad/s) and phase (rad) of each sine component.
    waves: Vec<[f64; 3]>,
}

impl Road {
    const WAVES: usize = 24;
    /// Lowest and highest frequency of the components, Hz: from body motion to above the wheel resonance.
    const BAND_HZ: (f64, f64) = (0.4, 16.0);

    fn new(seed: u64, point: &TestPoint, full: std::ops::Range<f64>) -> Self {
        let mut draw = Draw::new(seed, "road");
        let (low, high) = Self::BAND_HZ;
        let mut waves: Vec<[f64; 3]> = (0..Self::WAVES)
            .map(|index| {
                let place = (index as f64 + draw.unit()) / Self::WAVES as f64;
                let hz = low * libm::pow(high / low, place);
                // Displacement amplitudes fall with f^-1.2, where f is the frequency, so velocity amplitudes fall only
                // with f^-0.2. Both fall faster above 12 Hz, near the wheel resonance.
                let size = libm::pow(hz, -1.2) / (1.0 + (hz / 12.0).powi(4)).sqrt();
                [size, TAU * hz, TAU * draw.unit()]
            })
            .collect();
        let road = Self { waves: waves.clone() };
        let (mut travel, mut velocity) = (0f64, 0f64);
        for step in 0..4000 {
            let (x, v, _) = road.shape(full.start + (full.end - full.start) * f64::from(step) / 4000.0);
            travel = travel.max(x.abs());
            velocity = velocity.max(v.abs());
        }
        let share = (1.0 / travel).min(point.peak_velocity_m_s / (point.amplitude_m * velocity));
        for wave in &mut waves {
            wave[0] *= share;
        }
        Self { waves }
    }

    fn shape(&self, time: f64) -> (f64, f64, f64) {
        self.waves.iter().fold((0.0, 0.0, 0.0), |(x, v, a), [size, omega, phase]| {
            let (sin, cos) = libm::sincos(omega * time + phase);
            (x + size * sin, v + size * omega * cos, a - size * omega * omega * sin)
        })
    }
}

/// Computes a smooth step from 0 to 1, with its first and second derivative by `share`, the fraction of its duration.
/// Both derivatives are continuous.
fn smooth_step(share: f64) -> (f64, f64, f64) {
    let s = share.clamp(0.0, 1.0);
    (
        s * s * s * (10.0 + s * (6.0 * s - 15.0)),
        30.0 * s * s * (1.0 - s) * (1.0 - s),
        60.0 * s * (1.0 - s) * (1.0 - 2.0 * s),
    )
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
