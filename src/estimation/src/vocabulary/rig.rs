//! Errors of the rig: mass on the load cell, delayed channels, zero offsets and drifts.

use super::{Candidate, Start, candidate, fresh, linear, of_the_rig};
use crate::hypothesis::Free;
use crate::measurement::Artefact;
use crate::situation::Situation;
use dashpot_core::{element, number};

/// Largest plausible zero offset of a load cell, N.
const OFF: f64 = 200.0;

/// Adds the candidates for mass on the rig and for measurement errors.
pub(super) fn rig(s: &Situation, all: &mut Vec<Candidate>) {
    for (place, form) in [(0.0, "at the load cell"), (1.0, "inside, like oil in a long passage")] {
        all.push(Candidate {
            form,
            // The lag of the inertia force is fixed at a tenth of a millisecond. At 25 Hz, this lag causes an error of
            // 1.6 %.
            fixed: vec![(number!("moving_mass_place"), place), (number!("moving_mass_time"), 1e-4)],
            ..candidate(
                &[element!("moving_mass")],
                vec![linear(number!("moving_mass"), (0.2, 30.0))],
                vec![
                    Start::at(&[2.0]),
                    // The series stiffness of the base may have absorbed the mass by an increase or a decrease.
                    Start::moving(&[4.0], &[(number!("series_stiffness"), 0.5)]),
                    Start::moving(&[4.0], &[(number!("series_stiffness"), 2.0)]),
                ],
            )
        });
    }
    all.push(Candidate {
        form: "on the load cell",
        ..of_the_rig(
            Artefact::Mass,
            vec![fresh(Free::Rig(Artefact::Mass), (0.2, 30.0))],
            vec![Start::at(&[2.0]), Start::moving(&[2.0], &[(number!("series_stiffness"), 2.0)])],
        )
    });
    let added = |artefact: Artefact, plausible: (f64, f64), values: &[f64]| Candidate {
        ..of_the_rig(
            artefact,
            vec![fresh(Free::Rig(artefact), plausible)],
            values.iter().map(|v| Start::at(&[*v])).collect(),
        )
    };
    // A delayed force has the effect of a soft mount, so the series spring of the base may have absorbed the delay.
    let stiffer = || Start::moving(&[1e-3], &[(number!("series_stiffness"), 3.0)]);
    all.push(Candidate {
        starts: [3e-4, -3e-4, s.apparent_delay]
            .into_iter()
            .filter(|delay| *delay != 0.0)
            .map(|delay| Start::at(&[delay]))
            .chain([stiffer()])
            .collect(),
        ..added(Artefact::Delay, (-4.9e-3, 4.9e-3), &[])
    });
    all.push(Candidate {
        form: "low-pass filter of the force channel",
        starts: vec![Start::at(&[3e-4]), stiffer()],
        ..added(Artefact::LowPass, (1e-6, 4.9e-3), &[])
    });
    if !s.base.is_on(element!("gas_preload")) {
        all.push(added(Artefact::Offset, (-OFF, OFF), &[10.0]));
    }
    if s.clock_span > 1.0 {
        for pause in &s.pauses {
            all.push(Candidate {
                form: "zero set anew during the campaign",
                ..added(Artefact::Step(*pause), (-OFF, OFF), &[10.0])
            });
        }
        all.push(added(Artefact::GainDrift, (-0.2 / s.clock_span, 0.2 / s.clock_span), &[0.01 / s.clock_span]));
        // The drift, N/s, may reach the largest zero offset during the campaign. In a long campaign, at least 0.2 N/s
        // is plausible.
        let most = (OFF / s.clock_span).max(0.2);
        all.push(added(Artefact::Drift, (-most, most), &[10.0 / s.clock_span]));
        for share in [0.07, 0.15, 0.3, 0.6] {
            let time = ((share * s.clock_span) as u32).max(1);
            all.push(Candidate {
                form: "settles as the rig warms up",
                ..added(Artefact::WarmUp(time), (-OFF, OFF), &[10.0])
            });
        }
    }
}
