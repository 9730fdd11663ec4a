//! What yields between the ends and the piston: mounts, play.

use super::{Candidate, Start, candidate, grid, held, linear, log};
use crate::diagnosis::situation::Situation;

/// Adds them.
pub(super) fn series(s: &Situation, all: &mut Vec<Candidate>) {
    all.push(candidate(
        "series_compliance",
        &["series_compliance"],
        vec![log("series_stiffness", (1e5, 2e7))],
        [3e5, 1e6, 4e6].map(|k| Start::at(&[k])).to_vec(),
    ));
    if !s.base.is_on("series_compliance") {
        return;
    }
    for (form, fixed, last, lasts) in [
        ("relaxes", ("bushing_slip", 1e3), held("bushing_loss_time", (1e-3, 0.3), 1.0), [5e-3, 3e-2]),
        ("friction in the rubber", ("bushing_loss_time", 1e3), held("bushing_slip", (5e-6, 2e-3), 1.0), [3e-5, 2e-4]),
    ] {
        all.push(Candidate {
            form,
            // Two stiffnesses and a time follow any lag.
            sponge: true,
            fixed: vec![fixed],
            ..candidate(
                "bushing",
                &["bushing"],
                vec![log("bushing_hardening", (2e-4, 2e-2)), linear("bushing_loss_stiffness", (0.02, 3.0)), last],
                [2.5e-4, 6e-4, 2e-3]
                    .iter()
                    .flat_map(|d| lasts.map(|t| Start::at(&[*d, 0.3, t])))
                    // The base has the stiffness of the working deflection: less at small ones.
                    .chain([3e-4, 1e-3].map(|d| Start::moving(&[d, 0.5, lasts[0]], &[("series_stiffness", 0.6)])))
                    .collect(),
            )
        });
    }
    let stop = [log("bushing_stop", (1e-4, 1.0)), linear("bushing_stop_stiffness", (0.0, 60.0))];
    // The base has a stiffness between those before and after the stop.
    let top = 0.5 * (s.top_rebound + s.top_compression) / s.base.scalar("series_stiffness");
    let softer = |values: &dyn Fn(f64, f64) -> Vec<f64>| {
        [0.12, 0.25, 0.5]
            .iter()
            .flat_map(|part| {
                [0.3, 0.6].map(|k| {
                    let stop = (part * top / k).clamp(5e-5, 2e-2);
                    Start::moving(&values(stop, 0.7 / k), &[("series_stiffness", k)])
                })
            })
            .collect()
    };
    for (form, fixed, losses, starts) in [
        (
            "relaxes over decades and meets a stop",
            ("bushing_slip", 1e3),
            vec![
                linear("bushing_loss_stiffness", (0.0, 15.0)),
                held("bushing_loss_time", (0.0, 0.3), 0.7),
                linear("bushing_slow_stiffness", (0.0, 15.0)),
                held("bushing_slow_time", (2e-3, 10.0), 0.7),
            ],
            softer(&|stop, adds| vec![stop, adds, 0.3, 6e-3, 0.3, 0.07]),
        ),
        (
            "friction in the rubber, and a stop",
            ("bushing_loss_time", 1e3),
            vec![linear("bushing_loss_stiffness", (0.0, 15.0)), held("bushing_slip", (5e-6, 2e-3), 1.0)],
            softer(&|stop, adds| vec![stop, adds, 0.3, 1e-4]),
        ),
    ] {
        all.push(Candidate {
            form,
            sponge: true,
            fixed: vec![("bushing_hardening", 1.0), fixed],
            ..candidate("bushing", &["bushing"], [&stop[..], &losses].concat(), starts)
        });
    }
    all.push(candidate(
        "free_play",
        &["free_play"],
        // A gap closes however sharply; what softens over a hundred newtons is air.
        vec![log("free_play_gap", (2e-5, 1e-3)), held("free_play_force", (0.0, 40.0), 0.5)],
        grid(&[5e-5, 2e-4], &[8.0])
            .into_iter()
            .chain([Start::moving(&[1e-4, 8.0], &[("series_stiffness", 1.3)])])
            .collect(),
    ));
}
