//! Rejects units that are wrong by a factor of a thousand. The evidence is a combination of values that is impossible
//! for dampers and rigs.

use crate::data::record::Record;
use crate::error::{PlausibilityError, RecordError};
use crate::messages::phrases;
use crate::numbers::{median, range, sample_time};
use crate::options::Options;
use crate::quantities::channel::Channel;
use crate::quantities::unit::Unit;
use crate::tuning::unit_magnitude::{
    BEYOND_ANY_RIG, FASTEST, FOLLOWS, LONG, MOST_CURRENT, MOVING, RARELY, SHORTEST, SLOWEST, STIFFEST, WEAK, WEAKEST,
};
use dashpot_messages::{Sentence, format_decimals};

/// Rejects a campaign if its values indicate a unit that is wrong by a factor of a thousand. A unit given by the user
/// counts as correct.
pub(crate) fn reject(records: &[Record], options: &Options) -> Result<(), RecordError> {
    let Some(fastest) = records.iter().max_by(|a, b| a.peak_velocity.total_cmp(&b.peak_velocity)) else {
        return Ok(());
    };
    let insisted = |channel| options.units.contains_key(&channel);
    let slip = |channel, written, likely, evidence| {
        Err(PlausibilityError::UnitSlip { channel, written, likely, evidence }.into())
    };
    let largest = records.iter().map(largest_current).fold(0.0, f64::max);
    let (large, small): (Vec<f64>, Vec<f64>) = records.iter().map(largest_current).partition(|i| *i > MOST_CURRENT);
    let usual = small.iter().copied().fold(0.0, f64::max);
    // If most tests have an implausible current, the unit of the whole logger is wrong. The few small currents are then
    // those of a valve without current.
    let is_of_few = large.len() <= small.len();
    // If the user states that the setting is another quantity than a current, a column named current is not a current.
    let is_current = options.settings.name.as_deref().is_none_or(|name| name == "current");
    let is_questioned = is_current && !insisted(Channel::Current);
    if largest > MOST_CURRENT && usual > 0.0 && is_of_few && is_questioned {
        let other = records.iter().find(|record| largest_current(record) > MOST_CURRENT).unwrap_or(fastest);
        return Err(PlausibilityError::MixedCurrent {
            record: other.source.clone(),
            test: other.name.clone(),
            current: largest_current(other),
            others: usual,
        }
        .into());
    }
    if largest > MOST_CURRENT && is_questioned {
        let evidence = Sentence::from(phrases::TOO_MUCH_CURRENT).with("current", format_decimals(largest, 0));
        return slip(Channel::Current, Unit::Ampere, Unit::Milliampere, evidence);
    }
    let half = |r: &Record| 0.5 * range(&r.force);
    let strongest = records.iter().map(half).fold(0.0, f64::max);
    let damping = half(fastest) / fastest.peak_velocity.max(1e-9);
    if !insisted(Channel::Time) {
        let seconds = |r: &Record| r.time.last().copied().unwrap_or(0.0) - r.time.first().copied().unwrap_or(0.0);
        let is_quick = |r: &&Record| r.frequency > FASTEST && r.amplitude > 1e-4 || r.frequency > BEYOND_ANY_RIG;
        if let Some(quick) = records.iter().find(is_quick) {
            let evidence = Sentence::from(phrases::TOO_QUICK)
                .with("record", &quick.source)
                .with("amplitude", format_decimals(1e3 * quick.amplitude, 2))
                .with("frequency", format_decimals(quick.frequency, 0))
                .with("seconds", format_decimals(seconds(quick), 4));
            return slip(Channel::Time, Unit::Millisecond, Unit::Second, evidence);
        }
        let step = median(&mut records.iter().map(|r| sample_time(&r.time)).collect::<Vec<_>>());
        let longest = records.iter().map(seconds).fold(0.0, f64::max);
        if fastest.peak_velocity < SLOWEST && step > RARELY && longest > LONG && strongest > WEAK {
            let evidence = Sentence::from(phrases::TOO_LONG)
                .with("count", records.len())
                .with("velocity", format_decimals(1e3 * fastest.peak_velocity, 3))
                .with("hours", format_decimals(longest / 3600.0, 1))
                .with("step", format_decimals(step, 3));
            return slip(Channel::Time, Unit::Second, Unit::Millisecond, evidence);
        }
    }
    let longest = records.iter().map(|r| r.amplitude).fold(0.0, f64::max);
    if !insisted(Channel::Displacement) && longest < SHORTEST && damping > STIFFEST && strongest > WEAK {
        let evidence = Sentence::from(phrases::TOO_STIFF)
            .with("amplitude", format_decimals(1e3 * longest, 4))
            .with("force", format_decimals(half(fastest), 0))
            .with("velocity", format_decimals(1e3 * fastest.peak_velocity, 3))
            .with("damping", format!("{damping:.1e}"));
        return slip(Channel::Displacement, Unit::Millimetre, Unit::Metre, evidence);
    }
    let is_weak = strongest < WEAK && damping < WEAKEST && fastest.peak_velocity > MOVING;
    // A dead load cell also shows small forces, but those do not correlate with the motion.
    if !insisted(Channel::Force) && is_weak && follows(fastest) {
        let evidence = Sentence::from(phrases::TOO_WEAK)
            .with("count", records.len())
            .with("strongest", format_decimals(strongest, 3))
            .with("test", &fastest.name)
            .with("force", format_decimals(half(fastest), 3))
            .with("velocity", format_decimals(1e3 * fastest.peak_velocity, 1))
            .with("damping", format_decimals(damping, 2));
        return slip(Channel::Force, Unit::Newton, Unit::Kilonewton, evidence);
    }
    Ok(())
}

/// Returns the largest absolute current of a record's valve, A, or zero if the record states none in A.
fn largest_current(record: &Record) -> f64 {
    let constant = record.setting.as_ref().filter(|of| of.name == "current" && of.unit == "A").map(|of| of.value.abs());
    let changing = record.setting_signal.as_ref().filter(|of| of.name == "current" && of.unit == "A");
    let ends = changing.map(|of| of.range[0].abs().max(of.range[1].abs()));
    constant.or(ends).unwrap_or(0.0)
}

/// Returns whether the force of a record correlates with its velocity.
fn follows(record: &Record) -> bool {
    let count = record.force.len().max(1) as f64;
    let mean = |values: &[f64]| values.iter().sum::<f64>() / count;
    let (force, velocity) = (mean(&record.force), mean(&record.velocity));
    let (mut both, mut of_force, mut of_velocity) = (0.0, 0.0, 0.0);
    for (f, v) in record.force.iter().zip(&record.velocity) {
        both += (f - force) * (v - velocity);
        of_force += (f - force).powi(2);
        of_velocity += (v - velocity).powi(2);
    }
    both.abs() > FOLLOWS * (of_force * of_velocity).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::quantities::setting_value::Setting;

    /// Makes a campaign of a damper, tested at several amplitudes, m, and peak speeds, m/s. `force` is the damping
    /// force at 1 m/s, N, and `friction` is the friction, N. `slip` multiplies time, motion and force to imitate wrong
    /// units.
    fn campaign(force: f64, friction: f64, tests: &[(f64, f64)], slip: [f64; 3]) -> Vec<Record> {
        tests
            .iter()
            .map(|&(amplitude, speed)| {
                let omega = speed / amplitude;
                let time: Vec<f64> =
                    (0..1000).map(|i| f64::from(i) * 5.0 * std::f64::consts::TAU / omega / 1000.0).collect();
                let v = |t: f64| speed * libm::cos(omega * t);
                Record {
                    name: "a".into(),
                    source: "a.csv".into(),
                    force: time
                        .iter()
                        .map(|t| slip[2] * (force * v(*t) + friction * libm::tanh(v(*t) / 0.001)))
                        .collect(),
                    velocity: time.iter().map(|t| slip[1] * v(*t) / slip[0]).collect(),
                    amplitude: slip[1] * amplitude,
                    peak_velocity: slip[1] * speed / slip[0],
                    frequency: omega / std::f64::consts::TAU / slip[0],
                    time: time.iter().map(|t| t * slip[0]).collect(),
                    ..Record::default()
                }
            })
            .collect()
    }

    const USUAL: [(f64, f64); 3] = [(0.05, 0.05), (0.05, 0.26), (0.05, 1.0)];

    fn said(records: &[Record]) -> String {
        reject(records, &Options::default()).map_or_else(|e| e.to_string(), |()| String::new())
    }

    #[test]
    fn real_dampers_of_all_sizes_pass() {
        let plans: [&[(f64, f64)]; 5] = [
            &USUAL,
            &[(0.025, 0.1)],
            &[(0.001, 0.05), (0.0002, 0.02)],
            &[(0.03, 0.001), (0.03, 0.005)],
            &[(0.012, 1.5)],
        ];
        for force in [20.0, 60.0, 200.0, 2000.0, 20e3] {
            for plan in plans {
                for friction in [0.02, 0.1] {
                    // Even a small damper has a few newtons of friction, which dominate the force of a slow test.
                    let records = campaign(force, friction * force + 2.0, plan, [1.0; 3]);
                    assert_eq!(said(&records), "", "{force} N, {plan:?}");
                }
            }
        }
    }

    #[test]
    fn thousandfold_slips_are_refused_with_evidence_and_the_flag_to_insist() {
        for force in [600.0, 2000.0, 6000.0] {
            for (slip, wanted) in [
                ([1.0, 1.0, 1e-3], "--unit force=kN, or --unit force=N to insist"),
                ([1e3, 1.0, 1.0], "--unit time=ms, or --unit time=s to insist"),
                ([1e-3, 1.0, 1.0], "--unit time=s, or --unit time=ms to insist"),
                ([1.0, 1e-3, 1.0], "--unit displacement=m, or --unit displacement=mm to insist"),
            ] {
                let records = campaign(force, 0.05 * force, &USUAL, slip);
                // In a campaign, the plausibility check may reject the speed first if the time is too short by a factor
                // of a thousand.
                let message = said(&records);
                assert!(message.contains(wanted), "{force} {slip:?}: {message}");
            }
        }
        let mut options = Options::default();
        options.units.insert(Channel::Force, Unit::Newton);
        assert!(reject(&campaign(2000.0, 50.0, &USUAL, [1.0, 1.0, 1e-3]), &options).is_ok());
    }

    #[test]
    fn milliamperes_that_are_called_amperes_are_refused() {
        let at = |value: f64, options: &Options| {
            let mut records = campaign(2000.0, 50.0, &USUAL, [1.0; 3]);
            let setting = Setting { name: "current".into(), unit: "A".into(), value };
            records.iter_mut().for_each(|record| record.setting = Some(setting.clone()));
            reject(&records, options).map_or_else(|e| e.to_string(), |()| String::new())
        };
        let mut insists = Options::default();
        insists.units.insert(Channel::Current, Unit::Ampere);
        let none = Options::default();
        assert!(at(800.0, &none).contains("--unit current=mA, or --unit current=A to insist"), "{}", at(800.0, &none));
        assert!(at(-1600.0, &none).contains("1600 A"));
        assert_eq!([at(10.0, &none), at(800.0, &insists)], ["", ""]);
        // A profile that states the setting `current` and its unit does not state the unit in the files. The check
        // therefore still applies.
        let named = |name: &str| {
            let mut options = Options::default();
            options.settings.name = Some(name.into());
            options.settings.unit = "A".into();
            options
        };
        assert!(at(800.0, &named("current")).contains("--unit current=mA"));
        assert_eq!(at(800.0, &named("opening")), "");
        // If only one file deviates, the unit of all files is not at fault.
        let mut records = campaign(2000.0, 50.0, &USUAL, [1.0; 3]);
        let set = |records: &mut [Record], values: [f64; 3]| {
            for (record, value) in records.iter_mut().zip(values) {
                record.setting = Some(Setting { name: "current".into(), unit: "A".into(), value });
            }
        };
        set(&mut records, [0.3, 700.0, 0.7]);
        (records[1].name, records[1].source) = ("odd".into(), "odd.csv".into());
        let message = reject(&records, &none).unwrap_err().to_string();
        assert!(
            message.contains("odd.csv") && message.contains("--exclude 'odd'") && message.contains("0.70 A"),
            "{message}"
        );
        // If most files deviate, the unit is at fault, and the small current is the noise of a valve without current.
        set(&mut records, [0.1, 400.0, 800.0]);
        let message = reject(&records, &none).unwrap_err().to_string();
        assert!(message.contains("800 A") && message.contains("--unit current=mA"), "{message}");
    }

    /// Properties of a synthetic record: half the range of its force, N, peak velocity, m/s, amplitude, m, sampling
    /// interval, s, and duration, s.
    struct Figures {
        half: f64,
        speed: f64,
        amplitude: f64,
        step: f64,
        seconds: f64,
        /// Correlation of force and velocity.
        correlation: f64,
    }

    impl Figures {
        fn is_rejected(&self) -> bool {
            let count = (self.seconds / self.step).ceil() as u32;
            let phase = |i: u32| std::f64::consts::TAU * f64::from(i) / 20.0;
            let shift = libm::acos(self.correlation);
            let record = Record {
                time: (0..=count).map(|i| self.step * f64::from(i)).collect(),
                velocity: (0..=count).map(|i| self.speed * libm::cos(phase(i))).collect(),
                force: (0..=count).map(|i| self.half * libm::cos(phase(i) + shift)).collect(),
                amplitude: self.amplitude,
                peak_velocity: self.speed,
                ..Record::default()
            };
            reject(&[record], &Options::default()).is_err()
        }
    }

    #[test]
    fn units_are_doubted_only_where_all_figures_speak_for_it() {
        let long =
            |half, speed, step, seconds| Figures { half, speed, amplitude: 0.01, step, seconds, correlation: 1.0 };
        assert!(long(20.0, 4.5e-3, 0.07, 5000.0).is_rejected());
        for other in [
            long(6.0, 4.5e-3, 0.07, 5000.0),
            long(20.0, 8.5e-3, 0.07, 5000.0),
            long(20.0, 4.5e-3, 0.036, 5000.0),
            long(20.0, 4.5e-3, 0.07, 2600.0),
        ] {
            assert!(!other.is_rejected());
        }
        let stiff =
            |half, speed, amplitude| Figures { half, speed, amplitude, step: 1e-3, seconds: 0.2, correlation: 1.0 };
        assert!(stiff(40.0, 1e-4, 1.1e-4).is_rejected());
        assert!(!stiff(40.0, 1e-4, 2.1e-4).is_rejected() && !stiff(22.0, 1e-4, 1.1e-4).is_rejected());
        assert!(!stiff(6.0, 1e-5, 1.1e-4).is_rejected());
        let weak =
            |half, speed, correlation| Figures { half, speed, amplitude: 0.05, step: 1e-3, seconds: 0.2, correlation };
        assert!(weak(0.5, 0.08, 1.0).is_rejected() && weak(6.0, 0.8, 1.0).is_rejected());
        assert!(weak(0.1, 0.028, 1.0).is_rejected() && !weak(0.1, 0.014, 1.0).is_rejected());
        assert!(!weak(11.0, 2.0, 1.0).is_rejected() && !weak(1.1, 0.08, 1.0).is_rejected());
        assert!(weak(0.5, 0.08, 0.42).is_rejected() && !weak(0.5, 0.08, 0.21).is_rejected());
    }

    #[test]
    fn a_frequency_that_no_rig_reaches_is_another_unit_of_time() {
        let rejected = |frequency: f64, amplitude: f64| {
            let record = Record { time: vec![0.0, 1.0], frequency, amplitude, ..Record::default() };
            reject(&[record], &Options::default()).is_err()
        };
        assert!(!rejected(110.0, 2e-4) && rejected(210.0, 2e-4));
        // With lengths a thousand times too small as well, the speed is plausible.
        assert!(!rejected(500.0, 2.5e-5) && rejected(1667.0, 2.5e-5));
    }
}
