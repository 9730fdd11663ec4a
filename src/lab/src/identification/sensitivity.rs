//! Forces of a model over a segment, and their derivatives over the unknowns, in one run.
//!
//! The kernel's own step tells every stage ([`Follow`]); differentiating the stage equation gives the motion of the
//! internal mass over each parameter at the cost of a few products, so a fit with thirty unknowns costs a few runs
//! instead of sixty. Friction and gas act beside the mass: their derivatives are differences of the element itself.

use super::curve_weights::CurveWeights;
use super::segment::Segment;
use super::unknowns::{CurveName, Unknown, Unknowns, anchor};
use dashpot_core::elements::{Elements, Motion};
use dashpot_core::step::{Follow, Integration, Method, Stage, advance};
use dashpot_core::{Model, Output, Params, State};
use nalgebra::DMatrix;

/// Parameters whose change moves the internal mass, and their direct share in the stage equation.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Direction {
    SeriesStiffness,
    SeriesDamping,
    Mass,
    /// Spring coefficient of |x|^k x, k = 0..3.
    SpringPower(i32),
    FvPoint(usize),
    SpringPoint(usize),
}

/// Follows the stages and carries the derivatives along.
struct Tangent<'a> {
    directions: &'a [Direction],
    fv: &'a CurveWeights,
    spring: Option<&'a CurveWeights>,
    first_fv: usize,
    first_spring: usize,
    x: Vec<f64>,
    v: Vec<f64>,
    stages: Vec<(Vec<f64>, Vec<f64>)>,
}

impl Follow for Tangent<'_> {
    fn stage(&mut self, elements: &Elements, s: &Stage) {
        let e = &elements.series_compliance;
        let per_gamma = 1.0 / s.gamma;
        let divide = 1.0 / s.denominator;
        let stiffness = e.stiffness + s.inner.by_x;
        let (done, now) = self.stages.split_at_mut(s.index);
        let (du, push) = &mut now[0];
        for p in 0..self.directions.len() {
            let (mut x, mut v) = (self.x[p], self.v[p]);
            for (j, (u, push)) in done.iter().enumerate() {
                let a = s.row[j] * per_gamma;
                x += a * s.g * u[p];
                v += a * push[p];
            }
            // Known parts are kept in the stage's own slots until the direct shares are added.
            du[p] = e.mass * v - s.g * stiffness * x;
            push[p] = v;
            if s.last {
                self.x[p] = x;
            }
        }
        for (p, direction) in self.directions.iter().enumerate() {
            du[p] += match direction {
                Direction::SeriesStiffness => s.g * (s.path.x - s.x_m),
                Direction::SeriesDamping => s.g * (s.path.v - s.u),
                Direction::Mass => s.known_velocity - s.u,
                Direction::SpringPower(k) => -s.g * s.x_m * s.x_m.abs().powi(*k),
                Direction::FvPoint(_) | Direction::SpringPoint(_) => 0.0,
            };
        }
        let (first, weights) = self.fv.at(s.u);
        if self.first_fv < self.directions.len() {
            for (k, w) in weights.iter().enumerate().take(self.fv.points()) {
                du[self.first_fv + first + k] -= s.g * w;
            }
        }
        if let Some(spring) = self.spring {
            let (first, weights) = spring.at(s.x_m);
            for (k, w) in weights.iter().enumerate().take(spring.points()) {
                du[self.first_spring + first + k] -= s.g * w;
            }
        }
        for p in 0..self.directions.len() {
            let u = du[p] * divide;
            push[p] = u - push[p];
            du[p] = u;
            if s.last {
                self.x[p] += s.g * u;
                self.v[p] = u;
            }
        }
    }
}

/// An unknown that acts beside the mass: the element's own difference.
struct Beside {
    column: usize,
    plus: Model,
    minus: Model,
    per: f64,
}

/// How exactly a model is integrated in a fit.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Accuracy {
    /// As a host would.
    Full,
    /// One substep of the fourth-order method, however long the step: as good on smooth motions, and several times cheaper
    /// where a test is slow.
    Single,
    /// One substep of the second-order method: a few tenths of a percent off, a third of the cost.
    Cheap,
}

/// A run that is prepared once per parameter vector and shared by all segments.
pub struct Run {
    model: Model,
    params: Params,
    directions: Vec<Direction>,
    columns: Vec<usize>,
    first_fv: usize,
    first_spring: usize,
    fv: CurveWeights,
    spring: CurveWeights,
    beside: Vec<Beside>,
    rises: Vec<(usize, CurveName, usize)>,
    differences: Vec<(usize, Model, Model, f64)>,
    unknowns: usize,
}

const NOWHERE: usize = usize::MAX;

impl Run {
    /// Prepares the run at `theta`; `None` if the parameters do not make a model.
    pub fn new(unknowns: &Unknowns, theta: &[f64], accuracy: Accuracy) -> Option<Run> {
        let params = unknowns.params(theta);
        let prepare = |params: &Params| {
            let model = Model::new(params).ok()?;
            Some(match accuracy {
                Accuracy::Full => model,
                Accuracy::Single => model.with_integration(Integration::fixed(Method::Fourth, 1)),
                Accuracy::Cheap => model.with_integration(Integration::fixed(Method::Second, 1)),
            })
        };
        let model = prepare(&params)?;
        let mut run = Run {
            model,
            params,
            directions: Vec::new(),
            columns: Vec::new(),
            first_fv: NOWHERE,
            first_spring: NOWHERE,
            fv: CurveWeights::new(params.list("fv_velocity"), params.list("fv_force")),
            spring: CurveWeights::new(params.list("spring_displacement"), params.list("spring_force")),
            beside: Vec::new(),
            rises: Vec::new(),
            differences: Vec::new(),
            unknowns: unknowns.list.len(),
        };
        // Elements that the stages do not tell of: every derivative is then a difference of two runs.
        let differ = model.elements().has_extras();
        for (column, unknown) in unknowns.list.iter().enumerate() {
            let direction = match unknown {
                _ if differ => None,
                Unknown::Log(name) | Unknown::Linear(name) => match *name {
                    "series_stiffness" => Some(Direction::SeriesStiffness),
                    "series_damping" => Some(Direction::SeriesDamping),
                    "internal_mass" => Some(Direction::Mass),
                    "spring_linear" => Some(Direction::SpringPower(0)),
                    "spring_quadratic" => Some(Direction::SpringPower(1)),
                    "spring_cubic" => Some(Direction::SpringPower(2)),
                    "spring_quartic" => Some(Direction::SpringPower(3)),
                    _ => None,
                },
                Unknown::Rise { curve, point } => {
                    run.rises.push((column, *curve, *point));
                    continue;
                }
                Unknown::Entry(..) | Unknown::Above(..) => None,
            };
            if let Some(direction) = direction {
                run.directions.push(direction);
                run.columns.push(column);
                continue;
            }
            let step = 1e-5 * theta[column].abs().max(1e-3);
            let moved = |d: f64| {
                let mut theta = theta.to_vec();
                theta[column] += d;
                prepare(&unknowns.params(&theta))
            };
            let (plus, minus) = (moved(step)?, moved(-step)?);
            if differ {
                run.differences.push((column, plus, minus, 0.5 / step));
            } else {
                run.beside.push(Beside { column, plus, minus, per: 0.5 / step });
            }
        }
        for (curve, weights) in [(CurveName::Fv, run.fv.points()), (CurveName::Spring, run.spring.points())] {
            if run.rises.iter().any(|r| r.1 == curve) {
                let first = run.directions.len();
                for point in 0..weights {
                    run.directions.push(match curve {
                        CurveName::Fv => Direction::FvPoint(point),
                        CurveName::Spring => Direction::SpringPoint(point),
                    });
                    run.columns.push(NOWHERE);
                }
                match curve {
                    CurveName::Fv => run.first_fv = first,
                    CurveName::Spring => run.first_spring = first,
                }
            }
        }
        // Logarithmic unknowns scale their column by the value itself.
        Some(run)
    }

    /// Forces at the samples of a segment.
    pub fn forces(&self, segment: &Segment) -> Vec<f64> {
        forces(&self.model, segment)
    }

    /// Forces at the samples, and their derivatives: one column per sample, one row per unknown. The derivatives take the
    /// settled state at the first sample as given, which only samples before the scored ones feel.
    pub fn jacobian(&self, segment: &Segment, unknowns: &Unknowns, theta: &[f64]) -> (Vec<f64>, DMatrix<f64>) {
        let n = segment.force.len();
        let model = &self.model;
        let mut rows = DMatrix::zeros(self.unknowns, n);
        let mut forces = Vec::with_capacity(n);
        let p = self.directions.len();
        let mut tangent = Tangent {
            directions: &self.directions,
            fv: &self.fv,
            spring: (self.first_spring != NOWHERE).then_some(&self.spring),
            first_fv: self.first_fv,
            first_spring: self.first_spring,
            x: vec![0.0; p],
            v: vec![0.0; p],
            stages: vec![(vec![0.0; p], vec![0.0; p]); 8],
        };
        let series = model.elements().series_compliance;
        let has_series = model.elements().has_series();
        let mut state = model.settled(&segment.input[0]);
        let (mut next, mut output) = (State::ZERO, Output::ZERO);
        let mut by_point = vec![0.0; p];
        for i in 0..n {
            let input = &segment.input[i];
            if i == 0 {
                output = dashpot_core::evaluate::force(model, &state, input);
                next = state;
            } else {
                advance(model, &state, input, segment.dt[i], &mut tangent, &mut next, &mut output);
            }
            state = next;
            forces.push(output.force);
            let x = state.displacement;
            if has_series {
                for (k, direction) in self.directions.iter().enumerate() {
                    by_point[k] = -series.stiffness * tangent.x[k] - series.damping * tangent.v[k]
                        + match direction {
                            Direction::SeriesStiffness => x - state.mass_displacement,
                            Direction::SeriesDamping => input.velocity - state.mass_velocity,
                            _ => 0.0,
                        };
                }
            } else {
                by_point.fill(0.0);
                for (k, direction) in self.directions.iter().enumerate() {
                    if let Direction::SpringPower(power) = direction {
                        by_point[k] = x * x.abs().powi(*power);
                    }
                }
                if self.first_fv != NOWHERE {
                    let (first, w) = self.fv.at(input.velocity);
                    for (k, w) in w.iter().enumerate().take(self.fv.points()) {
                        by_point[self.first_fv + first + k] += w;
                    }
                }
                if self.first_spring != NOWHERE {
                    let (first, w) = self.spring.at(x);
                    for (k, w) in w.iter().enumerate().take(self.spring.points()) {
                        by_point[self.first_spring + first + k] += w;
                    }
                }
            }
            let mut row = rows.column_mut(i);
            for (k, column) in self.columns.iter().enumerate() {
                if *column != NOWHERE {
                    row[*column] = by_point[k];
                }
            }
            for (column, curve, point) in &self.rises {
                // A rise lifts every point from its own outwards.
                let (first, u) = match curve {
                    CurveName::Fv => (self.first_fv, self.params.list("fv_velocity")),
                    CurveName::Spring => (self.first_spring, self.params.list("spring_displacement")),
                };
                let zero = anchor(u);
                row[*column] = if *point > zero {
                    by_point[first + point..first + u.len()].iter().sum()
                } else {
                    -by_point[first..first + point + 1].iter().sum::<f64>()
                };
            }
            if !self.beside.is_empty() {
                let at = Motion {
                    displacement: x,
                    velocity: input.velocity,
                    side_force: input.side_force,
                    temperature: input.temperature,
                };
                let beside = |m: &Model| m.elements().friction(&at).force + m.elements().preload(&at).force;
                for b in &self.beside {
                    row[b.column] = (beside(&b.plus) - beside(&b.minus)) * b.per;
                }
            }
        }
        for (column, plus, minus, per) in &self.differences {
            let (a, b) = (self::forces(plus, segment), self::forces(minus, segment));
            for i in 0..n {
                rows[(*column, i)] = (a[i] - b[i]) * per;
            }
        }
        for (column, unknown) in unknowns.list.iter().enumerate() {
            let direct = self.columns.contains(&column);
            if let (Unknown::Log(_), true) = (unknown, direct) {
                rows.row_mut(column).scale_mut(theta[column].exp());
            }
        }
        (forces, rows)
    }
}

/// Forces of a model at the samples of a segment, from the settled state at its first.
pub fn forces(model: &Model, segment: &Segment) -> Vec<f64> {
    let mut state = model.settled(&segment.input[0]);
    let mut out = vec![dashpot_core::evaluate::force(model, &state, &segment.input[0]).force];
    let (mut next, mut output) = (State::ZERO, Output::ZERO);
    for i in 1..segment.input.len() {
        advance(model, &state, &segment.input[i], segment.dt[i], &mut (), &mut next, &mut output);
        state = next;
        out.push(output.force);
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::accuracy::Sine;
    use dashpot_core::Input;

    fn segment(amplitude: f64, frequency: f64) -> Segment {
        let motion = Sine { amplitude, frequency }.motion();
        let dt = 1.0 / frequency / 100.0;
        let n = 150;
        let input = (0..n)
            .map(|i| {
                let (x, v) = motion(i as f64 * dt);
                Input { side_force: 200.0, ..Input::motion(x, v) }
            })
            .collect();
        Segment {
            name: String::new(),
            dt: vec![dt; n],
            input,
            force: vec![0.0; n],
            from: 40,
            scale: 1.0,
            top: 1.0,
            peak_velocity: 1.0,
            amplitude,
        }
    }

    #[test]
    fn derivatives_agree_with_differences() {
        let mut base = Params::new();
        base.set_list("spring_displacement", &[-0.05, -0.02, 0.0, 0.02, 0.05]).unwrap();
        base.set_list("spring_force", &[-90.0, -20.0, 0.0, 15.0, 80.0]).unwrap();
        base.enable("side_force_friction", true).unwrap();
        for series in [true, false] {
            base.enable("series_compliance", series).unwrap();
            let mut list = Unknowns::rises(&base, CurveName::Fv);
            list.extend(Unknowns::rises(&base, CurveName::Spring));
            list.extend([
                Unknown::Linear("spring_linear"),
                Unknown::Linear("spring_quadratic"),
                Unknown::Linear("gas_force"),
                Unknown::Above("stribeck_breakaway_force", "stribeck_coulomb_force"),
                Unknown::Log("stribeck_breakaway_velocity"),
                Unknown::Linear("side_force_coefficient"),
            ]);
            if series {
                list.extend([
                    Unknown::Log("series_stiffness"),
                    Unknown::Linear("series_damping"),
                    Unknown::Log("internal_mass"),
                ]);
            }
            let mut base = base;
            base.set("spring_linear", 500.0).unwrap();
            let unknowns = Unknowns { base, list };
            let theta = unknowns.start();
            for test in [segment(0.03, 3.0), segment(0.002, 20.0)] {
                let run = Run::new(&unknowns, &theta, Accuracy::Full).unwrap();
                let (forces, rows) = run.jacobian(&test, &unknowns, &theta);
                assert_eq!(forces, run.forces(&test));
                for p in 0..theta.len() {
                    let step = 1e-3 * theta[p].abs().max(1e-2);
                    let moved = |d: f64| {
                        let mut t = theta.clone();
                        t[p] += d;
                        Run::new(&unknowns, &t, Accuracy::Full).unwrap().forces(&test)
                    };
                    let (a, b) = (moved(step), moved(-step));
                    let difference: Vec<f64> = a.iter().zip(&b).map(|(a, b)| (a - b) / (2.0 * step)).collect();
                    // The settled start is taken as given; its dependence is forgotten before the first scored sample.
                    let scored = test.from..a.len();
                    let size = difference[scored.clone()].iter().map(|d| d * d).sum::<f64>().sqrt();
                    let off = scored.map(|i| (rows[(p, i)] - difference[i]).powi(2)).sum::<f64>().sqrt();
                    assert!(off <= 2e-3 * size + 1e-6, "{:?}: off {off} of {size}", unknowns.list[p]);
                }
            }
        }
    }
}
