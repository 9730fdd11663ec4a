//! Compliance between the ends and the piston: mounts, play.

use super::{Candidate, Fresh, Start, candidate, grid, held, linear, log, near};
use crate::situation::Situation;
use dashpot_core::parameter::Number;
use dashpot_core::{element, number};

/// Energy loss of rubber: the fixed parameter that disables the other loss mechanism, and the free parameter of the
/// chosen mechanism.
type Loss = ((Number, f64), Fresh);

fn by_time() -> Loss {
    ((number!("bushing_slip"), 1e3), held(number!("bushing_loss_time"), (1e-3, 0.3), 1.0))
}

fn by_friction() -> Loss {
    ((number!("bushing_loss_time"), 1e3), held(number!("bushing_slip"), (5e-6, 2e-3), 1.0))
}

/// Adds the candidates for the series path.
pub(super) fn series(s: &Situation, all: &mut Vec<Candidate>) {
    series_compliance(s, all);
    if !s.base.is_on(element!("series_compliance")) {
        return;
    }
    bushing(all);
    bushing_with_stop(s, all);
    free_play(all);
    carrying_the_whole(s, all);
}

/// Adds the candidates for a series spring.
fn series_compliance(s: &Situation, all: &mut Vec<Candidate>) {
    // Friction without presliding that acts behind a soft spring resembles presliding friction. In one slow test, the
    // estimate was a mount of 0.25 N/µm that did not exist. Therefore, the form [`CARRIES_WHOLE`] requires presliding
    // friction.
    let whole = s.base.is_on(element!("presliding_friction")).then_some((CARRIES_WHOLE, 1.0));
    for (form, load) in [Some(("", 0.0)), whole].into_iter().flatten() {
        all.push(Candidate {
            form,
            fixed: vec![(number!("series_load"), load)],
            ..candidate(
                &[element!("series_compliance")],
                vec![
                    log(number!("series_stiffness"), (1e5, 2e7)),
                    near(number!("series_damping"), (0.0, 5e3), 200.0),
                    held(number!("internal_mass"), (0.02, 5.0), 0.6),
                ],
                [3e5, 1e6, 4e6].map(|k| Start::at(&[k, 200.0, 0.4])).to_vec(),
            )
        });
    }
}

/// Adds the candidates for rubber that hardens and relaxes, or has friction.
fn bushing(all: &mut Vec<Candidate>) {
    for (form, (fixed, last), lasts) in
        [("relaxes", by_time(), [5e-3, 3e-2]), ("friction in the rubber", by_friction(), [3e-5, 2e-4])]
    {
        all.push(Candidate {
            form,
            fixed: vec![fixed],
            ..candidate(
                &[element!("bushing")],
                vec![
                    log(number!("bushing_hardening"), (2e-4, 2e-2)),
                    linear(number!("bushing_loss_stiffness"), (0.02, 3.0)),
                    last,
                ],
                [2.5e-4, 6e-4, 2e-3]
                    .iter()
                    .flat_map(|d| lasts.map(|t| Start::at(&[*d, 0.3, t])))
                    // The base has the stiffness at the working deflection; the stiffness at small deflections is
                    // lower.
                    .chain(
                        [3e-4, 1e-3].map(|d| Start::moving(&[d, 0.5, lasts[0]], &[(number!("series_stiffness"), 0.6)])),
                    )
                    .collect(),
            )
        });
    }
}

/// Adds the candidates for rubber that meets a stop.
fn bushing_with_stop(s: &Situation, all: &mut Vec<Candidate>) {
    let stop = [log(number!("bushing_stop"), (1e-4, 1.0)), linear(number!("bushing_stop_stiffness"), (0.0, 60.0))];
    // The stiffness of the base is between the stiffnesses before and after the stop.
    let top = 0.5 * (s.top_rebound + s.top_compression) / s.base.number(number!("series_stiffness"));
    let softer = |values: &dyn Fn(f64, f64) -> Vec<f64>| {
        [0.12, 0.25, 0.5]
            .iter()
            .flat_map(|part| {
                [0.3, 0.6].map(|k| {
                    let stop = (part * top / k).clamp(5e-5, 2e-2);
                    Start::moving(&values(stop, 0.7 / k), &[(number!("series_stiffness"), k)])
                })
            })
            .collect()
    };
    for (form, fixed, losses, starts) in [
        (
            "relaxes over decades and meets a stop",
            (number!("bushing_slip"), 1e3),
            vec![
                linear(number!("bushing_loss_stiffness"), (0.0, 15.0)),
                held(number!("bushing_loss_time"), (0.0, 0.3), 0.7),
                linear(number!("bushing_slow_stiffness"), (0.0, 15.0)),
                held(number!("bushing_slow_time"), (2e-3, 10.0), 0.7),
            ],
            softer(&|stop, adds| vec![stop, adds, 0.3, 6e-3, 0.3, 0.07]),
        ),
        (
            "friction in the rubber, and a stop",
            (number!("bushing_loss_time"), 1e3),
            vec![
                linear(number!("bushing_loss_stiffness"), (0.0, 15.0)),
                held(number!("bushing_slip"), (5e-6, 2e-3), 1.0),
            ],
            softer(&|stop, adds| vec![stop, adds, 0.3, 1e-4]),
        ),
    ] {
        all.push(Candidate {
            form,
            fixed: vec![(number!("bushing_hardening"), 1.0), fixed],
            ..candidate(&[element!("bushing")], [&stop[..], &losses].concat(), starts)
        });
    }
}

/// Adds the candidates for play, without and with a load that opens the gap.
fn free_play(all: &mut Vec<Candidate>) {
    all.push(candidate(
        &[element!("free_play")],
        // A gap closes within a few newtons. If the transition extends over a hundred newtons, the cause is air.
        vec![log(number!("free_play_gap"), (2e-5, 1e-3)), held(number!("free_play_force"), (0.0, 40.0), 0.5)],
        grid(&[5e-5, 2e-4], &[8.0])
            .into_iter()
            // For a wider gap, the base has absorbed the gap with a softer series spring, so the start stiffens the
            // spring.
            .chain(
                [(1e-4, 1.3), (3e-4, 2.0), (8e-4, 4.0)]
                    .map(|(gap, stiffer)| Start::moving(&[gap, 8.0], &[(number!("series_stiffness"), stiffer)])),
            )
            .collect(),
    ));
    // Weight, gas and clamping increase or decrease the force at which the gap opens. The starts are about one and two
    // standard deviations of the load's prior away from zero. From there, the search converges to the optimum. Gap and
    // stiffness factor of these starts lie within those of the starts above.
    all.push(Candidate {
        form: "opens under a load",
        ..candidate(
            &[element!("free_play")],
            vec![
                log(number!("free_play_gap"), (2e-5, 1e-3)),
                held(number!("free_play_force"), (0.0, 60.0), 0.5),
                near(number!("free_play_load"), (-250.0, 250.0), 60.0),
            ],
            [-120.0, -45.0, 45.0, 120.0]
                .map(|load| Start::moving(&[2e-4, 15.0, load], &[(number!("series_stiffness"), 1.5)]))
                .to_vec(),
        )
    });
}

/// Form of the series spring as an eye or a mount, which also carries friction and gas. The other form is the oil,
/// which carries only the force of the valves.
pub const CARRIES_WHOLE: &str = "friction and gas act behind it";

/// Returns whether the damper has forces that a series spring of the form [`CARRIES_WHOLE`] carries in addition to the
/// hydraulic force.
fn carries_more(s: &Situation) -> bool {
    [
        element!("coulomb_friction"),
        element!("stribeck_friction"),
        element!("side_force_friction"),
        element!("presliding_friction"),
        element!("gas_preload"),
        element!("gas_spring"),
    ]
    .iter()
    .any(|element| s.base.is_on(*element))
}

/// Factors on the series stiffness of the base: the first gives the oil column, the second the series spring in front
/// of it.
///
/// The series spring is an eye or mount that also carries friction and gas.
const BEHIND: [(f64, f64); 2] = [(1.3, 2.5), (3.0, 1.2)];

/// Adds play and rubber in an eye or a mount, which carries the whole force. The series compliance of the base then
/// belongs to the oil behind it, which carries only the hydraulic force.
fn carrying_the_whole(s: &Situation, all: &mut Vec<Candidate>) {
    let carries_it = s.base.number(number!("series_load")) == 1.0;
    if carries_it || s.base.is_on(element!("oil_compressibility")) || !carries_more(s) {
        return;
    }
    let stiffness = s.base.number(number!("series_stiffness"));
    let whole = || {
        vec![
            (number!("series_load"), 1.0),
            (number!("oil_shortening"), 0.0),
            (number!("oil_chambers"), 1.0),
            (number!("oil_compression"), 1.0),
        ]
    };
    let oil = || held(number!("oil_stiffness"), (1e5, 1e8), 0.7);
    all.push(Candidate {
        form: "all of the force goes through it",
        fixed: whole(),
        ..candidate(
            &[element!("free_play"), element!("oil_compressibility")],
            vec![
                log(number!("free_play_gap"), (2e-5, 1e-3)),
                held(number!("free_play_force"), (0.0, 40.0), 0.5),
                oil(),
            ],
            // For a wider gap, the base has absorbed the gap with a softer series spring, so the oil column starts
            // stiffer.
            [(4e-5, 1.2), (4e-5, 1.7), (1e-4, 1.3), (1e-4, 1.8), (3e-4, 2.5)]
                .map(|(gap, behind)| {
                    Start::moving(&[gap, 4.0, behind * stiffness], &[(number!("series_stiffness"), 5.0)])
                })
                .to_vec(),
        )
    });
    for (form, (fixed, last), at) in [
        ("relaxes, and all of the force goes through it", by_time(), 1e-2),
        ("friction in the rubber, and all of the force goes through it", by_friction(), 1e-4),
    ] {
        let starts = BEHIND.iter().flat_map(|(behind, series)| {
            [5e-4, 3e-3]
                .map(|d| Start::moving(&[d, 0.5, at, behind * stiffness], &[(number!("series_stiffness"), *series)]))
        });
        all.push(Candidate {
            form,
            fixed: [whole(), vec![fixed]].concat(),
            ..candidate(
                &[element!("bushing"), element!("oil_compressibility")],
                vec![
                    // Rubber without hardening is also plausible, so the deflection of hardening has no upper limit.
                    log(number!("bushing_hardening"), (2e-4, f64::INFINITY)),
                    linear(number!("bushing_loss_stiffness"), (0.02, 3.0)),
                    last,
                    oil(),
                ],
                starts.collect(),
            )
        });
    }
}
