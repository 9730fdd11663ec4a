//! Synthetic rig tests for the unit tests: a simple damper on a sine, with standstill, run-up, run-down and noise.

use std::f64::consts::TAU;
use std::fmt::Write;

use crate::data::record::Record;
use crate::data::samples::Samples;
use crate::error::Place;

/// Uniform and normal random numbers from a seed (xorshift64*; Vigna 2016).
pub(crate) struct Random(u64);

impl Random {
    pub fn new(seed: u64) -> Self {
        Random(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1)
    }

    pub fn uniform(&mut self) -> f64 {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        (self.0.wrapping_mul(0x2545_F491_4F6C_DD1D) >> 11) as f64 / (1_u64 << 53) as f64
    }

    pub fn normal(&mut self) -> f64 {
        (-2.0 * libm::log(self.uniform().max(1e-300))).sqrt() * libm::cos(TAU * self.uniform())
    }
}

/// Returns test number `k` of a campaign: three cycles of a sine with the given amplitude, m, and peak velocity
/// `speed`, m/s. `force` computes the force, N, from displacement, m, and velocity, m/s.
pub(crate) fn sine_record(k: usize, amplitude: f64, speed: f64, mut force: impl FnMut(f64, f64) -> f64) -> Record {
    let omega = speed / amplitude;
    let time: Vec<f64> = (0..1500).map(|i| f64::from(i) * 0.002 * TAU / omega).collect();
    let velocity: Vec<f64> = time.iter().map(|t| speed * libm::cos(omega * t)).collect();
    let displacement: Vec<f64> = time.iter().map(|t| amplitude * libm::sin(omega * t)).collect();
    Record {
        name: format!("t{k}"),
        source: format!("t{k}.csv"),
        force: displacement.iter().zip(&velocity).map(|(x, v)| force(*x, *v)).collect(),
        amplitude,
        peak_velocity: speed,
        time,
        velocity,
        displacement,
        ..Record::default()
    }
}

/// Returns the samples of the file `long.txt`: the given displacement, m, at `rate` samples per second, with zero
/// force.
pub(crate) fn moving(rate: f64, displacement: Vec<f64>) -> Samples {
    let n = displacement.len();
    Samples {
        at: Place::file("long.txt"),
        name: "long".into(),
        lines: (1..=n).collect(),
        time: (0..n).map(|i| i as f64 / rate).collect(),
        begins: None,
        dates: crate::dates::file_dates::Dates::default(),
        force: vec![0.0; n],
        displacement: Some(displacement),
        velocity: None,
        side_force: None,
        temperature: None,
        current: None,
        setting: None,
        headings: Vec::new(),
        about: crate::data::test_metadata::TestMetadata::default(),
        units: Vec::new(),
        notes: Vec::new(),
    }
}

/// A sine test, rebound and tension positive.
#[derive(Debug, Clone)]
pub(crate) struct SineTest {
    pub frequency: f64,
    pub amplitude: f64,
    pub mean: f64,
    /// Number of whole steady cycles. A run-up of one cycle precedes them and a run-down of one cycle follows.
    pub cycles: usize,
    /// Standstill before the run-up and after the run-down, in cycles.
    pub rest: f64,
    pub per_cycle: usize,
    /// Standard deviation of the force noise, N. `lag1` is the autocorrelation of the noise from sample to sample.
    pub noise: f64,
    pub lag1: f64,
    /// Force at standstill, N.
    pub preload: f64,
    pub seed: u64,
}

impl Default for SineTest {
    fn default() -> Self {
        SineTest {
            frequency: 1.0,
            amplitude: 0.05,
            mean: 0.01,
            cycles: 5,
            rest: 0.6,
            per_cycle: 200,
            noise: 4.0,
            lag1: 0.0,
            preload: -150.0,
            seed: 1,
        }
    }
}

/// Returns the force of a damper, N, at the displacement `x`, m, and the velocity `v`, m/s. The damping is 1500 N s/m
/// in rebound and 800 N s/m in compression, the friction 40 N, and the gas spring 200 N/m.
pub(crate) fn damper_force(x: f64, v: f64) -> f64 {
    let damping = if v > 0.0 { 1500.0 } else { 800.0 };
    damping * v + 40.0 * libm::tanh(v / 0.002) + 200.0 * x
}

impl SineTest {
    pub fn period(&self) -> f64 {
        1.0 / self.frequency
    }

    /// Returns the time at which the steady cycles begin with an upward crossing of the mean displacement, s.
    pub fn steady_from(&self) -> f64 {
        (self.rest + 1.0) * self.period()
    }

    pub fn samples(&self) -> Samples {
        let mut random = Random::new(self.seed);
        let total = self.cycles as f64 + 2.0 + 2.0 * self.rest;
        let n = (total * self.per_cycle as f64).round() as usize + 1;
        let omega = TAU * self.frequency;
        let (mut time, mut x, mut v, mut force) = (vec![], vec![], vec![], vec![]);
        let mut noise = random.normal();
        for i in 0..n {
            // Shift the phase by a fraction of a sample, so that no sample lies at a turning point.
            let phase = (i as f64 + 0.37) / self.per_cycle as f64 - self.rest;
            let envelope = phase.min(self.cycles as f64 + 2.0 - phase).clamp(0.0, 1.0);
            let slope = if envelope > 0.0 && envelope < 1.0 {
                if phase < 1.0 { self.frequency } else { -self.frequency }
            } else {
                0.0
            };
            let displacement = self.mean + self.amplitude * envelope * libm::sin(TAU * phase);
            let velocity =
                self.amplitude * (envelope * omega * libm::cos(TAU * phase) + slope * libm::sin(TAU * phase));
            noise = self.lag1 * noise + (1.0 - self.lag1 * self.lag1).sqrt() * random.normal();
            time.push(i as f64 / self.per_cycle as f64 * self.period());
            x.push(displacement);
            v.push(velocity);
            force.push(damper_force(displacement, velocity) + self.preload + self.noise * noise);
        }
        Samples {
            at: Place::file("test.csv"),
            name: "test".into(),
            lines: (2..n + 2).collect(),
            time,
            begins: None,
            dates: Default::default(),
            about: Default::default(),
            force,
            displacement: Some(x),
            velocity: Some(v),
            side_force: None,
            temperature: None,

            current: None,
            setting: None,
            headings: Vec::new(),
            units: Vec::new(),
            notes: Vec::new(),
        }
    }

    pub fn csv(&self) -> String {
        csv(&self.samples())
    }
}

/// Formats samples as a CSV file in SI units.
pub(crate) fn csv(samples: &Samples) -> String {
    let mut text = String::from("time_s");
    let (x, v) = (samples.displacement.as_ref(), samples.velocity.as_ref());
    text.push_str(if x.is_some() { ",displacement_m" } else { "" });
    text.push_str(if v.is_some() { ",velocity_m_s" } else { "" });
    text.push_str(",force_N\n");
    for i in 0..samples.len() {
        write!(text, "{:.6}", samples.time[i]).unwrap();
        for channel in [x, v].into_iter().flatten() {
            write!(text, ",{:.9}", channel[i]).unwrap();
        }
        writeln!(text, ",{:.4}", samples.force[i]).unwrap();
    }
    text
}
