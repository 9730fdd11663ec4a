//! Corrects a record by the measurement error that a fit found, so that a comparison with the model shows only
//! differences from the damper.

use super::delayed_motion::DelayedMotion;
use super::smoothing::smooth;
pub use crate::data::measurement_error::MeasurementError;
use crate::data::record::{Note, Record};
use crate::messages::phrases;

impl MeasurementError {
    /// Returns the measurement error that the user stated for the first record, or no error for an empty list. All
    /// records of one campaign have the same stated error.
    pub fn stated(records: &[&Record]) -> MeasurementError {
        records.first().map_or(MeasurementError::NONE, |record| record.stated_error)
    }
}

/// Removes the measurement error `off` from a record. Leaves out samples at an end of the record if their motion was
/// not recorded.
pub fn correct_record(record: &Record, off: &MeasurementError) -> Record {
    if *off == MeasurementError::NONE {
        return record.clone();
    }
    let mut right = if off.delay_s == 0.0 { record.clone() } else { earlier(record, off.delay_s) };
    for (force, t) in right.force.iter_mut().zip(&right.time) {
        let clock = right.clock_s + t;
        *force = (*force - off.zero_n_per_s * clock) / (1.0 + off.gain_per_s * clock);
    }
    correct_inertia(&mut right, off.mass_kg);
    right.apparent_delay_s -= if right.apparent_delay_s == 0.0 { 0.0 } else { off.delay_s };
    right.original_fingerprint = Some(record.fingerprint());
    right.notes.push(Note { kind: "corrected", text: phrases::TAKEN_OUT.into() });
    right
}

/// Subtracts the inertia force of a rig mass `mass`, kg, that moves with the damper's end.
pub(crate) fn correct_inertia(record: &mut Record, mass: f64) {
    if mass != 0.0 && !record.time.is_empty() {
        let acceleration = smooth(record).acceleration;
        record.force.iter_mut().zip(acceleration).for_each(|(force, a)| *force -= mass * a);
    }
}

/// Pairs every force with the motion `delay` seconds earlier.
fn earlier(record: &Record, delay: f64) -> Record {
    let earlier = DelayedMotion::new(&record.time, delay);
    let (from, to) = (earlier.range.start, earlier.range.end);
    let kept = |values: &[f64]| earlier.kept(values);
    Record {
        displacement: earlier.values(&record.displacement),
        velocity: earlier.values(&record.velocity),
        time: kept(&record.time),
        force: kept(&record.force),
        side_force: record.side_force.as_deref().map(kept),
        temperature: record.temperature.as_deref().map(kept),
        setting_signal: record.setting_signal.as_ref().map(|of| of.with_values(earlier.previous_values(&of.values))),
        // The motion is shifted to the force samples, so cycles keep their force samples.
        cycles: record
            .cycles
            .iter()
            .filter(|cycle| cycle.start >= from && cycle.end <= to)
            .map(|cycle| cycle.start - from..cycle.end - from)
            .collect(),
        ..record.clone()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_record_is_what_it_was_before_it_went_wrong() {
        let (n, h, omega) = (400, 2e-3, 20.0);
        let time: Vec<f64> = (0..n).map(|i| 100.0 + h * i as f64).collect();
        let x = |t: f64| 0.01 * libm::sin(omega * t);
        let v = |t: f64| 0.01 * omega * libm::cos(omega * t);
        let force = |t: f64| 3000.0 * v(t) + 2000.0 * x(t);
        let off = MeasurementError { delay_s: 3.3e-3, mass_kg: 3.0, gain_per_s: 1e-4, zero_n_per_s: 0.1 };
        let a = |t: f64| -0.01 * omega * omega * libm::sin(omega * t);
        let read = Record {
            displacement: time.iter().map(|t| x(*t)).collect(),
            velocity: time.iter().map(|t| v(*t)).collect(),
            force: time
                .iter()
                .map(|t| (t, force(t - off.delay_s) + off.mass_kg * a(t - off.delay_s)))
                .map(|(t, f)| f * (1.0 + off.gain_per_s * t) + off.zero_n_per_s * t)
                .collect(),
            time,
            amplitude: 0.01,
            frequency: omega / std::f64::consts::TAU,
            peak_velocity: 0.01 * omega,
            ..Record::default()
        };
        let right = correct_record(&read, &off);
        assert!(right.time.len() == n - 2 && right.time[0] == read.time[2]);
        for i in 4..n - 6 {
            let wanted = 3000.0 * right.velocity[i] + 2000.0 * right.displacement[i];
            assert!((right.force[i] - wanted).abs() < 0.1, "{i}: {} {wanted}", right.force[i]);
        }
        assert_eq!(correct_record(&read, &MeasurementError::NONE).force, read.force);
    }
}
