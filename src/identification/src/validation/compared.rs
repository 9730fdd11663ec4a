//! Measured test with its simulated forces, and the checks before a comparison of them.

use dashpot_records::Record;

/// A measured test with the simulated forces at its samples.
#[derive(Debug, Clone)]
pub struct Compared<'a> {
    /// The measured test.
    pub record: &'a Record,
    /// Force of the full model at every sample of the record, N.
    pub model: Vec<f64>,
    /// Force of the force–velocity curve alone at every sample of the record, N.
    pub fv_only: Vec<f64>,
    /// Whether the identification used the test. Only a left-out test is an independent check.
    pub used_in_fit: bool,
}

/// Reason why measured and simulated forces cannot be compared.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum ValidationError {
    /// There is no test.
    #[error("no test to validate against: name at least one record")]
    NoTests,
    /// A test has no samples.
    #[error("test '{test}' has no samples: leave it out or look at what cleaning removed")]
    NoSamples {
        /// Name of the test.
        test: String,
    },
    /// The length of a series differs from the length of the record.
    #[error(
        "test '{test}': {series} has {got} samples, the force has {expected}: simulate at the record's own samples"
    )]
    Length {
        /// Name of the test.
        test: String,
        /// Name of the series.
        series: &'static str,
        /// Number of samples of the measured force.
        expected: usize,
        /// Number of samples of the series.
        got: usize,
    },
    /// A measured or simulated value is not finite.
    #[error("test '{test}': {series} is not a finite number at sample {sample}: {advice}")]
    NotFinite {
        /// Name of the test.
        test: String,
        /// Name of the series.
        series: &'static str,
        /// Sample number, counted from 1.
        sample: usize,
        /// Remedy.
        advice: &'static str,
    },
    /// A cycle extends beyond its record.
    #[error("test '{test}': cycle {cycle} reaches beyond the last sample: derive the cycles again after cleaning")]
    Cycle {
        /// Name of the test.
        test: String,
        /// Cycle number, counted from 1.
        cycle: usize,
    },
    /// All measured forces are zero, so an error in percent is undefined.
    #[error("test '{test}': the measured force is zero throughout: was the load cell connected?")]
    NoForce {
        /// Name of the test.
        test: String,
    },
}

impl Compared<'_> {
    /// Rejects data that cannot be compared, so that all later figures are finite.
    pub(super) fn check(&self) -> Result<(), ValidationError> {
        const RECORD: &str = "clean the record first";
        const SIMULATED: &str = "the simulation diverged, check the model's parameters";
        let record = self.record;
        let test = || record.name.clone();
        let expected = record.force.len();
        if expected == 0 {
            return Err(ValidationError::NoSamples { test: test() });
        }
        let series: [(&'static str, &[f64], &'static str); 6] = [
            ("the measured force", &record.force, RECORD),
            ("the time", &record.time, RECORD),
            ("the displacement", &record.displacement, RECORD),
            ("the velocity", &record.velocity, RECORD),
            ("the model's force", &self.model, SIMULATED),
            ("the force of the force–velocity curve", &self.fv_only, SIMULATED),
        ];
        for (series, values, advice) in series {
            if values.len() != expected {
                return Err(ValidationError::Length { test: test(), series, expected, got: values.len() });
            }
            if let Some(at) = values.iter().position(|value| !value.is_finite()) {
                return Err(ValidationError::NotFinite { test: test(), series, sample: at + 1, advice });
            }
        }
        if let Some(at) = record.cycles.iter().position(|cycle| cycle.start > cycle.end || cycle.end > expected) {
            return Err(ValidationError::Cycle { test: test(), cycle: at + 1 });
        }
        if record.force.iter().all(|force| *force == 0.0) {
            return Err(ValidationError::NoForce { test: test() });
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn record() -> Record {
        Record {
            name: "a".into(),
            time: vec![0.0, 0.1],
            displacement: vec![0.0, 0.0],
            velocity: vec![0.0, 1.0],
            force: vec![1.0, 2.0],
            ..Record::default()
        }
    }

    fn refusal(record: &Record, model: Vec<f64>) -> ValidationError {
        let fv_only = vec![0.0; record.force.len()];
        Compared { record, model, fv_only, used_in_fit: false }.check().unwrap_err()
    }

    #[test]
    fn a_diverged_model_is_named_with_its_test_and_sample() {
        let text = refusal(&record(), vec![1.0, f64::NAN]).to_string();
        assert!(text.contains("'a'") && text.contains("model") && text.contains("sample 2"), "{text}");
    }

    #[test]
    fn series_of_another_length_are_refused() {
        let error = refusal(&record(), vec![1.0]);
        assert!(matches!(error, ValidationError::Length { expected: 2, got: 1, .. }), "{error}");
    }

    #[test]
    fn a_dead_load_cell_is_refused() {
        let dead = Record { force: vec![0.0, 0.0], ..record() };
        assert_eq!(refusal(&dead, vec![1.0, 1.0]), ValidationError::NoForce { test: "a".into() });
    }

    #[test]
    #[expect(clippy::single_range_in_vec_init, reason = "one cycle is one range")]
    fn a_cycle_beyond_the_record_is_refused() {
        let torn = Record { cycles: vec![0..3], ..record() };
        assert_eq!(refusal(&torn, vec![1.0, 1.0]), ValidationError::Cycle { test: "a".into(), cycle: 1 });
    }
}
