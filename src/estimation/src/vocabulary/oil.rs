//! The oil column: compressibility, air, voids, temperature.

use super::{Candidate, Fresh, LinearExtension, Start, candidate, fresh, held, linear, log, near};
use crate::hypothesis::Free;
use crate::situation::Situation;
use dashpot_core::parameter::Number;
use dashpot_core::{element, number};

/// Start value of the reciprocal length of an oil column, 1/m, for a column of 17 cm.
const COLUMN: f64 = 6.0;
/// Constant C, °C, of Vogel's law for damper oils: the logarithm of the viscosity is linear in 1/(T + C) at temperature
/// T, °C.
const VOGEL: f64 = 95.0;

/// Trial values of force caps (largest forces before the oil cavitates), as fractions of the largest force of their
/// stroke.
const CAPS: [f64; 5] = [1.04, 0.98, 0.93, 0.85, 0.7];
/// Fraction of a force cap up to which the FV curve counts as correct on the stroke that cavitation limits to the cap.
///
/// In a second start, the curve counts as correct only up to the speed [`SLOW`], m/s, because voids distort it well
/// below the cap.
const TRUSTED: f64 = 0.85;
const SLOW: f64 = 0.3;

/// Returns trial force caps, N, of a stroke (1 rebound, −1 compression) with the largest force `top`, N. Each has a
/// linear extension of the FV curve on that stroke, because the curve may have absorbed the cap.
fn capped(s: &Situation, stroke: f64, top: f64) -> Vec<(f64, LinearExtension)> {
    let slow = s.driven(stroke * SLOW).abs();
    let drawn = |cap: f64| {
        [(TRUSTED * cap, 1.0), (slow, 0.7)].map(|(from, steepness)| LinearExtension { stroke, from, steepness })
    };
    CAPS.iter().flat_map(|share| drawn(share * top).map(|drawn| (share * top, drawn))).collect()
}

/// Adds the candidates for compressibility, aeration, cavitation and thinning of the oil.
pub(super) fn oil(s: &Situation, all: &mut Vec<Candidate>) {
    oil_compressibility(s, all);
    aeration(all);
    cavitation(s, all);
    temperature_fade(s, all);
}

/// Adds the candidates for an oil column that is compressible, in equal or in different chambers.
fn oil_compressibility(s: &Situation, all: &mut Vec<Candidate>) {
    let stiffness =
        if s.base.is_on(element!("series_compliance")) { s.base.number(number!("series_stiffness")) } else { 2e6 };
    for (chambers, form) in [(0.0, "rebound chamber"), (1.0, "both chambers")] {
        all.push(Candidate {
            form,
            fixed: vec![(number!("oil_chambers"), chambers), (number!("oil_compression"), 1.0)],
            ..candidate(
                &[element!("oil_compressibility")],
                // Oil columns are 8 to 50 cm long. A reciprocal length of up to 20 1/m (5 cm) counts as plausible.
                vec![log(number!("oil_stiffness"), (3e5, 2e7)), near(number!("oil_shortening"), (0.0, 20.0), 4.0)],
                vec![
                    Start::at(&[1e7, COLUMN]),
                    Start::at(&[2.5e6, COLUMN]),
                    Start::at(&[7e5, COLUMN]),
                    Start::moving(&[2.0 * stiffness, COLUMN], &[(number!("series_stiffness"), 2.0)]),
                    Start::moving(&[1.3 * stiffness, COLUMN], &[(number!("series_stiffness"), 4.0)]),
                    // Soft oil acts like a soft mount: the series spring may have absorbed the whole oil column.
                    Start::moving(&[1.1 * stiffness, COLUMN], &[(number!("series_stiffness"), 12.0)]),
                ],
            )
        });
    }
    all.push(Candidate {
        form: "one chamber softer than the other",
        fixed: vec![(number!("oil_chambers"), 1.0), (number!("oil_shortening"), 0.0)],
        ..candidate(
            &[element!("oil_compressibility")],
            // In a twin tube, only the area of the rod compresses the column. If the column is softer than any oil, the
            // cause is another effect.
            vec![log(number!("oil_stiffness"), (3e5, 5e7)), held(number!("oil_compression"), (0.03, 30.0), 1.0)],
            [(4.0, 0.25, 2.0), (4.0, 0.25, 6.0), (1.3, 3.0, 3.0), (1.3, 8.0, 6.0)]
                .map(|(rebound, share, stiffer)| {
                    Start::moving(&[rebound * stiffness, share], &[(number!("series_stiffness"), stiffer)])
                })
                .to_vec(),
        )
    });
}

/// Adds the candidate for air in the oil.
fn aeration(all: &mut Vec<Candidate>) {
    all.push(candidate(
        &[element!("aeration")],
        // If the estimated air exceeds that of any oil, the cause is play, a mount, or an elastic chamber.
        vec![
            log(number!("aeration_stroke"), (2e-5, 4.5e-3)),
            held(number!("aeration_force"), (40.0, 1500.0), 0.8),
            held(number!("aeration_compression"), (0.1, 10.0), 0.7),
        ],
        [[1e-4, 120.0], [1e-4, 300.0], [4e-4, 120.0], [4e-4, 300.0]]
            .map(|[stroke, force]| Start::at(&[stroke, force, 1.0]))
            .into_iter()
            // The series stiffness of the base absorbs the effect of air almost completely, even if there is much air.
            // Therefore, some starts increase this stiffness.
            .chain([(2e-4, 1.4), (1e-3, 4.0)].map(|(stroke, stiffer)| {
                Start::moving(&[stroke, 200.0, 1.0], &[(number!("series_stiffness"), stiffer)])
            }))
            .collect(),
    ));
}

/// Adds the candidates for voids: a force cap, a void with gas, a chamber that is not refilled.
fn cavitation(s: &Situation, all: &mut Vec<Candidate>) {
    force_caps(s, all);
    void_with_gas(s, all);
    unfilled(s, all);
}

/// Adds the candidates for a force cap on one stroke.
fn force_caps(s: &Situation, all: &mut Vec<Candidate>) {
    for (side, stroke, top) in [(0.0, -1.0, s.top_compression), (1.0, 1.0, s.top_rebound)] {
        for kept in [1.0, 0.0] {
            all.push(Candidate {
                form: match (side == 0.0, kept == 1.0) {
                    (true, true) => "compression capped, gas pushes on",
                    (true, false) => "compression capped, dead return",
                    (false, true) => "rebound capped, force stays",
                    (false, false) => "rebound capped, dead return",
                },
                fixed: vec![(number!("cavitation_side"), side), (number!("cavitation_return"), kept)],
                ..candidate(
                    &[element!("cavitation")],
                    vec![log(number!("cavitation_force"), (100.0, 5000.0))],
                    capped(s, stroke, top)
                        .into_iter()
                        .map(|(cap, drawn)| Start { unbend: Some(drawn), ..Start::at(&[cap]) })
                        .chain(capped(s, stroke, top).into_iter().step_by(2).map(|(cap, drawn)| Start {
                            unbend: Some(drawn),
                            curve: s.slowing.clone(),
                            ..Start::at(&[cap])
                        }))
                        .chain([Start::at(&[0.9 * top])])
                        .collect(),
                )
            });
        }
    }
}

/// Adds the candidate for a force cap in compression at which dissolved gas expands.
fn void_with_gas(s: &Situation, all: &mut Vec<Candidate>) {
    all.push(Candidate {
        form: "compression capped, gas expands in the void",
        fixed: vec![(number!("cavitation_side"), 0.0), (number!("cavitation_return"), 1.0)],
        ..candidate(
            &[element!("cavitation")],
            vec![
                log(number!("cavitation_force"), (100.0, 5000.0)),
                linear(number!("cavitation_onset"), (0.0, 1.0)),
                held(number!("cavitation_expansion"), (3e-5, 0.02), 1.2),
            ],
            capped(s, -1.0, s.top_compression)
                .into_iter()
                .map(|(cap, drawn)| Start { unbend: Some(drawn), ..Start::at(&[cap, 0.85, 5e-4]) })
                .collect(),
        )
    });
}

/// Returns the parameters that the candidates for temperature fade set to fixed values. `source` states whether the
/// temperature is measured (0) or computed from the dissipated work (1). `reference` is the temperature, °C, above
/// which the oil is thinner.
fn fade(source: f64, reference: f64) -> Vec<(Number, f64)> {
    vec![
        (number!("fade_source"), source),
        (number!("fade_reference"), reference),
        (number!("fade_slackening"), 1.0 / (reference + VOGEL)),
    ]
}

/// Adds the candidates for oil that becomes thinner with temperature.
fn temperature_fade(s: &Situation, all: &mut Vec<Candidate>) {
    if s.temperature_measured {
        all.push(fade_with_measured_temperature(s.temperature));
        all.push(fade_of_warmer_oil(s.temperature));
    } else {
        all.push(fade_by_own_work());
    }
}

fn fade_with_measured_temperature(reference: f64) -> Candidate {
    Candidate {
        form: "measured temperature",
        fixed: fade(0.0, reference),
        ..candidate(
            &[element!("temperature_fade")],
            vec![
                linear(number!("fade_coefficient"), (0.001, 0.07)),
                held(number!("fade_laminar_force"), (50.0, 1e6), 1.2),
            ],
            vec![Start::at(&[0.004, 1e4]), Start::at(&[0.01, 1e3]), Start::at(&[0.03, 2e3])],
        )
    }
}

/// Makes the candidate for a sensor on the tube, whose temperature lags behind that of the oil.
fn fade_of_warmer_oil(reference: f64) -> Candidate {
    // The difference of temperatures is the power divided by the heat transfer per kelvin from oil to tube.
    Candidate {
        form: "oil warmer than measured",
        fixed: fade(1.0, reference),
        ..candidate(
            &[element!("temperature_fade")],
            vec![
                linear(number!("fade_coefficient"), (0.001, 0.07)),
                Fresh { deviation: Some(0.8), ..fresh(Free::Cooling, (0.01, 0.5)) },
                Fresh { deviation: Some(0.8), ..fresh(Free::HeatCapacity, (100.0, 1500.0)) },
                held(number!("fade_laminar_force"), (50.0, 1e6), 1.2),
            ],
            vec![
                Start::at(&[0.004, 0.06, 250.0, 1e4]),
                Start::at(&[0.01, 0.06, 250.0, 1e3]),
                Start::at(&[0.03, 0.06, 250.0, 2e3]),
            ],
        )
    }
}

/// Makes the candidate for oil whose temperature follows from the dissipated work.
fn fade_by_own_work() -> Candidate {
    Candidate {
        form: "heated by its own work",
        fixed: fade(1.0, 20.0),
        ..candidate(
            &[element!("temperature_fade")],
            vec![
                linear(number!("fade_coefficient"), (0.001, 0.07)),
                Fresh { deviation: Some(1.2), ..fresh(Free::Cooling, (5e-4, 0.1)) },
                // The records determine heat capacity and fade coefficient separately only if the force decreases
                // nonlinearly with temperature.
                Fresh { deviation: Some(0.8), ..fresh(Free::HeatCapacity, (100.0, 5000.0)) },
                held(number!("fade_laminar_force"), (50.0, 1e6), 1.2),
            ],
            vec![
                Start::at(&[0.004, 2e-3, 600.0, 1e4]),
                Start::at(&[0.004, 1e-2, 600.0, 1e4]),
                Start::at(&[0.01, 2e-3, 600.0, 1e3]),
                Start::at(&[0.01, 1e-2, 600.0, 1e3]),
            ],
        )
    }
}

/// Start values of the fraction of the flow that does not refill a chamber. [`BEYOND`] contains start values of the
/// speed above which the chamber is not refilled, as fractions of the highest speed.
const UNFILLED: [f64; 3] = [0.03, 0.1, 0.3];
const BEYOND: [f64; 3] = [0.2, 0.5, 0.8];

/// Adds candidates for a chamber that the previous stroke did not refill: the next stroke begins without force.
fn unfilled(s: &Situation, all: &mut Vec<Candidate>) {
    for (side, driven, [beyond_a_speed, at_any_speed]) in [
        (1.0, 0, ["foot valve does not refill", "compression begins with a lost stroke"]),
        (0.0, 1, ["rebound chamber is not refilled", "rebound begins with a lost stroke"]),
    ] {
        let fixed = vec![(number!("cavitation_form"), 1.0), (number!("cavitation_side"), side)];
        let fraction = || log(number!("cavitation_unfilled"), (0.003, 1.0));
        let curves = [Vec::new(), s.slowing.clone()];
        let speed = s.fastest[driven].max(0.1);
        let starts = UNFILLED.iter().flat_map(|a| BEYOND.map(|b| vec![*a, b * speed]));
        all.push(Candidate {
            form: beyond_a_speed,
            jumps: true,
            fixed: fixed.clone(),
            ..candidate(
                &[element!("cavitation")],
                vec![fraction(), held(number!("cavitation_velocity"), (0.03, 1.5), 0.7)],
                starts.flat_map(|values| curves.clone().map(|curve| Start { curve, ..Start::at(&values) })).collect(),
            )
        });
        all.push(Candidate {
            form: at_any_speed,
            jumps: true,
            fixed: [fixed, vec![(number!("cavitation_velocity"), 0.0)]].concat(),
            ..candidate(
                &[element!("cavitation")],
                vec![fraction()],
                UNFILLED.iter().flat_map(|a| curves.clone().map(|curve| Start { curve, ..Start::at(&[*a]) })).collect(),
            )
        });
    }
}
