//! The effects that a diagnosis can name, each with the numbers it adds and where their search starts.
//!
//! One effect may come in several forms (a cap on rebound or on compression, a stop of rubber or of oil): they carry one
//! name, and the form that fits best speaks for it.

use super::hypothesis::{Free, Number, number};
use super::measurement::Artefact;
use super::situation::Situation;
use crate::identification::unknowns::Unknown;
use dashpot_core::Params;
use dashpot_core::elements;

/// A number that an effect brings along.
#[derive(Debug, Clone)]
pub struct Fresh {
    /// What it is.
    pub free: Free,
    /// Values that a damper or a rig shows; a finding outside is told.
    pub plausible: (f64, f64),
    /// Standard deviation of what is expected of it, in its own scale, where it is weakly determined by nature.
    pub deviation: Option<f64>,
}

/// Where a search begins.
#[derive(Debug, Clone)]
pub struct Start {
    /// Values of the fresh numbers in physical units, in their order.
    pub values: Vec<f64>,
    /// Numbers of the base that must move first, since the base stands where the effect hides: factors.
    pub moves: Vec<(&'static str, f64)>,
    /// A stroke (+1 rebound, −1 compression) whose FV branch is drawn on straight from its middle: a capped branch hides the
    /// cap.
    pub unbend: Option<f64>,
    /// Force, N, by which the FV curve's step about standstill shrinks: friction that the effect takes over.
    pub level: f64,
}

impl Start {
    fn at(values: &[f64]) -> Start {
        Start { values: values.to_vec(), moves: Vec::new(), unbend: None, level: 0.0 }
    }

    fn moving(values: &[f64], moves: &[(&'static str, f64)]) -> Start {
        Start { values: values.to_vec(), moves: moves.to_vec(), unbend: None, level: 0.0 }
    }
}

/// One form of one effect.
#[derive(Debug, Clone)]
pub struct Candidate {
    /// Name of the effect.
    pub effect: &'static str,
    /// Which form, where there are several.
    pub form: &'static str,
    /// Elements that it switches on.
    pub elements: &'static [&'static str],
    /// Parameters that it sets and leaves.
    pub fixed: Vec<(&'static str, f64)>,
    /// Numbers that it frees.
    pub fresh: Vec<Fresh>,
    /// Where to search.
    pub starts: Vec<Start>,
    /// Whether it fits a little of everything: it must then explain more than others to be named.
    pub sponge: bool,
    /// For a disagreement that has no name: what it looks like. It is never added; it keeps a known name from being given to
    /// what it explains better.
    pub unnamed: Option<&'static str>,
}

impl Candidate {
    /// Whether it is of the rig, not of the damper.
    pub fn is_artefact(&self) -> bool {
        self.elements.is_empty()
    }
}

fn log(name: &'static str, plausible: (f64, f64)) -> Fresh {
    Fresh { free: Free::Model(Unknown::Log(name)), plausible, deviation: None }
}

fn held(name: &'static str, plausible: (f64, f64), deviation: f64) -> Fresh {
    Fresh { deviation: Some(deviation), ..log(name, plausible) }
}

fn linear(name: &'static str, plausible: (f64, f64)) -> Fresh {
    Fresh { free: Free::Model(Unknown::Linear(name)), plausible, deviation: None }
}

/// Near an expected value by nature: `deviation` in its own unit.
fn near(name: &'static str, plausible: (f64, f64), deviation: f64) -> Fresh {
    Fresh { deviation: Some(deviation), ..linear(name, plausible) }
}

fn candidate(
    effect: &'static str,
    elements: &'static [&'static str],
    fresh: Vec<Fresh>,
    starts: Vec<Start>,
) -> Candidate {
    Candidate { effect, form: "", elements, fixed: Vec::new(), fresh, starts, sponge: false, unnamed: None }
}

fn grid(a: &[f64], b: &[f64]) -> Vec<Start> {
    a.iter().flat_map(|a| b.iter().map(|b| Start::at(&[*a, *b]))).collect()
}

/// All effects that could be added in a situation: those of elements that are not on, and those of the rig.
pub fn candidates(s: &Situation) -> Vec<Candidate> {
    let mut all = Vec::new();
    gas_and_springs(s, &mut all);
    friction(s, &mut all);
    series(s, &mut all);
    hydraulics(s, &mut all);
    stops(s, &mut all);
    measurement(s, &mut all);
    unnamed(&mut all);
    all.retain(|c| {
        let known = |name: &str| elements::names().any(|n| n == name);
        c.elements.iter().all(|e| known(e)) && (c.is_artefact() || !s.base.is_on(c.elements[0]))
    });
    all
}

fn gas_and_springs(s: &Situation, all: &mut Vec<Candidate>) {
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
            vec![linear("gas_stiffness", (100.0, 10_000.0)), held("gas_length", (0.06, 1.5), 1.0)],
            [0.07, 0.15, 0.4].map(|l| Start::at(&[1000.0, l])).to_vec(),
        )
    });
    all.push(Candidate {
        form: "takes time to cool",
        fixed: vec![("gas_adiabatic_index", 1.4)],
        ..candidate(
            "gas_spring",
            &["gas_spring"],
            vec![
                linear("gas_stiffness", (100.0, 10_000.0)),
                held("gas_length", (0.06, 1.5), 1.0),
                held("gas_thermal_time", (0.05, 60.0), 1.0),
            ],
            vec![Start::at(&[1000.0, 0.07, 2.0]), Start::at(&[1000.0, 0.15, 2.0]), Start::at(&[1000.0, 0.4, 2.0])],
        )
    });
    all.push(Candidate {
        sponge: true,
        ..candidate(
            "parallel_spring",
            &["parallel_spring"],
            vec![linear("spring_linear", (0.0, 20_000.0))],
            vec![Start::at(&[1000.0])],
        )
    });
    let _ = s;
}

/// Power of presliding friction from which it is refined.
const SLIPS: f64 = 1.5;
/// Speed below which its contacts creep, m/s.
const CREEPS: f64 = 1e-4;

fn friction(s: &Situation, all: &mut Vec<Candidate>) {
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
                    log("presliding_length", (3e-5, 5e-3)),
                    held("presliding_power", (1.0, 8.0), 0.7),
                    held("presliding_creep", (1e-7, 5e-3), 1.5),
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

fn series(s: &Situation, all: &mut Vec<Candidate>) {
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
                [6e-4, 2e-3].iter().flat_map(|d| lasts.map(|t| Start::at(&[*d, 0.3, t]))).collect(),
            )
        });
    }
    all.push(candidate(
        "free_play",
        &["free_play"],
        // A gap closes sharply; what softens over a hundred newtons is air.
        vec![log("free_play_gap", (2e-5, 1e-3)), held("free_play_force", (1.0, 40.0), 0.5)],
        grid(&[5e-5, 2e-4], &[8.0])
            .into_iter()
            .chain([Start::moving(&[1e-4, 8.0], &[("series_stiffness", 1.3)])])
            .collect(),
    ));
}

/// One over the length of an oil column, 1/m.
const COLUMN: f64 = 6.0;

fn hydraulics(s: &Situation, all: &mut Vec<Candidate>) {
    let stiffness = if s.base.is_on("series_compliance") { s.base.scalar("series_stiffness") } else { 2e6 };
    for (chambers, form) in [(0.0, "rebound chamber"), (1.0, "both chambers")] {
        all.push(Candidate {
            form,
            fixed: vec![("oil_chambers", chambers)],
            ..candidate(
                "oil_compressibility",
                &["oil_compressibility"],
                // A column of eight to fifty centimetres.
                vec![log("oil_stiffness", (3e5, 2e7)), near("oil_shortening", (0.0, 20.0), 4.0)],
                vec![
                    Start::at(&[1e7, COLUMN]),
                    Start::at(&[2.5e6, COLUMN]),
                    Start::at(&[7e5, COLUMN]),
                    Start::moving(&[2.0 * stiffness, COLUMN], &[("series_stiffness", 2.0)]),
                    Start::moving(&[1.3 * stiffness, COLUMN], &[("series_stiffness", 4.0)]),
                ],
            )
        });
    }
    all.push(candidate(
        "aeration",
        &["aeration"],
        vec![log("aeration_stroke", (2e-5, 3e-3)), held("aeration_force", (40.0, 1500.0), 0.8)],
        grid(&[1e-4, 4e-4], &[120.0, 300.0])
            .into_iter()
            .chain([Start::moving(&[2e-4, 200.0], &[("series_stiffness", 1.4)])])
            .collect(),
    ));
    for (side, stroke, top) in [(0.0, -1.0, s.top_compression), (1.0, 1.0, s.top_rebound)] {
        for kept in [1.0, 0.0] {
            all.push(Candidate {
                form: match (side == 0.0, kept == 1.0) {
                    (true, true) => "compression capped, gas pushes on",
                    (true, false) => "compression capped, dead return",
                    (false, true) => "rebound capped, force stays",
                    (false, false) => "rebound capped, dead return",
                },
                fixed: vec![("cavitation_side", side), ("cavitation_return", kept)],
                ..candidate(
                    "cavitation",
                    &["cavitation"],
                    vec![log("cavitation_force", (100.0, 5000.0))],
                    [0.98, 0.93, 0.85, 0.7]
                        .map(|share| Start { unbend: Some(stroke), ..Start::at(&[share * top]) })
                        .into_iter()
                        .chain([Start::at(&[0.9 * top])])
                        .collect(),
                )
            });
        }
    }
    all.push(Candidate {
        form: "foot valve does not refill",
        fixed: vec![("cavitation_form", 1.0), ("cavitation_side", 1.0)],
        ..candidate(
            "cavitation",
            &["cavitation"],
            vec![log("cavitation_unfilled", (0.003, 0.6)), held("cavitation_velocity", (0.03, 1.5), 0.7)],
            grid(&[0.01, 0.025, 0.06, 0.15], &[0.1, 0.25, 0.5]),
        )
    });
    if s.temperature_measured {
        all.push(Candidate {
            form: "measured temperature",
            fixed: vec![("fade_source", 0.0), ("fade_reference", s.temperature)],
            ..candidate(
                "temperature_fade",
                &["temperature_fade"],
                vec![linear("fade_coefficient", (0.001, 0.05)), held("fade_laminar_force", (50.0, 1e6), 1.2)],
                vec![Start::at(&[0.004, 1e4]), Start::at(&[0.01, 1e3])],
            )
        });
    } else {
        all.push(Candidate {
            form: "heated by its own work",
            fixed: vec![("fade_source", 1.0), ("fade_reference", 20.0), ("heat_capacity", 1000.0)],
            ..candidate(
                "temperature_fade",
                &["temperature_fade"],
                vec![
                    linear("fade_coefficient", (0.001, 0.05)),
                    Fresh { free: Free::Cooling, plausible: (5e-4, 3e-2), deviation: Some(1.2) },
                    held("fade_laminar_force", (50.0, 1e6), 1.2),
                ],
                vec![
                    Start::at(&[0.004, 2e-3, 1e4]),
                    Start::at(&[0.004, 1e-2, 1e4]),
                    Start::at(&[0.01, 2e-3, 1e3]),
                    Start::at(&[0.01, 1e-2, 1e3]),
                ],
            )
        });
    }
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
                // Four numbers fit a hump into anything.
                sponge: true,
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
            [0.015, 0.05, 0.15].map(|t| Start::at(&[0.05, t, 0.1 * s.knee_force.max(100.0), 150.0])).to_vec(),
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
    for (form, last, starts) in [
        ("lag", log("valve_time", (2e-4, 0.03)), [1e-3, 4e-3]),
        ("play", log("valve_play", (5.0, 1000.0)), [0.05 * knee, 0.2 * knee]),
    ] {
        all.push(Candidate {
            form,
            // A lag of its own at every force follows many loops.
            sponge: true,
            fixed: vec![("valve_form", 1.0), ("valve_time", 5e-4), ("valve_play", 0.0)],
            ..candidate(
                "valve_hysteresis",
                &["valve_hysteresis"],
                vec![
                    linear("valve_hysteresis_share", (0.02, 3.0)),
                    log("valve_opening_force", (30.0, 3000.0)),
                    last,
                    held("valve_width", (10.0, 1500.0), 0.8),
                ],
                [0.3, 0.8, 1.5]
                    .iter()
                    .flat_map(|f| starts.map(|t| Start::at(&[0.6, f * knee, t, 0.3 * f * knee])))
                    .collect(),
            )
        });
    }
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

fn stops(s: &Situation, all: &mut Vec<Candidate>) {
    let (low, high) = s.reach;
    for (effect, elements, names, reach) in [
        (
            "bump_stop",
            &["bump_stop"] as &'static [&'static str],
            [
                "bump_stop_clearance",
                "bump_stop_stiffness",
                "bump_stop_damping",
                "bump_stop_progression",
                "bump_stop_flow",
            ],
            -low,
        ),
        (
            "rebound_stop",
            &["rebound_stop"],
            [
                "rebound_stop_clearance",
                "rebound_stop_stiffness",
                "rebound_stop_damping",
                "rebound_stop_progression",
                "rebound_stop_flow",
            ],
            high,
        ),
    ] {
        if reach <= 1e-3 {
            continue;
        }
        let clearances = [0.5, 0.7, 0.85].map(|share| share * reach);
        all.push(Candidate {
            form: "rubber",
            ..candidate(
                effect,
                elements,
                vec![log(names[1], (500.0, 3e5)), linear(names[0], (0.01, 0.15)), held(names[3], (2e-3, 0.2), 1.0)],
                clearances.map(|c| Start::at(&[1e4, c, 0.02])).to_vec(),
            )
        });
        for (orifice, form) in [(0.0, "hydraulic, gap"), (1.0, "hydraulic, orifice")] {
            all.push(Candidate {
                form,
                fixed: vec![(names[1], 0.0), (names[4], orifice)],
                ..candidate(
                    effect,
                    elements,
                    vec![log(names[2], (100.0, 1e5)), linear(names[0], (0.01, 0.15)), held(names[3], (2e-3, 0.2), 1.0)],
                    clearances.iter().flat_map(|c| [500.0, 5e3].map(|d| Start::at(&[d, *c, 0.02]))).collect(),
                )
            });
        }
    }
}

fn measurement(s: &Situation, all: &mut Vec<Candidate>) {
    for (place, form) in [(0.0, "at the load cell"), (1.0, "inside, like oil in a long passage")] {
        all.push(Candidate {
            form,
            sponge: true,
            fixed: vec![("moving_mass_place", place)],
            ..candidate(
                "moving_mass",
                &["moving_mass"],
                vec![linear("moving_mass", (0.2, 30.0))],
                vec![Start::at(&[2.0])],
            )
        });
    }
    let rig = |artefact: Artefact, plausible: (f64, f64), values: &[f64]| Candidate {
        sponge: true,
        ..candidate(
            artefact.name(),
            &[],
            vec![Fresh { free: Free::Rig(artefact), plausible, deviation: None }],
            values.iter().map(|v| Start::at(&[*v])).collect(),
        )
    };
    all.push(rig(Artefact::Delay, (-4.9e-3, 4.9e-3), &[3e-4, -3e-4]));
    if !s.base.is_on("gas_preload") {
        all.push(rig(Artefact::Offset, (-200.0, 200.0), &[10.0]));
    }
    if s.clock_span > 1.0 {
        for pause in &s.pauses {
            all.push(Candidate {
                form: "zero set anew during the campaign",
                ..rig(Artefact::Step(*pause), (-200.0, 200.0), &[10.0])
            });
        }
        all.push(rig(Artefact::Drift, (-0.2, 0.2), &[10.0 / s.clock_span]));
        for share in [0.07, 0.15, 0.3, 0.6] {
            let time = ((share * s.clock_span) as u32).max(1);
            all.push(Candidate {
                form: "settles as the rig warms up",
                ..rig(Artefact::WarmUp(time), (-200.0, 200.0), &[10.0])
            });
        }
    }
}

/// What a rig may add that the vocabulary has no name for.
fn unnamed(all: &mut Vec<Candidate>) {
    let fresh = |artefact: Artefact| Fresh {
        free: Free::Rig(artefact),
        plausible: (-artefact.limit(), artefact.limit()),
        deviation: None,
    };
    all.push(Candidate {
        unnamed: Some("friction that grows with the force, as a tilted cross-head or eye makes in the guides"),
        ..candidate(
            Artefact::Guide.name(),
            &[],
            vec![fresh(Artefact::Guide), fresh(Artefact::GuideAlong)],
            vec![Start::at(&[0.03, 0.1])],
        )
    });
    for width in [50, 150, 400] {
        all.push(Candidate {
            unnamed: Some("a loop over force whatever the speed, as a load cell with hysteresis draws"),
            ..candidate(Artefact::Loop(width).name(), &[], vec![fresh(Artefact::Loop(width))], vec![Start::at(&[0.02])])
        });
    }
}

/// Masses of a rod with what moves with it, kg. A free internal mass would stand for any mass on the rig.
const ROD: (f64, f64) = (0.02, 0.6);

fn rod_mass(base: &Params) -> Number {
    let mut base = *base;
    let _ = base.set("internal_mass", base.scalar("internal_mass").clamp(ROD.0, ROD.1));
    Number { bounds: (ROD.0.ln(), ROD.1.ln()), ..number(&base, Unknown::Log("internal_mass"), Some(1.0)) }
}

/// The numbers of the base model that a refit may change.
pub fn base_numbers(base: &Params) -> Vec<Number> {
    use crate::identification::unknowns::{CurveName, Unknowns};
    let mut list = Vec::new();
    let on = |name: &str| base.is_on(name);
    if on("series_compliance") {
        list.push(rod_mass(base));
    }
    let mut add = |unknown: Unknown, prior: Option<f64>| list.push(number(base, unknown, prior));
    for rise in Unknowns::rises(base, CurveName::Fv) {
        add(rise, None);
    }
    if on("series_compliance") {
        add(Unknown::Log("series_stiffness"), Some(1.5));
        add(Unknown::Linear("series_damping"), Some(0.5 * base.scalar("series_damping").abs().max(200.0)));
    }
    if on("parallel_spring") {
        for name in ["spring_linear", "spring_quadratic", "spring_cubic", "spring_quartic"] {
            if base.scalar(name) != 0.0 {
                add(Unknown::Linear(name), None);
            }
        }
        if base.list("spring_displacement").len() > 2 {
            for rise in Unknowns::rises(base, CurveName::Spring) {
                add(rise, None);
            }
        }
    }
    if on("gas_preload") {
        add(Unknown::Linear("gas_force"), None);
    }
    if on("coulomb_friction") {
        add(Unknown::Linear("coulomb_force"), None);
        add(Unknown::Log("coulomb_steepness"), Some(0.5));
    }
    if on("stribeck_friction") {
        add(Unknown::Linear("stribeck_coulomb_force"), None);
        add(Unknown::Above("stribeck_breakaway_force", "stribeck_coulomb_force"), Some(0.5));
        add(Unknown::Log("stribeck_breakaway_velocity"), Some(0.7));
    }
    if on("viscous_friction") {
        add(Unknown::Linear("viscous_coefficient"), Some(0.3 * base.scalar("viscous_coefficient").abs().max(10.0)));
    }
    if on("side_force_friction") {
        add(Unknown::Linear("side_force_coefficient"), None);
    }
    list
}
