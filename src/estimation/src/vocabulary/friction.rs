//! Friction of rod, piston and guides.

use super::{Candidate, Start, above, candidate, held, linear, log};
use crate::situation::Situation;
use dashpot_core::{element, number};

/// Start value of the power of presliding friction.
const SLIPS: f64 = 1.5;
/// Start value of the speed below which the contacts of presliding friction creep, m/s.
const CREEPS: f64 = 1e-4;

/// Adds the candidates for friction.
pub(super) fn friction(s: &Situation, all: &mut Vec<Candidate>) {
    let level = s.friction.max(s.friction_in_curve).max(10.0);
    if !s.base.is_on(element!("stribeck_friction")) {
        all.push(candidate(
            &[element!("coulomb_friction")],
            vec![linear(number!("coulomb_force"), (3.0, 200.0)), held(number!("coulomb_steepness"), (100.0, 1e4), 0.7)],
            vec![Start::at(&[20.0, 1000.0])],
        ));
    }
    // The element contains the Coulomb force and the break-away peak (form of Jonnalagadda & Vyas, KTH 2020). It is a
    // candidate only if no other element contains the Coulomb force.
    if !s.base.is_on(element!("coulomb_friction")) && !s.base.is_on(element!("presliding_friction")) {
        let peak = |level: f64, velocity: f64| Start::at(&[level, 1.25 * level, velocity]);
        all.push(Candidate {
            form: "simplified",
            fixed: vec![(number!("stribeck_form"), 0.0)],
            ..candidate(
                &[element!("stribeck_friction")],
                vec![
                    linear(number!("stribeck_coulomb_force"), (3.0, 200.0)),
                    above(number!("stribeck_breakaway_force"), number!("stribeck_coulomb_force"), (3.0, 300.0)),
                    held(number!("stribeck_breakaway_velocity"), (3e-4, 0.05), 0.7),
                ],
                [0.002, 0.006, 0.02].map(|velocity| peak(20.0, velocity)).to_vec(),
            )
        });
    }
    // The element contains only the break-away peak, because another element contains the Coulomb force.
    let rise = s.base.number(number!("coulomb_steepness")).clamp(200.0, 5000.0);
    all.push(Candidate {
        form: "full",
        fixed: vec![
            (number!("stribeck_form"), 1.0),
            (number!("stribeck_coulomb_force"), 0.0),
            (number!("stribeck_rise"), 1.0),
            (number!("stribeck_rise_power"), 1.0),
            (number!("stribeck_breakaway_velocity"), 1.0 / rise),
        ],
        ..candidate(
            &[element!("stribeck_friction")],
            vec![
                linear(number!("stribeck_breakaway_force"), (3.0, 150.0)),
                log(number!("stribeck_velocity"), (0.002, 0.06)),
                held(number!("stribeck_fall"), (1.0, 3.0), 0.3),
            ],
            [0.006, 0.015, 0.035].map(|v| Start::at(&[0.4 * level, v, 1.5])).to_vec(),
        )
    });
    for (back, form) in [(0.0, "slips from the first"), (1.0, "bends before it slips")] {
        all.push(Candidate {
            form,
            fixed: vec![(number!("presliding_return"), back)],
            ..candidate(
                &[element!("presliding_friction")],
                vec![
                    linear(number!("presliding_force"), (3.0, 200.0)),
                    log(number!("presliding_length"), (0.0, 5e-3)),
                    held(number!("presliding_power"), (0.0, 8.0), 0.7),
                    // If a contact creeps at more than 5 mm/s, its force depends on speed, so it is not friction.
                    held(number!("presliding_creep"), (0.0, 5e-3), 1.5),
                ],
                [1e-4, 3e-4, 9e-4]
                    .iter()
                    .flat_map(|length| {
                        let none = [
                            (number!("coulomb_force"), 0.2),
                            (number!("stribeck_coulomb_force"), 0.2),
                            (number!("stribeck_breakaway_force"), 0.2),
                        ];
                        let stiffer = [none[0], none[1], none[2], (number!("series_stiffness"), 1.3)];
                        [
                            Start::moving(&[level, *length, SLIPS, CREEPS], &stiffer),
                            Start::at(&[0.3 * level, *length, SLIPS, CREEPS]),
                        ]
                    })
                    .chain([3e-4, 1e-3, 2e-3].iter().filter(|_| s.friction_in_curve > 3.0).map(|length| Start {
                        level: 0.8 * s.friction_in_curve,
                        ..Start::at(&[0.8 * s.friction_in_curve, *length, SLIPS, CREEPS])
                    }))
                    .collect(),
            )
        });
    }
    all.push(candidate(
        &[element!("side_force_friction")],
        vec![linear(number!("side_force_coefficient"), (0.003, 0.6))],
        vec![Start::at(&[0.05])],
    ));
}
