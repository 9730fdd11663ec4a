//! Passages and valves whose flow depends on more than the force.

use super::{Candidate, Start, candidate, held, linear, log};
use crate::situation::Situation;
use dashpot_core::{element, number};

/// Adds the candidates for displacement-dependent or frequency-dependent flow, and for valves with a lag.
pub(super) fn valves(s: &Situation, all: &mut Vec<Candidate>) {
    position_dependent_damping(s, all);
    frequency_selective_damping(s, all);
    valve_hysteresis(s, all);
}

/// Adds the candidates for a bypass or a groove that opens in a part of the stroke.
fn position_dependent_damping(s: &Situation, all: &mut Vec<Candidate>) {
    let (low, high) = s.reach;
    let (middle, span) = (0.5 * (low + high), 0.5 * (high - low));
    for (form, strength, start, names) in [
        (0.0, linear(number!("bypass_share"), (-1.0, 0.9)), 0.3, ["both strokes", "rebound", "compression"]),
        (
            1.0,
            linear(number!("bypass_flow"), (0.003, 2.0)),
            0.05,
            ["groove", "groove open in rebound", "groove open in compression"],
        ),
    ] {
        for (strokes, name) in [0.0, 1.0, 2.0].into_iter().zip(names) {
            all.push(Candidate {
                form: name,
                fixed: vec![(number!("bypass_strokes"), strokes), (number!("bypass_form"), form)],
                ..candidate(
                    &[element!("position_dependent_damping")],
                    vec![
                        strength.clone(),
                        linear(number!("bypass_centre"), (-0.1, 0.1)),
                        held(number!("bypass_half_width"), (0.003, 0.08), 0.8),
                        held(number!("bypass_blend"), (0.001, 0.03), 0.8),
                    ],
                    [-0.5, 0.0, 0.5]
                        .iter()
                        .flat_map(|c| [0.008, 0.02].map(|w| Start::at(&[start, middle + c * span, w, 0.005])))
                        .collect(),
                )
            });
        }
    }
}

/// Adds the candidates for flow that depends on the frequency: a bypass that closes, a filter of the force, or one of
/// the stroke.
fn frequency_selective_damping(s: &Situation, all: &mut Vec<Candidate>) {
    all.push(Candidate {
        form: "bypass",
        fixed: vec![(number!("fsd_form"), 2.0)],
        ..candidate(
            &[element!("frequency_selective_damping")],
            vec![
                linear(number!("fsd_flow"), (0.003, 2.0)),
                log(number!("fsd_time"), (5e-3, 0.5)),
                held(number!("fsd_force"), (5.0, 1000.0), 0.8),
                held(number!("fsd_laminar_force"), (2.0, 1e5), 1.5),
            ],
            [0.015, 0.05, 0.15].map(|t| Start::at(&[0.05, t, 0.3 * s.knee_force.max(100.0), 150.0])).to_vec(),
        )
    });
    for (form, name, times) in [(0.0, "filter", [0.01, 0.04, 0.15]), (1.0, "stroke", [0.015, 0.05, 0.15])] {
        all.push(Candidate {
            form: name,
            fixed: vec![(number!("fsd_form"), form)],
            ..candidate(
                &[element!("frequency_selective_damping")],
                vec![linear(number!("fsd_share"), (0.03, 0.8)), log(number!("fsd_time"), (5e-3, 0.5))],
                times.map(|t| Start::at(&[0.25, t])).to_vec(),
            )
        });
    }
}

/// Adds the candidates for valves that respond late, or open and close at different forces.
fn valve_hysteresis(s: &Situation, all: &mut Vec<Candidate>) {
    // Force at which the valves of the model open, N, from which the starts are computed.
    let knee = s.knee_force.max(50.0);
    moving_valves(knee, all);
    all.push(Candidate {
        form: "opens and closes at different forces",
        // With a time of 0.5 ms, the valve follows the force almost without delay, even in slow motion. Only the forces
        // then determine whether it is open.
        fixed: vec![(number!("valve_time"), 5e-4)],
        ..candidate(
            &[element!("valve_hysteresis")],
            vec![
                linear(number!("valve_hysteresis_share"), (0.01, 0.6)),
                log(number!("valve_opening_force"), (50.0, 3000.0)),
                linear(number!("valve_closing_ratio"), (0.3, 0.98)),
                held(number!("valve_width"), (10.0, 1500.0), 0.8),
            ],
            [0.5, 1.0, 1.8]
                .iter()
                .flat_map(|f| [0.5, 0.8].map(|closes| Start::at(&[0.15, f * knee, closes, 0.2 * f * knee])))
                .collect(),
        )
    });
    all.push(Candidate {
        fixed: vec![(number!("valve_closing_ratio"), 0.75)],
        ..candidate(
            &[element!("valve_hysteresis")],
            vec![
                linear(number!("valve_hysteresis_share"), (0.01, 0.6)),
                log(number!("valve_opening_force"), (50.0, 3000.0)),
                log(number!("valve_time"), (5e-4, 0.03)),
                held(number!("valve_width"), (20.0, 1500.0), 0.8),
            ],
            [0.5, 1.0, 1.8]
                .iter()
                .flat_map(|f| [2e-3, 6e-3].map(|t| Start::at(&[0.15, f * knee, t, 0.3 * f * knee])))
                .collect(),
        )
    });
}

/// Adds the candidates for a valve with play or with mass. `knee` is the force at which the valves open, N.
fn moving_valves(knee: f64, all: &mut Vec<Candidate>) {
    // A valve may open at any force above zero, and may open fully when its play is exceeded. Therefore, the plausible
    // ranges begin at 0.
    let stands = [log(number!("valve_opening_force"), (0.0, 3000.0)), held(number!("valve_width"), (0.0, 1500.0), 0.8)];
    for (form, place, lateness, starts) in [
        (
            "a valve with play",
            1.0,
            [log(number!("valve_play"), (5.0, 1000.0)), held(number!("valve_time"), (0.0, 5e-3), 0.8)],
            [0.05, 0.2].map(|play| [play * knee, 5e-4]),
        ),
        (
            "a valve with mass",
            2.0,
            [log(number!("valve_time"), (1.5e-4, 0.02)), held(number!("valve_damping"), (0.1, 3.0), 0.6)],
            [[7e-4, 0.7], [3e-3, 0.7]],
        ),
    ] {
        all.push(Candidate {
            form,
            fixed: vec![(number!("valve_form"), place)],
            ..candidate(
                &[element!("valve_hysteresis")],
                [lateness, stands.clone()].concat(),
                [0.3, 0.8]
                    .iter()
                    .flat_map(|f| starts.map(|[a, b]| Start::at(&[a, b, f * knee, 0.2 * f * knee])))
                    .collect(),
            )
        });
    }
}
