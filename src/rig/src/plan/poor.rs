//! Incomplete plans that occur on real rigs.

use super::diagnosis::{sine, tests};
use crate::TestPoint;

const SLOW_M_S: f64 = 0.05;

/// Makes eight sines about mid-stroke with an amplitude of 25 mm.
pub(super) fn one_amplitude() -> Vec<TestPoint> {
    [0.07, 0.3, 0.8, 1.25, 2.5, 5.0, 7.5, 10.0].map(|hz| sine((25.0, hz, 0.0, 0.0))).into()
}

/// Makes eight sines about mid-stroke at 2 Hz.
pub(super) fn one_frequency() -> Vec<TestPoint> {
    [0.3, 1.0, 3.0, 8.0, 15.0, 25.0, 40.0, 50.0].map(|mm| sine((mm, 2.0, 0.0, 0.0))).into()
}

pub(super) fn without_slow_tests() -> Vec<TestPoint> {
    tests().into_iter().filter(|test| test.peak_velocity_m_s >= SLOW_M_S).collect()
}

pub(super) fn centred() -> Vec<TestPoint> {
    tests().into_iter().filter(|test| test.mean_displacement_m == 0.0).collect()
}

pub(super) fn without_side_force() -> Vec<TestPoint> {
    tests().into_iter().filter(|test| test.side_force_n == 0.0).collect()
}
