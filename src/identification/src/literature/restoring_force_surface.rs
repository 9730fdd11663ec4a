//! Restoring-force surface.
//!
//! S. F. Masri, T. K. Caughey, *A nonparametric identification technique for nonlinear dynamic problems*, J. Appl. Mech. 46, 1979. The
//! force is a double series of Chebyshev polynomials over displacement and velocity, both scaled to −1..1 with the ranges of the tests.
//!
//! The force is linear in the coefficients. The degrees in displacement and in velocity are those with the best prediction of left-out
//! tests. Beyond the ranges of the tests the surface is constant, because a polynomial would diverge.

use super::observation::{Observation, SampledMotion, range};
use nalgebra::{DMatrix, DVector};
use serde::{Deserialize, Serialize};

/// Parameters of the surface.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Surface {
    /// Range of displacement, m.
    pub displacement_m: [f64; 2],
    /// Range of velocity, m/s.
    pub velocity_m_s: [f64; 2],
    /// Coefficients of T_i(x) T_j(v), N, with one row for each degree i in the scaled displacement x. T_i is the Chebyshev polynomial of
    /// degree i, and v the scaled velocity.
    pub coefficients_n: Vec<Vec<f64>>,
}

/// Highest tried degree in displacement.
const MOST_X: usize = 5;
/// Highest tried degree in velocity.
const MOST_V: usize = 11;
/// Increase of the diagonal of the normal equations, relative to the mean of the diagonal. It keeps the surface flat for combinations of
/// displacement and velocity without tests.
const RIDGE: f64 = 1e-5;

/// Computes the Chebyshev polynomials T_0 to T_n of a value that is scaled from `low`..`high` to −1..1 and clamped.
fn chebyshev(value: f64, [low, high]: [f64; 2], n: usize) -> Vec<f64> {
    let u = ((2.0 * value - low - high) / (high - low).max(1e-12)).clamp(-1.0, 1.0);
    let mut t = vec![1.0, u];
    for k in 2..=n {
        t.push(2.0 * u * t[k - 1] - t[k - 2]);
    }
    t.truncate(n + 1);
    t
}

/// Normal equations of one test: weighted sums of products of the basis functions and the force.
struct Sums {
    square: DMatrix<f64>,
    right: DVector<f64>,
    force: f64,
}

fn solve(square: &DMatrix<f64>, right: &DVector<f64>) -> Option<DVector<f64>> {
    let n = square.nrows();
    let ridge = RIDGE * square.trace() / n as f64;
    (square + DMatrix::identity(n, n) * ridge).cholesky().map(|c| c.solve(right))
}

/// Identifies the surface from tests. Returns `None` if the normal equations of the surface cannot be solved.
pub fn fit(tests: &[Observation]) -> Option<Surface> {
    let all = |of: fn(&SampledMotion) -> &Vec<f64>| -> [f64; 2] {
        let values: Vec<f64> = tests.iter().flat_map(|t| of(&t.motion)[t.from..].iter().copied()).collect();
        let (low, high) = range(&values);
        [low, high]
    };
    let (displacement_m, velocity_m_s) = (all(|m| &m.displacement), all(|m| &m.velocity));
    let width = MOST_V + 1;
    let size = (MOST_X + 1) * width;
    let sums: Vec<Sums> = tests
        .iter()
        .map(|test| {
            let mut sums = Sums { square: DMatrix::zeros(size, size), right: DVector::zeros(size), force: 0.0 };
            let count = test.force.len() - test.from;
            let mut rows = DMatrix::zeros(count, size);
            let mut target = DVector::zeros(count);
            for r in 0..count {
                let i = test.from + r;
                let x = chebyshev(test.motion.displacement[i], displacement_m, MOST_X);
                let v = chebyshev(test.motion.velocity[i], velocity_m_s, MOST_V);
                for (a, x) in x.iter().enumerate() {
                    for (b, v) in v.iter().enumerate() {
                        rows[(r, a * width + b)] = x * v / test.scale;
                    }
                }
                target[r] = test.force[i] / test.scale;
            }
            sums.square = rows.tr_mul(&rows);
            sums.right = rows.tr_mul(&target);
            sums.force = target.norm_squared();
            sums
        })
        .collect();
    let total = Sums {
        square: sums.iter().fold(DMatrix::zeros(size, size), |s, t| s + &t.square),
        right: sums.iter().fold(DVector::zeros(size), |s, t| s + &t.right),
        force: sums.iter().map(|t| t.force).sum(),
    };
    let chosen =
        |nx: usize, nv: usize| -> Vec<usize> { (0..size).filter(|k| k / width <= nx && k % width <= nv).collect() };
    let part = |from: &Sums, of: &[usize]| (from.square.select_rows(of).select_columns(of), from.right.select_rows(of));
    let mut best: Option<(f64, usize, usize)> = None;
    for nx in 0..=MOST_X {
        for nv in (1..=MOST_V).step_by(2) {
            let of = chosen(nx, nv);
            let (square, right) = part(&total, &of);
            let missed: f64 = if sums.len() < 3 {
                // There are too few tests to leave one out, so use fixed degrees.
                if (nx, nv) == (1, 5) { 0.0 } else { f64::INFINITY }
            } else {
                sums.iter()
                    .map(|test| {
                        let (own, own_right) = part(test, &of);
                        match solve(&(&square - &own), &(&right - &own_right)) {
                            // Sum the logarithms of the squared errors, so that a single test beyond the range of the other tests does not
                            // dominate.
                            Some(c) => {
                                libm::log((test.force - 2.0 * own_right.dot(&c) + c.dot(&(&own * &c))).max(1e-9))
                            }
                            None => f64::INFINITY,
                        }
                    })
                    .sum()
            };
            if missed.is_finite() && best.is_none_or(|b| missed < b.0) {
                best = Some((missed, nx, nv));
            }
        }
    }
    let (_, nx, nv) = best?;
    let of = chosen(nx, nv);
    let (square, right) = part(&total, &of);
    let c = solve(&square, &right)?;
    let coefficients_n = (0..=nx).map(|a| (0..=nv).map(|b| c[a * (nv + 1) + b]).collect()).collect();
    Some(Surface { displacement_m, velocity_m_s, coefficients_n })
}

impl Surface {
    /// Returns the force of the surface at every sample of a motion, N.
    pub fn forces(&self, motion: &SampledMotion) -> Vec<f64> {
        let nx = self.coefficients_n.len().saturating_sub(1);
        let nv = self.coefficients_n.first().map_or(0, |row| row.len().saturating_sub(1));
        motion
            .displacement
            .iter()
            .zip(&motion.velocity)
            .map(|(x, v)| {
                let (x, v) = (chebyshev(*x, self.displacement_m, nx), chebyshev(*v, self.velocity_m_s, nv));
                let row = |row: &Vec<f64>| row.iter().zip(&v).map(|(c, v)| c * v).sum::<f64>();
                self.coefficients_n.iter().zip(&x).map(|(c, x)| x * row(c)).sum()
            })
            .collect()
    }
}
