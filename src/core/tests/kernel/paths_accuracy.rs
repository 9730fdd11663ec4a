//! Tests of the guaranteed accuracy with each element of the force paths on, by comparison with a finer solution.

use crate::common::*;
use dashpot_core::element;
use dashpot_core::parameter::{Element, Number};
use dashpot_core::step::{Integration, Method};
use dashpot_core::{Model, Params};
use std::f64::consts::TAU;

#[test]
fn a_millisecond_step_is_within_a_thousandth() {
    check_millisecond_step(0);
}

#[test]
fn a_millisecond_step_is_within_a_thousandth_on_the_other_paths() {
    check_millisecond_step(1);
}

/// Checks every second model, beginning with index `half`, so that two tests run in parallel.
fn check_millisecond_step(half: usize) {
    let mut table = String::new();
    let mut missed = 0;
    for (name, params) in paths().into_iter().skip(half).step_by(2) {
        let model = Model::new(&params).unwrap();
        let mut worst = (0.0f64, 0.0f64);
        for (amplitude, peak) in [(0.05, 1.571), (0.01, 1.571), (0.005, 0.524), (0.002, 0.2618), (0.002, 0.052)] {
            let motion = sine(amplitude, peak / (TAU * amplitude));
            // The explicit method of the reference resolves neither a closing void nor air behind a series spring. In
            // these cases, steps of 0.01 ms by the fourth-order method are the reference.
            let exact =
                if params.is_on(element!("cavitation")) || name == "aeration" || name == "less air in compression" {
                    let fine = model.with_integration(Integration::fixed(Method::Fourth, 1));
                    step_forces(&fine, &motion, 1e-5, 12_000, false).into_iter().skip(99).step_by(100).collect()
                } else {
                    reference_forces(&model, &motion, 1e-3, 120, 500)
                };
            let (rms, largest) = errors(&step_forces(&model, &motion, 1e-3, 120, false), &exact);
            table += &format!("{name}: {amplitude} m {peak} m/s: rms {rms:.1e} largest {largest:.1e}\n");
            worst = (worst.0.max(rms), worst.1.max(largest));
        }
        // A void that closes causes an impact. The force sample after the impact depends on its exact instant, so the
        // tolerance is larger.
        let allowed = if params.is_on(element!("cavitation")) { (5e-3, 2e-2) } else { (1e-3, 1e-2) };
        missed += usize::from(worst.0 > allowed.0 || worst.1 > allowed.1);
    }
    assert!(missed == 0, "{missed} missed:\n{table}");
}

/// Name in messages, element, and the parameters that select a form of the element.
type Form = (&'static str, &'static str, &'static [(&'static str, f64)]);

/// Elements and forms from which the pairs are made.
const PAIRED: &[Form] = &[
    ("play", "free_play", &[]),
    ("bushing", "bushing", &[]),
    ("oil", "oil_compressibility", &[]),
    ("uneven oil", "oil_compressibility", &[("oil_compression", 0.3)]),
    ("air", "aeration", &[]),
    ("void", "cavitation", &[]),
    ("early void", "cavitation", &[("cavitation_force", 900.0)]),
    ("foot valve", "cavitation", &[("cavitation_form", 1.0), ("cavitation_side", 1.0), ("cavitation_velocity", 0.1)]),
    ("position", "position_dependent_damping", &[("bypass_half_width", 0.01)]),
    ("groove", "position_dependent_damping", &[("bypass_form", 1.0), ("bypass_half_width", 0.01)]),
    ("fade", "temperature_fade", &[]),
    ("filter", "frequency_selective_damping", &[]),
    ("passage", "frequency_selective_damping", &[("fsd_form", 2.0)]),
    ("stroke", "frequency_selective_damping", &[("fsd_form", 1.0)]),
    ("valve", "valve_hysteresis", &[]),
    ("valve with play", "valve_hysteresis", &[("valve_form", 1.0)]),
    ("valve with mass", "valve_hysteresis", &[("valve_form", 2.0)]),
    ("friction behind the spring", "coulomb_friction", &[("series_load", 1.0)]),
    ("presliding", "presliding_friction", &[]),
    ("gas", "gas_spring", &[]),
];

/// Returns the number of pairs with this series stiffness, N/m, and internal mass, kg, and the pairs beyond the
/// guaranteed accuracy. The number of such a pair is its error over the allowed one.
fn pairs_beyond(stiffness: f64, mass: f64) -> (usize, Vec<(f64, String)>) {
    let (mut count, mut beyond) = (0, Vec::new());
    for (i, (first, one, by_one)) in PAIRED.iter().enumerate() {
        for (second, other, by_other) in PAIRED.iter().skip(i + 1).filter(|(_, other, _)| other != one) {
            let mut params: Params = params(&[("series_stiffness", stiffness), ("internal_mass", mass)]);
            for (element, changes) in [(one, by_one), (other, by_other)] {
                params.enable(Element::find(element).unwrap(), true);
                changes.iter().for_each(|(name, value)| params.set(Number::find(name).unwrap(), *value).unwrap());
            }
            let model = Model::new(&params).unwrap();
            let fine = model.with_integration(Integration::fixed(Method::Fourth, 1));
            let mut worst = (0.0f64, 0.0f64);
            for (amplitude, peak) in [(0.05, 1.571), (0.01, 1.571), (0.005, 0.524), (0.002, 0.2618), (0.002, 0.052)] {
                let motion = sine(amplitude, peak / (TAU * amplitude));
                let exact: Vec<f64> =
                    step_forces(&fine, &motion, 2e-5, 3000, false).into_iter().skip(49).step_by(50).collect();
                let (rms, largest) = errors(&step_forces(&model, &motion, 1e-3, 60, false), &exact);
                worst = (worst.0.max(rms), worst.1.max(largest));
            }
            let allowed = if params.is_on(element!("cavitation")) { (5e-3, 2e-2) } else { (1e-3, 1e-2) };
            let share = (worst.0 / allowed.0).max(worst.1 / allowed.1);
            count += 1;
            if !(share <= 1.0) {
                beyond.push((share, format!("{first} and {second}: rms {:.1e} largest {:.1e}", worst.0, worst.1)));
            }
        }
    }
    (count, beyond)
}

#[test]
fn pairs_of_elements_are_within_it_behind_the_default_spring() {
    let (_, beyond) = pairs_beyond(3e6, 0.5);
    // At most one pair may miss the guaranteed accuracy: air with an oil that is softer in compression than the default
    // series spring. Its rms error is below 1.3 thousandths of the largest force.
    assert!(beyond.iter().all(|(share, _)| *share < 1.3) && beyond.len() <= 1, "{beyond:#?}");
}

/// Prints the pairs beyond the guaranteed accuracy behind four series springs: the figures that the book states.
#[test]
#[ignore = "a measurement: prints which pairs of elements miss the promise behind four springs"]
fn pairs_behind_four_springs() {
    for (stiffness, mass) in [(3e6, 0.5), (1e6, 1.0), (1e7, 0.1), (3e6, 0.2)] {
        let (count, beyond) = pairs_beyond(stiffness, mass);
        println!("{stiffness:e} N/m, {mass} kg: {} of {count} beyond: {beyond:#?}", beyond.len());
    }
}
