//! Units that are a thousandfold off: told by figures that no damper of any size and no rig shows together.

use crate::data::record::Record;
use crate::error::RecordError;
use crate::messages::phrases;
use crate::messages::sentence::Sentence;
use crate::numbers::{median, range, sample_time};
use crate::options::Options;
use crate::quantities::channel::Channel;
use crate::quantities::unit::Unit;

/// Damping of the fastest test, N s/m, below which a force is likely written in kN.
///
/// A damper of 20 N at 1 m/s has 20, one of a passenger car in kN some units.
const WEAKEST: f64 = 10.0;
/// Force of the strongest test, N, from which it is taken for what it is; the smallest dampers reach twice that.
const WEAK: f64 = 8.0;
/// Speed, m/s, from which a damper shows damping and not friction alone.
const MOVING: f64 = 0.02;
/// Damping, N s/m, and amplitude, m, beyond which a displacement in m was likely read as mm. A heavy damper has 20 kN at
/// 50 mm/s; friction alone reaches more only in strokes of some tenths of a millimetre, which are longer than this.
const STIFFEST: f64 = 3e5;
const SHORTEST: f64 = 1.5e-4;
/// Fastest test, m/s, slowest sampling, s, and longest test, s, that together speak for milliseconds read as seconds.
const SLOWEST: f64 = 6e-3;
const RARELY: f64 = 0.05;
const LONG: f64 = 3600.0;
/// Frequency, Hz, that no damper rig reaches with an amplitude of a tenth of a millimetre and more.
const FASTEST: f64 = 150.0;

/// Refuses a campaign whose figures speak for a unit a thousandfold off; a unit given by the user is right.
pub(crate) fn refuse(records: &[Record], options: &Options) -> Result<(), RecordError> {
    let Some(fastest) = records.iter().max_by(|a, b| a.peak_velocity.total_cmp(&b.peak_velocity)) else {
        return Ok(());
    };
    let insisted = |channel| options.units.contains_key(&channel);
    let half = |r: &Record| 0.5 * range(&r.force);
    let strongest = records.iter().map(half).fold(0.0, f64::max);
    let damping = half(fastest) / fastest.peak_velocity.max(1e-9);
    let slip = |channel, written, likely, evidence| Err(RecordError::UnitSlip { channel, written, likely, evidence });
    if !insisted(Channel::Time) {
        let seconds = |r: &Record| r.time.last().copied().unwrap_or(0.0) - r.time.first().copied().unwrap_or(0.0);
        if let Some(quick) = records.iter().find(|r| r.frequency > FASTEST && r.amplitude > 1e-4) {
            let evidence = Sentence::from(phrases::TOO_QUICK)
                .with("record", &quick.source)
                .with("amplitude", format!("{:.2}", 1e3 * quick.amplitude))
                .with("frequency", format!("{:.0}", quick.frequency))
                .with("seconds", format!("{:.4}", seconds(quick)));
            return slip(Channel::Time, Unit::Millisecond, Unit::Second, evidence);
        }
        let step = median(&mut records.iter().map(|r| sample_time(&r.time)).collect::<Vec<_>>());
        let longest = records.iter().map(seconds).fold(0.0, f64::max);
        if fastest.peak_velocity < SLOWEST && step > RARELY && longest > LONG && strongest > WEAK {
            let evidence = Sentence::from(phrases::TOO_LONG)
                .with("count", records.len())
                .with("velocity", format!("{:.3}", 1e3 * fastest.peak_velocity))
                .with("hours", format!("{:.1}", longest / 3600.0))
                .with("step", format!("{step:.3}"));
            return slip(Channel::Time, Unit::Second, Unit::Millisecond, evidence);
        }
    }
    let longest = records.iter().map(|r| r.amplitude).fold(0.0, f64::max);
    if !insisted(Channel::Displacement) && longest < SHORTEST && damping > STIFFEST && strongest > WEAK {
        let evidence = Sentence::from(phrases::TOO_STIFF)
            .with("amplitude", format!("{:.4}", 1e3 * longest))
            .with("force", format!("{:.0}", half(fastest)))
            .with("velocity", format!("{:.3}", 1e3 * fastest.peak_velocity))
            .with("damping", format!("{damping:.1e}"));
        return slip(Channel::Displacement, Unit::Millimetre, Unit::Metre, evidence);
    }
    let is_weak = strongest < WEAK && damping < WEAKEST && fastest.peak_velocity > MOVING;
    // A dead load cell is weak too, but what it shows has nothing to do with the motion.
    if !insisted(Channel::Force) && is_weak && follows(fastest) {
        let evidence = Sentence::from(phrases::TOO_WEAK)
            .with("count", records.len())
            .with("strongest", format!("{strongest:.3}"))
            .with("test", &fastest.name)
            .with("force", format!("{:.3}", half(fastest)))
            .with("velocity", format!("{:.3}", fastest.peak_velocity))
            .with("damping", format!("{damping:.2}"));
        return slip(Channel::Force, Unit::Newton, Unit::Kilonewton, evidence);
    }
    Ok(())
}

/// Correlation of force and velocity above which the one follows the other, in whatever unit it is written.
const FOLLOWS: f64 = 0.3;

/// Whether the force of a record has to do with its motion.
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

    /// A damper with a force at 1 m/s, and friction, tested at some amplitudes and peak speeds; units slip by factors.
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
        refuse(records, &Options::default()).map_or_else(|e| e.to_string(), |()| String::new())
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
                    // Friction of a small damper is a few newtons too; a slow test shows little else.
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
                // Time read a thousandfold short is absurd at once where the speed is.
                let message = said(&records);
                assert!(message.contains(wanted), "{force} {slip:?}: {message}");
            }
        }
        let mut options = Options::default();
        options.units.insert(Channel::Force, Unit::Newton);
        assert!(refuse(&campaign(2000.0, 50.0, &USUAL, [1.0, 1.0, 1e-3]), &options).is_ok());
    }
}
