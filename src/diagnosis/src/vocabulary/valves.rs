//! Passages and valves whose flow depends on more than the force.

use super::{Candidate, Start, candidate, held, linear, log};
use crate::situation::Situation;

/// Flow that depends on place or frequency, and valves that are late.
pub(super) fn valves(s: &Situation, all: &mut Vec<Candidate>) {
    let (low, high) = s.reach;
    let (middle, span) = (0.5 * (low + high), 0.5 * (high - low));
    for (form, strength, start, names) in [
        (0.0, linear("bypass_share", (-1.0, 0.9)), 0.3, ["both strokes", "rebound", "compression"]),
        (
            1.0,
            linear("bypass_flow", (0.003, 2.0)),
            0.05,
            ["groove", "groove open in rebound", "groove open in compression"],
        ),
    ] {
        for (strokes, name) in [0.0, 1.0, 2.0].into_iter().zip(names) {
            all.push(Candidate {
                form: name,
                fixed: vec![("bypass_strokes", strokes), ("bypass_form", form)],
                ..candidate(
                    "position_dependent_damping",
                    &["position_dependent_damping"],
                    vec![
                        strength.clone(),
                        linear("bypass_centre", (-0.1, 0.1)),
                        held("bypass_half_width", (0.003, 0.08), 0.8),
                        held("bypass_blend", (0.001, 0.03), 0.8),
                    ],
                    [-0.5, 0.0, 0.5]
                        .iter()
                        .flat_map(|c| [0.008, 0.02].map(|w| Start::at(&[start, middle + c * span, w, 0.005])))
                        .collect(),
                )
            });
        }
    }
    all.push(Candidate {
        form: "bypass",
        fixed: vec![("fsd_form", 2.0)],
        ..candidate(
            "frequency_selective_damping",
            &["frequency_selective_damping"],
            vec![
                linear("fsd_flow", (0.003, 2.0)),
                log("fsd_time", (5e-3, 0.5)),
                held("fsd_force", (5.0, 1000.0), 0.8),
                held("fsd_laminar_force", (2.0, 1e5), 1.5),
            ],
            [0.015, 0.05, 0.15].map(|t| Start::at(&[0.05, t, 0.3 * s.knee_force.max(100.0), 150.0])).to_vec(),
        )
    });
    for (form, name, times) in [(0.0, "filter", [0.01, 0.04, 0.15]), (1.0, "stroke", [0.015, 0.05, 0.15])] {
        all.push(Candidate {
            form: name,
            fixed: vec![("fsd_form", form)],
            ..candidate(
                "frequency_selective_damping",
                &["frequency_selective_damping"],
                vec![linear("fsd_share", (0.03, 0.8)), log("fsd_time", (5e-3, 0.5))],
                times.map(|t| Start::at(&[0.25, t])).to_vec(),
            )
        });
    }
    let knee = s.knee_force.max(50.0);
    // A valve may give way from the first newton, and at once beyond its play.
    let stands = [log("valve_opening_force", (0.0, 3000.0)), held("valve_width", (0.0, 1500.0), 0.8)];
    for (form, place, lateness, starts) in [
        (
            "a valve with play",
            1.0,
            [log("valve_play", (5.0, 1000.0)), held("valve_time", (0.0, 5e-3), 0.8)],
            [0.05, 0.2].map(|play| [play * knee, 5e-4]),
        ),
        (
            "a valve with mass",
            2.0,
            [log("valve_time", (1.5e-4, 0.02)), held("valve_damping", (0.1, 3.0), 0.6)],
            [[7e-4, 0.7], [3e-3, 0.7]],
        ),
    ] {
        all.push(Candidate {
            form,
            fixed: vec![("valve_form", place)],
            ..candidate(
                "valve_hysteresis",
                &["valve_hysteresis"],
                [lateness, stands.clone()].concat(),
                [0.3, 0.8]
                    .iter()
                    .flat_map(|f| starts.map(|[a, b]| Start::at(&[a, b, f * knee, 0.2 * f * knee])))
                    .collect(),
            )
        });
    }
    all.push(Candidate {
        form: "opens and closes at different forces",
        // So quick that the forces alone decide, however slow the motion.
        fixed: vec![("valve_time", 5e-4)],
        ..candidate(
            "valve_hysteresis",
            &["valve_hysteresis"],
            vec![
                linear("valve_hysteresis_share", (0.01, 0.6)),
                log("valve_opening_force", (50.0, 3000.0)),
                linear("valve_closing_ratio", (0.3, 0.98)),
                held("valve_width", (10.0, 1500.0), 0.8),
            ],
            [0.5, 1.0, 1.8]
                .iter()
                .flat_map(|f| [0.5, 0.8].map(|closes| Start::at(&[0.15, f * knee, closes, 0.2 * f * knee])))
                .collect(),
        )
    });
    all.push(Candidate {
        fixed: vec![("valve_closing_ratio", 0.75)],
        ..candidate(
            "valve_hysteresis",
            &["valve_hysteresis"],
            vec![
                linear("valve_hysteresis_share", (0.01, 0.6)),
                log("valve_opening_force", (50.0, 3000.0)),
                log("valve_time", (5e-4, 0.03)),
                held("valve_width", (20.0, 1500.0), 0.8),
            ],
            [0.5, 1.0, 1.8]
                .iter()
                .flat_map(|f| [2e-3, 6e-3].map(|t| Start::at(&[0.15, f * knee, t, 0.3 * f * knee])))
                .collect(),
        )
    });
}
