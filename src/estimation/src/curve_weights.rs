//! Derivatives of a curve with respect to the forces at its points, which a fit of the curve requires.

use crate::unknowns::CurveName;
use dashpot_core::Params;
use dashpot_core::curve::{Interpolation, monotone_derivative};
use dashpot_core::elements::fv_curve::fv_interpolation;

/// A curve through points, with the derivatives of its slopes with respect to the forces at the points.
#[derive(Debug, Clone)]
pub struct CurveWeights {
    u: Vec<f64>,
    /// Derivatives of the slope before and the slope after each point i with respect to the forces at the points i−2 to
    /// i+2.
    slope_by: Vec<[[f64; REACH]; 2]>,
}

/// Largest number of points that affect the slope of the curve at a point: the point and two points on each side.
const REACH: usize = 5;
/// Largest number of points that affect the value of the curve at one abscissa. With [`Interpolation::CubicEachSide`],
/// the slope at zero depends on two neighbors, both on the side of the evaluated piece.
const POINTS: usize = 4;
/// Index of the point itself among the [`REACH`] points that affect its slope.
const OWN: usize = 2;

impl CurveWeights {
    /// Computes the derivatives of the curve through (`u`, `f`) with respect to the forces `f`, for an `interpolation`
    /// between the points.
    pub fn new(u: &[f64], f: &[f64], interpolation: Interpolation) -> CurveWeights {
        let n = u.len();
        let line = |a: usize, b: usize, at: usize| {
            let per = 1.0 / (u[b] - u[a]);
            let mut by = [0.0; REACH];
            by[OWN + a - at] -= per;
            by[OWN + b - at] += per;
            by
        };
        let one_sided = |at: usize, near: usize, far: Option<usize>| {
            let chord = |a: usize, b: usize| (f[b] - f[a]) / (u[b] - u[a]);
            let mut by = line(at.min(near), at.max(near), at);
            let Some(far) = far else { return by };
            let share = (u[near] - u[at]) / (u[far] - u[at]);
            let (d0, d1) = (chord(at, near), chord(near, far));
            if d0 + (d0 - d1) * share < 0.0 {
                return [0.0; REACH];
            }
            let outer = line(near.min(far), near.max(far), at);
            for (by, outer) in by.iter_mut().zip(outer) {
                *by = *by * (1.0 + share) - outer * share;
            }
            by
        };
        let slope_by = (0..n)
            .map(|i| {
                if i == 0 || i + 1 == n {
                    return [if i == 0 { line(0, 1, i) } else { line(n - 2, n - 1, i) }; 2];
                }
                match interpolation {
                    Interpolation::Linear => return [line(i - 1, i, i), line(i, i + 1, i)],
                    Interpolation::CubicEachSide if u[i] == 0.0 => {
                        let far = Some(i + 2).filter(|far| *far < n);
                        return [one_sided(i, i - 1, i.checked_sub(2)), one_sided(i, i + 1, far)];
                    }
                    Interpolation::MonotoneCubic | Interpolation::CubicEachSide => {}
                }
                let (h0, h1) = (u[i] - u[i - 1], u[i + 1] - u[i]);
                let (d0, d1) = ((f[i] - f[i - 1]) / h0, (f[i + 1] - f[i]) / h1);
                if d0 * d1 <= 0.0 {
                    return [[0.0; REACH]; 2];
                }
                let (w0, w1) = (2.0 * h1 + h0, h1 + 2.0 * h0);
                let m = monotone_derivative(u, f, i);
                // The slope is m = W / (w0/d0 + w1/d1). The adjacent chords have the slopes d0 and d1 and the weights w0
                // and w1, and W = w0 + w1. Therefore, ∂m/∂d0 = m² w0 / (W d0²).
                let by = |w: f64, d: f64| m * m * w / ((w0 + w1) * d * d);
                let (by0, by1) = (by(w0, d0), by(w1, d1));
                [[0.0, -by0 / h0, by0 / h0 - by1 / h1, by1 / h1, 0.0]; 2]
            })
            .collect();
        CurveWeights { u: u.to_vec(), slope_by }
    }

    /// Computes the derivatives of a curve of a parameter set.
    pub fn from_params(params: &Params, curve: CurveName) -> CurveWeights {
        let interpolation = match curve {
            CurveName::Fv => fv_interpolation(params),
            CurveName::Spring => Interpolation::MonotoneCubic,
        };
        CurveWeights::new(params.list(curve.abscissae()), params.list(curve.forces()), interpolation)
    }

    /// Returns the number of points of the curve.
    pub fn points(&self) -> usize {
        self.u.len()
    }

    /// Computes the derivatives of the curve's value at `at` with respect to the forces of four adjacent points.
    /// Returns the index of the first of these points, and the four derivatives.
    pub fn evaluate(&self, at: f64) -> (usize, [f64; POINTS]) {
        let n = self.u.len();
        let right = self.u.partition_point(|u| *u <= at);
        let mut weights = [0.0; POINTS];
        let first_for = |left: usize| left.saturating_sub(1).min(n.saturating_sub(POINTS));
        if right == 0 || right == n {
            let end = if right == 0 { 0 } else { n - 1 };
            let first = first_for(end);
            weights[end - first] += 1.0;
            self.add_slope(end, usize::from(right > 0), at - self.u[end], first, &mut weights);
            return (first, weights);
        }
        let left = right - 1;
        let first = first_for(left);
        let h = self.u[right] - self.u[left];
        let t = (at - self.u[left]) / h;
        let (t2, t3) = (t * t, t * t * t);
        weights[left - first] += 2.0 * t3 - 3.0 * t2 + 1.0;
        weights[right - first] += 3.0 * t2 - 2.0 * t3;
        self.add_slope(left, 1, h * (t3 - 2.0 * t2 + t), first, &mut weights);
        self.add_slope(right, 0, h * (t3 - t2), first, &mut weights);
        (first, weights)
    }

    /// Adds `factor` times the derivatives of the slope before (`side` 0) or after (`side` 1) a point. The sum is in
    /// `weights`, the derivatives of the curve's value with respect to the forces from the point `first`.
    fn add_slope(&self, point: usize, side: usize, factor: f64, first: usize, weights: &mut [f64; POINTS]) {
        for (k, by) in self.slope_by[point][side].iter().enumerate() {
            if *by != 0.0 {
                weights[point + k - OWN - first] += factor * by;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use dashpot_core::curve::Curve;

    /// Compares the derivatives of [`CurveWeights::evaluate`] with finite differences of the curve itself.
    fn compare(u: &[f64], f: &[f64], interpolation: Interpolation) {
        let weights = CurveWeights::new(u, f, interpolation);
        for at in [-1.7, -0.9, -0.2, -0.03, 0.02, 0.2, 0.9, 1.6] {
            let (first, w) = weights.evaluate(at);
            for j in 0..u.len() {
                let moved = |d: f64| {
                    let mut g = f.to_vec();
                    g[j] += d;
                    Curve::new(u, &g, interpolation).unwrap().evaluate(at).value
                };
                let difference = (moved(0.01) - moved(-0.01)) / 0.02;
                let got = j.checked_sub(first).and_then(|k| w.get(k)).copied().unwrap_or(0.0);
                assert!((got - difference).abs() < 1e-6, "{interpolation:?} at {at}, point {j}: {got} {difference}");
            }
        }
    }

    #[test]
    fn weights_are_the_derivatives_over_the_points() {
        let u = [-1.0, -0.4, -0.1, 0.0, 0.05, 0.3, 1.1];
        let f = [-900.0, -500.0, -300.0, 0.0, 250.0, 700.0, 1900.0];
        // The rebound side begins almost flat. The parabola through the first three points of this side would have a
        // negative derivative at zero.
        let level = [-900.0, -500.0, -300.0, 0.0, 2.0, 700.0, 1900.0];
        for interpolation in [Interpolation::MonotoneCubic, Interpolation::CubicEachSide, Interpolation::Linear] {
            compare(&u, &f, interpolation);
            compare(&u, &level, interpolation);
            // Curves with only one point on a side, and with few points in total.
            compare(&u[2..], &f[2..], interpolation);
            compare(&u[2..5], &f[2..5], interpolation);
        }
    }
}
