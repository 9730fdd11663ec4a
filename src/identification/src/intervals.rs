//! 95 % intervals, where each parameter was identified from, and which were not.

use super::first_guess::SLOW;
use super::phrases;
use dashpot_core::number;
use dashpot_core::parameter::Number;
use dashpot_estimation::least_squares::covariance;
use dashpot_estimation::scale::Scale;
use dashpot_estimation::segment::Segment;
use dashpot_estimation::sensitivity::{Accuracy, Run};
use dashpot_estimation::unknowns::{Unknown, Unknowns, anchor};
use dashpot_records::Sentence;
use serde::Serialize;

/// Half-width of a 95 % interval in standard deviations.
pub(super) const Z: f64 = 1.96;
/// Half-width beyond which a parameter is not identified: relative to its value ...
const RELATIVE: f64 = 0.5;
/// ... unless its force effect is known to within this share of the largest force.
const SHARE: f64 = 0.005;
/// Side force, N, by which the force of its friction is judged.
const SIDE_FORCE: f64 = 300.0;
/// Strokes up to this amplitude, m, count as small in the account of where a parameter comes from.
const SMALL_STROKE: f64 = 0.006;

/// What a fit says of one number of the model.
#[derive(Debug, Clone, Serialize)]
pub struct Estimate {
    /// Name of the parameter.
    pub name: &'static str,
    /// Place in its list, for curves.
    pub index: Option<usize>,
    /// Value.
    pub value: f64,
    /// Lower end of the 95 % interval.
    pub low: Option<f64>,
    /// Upper end.
    pub high: Option<f64>,
    /// Unit.
    pub unit: &'static str,
    /// Which tests it was identified from.
    pub from: Sentence,
    /// Whether the data determines it.
    pub standing: Standing,
}

/// Whether the data determines a parameter.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Standing {
    /// Identified, with an interval.
    Identified,
    /// The data does not determine it; the value is the default or a guess.
    NotIdentified,
    /// The fit ran into a bound of the parameter table.
    AtBound,
}

/// Estimates of all unknowns at a solution, and the places of those that are not identified.
pub fn estimates(
    segments: &[Segment],
    unknowns: &Unknowns,
    theta: &[f64],
    accuracy: Accuracy,
) -> (Vec<Estimate>, Vec<usize>) {
    let refs: Vec<&Segment> = segments.iter().collect();
    let params = unknowns.params(theta);
    let Some((cov, determined)) = covariance(&refs, unknowns, theta, accuracy) else { return (Vec::new(), Vec::new()) };
    let top = segments.iter().fold(0.0f64, |m, s| m.max(s.top));
    let stroke = segments.iter().fold(0.0f64, |m, s| m.max(s.amplitude));
    let speed = segments.iter().fold(0.0f64, |m, s| m.max(s.peak_velocity));
    let sources = sources(segments, unknowns, theta);
    let (low, high) = unknowns.bounds();
    let scale = Scale::of(&unknowns.base);
    let mut loose = Vec::new();
    let mut list = Vec::new();
    for (i, unknown) in unknowns.list.iter().enumerate() {
        let sd = cov[(i, i)].max(0.0).sqrt();
        let at_bound =
            theta[i] <= low[i] + 1e-9 * (1.0 + low[i].abs()) || theta[i] >= high[i] - 1e-9 * (1.0 + high[i].abs());
        match unknown {
            Unknown::Log(number) | Unknown::Linear(number) | Unknown::Above(number, _) => {
                let value = params.number(*number);
                let (a, b) = match unknown {
                    Unknown::Log(_) => (value * libm::exp(-Z * sd), value * libm::exp(Z * sd)),
                    Unknown::Above(_, below) => {
                        // level (1 + share): both are uncertain.
                        let level = params.number(*below);
                        let k = unknowns.list.iter().position(|u| *u == Unknown::Linear(*below));
                        let factor = 1.0 + theta[i];
                        let more =
                            k.map_or(0.0, |k| factor * factor * cov[(k, k)] + 2.0 * factor * level * cov[(i, k)]);
                        let sd = (level * level * cov[(i, i)] + more).max(0.0).sqrt();
                        (value - Z * sd, value + Z * sd)
                    }
                    _ => (value - Z * sd, value + Z * sd),
                };
                let half = 0.5 * (b - a);
                // A parameter may be known to be nearly nothing: judge it by the force it makes, too.
                let force = half * per_unit(*number, stroke, speed);
                let identified = determined[i] > 1e-9 && (half <= RELATIVE * value.abs() || force <= SHARE * top);
                if !identified {
                    loose.push(i);
                }
                let (bound_low, bound_high) = scale.reach(*number);
                list.push(Estimate {
                    name: number.name(),
                    index: None,
                    value,
                    low: Some(a.max(bound_low)),
                    high: Some(b.min(bound_high)),
                    unit: number.parameter().unit,
                    from: sources[i].clone(),
                    standing: match (identified, at_bound) {
                        (false, _) => Standing::NotIdentified,
                        (true, true) if value != 0.0 => Standing::AtBound,
                        _ => Standing::Identified,
                    },
                });
            }
            Unknown::Rise { curve, point } => {
                let u = params.list(curve.abscissae());
                let zero = anchor(u);
                // The force at a point is the sum of the rises up to it.
                let path: Vec<usize> = unknowns
                    .list
                    .iter()
                    .enumerate()
                    .filter(|(_, other)| match other {
                        Unknown::Rise { curve: c, point: p } if c == curve => {
                            if *point > zero {
                                *p > zero && p <= point
                            } else {
                                *p < zero && p >= point
                            }
                        }
                        _ => false,
                    })
                    .map(|(k, _)| k)
                    .collect();
                let variance: f64 = path.iter().flat_map(|a| path.iter().map(|b| cov[(*a, *b)])).sum();
                let half = Z * variance.max(0.0).sqrt();
                let value = params.list(curve.forces())[*point];
                let identified = half <= RELATIVE * value.abs() || half <= SHARE * top;
                list.push(Estimate {
                    name: curve.forces().name(),
                    index: Some(*point),
                    value,
                    low: Some(value - half),
                    high: Some(value + half),
                    unit: "N",
                    from: sources[i].clone(),
                    standing: if identified { Standing::Identified } else { Standing::NotIdentified },
                });
            }
            Unknown::Entry(coefficients, k) => {
                let value = params.list(*coefficients)[*k];
                list.push(Estimate {
                    name: coefficients.name(),
                    index: Some(*k),
                    value,
                    low: Some(value - Z * sd),
                    high: Some(value + Z * sd),
                    unit: coefficients.parameter().unit,
                    from: sources[i].clone(),
                    standing: Standing::Identified,
                });
            }
        }
    }
    (list, loose)
}

/// Force that a unit of a number makes at most; without end where that is not known.
fn per_unit(number: Number, stroke: f64, speed: f64) -> f64 {
    const POWERS: [Number; 4] =
        [number!("spring_linear"), number!("spring_quadratic"), number!("spring_cubic"), number!("spring_quartic")];
    if let Some(k) = POWERS.iter().position(|power| *power == number) {
        stroke.powi(k as i32 + 1)
    } else if number == number!("viscous_coefficient") {
        speed.powi(2)
    } else if number == number!("side_force_coefficient") {
        SIDE_FORCE
    } else if number.parameter().unit == "N" {
        1.0
    } else {
        f64::INFINITY
    }
}

/// For every unknown, which kind of test carries its information.
fn sources(segments: &[Segment], unknowns: &Unknowns, theta: &[f64]) -> Vec<Sentence> {
    let n = unknowns.list.len();
    let Some(run) = Run::new(unknowns, theta, Accuracy::Cheap) else { return vec![Sentence::default(); n] };
    let mut information = vec![[0.0; 3]; n];
    for segment in segments {
        let kind = match segment {
            s if s.peak_velocity < SLOW => 0,
            s if s.amplitude < SMALL_STROKE => 1,
            _ => 2,
        };
        let (_, rows) = run.jacobian(segment, unknowns, theta);
        for (i, slot) in information.iter_mut().enumerate() {
            let row = rows.row(i);
            slot[kind] += row.iter().skip(segment.from).map(|d| d * d).sum::<f64>() / segment.scale.powi(2);
        }
    }
    information
        .iter()
        .map(|by_kind| {
            let sum: f64 = by_kind.iter().sum();
            if sum <= 0.0 {
                return phrases::NO_TEST.into();
            }
            let mut parts: Vec<(f64, &str)> =
                by_kind.iter().map(|i| i / sum).zip(phrases::KINDS_OF_TESTS).filter(|p| p.0 >= 0.1).collect();
            parts.sort_by(|a, b| b.0.total_cmp(&a.0));
            let said = |(share, kind): &(f64, &str)| {
                Sentence::from(phrases::SHARE_OF)
                    .with_word("tests", kind)
                    .with("percent", format!("{:.0}", 100.0 * share))
            };
            Sentence::list(parts.iter().map(said).collect(), phrases::COMMA)
        })
        .collect()
}
