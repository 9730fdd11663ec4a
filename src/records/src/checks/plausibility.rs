//! Figures that no suspension damper has: mostly a unit that was not said, or a load cell that is not connected.
//!
//! What is far too large is refused; what is small may be meant so and is only remarked upon.

use std::collections::HashMap;

use crate::data::record::{Note, Record};
use crate::error::RecordError;
use crate::messages::phrases;
use crate::messages::sentence::Sentence;
use crate::numbers::range;
use crate::options::Options;
use crate::quantities::channel::Channel;

/// Largest displacement amplitude, m; the longest suspensions travel half of it.
const LARGEST_AMPLITUDE: f64 = 0.5;
/// Highest speed, m/s; kerb strikes reach about 10.
const HIGHEST_SPEED: f64 = 20.0;
/// Largest force, N; dampers of heavy vehicles reach a third of it.
const LARGEST_FORCE: f64 = 2e5;

/// Range of the force, N, below which no damper's stays in every test: the smallest, of toys and of drawers, have a newton.
const LEAST_FORCE: f64 = 0.05;
/// Below these figures in every test a unit is likely wrong.
const SMALL_AMPLITUDE: f64 = 2e-4;
const SMALL_SPEED: f64 = 6e-3;
const SMALL_FORCE: f64 = 20.0;

/// Range of the force, in standard deviations of its noise, below which it shows noise alone: white noise of a hundred
/// thousand samples stays inside.
const NOISE_RANGE: f64 = 10.0;
/// Standard deviation of the force, in those of its noise, below which it shows noise alone.
const NOISE_SPREAD: f64 = 1.1;

/// Peak velocity, m/s, below which a damper stands still and need show no force.
const STANDSTILL: f64 = 1e-4;

/// Refuses a record that no damper can have given.
pub(crate) fn refuse_absurd(record: &Record, options: &Options) -> Result<(), RecordError> {
    let largest = |values: &[f64]| values.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
    let force = largest(&record.force);
    let absurd = |what: Sentence, channels: &[Channel], advice| {
        // Who said the unit needs another advice than to say it.
        let given = channels.iter().any(|channel| options.units.contains_key(channel));
        let advice = if given { phrases::UNIT_WAS_GIVEN } else { advice };
        Err(RecordError::Absurd { record: record.source.clone(), what, advice })
    };
    let motion = [Channel::Displacement, Channel::Velocity, Channel::Time];
    if record.amplitude > LARGEST_AMPLITUDE {
        return absurd(
            Sentence::from(phrases::AN_AMPLITUDE).with("amplitude", format!("{:.4}", record.amplitude)),
            &motion,
            phrases::SAY_MM,
        );
    }
    if record.peak_velocity > HIGHEST_SPEED {
        return absurd(
            Sentence::from(phrases::A_VELOCITY).with("velocity", format!("{:.4}", record.peak_velocity)),
            &motion,
            phrases::CHECK_MOTION_UNITS,
        );
    }
    if force > LARGEST_FORCE {
        return absurd(
            Sentence::from(phrases::A_FORCE).with("force", format!("{force:.0}")),
            &[Channel::Force],
            phrases::SAY_N,
        );
    }
    Ok(())
}

/// Remarks on a campaign whose figures are all small, on tests without force, and on tests that are there twice.
///
/// # Errors
/// Where most tests show no force, or all a force that no damper has.
pub(crate) fn remark(records: &[Record], options: &Options, notes: &mut Vec<Note>) -> Result<(), RecordError> {
    let silent: Vec<&Record> = records.iter().filter(|r| shows_noise_alone(r)).collect();
    if let Some(first) = silent.first() {
        let (count, all) = (silent.len(), records.len());
        if 2 * count > all {
            return Err(RecordError::NoForce {
                count,
                all,
                record: first.source.clone(),
                noise: first.noise.force_rms,
            });
        }
        let names = silent.iter().map(|r| &r.name);
        notes.push(Note {
            kind: "no_force",
            text: Sentence::from(phrases::NO_FORCE).with_names("tests", names, phrases::COMMA),
        });
    }
    if records.iter().all(|r| range(&r.force) < LEAST_FORCE)
        && let Some(first) = records.first()
    {
        return Err(RecordError::Absurd {
            record: first.source.clone(),
            what: Sentence::from(phrases::NO_MORE_FORCE).with("force", format!("{:.2e}", range(&first.force))),
            advice: if options.units.contains_key(&Channel::Force) || options.gain != 1.0 {
                phrases::UNIT_WAS_GIVEN
            } else {
                phrases::SAY_STRONGER
            },
        });
    }
    let most = |figure: fn(&Record) -> f64| records.iter().map(figure).fold(0.0_f64, f64::max);
    let mut small = |figure: f64, limit: f64, text: Sentence| {
        if figure < limit {
            notes.push(Note { kind: "small", text });
        }
    };
    let (amplitude, speed, force) = (most(|r| r.amplitude), most(|r| r.peak_velocity), most(|r| range(&r.force)));
    small(
        amplitude,
        SMALL_AMPLITUDE,
        Sentence::from(phrases::SMALL_AMPLITUDE).with("amplitude", format!("{:.4}", 1e3 * amplitude)),
    );
    small(speed, SMALL_SPEED, Sentence::from(phrases::SLOW).with("velocity", format!("{:.3}", 1e3 * speed)));
    small(force, SMALL_FORCE, Sentence::from(phrases::SMALL_FORCE).with("force", format!("{force:.3}")));
    let mut known: HashMap<String, &Record> = HashMap::with_capacity(records.len());
    for record in records {
        let twin = *known.entry(record.fingerprint()).or_insert(record);
        if !std::ptr::eq(twin, record) && twin.force == record.force && twin.time == record.time {
            notes.push(Note {
                kind: "duplicated",
                text: Sentence::from(phrases::TWINS).with("test", &record.name).with("twin", &twin.name),
            });
        }
    }
    Ok(())
}

/// Whether the force of a moving damper does not stand out of its noise.
pub(crate) fn shows_noise_alone(record: &Record) -> bool {
    let noise = record.noise.force_rms;
    let n = record.force.len() as f64;
    let mean = record.force.iter().sum::<f64>() / n;
    let spread = (record.force.iter().map(|f| (f - mean).powi(2)).sum::<f64>() / n).sqrt();
    let range = range(&record.force);
    record.peak_velocity > STANDSTILL && noise > 0.0 && range < NOISE_RANGE * noise && spread < NOISE_SPREAD * noise
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Noise;

    fn record(scale: [f64; 2]) -> Record {
        let time: Vec<f64> = (0..200).map(|i| 0.01 * f64::from(i)).collect();
        Record {
            name: "a".into(),
            source: "a.csv".into(),
            force: time.iter().map(|t| scale[1] * libm::sin(6.0 * t)).collect(),
            displacement: vec![0.0; time.len()],
            velocity: vec![0.0; time.len()],
            time,
            amplitude: 0.05 * scale[0],
            peak_velocity: 0.3 * scale[0],
            noise: Noise { force_rms: 5.0, ..Noise::default() },
            ..Record::default()
        }
    }

    #[test]
    fn a_thousandfold_slip_is_refused_with_the_unit_to_give() {
        assert!(refuse_absurd(&record([1.0, 2000.0]), &Options::default()).is_ok());
        let said = |scale| refuse_absurd(&record(scale), &Options::default()).unwrap_err().to_string();
        assert!(said([1e3, 2000.0]).contains("a.csv") && said([1e3, 1.0]).contains("--unit displacement=mm"));
        assert!(said([1.0, 2e6]).contains("--unit force=N"));
        let fast = Record { amplitude: 0.05, ..record([100.0, 1.0]) };
        assert!(refuse_absurd(&fast, &Options::default()).unwrap_err().to_string().contains("--unit velocity=mm/s"));
    }

    #[test]
    fn small_figures_silence_and_twins_are_told() {
        let mut notes = Vec::new();
        remark(&[record([1.0, 2000.0])], &Options::default(), &mut notes).unwrap();
        assert!(notes.is_empty());
        let twin = Record { name: "b".into(), ..record([1e-3, 7.0]) };
        let quiet = |r: Record| Record { noise: Noise { force_rms: 0.1, ..r.noise }, ..r };
        remark(&[quiet(record([1e-3, 7.0])), quiet(twin)], &Options::default(), &mut notes).unwrap();
        let text: Vec<String> = notes.iter().map(|n| n.text.to_string()).collect();
        for wanted in ["0.0500 mm", "0.300 mm/s", "13.999 N", "b holds the same samples as a"] {
            assert!(text.iter().any(|t| t.contains(wanted)), "{wanted}: {text:?}");
        }
        notes.clear();
        remark(&[record([1.0, 2000.0]), record([1.0, 5.0])], &Options::default(), &mut notes).unwrap();
        assert!(notes[0].kind == "no_force");
        assert!(
            remark(&[record([1.0, 5.0])], &Options::default(), &mut notes)
                .unwrap_err()
                .to_string()
                .contains("load cell")
        );
    }

    #[test]
    fn a_force_below_that_of_any_damper_is_refused_whatever_was_said() {
        let mut options = Options::default();
        let mut notes = Vec::new();
        let weak = Record { noise: Noise { force_rms: 1e-12, ..Noise::default() }, ..record([1.0, 1e-9]) };
        let told =
            |options: &Options, notes: &mut Vec<Note>| remark(&[weak.clone()], options, notes).unwrap_err().to_string();
        assert!(told(&options, &mut notes).contains("--unit force=kN"));
        options.units.insert(Channel::Force, crate::Unit::Newton);
        let insisted = told(&options, &mut notes);
        assert!(insisted.contains("the unit was said") && !insisted.contains("--unit force="), "{insisted}");
        let strong = refuse_absurd(&record([1.0, 1e9]), &options).unwrap_err().to_string();
        assert!(strong.contains("the unit was said"), "{strong}");
    }
}
