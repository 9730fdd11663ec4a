//! Screening of effects for a refit: the reduction of χ² by each effect if the other parameters of the model adapt to
//! first order.
//!
//! The parameters of the model without the candidate (base parameters) absorb a part of every effect. Therefore, a
//! candidate's response is first projected onto the orthogonal complement of the base parameters' Jacobian (Frisch &
//! Waugh, Econometrica 1, 1933; Lovell, J. Am. Stat. Assoc. 58, 1963).

use super::extend::extend;
use super::nearby::Nearby;
use crate::cancel;
use crate::gram::gram;
use crate::hypothesis::{Free, Hypothesis, Residual};
use crate::refit::{Refit, weights};
use crate::samples::Test;
use crate::unknowns::Unknown;
use crate::vocabulary::{Candidate, Fresh, Start};
use dashpot_records::restrict;
use nalgebra::{Cholesky, DMatrix, DVector, Dyn};
use rayon::prelude::*;

/// Projection of a residual onto the orthogonal complement of the Jacobian of the base parameters, which are those of
/// the model without candidates.
pub struct Projection {
    jacobian: DMatrix<f64>,
    weights: Vec<f64>,
    solver: Option<Cholesky<f64, Dyn>>,
}

impl Projection {
    /// Makes the projection at a refitted hypothesis.
    pub fn new(hypothesis: &Hypothesis, refit: &Refit) -> Projection {
        let weights = weights(&refit.residual);
        let mut jacobian = refit.jacobian.clone();
        for ((mut column, number), value) in jacobian.column_iter_mut().zip(&hypothesis.numbers).zip(&refit.theta) {
            // A parameter at its bound cannot adapt any further.
            let (low, high) = number.bounds;
            let free = *value > low && *value < high;
            for (value, w) in column.iter_mut().zip(&weights) {
                *value *= if free { *w } else { 0.0 };
            }
        }
        let mut normal = gram(&jacobian);
        for (i, number) in hypothesis.numbers.iter().enumerate() {
            normal[(i, i)] *= 1.0 + 1e-9;
            normal[(i, i)] += 1e-9 / (number.step * number.step);
            if let Some((_, deviation)) = number.prior {
                normal[(i, i)] += 1.0 / (deviation * deviation);
            }
        }
        Projection { jacobian, weights, solver: normal.cholesky() }
    }

    fn weighted(&self, b: &Residual) -> Residual {
        DVector::from_fn(b.len(), |i, _| b[i] * self.weights[i])
    }

    /// Computes the least-squares changes of the base parameters for a residual, or zeros if the normal matrix has no
    /// Cholesky decomposition.
    pub fn solve(&self, b: &Residual) -> DVector<f64> {
        let right = self.jacobian.tr_mul(&self.weighted(b));
        match &self.solver {
            Some(solver) => solver.solve(&right),
            None => DVector::zeros(self.jacobian.ncols()),
        }
    }

    /// Computes the weighted part of a residual that changes of the base parameters cannot reproduce.
    pub fn rest(&self, b: &Residual) -> Residual {
        self.rest_of(b, &self.solve(b))
    }

    /// Computes the weighted residual that remains after the parameter changes `answer`, a solution of
    /// [`Projection::solve`].
    fn rest_of(&self, b: &Residual, answer: &DVector<f64>) -> Residual {
        self.weighted(b) - &self.jacobian * answer
    }
}

/// A screened start of a candidate.
pub struct Screened {
    /// Index of the candidate in the list of candidates.
    pub candidate: usize,
    /// The hypothesis with the candidate.
    pub hypothesis: Hypothesis,
    /// Start of the refit, in which the base parameters are adapted to first order.
    pub start: Vec<f64>,
    /// Reduction of χ² expected from the refit.
    pub gain: f64,
    /// Squared norm of the candidate's weighted response, after the adaptation of the base parameters. A small norm
    /// means that the records cannot show the candidate.
    pub visible: f64,
    /// Whether the start also changes base parameters.
    pub moved: bool,
}

/// Returns the force of a measurement error that adds a known force in each test, divided by the allowed errors.
/// Returns `None` for any other candidate.
fn added(candidate: &Candidate, value: f64, tests: &[Test]) -> Option<Residual> {
    let [Fresh { free: Free::Rig(artefact), .. }] = &candidate.fresh[..] else { return None };
    let per_test: Option<Vec<f64>> = tests.iter().map(|t| artefact.per_value(&t.segment)).collect();
    let list: Vec<f64> =
        tests.iter().zip(per_test?).flat_map(|(t, per)| t.allowed.iter().map(move |a| value * per / a)).collect();
    Some(DVector::from_vec(list))
}

/// Natural logarithm of the largest factor by which a positive start value is scaled to the strength in the residual.
/// For a larger factor, the response is no longer proportional to the parameter.
const FURTHEST: f64 = 3.0;

/// Screens every start of every candidate. Starts at which the model gives no finite force are omitted.
pub fn screen(
    hypothesis: &Hypothesis,
    at: &Refit,
    projection: &Projection,
    candidates: &[Candidate],
    tests: &[Test],
    nearby: &Nearby,
) -> Vec<Screened> {
    let answer = projection.solve(&at.residual);
    let left = projection.rest_of(&at.residual, &answer);
    let jobs: Vec<(usize, &Candidate, &Start)> =
        candidates.iter().enumerate().flat_map(|(k, c)| c.starts.iter().map(move |s| (k, c, s))).collect();
    jobs.par_iter()
        .filter_map(|(place, candidate, start)| {
            if cancel::asked() {
                return None;
            }
            let extended = extend(hypothesis, &at.theta, candidate, start);
            let mut theta = extended.start();
            let first = hypothesis.numbers.len();
            // Change of the weighted forces due to the candidate.
            let change = match added(candidate, theta[first], tests) {
                Some(added) => added,
                None => &at.residual - nearby.residual(&extended, tests, &theta)?,
            };
            let mut taken_up = projection.solve(&change);
            let response = projection.rest_of(&change, &taken_up);
            let visible = response.norm_squared();
            let moved = start.moves_the_base();
            let (mut gain, mut used) = (2.0 * left.dot(&response) - visible, 1.0);
            if !moved && visible > 0.0 {
                // Best-fitting strength, relative to the start value, if the response is proportional to the strength.
                let strength = left.dot(&response) / visible;
                let (low, high) = extended.numbers[first].bounds;
                let is_log = matches!(&extended.numbers[first].free, Free::Model(Unknown::Log(_)));
                if !is_log {
                    let wanted = theta[first] * strength.clamp(-4.0, 4.0);
                    let value = restrict(wanted, low, high);
                    used = value / theta[first];
                    gain = used * (2.0 * left.dot(&response) - used * visible);
                    theta[first] = if value == 0.0 { 1e-3 * theta[first] } else { value };
                } else if strength > 0.0 {
                    // Many responses are also proportional to a parameter whose logarithm is free. The response at the
                    // scaled value tests whether the response of this candidate is proportional.
                    let mut scaled = theta.clone();
                    scaled[first] = restrict(theta[first] + libm::log(strength).clamp(-FURTHEST, FURTHEST), low, high);
                    if let Some(residual) = nearby.residual(&extended, tests, &scaled) {
                        let change = &at.residual - residual;
                        let taken_up_there = projection.solve(&change);
                        let response = projection.rest_of(&change, &taken_up_there);
                        let gain_there = 2.0 * left.dot(&response) - response.norm_squared();
                        if gain_there > gain {
                            (gain, taken_up, theta) = (gain_there, taken_up_there, scaled);
                        }
                    }
                    // If the response is not proportional, the parameter changes the shape of the response. The gain at
                    // the best strength then determines whether the start is refitted.
                    gain = gain.max(left.dot(&response).powi(2) / visible);
                }
            }
            for (i, d) in (&answer - taken_up * used).iter().enumerate() {
                let (low, high) = extended.numbers[i].bounds;
                theta[i] = restrict(theta[i] + d, low, high);
            }
            Some(Screened { candidate: *place, hypothesis: extended, start: theta, gain, visible, moved })
        })
        .collect()
}
