//! How a monotone-cubic curve moves when one of its points moves: the derivatives that its fit needs.

use dashpot_core::curve::monotone_derivative;

/// A curve through points, with the derivative of each point's slope over the neighbouring points' forces.
#[derive(Debug, Clone)]
pub struct CurveWeights {
    u: Vec<f64>,
    /// ∂(slope at i)/∂(f at i−1, i, i+1).
    slope_by: Vec<[f64; 3]>,
}

impl CurveWeights {
    /// Prepares the derivatives of the curve through (`u`, `f`).
    pub fn new(u: &[f64], f: &[f64]) -> CurveWeights {
        let n = u.len();
        let slope_by = (0..n)
            .map(|i| {
                if i == 0 || i + 1 == n {
                    let (a, b) = if i == 0 { (0, 1) } else { (n - 2, n - 1) };
                    let per = 1.0 / (u[b] - u[a]);
                    return if i == 0 { [0.0, -per, per] } else { [-per, per, 0.0] };
                }
                let (h0, h1) = (u[i] - u[i - 1], u[i + 1] - u[i]);
                let (d0, d1) = ((f[i] - f[i - 1]) / h0, (f[i + 1] - f[i]) / h1);
                if d0 * d1 <= 0.0 {
                    return [0.0; 3];
                }
                let (w0, w1) = (2.0 * h1 + h0, h1 + 2.0 * h0);
                let m = monotone_derivative(u, f, i);
                // m = W / (w0/d0 + w1/d1): ∂m/∂d0 = m² w0 / (W d0²).
                let by = |w: f64, d: f64| m * m * w / ((w0 + w1) * d * d);
                let (by0, by1) = (by(w0, d0), by(w1, d1));
                [-by0 / h0, by0 / h0 - by1 / h1, by1 / h1]
            })
            .collect();
        CurveWeights { u: u.to_vec(), slope_by }
    }

    /// Number of points.
    pub fn points(&self) -> usize {
        self.u.len()
    }

    /// ∂f(at)/∂(force of point j): the first point it names and the derivatives for four points from there.
    pub fn evaluate(&self, at: f64) -> (usize, [f64; 4]) {
        let n = self.u.len();
        let right = self.u.partition_point(|u| *u <= at);
        let mut weights = [0.0; 4];
        if right == 0 || right == n {
            let end = if right == 0 { 0 } else { n - 1 };
            let first = end.saturating_sub(1).min(n.saturating_sub(4));
            weights[end - first] += 1.0;
            self.add_slope(end, at - self.u[end], first, &mut weights);
            return (first, weights);
        }
        let left = right - 1;
        let first = left.saturating_sub(1).min(n.saturating_sub(4));
        let h = self.u[right] - self.u[left];
        let t = (at - self.u[left]) / h;
        let (t2, t3) = (t * t, t * t * t);
        weights[left - first] += 2.0 * t3 - 3.0 * t2 + 1.0;
        weights[right - first] += 3.0 * t2 - 2.0 * t3;
        self.add_slope(left, h * (t3 - 2.0 * t2 + t), first, &mut weights);
        self.add_slope(right, h * (t3 - t2), first, &mut weights);
        (first, weights)
    }

    fn add_slope(&self, point: usize, factor: f64, first: usize, weights: &mut [f64; 4]) {
        for (k, by) in self.slope_by[point].iter().enumerate() {
            if *by != 0.0 {
                weights[point + k - 1 - first] += factor * by;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use dashpot_core::curve::{Curve, Interpolation};

    #[test]
    fn weights_are_the_derivatives_over_the_points() {
        let u = [-1.0, -0.4, -0.1, 0.0, 0.05, 0.3, 1.1];
        let f = [-900.0, -500.0, -300.0, 0.0, 250.0, 700.0, 1900.0];
        let weights = CurveWeights::new(&u, &f);
        for at in [-1.7, -0.9, -0.2, -0.03, 0.02, 0.2, 0.9, 1.6] {
            let (first, w) = weights.evaluate(at);
            for j in 0..u.len() {
                let moved = |d: f64| {
                    let mut g = f;
                    g[j] += d;
                    Curve::new(&u, &g, Interpolation::MonotoneCubic).unwrap().evaluate(at).value
                };
                let difference = (moved(0.01) - moved(-0.01)) / 0.02;
                let got = if (first..first + 4).contains(&j) { w[j - first] } else { 0.0 };
                assert!((got - difference).abs() < 1e-6, "at {at}, point {j}: {got} {difference}");
            }
        }
    }
}
