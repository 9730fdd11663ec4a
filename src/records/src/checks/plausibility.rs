//! Rejects values that no suspension damper has. The usual causes are an unstated unit and an unconnected load cell.
//!
//! Values that are far too large are rejected, and so is a force that is too small for any damper or only noise. Other
//! small values may be intended and only cause a note.

use std::collections::HashMap;

use crate::data::record::{Note, Record};
use crate::error::{PlausibilityError, RecordError};
use crate::messages::phrases;
use crate::numbers::range;
use crate::options::Options;
use crate::quantities::channel::Channel;
use crate::tuning::plausibility::{
    HIGHEST_SPEED, LARGEST_AMPLITUDE, LARGEST_FORCE, LEAST_FORCE, NOISE_RANGE, NOISE_SPREAD, SMALL_AMPLITUDE,
    SMALL_FORCE, SMALL_SPEED, STANDSTILL,
};
use dashpot_messages::{Sentence, format_decimals};

/// Rejects a record with an amplitude, velocity or force that no damper reaches.
pub(crate) fn reject_absurd(record: &Record, options: &Options) -> Result<(), RecordError> {
    let largest = |values: &[f64]| values.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
    let force = largest(&record.force);
    let absurd = |what: Sentence, channels: &[Channel], advice| {
        // If the user has stated the unit, the advice to state it does not help.
        let given = channels.iter().any(|channel| options.units.contains_key(channel));
        let advice = if given { phrases::UNIT_WAS_GIVEN } else { advice };
        Err(PlausibilityError::Absurd { record: record.source.clone(), what, advice }.into())
    };
    let motion = [Channel::Displacement, Channel::Velocity, Channel::Time];
    if record.amplitude > LARGEST_AMPLITUDE {
        return absurd(
            Sentence::from(phrases::AN_AMPLITUDE).with("amplitude", format_decimals(record.amplitude, 4)),
            &motion,
            phrases::SAY_MM,
        );
    }
    if record.peak_velocity > HIGHEST_SPEED {
        return absurd(
            Sentence::from(phrases::A_VELOCITY).with("velocity", format_decimals(1e3 * record.peak_velocity, 0)),
            &motion,
            phrases::CHECK_MOTION_UNITS,
        );
    }
    if force > LARGEST_FORCE {
        return absurd(
            Sentence::from(phrases::A_FORCE).with("force", format_decimals(force, 0)),
            &[Channel::Force],
            phrases::SAY_N,
        );
    }
    Ok(())
}

/// Adds notes about a campaign with only small values, about tests without force and about identical tests.
///
/// # Errors
/// Most tests show no force, or the force of every test is too small for any damper.
pub(crate) fn remark(records: &[Record], options: &Options, notes: &mut Vec<Note>) -> Result<(), RecordError> {
    let silent: Vec<&Record> = records.iter().filter(|r| shows_noise_alone(r)).collect();
    if let Some(first) = silent.first() {
        let (count, all) = (silent.len(), records.len());
        if 2 * count > all {
            return Err(PlausibilityError::NoForce {
                count,
                all,
                record: first.source.clone(),
                noise: first.noise.force_rms,
            }
            .into());
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
        return Err(PlausibilityError::Absurd {
            record: first.source.clone(),
            what: Sentence::from(phrases::NO_MORE_FORCE).with("force", format!("{:.2e}", range(&first.force))),
            advice: if options.units.contains_key(&Channel::Force) || options.gain != 1.0 {
                phrases::UNIT_WAS_GIVEN
            } else {
                phrases::SAY_STRONGER
            },
        }
        .into());
    }
    let most = |figure: fn(&Record) -> f64| records.iter().map(figure).fold(0.0_f64, f64::max);
    let mut small = |figure: f64, limit: f64, text: Sentence| {
        if figure < limit {
            notes.push(Note { kind: "small", text });
        }
    };
    // The notes are in the unit of the files, because a user compares them with the files.
    let frame = records.first().map(|record| record.frame).unwrap_or_default();
    let (amplitude, speed, force) = (most(|r| r.amplitude), most(|r| r.peak_velocity), most(|r| range(&r.force)));
    small(
        amplitude,
        SMALL_AMPLITUDE,
        Sentence::from(phrases::SMALL_AMPLITUDE)
            .with("amplitude", format_decimals(amplitude / frame.unit.to_si(1.0), 4))
            .with("unit", frame.unit.name()),
    );
    let velocity = format_decimals(speed / frame.speed_unit().to_si(1.0), 3);
    let slow = Sentence::from(phrases::SLOW).with("velocity", velocity).with("unit", frame.speed_unit().name());
    small(speed, SMALL_SPEED, slow);
    small(force, SMALL_FORCE, Sentence::from(phrases::SMALL_FORCE).with("force", format_decimals(force, 3)));
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

/// Returns whether the damper moves but its force is indistinguishable from noise.
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
        assert!(reject_absurd(&record([1.0, 2000.0]), &Options::default()).is_ok());
        let said = |scale| reject_absurd(&record(scale), &Options::default()).unwrap_err().to_string();
        assert!(said([1e3, 2000.0]).contains("a.csv") && said([1e3, 1.0]).contains("--unit displacement=mm"));
        assert!(said([1.0, 2e6]).contains("--unit force=N"));
        let fast = Record { amplitude: 0.05, ..record([100.0, 1.0]) };
        assert!(reject_absurd(&fast, &Options::default()).unwrap_err().to_string().contains("--unit velocity=mm/s"));
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
        let describe =
            |options: &Options, notes: &mut Vec<Note>| remark(&[weak.clone()], options, notes).unwrap_err().to_string();
        assert!(describe(&options, &mut notes).contains("--unit force=kN"));
        options.units.insert(Channel::Force, crate::Unit::Newton);
        let insisted = describe(&options, &mut notes);
        assert!(insisted.contains("the unit was said") && !insisted.contains("--unit force="), "{insisted}");
        let strong = reject_absurd(&record([1.0, 1e9]), &options).unwrap_err().to_string();
        assert!(strong.contains("the unit was said"), "{strong}");
    }

    #[test]
    fn limits_of_what_a_damper_can_show() {
        let plain = Options::default();
        let absurd = |amplitude: f64, speed: f64, force: f64| {
            let record = Record { amplitude, peak_velocity: speed, ..record([1.0, force]) };
            reject_absurd(&record, &plain).is_err()
        };
        assert!(!absurd(0.4, 15.0, 1.5e5));
        assert!(absurd(0.7, 15.0, 1.5e5) && absurd(0.4, 28.0, 1.5e5) && absurd(0.4, 15.0, 2.8e5));
        let noted = |amplitude: f64, speed: f64, force: f64| {
            let noise = Noise::default();
            let record = Record { amplitude, peak_velocity: speed, noise, ..record([1.0, 0.5 * force]) };
            let mut notes = Vec::new();
            remark(&[record], &plain, &mut notes).map(|()| notes.len()).ok()
        };
        assert_eq!(noted(2.8e-4, 8.4e-3, 28.0), Some(0));
        assert_eq!((noted(1.4e-4, 8.4e-3, 28.0), noted(2.8e-4, 4.2e-3, 28.0)), (Some(1), Some(1)));
        assert_eq!(
            (noted(2.8e-4, 8.4e-3, 14.0), noted(1.0, 1.0, 0.07), noted(1.0, 1.0, 0.035)),
            (Some(1), Some(1), None)
        );
    }

    #[test]
    fn noise_is_known_by_its_range_and_its_spread() {
        let noise = Noise { force_rms: 1.0, ..Noise::default() };
        let alone = |force: f64, spike: f64, speed: f64| {
            let mut record = Record { peak_velocity: speed, noise, ..record([1.0, force]) };
            record.force[0] = spike;
            shows_noise_alone(&record)
        };
        // A sine has a root mean square of 0.7 of its amplitude. Amplitudes of 1.4 N and 1.8 N are therefore below and
        // above the limit `NOISE_SPREAD`.
        assert!(alone(1.4, 0.0, 1.0) && !alone(1.8, 0.0, 1.0));
        assert!(alone(0.0, 8.0, 1.0) && !alone(0.0, 14.0, 1.0));
        assert!(alone(1.0, 0.0, 1.4e-4) && !alone(1.0, 0.0, 0.7e-4));
    }
}
