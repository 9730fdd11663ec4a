//! Stops at the ends of the stroke.

use super::{Candidate, Start, candidate, held, linear, log};
use crate::situation::Situation;
use crate::spring_end::excess;
use dashpot_core::parameter::Element;
use dashpot_core::{element, number};

/// Adds the candidates for stops.
pub(super) fn stops(s: &Situation, all: &mut Vec<Candidate>) {
    let (low, high) = s.reach;
    for (elements, names, side, reach) in [
        (
            &[element!("bump_stop")] as &'static [Element],
            [
                number!("bump_stop_clearance"),
                number!("bump_stop_stiffness"),
                number!("bump_stop_damping"),
                number!("bump_stop_progression"),
                number!("bump_stop_flow"),
            ],
            -1.0,
            -low,
        ),
        (
            &[element!("rebound_stop")],
            [
                number!("rebound_stop_clearance"),
                number!("rebound_stop_stiffness"),
                number!("rebound_stop_damping"),
                number!("rebound_stop_progression"),
                number!("rebound_stop_flow"),
            ],
            1.0,
            high,
        ),
    ] {
        if reach <= 1e-3 {
            continue;
        }
        let hidden = excess(&s.base, side);
        let clearances = [0.4, 0.5, 0.6, 0.7, 0.8, 0.9].map(|share| share * reach);
        all.push(Candidate {
            form: "rubber",
            ..candidate(
                elements,
                vec![log(names[1], (500.0, 3e5)), linear(names[0], (0.01, 0.15)), held(names[3], (2e-3, 0.2), 1.0)],
                clearances
                    .map(|c| Start::at(&[1e4, c, 0.02]))
                    .into_iter()
                    // The end of the base's lookup spring may have absorbed the stop.
                    .chain(
                        clearances.into_iter().filter(|_| hidden > 0.0).map(|c| Start {
                            straighten: Some(side),
                            ..Start::at(&[0.5 * hidden / (reach - c), c, 0.02])
                        }),
                    )
                    .collect(),
            )
        });
        for (orifice, form) in [(0.0, "hydraulic, gap"), (1.0, "hydraulic, orifice")] {
            all.push(Candidate {
                form,
                fixed: vec![(names[1], 0.0), (names[4], orifice)],
                ..candidate(
                    elements,
                    // If a gap narrows progressively, the damping at its entrance is almost zero, so small values are
                    // plausible.
                    vec![log(names[2], (1.0, 1e5)), linear(names[0], (0.01, 0.15)), held(names[3], (0.0, 0.2), 1.0)],
                    clearances.iter().flat_map(|c| [500.0, 5e3].map(|d| Start::at(&[d, *c, 0.02]))).collect(),
                )
            });
        }
    }
}
