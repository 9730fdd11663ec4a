//! Finds tests that end within their first cycle, because an export was incomplete or a rig stopped.

use crate::cleaning::turning_points;
use crate::data::record::{Note, Record};
use crate::messages::phrases;
use crate::numbers::{median, range};
use crate::tuning::truncated_test::{LAST, MOVING, OF_A_CYCLE, STROKE};
use dashpot_messages::{Sentence, format_decimals};

/// Adds notes about tests that contain less than a cycle and end while the damper moves.
pub(crate) fn report(records: &[Record], notes: &mut Vec<Note>) {
    for record in records.iter().filter(|r| r.cycles.is_empty()) {
        let strokes = turning_points(&record.displacement, STROKE * range(&record.displacement)).len();
        let from = record.velocity.len().saturating_sub(LAST);
        let last = median(&mut record.velocity[from..].iter().map(|v| v.abs()).collect::<Vec<_>>());
        if strokes < OF_A_CYCLE && last > MOVING * record.peak_velocity {
            let text = Sentence::from(phrases::TORN)
                .with("test", &record.source)
                .with("velocity", format_decimals(1e3 * last, 1))
                .with("peak", format_decimals(1e3 * record.peak_velocity, 1));
            notes.push(Note { kind: "torn", text });
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    #[test]
    fn a_test_that_ends_within_its_first_stroke_is_told_and_a_ramp_to_rest_is_not() {
        let describe = |of: &dyn Fn(f64) -> (f64, f64)| {
            let (displacement, velocity): (Vec<f64>, Vec<f64>) = (0..200).map(|i| of(0.005 * f64::from(i))).unzip();
            let peak_velocity = velocity.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
            let record = Record { displacement, velocity, peak_velocity, ..Record::default() };
            let mut notes = Vec::new();
            report(&[record], &mut notes);
            notes.len()
        };
        // A sine that stops after a little more than half a cycle gives a note. A sine that ends at its turning point
        // gives none.
        assert_eq!(describe(&|t| ((3.6 * t).sin(), 3.6 * (3.6 * t).cos())), 1);
        assert_eq!(describe(&|t| ((4.71 * t).sin(), 4.71 * (4.71 * t).cos())), 0);
        // A motion from standstill to standstill and a motion of two cycles give no note.
        assert_eq!(describe(&|t| (-(PI * t).cos(), PI * (PI * t).sin())), 0);
        assert_eq!(describe(&|t| ((12.5 * t).sin(), 12.5 * (12.5 * t).cos())), 0);
    }
}
