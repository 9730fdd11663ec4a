//! Force-velocity curve with the smallest weighted error on the tests.
//!
//! The points lie at the peak velocities of the tests, and at creep speeds where slow tests show the friction step. Additional points
//! divide wide gaps. The kernel's monotone curve interpolates between the points, and a constant gas force is added. Least squares over all
//! samples, weighted by the force scale of each test, determine the forces. Among curves with these velocities and at least a small minimum
//! slope, this one has the smallest weighted root mean square error.
//!
//! Vehicle models use such a curve today. Every fit, report and validation compares the identified model with this curve.

use super::law::options;
use super::observation::{Observation, SampledMotion};
use dashpot_core::Params;
use dashpot_core::curve::{Curve, Interpolation, MAX_POINTS, NEAREST};
use dashpot_core::{element, list, number};
use dashpot_estimation::solve::{Bounds, Loss, Options, Residuals, solve};
use serde::{Deserialize, Serialize};

/// Parameters of the force-velocity curve.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct FvCurve {
    /// Velocities of the points, m/s, increasing. Zero is one of them.
    pub velocity_m_s: Vec<f64>,
    /// Forces at the points without the gas force, N. The force at zero velocity is zero.
    pub force_n: Vec<f64>,
    /// Gas force, which pushes the rod out, N.
    pub gas_force_n: f64,
}

/// Speeds of points below the smallest peak velocity, m/s. At these speeds, slow tests show the friction force around zero velocity.
const CREEPING: [f64; 4] = [3e-4, 1e-3, 2.5e-3, 5e-3];
/// Largest ratio of a point's speed to the next lower speed. A knee of a curve extends over about this ratio, so additional points divide a
/// wider gap.
const WIDEST: f64 = 1.65;
/// Ratio of two speeds below which they are merged to one point.
const SAME: f64 = 1.25;
/// Speed, m/s, above which additional points divide wide gaps. At lower speeds, only slow tests determine the curve.
const SMALLEST: f64 = 0.010;
/// Smallest slope of the curve, relative to the range of measured force divided by the range of velocity.
///
/// If friction decreases with speed, the best monotone curve has a horizontal section. This small slope changes the force in such a section
/// by less than a newton, and the curve stays invertible.
const LEAST_SLOPE: f64 = 0.1;
/// Smallest number of samples between a point and the next point toward zero. With fewer samples, the point is left out. If it is the
/// outermost point, the next point toward zero is left out instead.
const ENOUGH: usize = 12;
/// Width of the averaging bins: a fraction of their speed, and a minimum in m/s.
///
/// The bins are far narrower than any feature of a curve. Averaging over them makes the computation time of the least squares independent
/// of the number of tests.
const BIN: (f64, f64) = (0.01, 2e-5);

/// Samples averaged over a narrow range of velocity.
struct Bin {
    velocity: f64,
    force: f64,
    /// Sum of the samples' weights.
    weight: f64,
}

fn bins(tests: &[Observation]) -> Vec<Bin> {
    let mut samples: Vec<(f64, f64, f64)> = tests
        .iter()
        .flat_map(|t| {
            (t.from..t.force.len()).map(move |i| (t.motion.velocity[i], t.force[i], 1.0 / (t.scale * t.scale)))
        })
        .collect();
    samples.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut bins: Vec<Bin> = Vec::new();
    let mut begin = f64::NEG_INFINITY;
    for (v, f, w) in samples {
        match bins.last_mut() {
            Some(bin) if v - begin <= (BIN.0 * v.abs()).max(BIN.1) => {
                bin.weight += w;
                bin.velocity += w / bin.weight * (v - bin.velocity);
                bin.force += w / bin.weight * (f - bin.force);
            }
            _ => {
                begin = v;
                bins.push(Bin { velocity: v, force: f, weight: w });
            }
        }
    }
    bins
}

/// Returns the speeds of the points for one sign of velocity, m/s, increasing.
fn speeds(tests: &[Observation], sign: f64) -> Vec<f64> {
    let of = |t: &Observation| -> Vec<f64> { t.motion.velocity[t.from..].iter().map(|v| sign * v).collect() };
    let mut all: Vec<f64> = tests.iter().flat_map(of).filter(|v| *v > 0.0).collect();
    all.sort_by(f64::total_cmp);
    // The last point lies at the fourth highest speed, because the highest may be a single noisy peak.
    let Some(top) = all.get(all.len().saturating_sub(4)).copied() else { return Vec::new() };
    let mut peaks: Vec<f64> =
        tests.iter().map(|t| of(t).into_iter().fold(0.0, f64::max)).filter(|v| *v > 0.0 && *v < top / SAME).collect();
    // Keep the creep speeds below the peak velocity of a slow test, which passes them slowly. Fast tests pass them only at their reversals,
    // which does not suffice.
    let slow = peaks.iter().copied().filter(|v| *v < SMALLEST).fold(0.0, f64::max);
    peaks.extend(CREEPING.iter().copied().filter(|v| *v < slow));
    peaks.push(top);
    peaks.retain(|v| *v > 2.0 * NEAREST);
    peaks.sort_by(f64::total_cmp);
    let mut points: Vec<f64> = Vec::new();
    for v in peaks {
        match points.last_mut() {
            // The kernel rejects points that are closer together than `NEAREST`.
            Some(last) if v < (SAME * *last).max(*last + 2.0 * NEAREST) => *last = if v == top { v } else { *last },
            _ => points.push(v),
        }
    }
    // Add a point below the first point of the fast tests. Otherwise, the curve below that first point would be a single straight line.
    let first_fast = points.partition_point(|v| *v < SMALLEST);
    if points.get(first_fast).is_some_and(|v| *v > SAME * SMALLEST) {
        points.insert(first_fast, SMALLEST);
    }
    let mut divided: Vec<f64> = Vec::new();
    for v in points {
        if let Some(last) = divided.last().copied()
            && last >= SMALLEST
        {
            let parts = (libm::log(v / last) / libm::log(WIDEST)).ceil().max(1.0);
            divided.extend((1..parts as usize).map(|k| last * libm::pow(v / last, k as f64 / parts)));
        }
        divided.push(v);
    }
    let mut kept: Vec<f64> = Vec::new();
    for (k, v) in divided.iter().enumerate() {
        let below = kept.last().copied().unwrap_or(0.0);
        let count = all.partition_point(|s| s <= v) - all.partition_point(|s| *s <= below);
        if count >= ENOUGH {
            kept.push(*v);
        } else if k + 1 == divided.len() {
            // There are too few samples between the last two points. Keep the last point instead of the other, because it bounds the range
            // of the samples.
            kept.pop();
            kept.push(*v);
        }
    }
    // Remove every second inner point until the points of both sides fit into the kernel's list.
    while kept.len() > (MAX_POINTS - 1) / 2 {
        let last = kept.len() - 1;
        kept = kept.iter().enumerate().filter(|(k, _)| k % 2 == 0 || *k == last).map(|(_, v)| *v).collect();
    }
    kept
}

/// Returns the index of the point at zero velocity.
fn zero(velocity: &[f64]) -> usize {
    velocity.partition_point(|v| *v < 0.0)
}

struct CurveProblem<'a> {
    bins: &'a [Bin],
    velocity: &'a [f64],
    /// Force, N, by which the unknowns of the least squares are multiplied.
    unit: f64,
}

impl CurveProblem<'_> {
    /// Returns the forces at the points and the gas force, N. Each unknown is the rise of a point above its neighbor on the side of zero.
    /// The last unknown is the gas force.
    fn curve(&self, x: &[f64]) -> (Vec<f64>, f64) {
        let zero = zero(self.velocity);
        let mut force = vec![0.0; self.velocity.len()];
        for k in zero + 1..force.len() {
            force[k] = force[k - 1] + self.unit * x[k - 1];
        }
        for k in (0..zero).rev() {
            force[k] = force[k + 1] - self.unit * x[k];
        }
        (force, self.unit * x[self.velocity.len() - 1])
    }
}

impl Residuals for CurveProblem<'_> {
    type At = Vec<f64>;

    fn prepare(&self, x: &[f64]) -> Option<Vec<f64>> {
        Some(x.to_vec())
    }

    fn residuals(&self, _: usize, x: &Vec<f64>) -> Option<Vec<f64>> {
        let (force, gas) = self.curve(x);
        let curve = Curve::new(self.velocity, &force, Interpolation::MonotoneCubic).ok()?;
        Some(self.bins.iter().map(|b| b.weight.sqrt() * (curve.evaluate(b.velocity).value - gas - b.force)).collect())
    }
}

/// Identifies the curve from tests.
pub fn fit(tests: &[Observation]) -> FvCurve {
    let bins = bins(tests);
    let mut velocity: Vec<f64> = speeds(tests, -1.0).into_iter().rev().map(|v| -v).collect();
    velocity.push(0.0);
    velocity.extend(speeds(tests, 1.0));
    if velocity.len() < 2 {
        // Without motion there are no speeds, so use any two velocities.
        velocity = vec![-1.0, 0.0];
    }
    let unit = bins.iter().map(|b| b.force.abs()).fold(1e-3, f64::max);
    let problem = CurveProblem { bins: &bins, velocity: &velocity, unit };
    let n = velocity.len();
    // Start from a straight line, because the least-squares problem of a monotone curve has a single minimum.
    let reach = velocity[n - 1] - velocity[0];
    let mut start: Vec<f64> = velocity.windows(2).map(|w| (w[1] - w[0]) / reach).collect();
    start.push(0.0);
    let range = bins.iter().map(|b| b.force).fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), f| (l.min(f), h.max(f)));
    let slope = LEAST_SLOPE * ((range.1 - range.0) / reach).max(0.0) / unit;
    let mut low: Vec<f64> = velocity.windows(2).map(|w| slope * (w[1] - w[0])).collect();
    low.push(-10.0);
    let bounds = Bounds { low, high: vec![10.0; n] };
    let options = Options { loss: Loss::Squares, tolerance: 1e-9, ..options() };
    let found = solve(&problem, &start, &bounds, &options);
    let (force_n, gas_force_n) = problem.curve(&found.x);
    FvCurve { velocity_m_s: velocity, force_n, gas_force_n }
}

impl FvCurve {
    /// Returns the force of the curve at every sample of a motion, N.
    pub fn forces(&self, motion: &SampledMotion) -> Vec<f64> {
        match Curve::new(&self.velocity_m_s, &self.force_n, Interpolation::MonotoneCubic) {
            Ok(curve) => motion.velocity.iter().map(|v| curve.evaluate(*v).value - self.gas_force_n).collect(),
            Err(_) => vec![f64::NAN; motion.velocity.len()],
        }
    }

    /// Converts the curve to a parameter set of the kernel.
    pub fn params(&self) -> Params {
        let mut params = Params::new();
        params.disable_all();
        params.enable(element!("fv_curve"), true);
        params.enable(element!("gas_preload"), true);
        let _ = params.set_list(list!("fv_velocity"), &self.velocity_m_s);
        let _ = params.set_list(list!("fv_force"), &self.force_n);
        let gas = number!("gas_force");
        let _ = params.set(gas, gas.inside(self.gas_force_n));
        params
    }
}
