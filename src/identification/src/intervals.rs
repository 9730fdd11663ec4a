//! 95 % intervals, the tests from which each parameter was identified, and the parameters that were not identified.

use super::phrases;
use dashpot_core::parameter::{List, Number};
use dashpot_core::{Params, list, number};
use dashpot_estimation::curve_form;
use dashpot_estimation::deviations::sandwich;
use dashpot_estimation::first_guess::SLOW;
use dashpot_estimation::hypothesis::{Free, Hypothesis};
use dashpot_estimation::refit::Refit;
use dashpot_estimation::samples::Test;
use dashpot_estimation::scale::Scale;
use dashpot_estimation::structure::alternatives::{Part, mixed_interval};
use dashpot_estimation::unknowns::{CurveName, Unknown, anchor};
use dashpot_messages::Sentence;
use dashpot_records::Reading;
use nalgebra::DMatrix;
use serde::Serialize;

/// Half-width of a 95 % interval in standard deviations.
pub(crate) const Z: f64 = 1.96;
/// Largest half-width of an interval, relative to the value, at which a parameter counts as identified. [`SHARE`] is an alternative
/// criterion.
const RELATIVE: f64 = 0.5;
/// Largest force due to an interval's half-width, relative to the largest measured force, at which a parameter also counts as identified.
const SHARE: f64 = 0.005;
/// Side force, N, at which the force of the side-force friction is evaluated for [`SHARE`].
const SIDE_FORCE: f64 = 300.0;
/// Amplitude, m, below which [`sources`] counts a test as a small-stroke test.
const SMALL_STROKE: f64 = 0.006;

/// Estimate of one number of the model, with its interval and source.
#[derive(Debug, Clone, Serialize)]
pub struct Estimate {
    /// Name of the parameter.
    pub name: &'static str,
    /// Index of the number in its list, or `None` for a single number.
    pub index: Option<usize>,
    /// Value, in `unit`.
    pub value: f64,
    /// Lower end of the 95 % interval. `None` for a single number that the data does not determine. A point of a curve always has an
    /// interval.
    pub low: Option<f64>,
    /// Upper end of the 95 % interval. `None` for a single number that the data does not determine. A point of a curve always has an
    /// interval.
    pub high: Option<f64>,
    /// Unit of the value and of the interval.
    pub unit: &'static str,
    /// Kinds of tests from which the number was identified, as a sentence.
    pub from: Sentence,
    /// Whether the data determines the number.
    pub standing: Standing,
}

impl Estimate {
    /// Formats the value and its interval with the digits that all tables and sentences use.
    pub fn reading(&self) -> Reading {
        Reading::new(self.value, self.low.unwrap_or(f64::NAN), self.high.unwrap_or(f64::NAN), self.unit)
    }

    /// Returns the value and the ends of the interval as a part of a mean over structures, or `None` without an interval.
    pub(crate) fn part(&self, weight: f64) -> Option<Part> {
        Some(Part { weight, value: self.value, ends: [self.low?, self.high?] })
    }

    /// Replaces the interval by that of the mean over this estimate, with weight 1, and others. An estimate without an interval keeps none.
    pub(crate) fn mix(&mut self, others: impl Iterator<Item = Part>) {
        let Some(own) = self.part(1.0) else { return };
        let parts: Vec<Part> = std::iter::once(own).chain(others).collect();
        if let Some([low, high]) = mixed_interval(&parts) {
            (self.low, self.high) = (Some(low), Some(high));
        }
    }

    /// Widens the interval until it contains another one. An estimate without an interval keeps none.
    pub(crate) fn widen(&mut self, [from, to]: [f64; 2]) {
        if let (Some(low), Some(high)) = (self.low, self.high) {
            (self.low, self.high) = (Some(low.min(from)), Some(high.max(to)));
        }
    }
}

/// Whether the data determines a parameter.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Standing {
    /// Identified, with an interval.
    Identified,
    /// The data does not determine the parameter. The value then follows mainly from the prior. It is 0 if the element is off.
    NotIdentified,
    /// The estimate lies at a bound of the parameter's range.
    AtBound,
}

/// Computes the estimates of all numbers of the model from a refit. The list is empty if the covariance cannot be computed.
pub fn estimates(hypothesis: &Hypothesis, refit: &Refit, tests: &[Test]) -> Vec<Estimate> {
    let Some((covariance, determined)) = sandwich(hypothesis, refit, tests) else { return Vec::new() };
    let known = Known { covariance, determined, sources: sources(hypothesis, refit, tests) };
    known.estimates(hypothesis, &refit.theta, tests, refit.residual.as_slice())
}

/// Information that the records give about the free numbers of a model.
pub struct Known {
    /// Covariance of the numbers, in the coordinates of the fit, such as logarithms of values.
    pub covariance: DMatrix<f64>,
    /// Degree to which each number is determined independently of all others and of its prior, 0 to 1.
    pub determined: Vec<f64>,
    /// Kinds of tests from which each number was identified.
    pub sources: Vec<Sentence>,
}

impl Known {
    /// Selects the numbers at `indices`, in the order of the indices.
    pub fn select(&self, indices: &[usize]) -> Known {
        Known {
            covariance: DMatrix::from_fn(indices.len(), indices.len(), |i, j| {
                self.covariance[(indices[i], indices[j])]
            }),
            determined: indices.iter().map(|i| self.determined[*i]).collect(),
            sources: indices.iter().map(|i| self.sources[*i].clone()).collect(),
        }
    }

    /// Computes estimates of all numbers of a hypothesis at `theta`. `residual` is the weighted residual of the tests at `theta`.
    pub fn estimates(&self, hypothesis: &Hypothesis, theta: &[f64], tests: &[Test], residual: &[f64]) -> Vec<Estimate> {
        let params = hypothesis.params(theta);
        let model = |number: &dashpot_estimation::hypothesis::Number| match &number.free {
            Free::Model(unknown) => Some(*unknown),
            _ => None,
        };
        let fitted = Fitted {
            known: self,
            hypothesis,
            theta,
            unknowns: hypothesis.numbers.iter().map(model).collect(),
            misses: curve_form::misses(params.list(list!("fv_velocity")), tests, residual),
            params,
            top: tests.iter().fold(0.0f64, |m, t| m.max(t.segment.top)),
            stroke: tests.iter().fold(0.0f64, |m, t| m.max(t.segment.amplitude)),
            speed: tests.iter().fold(0.0f64, |m, t| m.max(t.segment.peak_velocity)),
            scale: Scale::from_params(&hypothesis.base),
        };
        let unknowns = fitted.unknowns.iter().enumerate();
        unknowns.filter_map(|(i, unknown)| Some(fitted.estimate(i, unknown.as_ref()?))).collect()
    }
}

/// Fitted model with the largest values of its tests.
struct Fitted<'a> {
    known: &'a Known,
    hypothesis: &'a Hypothesis,
    theta: &'a [f64],
    params: Params,
    /// Unknown of the model for each free number. It is `None` for a number of the rig.
    unknowns: Vec<Option<Unknown>>,
    /// Deviation of the FV curve from the records near each of its points, N.
    misses: Vec<f64>,
    /// Largest measured force, N.
    top: f64,
    /// Largest amplitude, m.
    stroke: f64,
    /// Largest peak velocity, m/s.
    speed: f64,
    scale: Scale,
}

impl Fitted<'_> {
    fn estimate(&self, i: usize, unknown: &Unknown) -> Estimate {
        match unknown {
            Unknown::Log(number) | Unknown::Linear(number) | Unknown::Above(number, _) => {
                self.estimate_number(i, unknown, *number)
            }
            Unknown::Rise { curve, point } => self.estimate_point(i, *curve, *point),
            Unknown::Entry(coefficients, k) => self.estimate_entry(i, *coefficients, *k),
        }
    }

    /// Returns the standard deviation of a free number in the coordinates of the fit.
    fn deviation(&self, i: usize) -> f64 {
        self.known.covariance[(i, i)].max(0.0).sqrt()
    }

    /// Returns whether a free number lies at a bound of its range.
    fn is_at_bound(&self, i: usize) -> bool {
        let (low, high) = self.hypothesis.numbers[i].bounds;
        let value = self.theta[i];
        value <= low + 1e-9 * (1.0 + low.abs()) || value >= high - 1e-9 * (1.0 + high.abs())
    }

    fn estimate_number(&self, i: usize, unknown: &Unknown, number: Number) -> Estimate {
        let value = self.params.number(number);
        let (a, b) = self.interval(i, unknown, value);
        let half = 0.5 * (b - a);
        // A parameter that is almost zero has a large relative uncertainty even if it is well known. Therefore, the force due to the
        // half-width also decides.
        let force = half * per_unit(number, self.stroke, self.speed);
        let identified =
            self.known.determined[i] > 1e-9 && (half <= RELATIVE * value.abs() || force <= SHARE * self.top);
        let (bound_low, bound_high) = self.scale.reach(number);
        Estimate {
            name: number.name(),
            index: None,
            value,
            low: identified.then(|| a.max(bound_low)),
            high: identified.then(|| b.min(bound_high)),
            unit: number.parameter().unit,
            from: self.known.sources[i].clone(),
            standing: match (identified, self.is_at_bound(i)) {
                (false, _) => Standing::NotIdentified,
                // A bound needs no report if it is zero or the default, such as Dahl's exponent of 1.
                (true, true) if value != 0.0 && value != number.default() => Standing::AtBound,
                _ => Standing::Identified,
            },
        }
    }

    /// Returns the 95 % interval of a single number.
    fn interval(&self, i: usize, unknown: &Unknown, value: f64) -> (f64, f64) {
        let cov = &self.known.covariance;
        let sd = match unknown {
            Unknown::Log(_) => {
                let sd = self.deviation(i);
                return (value * libm::exp(-Z * sd), value * libm::exp(Z * sd));
            }
            Unknown::Above(_, below) => {
                // The value is the other parameter, `level`, times 1 + fraction. Both `level` and the fraction are uncertain.
                let level = self.params.number(*below);
                let k = self.unknowns.iter().position(|u| *u == Some(Unknown::Linear(*below)));
                let factor = 1.0 + self.theta[i];
                let more = k.map_or(0.0, |k| factor * factor * cov[(k, k)] + 2.0 * factor * level * cov[(i, k)]);
                (level * level * cov[(i, i)] + more).max(0.0).sqrt()
            }
            _ => self.deviation(i),
        };
        (value - Z * sd, value + Z * sd)
    }

    /// Returns the increments whose sum is the force at a point: those from the fixed point of the curve to this point.
    fn increments(&self, curve: CurveName, point: usize) -> Vec<usize> {
        let zero = anchor(self.params.list(curve.abscissae()));
        let is_on_path = |other: &Option<Unknown>| match other {
            Some(Unknown::Rise { curve: c, point: p }) if *c == curve => {
                if point > zero {
                    *p > zero && *p <= point
                } else {
                    *p < zero && *p >= point
                }
            }
            _ => false,
        };
        (0..self.unknowns.len()).filter(|k| is_on_path(&self.unknowns[*k])).collect()
    }

    fn estimate_point(&self, i: usize, curve: CurveName, point: usize) -> Estimate {
        let cov = &self.known.covariance;
        let path = self.increments(curve, point);
        let variance: f64 = path.iter().flat_map(|a| path.iter().map(|b| cov[(*a, *b)])).sum();
        // The uncertainty of a point includes the deviation of the curve from the records near that point.
        let miss = if curve == CurveName::Fv { self.misses.get(point).copied().unwrap_or(0.0) } else { 0.0 };
        let half = (Z * Z * variance.max(0.0) + miss * miss).sqrt();
        let value = self.params.list(curve.forces())[point];
        let identified = half <= RELATIVE * value.abs() || half <= SHARE * self.top;
        Estimate {
            name: curve.forces().name(),
            index: Some(point),
            value,
            low: Some(value - half),
            high: Some(value + half),
            unit: "N",
            from: self.known.sources[i].clone(),
            standing: if identified { Standing::Identified } else { Standing::NotIdentified },
        }
    }

    fn estimate_entry(&self, i: usize, coefficients: List, k: usize) -> Estimate {
        let value = self.params.list(coefficients)[k];
        let sd = self.deviation(i);
        Estimate {
            name: coefficients.name(),
            index: Some(k),
            value,
            low: Some(value - Z * sd),
            high: Some(value + Z * sd),
            unit: coefficients.parameter().unit,
            from: self.known.sources[i].clone(),
            standing: Standing::Identified,
        }
    }
}

/// Returns the force, N, that one unit of a number causes at the largest amplitude `stroke`, m, and the largest velocity `speed`, m/s.
/// Returns infinity if that force is unknown.
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

/// Determines for every number the kinds of tests that give its information. Kinds with less than 10 % of the information are omitted.
pub fn sources(hypothesis: &Hypothesis, refit: &Refit, tests: &[Test]) -> Vec<Sentence> {
    let mut information = vec![[0.0; 3]; hypothesis.numbers.len()];
    let mut first = 0;
    for test in tests {
        let kind = match &test.segment {
            s if s.peak_velocity < SLOW => 0,
            s if s.amplitude < SMALL_STROKE => 1,
            _ => 2,
        };
        let rows = refit.jacobian.rows(first, test.count());
        for (slot, column) in information.iter_mut().zip(rows.column_iter()) {
            slot[kind] += column.norm_squared();
        }
        first += test.count();
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
