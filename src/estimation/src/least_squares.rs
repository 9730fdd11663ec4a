//! A model identified from segments: what is weighed in a fit, and what is known of the solution.

use super::priors::in_search;
use super::scale::Scale;
use super::segment::Segment;
use super::sensitivity::{Accuracy, Run};
use super::smooth_curve::SmoothCurve;
use super::solve::{self, Bounds, Loss, Options, Prior, Residuals, Slopes};
use super::unknowns::Unknowns;
use nalgebra::{DMatrix, DVector};
use rayon::prelude::*;

/// Weighted residual beyond which a sample counts linearly, not squared.
const HUBER: Loss = Loss::Huber(3.0);

/// How hard to try.
#[derive(Debug, Clone, Copy)]
pub struct Effort {
    /// Most accepted or refused steps.
    pub steps: usize,
    /// Share of the cost that may be left to gain.
    pub tolerance: f64,
    /// How exactly the model is integrated.
    pub accuracy: Accuracy,
}

impl Effort {
    /// To compare variants.
    pub const ROUGH: Effort = Effort { steps: 8, tolerance: 1e-3, accuracy: Accuracy::Cheap };
    /// For the result.
    pub const FINE: Effort = Effort { steps: 60, tolerance: 1e-7, accuracy: Accuracy::Full };
}

/// Where a fit ended.
#[derive(Debug, Clone)]
pub struct Solution {
    /// The unknowns.
    pub theta: Vec<f64>,
    /// Half the sum of the losses, with what leaving the usual costs.
    pub cost: f64,
    /// Whether it ended by itself.
    pub converged: bool,
}

/// The segments of a fit: a block is a segment; one more is what is usual of the shape of the FV curve.
struct Problem<'a> {
    segments: &'a [&'a Segment],
    unknowns: &'a Unknowns,
    accuracy: Accuracy,
    shape: SmoothCurve,
    /// Root of the weight of what is usual.
    held: f64,
}

/// The model at one point, and where that is.
struct At {
    run: Run,
    theta: Vec<f64>,
}

fn residuals(segment: &Segment, forces: &[f64]) -> Vec<f64> {
    (segment.from..segment.force.len()).map(|i| (forces[i] - segment.force[i]) / segment.scale).collect()
}

impl Residuals for Problem<'_> {
    type At = At;

    fn at(&self, theta: &[f64]) -> Option<At> {
        Some(At { run: Run::new(self.unknowns, theta, self.accuracy)?, theta: theta.to_vec() })
    }

    fn blocks(&self) -> usize {
        self.segments.len() + 1
    }

    fn is_measured(&self, block: usize) -> bool {
        block < self.segments.len()
    }

    fn residuals(&self, block: usize, at: &At) -> Option<Vec<f64>> {
        Some(match self.segments.get(block) {
            Some(segment) => residuals(segment, &self.unknowns.forces(&at.run, &at.theta, segment)),
            None => self.shape.rows(&at.theta).into_iter().map(|r| self.held * r).collect(),
        })
    }

    fn jacobian(&self, block: usize, at: &At) -> Option<(Vec<f64>, DMatrix<f64>)> {
        let Some(segment) = self.segments.get(block) else {
            return Some((self.residuals(block, at)?, self.shape.jacobian(&at.theta) * self.held));
        };
        let (forces, rows) = self.unknowns.jacobian(&at.run, &at.theta, segment);
        let scored = rows.columns(segment.from, segment.force.len() - segment.from);
        Some((residuals(segment, &forces), scored.transpose() / segment.scale))
    }
}

/// How much more what is usual weighs than beside samples that are all independent and miss by noise alone: by how many samples stand
/// for an independent one in what is left, which the error of a model's form makes alike all through a test, and by its mean square.
fn held<'a>(residuals: impl Iterator<Item = &'a [f64]>) -> f64 {
    let (mut sum, mut count) = (0.0, 0.0);
    for residual in residuals {
        sum += residual.iter().map(|r| r * r).sum::<f64>().min(MOST_FORM * residual.len() as f64)
            * correlation_factor(residual);
        count += residual.len() as f64;
    }
    if count > 0.0 && f64::is_finite(sum) { (sum / count).max(1.0) } else { 1.0 }
}

/// Mean square, in units of what is allowed, beyond which a misfit says no more: the start was bad, not the form.
const MOST_FORM: f64 = 30.0;
/// Damping of the first step: a start is near where the fit before it ended.
const DAMPING: f64 = 1e-3;
/// Times that the weight of what is usual is looked at again, from where the fit before ended, and the factor within which it has settled.
const AGAIN: usize = 2;
const SETTLED: f64 = 1.5;

/// Minimises from `start`.
pub fn solve(segments: &[&Segment], unknowns: &Unknowns, start: &[f64], effort: Effort) -> Solution {
    let (low, high) = unknowns.bounds();
    let bounds = Bounds { low, high };
    let scale = Scale::of(&unknowns.base);
    let of_the_rig = unknowns.rig.iter().map(|number| Some(number.usual));
    let usual: Vec<Option<(f64, f64)>> =
        unknowns.list.iter().map(|unknown| in_search(unknown, scale)).chain(of_the_rig).collect();
    let mut problem =
        Problem { segments, unknowns, accuracy: effort.accuracy, shape: SmoothCurve::new(unknowns), held: 1.0 };
    let at_start = |problem: &Problem| -> Option<Vec<Vec<f64>>> {
        let at = problem.at(start)?;
        (0..segments.len()).into_par_iter().map(|block| problem.residuals(block, &at)).collect()
    };
    let lost = Solution { theta: start.to_vec(), cost: f64::INFINITY, converged: false };
    let Some(first) = at_start(&problem) else { return lost };
    let mut weight = held(first.iter().map(Vec::as_slice));
    let mut from = start.to_vec();
    let mut found = None;
    for _ in 0..=AGAIN {
        problem.held = weight.sqrt();
        let spread = |(mean, spread)| Prior { mean, spread: spread / problem.held };
        let options = Options {
            steps: effort.steps,
            tolerance: effort.tolerance,
            loss: HUBER,
            priors: usual.iter().map(|u| u.map(spread)).collect(),
            slopes: Slopes::Fresh,
            damping: DAMPING,
            quiet: 1,
        };
        let ended = solve::solve(&problem, &from, &bounds, &options);
        let after = held(ended.rows.iter().take(segments.len()).map(|rows| rows.residual.as_slice()));
        from.clone_from(&ended.x);
        let settled = after.max(weight) < SETTLED * after.min(weight);
        weight = after;
        found = Some(ended);
        if settled {
            break;
        }
    }
    let Some(found) = found.filter(|found| found.cost.is_finite()) else { return lost };
    // Costs of different fits are compared without what is usual weighing more, since that differs.
    let off = |(u, t): (&Option<(f64, f64)>, &f64)| u.map_or(0.0, |(mean, spread)| 0.5 * ((t - mean) / spread).powi(2));
    let unusual: f64 = usual.iter().zip(&found.x).map(off).sum::<f64>()
        + problem.shape.rows(&found.x).iter().map(|r| 0.5 * r * r).sum::<f64>();
    let fitted = |rows: &solve::Rows| rows.residual.iter().map(|r| HUBER.of(*r).0).sum::<f64>();
    let cost = found.rows.iter().take(segments.len()).map(fitted).sum::<f64>() + unusual;
    Solution { theta: found.x, cost, converged: found.converged }
}

/// Share of the full information that stays when a test is left out which alone determines a parameter: without it
/// the prediction of that test would be arbitrary.
const RIDGE: f64 = 1e-3;

/// Mean square of each test's weighted residual as predicted from all other tests: the refit without the test is
/// linearised about the common solution (exact for linear least squares; Cook & Weisberg, *Residuals and Influence in
/// Regression*, 1982), so one pass serves all tests.
pub fn left_out_errors(segments: &[&Segment], unknowns: &Unknowns, theta: &[f64]) -> Vec<f64> {
    let Some(run) = Run::new(unknowns, theta, Accuracy::Cheap) else { return vec![f64::INFINITY; segments.len()] };
    let parts: Vec<(DMatrix<f64>, DVector<f64>)> = segments
        .par_iter()
        .map(|segment| {
            let (forces, rows) = unknowns.jacobian(&run, theta, segment);
            let count = segment.force.len() - segment.from;
            let rows = rows.columns(segment.from, count) / segment.scale;
            let residual = DVector::from_fn(count, |k, _| {
                (forces[segment.from + k] - segment.force[segment.from + k]) / segment.scale
            });
            (rows, residual)
        })
        .collect();
    let n = theta.len();
    let mut hessian = DMatrix::zeros(n, n);
    let own: Vec<DMatrix<f64>> = parts.par_iter().map(|(rows, _)| rows * rows.transpose()).collect();
    for part in &own {
        hessian += part;
    }
    parts
        .par_iter()
        .zip(&own)
        .map(|((rows, residual), own)| {
            let mut others = &hessian - own;
            for i in 0..n {
                others[(i, i)] += RIDGE * hessian[(i, i)] + 1e-300;
            }
            let moved = others.cholesky().map(|c| c.solve(&(rows * residual)));
            let predicted = match moved {
                Some(moved) => residual + rows.transpose() * moved,
                None => residual.clone(),
            };
            predicted.norm_squared() / predicted.len().max(1) as f64
        })
        .collect()
}

/// Covariance of the unknowns at a solution: the sandwich form, with the noise of every test taken from its own
/// residual and its samples discounted for their correlation, so that model error widens the intervals too.
///
/// Returns the covariance and, for each unknown, how well it is determined apart from all others (1: fully, 0: not).
pub fn covariance(
    segments: &[&Segment],
    unknowns: &Unknowns,
    theta: &[f64],
    accuracy: Accuracy,
) -> Option<(DMatrix<f64>, Vec<f64>)> {
    let run = Run::new(unknowns, theta, accuracy)?;
    let n = theta.len();
    let parts: Vec<(DMatrix<f64>, f64)> = segments
        .par_iter()
        .map(|segment| {
            let (forces, rows) = unknowns.jacobian(&run, theta, segment);
            let count = segment.force.len() - segment.from;
            let residual: Vec<f64> =
                (segment.from..segment.force.len()).map(|i| (forces[i] - segment.force[i]) / segment.scale).collect();
            let variance = residual.iter().map(|r| r * r).sum::<f64>() / count.max(1) as f64;
            let scored = rows.columns(segment.from, count) / segment.scale;
            (&scored * scored.transpose(), variance * correlation_factor(&residual))
        })
        .collect();
    let mut hessian = DMatrix::zeros(n, n);
    let mut meat = DMatrix::zeros(n, n);
    for (part, variance) in &parts {
        hessian += part;
        meat += part * *variance;
    }
    let scale: Vec<f64> = (0..n).map(|i| hessian[(i, i)].sqrt().max(1e-150)).collect();
    let scaled = DMatrix::from_fn(n, n, |i, j| hessian[(i, j)] / (scale[i] * scale[j]));
    let eigen = scaled.symmetric_eigen();
    let largest = eigen.eigenvalues.amax();
    // Directions that the data does not see at all are cut off here and named by the caller.
    let inverse_values = eigen.eigenvalues.map(|v| if v > 1e-12 * largest { 1.0 / v } else { 1e12 / largest });
    let vectors = &eigen.eigenvectors;
    let inverse = vectors * DMatrix::from_diagonal(&inverse_values) * vectors.transpose();
    let determined = (0..n).map(|i| 1.0 / inverse[(i, i)].max(1.0)).collect();
    let bread = DMatrix::from_fn(n, n, |i, j| inverse[(i, j)] / (scale[i] * scale[j]));
    Some((&bread * meat * &bread, determined))
}

/// How many samples stand for one independent sample: the sum of the residual's autocorrelation up to where it first
/// falls below noise (Geyer's initial positive sequence, Stat. Sci. 7, 1992).
fn correlation_factor(residual: &[f64]) -> f64 {
    let n = residual.len();
    let variance: f64 = residual.iter().map(|r| r * r).sum();
    if n < 8 || variance <= 0.0 {
        return 1.0;
    }
    let lag = |k: usize| (0..n - k).map(|i| residual[i] * residual[i + k]).sum::<f64>() / variance;
    let mut sum = 1.0;
    let noise = 2.0 / (n as f64).sqrt();
    for k in 1..n / 2 {
        let r = lag(k);
        if r < noise {
            break;
        }
        sum += 2.0 * r;
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::unknowns::{CurveName, Unknown};
    use dashpot_core::number;
    use dashpot_core::parameter::Element;
    use dashpot_core::{Input, Params};

    /// Sines on a damper of a curve and gas, each with an error of its own that no model has.
    fn campaign() -> (Vec<Segment>, Unknowns) {
        let mut base = Params::new();
        base.disable_all();
        for element in ["fv_curve", "gas_preload"] {
            base.enable(Element::find(element).unwrap(), true);
        }
        let mut list = Unknowns::rises(&base, CurveName::Fv);
        list.push(Unknown::Linear(number!("gas_force")));
        let unknowns = Unknowns { base, list, rig: Vec::new() };
        let run = Run::new(&unknowns, &unknowns.start(), Accuracy::Full).unwrap();
        let segments = (0..12)
            .map(|k| {
                let (amplitude, omega) = (0.004 * (1.0 + f64::from(k % 4)), 6.0 * (1.0 + f64::from(k / 4)).powi(2));
                let n = 200;
                let at = |i: usize| std::f64::consts::TAU * i as f64 / n as f64;
                let mut segment = Segment {
                    name: format!("{k}"),
                    dt: vec![std::f64::consts::TAU / omega / n as f64; n],
                    input: (0..n)
                        .map(|i| Input::motion(amplitude * libm::sin(at(i)), amplitude * omega * libm::cos(at(i))))
                        .collect(),
                    force: vec![0.0; n],
                    from: 20,
                    scale: 5.0,
                    top: 1000.0,
                    peak_velocity: amplitude * omega,
                    amplitude,
                    clock: 0.0,
                };
                let off = 6.0 * libm::sin(f64::from(k) * 2.4);
                segment.force = run.forces(&segment);
                segment.force.iter_mut().enumerate().for_each(|(i, f)| *f += off + 3.0 * libm::sin(7.1 * i as f64));
                segment
            })
            .collect();
        (segments, unknowns)
    }

    #[test]
    fn a_test_left_out_is_predicted_as_by_a_fit_without_it() {
        let (segments, unknowns) = campaign();
        let all: Vec<&Segment> = segments.iter().collect();
        let common = solve(&all, &unknowns, &unknowns.start(), Effort::FINE);
        let errors = left_out_errors(&all, &unknowns, &common.theta);
        // The last test alone reaches the fastest point of the curve; without it that point would be arbitrary, and is held instead.
        for (k, error) in errors.iter().enumerate().take(11) {
            let others: Vec<&Segment> = segments.iter().enumerate().filter(|(i, _)| *i != k).map(|(_, s)| s).collect();
            let without = solve(&others, &unknowns, &common.theta, Effort::FINE).theta;
            let run = Run::new(&unknowns, &without, Accuracy::Full).unwrap();
            let residual = residuals(&segments[k], &run.forces(&segments[k]));
            let wanted = residual.iter().map(|r| r * r).sum::<f64>() / residual.len() as f64;
            // What is usual of a curve's shape weighs in a fit, most at its ends, and nothing in the pass.
            assert!((0.66..1.5).contains(&(error / wanted)), "{k}: {error}, {wanted}");
        }
    }

    #[test]
    fn samples_that_are_alike_count_as_one() {
        let mut state = 88_172_645_463_325_252u64;
        let noise: Vec<f64> = std::iter::repeat_with(|| {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            (state >> 11) as f64 / (1u64 << 53) as f64 - 0.5
        })
        .take(400)
        .collect();
        let slow: Vec<f64> = (0..400).map(|i| libm::sin(f64::from(i) * 0.03)).collect();
        assert!(correlation_factor(&noise) < 2.0, "{}", correlation_factor(&noise));
        assert!(correlation_factor(&slow) > 20.0);
        assert!(held([noise.as_slice()].into_iter()) < 2.0);
        let loud: Vec<f64> = slow.iter().map(|r| 3.0 * r).collect();
        assert!(held([loud.as_slice()].into_iter()) > 4.0 * held([slow.as_slice()].into_iter()));
    }

    #[test]
    fn the_covariance_is_that_of_repeated_campaigns() {
        let (segments, unknowns) = campaign();
        let place = unknowns.list.len() - 1;
        let all: Vec<&Segment> = segments.iter().collect();
        let common = solve(&all, &unknowns, &unknowns.start(), Effort::FINE);
        let (covariance, determined) = covariance(&all, &unknowns, &common.theta, Accuracy::Full).unwrap();
        assert!(determined[place] > 0.05, "{determined:?}");
        // The same campaigns, with the tests' own errors the other way round or dealt anew.
        let fits: Vec<f64> = (1..=24)
            .map(|seed| {
                let mut other = segments.clone();
                for (k, segment) in other.iter_mut().enumerate() {
                    let old = 6.0 * libm::sin(k as f64 * 2.4);
                    let new = 6.0 * libm::sin((k as f64 + 1.0) * f64::from(seed) * 2.4);
                    segment.force.iter_mut().for_each(|f| *f += new - old);
                }
                solve(&other.iter().collect::<Vec<_>>(), &unknowns, &common.theta, Effort::FINE).theta[place]
            })
            .collect();
        let mean = fits.iter().sum::<f64>() / fits.len() as f64;
        let spread = (fits.iter().map(|f| (f - mean).powi(2)).sum::<f64>() / (fits.len() - 1) as f64).sqrt();
        let told = covariance[(place, place)].sqrt();
        assert!((0.5..2.0).contains(&(told / spread)), "{told} told, {spread} seen");
    }
}
