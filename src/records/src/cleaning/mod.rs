//! Cleaning of one test. Every step makes the repairs that are safe, notes them with figures, and rejects unreliable
//! data.

mod clipped;
pub(crate) mod corrections;
mod cycles;
mod drift;
mod duplicates;
mod frozen;
mod gaps;
mod missing;
mod order;
mod outliers;
mod rests;
pub(crate) mod set_to;
mod settings;
mod stairs;
pub(crate) mod still;
pub(crate) mod swapped_columns;
mod trim;

use crate::data::complete_test::{CompleteTest, steady};
use crate::data::cycle::Cycle;
use crate::data::measurement_error::MeasurementError;
use crate::data::record::{Note, Record};
use crate::data::rig_frame::RigFrame;
use crate::data::samples::Samples;
use crate::error::{RecordError, SampleError};
use crate::messages::phrases;
use crate::numbers::{range, sample_time};
use crate::options::Options;
use crate::quantities::channel::Channel;
use crate::signal::measurement_correction::correct_inertia;
use crate::signal::{consistency, derivative, noise};
use dashpot_messages::{Sentence, format_decimals};

use crate::tuning::cleaning::{BY_CHANCE, FEWEST, WINDOW_NO_CYCLE, WINDOW_OF_CYCLE};
pub(crate) use clipped::Reach;
pub(crate) use corrections::delay_motion;
#[cfg(test)]
pub(crate) use cycles::find as find_cycles;
pub(crate) use cycles::{robust_peak, turning_points};
pub(crate) use drift::time_mean;

/// Sorts the rows and splits the record into tests.
///
/// Drops repeated rows, rows of an earlier run and rows with missing values, and orders the time stamps. Splits at gaps
/// in time, at standstills between tests, and at changes of amplitude, frequency or speed without a standstill. Cuts
/// off the start of a test in which a slow supply brings the setting to its value.
pub(crate) fn sort_out(mut samples: Samples, options: &Options) -> Result<Vec<Samples>, RecordError> {
    enough(&samples)?;
    missing::forget_overflows(&mut samples);
    swapped_columns::reject(&samples, options)?;
    missing::drop_rows(&mut samples)?;
    order::drop_stale(&mut samples);
    duplicates::remove(&mut samples);
    order::restore(&mut samples)?;
    Ok(gaps::split(samples)
        .into_iter()
        .flat_map(rests::split)
        .flat_map(stairs::split)
        .flat_map(settings::split)
        .map(|part| set_to::drop_start(part, &options.settings))
        .collect())
}

/// Cleans a single test with all steps that precede the determination of its campaign's positive direction.
#[cfg(test)]
pub(crate) fn repair(samples: Samples, options: &Options) -> Result<CompleteTest, RecordError> {
    let mut pieces = sort_out(samples, options)?;
    assert_eq!(pieces.len(), 1, "gaps in {pieces:?}");
    mend(pieces.remove(0), options, &Reach::default())
}

/// Cleans a test before the sign convention of its campaign (positive in rebound or in compression) is determined.
/// Repairs single samples, derives a missing motion channel and applies the user's corrections. `reach` is the range of
/// the motion over all tests of the campaign.
pub(crate) fn mend(mut samples: Samples, options: &Options, reach: &Reach) -> Result<CompleteTest, RecordError> {
    enough(&samples)?;
    still::reject(&samples)?;
    frozen::reject(&samples)?;
    still::reject_constant_force(&samples)?;
    let without_force = clipped::deal(&mut samples, reach)?;
    let replaced = outliers::replace(&mut samples);
    corrections::calibrate(&mut samples, options);
    let before = samples.notes.len();
    let CompleteMotion { displacement, velocity, cycles, velocity_window_s } = complete(&mut samples, options)?;
    // The spikes of a velocity that is not used are irrelevant.
    let used = replaced.into_iter().filter(|(channel, _)| *channel != Channel::Velocity || velocity_window_s == 0.0);
    samples.notes.splice(before..before, used.map(|(_, text)| Note { kind: "outlier", text }));
    let (setting, setting_signal) = set_to::take(&mut samples, &options.settings);
    let mut motion = CompleteTest {
        at: samples.at,
        name: samples.name,
        time: samples.time,
        begins: samples.begins,
        about: samples.about.clone(),
        displacement,
        velocity,
        velocity_window_s,
        force: samples.force,
        side_force: samples.side_force,
        temperature: samples.temperature,
        setting,
        setting_signal,
        cycles,
        stated_error: MeasurementError::NONE,
        notes: samples.notes,
    };
    let partnered = corrections::apply(&mut motion, options);
    let without_force =
        &without_force[partnered.start.min(without_force.len())..partnered.end.min(without_force.len())];
    if motion.time.len() < FEWEST {
        return Err(SampleError::TooFew { at: motion.at, samples: motion.time.len(), needed: FEWEST }.into());
    }
    if without_force.contains(&true) {
        let drop = |values: &mut Vec<f64>| {
            let mut at = without_force.iter();
            values.retain(|_| at.next() == Some(&false));
        };
        for values in [&mut motion.time, &mut motion.displacement, &mut motion.velocity, &mut motion.force] {
            drop(values);
        }
        let signal = motion.setting_signal.as_mut().map(|signal| &mut signal.values);
        for values in [motion.side_force.as_mut(), motion.temperature.as_mut(), signal].into_iter().flatten() {
            drop(values);
        }
        motion.cycles = cycles::find(&motion.time, &motion.displacement);
    }
    Ok(motion)
}

fn enough(samples: &Samples) -> Result<(), RecordError> {
    if samples.len() < FEWEST {
        return Err(SampleError::TooFew { at: samples.at.clone(), samples: samples.len(), needed: FEWEST }.into());
    }
    Ok(())
}

/// Displacement and velocity, with the cycles of the displacement.
struct CompleteMotion {
    displacement: Vec<f64>,
    velocity: Vec<f64>,
    cycles: Vec<Cycle>,
    /// Length of the window for deriving the velocity from the displacement, s; 0 if the recorded velocity is used.
    velocity_window_s: f64,
}

/// Completes the motion: derives a missing channel, or compares the two channels.
fn complete(samples: &mut Samples, options: &Options) -> Result<CompleteMotion, RecordError> {
    match (samples.displacement.take(), samples.velocity.take()) {
        (Some(displacement), Some(velocity)) => {
            let cycles = cycles::find(&samples.time, &displacement);
            let span = steady(&cycles, samples.len());
            let agreement =
                consistency::compare(&samples.time[span.clone()], &displacement[span.clone()], &velocity[span]);
            if let Some(agreement) = agreement {
                let period = cycles
                    .first()
                    .zip(cycles.last())
                    .map(|(first, last)| (last.end_time - first.start_time) / cycles.len() as f64);
                if consistency::is_delayed(&agreement, sample_time(&samples.time), period) {
                    samples.note(
                        "late_velocity",
                        Sentence::from(phrases::VELOCITY_LATE)
                            .with("column", samples.heading(Channel::Velocity))
                            .with("lag", format_decimals(1e3 * agreement.lag.abs(), 2))
                            .with_sentence("side", if agreement.lag > 0.0 { phrases::BEHIND } else { phrases::AHEAD }),
                    );
                    return Ok(differentiated(samples, displacement));
                }
                if let Some(cause) = consistency::contradiction(&agreement, &samples.units) {
                    return Err(SampleError::Contradiction { at: samples.at.clone(), cause }.into());
                }
                samples.note(
                    "consistency",
                    Sentence::from(phrases::CONSISTENT)
                        .with("gain", format_decimals(agreement.gain, 4))
                        .with_sentence("lag", describe_lag(agreement.lag))
                        .with("percent", format_decimals(100.0 * (1.0 - agreement.explained).max(0.0), 3)),
                );
            }
            Ok(CompleteMotion { displacement, velocity, cycles, velocity_window_s: 0.0 })
        }
        (Some(displacement), None) => Ok(differentiated(samples, displacement)),
        (None, Some(velocity)) => Ok(integrated(samples, velocity, options.initial_position)),
        // The table layout requires a motion channel, and cleaning drops at most one of two motion channels. This case
        // therefore does not occur.
        (None, None) => Err(SampleError::NoData { at: samples.at.clone() }.into()),
    }
}

/// Formats the lag of the velocity behind the derivative of the displacement, s. A lag that rounds to zero has no sign.
fn describe_lag(lag: f64) -> Sentence {
    let shown = format_decimals(1e3 * lag.abs(), 2);
    match lag {
        _ if shown == "0.00" => phrases::NO_LAG.into(),
        lag if lag > 0.0 => Sentence::from(phrases::LAGS).with("lag", shown),
        _ => Sentence::from(phrases::LEADS).with("lag", shown),
    }
}

/// Derives the velocity from the displacement.
fn differentiated(samples: &mut Samples, displacement: Vec<f64>) -> CompleteMotion {
    let cycles = cycles::find(&samples.time, &displacement);
    let window = match cycles.len() {
        0 => WINDOW_NO_CYCLE,
        n => WINDOW_OF_CYCLE * (cycles[n - 1].end_time - cycles[0].start_time) / n as f64,
    };
    let (velocity, filter) = derivative::differentiate(&samples.time, &displacement, window);
    let shorter = (filter.shorter > BY_CHANCE)
        .then(|| Sentence::from(phrases::SHORTER).with("percent", format_decimals(100.0 * filter.shorter, 0)));
    samples.note(
        "derived",
        Sentence::from(phrases::DIFFERENTIATED)
            .with("points", filter.points)
            .with("window", format_decimals(filter.window, 4))
            .with("frequency", format_decimals(filter.bandwidth, 1))
            .with_any("shorter", shorter),
    );
    CompleteMotion { displacement, velocity, cycles, velocity_window_s: filter.window }
}

/// Derives the displacement from the velocity. Subtracts the velocity offset, which would integrate to a drift. The
/// offset is the mean over whole cycles, because the damper returns to its position in every cycle.
fn integrated(samples: &mut Samples, mut velocity: Vec<f64>, initial: f64) -> CompleteMotion {
    let time = &samples.time;
    let n = time.len();
    let mut cycles = Vec::new();
    let mut removed = 0.0;
    // The first iteration removes the offset of the whole record. The others remove the residual offset over whole
    // cycles.
    for _ in 0..3 {
        let span = steady(&cycles, n);
        let offset = time_mean(time, &velocity, span.start, span.end.min(n - 1));
        velocity.iter_mut().for_each(|v| *v -= offset);
        removed += offset;
        cycles = cycles::find(time, &derivative::integrate(time, &velocity, initial));
        if cycles.is_empty() {
            break;
        }
    }
    let displacement = derivative::integrate(time, &velocity, initial);
    let seconds = time[n - 1] - time[0];
    let basis = if cycles.is_empty() { phrases::NOT_PERIODIC_ENDS } else { phrases::CYCLES_RETURN };
    samples.note(
        "derived",
        Sentence::from(phrases::INTEGRATED)
            .with("start", format_decimals(1e3 * initial, 2))
            .with("offset", format_decimals(1e3 * removed, 4))
            .with("drift", format_decimals(1e3 * removed * seconds, 2))
            .with_sentence("basis", basis),
    );
    CompleteMotion { displacement, velocity, cycles, velocity_window_s: 0.0 }
}

/// Returns the sample ranges of the whole cycles of a motion.
pub(crate) fn cycles_of(time: &[f64], displacement: &[f64]) -> Vec<std::ops::Range<usize>> {
    cycles::find(time, displacement).iter().map(|c| c.start..c.end).collect()
}

/// Completes the cleaning of a rebound-positive test. Removes standstill and ramps, finds whole cycles and computes the
/// characteristic values of the test.
pub(crate) fn finish(mut motion: CompleteTest) -> Result<Record, RecordError> {
    // If the setting changes during a test, its cycles differ. The test then stays whole, like a road test.
    motion.cycles = match motion.setting_signal {
        Some(_) => Vec::new(),
        None => cycles::find(&motion.time, &motion.displacement),
    };
    let untrimmed = motion.time.len() >= FEWEST;
    let whole = motion.clone();
    trim::trim(&mut motion);
    // A slow logger records few samples of a short test. The samples before and after the whole cycles then count too.
    if motion.time.len() < FEWEST && untrimmed {
        motion = whole;
    }
    let CompleteTest {
        at,
        name,
        time,
        begins,
        about,
        displacement,
        velocity,
        velocity_window_s,
        force,
        side_force,
        temperature,
        setting,
        setting_signal,
        cycles,
        stated_error: given,
        mut notes,
    } = motion;
    if time.len() < FEWEST {
        return Err(SampleError::TooFew { at, samples: time.len(), needed: FEWEST }.into());
    }
    drift::report(&time, &displacement, &force, &cycles, &mut notes);
    let noise = noise::floor(&time, &force, &cycles);
    let (amplitude, frequency) = match (cycles.first(), cycles.last()) {
        (Some(_), Some(_)) => {
            let strokes: Vec<f64> = cycles.iter().map(Cycle::stroke).collect();
            let seconds: f64 = cycles.iter().map(Cycle::period).sum();
            (0.5 * crate::numbers::median(&mut strokes.clone()), cycles.len() as f64 / seconds)
        }
        _ => (0.5 * range(&displacement), 0.0),
    };
    let mut record = Record {
        name,
        source: at.to_string(),
        peak_velocity: cycles::robust_peak(&velocity, &cycles),
        mean_displacement: time_mean(&time, &displacement, 0, time.len()),
        amplitude,
        frequency,
        cycles: cycles.iter().map(|c| c.start..c.end).collect(),
        noise,
        time,
        begins,
        about,
        setting,
        setting_signal,
        clock_s: 0.0,
        displacement,
        velocity,
        velocity_window_s,
        force,
        side_force,
        temperature,
        notes,
        original_fingerprint: None,
        apparent_delay_s: 0.0,
        stated_error: given,
        counted: None,
        frame: RigFrame::default(),
    };
    correct_inertia(&mut record, given.mass_kg);
    Ok(record)
}

#[cfg(test)]
mod tests {
    use dashpot_test_support::drawn;
    use proptest::prelude::*;

    use super::*;
    use crate::data::record::NoiseSource;
    use crate::data::setting_signal::SettingPattern;
    use crate::data::test_metadata::TestMetadata;
    use crate::error::Place;
    use crate::fixtures::SineTest;
    use crate::quantities::unit::Unit;

    fn clean(samples: Samples, options: &Options) -> Result<Record, RecordError> {
        finish(repair(samples, options)?)
    }

    #[test]
    fn the_figures_of_a_test_are_found() {
        let test = SineTest::default();
        let record = clean(test.samples(), &Options::default()).unwrap();
        assert_eq!(record.cycles.len(), 5);
        assert_eq!((record.cycles[0].start, record.cycles[4].end), (0, record.time.len()));
        assert!((record.amplitude - 0.05).abs() < 1e-4);
        assert!((record.frequency - 1.0).abs() < 1e-3);
        assert!((record.peak_velocity / (std::f64::consts::TAU * 0.05) - 1.0).abs() < 2e-3);
        assert!((record.mean_displacement - 0.01).abs() < 1e-4);
        assert_eq!(record.noise.from, NoiseSource::CycleRepeat);
        assert!((record.noise.force_rms / 4.0 - 1.0).abs() < 0.1);
    }

    #[test]
    fn a_missing_channel_is_derived_and_agrees_with_the_measured_one() {
        let both = SineTest::default().samples();
        let reference = clean(both.clone(), &Options::default()).unwrap();
        let mut without_velocity = both.clone();
        without_velocity.velocity = None;
        let derived = clean(without_velocity, &Options::default()).unwrap();
        assert_eq!(derived.time, reference.time);
        let peak = reference.peak_velocity;
        assert!(derived.velocity.iter().zip(&reference.velocity).all(|(a, b)| (a - b).abs() < 0.01 * peak));
        assert!(derived.notes.iter().any(|n| n.kind == "derived" && n.text.to_string().contains("-3 dB")));

        let mut without_displacement = both;
        without_displacement.displacement = None;
        without_displacement.velocity.as_mut().unwrap().iter_mut().for_each(|v| *v += 0.003); // sensor offset
        let options = Options { initial_position: 0.01, ..Options::default() };
        let derived = clean(without_displacement, &options).unwrap();
        assert!((derived.amplitude - 0.05).abs() < 2e-4 && derived.cycles.len() == 5);
        assert!((derived.mean_displacement - 0.01).abs() < 5e-4, "{}", derived.mean_displacement);
        let note = derived.notes.iter().find(|n| n.kind == "derived").unwrap();
        assert!(
            note.text.to_string().contains("velocity offset 3.0")
                || note.text.to_string().contains("velocity offset 2.9"),
            "{}",
            note.text
        );
    }

    #[test]
    fn a_disturbed_last_cycle_is_left_out() {
        let test = SineTest::default();
        let mut samples = test.samples();
        let from = ((test.steady_from() + 4.2) * 200.0) as usize;
        for (k, force) in samples.force[from..from + 100].iter_mut().enumerate() {
            *force += 80.0 * libm::sin(k as f64);
        }
        let record = clean(samples, &Options::default()).unwrap();
        assert_eq!(record.cycles.len(), 4);
        assert!(record.notes.iter().any(|n| n.kind == "noisy_last_cycle"));
    }

    #[test]
    fn a_lag_that_rounds_to_zero_has_no_sign() {
        let said = [-4e-6, 0.0, 4e-6, 2e-5, -2e-5].map(|lag| describe_lag(lag).to_string());
        let none = "has no lag";
        assert_eq!(said, [none, none, none, "lags it by 0.02 ms", "leads it by 0.02 ms"]);
    }

    #[test]
    fn spikes_of_an_unused_velocity_are_not_reported_and_others_are_in_the_unit_of_the_file() {
        let mut samples = SineTest::default().samples();
        samples.units = vec![(Channel::Force, Unit::Kilonewton), (Channel::Velocity, Unit::MillimetrePerSecond)];
        let spike = |values: &mut Vec<f64>, height: f64| values[555] += height;
        spike(&mut samples.force, 900.0);
        samples.velocity.iter_mut().for_each(|v| spike(v, 0.5));
        let spikes = |samples: Samples| -> Vec<String> {
            let record = clean(samples, &Options::default()).unwrap();
            let notes = record.notes.iter().filter(|note| note.kind == "outlier");
            notes.map(|note| note.text.to_string()).collect()
        };
        let said = spikes(samples.clone());
        assert!(said.len() == 2 && said[0].contains("force") && said[1].contains("velocity"), "{said:?}");
        for (text, wanted, unit) in [(&said[0], 0.9, "kN"), (&said[1], 500.0, "mm/s")] {
            let largest = text.split("largest ").nth(1).and_then(|rest| rest.split(' ').next()).unwrap();
            assert!((largest.parse::<f64>().unwrap() / wanted - 1.0).abs() < 0.05, "{text}");
            assert!(text.contains(&format!("{largest} {unit} off")), "{text}");
        }
        // A velocity with the lag of a filter is not used.
        let mut late = samples;
        late.velocity.iter_mut().for_each(|v| *v = (0..v.len()).map(|k| v[k.saturating_sub(8)]).collect());
        let said = spikes(late);
        assert!(said.len() == 1 && said[0].contains("force"), "{said:?}");
    }

    #[test]
    fn an_incomplete_last_cycle_is_cut() {
        let test = SineTest::default();
        let samples = test.samples();
        let mut cut = samples.clone();
        cut.select(&(0..((test.steady_from() + 3.7) * 200.0) as usize).collect::<Vec<_>>());
        let record = clean(cut, &Options::default()).unwrap();
        assert_eq!(record.cycles.len(), 3);
        assert_eq!(record.cycles[2].end, record.time.len());
        assert!(record.notes.iter().any(|n| n.kind == "trimmed" && n.text.to_string().contains("incomplete cycle")));
    }

    #[test]
    fn clipped_force_samples_are_left_out() {
        let mut samples = SineTest { noise: 1.0, ..SineTest::default() }.samples();
        let top = samples.force.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        samples.force.iter_mut().for_each(|f| *f = f.min(0.98 * top));
        let record = clean(samples, &Options::default()).unwrap();
        assert_eq!(record.cycles.len(), 5);
        assert!(record.notes.iter().any(|n| n.kind == "clipped"));
        assert!(record.time.len() < 1000 && record.time.windows(2).all(|w| w[1] > w[0]));
        assert!(record.cycles.iter().all(|c| c.end <= record.time.len()));
    }

    #[test]
    fn a_record_without_cycles_is_kept_whole() {
        let mut samples = SineTest::default().samples();
        let x: Vec<f64> = samples.time.iter().map(|t| 0.02 * libm::sin(t * t) * libm::cos(1.3 * t)).collect();
        samples.displacement = Some(x);
        samples.velocity = None;
        let n = samples.len();
        let record = clean(samples, &Options::default()).unwrap();
        assert!(record.cycles.is_empty() && record.frequency == 0.0 && record.time.len() == n);
        assert_eq!(record.noise.from, NoiseSource::SampleDifferences);
    }

    #[test]
    fn a_test_whose_current_steps_is_kept_whole() {
        let mut samples = SineTest::default().samples();
        let n = samples.len();
        samples.current = Some((0..n).map(|k| if k % 300 < 150 { 0.2 } else { 1.4 }).collect());
        let record = clean(samples.clone(), &Options::default()).unwrap();
        assert!(record.cycles.is_empty() && record.time.len() == n && record.setting.is_none());
        let signal = record.setting_signal.as_ref().unwrap();
        assert_eq!((signal.pattern, signal.values.len(), signal.range), (SettingPattern::Steps, n, [0.2, 1.4]));
        assert!(
            record.notes.iter().any(|note| note.kind == "changing_setting" && note.text.to_string().contains("steps"))
        );
        // Cycles with different currents are no measure of noise.
        assert_eq!(record.noise.from, NoiseSource::SampleDifferences);
        samples.current = Some(vec![0.8; n]);
        let record = clean(samples, &Options::default()).unwrap();
        assert!(record.setting_signal.is_none() && record.setting.unwrap().value == 0.8 && !record.cycles.is_empty());
    }

    #[test]
    fn too_few_samples_are_refused() {
        let mut samples = SineTest::default().samples();
        samples.select(&(0..19).collect::<Vec<_>>());
        assert!(matches!(
            clean(samples, &Options::default()),
            Err(RecordError::Sample(SampleError::TooFew { samples: 19, .. }))
        ));
    }

    proptest! {
        #![proptest_config(drawn(200))]
        /// Checks that cleaning returns a valid record or an error for any file contents, and never panics.
        #[test]
        fn any_table_gives_a_sound_record_or_an_error(
            rows in prop::collection::vec(
                (-1.0..5.0_f64, -3..4_i32, -1.0..1.0_f64, prop::sample::select(vec![0.0, 1.0, 1e-300, 1e300, f64::NAN])), 0..120),
            sorted in any::<bool>(),
            motion in 0..3,
        ) {
            let mut times: Vec<f64> = rows.iter().map(|r| r.0).collect();
            if sorted {
                times.sort_by(f64::total_cmp);
            }
            let n = rows.len();
            let samples = Samples {
                at: Place::file("any.csv"),
                name: "any".into(),
                lines: (2..n + 2).collect(),
                headings: Vec::new(),
                units: Vec::new(),
                time: times,
                begins: None,
                dates: Default::default(),
                about: TestMetadata::default(),
                force: rows.iter().map(|r| if r.1 == 3 { r.3 } else { f64::from(r.1) }).collect(),
                displacement: (motion != 0).then(|| rows.iter().map(|r| r.2).collect()),
                velocity: (motion != 1).then(|| rows.iter().map(|r| f64::from(r.1)).collect()),
                side_force: None,
                temperature: None,
                current: None,
                setting: None,
                notes: Vec::new(),
            };
            let options = Options::default();
            let pieces = sort_out(samples, &options).unwrap_or_default();
            for record in pieces.into_iter().filter_map(|piece| finish(mend(piece, &options, &Reach::default()).ok()?).ok()) {
                prop_assert!(record.time.windows(2).all(|w| w[1] > w[0]));
                let n = record.time.len();
                prop_assert!([record.displacement.len(), record.velocity.len(), record.force.len()] == [n, n, n]);
                prop_assert!(record.cycles.iter().all(|c| c.start < c.end && c.end <= n));
            }
        }
    }

    #[test]
    fn a_derived_velocity_has_a_window_of_a_twelfth_of_a_cycle_or_of_17_ms() {
        for frequency in [0.5, 1.0, 4.0] {
            let mut samples = SineTest { frequency, ..SineTest::default() }.samples();
            samples.velocity = None;
            let window = repair(samples, &Options::default()).unwrap().velocity_window_s;
            assert!((0.07..0.09).contains(&(window * frequency)), "{frequency} Hz: {window} s");
        }
        let mut samples = crate::fixtures::moving(1000.0, (0..2000).map(|i| 1e-4 * f64::from(i)).collect());
        let displacement = samples.displacement.take().unwrap();
        let window = differentiated(&mut samples, displacement).velocity_window_s;
        assert!((0.015..0.019).contains(&window), "{window} s");
    }

    #[test]
    fn windows_that_corners_shorten_are_noted_from_a_hundredth_of_the_samples_on() {
        // Each corner shortens the windows of eight or more of 1600 samples.
        let is_noted = |corners: i32| {
            let mut random = crate::fixtures::Random::new(6);
            let corner = |i: i32| (1..=corners).map(|k| 4e-4 * f64::from((i - 300 * k).max(0))).sum::<f64>();
            let x = (0..1600).map(|i| 1e-4 * f64::from(i) + corner(i) + 1e-5 * random.normal()).collect();
            let mut samples = crate::fixtures::moving(1000.0, x);
            let displacement = samples.displacement.take().unwrap();
            differentiated(&mut samples, displacement);
            samples.notes.iter().any(|note| note.text.to_string().contains("where the motion turns"))
        };
        assert!(!is_noted(1) && is_noted(4));
    }
}
