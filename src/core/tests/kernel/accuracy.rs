//! Tests of the guaranteed accuracy at the extreme amplitudes and velocities of a rig's test matrix, by comparison with
//! an independent reference.

use crate::common::*;
use dashpot_core::list;
use dashpot_core::step::Method;

/// Returns the largest rms error and the largest single error of the forces over five sine motions, relative to each
/// motion's largest force.
fn worst(changes: &[(&str, f64)], dt: f64, velocity_only: bool) -> (f64, f64) {
    let model = model(changes);
    let mut worst = (0.0f64, 0.0f64);
    // Amplitudes in m and peak velocities in m/s; the frequencies reach 25 Hz.
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

/// The automatic choice takes one or two substeps of the three-stage method in a step of 1 ms. More substeps would also
/// be accurate, but their cost would differ from the figures in the book.
#[test]
fn the_automatic_choice_takes_no_more_substeps_than_it_needs() {
    for (changes, substeps) in [(DEFAULT, 1), (SOFT, 1), (STIFF, 2)] {
        let chosen = model(changes).integration();
        assert_eq!((chosen.method, chosen.substeps(1e-3)), (Method::ThreeStage, substeps), "{changes:?}");
        assert_eq!(chosen.substeps(2.5e-4), 1, "{changes:?}");
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

/// The rms error of a step of 1 ms is at most 0.1 % of the largest force, and a single error at most 1 %.
///
/// This holds for series springs of 3e5 to 3e7 N/m and masses of 0.1 to 2 kg, and for 0.3, 1 and 3 times the default FV
/// forces.
/// The automatic choice of method and substeps was fitted to these dampers.
#[test]
fn a_millisecond_step_is_within_a_thousandth_for_any_mass_spring_and_damping() {
    let mut table = String::new();
    for scale in [1.0f64, 0.3, 3.0] {
        for (stiffness, mass) in [
            (3e5f64, 0.3f64),
            (5e5, 1.0),
            (1e6, 1.0),
            (1e6, 0.2),
            (3e6, 0.5),
            (3e6, 2.0),
            (6e6, 1.0),
            (3e6, 0.1),
            (1e7, 0.5),
            (1e7, 0.1),
            (1e7, 2.0),
            (3e7, 0.1),
            (3e7, 0.5),
        ] {
            let mut params = params(&[("series_stiffness", stiffness), ("internal_mass", mass)]);
            let forces: Vec<f64> = params.list(list!("fv_force")).iter().map(|force| scale * force).collect();
            params.set_list(list!("fv_force"), &forces).unwrap();
            let model = dashpot_core::Model::new(&params).unwrap();
            // The reference steps are so short that the explicit method is stable with the steepest FV curve.
            let rate = (scale * 7e3 / mass).max((stiffness / mass).sqrt());
            let parts = 200 + (1.5e-3 * rate) as usize;
            for (amplitude, peak) in [(0.05, 1.571), (0.01, 1.571), (0.005, 0.524), (0.002, 0.2618), (0.002, 0.052)] {
                let motion = sine(amplitude, peak / (std::f64::consts::TAU * amplitude));
                let exact = reference_forces(&model, &motion, 1e-3, 80, parts);
                let (rms, largest) = errors(&step_forces(&model, &motion, 1e-3, 80, false), &exact);
                if !(rms <= 1e-3 && largest <= 1e-2) {
                    table += &format!("{stiffness:e} {mass} x{scale} {amplitude} {peak}: {rms:.1e} {largest:.1e}\n");
                }
            }
        }
    }
    assert!(table.is_empty(), "beyond it:\n{table}");
}
