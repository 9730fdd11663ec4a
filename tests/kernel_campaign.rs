//! Synthetic campaigns of dampers with known parameters. The kernel simulates them with steps shorter than the sample
//! interval.

use dashpot_core::number;
use dashpot_core::parameter::Element;
use dashpot_core::{Input, Model, Params, State, evaluate, step};
use dashpot_records::{Noise, Record};
use std::f64::consts::TAU;

/// Random number generator xorshift64*. It is part of the project, so that the data do not change with the version of a
/// library.
pub struct Random(u64);

impl Random {
    /// Initializes the generator from a seed.
    pub fn new(seed: u64) -> Random {
        let mut random = Random(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1);
        (0..20).for_each(|_| {
            random.uniform();
        });
        random
    }

    /// Draws a uniform number in 0..1.
    pub fn uniform(&mut self) -> f64 {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        (self.0.wrapping_mul(0x2545_F491_4F6C_DD1D) >> 11) as f64 / (1u64 << 53) as f64
    }

    /// Draws a normally distributed number with mean 0 and standard deviation 1.
    pub fn normal(&mut self) -> f64 {
        (-2.0 * (1.0 - self.uniform()).ln()).sqrt() * (TAU * self.uniform()).cos()
    }
}

/// Returns sine tests with amplitudes of 1 to 50 mm and peak velocities of 0.052 to 1.57 m/s. Tests above 25.1 Hz are
/// omitted, because rigs reach about 25 Hz.
pub fn strokes_and_speeds() -> Vec<Sine> {
    let mut tests = Vec::new();
    for amplitude in [0.05, 0.025, 0.01, 0.005, 0.002, 0.001] {
        for peak in [0.052, 0.13, 0.26, 0.52, 1.05, 1.57] {
            let frequency = peak / (TAU * amplitude);
            if frequency <= 25.1 {
                tests.push(Sine::new(amplitude, frequency));
            }
        }
    }
    tests
}

/// Makes the reference model: FV curve, series compliance, dry friction, a linear spring and gas.
///
/// # Panics
/// Never, because the kernel defines the names.
pub fn base() -> Params {
    let mut params = Params::new();
    params.disable_all();
    for name in ["fv_curve", "series_compliance", "parallel_spring", "coulomb_friction", "gas_preload"] {
        params.enable(Element::find(name).unwrap(), true);
    }
    params.set(number!("spring_quadratic"), 0.0).unwrap();
    params.set(number!("spring_linear"), 800.0).unwrap();
    params
}

/// A sine test.
#[derive(Debug, Clone, Copy)]
pub struct Sine {
    /// Amplitude, m.
    pub amplitude: f64,
    /// Frequency, Hz.
    pub frequency: f64,
    /// Mean displacement, m.
    pub mean: f64,
    /// Side force, N; `None` if the record has no channel of side force.
    pub side_force: Option<f64>,
}

impl Sine {
    /// Makes a test about zero displacement, without side force. `amplitude` is in m, `frequency` in Hz.
    pub fn new(amplitude: f64, frequency: f64) -> Sine {
        Sine { amplitude, frequency, mean: 0.0, side_force: None }
    }
}

/// Number of whole cycles of each record.
const CYCLES: usize = 3;
/// Number of kernel steps per sample interval.
const FINER: usize = 4;

/// Simulates three cycles of every test with a damper's parameters. The force has white noise with a standard deviation
/// of `noise` times the test's root mean square force.
pub fn campaign(params: &Params, tests: &[Sine], seed: u64, noise: f64) -> Vec<Record> {
    let model = Model::new(params).unwrap();
    let mut random = Random::new(seed);
    tests.iter().enumerate().map(|(k, test)| record(&model, k, test, noise, &mut random)).collect()
}

fn record(model: &Model, k: usize, test: &Sine, noise: f64, random: &mut Random) -> Record {
    let rate = (400.0 * test.frequency).clamp(20.0, 1000.0);
    let per_cycle = (rate / test.frequency).round() as usize;
    let count = CYCLES * per_cycle + 1;
    let w = TAU * test.frequency;
    let motion = |t: f64| (test.mean - test.amplitude * (w * t).cos(), test.amplitude * w * (w * t).sin());
    // The record begins at a time at which the rising displacement passes its mean. All cycles therefore begin there,
    // too.
    let start = 0.25 / test.frequency;
    let input = |t: f64| {
        let (x, v) = motion(t);
        Input { side_force: test.side_force.unwrap_or(0.0), ..Input::motion(x, v) }
    };
    let mut state: State = model.steady_state(&input(start));
    let mut record = Record {
        name: format!("test{k:02}"),
        amplitude: test.amplitude,
        frequency: test.frequency,
        peak_velocity: w * test.amplitude,
        mean_displacement: test.mean,
        cycles: (0..CYCLES).map(|c| c * per_cycle..(c + 1) * per_cycle).collect(),
        side_force: test.side_force.map(|f| vec![f; count]),
        ..Record::default()
    };
    for i in 0..count {
        let t = start + i as f64 / rate;
        let force = if i == 0 {
            evaluate(model, &state, &input(t)).0.force
        } else {
            (1..=FINER).fold(0.0, |_, j| {
                let at = t + (j as f64 / FINER as f64 - 1.0) / rate;
                let (next, output) = step(model, &state, &input(at), 1.0 / rate / FINER as f64);
                state = next;
                output.force
            })
        };
        let (x, v) = motion(t);
        record.time.push(t);
        record.displacement.push(x);
        record.velocity.push(v);
        record.force.push(force);
    }
    let rms = (record.force.iter().map(|f| f * f).sum::<f64>() / count as f64).sqrt();
    record.noise = Noise { force_rms: noise * rms, ..Noise::default() };
    for f in &mut record.force {
        *f += noise * rms * random.normal();
    }
    record
}
