//! Polynomial in velocity, followed by a first-order lag.
//!
//! Jonnalagadda & Vyas compare this model with their own (*Modelling of Automotive Suspension Damper*, KTH 2020, chapter 2). The equations
//! of the model are `T(|v|) dy/dt + y = Σ a_k v^k` and F = y. They contain the velocity v, the force F, the state y, the coefficients a_k
//! and the time constant T. Here the time constant changes over a ramp from low to high speed, because a jump makes the model unstable.

use super::law::{self, Law, Number};
use super::observation::{Observation, SampledMotion, Scales};
use dashpot_core::Params;
use dashpot_core::{element, list, number};
use nalgebra::{DMatrix, DVector};
use serde::{Deserialize, Serialize};

/// Parameters of the polynomial with lag.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct LaggedPolynomial {
    /// Coefficients a_0, a_1, ... of the polynomial; a_k is in N (s/m)^k.
    pub coefficients: Vec<f64>,
    /// Time constant at low speed, s.
    pub lag_slow_s: f64,
    /// Time constant at high speed, s.
    pub lag_fast_s: f64,
    /// Speeds between which the time constant changes, m/s.
    pub ramp_m_s: [f64; 2],
}

/// Largest degree of the polynomial, from Jonnalagadda & Vyas.
const DEGREE: usize = 7;
/// Speeds at which the ramp of the time constant begins and ends, as fractions of the highest speed of the tests.
const RAMP: [f64; 2] = [0.03, 0.3];
/// Number of substeps for each shortest time constant in a sampling interval.
const PARTS: f64 = 2.0;
/// Largest number of substeps in a sampling interval. An interval that needs more substeps is much longer than the time constants. The
/// force then reaches the value of the polynomial within the interval.
const MOST_PARTS: f64 = 16.0;
/// Bound on the coefficients of a polynomial of degree 7, in units of the largest force divided by a power of the highest velocity.
///
/// The largest coefficient of the Chebyshev polynomial of degree 7 is 112.
const LARGEST: f64 = 120.0;

/// Returns the largest number of coefficients of the polynomial whose values stay within the kernel's range. If all tests are slow, the
/// coefficients of high powers become very large.
fn most_terms(s: &Scales) -> usize {
    let (_, high) = list!("polynomial").bounds();
    (2..=DEGREE + 1).rev().find(|n| LARGEST * s.force / s.velocity.powi(*n as i32 - 1) <= high).unwrap_or(2)
}

/// Returns the number of coefficients with which the polynomial, without the lag, predicts left-out tests best. A polynomial of high degree
/// would fit the tests and diverge beyond them. With fewer than three tests, returns the largest number.
fn terms(tests: &[Observation]) -> usize {
    let s = Scales::from_tests(tests);
    let most = most_terms(&s);
    if tests.len() < 3 {
        return most;
    }
    let sums: Vec<(DMatrix<f64>, DVector<f64>, f64)> = tests
        .iter()
        .map(|t| {
            let count = t.force.len() - t.from;
            let row = |r: usize, c: usize| (t.motion.velocity[t.from + r] / s.velocity).powi(c as i32) / t.scale;
            let rows = DMatrix::from_fn(count, most, row);
            let target = DVector::from_fn(count, |r, _| t.force[t.from + r] / t.scale);
            (rows.tr_mul(&rows), rows.tr_mul(&target), target.norm_squared())
        })
        .collect();
    let missed = |n: usize| -> f64 {
        (0..sums.len())
            .map(|out| {
                let (mut square, mut right) = (DMatrix::<f64>::zeros(n, n), DVector::<f64>::zeros(n));
                for (_, (a, b, _)) in sums.iter().enumerate().filter(|(k, _)| *k != out) {
                    square += a.view((0, 0), (n, n));
                    right += b.rows(0, n);
                }
                let ridge = 1e-12 * square.trace();
                let (own, own_right, force) = (sums[out].0.view((0, 0), (n, n)), sums[out].1.rows(0, n), sums[out].2);
                match (square + DMatrix::identity(n, n) * ridge).cholesky().map(|c| c.solve(&right)) {
                    Some(c) => force - 2.0 * own_right.dot(&c) + c.dot(&(own * &c)),
                    None => f64::INFINITY,
                }
            })
            .sum()
    };
    (2..=most).min_by(|a, b| missed(*a).total_cmp(&missed(*b))).unwrap_or(2)
}

/// Polynomial with lag and N coefficients.
struct WithTerms<const N: usize>(LaggedPolynomial);

/// Identifies the model from tests. Returns `None` if no start gives finite forces.
pub fn fit(tests: &[Observation]) -> Option<LaggedPolynomial> {
    match terms(tests) {
        2 => law::fit::<WithTerms<2>>(tests).map(|f| f.0),
        3 => law::fit::<WithTerms<3>>(tests).map(|f| f.0),
        4 => law::fit::<WithTerms<4>>(tests).map(|f| f.0),
        5 => law::fit::<WithTerms<5>>(tests).map(|f| f.0),
        6 => law::fit::<WithTerms<6>>(tests).map(|f| f.0),
        7 => law::fit::<WithTerms<7>>(tests).map(|f| f.0),
        _ => law::fit::<WithTerms<8>>(tests).map(|f| f.0),
    }
}

impl LaggedPolynomial {
    fn polynomial(&self, v: f64) -> f64 {
        self.coefficients.iter().rev().fold(0.0, |sum, a| sum * v + a)
    }

    fn time_constant(&self, v: f64) -> f64 {
        let [v1, v2] = self.ramp_m_s;
        let share = ((v.abs() - v1) / (v2 - v1)).clamp(0.0, 1.0);
        self.lag_slow_s + (self.lag_fast_s - self.lag_slow_s) * share
    }

    /// Converts the model to a parameter set of the kernel, which contains this model as an element.
    pub fn params(&self) -> Params {
        let mut params = Params::new();
        params.disable_all();
        params.enable(element!("lagged_polynomial"), true);
        let _ = params.set_list(list!("polynomial"), &self.coefficients);
        for (number, value) in [
            (number!("lag_slow"), self.lag_slow_s),
            (number!("lag_fast"), self.lag_fast_s),
            (number!("lag_v1"), self.ramp_m_s[0]),
            (number!("lag_v2"), self.ramp_m_s[1]),
        ] {
            let _ = params.set(number, number.inside(value));
        }
        params
    }
}

impl<const N: usize> Law for WithTerms<N> {
    fn numbers(s: &Scales) -> Vec<Number> {
        let (_, high) = list!("polynomial").bounds();
        let coefficient = |k: usize| Number::Linear { typical: s.force / s.velocity.powi(k as i32), low: -high, high };
        let mut numbers: Vec<Number> = (0..N).map(coefficient).collect();
        numbers.extend([Number::Log { low: 1e-5, high: 1.0 }; 2]);
        numbers
    }

    fn starts(_: &Scales) -> Vec<Vec<f64>> {
        [[2e-4, 1e-4], [4e-3, 1e-3], [2e-2, 2e-3], [1e-1, 1e-2]]
            .map(|lags| {
                let mut start = vec![0.0; N];
                start.extend(lags);
                start
            })
            .to_vec()
    }

    fn from_numbers(n: &[f64], s: &Scales) -> Self {
        WithTerms(LaggedPolynomial {
            coefficients: n[..N].to_vec(),
            lag_slow_s: n[N],
            lag_fast_s: n[N + 1],
            ramp_m_s: RAMP.map(|share| share * s.velocity.max(1e-3)),
        })
    }

    fn forces(&self, motion: &SampledMotion) -> Vec<f64> {
        self.0.forces(motion)
    }
}

impl LaggedPolynomial {
    /// Returns the force of the model at every sample of a motion, N.
    pub fn forces(&self, motion: &SampledMotion) -> Vec<f64> {
        let v = &motion.velocity;
        motion.run(self.polynomial(v[0]), |y, i| {
            if i > 0 && motion.dt[i] > 0.0 {
                // A substep is exact for a polynomial value that changes linearly during the substep. So the substeps must be short
                // compared with the time constant.
                let shortest = self.lag_slow_s.min(self.lag_fast_s);
                let parts = (PARTS * motion.dt[i] / shortest).ceil().clamp(1.0, MOST_PARTS);
                let h = motion.dt[i] / parts;
                let at = |k: usize| v[i - 1] + (v[i] - v[i - 1]) * k as f64 / parts;
                for k in 0..parts as usize {
                    let (p0, p1) = (self.polynomial(at(k)), self.polynomial(at(k + 1)));
                    let lag = self.time_constant(0.5 * (at(k) + at(k + 1)));
                    let behind = (p1 - p0) / h * lag;
                    *y = p1 - behind + (*y - p0 + behind) * libm::exp(-h / lag);
                }
            }
            *y
        })
    }
}
