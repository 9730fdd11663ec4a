//! Against a reference: which numbers of the model, and where its FV curve, are others than on the reference damper.

mod pattern;

pub use pattern::{CurveMoved, MovedBy};

use super::decisions::MATERIAL;
use super::phrases;
use super::search::physical;
use dashpot_core::Params;
use dashpot_core::{element, list};
use dashpot_estimation::deviations::covariance;
use dashpot_estimation::hypothesis::{Free, Hypothesis};
use dashpot_estimation::refit::Refit;
use dashpot_estimation::samples::Test;
use dashpot_estimation::unknowns::{CurveName, Unknown};
use dashpot_records::restrict;
use dashpot_records::{Sentence, reading_unit};
use nalgebra::{DMatrix, DVector};
use pattern::Point;
use serde::Serialize;
use std::cell::LazyCell;

/// Standard deviations from which a number of two dampers differs.
const CHANGED: f64 = 3.0;

/// A number of the model that is another on this damper than on the reference.
#[derive(Debug, Clone, Serialize)]
pub struct Change {
    /// Parameter; a point of the FV curve is `fv_force`.
    pub parameter: &'static str,
    /// Of a point of the FV curve its velocity, m/s, rebound positive.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub velocity_m_s: Option<f64>,
    /// On the reference damper.
    pub reference: f64,
    /// On this one.
    pub value: f64,
    /// Ends of the 95 % interval of this one's, what the reference leaves open included.
    pub low: f64,
    /// See `low`.
    pub high: f64,
    /// Unit.
    pub unit: &'static str,
    /// By how much it moves the force, as a share of the largest force in that direction of the test in which it moves it most; of a point of the
    /// FV curve, all of its side together.
    pub force_share: f64,
}

impl Change {
    /// Whether it stands in the answer.
    pub(super) fn is_material(&self) -> bool {
        self.force_share > MATERIAL
    }

    /// What it is called in a table.
    pub fn name(&self) -> String {
        match self.velocity_m_s {
            Some(velocity) => format!("{}, {velocity:.3} m/s", self.parameter),
            None => self.parameter.to_owned(),
        }
    }

    /// In words, with how its side of the FV curve moved as a whole.
    fn sentence(&self, curve: &[CurveMoved]) -> Sentence {
        // Four digits that count.
        let (factor, unit) = reading_unit(self.value.abs().max(self.reference.abs()), self.unit);
        let of = |value: f64| match factor * value {
            0.0 => "0".to_owned(),
            value => format!("{value:.*}", (3 - libm::log10(value.abs()).floor() as i32).clamp(0, 12) as usize),
        };
        let said = match self.velocity_m_s {
            Some(v) if v > 0.0 => Sentence::from(phrases::OTHER_REBOUND).with("velocity", format!("{v:.3}")),
            Some(v) => Sentence::from(phrases::OTHER_COMPRESSION).with("velocity", format!("{:.3}", -v)),
            None => Sentence::from(phrases::OTHER_NUMBER).with("name", self.parameter),
        };
        let everywhere = curve.iter().find(|moved| self.velocity_m_s.is_some_and(|v| moved.is_of(v)));
        let said = match self.velocity_m_s {
            Some(_) => said.with_any("everywhere", everywhere.map(CurveMoved::sentence)),
            None => said,
        };
        let value = of(self.value);
        // The sentences on forces bear their unit.
        let value = if self.velocity_m_s.is_some() || unit.is_empty() { value } else { format!("{value} {unit}") };
        said.with("reference", of(self.reference)).with("value", value)
    }
}

/// An explanation with the numbers that it was fitted to have, and how well they are known.
struct Fitted<'a> {
    hypothesis: &'a Hypothesis,
    theta: &'a [f64],
    covariance: DMatrix<f64>,
}

impl<'a> Fitted<'a> {
    fn new((hypothesis, refit): (&'a Hypothesis, &'a Refit)) -> Option<Self> {
        Some(Fitted { hypothesis, theta: &refit.theta, covariance: covariance(hypothesis, refit)? })
    }

    fn params(&self) -> Params {
        self.hypothesis.params(self.theta)
    }

    fn deviation(&self, place: usize) -> f64 {
        self.covariance[(place, place)].max(0.0).sqrt()
    }

    /// Force of the FV curve at a velocity, N, and its standard deviation.
    fn curve(&self, velocity: f64) -> (f64, f64) {
        let at = |theta: &[f64]| curve_at(&self.hypothesis.params(theta), velocity);
        let slope = |place: usize| {
            if !is_of_curve(&self.hypothesis.numbers[place].free) {
                return 0.0;
            }
            // Central, over a small part of what is open.
            let step = 0.01 * self.deviation(place).max(1e-9);
            let mut theta = self.theta.to_vec();
            theta[place] += step;
            let above = at(&theta);
            theta[place] -= 2.0 * step;
            (above - at(&theta)) / (2.0 * step)
        };
        let slopes = DVector::from_fn(self.theta.len(), |place, _| slope(place));
        (at(self.theta), slopes.dot(&(&self.covariance * &slopes)).max(0.0).sqrt())
    }
}

fn is_of_curve(free: &Free) -> bool {
    matches!(free, Free::Model(Unknown::Rise { curve: CurveName::Fv, .. }))
}

/// Between the points of the curve in proportion; beyond them as at its ends.
fn curve_at(params: &Params, velocity: f64) -> f64 {
    let (v, f) = (params.list(list!("fv_velocity")), params.list(list!("fv_force")));
    let right = restrict(v.partition_point(|at| *at < velocity), 1, v.len().max(2) - 1);
    let (Some(a), Some(b)) = (v.get(right - 1).zip(f.get(right - 1)), v.get(right).zip(f.get(right))) else {
        return 0.0;
    };
    let share = ((velocity - a.0) / (b.0 - a.0)).clamp(0.0, 1.0);
    a.1 + share * (b.1 - a.1)
}

/// Which numbers are meant.
type Which<'a> = dyn Fn(&Free) -> bool + 'a;

/// What is another on this damper than on the reference.
#[derive(Debug, Default)]
pub(super) struct Changes {
    /// Numbers, and points of the FV curve.
    pub numbers: Vec<Change>,
    /// How the curve moved as a whole.
    pub curve: Vec<CurveMoved>,
}

/// Numbers and points of the FV curve that differ from the reference damper's by more than both leave open.
pub(super) fn changes(reference: (&Hypothesis, &Refit), own: (&Hypothesis, &Refit), tests: &[Test]) -> Changes {
    let (Some(there), Some(here)) = (Fitted::new(reference), Fitted::new(own)) else { return Changes::default() };
    // Only where there is a change to weigh.
    let forces = LazyCell::new(|| here.hypothesis.forces(tests, here.theta));
    // Most that the force of a test moves in rebound or in compression, as a share of its largest there, where these numbers are as on the
    // reference: half of the compression force may be little beside the rebound force.
    let moved = |which: &Which| {
        let mut theta = here.theta.to_vec();
        for (place, number) in here.hypothesis.numbers.iter().enumerate().filter(|(_, n)| which(&n.free)) {
            theta[place] = there.hypothesis.place_of(&number.free).map_or(theta[place], |k| there.theta[k]);
        }
        let (Some(own), Some(with)) = (&*forces, here.hypothesis.forces(tests, &theta)) else { return 0.0 };
        let share = |test: &Test, own: &[f64], with: &[f64], side: f64| {
            let on_side = test.inputs().iter().map(|input| side * input.velocity > 0.0);
            let samples = on_side.zip(test.forces()).zip(own.iter().zip(with)).filter(|((on_side, _), _)| *on_side);
            let (moved, force) = samples.fold((0.0f64, 0.0f64), |(moved, force), ((_, f), (own, with))| {
                (moved.max((own - with).abs()), force.max(f.abs()))
            });
            if force > 0.0 { moved / force } else { 0.0 }
        };
        let tests = tests.iter().zip(own.iter().zip(&with));
        let shares = tests.flat_map(|(test, (own, with))| [1.0, -1.0].map(|side| share(test, own, with, side)));
        shares.fold(0.0, f64::max)
    };
    let numbers = there.hypothesis.numbers.iter().enumerate().filter_map(|(k, n)| {
        let Free::Model(Unknown::Log(number) | Unknown::Linear(number)) = n.free else { return None };
        let place = here.hypothesis.place_of(&n.free)?;
        let deviation = libm::hypot(there.deviation(k), here.deviation(place));
        let (before, after) = (there.theta[k], here.theta[place]);
        ((after - before).abs() > CHANGED * deviation).then(|| Change {
            parameter: number.name(),
            velocity_m_s: None,
            reference: physical(&n.free, before),
            value: physical(&n.free, after),
            low: physical(&n.free, after - 1.96 * deviation),
            high: physical(&n.free, after + 1.96 * deviation),
            unit: number.parameter().unit,
            force_share: moved(&|free| *free == n.free),
        })
    });
    let sides = points_of_the_curve(&there, &here, tests);
    let curve = pattern::of(&sides);
    Changes { numbers: numbers.chain(of_the_curve(&here, &sides, &moved)).collect(), curve }
}

/// Points of the FV curve as far as the tests reach, in rebound and in compression; none where the curve is not free.
fn points_of_the_curve(there: &Fitted, here: &Fitted, tests: &[Test]) -> [Vec<Point>; 2] {
    let params = here.params();
    if !params.is_on(element!("fv_curve")) || !here.hypothesis.numbers.iter().any(|n| is_of_curve(&n.free)) {
        return [Vec::new(), Vec::new()];
    }
    [1.0, -1.0].map(|side| {
        let reach = tests.iter().flat_map(|t| t.inputs()).fold(0.0f64, |most, input| most.max(side * input.velocity));
        let reached = params.list(list!("fv_velocity")).iter().filter(|v| (1e-9..=reach).contains(&(side * **v)));
        let point = |v: &f64| {
            let ((before, of_there), (after, of_here)) = (there.curve(*v), here.curve(*v));
            Point { velocity: *v, before, after, deviation: libm::hypot(of_there, of_here) }
        };
        reached.map(point).collect()
    })
}

/// Those of them that moved.
fn of_the_curve(here: &Fitted, sides: &[Vec<Point>; 2], moved: &dyn Fn(&Which) -> f64) -> Vec<Change> {
    let params = here.params();
    let velocities = params.list(list!("fv_velocity"));
    let mut found = Vec::new();
    for (side, points) in [1.0, -1.0].into_iter().zip(sides) {
        if !points.iter().any(Point::has_moved) {
            continue;
        }
        let of_side = |free: &Free| match free {
            Free::Model(Unknown::Rise { curve: CurveName::Fv, point }) => {
                velocities.get(*point).is_some_and(|v| side * v > 0.0)
            }
            _ => false,
        };
        let force_share = moved(&of_side);
        found.extend(points.iter().filter(|p| p.has_moved()).map(|p| Change {
            parameter: list!("fv_force").name(),
            velocity_m_s: Some(p.velocity),
            reference: p.before,
            value: p.after,
            low: p.after - 1.96 * p.deviation,
            high: p.after + 1.96 * p.deviation,
            unit: "N",
            force_share,
        }));
    }
    found
}

/// Those that stand in the answer, what moves the force most first; of a side of the FV curve the point at which it moved most, of a curve that moved
/// by one force against the motion that alone.
fn in_the_answer(changes: &Changes) -> Vec<&Change> {
    let dry = changes.curve.iter().any(|moved| moved.by == MovedBy::DryForce);
    let side = |change: &Change| change.velocity_m_s.map(|v| if dry { 1.0 } else { v.signum() });
    // Of a curve that moved by one force alike either of both sides may stand for both: that which moves the force more.
    let moved = |change: &Change| if dry { change.force_share } else { (change.value - change.reference).abs() };
    let material: Vec<&Change> = changes.numbers.iter().filter(|change| change.is_material()).collect();
    let is_most = |(place, change): &(usize, &&Change)| {
        side(change).is_none()
            || material.iter().enumerate().all(|(other, c)| {
                side(c) != side(change) || moved(c) < moved(change) || moved(c) == moved(change) && other >= *place
            })
    };
    let mut told: Vec<&Change> = material.iter().enumerate().filter(is_most).map(|(_, change)| *change).collect();
    told.sort_by(|a, b| b.force_share.total_cmp(&a.force_share));
    told
}

/// The same in words.
pub(super) fn told(changes: &Changes) -> Vec<Sentence> {
    let dry = changes.curve.iter().find(|moved| moved.by == MovedBy::DryForce);
    let sentence = |change: &Change| match dry.filter(|_| change.velocity_m_s.is_some()) {
        Some(moved) => moved.sentence(),
        None => change.sentence(&changes.curve),
    };
    in_the_answer(changes).into_iter().map(sentence).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(reference: f64, value: f64, force_share: f64, velocity_m_s: Option<f64>) -> Change {
        let parameter = if velocity_m_s.is_some() { "fv_force" } else { "gas_force" };
        Change { parameter, velocity_m_s, reference, value, low: value, high: value, unit: "N", force_share }
    }

    #[test]
    fn what_stands_in_the_answer_moves_the_force_by_more_than_the_scatter_of_a_series() {
        let all = [
            of(180.0, 172.0, 0.02, None),
            of(400.0, 320.0, 0.2, Some(0.1)),
            of(1600.0, 1300.0, 0.2, Some(1.05)),
            of(-500.0, -480.0, 0.04, Some(-0.5)),
            of(180.0, 12.85, 0.6, None),
        ];
        let said = |by: &[(MovedBy, &'static str, f64)]| {
            let curve = by.iter().map(|(by, side, value)| {
                let (by, side, value) = (*by, *side, *value);
                CurveMoved { by, side, value, low: value, high: value, speed_m_s: [0.003, 1.05] }
            });
            let changes = Changes { numbers: all.to_vec(), curve: curve.collect() };
            told(&changes).iter().map(ToString::to_string).collect::<Vec<_>>()
        };
        assert_eq!(said(&[]), ["gas_force 180.0 -> 12.85 N", "rebound force at 1.050 m/s 1600 -> 1300 N"]);
        assert_eq!(
            said(&[(MovedBy::Share, "rebound", -0.2), (MovedBy::Share, "compression", -0.04)]),
            ["gas_force 180.0 -> 12.85 N", "rebound force at 1.050 m/s 1600 -> 1300 N (20 % less at every speed)"]
        );
        assert_eq!(
            said(&[(MovedBy::DryForce, "both", 25.2)]),
            [
                "gas_force 180.0 -> 12.85 N",
                "25 N more force against the motion at every speed from 0.003 to 1.05 m/s, in rebound and compression alike, as more dry friction makes"
            ]
        );
        let alone = |reference, value| of(reference, value, 1.0, None).sentence(&[]).to_string();
        assert_eq!(alone(179.219_4, 0.012_852_4), "gas_force 179.2 -> 0.01285 N");
        assert_eq!(alone(627.627, 0.0), "gas_force 627.6 -> 0 N");
        let number =
            |parameter, unit| Change { parameter, unit, ..of(2e-4, 3.5e-4, 1.0, None) }.sentence(&[]).to_string();
        assert_eq!(number("free_play_gap", "m"), "free_play_gap 0.2000 -> 0.3500 mm");
        assert_eq!(number("presliding_power", "-"), "presliding_power 0.0002000 -> 0.0003500");
    }

    #[test]
    fn the_curve_is_straight_between_its_points() {
        let params = Params::new();
        let (v, f) = (params.list(list!("fv_velocity")), params.list(list!("fv_force")));
        for k in 1..v.len() {
            assert_eq!(curve_at(&params, v[k]), f[k]);
            assert!((curve_at(&params, 0.5 * (v[k - 1] + v[k])) - 0.5 * (f[k - 1] + f[k])).abs() < 1e-9);
        }
        assert_eq!((curve_at(&params, -99.0), curve_at(&params, 99.0)), (f[0], f[f.len() - 1]));
    }
}
