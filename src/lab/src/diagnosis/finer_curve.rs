//! An FV curve with more points, where a dozen on each stroke are too few for the valves at hand: what a curve can hold is
//! no missing effect.

use super::hypothesis::{Free, Hypothesis};
use super::vocabulary::base_numbers;
use crate::identification::unknowns::Unknown;
use dashpot_core::Model;
use dashpot_core::curve::MAX_POINTS;

/// The explanation at `theta` with a point more in every interval of its FV curve; `None` where the curve is full.
pub fn finer(from: &Hypothesis, theta: &[f64]) -> Option<Hypothesis> {
    let mut params = from.params(theta);
    let curve = Model::new(&params).ok()?.elements().fv_curve;
    let velocity = params.list("fv_velocity").to_vec();
    if 2 * velocity.len() - 1 > MAX_POINTS {
        return None;
    }
    let mut points: Vec<f64> = velocity.clone();
    for pair in velocity.windows(2) {
        // In the middle by ratio, as the points themselves are spread.
        let middle = if pair[0] * pair[1] > 0.0 {
            (pair[0] * pair[1]).sqrt().copysign(pair[0])
        } else {
            0.5 * (pair[0] + pair[1])
        };
        points.push(middle);
    }
    points.sort_by(f64::total_cmp);
    let force: Vec<f64> = points.iter().map(|v| curve.at(*v).value).collect();
    params.set_list("fv_velocity", &points).ok()?;
    params.set_list("fv_force", &force).ok()?;
    let numbers = base_numbers(&params)
        .into_iter()
        .map(|mut number| {
            // What was expected of a number beforehand stays; points are others now.
            let is_point = matches!(&number.free, Free::Model(Unknown::Rise { .. }));
            if let Some(known) = from.numbers.iter().find(|n| !is_point && n.free == number.free) {
                (number.prior, number.step) = (known.prior, known.step);
            }
            number
        })
        .collect();
    Some(Hypothesis { base: params, numbers, heating: from.heating.clone() })
}

#[cfg(test)]
mod tests {
    use super::*;
    use dashpot_core::Params;

    #[test]
    fn more_points_are_the_same_curve_to_begin_with() {
        let base = Params::new();
        let from = Hypothesis { base, numbers: base_numbers(&base), heating: None };
        let theta = from.start();
        let to = finer(&from, &theta).unwrap();
        assert_eq!(to.base.list("fv_velocity").len(), 2 * base.list("fv_velocity").len() - 1);
        let [a, b] = [from.params(&theta), to.params(&to.start())].map(|p| Model::new(&p).unwrap());
        let top = a.elements().fv_curve.at(1.0).value;
        for i in -100..=100 {
            let v = 0.01 * f64::from(i);
            let (a, b) = (a.elements().fv_curve.at(v).value, b.elements().fv_curve.at(v).value);
            assert!((a - b).abs() < 0.01 * top, "{v}: {a} {b}");
        }
    }
}
