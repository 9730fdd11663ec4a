//! Comparison of a damper's temperature with that of the reference.
//!
//! A change of temperature changes gas and oil, and appears as a change of the damper or of its rig.

use super::phrases;
use dashpot_messages::Sentence;
use dashpot_records::Record;

/// Difference of a test's mean temperatures on damper and reference, K, above which it is reported.
///
/// At this difference, the gas force differs by 3 %. The valve forces of dampers of one series differ as much, so a
/// smaller difference of temperature needs no report.
const WARMER: f64 = 8.0;

/// Returns the mean temperature of a record, °C, if the temperature was recorded.
fn mean_temperature(record: &Record) -> Option<f64> {
    let known: Vec<f64> = record.temperature.as_ref()?.iter().copied().filter(|t| t.is_finite()).collect();
    (!known.is_empty()).then(|| known.iter().sum::<f64>() / known.len() as f64)
}

/// Reports the test whose mean temperature differs most from that of the test of equal name on the reference. Returns
/// `None` if the difference is at most [`WARMER`], or if temperatures are unknown.
pub(super) fn warmer(records: &[&Record], reference: &[Record]) -> Option<Sentence> {
    let pair = |record: &Record| {
        let there = reference.iter().find(|other| other.name == record.name)?;
        Some((record.name.clone(), mean_temperature(record)?, mean_temperature(there)?))
    };
    let apart = |(_, here, there): &(String, f64, f64)| (here - there).abs();
    let furthest = records.iter().copied().filter_map(pair).max_by(|a, b| apart(a).total_cmp(&apart(b)))?;
    let (test, here, there) = &furthest;
    let sense = if here > there { phrases::WARMER_SENSE } else { phrases::COLDER_SENSE };
    (apart(&furthest) > WARMER).then(|| {
        Sentence::from(phrases::WARMER)
            .with("kelvin", format!("{:.0}", apart(&furthest)))
            .with_sentence("sense", sense)
            .with("test", test)
            .with("here", format!("{here:.0}"))
            .with("there", format!("{there:.0}"))
    })
}
