//! Small feed-forward neural network.
//!
//! The model is a black box after A. Patel, J. Dunne, *NARX neural network modelling of hydraulic suspension dampers for steady-state and
//! variable temperature operation*, Vehicle System Dynamics 40, 2003. Jonnalagadda & Vyas review it (*Modelling of Automotive Suspension
//! Damper*, KTH 2020, chapter 2).
//!
//! The network has one hidden tanh layer over displacement, velocity and acceleration. The original also feeds back the measured force,
//! which does not exist in a vehicle model. Levenberg-Marquardt with exact derivatives and weight decay trains the network from fixed
//! starts. Thus, equal tests give equal networks.

use super::law::options;
use super::observation::{Observation, SampledMotion, Scales};
use dashpot_estimation::solve::{Bounds, Options, Prior, Residuals, solve_from};
use nalgebra::DMatrix;
use serde::{Deserialize, Serialize};

/// Weights and scales of the network.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Network {
    /// Subtracted offset of the displacement, m.
    pub middle_m: f64,
    /// Divisors of displacement, velocity and acceleration, m, m/s and m/s².
    pub input_scale: [f64; 3],
    /// Factor on the output, N.
    pub output_scale_n: f64,
    /// Weights of each hidden neuron: its bias, its weights of displacement, velocity and acceleration, and the weight of its output in the
    /// force.
    pub neurons: Vec<[f64; 5]>,
    /// Bias of the output.
    pub bias: f64,
    /// Weights that connect displacement, velocity and acceleration directly to the output.
    pub feedthrough: [f64; 3],
}

/// Number of hidden neurons.
const NEURONS: usize = 8;
/// Number of fixed starts.
const STARTS: u64 = 4;
/// Prior standard deviation of the weights, for scaled inputs. It makes steps improbable that are steeper than those of any damper. The
/// velocity weights have ten times this deviation.
const DECAY: f64 = 3.0;
/// Approximate largest number of samples that train the network. If the tests have more scored samples, every k-th one is used, because
/// neighboring samples are redundant.
const SAMPLES: usize = 6000;
const SIZE: usize = 5 * NEURONS + 4;

/// Computes the acceleration at the samples by central differences of velocity, m/s².
fn acceleration(motion: &SampledMotion) -> Vec<f64> {
    let (v, dt) = (&motion.velocity, &motion.dt);
    let n = v.len();
    (0..n)
        .map(|i| {
            let (a, b) = (i.saturating_sub(1), (i + 1).min(n - 1));
            let span: f64 = dt[a + 1..=b].iter().sum();
            if span > 0.0 { (v[b] - v[a]) / span } else { 0.0 }
        })
        .collect()
}

struct NetworkProblem<'a> {
    tests: &'a [Observation],
    /// Scaled inputs, and measured forces in N, at the training samples of every test.
    samples: Vec<Vec<([f64; 3], f64)>>,
    output: f64,
}

/// Computes the scaled output of the network from its weights `w` and the scaled inputs `u`. If `by` is given, stores the derivatives of
/// the output with respect to the weights in it.
fn output(w: &[f64], u: &[f64; 3], mut by: Option<&mut [f64; SIZE]>) -> f64 {
    let tail = &w[5 * NEURONS..];
    let mut sum = tail[0] + tail[1] * u[0] + tail[2] * u[1] + tail[3] * u[2];
    if let Some(by) = by.as_deref_mut() {
        by[5 * NEURONS..].copy_from_slice(&[1.0, u[0], u[1], u[2]]);
    }
    for k in 0..NEURONS {
        let n = &w[5 * k..5 * k + 5];
        let h = libm::tanh(n[0] + n[1] * u[0] + n[2] * u[1] + n[3] * u[2]);
        sum += n[4] * h;
        if let Some(by) = by.as_deref_mut() {
            let inner = n[4] * (1.0 - h * h);
            by[5 * k..5 * k + 5].copy_from_slice(&[inner, inner * u[0], inner * u[1], inner * u[2], h]);
        }
    }
    sum
}

impl Residuals for NetworkProblem<'_> {
    type At = Vec<f64>;

    fn prepare(&self, x: &[f64]) -> Option<Vec<f64>> {
        Some(x.to_vec())
    }

    fn blocks(&self) -> usize {
        self.tests.len()
    }

    fn residuals(&self, block: usize, x: &Vec<f64>) -> Option<Vec<f64>> {
        let test = &self.tests[block];
        let residual = |(u, f): &([f64; 3], f64)| (self.output * output(x, u, None) - f) / test.scale;
        Some(self.samples[block].iter().map(residual).collect())
    }

    fn jacobian(&self, block: usize, x: &Vec<f64>) -> Option<DMatrix<f64>> {
        let test = &self.tests[block];
        let mut jacobian = DMatrix::zeros(self.samples[block].len(), SIZE);
        let mut by = [0.0; SIZE];
        for (r, (u, _)) in self.samples[block].iter().enumerate() {
            output(x, u, Some(&mut by));
            for (c, by) in by.iter().enumerate() {
                jacobian[(r, c)] = by * self.output / test.scale;
            }
        }
        Some(jacobian)
    }
}

/// Returns a generator of numbers that are uniform over −1..1 and equal in every run. It is a linear congruential generator with Knuth's
/// constants.
fn spread(seed: u64) -> impl FnMut() -> f64 {
    let mut state = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15);
    move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }
}

/// Trains the network on tests. Returns `None` if the cost is not finite.
pub fn fit(tests: &[Observation]) -> Option<Network> {
    let scales = Scales::from_tests(tests);
    let accelerations: Vec<Vec<f64>> = tests.iter().map(|t| acceleration(&t.motion)).collect();
    let fastest =
        tests.iter().zip(&accelerations).flat_map(|(t, a)| a[t.from..].iter()).fold(1e-6f64, |m, a| m.max(a.abs()));
    let mut network = Network {
        middle_m: scales.middle,
        input_scale: [scales.displacement, scales.velocity, fastest],
        output_scale_n: scales.force,
        neurons: Vec::new(),
        bias: 0.0,
        feedthrough: [0.0; 3],
    };
    let scored: usize = tests.iter().map(|t| t.force.len() - t.from).sum();
    let stride = scored.div_ceil(SAMPLES);
    let samples = |(t, a): (&Observation, &Vec<f64>)| -> Vec<([f64; 3], f64)> {
        let inputs = network.inputs(&t.motion, a);
        inputs.into_iter().zip(t.force.iter().copied()).skip(t.from).step_by(stride).collect()
    };
    let samples = tests.iter().zip(&accelerations).map(samples).collect();
    let problem = NetworkProblem { tests, samples, output: scales.force };
    let starts: Vec<Vec<f64>> = (1..=STARTS)
        .map(|seed| {
            let mut next = spread(seed);
            let mut start = Vec::with_capacity(SIZE);
            for _ in 0..NEURONS {
                // Each neuron starts as a steep or gentle step at some velocity. The step also depends on displacement and acceleration.
                let steep = libm::pow(10f64, 0.75 * (1.0 + next()));
                start.extend([steep * 0.5 * next(), next(), steep, next(), 0.1 * next()]);
            }
            start.extend([0.0; 4]);
            start
        })
        .collect();
    let mut priors = vec![Some(Prior { mean: 0.0, spread: DECAY }); SIZE];
    // The velocity weights have a ten times wider prior, because friction makes the force depend steeply on velocity.
    for k in 0..NEURONS {
        priors[5 * k + 2] = Some(Prior { mean: 0.0, spread: 10.0 * DECAY });
    }
    let options = Options { priors, ..options() };
    let found = solve_from(&problem, &starts, &Bounds::none(SIZE), &options)?;
    if !found.cost.is_finite() {
        return None;
    }
    let w = &found.x;
    network.neurons =
        (0..NEURONS).map(|k| [w[5 * k], w[5 * k + 1], w[5 * k + 2], w[5 * k + 3], w[5 * k + 4]]).collect();
    network.bias = w[5 * NEURONS];
    network.feedthrough = [w[5 * NEURONS + 1], w[5 * NEURONS + 2], w[5 * NEURONS + 3]];
    Some(network)
}

impl Network {
    fn inputs(&self, motion: &SampledMotion, acceleration: &[f64]) -> Vec<[f64; 3]> {
        let [x, v, a] = self.input_scale;
        (0..motion.dt.len())
            .map(|i| [(motion.displacement[i] - self.middle_m) / x, motion.velocity[i] / v, acceleration[i] / a])
            .collect()
    }

    /// Returns the force of the network at every sample of a motion, N.
    pub fn forces(&self, motion: &SampledMotion) -> Vec<f64> {
        self.inputs(motion, &acceleration(motion))
            .iter()
            .map(|u| {
                let neuron = |n: &[f64; 5]| n[4] * libm::tanh(n[0] + n[1] * u[0] + n[2] * u[1] + n[3] * u[2]);
                let straight: f64 = self.feedthrough.iter().zip(u).map(|(w, u)| w * u).sum();
                self.output_scale_n * (self.bias + straight + self.neurons.iter().map(neuron).sum::<f64>())
            })
            .collect()
    }
}
