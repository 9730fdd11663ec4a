//! Comparison with models of the literature, each identified from the tests that the model was fitted to.

use super::compared::Compared;
use super::deviation::Deviation;
use crate::literature::Literature;
use serde::Serialize;

/// A model of the literature and how close it comes.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Against {
    /// Its name on the command line.
    pub model: String,
    /// The model in words.
    pub meaning: String,
    /// Its errors on every test, in the order of the validation's tests.
    pub tests: Vec<AgainstTest>,
    /// Mean errors on the tests that it was identified from.
    pub used_in_fit: Option<AgainstSummary>,
    /// Mean errors on the tests left out.
    pub left_out: Option<AgainstSummary>,
    /// The model with its numbers; absent for the model that is validated.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub numbers: Option<Literature>,
}

/// Errors on one test.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct AgainstTest {
    /// Name of the test.
    pub name: String,
    /// Whether the model was identified from it.
    pub used_in_fit: bool,
    /// Its errors.
    #[serde(flatten)]
    pub errors: Deviation,
}

/// Mean errors over a set of tests, each with equal weight.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct AgainstSummary {
    /// Number of tests.
    pub tests: usize,
    /// Mean errors.
    #[serde(flatten)]
    pub errors: Deviation,
}

impl Against {
    /// Measures forces of a model on every compared test.
    pub fn measure(model: &str, meaning: &str, compared: &[Compared<'_>], forces: &[Vec<f64>]) -> Against {
        let tests = compared
            .iter()
            .zip(forces)
            .map(|(c, forces)| {
                let record = c.record;
                let top = record.force.iter().fold(0.0f64, |m, f| m.max(f.abs()));
                let errors = Deviation::of_test(forces, &record.force, &record.velocity, top);
                AgainstTest { name: record.name.clone(), used_in_fit: c.used_in_fit, errors }
            })
            .collect();
        Self::from_tests(model, meaning, tests)
    }

    /// From errors test by test.
    pub(super) fn from_tests(model: &str, meaning: &str, tests: Vec<AgainstTest>) -> Against {
        let summary = |used: bool| {
            let errors: Vec<Deviation> = tests.iter().filter(|t| t.used_in_fit == used).map(|t| t.errors).collect();
            (!errors.is_empty()).then(|| AgainstSummary { tests: errors.len(), errors: Deviation::mean(&errors) })
        };
        Against {
            model: model.to_owned(),
            meaning: meaning.to_owned(),
            used_in_fit: summary(true),
            left_out: summary(false),
            tests,
            numbers: None,
        }
    }
}
