//! Execution of a case: all tests in sequence with one clock, so that temperatures and other lasting states continue
//! from test to test.

use std::cell::RefCell;
use std::collections::BTreeMap;

use dashpot_messages::format_number;

use super::{InjectedCampaign, InjectedCase, InjectedEffect, Truth};
use crate::campaign::check;
use crate::draw::Draw;
use crate::drive::Drive;
use crate::heat::{AIR_C, Heat, Temperatures};
use crate::hidden::{self, DamperEffect, RandomEffect};
use crate::neutral::{Line, Neutral, OWN, Rest, System};
use crate::sensors::Sensors;
use crate::solver::Integrator;
use crate::{Campaign, Matrix, Options, Record, RigError, TestPoint};

/// Largest accepted strength of an effect, in typical strong cases. The search for a severity ends far below it.
///
/// Test: `unknown_names_forms_and_strengths_are_refused`.
const STRONGEST: f64 = 1000.0;

/// Smallest number of samples per cycle at the default sample rate, unless the highest of [`RATES_HZ`] limits this
/// rate.
///
/// This number is lower than on a common rig, so that files are short, but sufficient for 25 Hz.
const SAMPLES_PER_CYCLE: f64 = 100.0;
/// Sample rates with sample times in whole microseconds, Hz.
const RATES_HZ: [f64; 22] = [
    1.0, 2.0, 4.0, 5.0, 8.0, 10.0, 16.0, 20.0, 25.0, 32.0, 40.0, 50.0, 80.0, 100.0, 125.0, 200.0, 250.0, 400.0, 500.0,
    1000.0, 1250.0, 2500.0,
];
/// Default sample rate of road-like motions, Hz.
const ROAD_RATE_HZ: f64 = 500.0;
/// Range of pauses between tests, s.
const PAUSE_S: (f64, f64) = (3.0, 12.0);
/// Offset of the sample times from the reversals of the motion, in sample intervals. Without the offset, the velocity
/// of a sample at a reversal would be exactly zero.
const SAMPLE_OFFSET: f64 = 0.37;

impl InjectedCase {
    /// Makes a case without injected effects: the neutral damper of a seed.
    pub fn nothing(seed: u64) -> Self {
        Self { options: Options { seed, ..Options::default() }, ..Self::default() }
    }

    /// Adds an injected effect.
    #[must_use]
    pub fn hiding(mut self, name: &str, strength: f64) -> Self {
        self.effects.push((name.into(), strength));
        self
    }

    /// Runs the case on its plan in one thread; several cases can run in parallel.
    ///
    /// # Errors
    /// [`RigError::Option`] for unknown effects, negative strengths and options out of range; [`RigError::Motion`] if a
    /// test cannot be simulated.
    pub fn run(&self) -> Result<InjectedCampaign, RigError> {
        let order = self.options.order.unwrap_or(self.options.seed);
        self.run_matrix(&self.plan.matrix(order), |_, _| {})
    }

    /// Runs the case on a test matrix instead of its plan, in the order of the matrix. `progress` is called with the
    /// numbers of completed tests and of all tests.
    ///
    /// # Errors
    /// Returns the errors of [`InjectedCase::run`].
    pub fn run_matrix(&self, matrix: &Matrix, progress: impl Fn(usize, usize)) -> Result<InjectedCampaign, RigError> {
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
            if drawn.iter().any(|other: &RandomEffect| other.name == effect.name) {
                return Err(RigError::Option { option: "hide", problem: format!("'{}' is listed twice", effect.name) });
            }
            drawn.push(effect);
        }
        let truth = truth(seed, &drawn, draw.values);
        // An effect of strength 0 is omitted, so that the records equal those of the neutral damper bit for bit.
        let hidden: Vec<Box<dyn DamperEffect>> =
            drawn.into_iter().filter(|effect| effect.strength > 0.0).map(|drawn| drawn.effect).collect();

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
        Ok(InjectedCampaign { campaign: Campaign { options: self.options.clone(), records, sealed: true }, truth })
    }
}

fn check_strength(name: &str, strength: f64) -> Result<(), RigError> {
    if (0.0..=STRONGEST).contains(&strength) {
        return Ok(());
    }
    let number = format_number(strength);
    Err(RigError::Option { option: "hide", problem: format!("strength {number} of '{name}'; give 0 to {STRONGEST}") })
}

fn truth(seed: u64, drawn: &[RandomEffect], damper: Vec<(String, f64)>) -> Truth {
    // If a name is drawn several times, such as the fraction of each element, a number is appended to the name.
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
            .map(|effect| InjectedEffect {
                name: effect.name.into(),
                form: effect.form.into(),
                strength: effect.strength,
                shapes: named(&effect.shapes),
            })
            .collect(),
        damper: named(&damper),
    }
}

/// A test with its start time in the campaign.
struct Scheduled<'a> {
    point: &'a TestPoint,
    drive: Drive,
    rate_hz: f64,
    /// Time of the first sample since the start of the campaign, s.
    clock_s: f64,
    /// Pause before the test, s.
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
            // The start time is rounded up to whole milliseconds, so that all times are exact in a file with six
            // decimals.
            clock_s = f64::ceil((clock_s + pause_s) * 1e3) / 1e3;
            let test = Scheduled { point, rate_hz: options.sample_rate_hz.unwrap_or(usual), clock_s, pause_s, drive };
            clock_s += test.drive.duration_s();
            test
        })
        .collect()
}

/// The damper on the rig with its injected effects.
struct Rig<'a> {
    neutral: &'a Neutral,
    heat: &'a Heat,
    hidden: &'a [Box<dyn DamperEffect>],
    options: &'a Options,
}

/// States that continue from one test to the next.
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
            // The number of states of the solver is a compile-time constant, so it is rounded up. Surplus states stay
            // at zero.
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
        let system = System::<N> { neutral: self.neutral, effects: self.hidden, first, oil_c: &oil_c };
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
        let displacement_m = point.mean_displacement_m;
        let rest = Rest { displacement_m, rod_n: self.neutral.rest_n(displacement_m) };
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{EFFECTS, Plan, UNKNOWN_EFFECTS};
    use std::f64::consts::TAU;

    fn sine(amplitude_m: f64, frequency_hz: f64) -> TestPoint {
        let name = format!("a{:.1}mm_f{frequency_hz}hz", amplitude_m * 1e3);
        TestPoint { cycles: 2, ..TestPoint::at_peak_velocity(name, amplitude_m, TAU * amplitude_m * frequency_hz) }
    }

    fn matrix() -> Matrix {
        let side = TestPoint { side_force_n: 800.0, name: "side".into(), ..sine(0.02, 0.8) };
        let out = TestPoint { mean_displacement_m: 0.02, name: "out".into(), ..sine(0.025, 2.0) };
        let inward = TestPoint { mean_displacement_m: -0.02, name: "in".into(), ..sine(0.025, 2.0) };
        Matrix::new(vec![sine(0.02, 0.1), sine(0.025, 5.0), side, sine(0.0008, 1.0), out, sine(0.003, 20.0), inward])
            .unwrap()
    }

    fn ideal(seed: u64, effects: &[(&str, f64)]) -> InjectedCase {
        InjectedCase {
            effects: effects.iter().map(|(name, strength)| ((*name).into(), *strength)).collect(),
            options: Options { seed, noise_percent: 0.0, ..Options::default() },
            ..InjectedCase::default()
        }
    }

    fn measured(seed: u64, effects: &[(&str, f64)]) -> Vec<Record> {
        ideal(seed, effects).run_matrix(&matrix(), |_, _| {}).unwrap().campaign.records
    }

    /// Computes the root mean square difference of the noise-free forces of two campaigns, N.
    fn distance(a: &[Record], b: &[Record]) -> f64 {
        let squares = |f: &dyn Fn(&Record, &Record, usize) -> f64| -> f64 {
            a.iter().zip(b).map(|(a, b)| (0..a.time_s.len()).map(|i| f(a, b, i)).sum::<f64>()).sum()
        };
        (squares(&|a, b, i| (a.clean_force_n[i] - b.clean_force_n[i]).powi(2)) / squares(&|_, _, _| 1.0)).sqrt()
    }

    fn all() -> impl Iterator<Item = &'static str> {
        EFFECTS.into_iter().chain(UNKNOWN_EFFECTS)
    }

    #[test]
    fn strength_zero_is_the_neutral_damper_to_the_bit() {
        let neutral = measured(3, &[]);
        for name in all() {
            assert_eq!(measured(3, &[(name, 0.0)]), neutral, "{name}");
        }
    }

    #[test]
    fn the_trace_of_an_effect_grows_with_its_strength_from_nothing() {
        for seed in [1, 2] {
            let neutral = measured(seed, &[]);
            for name in all() {
                let trace = |strength| distance(&measured(seed, &[(name, strength)]), &neutral);
                let traces = [0.01, 0.25, 1.0, 4.0].map(trace);
                assert!(traces[3] > 1.0, "{name}, seed {seed}: {traces:?}");
                assert!(traces[0] < 0.25 * traces[3], "{name}, seed {seed}: {traces:?}");
                assert!(traces.windows(2).all(|two| two[0] <= two[1] + 0.02), "{name}, seed {seed}: {traces:?}");
            }
        }
    }

    #[test]
    fn a_passive_damper_takes_energy_in_every_cycle() {
        // The measurement errors of the rig are excluded, because they are no passive forces. A mass need not be
        // excluded, because it returns the energy that it stores.
        let physical = EFFECTS.iter().filter(|name| !["channel_delay", "force_offset", "force_drift"].contains(name));
        for name in physical {
            for record in measured(4, &[(name, 1.0)]) {
                let per_cycle = (record.sample_rate_hz / record.point.frequency_hz).round() as usize;
                let last = record.time_s.len() - 1;
                let end = last - (0.3 * last as f64) as usize;
                let work: f64 = (end - per_cycle..end)
                    .map(|i| {
                        0.5 * (record.force_n[i] + record.force_n[i + 1])
                            * (record.displacement_m[i + 1] - record.displacement_m[i])
                    })
                    .sum();
                assert!(work > 0.0, "{name} in {}: {work} J", record.point.name);
            }
        }
    }

    #[test]
    fn cases_are_the_same_whatever_runs_beside_them() {
        let case = ideal(5, &[("temperature_fade", 1.0), ("free_play", 1.0), ("aeration", 1.0)]);
        let alone = case.run_matrix(&matrix(), |_, _| {}).unwrap();
        let both: Vec<InjectedCampaign> = std::thread::scope(|scope| {
            let runs: Vec<_> = (0..2).map(|_| scope.spawn(|| case.run_matrix(&matrix(), |_, _| {}).unwrap())).collect();
            runs.into_iter().map(|run| run.join().unwrap()).collect()
        });
        assert!(both.iter().all(|other| *other == alone));
    }

    #[test]
    fn damper_and_shapes_do_not_depend_on_what_else_is_hidden() {
        let one = ideal(6, &[("free_play", 1.0)]).run_matrix(&matrix(), |_, _| {}).unwrap().truth;
        let two = ideal(6, &[("aeration", 0.5), ("free_play", 2.0)]).run_matrix(&matrix(), |_, _| {}).unwrap().truth;
        assert_eq!(one.damper, two.damper);
        assert_eq!(one.effects[0].form, two.effects[1].form);
    }

    #[test]
    fn records_follow_each_other_on_one_clock() {
        let records = measured(1, &[]);
        for pair in records.windows(2) {
            let pause = pair[1].time_s[0] - pair[0].time_s[pair[0].time_s.len() - 1];
            assert!((PAUSE_S.0..PAUSE_S.1 + 1.1).contains(&pause), "{pause}");
        }
        assert!(records[1].time_s[0] > 10.0);
    }

    #[test]
    fn channels_can_be_withheld_and_noise_leaves_the_clean_force() {
        let mut case = ideal(2, &[]);
        let clean = case.run_matrix(&matrix(), |_, _| {}).unwrap().campaign.records;
        assert!(clean.iter().all(|record| record.side_force_n.is_some() && record.temperature_c.is_some()));
        case.options = Options {
            noise_percent: 2.0,
            noise_colour: 0.8,
            hum_n: 1.0,
            bits: Some(14),
            side_force_channel: false,
            temperature_channel: false,
            ..case.options
        };
        for (noisy, clean) in case.run_matrix(&matrix(), |_, _| {}).unwrap().campaign.records.iter().zip(&clean) {
            assert!(noisy.side_force_n.is_none() && noisy.temperature_c.is_none());
            assert_eq!(noisy.clean_force_n, clean.clean_force_n);
            assert_ne!(noisy.force_n, noisy.clean_force_n);
        }
    }

    #[test]
    fn a_hot_start_changes_a_damper_that_fades_and_no_other() {
        let run = |effects: &[(&str, f64)], celsius| {
            let mut case = ideal(7, effects);
            case.options.start_temperature_c = celsius;
            case.run_matrix(&matrix(), |_, _| {}).unwrap().campaign.records
        };
        assert_eq!(distance(&run(&[], None), &run(&[], Some(70.0))), 0.0);
        let (cold, hot) = (run(&[("temperature_fade", 1.0)], None), run(&[("temperature_fade", 1.0)], Some(70.0)));
        let largest = |record: &Record| record.clean_force_n.iter().fold(0f64, |most, n| most.max(n.abs()));
        assert!(largest(&hot[0]) < largest(&cold[0]));
        assert!(hot[0].temperature_c.as_ref().unwrap()[0] == 70.0);
    }

    #[test]
    fn unknown_names_forms_and_strengths_are_refused() {
        let refusal = |name: &str, strength| {
            ideal(1, &[(name, strength)]).run_matrix(&matrix(), |_, _| {}).unwrap_err().to_string()
        };
        assert!(refusal("wobble", 1.0).contains("gas_spring, stribeck_friction"));
        assert!(refusal("aeration:foam", 1.0).contains("entrained, dissolving_foam"));
        for strength in [-1.0, 1001.0, 1e308, -1e308, f64::NAN, f64::INFINITY] {
            let message = refusal("aeration", strength);
            assert!(message.contains("'aeration'; give 0 to 1000") && message.len() < 300, "{message}");
        }
        let twice = ideal(1, &[("aeration", 1.0), ("aeration", 1.0)]).run_matrix(&matrix(), |_, _| {}).unwrap_err();
        assert!(twice.to_string().contains("listed twice"));
    }

    #[test]
    fn sealed_truth_reads_back_and_the_description_is_silent() {
        let folder = tempfile::tempdir().unwrap();
        let outcome = ideal(8, &[("cavitation", 1.0)]).run_matrix(&matrix(), |_, _| {}).unwrap();
        outcome.write(folder.path()).unwrap();
        assert_eq!(Truth::read(folder.path()).unwrap(), outcome.truth);
        let text = std::fs::read_to_string(folder.path().join(crate::campaign::CAMPAIGN_FILE)).unwrap();
        assert!(!text.contains("seed") && !text.contains("cavitation") && !text.contains("hide"), "{text}");
        let clean = folder.path().join(super::super::SEALED_FOLDER).join(super::super::CLEAN_FORCE_FILE);
        let samples: usize = outcome.campaign.records.iter().map(|record| record.time_s.len()).sum();
        assert_eq!(std::fs::read_to_string(clean).unwrap().lines().count(), samples + 1);
        // A campaign without injected effects removes the truth of an earlier campaign.
        let plain = Campaign::run(&matrix(), &Options { sample_rate_hz: Some(200.0), ..Options::default() }, |_, _| {});
        plain.unwrap().write(folder.path()).unwrap();
        assert!(!folder.path().join(super::super::SEALED_FOLDER).exists());
    }

    #[test]
    fn every_plan_can_be_run() {
        for plan in [Plan::OneAmplitude, Plan::OneFrequency, Plan::Centred] {
            let case = InjectedCase { plan, ..ideal(9, &[("presliding_friction", 1.0)]) };
            assert!(case.run().unwrap().campaign.records.len() >= 8);
        }
    }
}
