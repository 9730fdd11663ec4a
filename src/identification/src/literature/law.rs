//! Least-squares identification of models that consist of a formula: their parameters, starts and residuals.

use super::observation::{Observation, SampledMotion, Scales};
use dashpot_estimation::solve::{Bounds, Loss, Options, Residuals, solve_from};
use dashpot_records::restrict;
use nalgebra::{DMatrix, DVector};
use rayon::prelude::*;

/// Kind and range of one parameter of a model.
#[derive(Debug, Clone, Copy)]
pub enum Number {
    /// A parameter to which the force is proportional if all other linear parameters are zero. Linear least squares find it at each start.
    Linear {
        /// Typical magnitude, which scales the parameter.
        typical: f64,
        /// Lowest value.
        low: f64,
        /// Highest value.
        high: f64,
    },
    /// A positive parameter over several decades, identified on a logarithmic scale.
    Log {
        /// Lowest value.
        low: f64,
        /// Highest value.
        high: f64,
    },
    /// A parameter that is neither linear nor logarithmic.
    Plain {
        /// Typical magnitude, which scales the parameter.
        typical: f64,
        /// Lowest value.
        low: f64,
        /// Highest value.
        high: f64,
    },
}

impl Number {
    /// Makes a linear parameter of either sign.
    pub fn linear(typical: f64) -> Number {
        Number::Linear { typical, low: f64::NEG_INFINITY, high: f64::INFINITY }
    }

    /// Makes a nonnegative linear parameter.
    pub fn positive(typical: f64) -> Number {
        Number::Linear { typical, low: 0.0, high: f64::INFINITY }
    }

    fn inner(self, value: f64) -> f64 {
        match self {
            Number::Log { low, high } => libm::log(restrict(value, low, high)),
            Number::Linear { typical, low, high } | Number::Plain { typical, low, high } => {
                restrict(value, low, high) / typical
            }
        }
    }

    fn outer(self, value: f64) -> f64 {
        match self {
            Number::Log { .. } => libm::exp(value),
            Number::Linear { typical, .. } | Number::Plain { typical, .. } => value * typical,
        }
    }

    fn bounds(self) -> (f64, f64) {
        match self {
            Number::Log { low, high } => (libm::log(low), libm::log(high)),
            Number::Linear { typical, low, high } | Number::Plain { typical, low, high } => {
                (low / typical, high / typical)
            }
        }
    }
}

/// Model that consists of a formula with a few parameters.
pub trait Law: Sized + Send + Sync + 'static {
    /// Returns the parameters, in the order of [`Law::from_numbers`].
    fn numbers(scales: &Scales) -> Vec<Number>;

    /// Returns start values of all parameters, each set with another physical interpretation of the tests. Linear least squares replace the
    /// values of linear parameters.
    fn starts(scales: &Scales) -> Vec<Vec<f64>>;

    /// Makes the model with the parameters `numbers`, which have the order of [`Law::numbers`].
    fn from_numbers(numbers: &[f64], scales: &Scales) -> Self;

    /// Returns the force of the model at every sample of a motion, N.
    fn forces(&self, motion: &SampledMotion) -> Vec<f64>;
}

/// Weighted residual above which the Huber loss grows linearly instead of quadratically. The value is large, because a poor model has large
/// residuals that are not outliers.
const HUBER: f64 = 30.0;
/// Number of starts that are iterated to convergence: those with the lowest cost after the fit of their linear parameters.
const FOLLOWED: usize = 3;
/// Increase of the diagonal of the normal equations, relative to the diagonal. It keeps the linear parameters of a start finite if the
/// tests do not determine them.
const RIDGE: f64 = 1e-10;

/// Returns the least-squares options that all models of the literature share.
pub fn options() -> Options {
    Options { steps: 100, tolerance: 1e-6, loss: Loss::Huber(HUBER), ..Options::default() }
}

/// Function that returns the force of a law with its parameters at every sample of a motion, N.
type Forces = Box<dyn Fn(&SampledMotion) -> Vec<f64> + Send + Sync>;

/// Least-squares problem of one law. All laws share this code, which is compiled once.
struct LawProblem<'a> {
    tests: &'a [Observation],
    numbers: &'a [Number],
    make: &'a (dyn Fn(&[f64]) -> Forces + Sync),
}

impl LawProblem<'_> {
    fn outer(&self, inner: &[f64]) -> Vec<f64> {
        self.numbers.iter().zip(inner).map(|(n, x)| n.outer(*x)).collect()
    }

    fn law(&self, inner: &[f64]) -> Forces {
        (self.make)(&self.outer(inner))
    }
}

impl Residuals for LawProblem<'_> {
    type At = Forces;

    fn prepare(&self, x: &[f64]) -> Option<Forces> {
        Some(self.law(x))
    }

    fn blocks(&self) -> usize {
        self.tests.len()
    }

    fn residuals(&self, block: usize, forces: &Forces) -> Option<Vec<f64>> {
        let test = &self.tests[block];
        let forces = forces(&test.motion);
        Some((test.from..test.force.len()).map(|i| (forces[i] - test.force[i]) / test.scale).collect())
    }
}

/// Returns a start, in scaled coordinates, with the least-squares values of its linear parameters.
fn with_linear(problem: &LawProblem<'_>, start: &[f64]) -> Vec<f64> {
    let linear: Vec<usize> =
        (0..start.len()).filter(|i| matches!(problem.numbers[*i], Number::Linear { .. })).collect();
    let mut inner: Vec<f64> = problem.numbers.iter().zip(start).map(|(n, v)| n.inner(*v)).collect();
    if linear.is_empty() {
        return inner;
    }
    for i in &linear {
        inner[*i] = 0.0;
    }
    let k = linear.len();
    let (mut square, mut right) = (DMatrix::<f64>::zeros(k, k), DVector::<f64>::zeros(k));
    for test in problem.tests {
        let columns: Vec<Vec<f64>> = linear
            .iter()
            .map(|i| {
                let mut one = inner.clone();
                one[*i] = 1.0;
                problem.law(&one)(&test.motion)
            })
            .collect();
        let matrix = DMatrix::from_fn(test.force.len() - test.from, k, |r, c| columns[c][test.from + r] / test.scale);
        let target = DVector::from_iterator(
            test.force.len() - test.from,
            test.force[test.from..].iter().map(|f| f / test.scale),
        );
        square += matrix.tr_mul(&matrix);
        right += matrix.tr_mul(&target);
    }
    for i in 0..k {
        square[(i, i)] += RIDGE * square[(i, i)] + 1e-30;
    }
    if let Some(solved) = square.cholesky().map(|c| c.solve(&right)) {
        for (c, i) in linear.iter().enumerate() {
            let (low, high) = problem.numbers[*i].bounds();
            inner[*i] = restrict(solved[c], low, high);
        }
    }
    inner
}

/// Identifies a law from several starts. Returns `None` if no start gives finite forces.
pub fn fit<L: Law>(tests: &[Observation]) -> Option<L> {
    fit_from(tests, &[])
}

/// Identifies a law from the starts of the law and from `further` starts. Returns `None` if no start gives finite forces.
///
/// The further starts are always iterated to convergence, without a fit of their linear parameters.
pub fn fit_from<L: Law>(tests: &[Observation], further: &[Vec<f64>]) -> Option<L> {
    let scales = Scales::from_tests(tests);
    let numbers = L::numbers(&scales);
    let make = |numbers: &[f64]| -> Forces {
        let law = L::from_numbers(numbers, &scales);
        Box::new(move |motion| law.forces(motion))
    };
    let problem = LawProblem { tests, numbers: &numbers, make: &make };
    Some(L::from_numbers(&best(&problem, &L::starts(&scales), further)?, &scales))
}

/// Returns the parameters with the lowest cost that the least squares find from several starts. Returns `None` if no cost is finite.
fn best(problem: &LawProblem<'_>, starts: &[Vec<f64>], further: &[Vec<f64>]) -> Option<Vec<f64>> {
    let (low, high) = problem.numbers.iter().map(|n| n.bounds()).unzip();
    let bounds = Bounds { low, high };
    let mut starts: Vec<(f64, Vec<f64>)> = starts
        .par_iter()
        .map(|start| {
            let inner = with_linear(problem, start);
            let law = problem.law(&inner);
            let squares: f64 = (0..problem.tests.len())
                .filter_map(|block| problem.residuals(block, &law))
                .flatten()
                .map(|r| r * r)
                .sum();
            (if squares.is_finite() { squares } else { f64::INFINITY }, inner)
        })
        .collect();
    starts.sort_by(|a, b| a.0.total_cmp(&b.0));
    let as_given = |start: &Vec<f64>| problem.numbers.iter().zip(start).map(|(n, v)| n.inner(*v)).collect::<Vec<f64>>();
    let starts: Vec<Vec<f64>> =
        starts.into_iter().take(FOLLOWED).map(|s| s.1).chain(further.iter().map(as_given)).collect();
    let found = solve_from(problem, &starts, &bounds, &options())?;
    found.cost.is_finite().then(|| problem.outer(&found.x))
}
