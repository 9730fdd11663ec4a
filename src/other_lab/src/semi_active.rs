//! A semi-active damper (a monotube with a solenoid valve in parallel with the shims of the piston), and its campaign
//! on a rig.
//!
//! The equations of this damper differ from those of the identified model. In the identified model, the actuator is a
//! lag with a dead time. In this damper, it consists of a coil, a magnet, a spool and a main stage.

use crate::LabError;
use crate::campaign::{Accuracy, TestRecord};
use crate::draw::Draw;
use crate::integrator::{Equations, Integrator, Steps};
use crate::jet::Jet;
use crate::plant::flow::Valves;
use crate::plant::monotube::{BAR, Fluid, GAS};
use crate::plant::solenoid_valve::{self, STAGE, SolenoidValve};
use crate::plant::{Mount, Seal};
use crate::protocol::Protocol;
use crate::protocol::waveform::{Ready, Waveform};
use crate::sensors::Sensors;
use crate::trace::interpolate;
use std::f64::consts::{FRAC_PI_4, TAU};

const MOUNT: usize = 0;
const X: usize = 1;
const V: usize = 2;
const SEAL: usize = 3;
const OIL: usize = 4;
const VALVE: usize = 6;
const STATES: usize = VALVE + solenoid_valve::STATES;
/// Simulated time, s, in which the valve reaches its steady state at a constant current.
const LONG: f64 = 0.6;
/// Longest step of the simulation, s.
const STEP: f64 = 1e-3;

/// Parameters of a semi-active damper.
#[derive(Debug, Clone)]
pub struct SemiActivePlant {
    /// Solenoid valve that the current controls.
    pub valve: SolenoidValve,
    /// Largest current of the valve, A.
    pub most: f64,
    mount: Mount,
    seal: Seal,
    mass: f64,
    shims: [Valves; 2],
    fluid: Fluid,
    piston: f64,
    rod: f64,
    lengths: [f64; 2],
    gas: [f64; 2],
}

/// A commanded current over time.
#[derive(Debug, Clone)]
pub enum Command {
    /// Current levels with their start times, s and A. The first level applies from the beginning.
    Levels(Vec<[f64; 2]>),
    /// A mean current, A, and superposed sine waves: amplitude, A, angular frequency, rad/s, and phase, rad.
    Waves(f64, Vec<[f64; 3]>),
}

impl Command {
    fn at(&self, t: f64) -> f64 {
        match self {
            Command::Levels(levels) => {
                let place = levels.partition_point(|[from, _]| *from <= t).max(1) - 1;
                levels.get(place).map_or(0.0, |[_, level]| *level)
            }
            Command::Waves(mean, waves) => {
                let sum: f64 = waves.iter().map(|[size, omega, phase]| size * libm::sin(omega * t + phase)).sum();
                (mean + sum).max(0.0)
            }
        }
    }

    /// Returns the times of the jumps of the current before `end`, s.
    fn jumps(&self, end: f64) -> Vec<f64> {
        match self {
            Command::Levels(levels) => {
                levels.iter().map(|[from, _]| *from).filter(|from| *from > 0.0 && *from < end).collect()
            }
            Command::Waves(..) => Vec::new(),
        }
    }
}

/// A test of a semi-active damper.
#[derive(Debug, Clone)]
pub struct SemiActiveTest {
    /// Name of the test.
    pub name: String,
    /// Motion of the moving end.
    pub motion: Waveform,
    /// Number of cycles of a sine or triangle.
    pub cycles: f64,
    /// Commanded current over time.
    pub command: Command,
    /// Whether the test is excluded from identification.
    pub left_out: bool,
}

/// Record of a test of a semi-active damper.
#[derive(Debug, Clone)]
pub struct SemiActiveRecord {
    /// Measured channels other than the command.
    pub record: TestRecord,
    /// Commanded current at the samples, A.
    pub command_a: Vec<f64>,
    /// True position of the valve's main stage, m.
    pub stage_m: Vec<f64>,
}

impl SemiActivePlant {
    /// Draws the damper of a seed.
    pub fn new(seed: u64) -> SemiActivePlant {
        let mut drawn = Draw::new(seed, "semi-active");
        let d = &mut drawn;
        let rebound = d.scale(2200.0, 3600.0);
        let compression = rebound / d.between(1.3, 2.2);
        let area = |diameter: f64| FRAC_PI_4 * diameter * diameter;
        let (piston, rod) = (area(d.between(0.040, 0.046)), area(d.between(0.011, 0.013)));
        let soft = d.between(0.1, 0.18) * rebound;
        let (most, annulus) = (1.6, piston - rod);
        // At this opening, m², and the force `soft`, N, all oil flows through the solenoid valve at 0.5 m/s.
        let opening = 0.5 * annulus / (0.65 * (2.0 * soft / annulus / 850.0).sqrt());
        let needed = 2.6 * compression / (annulus * BAR);
        SemiActivePlant {
            valve: SolenoidValve::new(d, opening, most),
            most,
            mount: Mount::new(d, (1.5e6, 6e6), (1500.0, 4000.0)),
            seal: Seal::new(d, (25.0, 60.0)),
            mass: d.between(0.3, 0.8),
            shims: [rebound, compression].map(|force| Valves::orifice_and_shim(d, force)),
            fluid: Fluid::new(d),
            piston,
            rod,
            lengths: [d.between(0.11, 0.15), d.between(0.13, 0.18)],
            gas: [d.between(22.0, 30.0).max(needed), d.between(7e-5, 1.2e-4)],
        }
    }

    fn annulus(&self) -> f64 {
        self.piston - self.rod
    }

    fn hydraulic(&self, y: &[f64]) -> f64 {
        (y[OIL] - y[OIL + 1]) * BAR * self.annulus()
    }

    /// Computes the states of the valve in equilibrium at a current, A, approached from zero current.
    fn valve_at_rest(&self, current: f64) -> Vec<f64> {
        let alone = Alone { valve: &self.valve, current };
        let mut y = vec![0.0; solenoid_valve::STATES];
        let steps = Steps { longest: STEP, resolution: 1.0, relative: 1e-4, absolute: 1.0 };
        Integrator::new(y.len()).run(&alone, (0.0, LONG), &mut y, &steps, |_, _, _| ());
        y
    }

    /// Computes pairs of the main stage's position, m, and the current, A, at increasing currents. The valve is in
    /// equilibrium without flow.
    pub fn stage_map(&self) -> Vec<[f64; 2]> {
        const CURRENTS: u32 = 64;
        let mut y = vec![0.0; solenoid_valve::STATES];
        let steps = Steps { longest: STEP, resolution: 1.0, relative: 1e-4, absolute: 1.0 };
        let mut map: Vec<[f64; 2]> = Vec::new();
        for k in 0..=CURRENTS {
            let current = self.most * f64::from(k) / f64::from(CURRENTS);
            let alone = Alone { valve: &self.valve, current };
            Integrator::new(y.len()).run(&alone, (0.0, LONG), &mut y, &steps, |_, _, _| ());
            if map.last().is_none_or(|[place, _]| y[STAGE] > *place) {
                map.push([y[STAGE], current]);
            }
        }
        map
    }

    fn rest(&self, x: f64, current: f64) -> Vec<f64> {
        let mut y = vec![0.0; STATES];
        let pressure = self.gas[0] * libm::pow(self.gas[1] / (self.gas[1] + self.rod * x), GAS);
        y[OIL..OIL + 2].fill(pressure);
        y[X] = x;
        y[MOUNT] = self.oil_force(&y);
        y[VALVE..].copy_from_slice(&self.valve_at_rest(current));
        y
    }

    fn oil_force(&self, y: &[f64]) -> f64 {
        (y[OIL] * self.annulus() - y[OIL + 1] * self.piston + self.rod) * BAR
    }

    /// Simulates a test with the sensors of a protocol. The largest force of the test determines the range of the force
    /// channel's analog-to-digital converter.
    ///
    /// # Errors
    /// [`LabError::NoNumbers`] if the simulation has no finite force.
    pub fn run(
        &self,
        test: &SemiActiveTest,
        protocol: &Protocol,
        accuracy: &Accuracy,
        seed: u64,
    ) -> Result<SemiActiveRecord, LabError> {
        let motion = test.motion.ready(0.0, protocol.rest_s, test.cycles);
        let end = motion.seconds();
        let mut y = self.rest(motion.evaluate(0.0).x, test.command.at(0.0));
        let (mut time, mut force, mut stage) = (vec![0.0], Vec::new(), vec![y[VALVE + STAGE]]);
        let steps = Steps {
            longest: test.motion.longest_step().min(STEP) * accuracy.longest,
            resolution: accuracy.longest,
            relative: accuracy.relative,
            absolute: accuracy.absolute,
        };
        let mut ends = test.command.jumps(end);
        ends.push(end);
        let mut begin = 0.0;
        for end in ends {
            // Between two jumps of the command, the current is constant, including the instant of the second jump.
            let held = match &test.command {
                Command::Levels(_) => Some(test.command.at(0.5 * (begin + end))),
                Command::Waves(..) => None,
            };
            let machine = Machine { plant: self, motion: &motion, command: &test.command, held };
            if force.is_empty() {
                force.push(machine.force(&machine.drive(0.0), &y));
            }
            let mut integrator = Integrator::new(STATES);
            let done = integrator.run(&machine, (begin, end), &mut y, &steps, |t, at, y| {
                time.push(t);
                force.push(machine.force(at, y));
                stage.push(y[VALVE + STAGE]);
            });
            if !done || force.iter().any(|f| !f.is_finite()) {
                return Err(LabError::NoNumbers { test: test.name.clone() });
            }
            begin = end;
        }
        let samples: Vec<f64> =
            (0..=(end * protocol.sample_rate_hz) as usize).map(|i| i as f64 / protocol.sample_rate_hz).collect();
        let through = |values: &[f64]| -> Vec<f64> { samples.iter().map(|t| interpolate(&time, values, *t)).collect() };
        let clean = through(&force);
        let mut record = TestRecord {
            name: test.name.clone(),
            time_s: samples.clone(),
            displacement_m: samples.iter().map(|t| motion.evaluate(*t).x).collect(),
            velocity_m_s: Some(samples.iter().map(|t| motion.evaluate(*t).v).collect()),
            force_n: clean.clone(),
            clean_force_n: clean,
            side_force_n: None,
            temperature_c: None,
            left_out: test.left_out,
        };
        let peak_n = record.clean_force_n.iter().fold(1.0f64, |m, f| m.max(f.abs()));
        let sensors = Sensors { protocol, seed, test: &test.name, peak_n };
        sensors.force(&record.time_s, &mut record.force_n);
        sensors.displacement(&mut record.displacement_m);
        record.velocity_m_s.iter_mut().for_each(|velocity| sensors.velocity(velocity));
        Ok(SemiActiveRecord {
            command_a: samples.iter().map(|t| test.command.at(*t)).collect(),
            stage_m: through(&stage),
            record,
        })
    }
}

impl SemiActiveRecord {
    /// Formats the record as CSV with its commanded current, SI units.
    pub fn csv(&self) -> String {
        let text = self.record.csv();
        let mut lines = text.lines();
        let mut out = format!("{},current [A]\n", lines.next().unwrap_or_default());
        for (line, command) in lines.zip(&self.command_a) {
            out += &format!("{line},{command:.4}\n");
        }
        out
    }
}

/// The solenoid valve without flow, at a constant current, A.
struct Alone<'a> {
    valve: &'a SolenoidValve,
    current: f64,
}

impl Equations for Alone<'_> {
    type Drive = ();

    fn drive(&self, _: f64) {}

    fn tolerances(&self) -> &[f64] {
        &solenoid_valve::TOLERANCES
    }

    fn rates(&self, (): &(), y: &[f64], r: &mut [f64]) {
        self.valve.rates(self.current, 0.0, y, r);
    }
}

/// A damper in one test, between two jumps of its command.
struct Machine<'a> {
    plant: &'a SemiActivePlant,
    motion: &'a Ready,
    command: &'a Command,
    held: Option<f64>,
}

/// Motion and command at an instant.
struct Instant {
    input: Jet,
    command: f64,
}

const TOLERANCES: [f64; STATES] = {
    let mut all = [0.0; STATES];
    (all[MOUNT], all[X], all[V], all[SEAL]) = (0.1, 5e-7, 2e-5, 1e-7);
    (all[OIL], all[OIL + 1]) = (5e-4, 5e-4);
    let mut k = 0;
    while k < solenoid_valve::STATES {
        all[VALVE + k] = solenoid_valve::TOLERANCES[k];
        k += 1;
    }
    all
};

impl Machine<'_> {
    fn mount_rate(&self, at: &Instant, y: &[f64]) -> (f64, f64) {
        let own = self.plant.mount.compliance(y[MOUNT]);
        let relative = at.input.v - y[V];
        (relative / own, self.plant.mount.damping * relative)
    }

    /// Computes the force at the load cell, N, from the motion and the states.
    fn force(&self, at: &Instant, y: &[f64]) -> f64 {
        y[MOUNT] + self.mount_rate(at, y).1
    }
}

impl Equations for Machine<'_> {
    type Drive = Instant;

    fn drive(&self, t: f64) -> Instant {
        Instant { input: self.motion.evaluate(t), command: self.held.unwrap_or_else(|| self.command.at(t)) }
    }

    fn tolerances(&self) -> &[f64] {
        &TOLERANCES
    }

    fn longest(&self, at: &Instant) -> f64 {
        0.4 * (at.input.v.abs() + 1.5e-3) / at.input.a.abs().max(1e-9)
    }

    fn rates(&self, at: &Instant, y: &[f64], r: &mut [f64]) {
        let plant = self.plant;
        let (mount_rate, beside) = self.mount_rate(at, y);
        r[MOUNT] = mount_rate;
        r[X] = y[V];
        r[SEAL] = plant.seal.rate(y[V], y[SEAL]);
        let held = plant.oil_force(y) + plant.seal.force(y[V], y[SEAL]);
        r[V] = (y[MOUNT] + beside - held) / plant.mass;

        let (area, h) = (plant.annulus(), plant.hydraulic(y));
        let shims = if h >= 0.0 { &plant.shims[0] } else { &plant.shims[1] };
        let valve = &y[VALVE..];
        let passed = shims.velocity(h.abs(), 1.0) + plant.valve.velocity(h.abs(), area, valve);
        let q = area * passed.copysign(h);
        let above = area * (plant.lengths[0] - y[X]).max(0.01);
        let below = plant.piston * (plant.lengths[1] + y[X]).max(0.01);
        let p1 = y[OIL + 1].max(0.2);
        let gas = plant.gas[1] * libm::pow(plant.gas[0] / p1, 1.0 / GAS) / (GAS * p1);
        r[OIL] = (area * y[V] - q) / (above * plant.fluid.compliance(y[OIL]));
        r[OIL + 1] = (q - plant.piston * y[V]) / (below * plant.fluid.compliance(y[OIL + 1]) + gas);
        plant.valve.rates(at.command, h.abs() / area, valve, &mut r[VALVE..]);
    }
}

/// Currents of the sines, A.
pub const CURRENTS: [f64; 8] = [0.0, 0.2, 0.4, 0.6, 0.8, 1.0, 1.3, 1.6];
/// Prefix of the names of tests that are excluded from identification.
pub const LEFT_OUT: &str = "holdout_";
/// Amplitude, mm, and peak velocity, m/s, of the sines at each current.
const SINES: [(f64, f64); 6] = [(30.0, 0.02), (30.0, 0.15), (30.0, 0.5), (30.0, 0.9), (6.0, 0.25), (6.0, 0.6)];
/// Lower and upper level of the current steps, A, and constant speed of the motion, m/s.
const STEPS: [(f64, f64, f64); 5] =
    [(0.0, 1.6, 0.3), (0.3, 1.2, 0.3), (0.0, 0.9, 0.5), (0.6, 1.6, 0.15), (0.3, 0.9, 0.3)];
/// Amplitude of the triangles, m.
const TRIANGLE: f64 = 0.04;

/// Makes sine tests at each of the constant currents, A.
pub fn sines(currents: &[f64]) -> Vec<SemiActiveTest> {
    let of = |current: f64| {
        SINES.map(|(amplitude, peak)| {
            let frequency = peak / (TAU * amplitude * 1e-3);
            SemiActiveTest {
                name: format!("sine_{amplitude}mm_{:.0}mm_s_{current}A", 1e3 * peak),
                motion: Waveform::Sine { amplitude: amplitude * 1e-3, frequency },
                cycles: 3.0,
                command: Command::Levels(vec![[0.0, current]]),
                left_out: false,
            }
        })
    };
    currents.iter().flat_map(|current| of(*current)).collect()
}

/// Makes tests with steps of current up and down during strokes of constant speed.
///
/// Each step occurs at a random instant between 25 and 40 % of a stroke. Every third stroke has no step, so that steps
/// up and down occur in both directions.
pub fn steps(seed: u64) -> Vec<SemiActiveTest> {
    let of = |(place, (low, high, speed)): (usize, &(f64, f64, f64))| {
        let mut d = Draw::new(seed, &format!("steps {place}"));
        // The first stroke with a step (k = 3) begins half a stroke after the standstill and the fade-in of one cycle.
        let stroke = 2.0 * TRIANGLE / speed;
        let cycles = 9.0;
        let mut levels = vec![[0.0, *low]];
        let mut is_high = false;
        for k in 3..(2.0 * cycles) as usize {
            if k % 3 != 2 {
                is_high = !is_high;
                let begin = Protocol::default().rest_s + (k as f64 - 0.5) * stroke;
                let level = if is_high { *high } else { *low };
                levels.push([begin + d.between(0.25, 0.4) * stroke, level]);
            }
        }
        SemiActiveTest {
            name: format!("steps_{low}_{high}_{:.0}mm_s", 1e3 * speed),
            motion: Waveform::Triangle { amplitude: TRIANGLE, frequency: 0.5 / stroke },
            cycles,
            command: Command::Levels(levels),
            left_out: false,
        }
    };
    STEPS.iter().enumerate().map(of).collect()
}

/// Makes a test with a random current, up to about `most`, A, during a road-like random motion.
pub fn random(name: &str, seed: u64, most: f64, left_out: bool) -> SemiActiveTest {
    let mut d = Draw::new(seed, "random current");
    let waves: Vec<[f64; 3]> =
        (0..14).map(|_| [d.between(0.4, 1.0), TAU * d.scale(0.3, 12.0), TAU * d.fraction()]).collect();
    let square: f64 = waves.iter().map(|[size, ..]| 0.5 * size * size).sum();
    // The waves are scaled so that two standard deviations of the current are half the range from 0 to `most`.
    let factor = 0.25 * most / square.sqrt();
    let waves = waves.into_iter().map(|[size, omega, phase]| [factor * size, omega, phase]).collect();
    SemiActiveTest {
        name: name.to_owned(),
        motion: Waveform::Road { displacement: 0.03, velocity: 0.8, seconds: 8.0, seed },
        cycles: 1.0,
        command: Command::Waves(0.5 * most, waves),
        left_out,
    }
}

/// Returns the tests of the campaign: sines at each current, steps, and a left-out test with random current.
pub fn protocol(seed: u64, most: f64) -> Vec<SemiActiveTest> {
    let mut tests = sines(&CURRENTS);
    tests.extend(steps(seed));
    tests.push(random(&format!("{LEFT_OUT}random_current"), seed, most, true));
    tests
}

#[cfg(test)]
mod tests {
    use super::*;

    fn quiet() -> Protocol {
        Protocol { noise_percent: 0.0, ..Protocol::default() }
    }

    #[test]
    fn the_damper_is_harder_with_more_current_and_takes_energy() {
        for seed in 0..3 {
            let plant = SemiActivePlant::new(seed);
            let mut last = 0.0;
            for current in CURRENTS {
                let test = sines(&[current]).swap_remove(2);
                let got = plant.run(&test, &quiet(), &Accuracy::default(), 1).unwrap().record;
                let peak = got.clean_force_n.iter().fold(0.0f64, |m, f| m.max(*f));
                assert!(peak > 1.02 * last && peak < 6000.0, "{seed} {current}: {peak} after {last}");
                last = peak;
                let work: f64 = (1..got.time_s.len())
                    .map(|i| {
                        0.5 * (got.clean_force_n[i] + got.clean_force_n[i - 1])
                            * (got.displacement_m[i] - got.displacement_m[i - 1])
                    })
                    .sum();
                assert!(work > 0.0);
            }
        }
    }

    #[test]
    fn the_valve_takes_milliseconds_and_rests_elsewhere_on_the_way_down() {
        for seed in 0..4 {
            let plant = SemiActivePlant::new(seed);
            let answer = |from: f64, to: f64| {
                let mut y = plant.valve_at_rest(from);
                let start = y[STAGE];
                let alone = Alone { valve: &plant.valve, current: to };
                let steps = Steps { longest: 2e-4, resolution: 1.0, relative: 1e-4, absolute: 1.0 };
                let mut way = Vec::new();
                Integrator::new(y.len()).run(&alone, (0.0, 0.3), &mut y, &steps, |t, (), y| way.push((t, y[STAGE])));
                let end = y[STAGE];
                let reached = way.iter().find(|(_, s)| (s - start) / (end - start) > 0.63).unwrap().0;
                (reached, end)
            };
            let ((up, high), (down, low)) = (answer(0.3, 1.2), answer(1.2, 0.3));
            assert!((2e-3..40e-3).contains(&up) && (2e-3..60e-3).contains(&down), "{seed}: {up} {down}");
            assert!(high > low);
            // The position of the main stage at 0.6 A must differ between an approach from lower and one from higher
            // currents, because of friction.
            let mut from_above = plant.valve_at_rest(1.6);
            let alone = Alone { valve: &plant.valve, current: 0.6 };
            let steps = Steps { longest: 2e-4, resolution: 1.0, relative: 1e-4, absolute: 1.0 };
            Integrator::new(from_above.len()).run(&alone, (0.0, 0.4), &mut from_above, &steps, |_, _, _| ());
            assert!(from_above[STAGE] > plant.valve_at_rest(0.6)[STAGE], "{seed}");
        }
    }
}
