//! Comparison with models of the literature. Each of them is identified from the tests that the fit of the validated model used.

use super::compared::Compared;
use super::deviation::Deviation;
use crate::literature::Literature;
use serde::Serialize;

/// Errors of a model of the literature, or of the validated model in the same format.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Against {
    /// Name of the model on the command line.
    pub model: String,
    /// Description of the model.
    pub meaning: String,
    /// Errors on every test, in the order of the validation's tests.
    pub tests: Vec<AgainstTest>,
    /// Mean errors on the tests that the fit of the validated model used, or `None` without such tests.
    pub used_in_fit: Option<AgainstSummary>,
    /// Mean errors on all other tests, or `None` without such tests.
    pub left_out: Option<AgainstSummary>,
    /// The model with its parameters, or `None` for the validated model.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub numbers: Option<Literature>,
}

/// Errors of a model on one test.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct AgainstTest {
    /// Name of the test.
    pub name: String,
    /// Whether the fit of the validated model used this test.
    pub used_in_fit: bool,
    /// Errors of the model.
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
    /// Computes the errors of a model's forces on every compared test.
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

    /// Summarizes the errors of the tests.
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
