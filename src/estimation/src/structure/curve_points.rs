//! Refinement of an FV curve whose dozen points for each stroke do not resolve the valves.
//!
//! Without the refinement, a search would explain the error of a coarse curve by an effect that the damper lacks.

use super::screening::Projection;
use crate::hypothesis::{Free, Hypothesis, number};
use crate::refit::{Effort, Refit, refit};
use crate::samples::Test;
use crate::sensitivity::Accuracy;
use crate::unknowns::{CurveName, Unknown, Unknowns, anchor};
use dashpot_core::curve::MAX_POINTS;
use dashpot_core::{Model, Params, list};
use nalgebra::DVector;

/// Smallest reduction of χ² for each added point. All added points together must reduce the excess of χ² over that of
/// noise by at least the fraction [`BY_POINTS`].
const PER_POINT: f64 = 8.0;
const BY_POINTS: f64 = 0.05;
/// Largest number of refinements of the curve.
const GENERATIONS: usize = 2;

/// Adds points to the FV curve of a refitted hypothesis where they reduce χ² enough. `floor` is the χ² of noise. In the
/// list of parameters, the force increments between the new points replace those between the old points.
pub fn with_enough_points(mut now: (Hypothesis, Refit), tests: &[Test], floor: f64) -> (Hypothesis, Refit) {
    let is_rise = |free: &Free| matches!(free, Free::Model(Unknown::Rise { curve: CurveName::Fv, .. }));
    if !now.0.numbers.iter().any(|n| is_rise(&n.free)) {
        return now;
    }
    for _ in 0..GENERATIONS {
        let (from, at) = &now;
        let worth = |added: usize| (PER_POINT * added as f64).max(BY_POINTS * (at.chi2 - floor));
        if at.chi2 - floor < PER_POINT {
            break;
        }
        let Some((points, expected)) = worth_their_while(from, at, tests) else { break };
        if points.is_empty() || expected < worth(points.len()) {
            break;
        }
        let Some(finer) = with_points(from, &at.theta, &points) else { break };
        match refit(&finer, tests, &finer.start(), None, Effort::JUDGE) {
            Some(refitted) if at.chi2 - refitted.chi2 > worth(points.len()) => {
                now = (finer.starting_at(&refitted.theta), refitted);
            }
            _ => break,
        }
    }
    now
}

/// Returns the middle of every interval of the FV curve, m/s. It is the geometric mean of the ends, because the points
/// are spaced geometrically. Next to zero, it is the arithmetic mean.
fn middles(from: &Hypothesis) -> Vec<f64> {
    let velocity = from.base.list(list!("fv_velocity"));
    velocity
        .windows(2)
        .map(|pair| {
            if pair[0] * pair[1] > 0.0 {
                (pair[0] * pair[1]).sqrt().copysign(pair[0])
            } else {
                0.5 * (pair[0] + pair[1])
            }
        })
        .collect()
}

/// Returns the middles at which a point reduces χ² enough, and the total reduction. Returns `None` if the curve with
/// all middles exceeds the table, or if it gives no valid model or no finite force.
///
/// All other parameters adapt to first order. A greedy selection adds the best middle first.
fn worth_their_while(from: &Hypothesis, at: &Refit, tests: &[Test]) -> Option<(Vec<f64>, f64)> {
    let room = MAX_POINTS - from.base.list(list!("fv_velocity")).len();
    let middles = middles(from);
    let all = with_points(from, &at.theta, &middles)?;
    let jacobian = all.jacobian(Accuracy::Derivatives, tests, &all.start())?;
    let velocity = all.base.list(list!("fv_velocity")).to_vec();
    let zero = anchor(&velocity);
    let rise = |point: usize| {
        let of = Free::Model(Unknown::Rise { curve: CurveName::Fv, point });
        all.position(&of).map(|k| jacobian.column(k))
    };
    let here = Refit { jacobian: from.jacobian(Accuracy::Derivatives, tests, &at.theta)?, ..at.clone() };
    let projection = Projection::new(from, &here);
    let mut left = projection.rest(&at.residual);
    // A new point above the line between its neighbors increases the force increment before it and decreases the one
    // after it.
    let mut bumps: Vec<(f64, DVector<f64>)> = middles
        .iter()
        .filter_map(|middle| {
            let point = velocity.iter().position(|v| v == middle)?;
            let outer = if point > zero { point + 1 } else { point.checked_sub(1)? };
            Some((*middle, projection.rest(&(rise(point)? - rise(outer)?))))
        })
        .collect();
    let (mut points, mut promised) = (Vec::new(), 0.0);
    while points.len() < room {
        let gain = |bump: &DVector<f64>| bump.dot(&left).powi(2) / bump.norm_squared().max(1e-300);
        let gains: Vec<f64> = bumps.iter().map(|(_, bump)| gain(bump)).collect();
        let Some(best) = (0..gains.len()).max_by(|a, b| gains[*a].total_cmp(&gains[*b])) else { break };
        if gains[best] < PER_POINT {
            break;
        }
        promised += gains[best];
        let (point, bump) = bumps.swap_remove(best);
        points.push(point);
        let way = bump.normalize();
        left.axpy(-way.dot(&left), &way, 1.0);
        for (_, other) in &mut bumps {
            other.axpy(-way.dot(other), &way, 1.0);
        }
    }
    Some((points, promised))
}

/// Returns a hypothesis with more points on its FV curve. Returns `None` if the table is too small or the model is not
/// valid.
fn with_points(from: &Hypothesis, theta: &[f64], points: &[f64]) -> Option<Hypothesis> {
    let mut velocities = from.base.list(list!("fv_velocity")).to_vec();
    velocities.extend_from_slice(points);
    velocities.sort_by(f64::total_cmp);
    with_velocities(from, theta, &velocities)
}

/// Computes the forces of a parameter set's FV curve, N, at some velocities, m/s. Returns `None` if the set is not a
/// valid model.
pub(crate) fn forces_at(params: &Params, velocities: &[f64]) -> Option<Vec<f64>> {
    let curve = Model::new(params).ok()?.elements().paths.fv_curve;
    Some(velocities.iter().map(|v| curve.evaluate(*v).value).collect())
}

/// Resamples the FV curve of a hypothesis at other velocities, m/s. Returns `None` if the table is too small or the
/// model is not valid.
pub(crate) fn with_velocities(from: &Hypothesis, theta: &[f64], velocities: &[f64]) -> Option<Hypothesis> {
    let mut params = from.params(theta);
    let forces = forces_at(&params, velocities)?;
    params.set_list(list!("fv_velocity"), velocities).ok()?;
    params.set_list(list!("fv_force"), &forces).ok()?;
    let is_point = |free: &Free| matches!(free, Free::Model(Unknown::Rise { curve: CurveName::Fv, .. }));
    let rises = Unknowns::rises(&params, CurveName::Fv).into_iter().map(|rise| number(&params, rise));
    let kept = from.clone().starting_at(theta).numbers;
    let first = kept.iter().position(|n| is_point(&n.free)).unwrap_or(kept.len());
    let mut numbers = kept[..first].to_vec();
    numbers.extend(rises);
    numbers.extend(kept[first..].iter().filter(|n| !is_point(&n.free)).cloned());
    Some(Hypothesis { base: params, numbers, heating: from.heating.clone(), priors: from.priors.clone() })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::prior_set::PriorSet;
    use crate::vocabulary::base_numbers;
    use dashpot_core::Params;

    #[test]
    fn more_points_are_the_same_curve_to_begin_with() {
        let base = Params::new();
        let from = Hypothesis { base, numbers: base_numbers(&base), heating: None, priors: PriorSet::default() };
        let theta = from.start();
        let to = with_points(&from, &theta, &middles(&from)).unwrap();
        assert_eq!(to.base.list(list!("fv_velocity")).len(), 2 * base.list(list!("fv_velocity")).len() - 1);
        assert_eq!(to.numbers.len() - from.numbers.len(), base.list(list!("fv_velocity")).len() - 1);
        let [a, b] = [from.params(&theta), to.params(&to.start())].map(|p| Model::new(&p).unwrap());
        let top = a.elements().paths.fv_curve.evaluate(1.0).value;
        for i in -100..=100 {
            let v = 0.01 * f64::from(i);
            let (a, b) = (a.elements().paths.fv_curve.evaluate(v).value, b.elements().paths.fv_curve.evaluate(v).value);
            assert!((a - b).abs() < 0.01 * top, "{v}: {a} {b}");
        }
    }
}
