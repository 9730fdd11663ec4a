//! Correction of records for the measurement errors that the fit of a model found.
//!
//! Measurement errors belong to the campaign and not to the damper, so no model contains them. Without a correction, a validation or
//! diagnosis of the same campaign would attribute them to the model.

use super::model_file::Identification;
use super::of_the_rig::{Measured, to_measurement_error};
use super::phrases;
use dashpot_messages::Sentence;
use dashpot_records::measurement_correction::{MeasurementError, correct_record};
use dashpot_records::{Note, Record};
use rayon::prelude::*;

/// Kind of a [`Note`] on the measurement errors that a fit found. The note reports that the records were corrected for them, or that the
/// fit used none of these records.
pub const AS_THE_FIT_SAW: &str = "as_the_fit_saw";

impl Identification {
    /// Returns the measurement errors that the fit found in its records.
    pub fn measured(&self) -> Vec<Measured> {
        self.measurement.iter().filter_map(|(name, numbers)| Measured::named(name, *numbers)).collect()
    }

    /// Corrects the records in place for the measurement errors that the fit found. Returns a note, or `None` if the fit found no error.
    ///
    /// If the fit used at least one of these records, all of them count as records of the fit's rig and campaign, even left-out ones. If
    /// the fit used none of them, they stay unchanged. The note then reports the errors that the fit found in its own records.
    pub fn right<'r>(&self, records: impl IntoIterator<Item = &'r mut Record>) -> Option<Note> {
        let measured = self.measured();
        let off = to_measurement_error(&measured);
        if off == MeasurementError::NONE {
            return None;
        }
        let records: Vec<&mut Record> = records.into_iter().collect();
        let found: Vec<Sentence> = measured.iter().map(Measured::finding).collect();
        if !records.iter().any(|record| self.used(record)) {
            let options: Vec<String> = measured.iter().filter_map(Measured::as_option).collect();
            let option = (!options.is_empty())
                .then(|| Sentence::from(phrases::IF_THE_SAME_RIG).with("options", options.join(" ")));
            let text = Sentence::from(phrases::FOUND_IN_ITS_OWN)
                .with_list("findings", found, phrases::THAT)
                .with_any("option", option);
            return Some(Note { kind: AS_THE_FIT_SAW, text });
        }
        records.into_par_iter().for_each(|record| {
            // Drifts count from the start of the fit's own campaign. The given records may be only a part of that campaign, so their own
            // start may be later.
            if let (Some(from), Some(begins)) = (self.clock_from, record.begins) {
                record.clock_s = begins - from;
            }
            // The reader has already corrected the errors that the user stated. So only the difference between found and stated errors is
            // corrected here.
            *record = correct_record(record, &off.beyond(&record.stated_error));
        });
        let text = Sentence::from(phrases::TAKEN_OUT_AS_THE_FIT_DID);
        let text = text.with_list("findings", found, phrases::SEMICOLON);
        Some(Note { kind: AS_THE_FIT_SAW, text })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn record(frequency: f64) -> Record {
        let omega = std::f64::consts::TAU * frequency;
        let time: Vec<f64> = (0..500).map(|k| k as f64 / (100.0 * frequency)).collect();
        Record {
            name: format!("{frequency}"),
            displacement: time.iter().map(|t| 0.01 * libm::sin(omega * t)).collect(),
            velocity: time.iter().map(|t| 0.01 * omega * libm::cos(omega * t)).collect(),
            force: time.iter().map(|t| -2.0 * 0.01 * omega * omega * libm::sin(omega * t)).collect(),
            time,
            amplitude: 0.01,
            frequency,
            peak_velocity: 0.01 * omega,
            ..Record::default()
        }
    }

    #[test]
    fn the_rig_is_taken_out_of_its_own_campaign_and_of_no_other() {
        let mut own = vec![record(1.0), record(4.0)];
        let identification = Identification {
            fingerprints: vec![own[0].fingerprint()],
            measurement: [("rig_mass".to_owned(), [2.0, 1.9, 2.1])].into(),
            ..Identification::default()
        };
        let note = identification.right(&mut own).unwrap();
        assert!(note.text.to_string().contains("2.00 kg"), "{}", note.text);
        let top = 2.0 * 0.01 * (std::f64::consts::TAU * 4.0f64).powi(2);
        for record in &own {
            let left = record.force[20..480].iter().fold(0.0f64, |most, f| most.max(f.abs()));
            assert!(left < 0.01 * top, "{}: {left} of {top}", record.name);
        }
        assert!(identification.used(&own[0]) && !identification.used(&own[1]), "a record is still itself");
        let mut given = record(1.0);
        given.stated_error.mass_kg = 2.0;
        let fingerprint = Identification { fingerprints: vec![given.fingerprint()], ..identification.clone() };
        let before = given.force.clone();
        assert!(fingerprint.right([&mut given]).is_some() && given.force == before, "the user had given it");
        let mut other = vec![record(2.0)];
        let before = other[0].force.clone();
        let note = identification.right(&mut other).unwrap();
        assert!(other[0].force == before && note.text.to_string().contains("--rig-mass=2.0"), "{}", note.text);
        assert!(Identification::default().right(&mut own).is_none());
    }
}
