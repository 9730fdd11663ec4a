//! Runs a case: test after test on one clock, so that heat and whatever else lasts is carried over.

use std::cell::RefCell;
use std::collections::BTreeMap;

use super::{HiddenCampaign, HiddenCase, HiddenEffect, Truth};
use crate::campaign::check;
use crate::draw::Draw;
use crate::drive::Drive;
use crate::heat::{AIR_C, Heat, Temperatures};
use crate::hidden::{self, Drawn, Hidden};
use crate::neutral::{Line, Neutral, OWN, Rest, System};
use crate::sensors::Sensors;
use crate::solver::Integrator;
use crate::{Campaign, Matrix, Options, Record, RigError, TestPoint};

/// Samples per cycle aimed at, fewer than on a usual rig: enough for 25 Hz and short files.
const SAMPLES_PER_CYCLE: f64 = 100.0;
/// Rates whose sample times are whole microseconds, Hz.
const RATES_HZ: [f64; 22] = [
    1.0, 2.0, 4.0, 5.0, 8.0, 10.0, 16.0, 20.0, 25.0, 32.0, 40.0, 50.0, 80.0, 100.0, 125.0, 200.0, 250.0, 400.0, 500.0,
    1000.0, 1250.0, 2500.0,
];
/// Rate for road-like motions, Hz.
const ROAD_RATE_HZ: f64 = 500.0;
/// Rests between tests, s.
const PAUSE_S: (f64, f64) = (3.0, 12.0);
/// Samples fall beside the reversals, where the velocity would be exactly zero: by this share of a sample.
const SAMPLE_OFFSET: f64 = 0.37;

impl HiddenCase {
    /// A case without hidden effects: the neutral damper of a seed.
    pub fn nothing(seed: u64) -> Self {
        Self { options: Options { seed, ..Options::default() }, ..Self::default() }
    }

    /// Hides one more effect.
    #[must_use]
    pub fn hiding(mut self, name: &str, strength: f64) -> Self {
        self.effects.push((name.into(), strength));
        self
    }

    /// Runs the case on its plan. One thread; run cases side by side to use more.
    ///
    /// # Errors
    /// [`RigError::Option`] for unknown effects, strengths below zero and options out of range; [`RigError::Motion`] when a
    /// test cannot be simulated.
    pub fn run(&self) -> Result<HiddenCampaign, RigError> {
        let order = self.options.order.unwrap_or(self.options.seed);
        self.run_matrix(&self.plan.matrix(order), |_, _| {})
    }

    /// Runs the case on a matrix instead of its plan, in the matrix's order. `progress` is called with the number of tests
    /// done and their total.
    ///
    /// # Errors
    /// As [`HiddenCase::run`].
    pub fn run_matrix(&self, matrix: &Matrix, progress: impl Fn(usize, usize)) -> Result<HiddenCampaign, RigError> {
        let seed = self.options.seed;
        check(matrix, &self.options)?;
        let mut draw = Draw::new(seed, "neutral damper");
        let neutral = Neutral::draw(&mut draw);
        let heat = Heat::draw(&mut draw);
        let tests = schedule(matrix, &self.options);
        let campaign_s = tests.last().map_or(0.0, |test| test.clock_s + test.drive.duration_s());
        let mut drawn = Vec::new();
        for (name, strength) in &self.effects {
            check_strength(name, *strength)?;
            let effect = hidden::draw(name, *strength, seed, &neutral, campaign_s)?;
            if drawn.iter().any(|other: &Drawn| other.name == effect.name) {
                return Err(RigError::Option { option: "hide", problem: format!("'{}' is listed twice", effect.name) });
            }
            drawn.push(effect);
        }
        let truth = truth(seed, &drawn, draw.drawn);
        // At strength 0 nothing at all is left of an effect.
        let hidden: Vec<Box<dyn Hidden>> =
            drawn.into_iter().filter(|effect| effect.strength > 0.0).map(|effect| effect.hidden).collect();

        let rig = Rig { neutral: &neutral, heat: &heat, hidden: &hidden, options: &self.options };
        let with_side_force = matrix.has_side_force() && self.options.side_force_channel;
        let mut records = rig.measure_all(&tests, with_side_force, progress)?;
        let peak = records.iter().flat_map(|record| &record.clean_force_n).fold(0f64, |peak, n| peak.max(n.abs()));
        for (record, test) in records.iter_mut().zip(&tests) {
            Sensors::new(&self.options, &test.point.name).disturb_record(
                record,
                test.drive.full_cycles_s(),
                test.clock_s,
                peak,
            );
        }
        Ok(HiddenCampaign { campaign: Campaign { options: self.options.clone(), records, sealed: true }, truth })
    }
}

fn check_strength(name: &str, strength: f64) -> Result<(), RigError> {
    if strength.is_finite() && strength >= 0.0 {
        return Ok(());
    }
    Err(RigError::Option { option: "hide", problem: format!("strength {strength} of '{name}'; give 0 or more") })
}

fn truth(seed: u64, drawn: &[Drawn], damper: Vec<(String, f64)>) -> Truth {
    // A name drawn several times, such as the share of each element, is numbered.
    let named = |drawn: &[(String, f64)]| {
        let mut named = BTreeMap::new();
        for (name, value) in drawn {
            let mut key = name.clone();
            let mut number = 2;
            while named.contains_key(&key) {
                key = format!("{name}_{number}");
                number += 1;
            }
            named.insert(key, *value);
        }
        named
    };
    Truth {
        seed,
        effects: drawn
            .iter()
            .map(|effect| HiddenEffect {
                name: effect.name.into(),
                form: effect.form.into(),
                strength: effect.strength,
                shapes: named(&effect.shapes),
            })
            .collect(),
        damper: named(&damper),
    }
}

/// One test on the clock.
struct Scheduled<'a> {
    point: &'a TestPoint,
    drive: Drive,
    rate_hz: f64,
    /// Clock at the first sample, s.
    clock_s: f64,
    /// Rest before the test, s.
    pause_s: f64,
}

fn schedule<'a>(matrix: &'a Matrix, options: &Options) -> Vec<Scheduled<'a>> {
    let mut draw = Draw::new(options.seed, "rests between tests");
    let mut clock_s = 0.0;
    matrix
        .points()
        .iter()
        .enumerate()
        .map(|(index, point)| {
            let drive = Drive::brief(point);
            let wanted = SAMPLES_PER_CYCLE * point.frequency_hz;
            let usual = RATES_HZ.into_iter().find(|rate| *rate >= wanted).unwrap_or(RATES_HZ[RATES_HZ.len() - 1]);
            let usual = if point.road_seed.is_some() { ROAD_RATE_HZ } else { usual };
            let pause_s = if index == 0 { 0.0 } else { PAUSE_S.0 + (PAUSE_S.1 - PAUSE_S.0) * draw.unit() };
            // Whole milliseconds, so that times are exact in a file.
            clock_s = f64::ceil((clock_s + pause_s) * 1e3) / 1e3;
            let test = Scheduled { point, rate_hz: options.sample_rate_hz.unwrap_or(usual), clock_s, pause_s, drive };
            clock_s += test.drive.duration_s();
            test
        })
        .collect()
}

/// The damper on the rig with whatever is hidden.
struct Rig<'a> {
    neutral: &'a Neutral,
    heat: &'a Heat,
    hidden: &'a [Box<dyn Hidden>],
    options: &'a Options,
}

/// What lasts from test to test.
struct Lasting {
    temperatures: Temperatures,
    states: Vec<Vec<f64>>,
}

impl Rig<'_> {
    fn measure_all(
        &self,
        tests: &[Scheduled],
        with_side_force: bool,
        progress: impl Fn(usize, usize),
    ) -> Result<Vec<Record>, RigError> {
        let body_c = self.options.start_temperature_c.unwrap_or(AIR_C);
        let mut lasting = Lasting {
            temperatures: Temperatures { oil_c: body_c, body_c },
            states: self.hidden.iter().map(|hidden| vec![0.0; hidden.tolerances().len()]).collect(),
        };
        let states = OWN + lasting.states.iter().map(Vec::len).sum::<usize>();
        let mut records = Vec::with_capacity(tests.len());
        for test in tests {
            lasting.temperatures = self.heat.after(lasting.temperatures, 0.0, test.pause_s);
            for (hidden, states) in self.hidden.iter().zip(&mut lasting.states) {
                hidden.pause(test.pause_s, states);
            }
            // The solver knows the number of states when it is compiled; spare states stay at zero.
            let record = match states {
                0..=3 => self.measure::<3>(test, with_side_force, &mut lasting),
                4 => self.measure::<4>(test, with_side_force, &mut lasting),
                5 => self.measure::<5>(test, with_side_force, &mut lasting),
                6..=8 => self.measure::<8>(test, with_side_force, &mut lasting),
                9..=12 => self.measure::<12>(test, with_side_force, &mut lasting),
                13..=20 => self.measure::<20>(test, with_side_force, &mut lasting),
                _ => self.measure::<64>(test, with_side_force, &mut lasting),
            };
            records.push(record?);
            progress(records.len(), tests.len());
        }
        Ok(records)
    }

    fn measure<const N: usize>(
        &self,
        test: &Scheduled,
        with_side_force: bool,
        lasting: &mut Lasting,
    ) -> Result<Record, RigError> {
        let mut first = Vec::with_capacity(self.hidden.len());
        let mut next = OWN;
        for states in &lasting.states {
            first.push(next);
            next += states.len();
        }
        let oil_c = RefCell::new(lasting.temperatures.oil_c);
        let system = System::<N> { neutral: self.neutral, hidden: self.hidden, first, oil_c: &oil_c };
        let point = test.point;
        let offset = SAMPLE_OFFSET / test.rate_hz;
        let line = |time: f64| {
            let motion = test.drive.motion_with_acceleration(time + offset);
            Line {
                displacement_m: motion.displacement_m,
                velocity_m_s: motion.velocity_m_s,
                acceleration_m_s2: motion.acceleration_m_s2,
                side_force_n: point.side_force_n,
                clock_s: test.clock_s + time,
                peak_velocity_m_s: point.peak_velocity_m_s,
                oil_c: 0.0,
            }
        };
        let count = (test.drive.duration_s() * test.rate_hz).floor() as usize + 1;
        let mut record = Record::empty(point, test.rate_hz, count);
        let mut temperature_c = Vec::with_capacity(count);
        let rest = Rest { displacement_m: point.mean_displacement_m };
        let mut motion = Integrator::new(
            |time, state: &[f64; N]| system.rates(&line(time), state),
            0.0,
            system.at_rest(&rest, &lasting.states),
            system.tolerance(),
        );
        let late = self.hidden.iter().map(|hidden| hidden.delay_s()).sum::<f64>();
        for index in 0..count {
            let time = index as f64 / test.rate_hz;
            let felt = (time - late).max(0.0);
            motion.advance_to(felt).map_err(|stuck| RigError::Motion {
                test: point.name.clone(),
                time_s: stuck.time_s,
                problem: stuck.reason.into(),
            })?;
            let (now, then) = (line(time), line(felt));
            record.time_s.push(test.clock_s + time);
            record.displacement_m.push(now.displacement_m);
            record.velocity_m_s.push(now.velocity_m_s);
            record.force_n.push(system.cell_n(&then, motion.state()));
            temperature_c.push(lasting.temperatures.body_c);
            let heat_w = system.heat_w(&then, motion.state());
            lasting.temperatures = self.heat.after(lasting.temperatures, heat_w, 1.0 / test.rate_hz);
            *oil_c.borrow_mut() = lasting.temperatures.oil_c;
        }
        let end = motion.state();
        for (states, first) in lasting.states.iter_mut().zip(&system.first) {
            let count = states.len();
            states.copy_from_slice(&end[*first..first + count]);
        }
        record.clean_force_n.clone_from(&record.force_n);
        record.side_force_n = with_side_force.then(|| vec![point.side_force_n; count]);
        record.temperature_c = self.options.temperature_channel.then_some(temperature_c);
        Ok(record)
    }
}
