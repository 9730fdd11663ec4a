//! Execution of the tests of a test matrix on one damper, with checks of the options.

use std::sync::atomic::{AtomicUsize, Ordering};

use dashpot_messages::format_number;
use rayon::prelude::*;

use super::{Campaign, Options, Record};
use crate::damper::{Damper, Excitation, State};
use crate::drive::Drive;
use crate::sensors::Sensors;
use crate::solver::Integrator;
use crate::{Matrix, RigError, TestPoint};

/// Smallest number of samples per cycle at the default sample rate, unless [`HIGHEST_DEFAULT_RATE_HZ`] limits this
/// rate.
pub const SAMPLES_PER_CYCLE: f64 = 400.0;
/// Highest sample rate chosen by default, Hz.
pub const HIGHEST_DEFAULT_RATE_HZ: f64 = 1000.0;
/// Lowest sample rate chosen by default, Hz.
pub const LOWEST_DEFAULT_RATE_HZ: f64 = 20.0;

/// Default sample rates, Hz. Their sample times are whole microseconds, and thus exact in a file with six decimals.
const RATES_HZ: [f64; 13] = [20.0, 25.0, 32.0, 40.0, 50.0, 80.0, 100.0, 125.0, 200.0, 250.0, 400.0, 500.0, 1000.0];
/// Lowest and highest accepted sample rate, Hz.
const RATE_RANGE_HZ: (f64, f64) = (1.0, 20_000.0);
/// Largest accepted number of samples of a record. A longer record indicates a mistake in the options.
const LONGEST_RECORD: f64 = 5e6;
/// Smallest accepted number of samples per cycle. With fewer samples a record does not represent a sine.
const LEAST_PER_CYCLE: f64 = 8.0;
/// Largest accepted noise, percent of the test's rms force.
const NOISE_LIMIT_PERCENT: f64 = 100.0;

/// Largest accepted correlation between successive samples of colored noise.
const COLOUR_LIMIT: f64 = 0.99;
/// Largest accepted amplitude of mains hum, N.
const HUM_LIMIT_N: f64 = 1000.0;
/// Accepted numbers of bits of the force channel's analog-to-digital converter.
const BITS: std::ops::RangeInclusive<u32> = 8..=24;
/// Accepted initial temperatures of a damper, °C.
const TEMPERATURES_C: std::ops::RangeInclusive<f64> = -40.0..=120.0;

/// Returns the default sample rate, Hz, for a test.
///
/// The rate gives at least 400 samples per cycle and is rounded up to a common rate, within 20 to 1000 Hz. Above 2.5
/// Hz, the upper limit gives fewer samples per cycle. The lower limit lets a slow test resolve the break-away of
/// friction. The upper limit is the rate of a common data logger.
pub fn default_sample_rate_hz(frequency_hz: f64) -> f64 {
    let wanted = SAMPLES_PER_CYCLE * frequency_hz;
    RATES_HZ.into_iter().find(|rate| *rate >= wanted).unwrap_or(HIGHEST_DEFAULT_RATE_HZ)
}

impl Campaign {
    /// Runs all tests of the test matrix on the damper of the seed in `options`.
    ///
    /// After each test, `progress` is called with the numbers of completed tests and of all tests, from any thread and
    /// in any order. The result does not depend on the order of the tests and the number of threads.
    ///
    /// # Errors
    /// [`RigError::Option`] if an option is out of range, [`RigError::Motion`] if a test cannot be simulated.
    pub fn run(matrix: &Matrix, options: &Options, progress: impl Fn(usize, usize) + Sync) -> Result<Self, RigError> {
        Self::run_on(&Damper::seeded(options.seed), matrix, options, progress)
    }

    /// Runs all tests of the test matrix on a given damper. The seed in `options` then determines only the noise.
    ///
    /// # Errors
    /// Returns the errors of [`Campaign::run`].
    pub fn run_on(
        damper: &Damper,
        matrix: &Matrix,
        options: &Options,
        progress: impl Fn(usize, usize) + Sync,
    ) -> Result<Self, RigError> {
        check(matrix, options)?;
        let pool =
            rayon::ThreadPoolBuilder::new().num_threads(options.threads.unwrap_or(0)).build().map_err(|error| {
                RigError::Option {
                    option: "threads",
                    problem: format!("the worker threads could not be started: {error}"),
                }
            })?;
        let total = matrix.points().len();
        let done = AtomicUsize::new(0);
        let with_side_force = matrix.has_side_force() && options.side_force_channel;
        let records: Vec<Result<Record, RigError>> = pool.install(|| {
            matrix
                .points()
                .par_iter()
                // Schedule each test separately, because test durations differ by a factor of a hundred.
                .with_max_len(1)
                .map(|point| {
                    let record = measure(damper, point, options, with_side_force);
                    progress(done.fetch_add(1, Ordering::Relaxed) + 1, total);
                    record
                })
                .collect()
        });
        // Collect all results first, so that the reported error does not depend on the order of execution.
        let mut records: Vec<Record> = records.into_iter().collect::<Result<_, _>>()?;
        let peak = records.iter().flat_map(|record| &record.clean_force_n).fold(0f64, |peak, n| peak.max(n.abs()));
        pool.install(|| {
            records.par_iter_mut().for_each(|record| {
                let full_cycles = Drive::new(&record.point).full_cycles_s();
                let name = record.point.name.clone();
                Sensors::new(options, &name).disturb_record(record, full_cycles, 0.0, peak);
            });
        });
        Ok(Self { options: options.clone(), records, sealed: false })
    }
}

pub(crate) fn check(matrix: &Matrix, options: &Options) -> Result<(), RigError> {
    let fail = |option, problem| Err(RigError::Option { option, problem });
    let noise = options.noise_percent;
    if !(0.0..=NOISE_LIMIT_PERCENT).contains(&noise) {
        return fail("noise", format!("{} %; give 0 to {NOISE_LIMIT_PERCENT} %", format_number(noise)));
    }
    if i64::try_from(options.seed).is_err() {
        // `campaign.toml` contains the seed, and the largest integer of TOML is that of `i64`.
        return fail("seed", format!("{}; give 0 to {}", options.seed, i64::MAX));
    }
    if options.threads == Some(0) {
        return fail("threads", "0 threads; give at least 1".into());
    }
    if !(0.0..=COLOUR_LIMIT).contains(&options.noise_colour) {
        return fail(
            "noise colour",
            format!("{}; give 0 (white) to {COLOUR_LIMIT}", format_number(options.noise_colour)),
        );
    }
    if !(0.0..=HUM_LIMIT_N).contains(&options.hum_n) {
        return fail("hum", format!("{} N; give 0 to {HUM_LIMIT_N} N", format_number(options.hum_n)));
    }
    if let Some(bits) = options.bits.filter(|bits| !BITS.contains(bits)) {
        return fail("bits", format!("{bits} bits; give {} to {}", BITS.start(), BITS.end()));
    }
    if let Some(celsius) = options.start_temperature_c.filter(|celsius| !TEMPERATURES_C.contains(celsius)) {
        let (low, high) = (TEMPERATURES_C.start(), TEMPERATURES_C.end());
        return fail("start temperature", format!("{} °C; give {low} to {high} °C", format_number(celsius)));
    }
    let Some(rate) = options.sample_rate_hz else {
        return Ok(());
    };
    let (low, high) = RATE_RANGE_HZ;
    if !(low..=high).contains(&rate) {
        return fail("sample rate", format!("{} Hz; give {low} to {high} Hz", format_number(rate)));
    }
    for point in matrix.points() {
        if rate < LEAST_PER_CYCLE * point.frequency_hz {
            return fail(
                "sample rate",
                format!(
                    "{rate} Hz shows fewer than {LEAST_PER_CYCLE} samples per cycle of test '{}' ({:.3} Hz); raise the rate",
                    point.name, point.frequency_hz
                ),
            );
        }
        let samples = rate * Drive::new(point).duration_s();
        if samples > LONGEST_RECORD {
            return fail(
                "sample rate",
                format!(
                    "{rate} Hz makes {samples:.0} samples of test '{}'; lower the rate (at most {LONGEST_RECORD:.0} samples per test)",
                    point.name
                ),
            );
        }
    }
    Ok(())
}

/// Simulates the record of one test, from standstill to standstill, without noise.
fn measure(damper: &Damper, point: &TestPoint, options: &Options, with_side_force: bool) -> Result<Record, RigError> {
    let drive = Drive::new(point);
    let excitation = |time: f64| {
        let (displacement_m, velocity_m_s) = drive.motion(time);
        Excitation { displacement_m, velocity_m_s, side_force_n: point.side_force_n }
    };
    let sample_rate_hz = options.sample_rate_hz.unwrap_or_else(|| default_sample_rate_hz(point.frequency_hz));
    let count = (drive.duration_s() * sample_rate_hz).floor() as usize + 1;
    let mut record = Record::empty(point, sample_rate_hz, count);
    record.side_force_n = with_side_force.then(|| vec![point.side_force_n; count]);

    let mut motion = Integrator::new(
        |time, state: &State| damper.rates(state, &excitation(time)),
        0.0,
        damper.at_rest(point.mean_displacement_m),
        Damper::tolerance(),
    );
    for index in 0..count {
        let time = index as f64 / sample_rate_hz;
        motion.advance_to(time).map_err(|stuck| RigError::Motion {
            test: point.name.clone(),
            time_s: stuck.time_s,
            problem: stuck.reason.into(),
        })?;
        let input = excitation(time);
        record.time_s.push(time);
        record.displacement_m.push(input.displacement_m);
        record.velocity_m_s.push(input.velocity_m_s);
        record.force_n.push(damper.force_n(motion.state()));
    }

    record.clean_force_n.clone_from(&record.force_n);
    Ok(record)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::MatrixOptions;

    fn small_matrix() -> Matrix {
        Matrix::thesis(&MatrixOptions {
            amplitudes_m: vec![0.02],
            peak_velocities_m_s: vec![0.25, 1.0],
            slow_tests: false,
            ..MatrixOptions::default()
        })
        .unwrap()
    }

    fn ideal() -> Options {
        Options { noise_percent: 0.0, ..Options::default() }
    }

    #[test]
    fn default_rates_give_exact_times_and_enough_samples() {
        for point in Matrix::default().points() {
            let rate = default_sample_rate_hz(point.frequency_hz);
            assert!((LOWEST_DEFAULT_RATE_HZ..=HIGHEST_DEFAULT_RATE_HZ).contains(&rate));
            assert!(rate >= SAMPLES_PER_CYCLE * point.frequency_hz || rate == HIGHEST_DEFAULT_RATE_HZ);
            assert_eq!((1e6 / rate).fract(), 0.0);
        }
    }

    #[test]
    fn noise_has_the_stated_size_on_every_channel() {
        let matrix = small_matrix();
        let clean = Campaign::run(&matrix, &ideal(), |_, _| {}).unwrap();
        let noisy = Campaign::run(&matrix, &Options { noise_percent: 2.0, sample_rate_hz: None, ..ideal() }, |_, _| {})
            .unwrap();
        for (clean, noisy) in clean.records.iter().zip(&noisy.records) {
            let deviation = |a: &[f64], b: &[f64]| {
                (a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum::<f64>() / a.len() as f64).sqrt()
            };
            let rms = clean.rms_n(Drive::new(&clean.point).full_cycles_s());
            for (measured, stated) in [
                (deviation(&clean.force_n, &noisy.force_n), 0.02 * rms + 0.5),
                (deviation(&clean.displacement_m, &noisy.displacement_m), 2e-6),
                (deviation(&clean.velocity_m_s, &noisy.velocity_m_s), 1e-3 * clean.point.peak_velocity_m_s),
            ] {
                let error = 4.0 / (2.0 * clean.time_s.len() as f64).sqrt();
                assert!((measured / stated - 1.0).abs() < error, "{measured} against {stated}");
            }
        }
    }

    #[test]
    fn a_test_does_not_depend_on_its_company() {
        let matrix = small_matrix();
        let both = Campaign::run(&matrix, &Options::default(), |_, _| {}).unwrap();
        let reversed = Matrix::new(matrix.points().iter().rev().cloned().collect()).unwrap();
        let other = Campaign::run(&reversed, &Options { threads: Some(1), ..Options::default() }, |_, _| {}).unwrap();
        assert_eq!(both.records[0], other.records[1]);
        assert_eq!(both.records[1], other.records[0]);
    }

    #[test]
    fn progress_counts_every_test() {
        let last = AtomicUsize::new(0);
        Campaign::run(&small_matrix(), &ideal(), |done, total| {
            assert_eq!(total, 2);
            last.fetch_max(done, Ordering::Relaxed);
        })
        .unwrap();
        assert_eq!(last.into_inner(), 2);
    }

    #[test]
    fn options_out_of_range_are_named() {
        for (options, words) in [
            (Options { noise_percent: -1.0, ..ideal() }, "option noise"),
            (Options { noise_percent: f64::NAN, ..ideal() }, "option noise"),
            (Options { sample_rate_hz: Some(0.0), ..ideal() }, "option sample rate: 0 Hz"),
            (Options { sample_rate_hz: Some(20.0), ..ideal() }, "fewer than 8 samples per cycle"),
            (Options { threads: Some(0), ..ideal() }, "option threads"),
            (Options { seed: u64::MAX, ..ideal() }, "option seed"),
        ] {
            let message = Campaign::run(&small_matrix(), &options, |_, _| {}).unwrap_err().to_string();
            assert!(message.contains(words), "{message}");
        }
        for value in [1e308, -1e308, f64::NAN, f64::INFINITY] {
            for (options, words) in [
                (Options { noise_percent: value, ..ideal() }, "option noise: "),
                (Options { sample_rate_hz: Some(value), ..ideal() }, "option sample rate: "),
                (Options { noise_colour: value, ..ideal() }, "option noise colour: "),
                (Options { hum_n: value, ..ideal() }, "option hum: "),
                (Options { start_temperature_c: Some(value), ..ideal() }, "option start temperature: "),
            ] {
                let message = Campaign::run(&small_matrix(), &options, |_, _| {}).unwrap_err().to_string();
                let named = format!("{words}{}", format_number(value));
                assert!(message.starts_with(&named) && message.len() < 300, "{message}");
            }
        }
        let slow = Matrix::default();
        let message = Campaign::run(&slow, &Options { sample_rate_hz: Some(20e3), ..ideal() }, |_, _| {})
            .unwrap_err()
            .to_string();
        assert!(message.contains("lower the rate"), "{message}");
    }
}
