//! Gas and springs beside the valves.

use super::{Candidate, Fresh, Start, candidate, held, linear};

/// The gas column at x = 0, m. One that ends where the stroke does is a stop, not gas; a very long one is a straight spring.
fn length() -> Fresh {
    held("gas_length", (0.06, 1.5), 1.0)
}

/// Adds them.
pub(super) fn springs(all: &mut Vec<Candidate>) {
    all.push(candidate(
        "gas_preload",
        &["gas_preload"],
        vec![linear("gas_force", (20.0, 1200.0))],
        vec![Start::at(&[100.0])],
    ));
    all.push(Candidate {
        form: "isothermal",
        fixed: vec![("gas_adiabatic_index", 1.0)],
        ..candidate(
            "gas_spring",
            &["gas_spring"],
            vec![linear("gas_stiffness", (100.0, 10_000.0)), length()],
            [0.07, 0.15, 0.4].map(|l| Start::at(&[1000.0, l])).to_vec(),
        )
    });
    all.push(Candidate {
        form: "takes time to cool",
        fixed: vec![("gas_adiabatic_index", 1.4)],
        ..candidate(
            "gas_spring",
            &["gas_spring"],
            vec![linear("gas_stiffness", (100.0, 10_000.0)), length(), held("gas_thermal_time", (0.05, 60.0), 1.0)],
            vec![Start::at(&[1000.0, 0.07, 2.0]), Start::at(&[1000.0, 0.15, 2.0]), Start::at(&[1000.0, 0.4, 2.0])],
        )
    });
    all.push(Candidate {
        ..candidate(
            "parallel_spring",
            &["parallel_spring"],
            vec![linear("spring_linear", (0.0, 20_000.0))],
            vec![Start::at(&[1000.0])],
        )
    });
}
