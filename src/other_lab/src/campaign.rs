//! Simulation of a campaign: successive tests on one damper, and their sensor readings.

use crate::LabError;
use crate::case::{Case, InjectedEffect, Prepared};
use crate::draw::Draw;
use crate::effects::Reading;
use crate::integrator::{Equations, Integrator, Steps};
use crate::machine::{Around, Machine};
use crate::plant::Scale;
use crate::protocol::Protocol;
use crate::protocol::plan::Test;
use crate::protocol::waveform::{Ready, Waveform};
use crate::sensors::Sensors;
use crate::trace::interpolate;
use serde::Serialize;

/// Records of a campaign, and the true damper and effects.
#[derive(Debug, Clone)]
pub struct Campaign {
    /// The tests in the order of execution.
    pub tests: Vec<TestRecord>,
    /// The true damper and effects.
    pub truth: Truth,
}

/// Measured channels of one test.
#[derive(Debug, Clone)]
pub struct TestRecord {
    /// Name of the test.
    pub name: String,
    /// Time since the start of the campaign, s. It continues from test to test.
    pub time_s: Vec<f64>,
    /// Displacement of the moving end, extension positive, m.
    pub displacement_m: Vec<f64>,
    /// Velocity of the moving end, m/s, if measured.
    pub velocity_m_s: Option<Vec<f64>>,
    /// Force, tension positive, N.
    pub force_n: Vec<f64>,
    /// Force without noise, hum, offset and rounding, but with the delay of the force channel, N.
    pub clean_force_n: Vec<f64>,
    /// Side force, N, if a test of the plan has side force.
    pub side_force_n: Option<Vec<f64>>,
    /// Temperature of the oil, °C, if measured.
    pub temperature_c: Option<Vec<f64>>,
    /// Whether the test is excluded from identification.
    pub left_out: bool,
}

/// True properties of a campaign.
#[derive(Debug, Clone, Serialize)]
pub struct Truth {
    /// Kind of damper.
    pub plant: String,
    /// Seed of the damper and the injected effects.
    pub seed: u64,
    /// Seed of the noise.
    pub noise_seed: u64,
    /// Injected effects.
    pub injected: Vec<InjectedEffect>,
    /// Characteristic forces and stiffness of the damper.
    pub scale: Scale,
    /// Protocol of the measurement.
    pub protocol: Protocol,
    /// Names of the tests excluded from identification.
    pub left_out: Vec<String>,
}

/// Accuracy of the simulation.
#[derive(Debug, Clone, Copy)]
pub struct Accuracy {
    /// Relative error tolerance of a step.
    pub relative: f64,
    /// Factor by which the absolute error tolerances of the states are multiplied.
    pub absolute: f64,
    /// Factor by which the longest step of a motion is multiplied.
    pub longest: f64,
}

impl Default for Accuracy {
    /// Returns tolerances with force errors below a tenth of the default sensor noise. The test
    /// `smaller_steps_change_the_force_by_less_than_a_tenth_of_the_noise` verifies this.
    fn default() -> Accuracy {
        Accuracy { relative: 4e-4, absolute: 0.4, longest: 1.0 }
    }
}

/// Temperature of the laboratory, °C.
const AMBIENT_C: f64 = 22.0;
/// Heat capacity of oil and tube, J/K. [`COOLING`] is the heat transfer to the air, W/K.
const CAPACITY: f64 = 700.0;
const COOLING: f64 = 4.0;
/// Pause between two tests, s.
const PAUSE_S: f64 = 25.0;
/// Upper limit of the oil temperature, °C, as on a rig that lets hot oil cool.
const HOTTEST_C: f64 = 85.0;

struct Simulated {
    time: Vec<f64>,
    force: Vec<f64>,
    energy: f64,
}

impl Case {
    /// Simulates all tests of the campaign with the default accuracy, and adds the sensor errors.
    ///
    /// # Errors
    /// Returns a [`LabError`] for an unknown effect or law, an invalid strength, an invalid protocol, or a simulation
    /// without a finite force.
    pub fn run(&self) -> Result<Campaign, LabError> {
        self.run_with(&Accuracy::default())
    }

    /// Simulates the campaign with the accuracy `accuracy`, and adds the sensor errors.
    ///
    /// # Errors
    /// Returns the errors of [`Case::run`].
    pub fn run_with(&self, accuracy: &Accuracy) -> Result<Campaign, LabError> {
        self.run_prepared(self.prepare()?, accuracy)
    }

    /// Simulates the campaign with a damper and effects that are already drawn.
    pub(crate) fn run_prepared(&self, prepared: Prepared, accuracy: &Accuracy) -> Result<Campaign, LabError> {
        let Prepared { plant, effects, truth } = prepared;
        let p = &self.protocol;
        p.check()?;
        let tests = self.ordered();
        let ready: Vec<Ready> =
            tests.iter().map(|test| test.motion.ready(test.mean, p.rest_s, f64::from(p.cycles))).collect();
        let campaign: f64 = ready.iter().map(|r| r.seconds() + PAUSE_S).sum();
        let has_side = tests.iter().any(|test| test.side != 0.0);
        let (mut clock, mut oil_c) = (0.0, AMBIENT_C);
        let mut records = Vec::with_capacity(tests.len());
        for (test, motion) in tests.iter().zip(&ready) {
            let around = Around { clock, campaign, side: test.side, oil_c };
            let machine = Machine::new(&plant, &effects, motion, around);
            let Simulated { time, mut force, energy } = simulate(&machine, motion, &test.motion, accuracy)
                .ok_or_else(|| LabError::NoNumbers { test: test.name.clone() })?;
            let seconds = motion.seconds();
            let heat = |before: f64, joule: f64| (before + joule / CAPACITY).min(HOTTEST_C);
            let warm = |t: f64| oil_c + (heat(oil_c, energy) - oil_c) * t / seconds;

            let number = Draw::new(0, &test.name).choice(1 << 30) as u64;
            for effect in &effects {
                effect.channel(number, &time, &mut force);
            }
            let times = self.samples(test, seconds);
            let moves: Vec<_> = times.iter().map(|t| motion.evaluate(*t)).collect();
            let peak = force.iter().fold(0.0f64, |m, f| m.max(f.abs()));
            let mut clean: Vec<f64> = times.iter().map(|t| interpolate(&time, &force, t - p.force_delay_s)).collect();
            for ((t, input), value) in times.iter().zip(&moves).zip(&mut clean) {
                let now = clock + t - p.force_delay_s;
                let reading = Reading {
                    t: *t,
                    clock: now,
                    progress: now / campaign,
                    input: *input,
                    force: *value,
                    oil_c: warm(*t),
                    peak,
                };
                *value += effects.iter().map(|e| e.reads(&reading)).sum::<f64>();
            }
            let through = |x: f64| effects.iter().fold(x, |x, e| e.displacement(x));
            records.push(TestRecord {
                name: test.name.clone(),
                time_s: times.iter().map(|t| clock + t).collect(),
                displacement_m: moves.iter().map(|m| through(m.x)).collect(),
                velocity_m_s: p.velocity_channel.then(|| moves.iter().map(|m| m.v).collect()),
                force_n: clean.clone(),
                clean_force_n: clean,
                side_force_n: has_side.then(|| vec![test.side; times.len()]),
                temperature_c: p.temperature_channel.then(|| times.iter().map(|t| warm(*t)).collect()),
                left_out: test.left_out,
            });
            // Unrecorded conditioning cycles, only before sine tests, also heat the oil. The oil cools over the
            // duration of the test and a pause.
            let runs = if matches!(test.motion, Waveform::Sine { .. }) { p.conditioning } else { 0.0 };
            oil_c = heat(oil_c, energy * (1.0 + runs));
            oil_c = AMBIENT_C + (oil_c - AMBIENT_C) * libm::exp(-(seconds + PAUSE_S) * COOLING / CAPACITY);
            clock += seconds + PAUSE_S;
        }
        self.measure(&mut records);
        let held_out = records.iter().filter(|r| r.left_out).map(|r| r.name.clone()).collect();
        Ok(Campaign {
            tests: records,
            truth: Truth {
                plant: self.plant.name().to_owned(),
                seed: self.seed,
                noise_seed: self.noise_seed,
                injected: truth,
                scale: plant.scale,
                protocol: p.clone(),
                left_out: held_out,
            },
        })
    }

    /// Returns the tests in the order of execution. If the protocol shuffles them, the repeated reference tests are
    /// spread evenly over the others.
    fn ordered(&self) -> Vec<Test> {
        let tests = self.protocol.plan.tests(self.protocol.road_s);
        if !self.protocol.shuffled {
            return tests;
        }
        let (repeats, mut rest): (Vec<_>, Vec<_>) = tests.into_iter().partition(|test| test.is_reference);
        Draw::new(self.seed, "order of the tests").shuffle(&mut rest);
        let (count, gaps) = (rest.len(), repeats.len().saturating_sub(1).max(1));
        for (i, repeat) in repeats.into_iter().enumerate() {
            rest.insert((i * count / gaps + i).min(rest.len()), repeat);
        }
        rest
    }

    /// Computes the times of the samples since the start of the test, s.
    fn samples(&self, test: &Test, seconds: f64) -> Vec<f64> {
        let p = &self.protocol;
        let all = seconds * p.sample_rate_hz;
        let every = match test.motion {
            Waveform::Sine { .. } | Waveform::Triangle { .. } => (all / p.most_samples as f64).ceil().max(1.0),
            Waveform::Sweep { .. } | Waveform::Road { .. } => 1.0,
        };
        (0..=(all / every) as usize).map(|i| i as f64 * every / p.sample_rate_hz).collect()
    }

    fn measure(&self, records: &mut [TestRecord]) {
        let peak_n = records.iter().flat_map(|r| &r.clean_force_n).fold(1.0f64, |m, f| m.max(f.abs()));
        for record in records {
            let name = record.name.clone();
            let sensors = Sensors { protocol: &self.protocol, seed: self.noise_seed, test: &name, peak_n };
            sensors.force(&record.time_s, &mut record.force_n);
            sensors.displacement(&mut record.displacement_m);
            if let Some(velocity) = &mut record.velocity_m_s {
                sensors.velocity(velocity);
            }
            if let Some(side) = &mut record.side_force_n {
                sensors.side(side);
            }
            if let Some(temperature) = &mut record.temperature_c {
                sensors.temperature(temperature);
            }
        }
    }
}

fn simulate(machine: &Machine, motion: &Ready, kind: &Waveform, accuracy: &Accuracy) -> Option<Simulated> {
    let mut y = machine.rest();
    let start = machine.drive(0.0);
    let (mut time, mut force) = (vec![0.0], vec![machine.force(&start, &y)]);
    let (mut energy, mut last) = (0.0, (0.0, 0.0));
    let steps = Steps {
        longest: kind.longest_step() * accuracy.longest,
        resolution: accuracy.longest,
        relative: accuracy.relative,
        absolute: accuracy.absolute,
    };
    let mut integrator = Integrator::new(y.len());
    let done = integrator.run(machine, (0.0, motion.seconds()), &mut y, &steps, |t, at, y| {
        let f = machine.force(at, y);
        let power = f * at.input.v;
        energy += 0.5 * (power + last.1) * (t - last.0);
        last = (t, power);
        time.push(t);
        force.push(f);
    });
    (done && force.iter().all(|f| f.is_finite())).then(|| Simulated { time, force, energy: energy.max(0.0) })
}
