//! Interpolation between the grid values of a setting.
//!
//! A parameter follows the monotone cubic through its grid values, with Fritsch–Butland derivatives, as the FV curve
//! uses them. The forces of the FV table are interpolated in the same way, point by point. A cubic with the end values
//! f_i, f_{i+1} and end derivatives d_i, d_{i+1} over a grid interval of length h has the Bernstein coefficients
//!
//! ```text
//! f_i,  f_i + h d_i / 3,  f_{i+1} − h d_{i+1} / 3,  f_{i+1}
//! ```
//!
//! and lies between the smallest and the largest of these coefficients. At grid value i, let g_i be the difference of
//! the forces of two neighboring points of the FV table. e_i is its derivative with respect to the setting. h_i is the
//! length of the grid interval after the value i. At every setting, the forces do not decrease with velocity if
//!
//! ```text
//! −3 g_i / h_i  ≤  e_i  ≤  3 g_i / h_{i−1}
//! ```
//!
//! Derivatives that violate this condition are reduced toward zero ([`limit`]). The reduction keeps each force monotone
//! over the setting.

use crate::curve::monotone_derivative;
use crate::math::{max, min};

/// Largest number of values of a grid.
pub const MAX_GRID: usize = 8;

/// Interval of the grid and the weights of its cubic at a setting.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GridPosition {
    /// Index of the grid interval, from 0.
    pub interval: usize,
    /// Weights of the values at both ends of the interval, then of the derivatives there. The weights of the
    /// derivatives include the length of the interval.
    pub weights: [f64; 4],
}

impl GridPosition {
    /// Finds the interval and the weights of a setting, which is clamped to the grid of `count` values.
    #[inline(always)]
    pub fn new(grid: &[f64; MAX_GRID], count: usize, setting: f64) -> GridPosition {
        let mut interval = 0;
        // There are at most eight grid values, so a linear search is sufficient.
        for (place, from) in grid.iter().enumerate().skip(1) {
            interval += usize::from(place + 1 < count && setting >= *from);
        }
        let low = grid[interval & (MAX_GRID - 1)];
        let h = grid[(interval + 1) & (MAX_GRID - 1)] - low;
        let t = (setting - low) / h;
        let t = min(1.0, max(0.0, t));
        let rest = 1.0 - t;
        let weights =
            [rest * rest * (1.0 + 2.0 * t), t * t * (1.0 + 2.0 * rest), h * (t * (rest * rest)), -(h * (t * t * rest))];
        GridPosition { interval, weights }
    }

    /// Interpolates between the values `y` at the grid values, with their derivatives `d` with respect to the setting.
    #[inline(always)]
    pub fn value(&self, y: &[f64; MAX_GRID], d: &[f64; MAX_GRID]) -> f64 {
        let (from, to) = (self.interval & (MAX_GRID - 1), (self.interval + 1) & (MAX_GRID - 1));
        let [w0, w1, w2, w3] = self.weights;
        (w0 * y[from] + w1 * y[to]) + (w2 * d[from] + w3 * d[to])
    }
}

/// Computes the derivatives, with respect to the setting, of a parameter with these `values` at the grid values.
pub fn derivatives(grid: &[f64], values: &[f64]) -> [f64; MAX_GRID] {
    let mut derivatives = [0.0; MAX_GRID];
    for (place, derivative) in derivatives.iter_mut().enumerate().take(grid.len()) {
        *derivative = monotone_derivative(grid, values, place);
    }
    derivatives
}

/// Reduces the derivatives of the FV table's forces with respect to the setting at one grid value. The interpolated
/// forces then do not decrease with velocity.
///
/// `rises` is the force of the next point minus the force of a point, for each point except the last. `before` and
/// `after` are the lengths of the grid intervals on both sides, infinite for a missing interval.
///
/// Positive and negative derivatives are limited separately. Two sweeps over the points find the largest derivatives
/// that do not exceed the given ones. The change of the derivative from a point to the next stays between −3
/// `rises`/`after` and 3 `rises`/`before`. Between points whose derivatives have different signs, each derivative may
/// use half of this range.
pub fn limit(derivatives: &mut [f64], rises: impl Fn(usize) -> f64, before: f64, after: f64) {
    let count = derivatives.len();
    let sign_at = |derivatives: &[f64], point: usize| derivatives.get(point).copied().unwrap_or(0.0);
    // The reduced derivatives still have the signs of the given ones, because no derivative changes its sign.
    for sign in [1.0, -1.0] {
        let room = |derivatives: &[f64], point: usize| {
            let mixed = sign_at(derivatives, point) * sign_at(derivatives, point + 1) < 0.0;
            let part = if mixed { 1.5 } else { 3.0 };
            let within = |length: f64| if length.is_finite() { part * rises(point) / length } else { f64::INFINITY };
            let (up, down) = (within(before), within(after));
            if sign > 0.0 { (up, down) } else { (down, up) }
        };
        let target = |derivatives: &[f64], point: usize| max(sign * sign_at(derivatives, point), 0.0);
        for point in 1..count {
            let (up, _) = room(derivatives, point - 1);
            let most = target(derivatives, point - 1) + up;
            reduce(derivatives, point, sign, most);
        }
        for point in (1..count).rev() {
            let (_, down) = room(derivatives, point - 1);
            let most = target(derivatives, point) + down;
            reduce(derivatives, point - 1, sign, most);
        }
    }
}

/// Limits the derivative at `point` to the magnitude `most` if it has the sign `sign`. A derivative of the opposite
/// sign does not change.
fn reduce(derivatives: &mut [f64], point: usize, sign: f64, most: f64) {
    if let Some(derivative) = derivatives.get_mut(point)
        && sign * *derivative > most
    {
        *derivative = sign * most;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use dashpot_test_support::drawn;
    use proptest::prelude::*;
    use std::vec::Vec;

    const GRID: [f64; MAX_GRID] = [0.0, 0.25, 0.4, 0.8, 1.2, 1.3, 1.6, 2.0];

    fn padded(values: &[f64]) -> [f64; MAX_GRID] {
        core::array::from_fn(|i| values.get(i).copied().unwrap_or(0.0))
    }

    #[test]
    fn a_number_is_exact_on_the_grid_monotone_and_continuous_with_its_derivative() {
        let y = padded(&[10.0, 12.0, 12.0, 40.0, 41.0, 90.0, 30.0, -5.0]);
        for count in 2..=MAX_GRID {
            let d = derivatives(&GRID[..count], &y[..count]);
            let at = |s: f64| GridPosition::new(&GRID, count, s).value(&y, &d);
            for (s, y) in GRID.iter().zip(&y).take(count) {
                assert_eq!(at(*s), *y);
            }
            for i in 0..count - 1 {
                let (low, high) = (y[i].min(y[i + 1]), y[i].max(y[i + 1]));
                let (from, to) = (GRID[i], GRID[i + 1]);
                let mut last = y[i];
                for k in 1..=200 {
                    let value = at(from + (to - from) * f64::from(k) / 200.0);
                    assert!(value >= low - 1e-9 && value <= high + 1e-9);
                    assert!((value - last) * (y[i + 1] - y[i]) >= -1e-9, "falls between {from} and {to}");
                    last = value;
                }
            }
            for s in &GRID[1..count - 1] {
                let e = 1e-7;
                let (left, right) = ((at(*s) - at(s - e)) / e, (at(s + e) - at(*s)) / e);
                // The tolerance covers the change of the derivative over the distance e, which is e times the
                // curvature.
                assert!((left - right).abs() < 1e-2 * (1.0 + left.abs()), "{left} {right} at {s}");
            }
            // Outside the grid the setting is clamped.
            assert_eq!((at(-1.0), at(9.0)), (y[0], y[count - 1]));
        }
    }

    proptest! {
        #![proptest_config(drawn(400))]

        /// Forces that do not decrease with velocity at the grid values do not decrease at any setting between them.
        /// Horizontal and crossing curves are included.
        #[test]
        fn forces_do_not_fall_over_velocity_between_the_grid(
            rises in prop::collection::vec(prop::collection::vec(prop_oneof![Just(0.0), 0.0..1.0f64, 0.0..1e3f64], 8), MAX_GRID),
            starts in prop::collection::vec(-2e3..0.0f64, MAX_GRID),
            count in 2..=MAX_GRID,
        ) {
            let forces: Vec<Vec<f64>> = (0..count)
                .map(|i| rises[i].iter().scan(starts[i], |f, g| { *f += g; Some(*f) }).collect())
                .collect();
            let points = forces[0].len();
            let mut d: Vec<Vec<f64>> = (0..count).map(|_| std::vec![0.0; points]).collect();
            for k in 0..points {
                let y: Vec<f64> = forces.iter().map(|f| f[k]).collect();
                for (i, derivative) in derivatives(&GRID[..count], &y).into_iter().enumerate().take(count) {
                    d[i][k] = derivative;
                }
            }
            let targets = d.clone();
            for (i, d) in d.iter_mut().enumerate() {
                let before = if i > 0 { GRID[i] - GRID[i - 1] } else { f64::INFINITY };
                let after = if i + 1 < count { GRID[i + 1] - GRID[i] } else { f64::INFINITY };
                limit(d, |k| forces[i][k + 1] - forces[i][k], before, after);
                for (reduced, target) in d.iter().zip(&targets[i]) {
                    prop_assert!(reduced * target >= 0.0 && reduced.abs() <= target.abs());
                }
            }
            for step in 0..=400 {
                let s = GRID[0] + (GRID[count - 1] - GRID[0]) * f64::from(step) / 400.0;
                let place = GridPosition::new(&GRID, count, s);
                let at = |k: usize| {
                    let y = padded(&forces.iter().map(|f| f[k]).collect::<Vec<_>>());
                    let d = padded(&d.iter().map(|d| d[k]).collect::<Vec<_>>());
                    place.value(&y, &d)
                };
                for k in 1..points {
                    prop_assert!(at(k) >= at(k - 1) - 1e-9, "falls by {} at {s}", at(k - 1) - at(k));
                }
            }
        }
    }
}
