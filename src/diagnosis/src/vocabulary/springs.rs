//! Gas and springs beside the valves.

use super::Situation;
use super::{Candidate, Fresh, Start, candidate, held, linear};
use dashpot_core::{element, number};

/// The gas column at x = 0, m. One that ends where the stroke does is a stop, not gas; a very long one is a straight spring.
fn length() -> Fresh {
    held(number!("gas_length"), (0.06, 1.5), 1.0)
}

/// Adds them.
pub(super) fn springs(all: &mut Vec<Candidate>, s: &Situation) {
    all.push(candidate(
        &[element!("gas_preload")],
        vec![linear(number!("gas_force"), (20.0, 1200.0))],
        vec![Start::at(&[100.0])],
    ));
    if s.temperature_measured {
        all.push(Candidate {
            fixed: vec![(number!("gas_warming_reference"), s.temperature)],
            ..candidate(
                &[element!("gas_warming")],
                vec![linear(number!("gas_warming_rate"), (0.1, 10.0))],
                vec![Start::at(&[0.8])],
            )
        });
    }
    all.push(Candidate {
        form: "isothermal",
        fixed: vec![(number!("gas_adiabatic_index"), 1.0)],
        ..candidate(
            &[element!("gas_spring")],
            vec![linear(number!("gas_stiffness"), (100.0, 10_000.0)), length()],
            [0.07, 0.15, 0.4].map(|l| Start::at(&[1000.0, l])).to_vec(),
        )
    });
    all.push(Candidate {
        form: "takes time to cool",
        fixed: vec![(number!("gas_adiabatic_index"), 1.4)],
        ..candidate(
            &[element!("gas_spring")],
            vec![
                linear(number!("gas_stiffness"), (100.0, 10_000.0)),
                length(),
                held(number!("gas_thermal_time"), (0.05, 60.0), 1.0),
            ],
            vec![Start::at(&[1000.0, 0.07, 2.0]), Start::at(&[1000.0, 0.15, 2.0]), Start::at(&[1000.0, 0.4, 2.0])],
        )
    });
    all.push(Candidate {
        ..candidate(
            &[element!("parallel_spring")],
            vec![linear(number!("spring_linear"), (0.0, 20_000.0))],
            vec![Start::at(&[1000.0])],
        )
    });
}
