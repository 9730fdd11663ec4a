//! Gas and springs parallel to the valves.

use super::{Candidate, Fresh, Start, candidate, held, linear};
use crate::situation::Situation;
use dashpot_core::parameter::Number;
use dashpot_core::{element, number};

/// Makes the parameter for the length of the gas column at zero displacement, m. A column as short as the stroke is a
/// stop, not gas. A very long column is a linear spring.
fn length() -> Fresh {
    held(number!("gas_length"), (0.06, 1.5), 1.0)
}

/// Adds the candidates for gas and springs.
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
    for (form, power, plausible, start) in [
        ("linear", number!("spring_linear"), (0.0, 20_000.0), 1000.0),
        ("quadratic", number!("spring_quadratic"), (-1e6, 1e6), 2e4),
        ("cubic", number!("spring_cubic"), (-2e7, 2e7), 4e5),
        ("quartic", number!("spring_quartic"), (-4e8, 4e8), 8e6),
    ] {
        all.push(Candidate {
            form,
            fixed: POWERS.into_iter().filter(|other| *other != power).map(|other| (other, 0.0)).collect(),
            ..candidate(&[element!("parallel_spring")], vec![linear(power, plausible)], vec![Start::at(&[start])])
        });
    }
}

/// Coefficients of the powers of a spring.
const POWERS: [Number; 4] =
    [number!("spring_linear"), number!("spring_quadratic"), number!("spring_cubic"), number!("spring_quartic")];
