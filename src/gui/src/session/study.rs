//! Study of one parameter: loops of one test for several values, with the gap and the area of each loop.

use crate::session::Session;
use crate::session::campaign::Loaded;
use crate::session::simulation::OfTest;
use dashpot_core::parameter::Number;
use dashpot_core::{Model, Params};
use dashpot_records::Record;
use dashpot_records::smoothing::Motion;
use dashpot_simulation::prediction::predict;
use rayon::prelude::*;

/// Input of a study.
#[derive(Debug, Clone, PartialEq)]
pub struct Question {
    /// Parameter that varies.
    pub number: Number,
    /// First and last value, SI.
    pub range: [f64; 2],
    /// Whether the ratio of successive values is constant.
    pub factors: bool,
    /// Number of values of the parameter.
    pub count: usize,
    /// Index of the test whose motion is the input.
    pub test: usize,
}

/// Result for one value of the varied parameter.
#[derive(Debug, Clone)]
pub struct Member {
    /// Value of the parameter, SI.
    pub value: f64,
    /// Forces over the shown cycle, N.
    pub force: Vec<f64>,
    /// Area of the loop of force over displacement, J: the work of one cycle.
    pub area: f64,
    /// Mean force near zero velocity while the velocity falls minus that while the velocity rises, N.
    pub gap: f64,
}

/// Loops of one test for several values of a parameter.
#[derive(Debug, Clone)]
pub struct Study {
    /// Input of the study.
    pub question: Question,
    /// Values of the damper before the variation.
    params: Params,
    /// Results for the valid values, in the order of the values.
    pub members: Vec<Member>,
    /// Area, J, and gap, N, of the measured cycle, defined as in [`Member`].
    pub measured: [f64; 2],
}

/// Simulates each value of the parameter. Omits values that do not make a valid model. Returns `None` if the test does not exist.
pub fn study(question: &Question, params: &Params, loaded: &Loaded) -> Option<Study> {
    let (record, seen) = (loaded.campaign.records.get(question.test)?, loaded.tests.get(question.test)?);
    let [low, high] = question.range;
    let value = |k: usize| {
        let part = k as f64 / (question.count.max(2) - 1) as f64;
        if question.factors && low > 0.0 { low * libm::pow(high / low, part) } else { low + part * (high - low) }
    };
    let cycle = &seen.cycle;
    let n = seen.cycle_samples;
    let figures =
        |force: &[f64]| [loop_area(&cycle.displacement[..n], force), gap(&seen.cycle_motion.velocity[..n], force)];
    let members = (0..question.count.max(2))
        .into_par_iter()
        .filter_map(|k| {
            let mut with = *params;
            with.set(question.number, value(k)).ok()?;
            let model = Model::new(&with).ok()?;
            let rise = loaded.warm.rise(&with, question.test);
            let along = |record: &Record, motion: &Motion| predict(&model, record, motion, rise);
            let force = OfTest::simulate(along, record, seen, true).shown;
            let [area, gap] = figures(&force);
            Some(Member { value: value(k), force, area, gap })
        })
        .collect();
    Some(Study { question: question.clone(), params: *params, members, measured: figures(&cycle.force[..n]) })
}

impl Study {
    /// Returns whether the damper of the test has changed since the study. A change of the varied parameter alone does not count.
    pub fn is_old(&self, session: &Session) -> bool {
        let without = |mut params: Params| {
            let _ = params.set(self.question.number, self.params.number(self.question.number));
            params
        };
        session.params_of_study(self.question.test).map(without) != Some(self.params)
    }
}

/// Computes the area inside a closed loop, ∮ F dx. For `x` in m and the force F in N, this is the work of one cycle, J.
pub fn loop_area(x: &[f64], force: &[f64]) -> f64 {
    let n = x.len().min(force.len());
    (0..n).map(|i| 0.5 * (force[i] + force[(i + 1) % n]) * (x[(i + 1) % n] - x[i])).sum()
}

/// Largest speed at which the gap is evaluated, as a fraction of the peak velocity. Friction and compressibility open the loop most at low
/// velocity.
const SLOW: f64 = 0.2;

/// Computes the gap at low velocities, N: mean force while the velocity falls minus mean force while the velocity rises. Returns 0 without
/// samples of both kinds.
pub fn gap(velocity: &[f64], force: &[f64]) -> f64 {
    let peak = velocity.iter().fold(0.0f64, |m, v| v.abs().max(m));
    let n = velocity.len().min(force.len());
    let mut sums = [(0.0, 0.0); 2];
    for i in (0..n).filter(|i| velocity[*i].abs() <= SLOW * peak) {
        let falls = velocity[(i + 1) % n] < velocity[i];
        let (count, sum) = &mut sums[usize::from(falls)];
        *count += 1.0;
        *sum += force[i];
    }
    let [(rising, up), (falling, down)] = sums;
    if rising > 0.0 && falling > 0.0 { down / falling - up / rising } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    #[test]
    fn area_and_gap_of_a_known_loop() {
        let n = 2000;
        let phase = |i: usize| TAU * i as f64 / n as f64;
        let x: Vec<f64> = (0..n).map(|i| 0.01 * libm::sin(phase(i))).collect();
        let v: Vec<f64> = (0..n).map(|i| 0.01 * TAU * libm::cos(phase(i))).collect();
        // The test damper has the viscous damping c = 1000 N s/m and a spring of 5000 N/m. The motion has the amplitude X = 10 mm and the
        // angular frequency ω = 2π rad/s. The area is π c ω X², and only the spring causes a gap.
        let force: Vec<f64> = x.iter().zip(&v).map(|(x, v)| 1000.0 * v + 5000.0 * x).collect();
        let wanted = std::f64::consts::PI * 1000.0 * TAU * 0.01 * 0.01;
        assert!((loop_area(&x, &force) / wanted - 1.0).abs() < 1e-3);
        let viscous: Vec<f64> = v.iter().map(|v| 1000.0 * v).collect();
        assert!(gap(&v, &viscous).abs() < 0.5);
        // While the velocity falls, the spring is extended: x > 0. So the gap is about twice the spring force at the amplitude.
        let found = gap(&v, &force);
        assert!((found / (2.0 * 5000.0 * 0.01) - 1.0).abs() < 0.05, "{found}");
    }
}
