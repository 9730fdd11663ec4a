//! Compares the force of the kernel with fixed host steps with the converged solution, over the whole test matrix of
//! sines up to 25 Hz.

use dashpot_core::number;
use dashpot_core::{Model, Params};
use dashpot_rig::Matrix;
use dashpot_simulation::accuracy::{HostInput, References, Sine, radau::reference_forces, worst};

fn matrix() -> Vec<Sine> {
    let mut tests: Vec<Sine> = Matrix::default()
        .points()
        .iter()
        .map(|p| Sine { amplitude: p.amplitude_m, frequency: p.frequency_hz })
        .collect();
    tests.push(Sine { amplitude: 0.001, frequency: 25.0 });
    tests
}

fn model(stiffness: f64, damping: f64, mass: f64) -> Model {
    let mut params = Params::new();
    params.set(number!("series_stiffness"), stiffness).unwrap();
    params.set(number!("series_damping"), damping).unwrap();
    params.set(number!("internal_mass"), mass).unwrap();
    Model::new(&params).unwrap()
}

#[test]
fn errors_stay_inside_the_contract() {
    stay_inside_the_contract(&[(1e7, 200.0, 0.1), (5e5, 1000.0, 2.0)]);
}

#[test]
#[ignore = "a damper between those of the test before"]
fn errors_of_a_third_damper_stay_inside_the_contract() {
    stay_inside_the_contract(&[(3e6, 200.0, 0.5)]);
}

/// Asserts the limits of the force error of dampers with these series stiffnesses, N/m, dampings, N s/m, and masses,
/// kg. The reference is a converged solution.
fn stay_inside_the_contract(dampers: &[(f64, f64, f64)]) {
    for (stiffness, damping, mass) in dampers.iter().copied() {
        let model = model(stiffness, damping, mass);
        let references = References::solve(&model, &matrix(), 0.25e-3);
        let both = worst(&references.compare(&model, 1e-3, HostInput::Motion));
        let fine = worst(&references.compare(&model, 0.25e-3, HostInput::Motion));
        let velocity = worst(&references.compare(&model, 1e-3, HostInput::Velocity));
        let of = format!("series stiffness {stiffness:.1e}, mass {mass}: {both:?} {fine:?} {velocity:?}");
        assert!(both.rms <= 1e-3 && both.largest <= 1e-2, "{of}");
        assert!(fine.rms <= 1e-4, "{of}");
        assert!(velocity.rms <= 5e-3, "{of}");
    }
}

#[test]
fn the_reference_itself_has_converged() {
    let model = model(1e7, 200.0, 0.1);
    for sine in [Sine { amplitude: 0.05, frequency: 5.0 }, Sine { amplitude: 0.001, frequency: 20.8 }] {
        let of = |parts| reference_forces(&model, &sine.motion(), 0.25e-3, 400, parts);
        let (coarse, fine) = (of(4), of(12));
        let top = fine.iter().fold(0.0f64, |m, f| m.max(f.abs()));
        let off = coarse.iter().zip(&fine).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        // The reference's error must be at most a tenth of the smallest limit of `errors_stay_inside_the_contract`,
        // 1e-4.
        assert!(off <= 1e-5 * top, "{off} of {top}");
    }
}
