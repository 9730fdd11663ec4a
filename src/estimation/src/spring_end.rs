//! Detection of a stop that a lookup spring represents. Such a stop appears as a force at the spring's end in excess of
//! the extrapolated middle of the spring curve.

use crate::hypothesis::{Free, Hypothesis};
use crate::unknowns::{CurveName, Unknown, anchor, towards_zero};
use dashpot_core::Params;
use dashpot_core::{element, list};
use dashpot_records::restrict;

/// Fraction of the spring's displacement range that counts as its middle.
const MIDDLE: f64 = 0.5;

/// Computes the slope of the middle of a spring curve, N/m, at least 0. `x` are displacements, m, and `force` forces,
/// N.
fn middle(x: &[f64], force: &[f64]) -> f64 {
    let reach = x.iter().fold(0.0f64, |most, x| most.max(x.abs()));
    let mut inside = x.iter().zip(force).filter(|(x, _)| x.abs() <= MIDDLE * reach);
    match (inside.next(), inside.next_back()) {
        (Some((x0, f0)), Some((x1, f1))) => ((f1 - f0) / (x1 - x0)).max(0.0),
        _ => 0.0,
    }
}

/// Computes the excess force, N, at one end of a spring over the linear extrapolation of the spring's middle. The end
/// is that of rebound (`side` = 1) or compression (−1). The excess is at least 0. It is 0 without a lookup spring of at
/// least three points.
pub fn excess(base: &Params, side: f64) -> f64 {
    let (x, force) = (base.list(list!("spring_displacement")), base.list(list!("spring_force")));
    if !base.is_on(element!("parallel_spring")) || x.len() < 3 {
        return 0.0;
    }
    let end = if side > 0.0 { x.len() - 1 } else { 0 };
    (side * (force[end] - force[anchor(x)]) - middle(x, force) * (x[end] - x[anchor(x)]).abs()).max(0.0)
}

/// Limits the start values of one side of the spring curve, rebound (`side` = 1) or compression (−1), to the linear
/// extrapolation of its middle.
pub fn straighten(to: &mut Hypothesis, side: f64) {
    let (x, force) =
        (to.base.list(list!("spring_displacement")).to_vec(), to.base.list(list!("spring_force")).to_vec());
    if x.len() < 3 {
        return;
    }
    let (zero, slope) = (anchor(&x), middle(&x, &force));
    for number in &mut to.numbers {
        if let Free::Model(Unknown::Rise { curve: CurveName::Spring, point }) = number.free
            && (x[point] - x[zero]) * side > 0.0
        {
            let straight = slope * (x[point] - x[towards_zero(point, zero)]).abs();
            number.start = restrict(number.start.min(straight), number.bounds.0, number.bounds.1);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::hypothesis::number;
    use crate::prior_set::PriorSet;
    use crate::unknowns::Unknowns;

    #[test]
    fn what_goes_beyond_the_middle_is_found_on_its_side_and_taken_out() {
        let mut base = Params::new();
        base.set_list(list!("spring_displacement"), &[-0.05, -0.04, -0.02, 0.0, 0.02, 0.04, 0.05]).unwrap();
        base.set_list(list!("spring_force"), &[-150.0, -60.0, -20.0, 0.0, 20.0, 40.0, 50.0]).unwrap();
        assert!((excess(&base, -1.0) - 100.0).abs() < 1e-9 && excess(&base, 1.0) < 1e-9);
        let rises = Unknowns::rises(&base, CurveName::Spring).into_iter();
        let numbers = rises.map(|rise| number(&base, rise)).collect();
        let mut to = Hypothesis { base, numbers, heating: None, priors: PriorSet::default() };
        straighten(&mut to, -1.0);
        let straight = to.params(&to.start());
        for (x, force) in straight.list(list!("spring_displacement")).iter().zip(straight.list(list!("spring_force"))) {
            assert!((force - 1000.0 * x).abs() < 1e-6, "{x} {force}");
        }
        base.enable(element!("parallel_spring"), false);
        assert_eq!(excess(&base, -1.0), 0.0);
    }
}
