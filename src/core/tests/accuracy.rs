//! The accuracy contract over the corners of the test matrix, against an independent reference.

mod common;
use common::*;

/// Largest rms and largest single error, as shares of the largest force.
fn worst(changes: &[(&str, f64)], dt: f64, velocity_only: bool) -> (f64, f64) {
    let model = model(changes);
    let mut worst = (0.0f64, 0.0f64);
    // Peak velocity 0.052 to 1.571 m/s, up to 25 Hz.
    for (amplitude, peak) in [(0.05, 1.571), (0.01, 1.571), (0.005, 0.524), (0.002, 0.2618), (0.002, 0.052)] {
        let frequency = peak / (std::f64::consts::TAU * amplitude);
        let motion = sine(amplitude, frequency);
        let steps = (0.12 / dt) as usize;
        let parts = (dt / 2e-6) as usize;
        let exact = reference_forces(&model, &motion, dt, steps, parts);
        let got = errors(&step_forces(&model, &motion, dt, steps, velocity_only), &exact);
        worst = (worst.0.max(got.0), worst.1.max(got.1));
    }
    worst
}

const DEFAULT: &[(&str, f64)] = &[("series_stiffness", 3e6), ("internal_mass", 0.5)];
const STIFF: &[(&str, f64)] = &[("series_stiffness", 1e7), ("internal_mass", 0.1)];
const SOFT: &[(&str, f64)] = &[("series_stiffness", 1e6), ("internal_mass", 1.0)];

#[test]
fn a_millisecond_step_is_within_a_thousandth() {
    for changes in [DEFAULT, STIFF, SOFT] {
        let (rms, largest) = worst(changes, 1e-3, false);
        assert!(rms <= 1e-3 && largest <= 1e-2, "{changes:?}: rms {rms:.2e} largest {largest:.2e}");
    }
}

#[test]
fn a_quarter_millisecond_step_is_within_a_ten_thousandth() {
    for changes in [DEFAULT, STIFF, SOFT] {
        let (rms, _) = worst(changes, 2.5e-4, false);
        assert!(rms <= 1e-4, "{changes:?}: rms {rms:.2e}");
    }
}

#[test]
fn velocity_alone_is_within_half_a_percent() {
    for changes in [DEFAULT, STIFF, SOFT] {
        let (rms, _) = worst(changes, 1e-3, true);
        assert!(rms <= 5e-3, "{changes:?}: rms {rms:.2e}");
    }
}
