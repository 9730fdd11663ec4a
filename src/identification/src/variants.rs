//! The variants of friction and spring, and the choice among them by tests that the fit did not see.

use super::more_points::with_points;
use super::of_the_rig::OfTheRig;
use super::phrases;
use dashpot_core::Params;
use dashpot_core::parameter::{Element, Number};
use dashpot_core::{element, list, number};
use dashpot_estimation::least_squares::{Effort, left_out_errors, solve};
use dashpot_estimation::priors::unusual;
use dashpot_estimation::scale::Scale;
use dashpot_estimation::segment::Segment;
use dashpot_estimation::spring_end::excess;
use dashpot_estimation::unknowns::{CurveName, Unknown, Unknowns};
use dashpot_records::Sentence;
use dashpot_records::sentence::Template;
use rayon::prelude::*;
use serde::Serialize;

/// Relative fall of the error that one more parameter must bring to be worth having.
const WORTH: f64 = 0.02;
/// Points of the lookup spring.
const LOOKUP_POINTS: usize = 7;

/// How a variant is told apart from its rivals.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Variant {
    /// Name in the report.
    pub name: &'static str,
    /// The same where the damper is rigid in series: friction that turns over within a distance and a soft series path look alike, and
    /// which of them a damper has is chosen with it.
    pub rigid: &'static str,
    /// Elements that it switches on.
    pub elements: &'static [Element],
    /// Its unknowns.
    unknowns: &'static [Unknown],
    /// Whether the points of the lookup spring are unknowns too.
    lookup: bool,
    /// Numbers that it sets.
    choices: &'static [(Number, f64)],
    /// Whether a host that holds the force over a step of 1 ms can run it: friction that turns over within a step chatters there.
    runs_in_real_time: bool,
}

/// Friction variants, simplest first (thesis 3.1–3.7).
pub const FRICTION: &[Variant] = &[
    Variant {
        name: "none",
        rigid: "none, rigid in series",
        elements: &[],
        unknowns: &[],
        lookup: false,
        choices: &[],
        runs_in_real_time: true,
    },
    Variant {
        name: "Coulomb",
        rigid: "Coulomb, rigid in series",
        elements: &[element!("coulomb_friction")],
        unknowns: &[Unknown::Linear(number!("coulomb_force")), Unknown::Log(number!("coulomb_steepness"))],
        lookup: false,
        choices: &[],
        runs_in_real_time: false,
    },
    Variant {
        name: "Coulomb + viscous",
        rigid: "Coulomb + viscous, rigid in series",
        elements: &[element!("coulomb_friction"), element!("viscous_friction")],
        unknowns: &[
            Unknown::Linear(number!("coulomb_force")),
            Unknown::Log(number!("coulomb_steepness")),
            Unknown::Linear(number!("viscous_coefficient")),
        ],
        lookup: false,
        choices: &[],
        runs_in_real_time: false,
    },
    Variant {
        name: "simplified Stribeck",
        rigid: "simplified Stribeck, rigid in series",
        elements: &[element!("stribeck_friction")],
        unknowns: &[
            Unknown::Linear(number!("stribeck_coulomb_force")),
            Unknown::Above(number!("stribeck_breakaway_force"), number!("stribeck_coulomb_force")),
            Unknown::Log(number!("stribeck_breakaway_velocity")),
        ],
        lookup: false,
        choices: &[(number!("stribeck_form"), 0.0)],
        runs_in_real_time: false,
    },
    Variant {
        name: "full Stribeck",
        rigid: "full Stribeck, rigid in series",
        elements: &[element!("stribeck_friction")],
        unknowns: &[
            Unknown::Linear(number!("stribeck_coulomb_force")),
            Unknown::Above(number!("stribeck_breakaway_force"), number!("stribeck_coulomb_force")),
            Unknown::Log(number!("stribeck_breakaway_velocity")),
            Unknown::Log(number!("stribeck_velocity")),
        ],
        lookup: false,
        choices: &[(number!("stribeck_form"), 1.0)],
        runs_in_real_time: false,
    },
    Variant {
        name: "presliding",
        rigid: "presliding, rigid in series",
        elements: &[element!("presliding_friction")],
        unknowns: &[Unknown::Linear(number!("presliding_force")), Unknown::Log(number!("presliding_length"))],
        lookup: false,
        choices: &[(number!("presliding_power"), 1.0)],
        runs_in_real_time: true,
    },
    Variant {
        name: "shaped presliding",
        rigid: "shaped presliding, rigid in series",
        elements: &[element!("presliding_friction")],
        unknowns: &[
            Unknown::Linear(number!("presliding_force")),
            Unknown::Log(number!("presliding_length")),
            Unknown::Log(number!("presliding_power")),
        ],
        lookup: false,
        choices: &[],
        runs_in_real_time: true,
    },
];

/// Spring variants, simplest first (thesis 3, F_p).
pub const SPRING: &[Variant] = &[
    Variant {
        name: "none",
        rigid: "none, rigid in series",
        elements: &[],
        unknowns: &[],
        lookup: false,
        choices: &[],
        runs_in_real_time: true,
    },
    Variant {
        name: "linear",
        rigid: "linear, rigid in series",
        elements: &[element!("parallel_spring")],
        unknowns: &[Unknown::Linear(number!("spring_linear"))],
        lookup: false,
        choices: &[],
        runs_in_real_time: true,
    },
    Variant {
        name: "quadratic",
        rigid: "quadratic, rigid in series",
        elements: &[element!("parallel_spring")],
        unknowns: &[Unknown::Linear(number!("spring_quadratic"))],
        lookup: false,
        choices: &[],
        runs_in_real_time: true,
    },
    Variant {
        name: "cubic",
        rigid: "cubic, rigid in series",
        elements: &[element!("parallel_spring")],
        unknowns: &[Unknown::Linear(number!("spring_cubic"))],
        lookup: false,
        choices: &[],
        runs_in_real_time: true,
    },
    Variant {
        name: "quartic",
        rigid: "quartic, rigid in series",
        elements: &[element!("parallel_spring")],
        unknowns: &[Unknown::Linear(number!("spring_quartic"))],
        lookup: false,
        choices: &[],
        runs_in_real_time: true,
    },
    Variant {
        name: "lookup",
        rigid: "lookup, rigid in series",
        elements: &[element!("parallel_spring")],
        unknowns: &[],
        lookup: true,
        choices: &[],
        runs_in_real_time: true,
    },
];

/// Physical laws that a curved spring may stand for. A table or a power that has taken up a stop or a gas column draws it through a
/// few points; the law itself has fewer numbers, goes on beyond the records as the part does, and has a name.
pub const PHYSICAL_SPRING: &[Variant] = &[
    Variant {
        name: "linear, gas column",
        rigid: "linear, gas column, rigid in series",
        elements: &[element!("parallel_spring"), element!("gas_spring")],
        unknowns: &[
            Unknown::Linear(number!("spring_linear")),
            Unknown::Linear(number!("gas_stiffness")),
            Unknown::Log(number!("gas_length")),
            Unknown::Log(number!("gas_thermal_time")),
        ],
        lookup: false,
        choices: &[],
        runs_in_real_time: true,
    },
    Variant {
        name: "linear, bump stop",
        rigid: "linear, bump stop, rigid in series",
        elements: &[element!("parallel_spring"), element!("bump_stop")],
        unknowns: &[
            Unknown::Linear(number!("spring_linear")),
            Unknown::Linear(number!("bump_stop_clearance")),
            Unknown::Log(number!("bump_stop_stiffness")),
            Unknown::Log(number!("bump_stop_progression")),
        ],
        lookup: false,
        choices: &[(number!("bump_stop_damping"), 0.0)],
        runs_in_real_time: true,
    },
    Variant {
        name: "linear, rebound stop",
        rigid: "linear, rebound stop, rigid in series",
        elements: &[element!("parallel_spring"), element!("rebound_stop")],
        unknowns: &[
            Unknown::Linear(number!("spring_linear")),
            Unknown::Linear(number!("rebound_stop_clearance")),
            Unknown::Log(number!("rebound_stop_stiffness")),
            Unknown::Log(number!("rebound_stop_progression")),
        ],
        lookup: false,
        choices: &[(number!("rebound_stop_damping"), 0.0)],
        runs_in_real_time: true,
    },
];

/// Shares of the reach of the tests at which a stop is first looked for: it lies somewhere between the middle of the stroke and its end,
/// and a start beyond it on either side finds the way.
const CLEARANCES: [f64; 3] = [0.5, 0.7, 0.85];
/// Lengths, m, of a gas column that is looked for: a short one stiffens within the stroke.
const COLUMNS: [f64; 2] = [0.1, 0.3];
/// First stiffness of a stop of a car, N/m, that no table has drawn.
const STOP: f64 = 1e4;
/// The stops, with the side on which each lies, and their numbers that a fit starts from.
const STOPS: [(Element, f64, Number, Number); 2] = [
    (element!("bump_stop"), -1.0, number!("bump_stop_clearance"), number!("bump_stop_stiffness")),
    (element!("rebound_stop"), 1.0, number!("rebound_stop_clearance"), number!("rebound_stop_stiffness")),
];
/// Coefficients of the powers of a spring, that of the straight one first.
const POWERS: [Number; 4] =
    [number!("spring_linear"), number!("spring_quadratic"), number!("spring_cubic"), number!("spring_quartic")];

impl Variant {
    /// Whether it is a spring that a stop or a gas column may have bent.
    pub fn is_curved(&self) -> bool {
        let [_, curved @ ..] = &POWERS;
        self.lookup || curved.iter().any(|power| self.unknowns.contains(&Unknown::Linear(*power)))
    }

    /// Where a fit of this physical spring begins, from a model with a table or a power in its place.
    fn starts(&self, from: &Params, segments: &[Segment]) -> Vec<Params> {
        let x = || segments.iter().flat_map(|s| s.input.iter().filter_map(|i| i.displacement));
        let Some((_, side, clearance_of, stiffness_of)) = STOPS.iter().find(|stop| self.elements.contains(&stop.0))
        else {
            let set = |length: &f64| {
                let mut start = *from;
                start.set(number!("gas_length"), *length).is_ok().then_some(start)
            };
            return COLUMNS.iter().filter_map(set).collect();
        };
        let reach = x().map(|x| side * x).fold(0.0, f64::max);
        let drawn = excess(from, *side);
        let set = |share: &f64| {
            let mut start = *from;
            let clearance = share * reach;
            let stiffness =
                if drawn > 0.0 { 0.5 * drawn / (reach - clearance) } else { STOP * Scale::of(from).force() };
            start.set(*clearance_of, clearance).ok()?;
            start.set(*stiffness_of, stiffness).ok()?;
            Some(start)
        };
        CLEARANCES.iter().filter_map(set).collect()
    }
}

/// Ways to fit with each of the physical springs that may be used, where the tests go out of the middle.
pub fn physical_springs(
    structure: Structure,
    from: &Params,
    springs: &[Variant],
    segments: &[Segment],
) -> Vec<Candidate> {
    let with = |v: &Variant| Candidate {
        name: v.name,
        structure: Structure { spring: *v, ..structure },
        starts: v.starts(from, segments),
    };
    springs.iter().map(with).filter(|candidate| !candidate.starts.is_empty()).collect()
}

/// Elements that a fit can identify; all others are found by a diagnosis.
pub fn identified() -> Vec<Element> {
    let mut all = vec![
        element!("fv_curve"),
        element!("series_compliance"),
        element!("gas_preload"),
        element!("gas_warming"),
        element!("side_force_friction"),
    ];
    for element in FRICTION.iter().chain(SPRING).chain(PHYSICAL_SPRING).flat_map(|v| v.elements) {
        if !all.contains(element) {
            all.push(*element);
        }
    }
    all
}

/// What is on in a fit.
#[derive(Debug, Clone, Copy)]
pub struct Structure {
    /// Friction.
    pub friction: Variant,
    /// Spring parallel to the primary damper.
    pub spring: Variant,
    /// Series compliance and internal mass.
    pub series: bool,
    /// Constant gas force.
    pub gas: bool,
    /// Gas force that grows with the temperature from this one on, °C.
    pub warming: Option<f64>,
    /// Friction growing with side force.
    pub side_force: bool,
    /// What is looked for in the measurement itself.
    pub rig: OfTheRig,
}

impl Structure {
    /// Base set and unknowns of this structure, starting from the values in `from`.
    pub fn unknowns(&self, from: &Params, segments: &[Segment]) -> Unknowns {
        let mut base = *from;
        let mut list = Vec::new();
        base.disable_all();
        base.enable(element!("fv_curve"), true);
        list.extend(Unknowns::rises(&base, CurveName::Fv));
        if self.series {
            base.enable(element!("series_compliance"), true);
            list.extend([
                Unknown::Log(number!("series_stiffness")),
                Unknown::Linear(number!("series_damping")),
                Unknown::Log(number!("internal_mass")),
            ]);
        }
        if self.gas {
            base.enable(element!("gas_preload"), true);
            list.push(Unknown::Linear(number!("gas_force")));
        }
        if let Some(reference) = self.warming {
            base.enable(element!("gas_warming"), true);
            let _ = base.set(number!("gas_warming_reference"), reference);
            list.push(Unknown::Linear(number!("gas_warming_rate")));
        }
        if self.side_force {
            base.enable(element!("side_force_friction"), true);
            list.push(Unknown::Linear(number!("side_force_coefficient")));
        }
        for power in POWERS {
            if !self.spring.unknowns.contains(&Unknown::Linear(power)) {
                let _ = base.set(power, 0.0);
            }
        }
        if !self.spring.lookup {
            let _ = base.set_list(list!("spring_displacement"), &[]);
            let _ = base.set_list(list!("spring_force"), &[]);
        }
        for variant in [self.friction, self.spring] {
            for (number, value) in variant.choices {
                let _ = base.set(*number, *value);
            }
            for element in variant.elements {
                base.enable(*element, true);
            }
            list.extend(variant.unknowns);
            if variant.lookup {
                if base.list(list!("spring_displacement")).is_empty() {
                    start_lookup(&mut base, segments);
                }
                list.extend(Unknowns::rises(&base, CurveName::Spring));
            }
        }
        Unknowns { base, list, rig: self.rig.numbers() }
    }
}

/// A flat lookup spring over the displacements that the tests cover, with a point at zero.
fn start_lookup(base: &mut Params, segments: &[Segment]) {
    let x = || segments.iter().flat_map(|s| s.input.iter().filter_map(|i| i.displacement));
    let (low, high) = (x().fold(0.0f64, f64::min), x().fold(0.0f64, f64::max));
    let span = (high - low).max(1e-6);
    let step = span / (LOOKUP_POINTS - 1) as f64;
    let first = (low / step).round() * step;
    let points: Vec<f64> = (0..LOOKUP_POINTS)
        .map(|k| {
            let p = first + k as f64 * step;
            if p.abs() < 0.5 * step { 0.0 } else { p }
        })
        .collect();
    let forces: Vec<f64> = points.iter().map(|x| 1.0 * x).collect();
    let _ = base.set_list(list!("spring_displacement"), &points);
    let _ = base.set_list(list!("spring_force"), &forces);
}

/// Fewest tests that can judge variants by leaving one of them out.
pub const FEWEST_TESTS: usize = 4;

/// Velocities, as shares of the fastest slow test's peak, at which the FV table gets points from slow tests.
const SLOW_POINTS: [f64; 2] = [0.4, 1.0];

/// The same parameters with points in the FV table where only slow tests are (thesis 4: "with and without the slow-test
/// points"); `None` where the table already reaches that far down.
pub fn with_slow_points(from: &Params, slow_peak: f64) -> Option<Params> {
    let v = from.list(list!("fv_velocity"));
    let closest = v.iter().filter(|v| **v != 0.0).fold(f64::INFINITY, |m, v| m.min(v.abs()));
    if slow_peak <= 0.0 || 2.0 * slow_peak > closest {
        return None;
    }
    with_points(from, SLOW_POINTS.iter().flat_map(|share| [share * slow_peak, -share * slow_peak]))
}

/// The outcome of one choice.
#[derive(Debug, Clone, Serialize)]
pub struct Choice {
    /// What was chosen: "friction", "spring", "FV points" or "measurement".
    pub of: &'static str,
    /// The name of the variant that was kept.
    pub chosen: &'static str,
    /// Each variant with its error on left-out tests, in units of what a test's noise and floor allow.
    pub scores: Vec<Score>,
    /// Why, in words.
    pub why: Sentence,
    /// What it leaves open that moves the model's numbers.
    #[serde(skip)]
    pub open: Option<Sentence>,
}

/// What an error on left-out tests says of a variant, in units of what their noise and floor allow: up to one and a half a model is as good as
/// the records tell, and three times as much is seen in a plot.
fn grade(error: f64) -> Template {
    match error {
        e if e <= 1.5 => phrases::GOOD,
        e if e <= 3.0 => phrases::FAIR,
        _ => phrases::POOR,
    }
}

impl Choice {
    /// The whole choice in one sentence.
    pub fn in_words(&self) -> Sentence {
        Sentence::from(phrases::CHOICE)
            .with_word("of", self.of)
            .with_word("chosen", self.chosen)
            .with_said("why", self.why.clone())
    }
}

/// Error of one variant on left-out tests.
#[derive(Debug, Clone, Serialize)]
pub struct Score {
    /// Variant.
    pub name: &'static str,
    /// Geometric mean over the left-out tests of rms error per allowed error.
    pub held_out: f64,
    /// Difference of its logarithm from the best variant's that chance explains (one standard error).
    pub tie_within: f64,
}

/// One of several ways to fit.
pub struct Candidate {
    /// Name in the report.
    pub name: &'static str,
    /// What is on.
    pub structure: Structure,
    /// Where the fit starts: the best of these ends is kept.
    pub starts: Vec<Params>,
}

/// The same with the series path of a usual damper; `None` where it has none.
fn as_usual(from: &Params) -> Option<Params> {
    let mut usual = *from;
    let scale = Scale::of(from);
    for number in [number!("series_stiffness"), number!("series_damping"), number!("internal_mass")] {
        usual.set(number, number.inside(scale.of_number(number) * number.default())).ok()?;
    }
    (usual != *from).then_some(usual)
}

/// Which way to fit was chosen.
pub struct Chosen {
    /// Its place among the candidates.
    pub place: usize,
    /// The account.
    pub choice: Choice,
    /// Parameters that its fit found.
    pub params: Params,
    /// What it found of the measurement.
    pub rig: OfTheRig,
}

/// Which way to fit is kept.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Keep {
    /// The simplest that predicts left-out tests as well as the best, within chance.
    Simplest,
    /// The first, unless another is clearly likelier: what a wrong form of the model leaves looks like a fault of the measurement too.
    First,
}

/// Error of a test, in units of what its noise and floor allow, below which smaller is not nearer.
const LEAST: f64 = 1e-3;

/// How much likelier than the records as they are a fault of the measurement must be, as the logarithm of the odds: nine to one. Each
/// test counts as one independent sample, since the error of a model's form is alike all through a test.
const BELIEVED: f64 = 2.2;
/// What a mass of less than nothing on the load cell costs, in the same units: only a rig that takes inertia off by itself can have taken too much,
/// and a late force channel leaves the same trace.
const LESS_THAN_NO_MASS: f64 = BELIEVED;
/// From which a late force channel that is not believed is told, in the same units: three to one, below which it is noise.
const TOLD: f64 = 1.1;

/// Chooses among ways to fit.
///
/// Every candidate is fitted to all tests and then judged on each test as predicted from all others. [`Keep::Simplest`]: the simplest
/// within one standard error of the best is kept (Breiman et al., *Classification and Regression Trees*, 1984, 3.4.3), each unknown costing
/// [`WORTH`] of the error; it has to be so in the mean of the squares and in that of the logarithms. What a model's form cannot give differs from test
/// to test by orders of magnitude and is alike all through one. Squares alone let the tests decide that every candidate misses, and as chance between
/// them is as large, nothing is then worth its numbers, not even friction that brings every slow test nearer by ten times; logarithms alone
/// overlook what matters in two tests of twenty, as a stop does. [`Keep::First`] goes by the logarithms, which are the likelihood where each test
/// has an error of its own size.
pub fn choose(of: &'static str, candidates: &[Candidate], segments: &[Segment], keep: Keep) -> Chosen {
    struct Judged {
        params: Params,
        rig: OfTheRig,
        unknowns: usize,
        /// What its numbers cost it, as the logarithm of the odds: an internal mass of 3 kg predicts as well as one on the load cell, but no rod
        /// is that heavy.
        unusual: f64,
        errors: Vec<f64>,
    }
    let all: Vec<&Segment> = segments.iter().collect();
    let judged: Vec<Judged> = candidates
        .par_iter()
        .map(|candidate| {
            // From where the last choice ended, and from a damper as it is usual: another friction may need another series path.
            let matters = candidate.structure.series && (of == "friction" || keep == Keep::First);
            let usual = candidate.starts.first().filter(|_| matters).and_then(as_usual);
            let fits = candidate.starts.iter().chain(&usual).map(|from| {
                let unknowns = candidate.structure.unknowns(from, segments);
                let found = solve(&all, &unknowns, &unknowns.start(), Effort::ROUGH);
                (found.cost, found.theta, unknowns)
            });
            let best = fits.min_by(|a, b| a.0.total_cmp(&b.0));
            let (_, theta, unknowns) = best.unwrap_or_else(|| {
                let unknowns = candidate.structure.unknowns(&Params::new(), segments);
                (f64::INFINITY, unknowns.start(), unknowns)
            });
            let errors = left_out_errors(&all, &unknowns, &theta);
            let unusual = unusual(&unknowns, &theta);
            let unknowns = unknowns.starting_at(&theta);
            let rig = candidate.structure.rig.starting_at(&unknowns.rig);
            Judged { params: unknowns.base, rig, unknowns: theta.len(), unusual, errors }
        })
        .collect();
    let n = segments.len() as f64;
    let places = 0..candidates.len();
    let fewest = judged.iter().map(|j| j.unknowns).min().unwrap_or(0);
    let price = |k: usize| WORTH * (judged[k].unknowns - fewest) as f64;
    let mean = |of: &dyn Fn(&f64) -> f64, k: usize| judged[k].errors.iter().map(of).sum::<f64>() / n;
    // Two views of a test's error: its square, in which the worst tests count, and its logarithm, in which each counts by the factor.
    let square = |square: &f64| *square;
    let logarithm = |square: &f64| 0.5 * libm::log(square.max(LEAST * LEAST));
    let typical = |k: usize| libm::exp(mean(&logarithm, k));
    let best_by =
        |priced: &dyn Fn(usize) -> f64| places.clone().min_by(|a, b| priced(*a).total_cmp(&priced(*b))).unwrap_or(0);
    let tie = |of: &dyn Fn(&f64) -> f64, best: usize, k: usize| {
        let d: Vec<f64> = judged[k].errors.iter().zip(&judged[best].errors).map(|(a, b)| of(a) - of(b)).collect();
        let m = d.iter().sum::<f64>() / n;
        (d.iter().map(|x| (x - m).powi(2)).sum::<f64>() / (n * (n - 1.0).max(1.0))).sqrt()
    };
    let likelihood = |k: usize| {
        let less_than_none = judged[k].rig.has_less_than_no_mass();
        let unusual = judged[k].unusual + if less_than_none { LESS_THAN_NO_MASS } else { 0.0 };
        n * mean(&logarithm, k) + 0.5 * judged[k].unknowns as f64 * libm::log(n) + unusual
    };
    // Among those that explain the records alike, one that every host can run.
    let simplest = |among: &dyn Fn(usize) -> bool| {
        places.clone().filter(|k| among(*k)).min_by(|a, b| {
            let friction = |k: usize| !candidates[k].structure.friction.runs_in_real_time;
            friction(*a)
                .cmp(&friction(*b))
                .then(judged[*a].unknowns.cmp(&judged[*b].unknowns))
                .then(mean(&square, *a).total_cmp(&mean(&square, *b)))
        })
    };
    let (kept, best) = match keep {
        Keep::First => {
            let best = best_by(&likelihood);
            (if likelihood(0) - likelihood(best) < BELIEVED { 0 } else { best }, best)
        }
        Keep::Simplest => {
            let worst = best_by(&|k| mean(&square, k).sqrt() * (1.0 + price(k)));
            let usual = best_by(&|k| mean(&logarithm, k) + price(k));
            let ties = |of: &dyn Fn(&f64) -> f64, best, k| mean(of, k) - mean(of, best) <= tie(of, best, k);
            let by_both = simplest(&|k| ties(&square, worst, k) && ties(&logarithm, usual, k));
            let kept = by_both.or_else(|| simplest(&|k| ties(&square, worst, k))).unwrap_or(worst);
            (kept, if kept == worst { worst } else { usual })
        }
    };
    let error = |k: usize| format!("{:.2}", typical(k));
    let other = |k: usize| Sentence::from(phrases::OTHER).with_word("name", candidates[k].name).with("error", error(k));
    let others: Vec<Sentence> = places.clone().filter(|k| *k != kept).map(other).collect();
    let others =
        (!others.is_empty()).then(|| Sentence::from(phrases::OTHERS).with_list("others", others, phrases::COMMA));
    let reason = if kept == best {
        phrases::NO_OTHER_IS_BETTER
    } else if keep == Keep::First {
        phrases::NO_OTHER_IS_LIKELIER
    } else {
        phrases::SIMPLEST
    };
    let why = Sentence::from(phrases::WHY)
        .with_said("grade", grade(typical(kept)))
        .with("error", error(kept))
        .with_any("others", others)
        .with_said("reason", reason);
    let scores = places
        .map(|k| Score { name: candidates[k].name, held_out: typical(k), tie_within: tie(&logarithm, best, k) })
        .collect();
    // A late force channel that the records speak for, but not surely, leaves the series path open.
    let late = (0..candidates.len()).find(|k| *k != 0 && judged[*k].rig.is_delay_alone());
    let open = late.filter(|k| keep == Keep::First && kept == 0 && likelihood(0) - likelihood(*k) > TOLD).map(|k| {
        let stiffness = |k: usize| format!("{:.3e}", judged[k].params.number(number!("series_stiffness")));
        Sentence::from(phrases::PERHAPS_LATE)
            .with("odds", format!("{:.1}", libm::exp(likelihood(0) - likelihood(k))))
            .with("delay", format!("{:.2}", 1e3 * judged[k].rig.delay_found()))
            .with("with", stiffness(k))
            .with("without", stiffness(0))
    });
    let open = open.filter(|_| candidates[kept].structure.series);
    let choice = Choice { of, chosen: candidates[kept].name, scores, why, open };
    Chosen { place: kept, choice, params: judged[kept].params, rig: judged[kept].rig }
}
