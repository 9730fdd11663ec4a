//! Friction of rod, piston and guides.

use super::{Candidate, Start, candidate, held, linear, log};
use crate::situation::Situation;

/// Power of presliding friction from which it is refined.
const SLIPS: f64 = 1.5;
/// Speed below which its contacts creep, m/s.
const CREEPS: f64 = 1e-4;

/// Adds them.
pub(super) fn friction(s: &Situation, all: &mut Vec<Candidate>) {
    let level = s.friction.max(s.friction_in_curve).max(10.0);
    if !s.base.is_on("stribeck_friction") {
        all.push(candidate(
            "coulomb_friction",
            &["coulomb_friction"],
            vec![linear("coulomb_force", (3.0, 200.0)), held("coulomb_steepness", (100.0, 1e4), 0.7)],
            vec![Start::at(&[20.0, 1000.0])],
        ));
    }
    // The peak alone, above the level that another element carries.
    let rise = s.base.scalar("coulomb_steepness").clamp(200.0, 5000.0);
    all.push(Candidate {
        form: "full",
        fixed: vec![
            ("stribeck_form", 1.0),
            ("stribeck_coulomb_force", 0.0),
            ("stribeck_rise", 1.0),
            ("stribeck_rise_power", 1.0),
            ("stribeck_breakaway_velocity", 1.0 / rise),
        ],
        ..candidate(
            "stribeck_friction",
            &["stribeck_friction"],
            vec![
                linear("stribeck_breakaway_force", (3.0, 150.0)),
                log("stribeck_velocity", (0.002, 0.06)),
                held("stribeck_fall", (1.0, 3.0), 0.3),
            ],
            [0.006, 0.015, 0.035].map(|v| Start::at(&[0.4 * level, v, 1.5])).to_vec(),
        )
    });
    for (back, form) in [(0.0, "slips from the first"), (1.0, "bends before it slips")] {
        all.push(Candidate {
            form,
            fixed: vec![("presliding_return", back)],
            ..candidate(
                "presliding_friction",
                &["presliding_friction"],
                vec![
                    linear("presliding_force", (3.0, 200.0)),
                    log("presliding_length", (0.0, 5e-3)),
                    held("presliding_power", (0.0, 8.0), 0.7),
                    // What creeps faster is no friction: its force grows with speed.
                    held("presliding_creep", (0.0, 5e-3), 1.5),
                ],
                [1e-4, 3e-4, 9e-4]
                    .iter()
                    .flat_map(|length| {
                        let none = [
                            ("coulomb_force", 0.2),
                            ("stribeck_coulomb_force", 0.2),
                            ("stribeck_breakaway_force", 0.2),
                        ];
                        let stiffer = [none[0], none[1], none[2], ("series_stiffness", 1.3)];
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
        "side_force_friction",
        &["side_force_friction"],
        vec![linear("side_force_coefficient", (0.003, 0.6))],
        vec![Start::at(&[0.05])],
    ));
}
