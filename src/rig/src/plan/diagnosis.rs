//! The diagnosis plan: the smallest set of tests that distinguishes the effects of a damper.

use std::f64::consts::TAU;

use super::CHECK_PREFIX;
use crate::TestPoint;
use crate::draw::Draw;

/// Prefix of the names of the reference test, which is repeated to show drift.
pub(super) const REFERENCE: &str = "reference";
const REFERENCES: usize = 3;

/// Row of a plan: amplitude (mm), frequency (Hz), mean displacement (mm), side force (N).
type Row = (f64, f64, f64, f64);

const TRAINING: [Row; 31] = [
    // Slow tests show friction, gas and stops.
    (50.0, 0.05, 0.0, 0.0),
    (25.0, 0.07, 0.0, 0.0),
    (10.0, 0.05, 0.0, 0.0),
    (10.0, 0.2, 0.0, 0.0),
    // Small amplitudes show presliding, mount and play.
    (0.3, 0.1, 0.0, 0.0),
    (0.3, 1.0, 0.0, 0.0),
    (1.0, 0.1, 0.0, 0.0),
    (1.0, 1.0, 0.0, 0.0),
    (1.0, 10.0, 0.0, 0.0),
    (1.0, 25.0, 0.0, 0.0),
    (2.0, 5.0, 0.0, 0.0),
    (2.0, 25.0, 0.0, 0.0),
    (5.0, 1.0, 0.0, 0.0),
    (5.0, 5.0, 0.0, 0.0),
    (5.0, 25.0, 0.0, 0.0),
    (10.0, 2.0, 0.0, 0.0),
    (10.0, 8.0, 0.0, 0.0),
    (10.0, 25.0, 0.0, 0.0),
    // Long strokes show valves, stops and heat.
    (25.0, 0.5, 0.0, 0.0),
    (25.0, 3.0, 0.0, 0.0),
    (25.0, 6.0, 0.0, 0.0),
    (25.0, 10.0, 0.0, 0.0),
    (50.0, 0.4, 0.0, 0.0),
    (50.0, 1.5, 0.0, 0.0),
    (50.0, 5.0, 0.0, 0.0),
    // In the following tests, the mean position is off center, or side force acts.
    (10.0, 2.0, 25.0, 0.0),
    (10.0, 2.0, -25.0, 0.0),
    (25.0, 2.0, 25.0, 0.0),
    (25.0, 2.0, -25.0, 0.0),
    (25.0, 0.5, 0.0, 500.0),
    (25.0, 0.5, 0.0, 1000.0),
];

/// Tests for verification only (check tests), with amplitudes and velocities between those of the training tests.
const CHECKS: [Row; 11] = [
    (0.6, 2.0, 0.0, 0.0),
    (1.5, 18.0, 0.0, 0.0),
    (7.0, 22.0, 0.0, 0.0),
    (46.0, 0.6, 0.0, 0.0),
    (44.0, 4.2, 0.0, 0.0),
    (3.0, 8.0, 0.0, 0.0),
    (15.0, 3.0, 0.0, 0.0),
    (35.0, 2.2, 0.0, 0.0),
    (12.0, 4.0, 15.0, 0.0),
    (20.0, 2.5, -20.0, 0.0),
    (20.0, 0.8, 0.0, 750.0),
];

/// Road-like tests: limits of displacement (mm) and velocity (m/s), mean displacement (mm), side force (N).
const ROADS: [Row; 3] = [(18.0, 0.5, 0.0, 0.0), (30.0, 1.1, 8.0, 0.0), (14.0, 0.8, -12.0, 300.0)];
/// Approximate duration of a road-like test, s.
const ROAD_S: f64 = 4.0;

/// Returns the reference tests, training tests and check tests of the diagnosis plan, before shuffling.
pub(super) fn tests() -> Vec<TestPoint> {
    let mut tests: Vec<TestPoint> = (1..=REFERENCES)
        .map(|number| TestPoint { name: format!("{REFERENCE}_{number}"), ..sine((25.0, 1.25, 0.0, 0.0)) })
        .collect();
    tests.extend(TRAINING.into_iter().map(sine));
    tests.extend(CHECKS.into_iter().map(|row| {
        let test = sine(row);
        TestPoint { name: format!("{CHECK_PREFIX}{}", test.name), ..test }
    }));
    tests.extend(ROADS.into_iter().zip(1..).map(|((limit_mm, limit_m_s, mean_mm, side_force_n), number)| {
        let test = TestPoint::at_peak_velocity(format!("{CHECK_PREFIX}road_{number}"), limit_mm * 1e-3, limit_m_s);
        TestPoint {
            mean_displacement_m: mean_mm * 1e-3,
            side_force_n,
            cycles: (ROAD_S * test.frequency_hz).round() as u32,
            road_seed: Some(number),
            ..test
        }
    }));
    tests
}

/// Makes a test with three cycles of a sine from a row of a plan.
pub(super) fn sine((amplitude_mm, frequency_hz, mean_mm, side_force_n): Row) -> TestPoint {
    let amplitude_m = amplitude_mm * 1e-3;
    let mut name = format!("a{amplitude_mm}mm_f{frequency_hz}hz");
    if mean_mm != 0.0 {
        name += &format!("_{}{}mm", if mean_mm > 0.0 { "out" } else { "in" }, mean_mm.abs());
    }
    if side_force_n != 0.0 {
        name += &format!("_side{side_force_n}n");
    }
    TestPoint {
        frequency_hz,
        mean_displacement_m: mean_mm * 1e-3,
        side_force_n,
        cycles: 3,
        ..TestPoint::at_peak_velocity(name, amplitude_m, TAU * amplitude_m * frequency_hz)
    }
}

/// Shuffles the tests with the seed `order`, and places the reference tests at start, middle and end.
pub(super) fn shuffled(tests: Vec<TestPoint>, order: u64) -> Vec<TestPoint> {
    let (references, mut rest): (Vec<_>, Vec<_>) = tests.into_iter().partition(|test| test.name.starts_with(REFERENCE));
    let mut draw = Draw::new(order, "order of the tests");
    for last in (1..rest.len()).rev() {
        rest.swap(last, draw.choice(last + 1));
    }
    let places = references.len().saturating_sub(1).max(1);
    let count = rest.len();
    for (index, reference) in references.into_iter().enumerate() {
        rest.insert((index * count / places + index).min(rest.len()), reference);
    }
    rest
}
