//! Extension of a hypothesis by one effect: elements of the effect are enabled, its parameters are made free, and one
//! of its starts is applied.

use crate::hypothesis::{Free, Hypothesis, Number, number};
use crate::scale::Scale;
use crate::spring_end::straighten;
use crate::unknowns::{CurveName, Unknown, anchor, towards_zero};
use crate::vocabulary::{Candidate, Fresh, LinearExtension, Start};
use dashpot_core::Params;
use dashpot_core::list;
use dashpot_core::parameter;
use dashpot_records::restrict;

/// Returns the hypothesis with the parameters `theta`, extended by a candidate at one of the candidate's starts.
pub fn extend(from: &Hypothesis, theta: &[f64], candidate: &Candidate, start: &Start) -> Hypothesis {
    let mut to = from.clone().starting_at(theta);
    for element in candidate.elements {
        to.base.enable(*element, true);
    }
    for (number, value) in &candidate.fixed {
        set(&mut to.base, *number, *value);
    }
    for (fresh, value) in candidate.fresh.iter().zip(&start.values) {
        if let Free::Model(unknown) = &fresh.free {
            place(&mut to.base, unknown, *value);
        }
    }
    for (fresh, value) in candidate.fresh.iter().zip(&start.values) {
        let number = to.with_own_prior(fresh_number(&to.base, fresh, *value));
        to.numbers.push(number);
    }
    for (number, factor) in &start.moves {
        scale(&mut to, *number, *factor);
    }
    if !start.curve.is_empty() {
        set_curve(&mut to, &start.curve);
    }
    if let Some(drawn) = &start.unbend {
        unbend(&mut to, drawn);
    }
    if let Some(side) = start.straighten {
        straighten(&mut to, side);
    }
    if start.level > 0.0 {
        level(&mut to, start.level);
    }
    to
}

/// Sets a scalar, clamped to its bounds.
fn set(params: &mut Params, number: parameter::Number, value: f64) {
    let _ = params.set(number, number.inside(value));
}

fn place(params: &mut Params, unknown: &Unknown, value: f64) {
    match unknown {
        Unknown::Log(n) | Unknown::Linear(n) | Unknown::Above(n, _) => set(params, *n, value),
        Unknown::Rise { .. } | Unknown::Entry(..) => {}
    }
}

/// Ratio of two prior standard deviations: that of a parameter's change from a reference damper, and that of the
/// parameter itself. The deviation of the parameter itself counts at most as two typical steps of a search. [`CURVE`]
/// is the prior standard deviation of the relative change of a part of the FV curve.
const CHANGED: f64 = 2.0;
const CURVE: f64 = 0.4;

fn fresh_number(base: &Params, fresh: &Fresh, value: f64) -> Number {
    match &fresh.free {
        Free::Model(unknown) => {
            let mut number = number(base, *unknown);
            if let Unknown::Linear(_) = unknown {
                let (low, high) = fresh.plausible;
                number.step = (0.3 * value.abs()).max(0.02 * (high - low).abs().min(10.0 * value.abs().max(1e-6)));
            }
            number
        }
        Free::Shift(unknown) => {
            let own = number(base, *unknown);
            let bounds = (own.bounds.0 - own.start, own.bounds.1 - own.start);
            let spread = CHANGED * own.prior.map_or(own.step, |(_, sd)| sd.min(2.0 * own.step));
            Number { free: fresh.free.clone(), start: value, step: own.step, bounds, prior: Some((0.0, spread)) }
        }
        Free::Curve(_) => {
            let prior = Some((0.0, CURVE));
            Number { free: fresh.free.clone(), start: value, step: 0.1, bounds: (-0.95, 3.0), prior }
        }
        Free::Rig(artefact) => {
            let ((low, high), factor) = (artefact.bounds(), Scale::from_params(base).of_artefact(*artefact));
            // A delay estimated from the raw data may far exceed the delays of filters. The bounds are then centered on
            // that estimate.
            let about = if (low..=high).contains(&value) { 0.0 } else { value };
            let bounds = (factor * low + about, factor * high + about);
            Number { free: fresh.free.clone(), start: value, step: value.abs(), bounds, prior: None }
        }
        Free::Cooling | Free::HeatCapacity => {
            let heat = Scale::from_params(base).force();
            let (low, high) = if fresh.free == Free::Cooling { (1e-4f64, 1.0f64) } else { (50.0 * heat, 1e5 * heat) };
            let start = libm::log(value);
            let prior = fresh.deviation.map(|d| (start, d));
            Number { free: fresh.free.clone(), start, step: 0.3, bounds: (libm::log(low), libm::log(high)), prior }
        }
    }
}

/// Multiplies the start value of the free parameter `which` of the model by a factor.
fn scale(to: &mut Hypothesis, which: parameter::Number, factor: f64) {
    for number in &mut to.numbers {
        let (low, high) = number.bounds;
        match &number.free {
            Free::Model(Unknown::Log(n)) if *n == which => {
                number.start = restrict(number.start + libm::log(factor), low, high)
            }
            Free::Model(Unknown::Linear(n)) if *n == which => number.start = restrict(number.start * factor, low, high),
            _ => {}
        }
    }
}

/// Returns the free force increments of one stroke of the FV curve (1 rebound, −1 compression), innermost first. Each
/// entry is the index of the increment among the parameters and the index of its point.
fn branch(of: &Hypothesis, velocity: &[f64], stroke: f64) -> Vec<(usize, usize)> {
    let mut rises: Vec<(usize, usize)> = of
        .numbers
        .iter()
        .enumerate()
        .filter_map(|(place, n)| match &n.free {
            Free::Model(Unknown::Rise { curve: CurveName::Fv, point }) if velocity[*point] * stroke > 0.0 => {
                Some((place, *point))
            }
            _ => None,
        })
        .collect();
    rises.sort_by(|a, b| velocity[a.1].abs().total_cmp(&velocity[b.1].abs()));
    rises
}

/// Sets the start of the FV curve to the given forces at its points, N.
fn set_curve(to: &mut Hypothesis, forces: &[f64]) {
    let zero = anchor(to.base.list(list!("fv_velocity")));
    for number in &mut to.numbers {
        if let Free::Model(Unknown::Rise { curve: CurveName::Fv, point }) = &number.free
            && let (Some(own), Some(inner)) = (forces.get(*point), forces.get(towards_zero(*point, zero)))
        {
            number.start = restrict((own - inner).abs(), number.bounds.0, number.bounds.1);
        }
    }
}

/// Subtracts a force, N, from the innermost increments of the FV curve, on both strokes. Each increment keeps at least
/// a tenth of its value.
fn level(to: &mut Hypothesis, force: f64) {
    let velocity = to.base.list(list!("fv_velocity")).to_vec();
    for stroke in [1.0, -1.0] {
        let mut left = force;
        for (place, _) in branch(to, &velocity, stroke) {
            let number = &mut to.numbers[place];
            let taken = left.min(0.9 * number.start);
            number.start -= taken;
            left -= taken;
        }
    }
}

/// Raises the slope of the FV curve on the stroke `drawn.stroke` where the force exceeds `drawn.from`, N. The slope
/// there becomes at least `drawn.steepness` times the slope below that force.
fn unbend(to: &mut Hypothesis, drawn: &LinearExtension) {
    let velocity = to.base.list(list!("fv_velocity")).to_vec();
    let zero = anchor(&velocity);
    let (mut force, mut slope) = (0.0, None);
    for (place, point) in branch(to, &velocity, drawn.stroke) {
        let span = (velocity[point] - velocity[towards_zero(point, zero)]).abs();
        let number = &mut to.numbers[place];
        let rise = number.start;
        force += rise;
        match slope {
            Some(slope) if force > drawn.from => {
                let steep = rise.max(drawn.steepness * slope * span);
                number.start = restrict(steep, number.bounds.0, number.bounds.1);
                force += number.start - rise;
            }
            _ => slope = Some(rise / span),
        }
    }
}
