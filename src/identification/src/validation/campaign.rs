//! Validation of a whole campaign: figures of every test, of all tests together, and of the left-out tests.

use super::against::{Against, AgainstTest};
use super::compared::{Compared, ValidationError};
use super::deviation::{Errors, REGION_BOUNDARY};
use super::matrix::ErrorMatrix;
use super::of_test::TestValidation;
use super::response::StepResponse;
use super::setting_doubt::SettingDoubt;
use crate::family::is_of_grid;
use crate::limits::Certificate;
use dashpot_messages::Sentence;
use dashpot_records::{Unusable, is_same_setting};
use serde::Serialize;

/// Mean figures over a set of tests, with equal weight for each test regardless of its length.
///
/// The error in percent is the mean of the tests' errors in percent. The root mean square is the mean of the tests' root mean squares.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Summary {
    /// Number of tests.
    pub tests: usize,
    /// Mean errors.
    #[serde(flatten)]
    pub errors: Errors,
}

/// Errors of a model over a campaign. `dashpot validate` writes its JSON form.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Validation {
    /// Figures of every test, in the given order.
    pub tests: Vec<TestValidation>,
    /// Mean figures of all tests.
    pub overall: Summary,
    /// Mean figures of the tests that the identification used, or `None` without such tests.
    pub used_in_fit: Option<Summary>,
    /// Mean figures of the tests that the identification did not use, or `None` without such tests.
    pub left_out: Option<Summary>,
    /// Errors by amplitude and peak velocity.
    pub matrix: ErrorMatrix,
    /// Speed that separates region 1 from region 2, m/s.
    pub region_boundary_m_s: f64,
    /// Errors at each setting; empty if the damper has no setting.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub settings: Vec<SettingSummary>,
    /// Errors of the tests in which the setting changes, or `None` without such tests.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub changing: Option<ChangingSummary>,
    /// Responses to steps of the setting, or empty if no test has steps.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub step_responses: Vec<StepResponse>,
    /// Tests whose forces are those of another setting than the stated one, or empty.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub setting_doubts: Vec<SettingDoubt>,
    /// Errors of the model and of models of the literature on the same tests, or empty without a comparison.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub against: Vec<Against>,
    /// Results of the limits, or `None` without limits.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub limits: Option<Certificate>,
    /// Sentence about the measurement errors that the fit of the model found. It states whether the records were corrected. `None` without
    /// such errors.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub as_the_fit_saw: Option<Sentence>,
    /// Files and tests of the campaign that could not be used. No figure includes them.
    pub unusable: Vec<Unusable>,
}

/// Mean figures over the tests in which the setting changes.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ChangingSummary {
    /// Figures of the tests in which the setting changes.
    #[serde(flatten)]
    pub summary: Summary,
    /// Indices of the tests in which the setting changes, in [`Validation::tests`].
    #[serde(skip)]
    pub places: Vec<usize>,
}

/// Mean figures at one setting.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SettingSummary {
    /// Value of the setting.
    pub setting: f64,
    /// Whether the model file gives numbers at the setting. Otherwise, the numbers of the model are interpolated.
    pub is_of_grid: bool,
    /// Figures of the tests at the setting.
    #[serde(flatten)]
    pub summary: Summary,
    /// Indices of the tests at the setting, in [`Validation::tests`].
    #[serde(skip)]
    pub places: Vec<usize>,
}

impl Validation {
    /// Summarizes the tests by their setting. The lowest setting comes first. `settings` contains the setting of every test, `grid` the
    /// settings of the model file.
    ///
    /// `settings` has `None` for a test whose setting changes. These tests are summarized together.
    pub fn summarize_settings(&mut self, settings: &[Option<f64>], grid: &[f64]) {
        let all = 0..self.tests.len().min(settings.len());
        let (constant, changing): (Vec<usize>, Vec<usize>) = all.partition(|place| settings[*place].is_some());
        let errors: Vec<Errors> = changing.iter().map(|place| self.tests[*place].errors).collect();
        self.changing = Errors::mean(&errors)
            .map(|errors| ChangingSummary { summary: Summary { tests: changing.len(), errors }, places: changing });
        let settings: Vec<f64> = settings.iter().map(|setting| setting.unwrap_or(f64::NAN)).collect();
        let mut places = constant;
        places.sort_by(|a, b| settings[*a].total_cmp(&settings[*b]));
        let runs = places.chunk_by(|a, b| is_same_setting(settings[*a], settings[*b]));
        let of = |run: &[usize]| {
            let errors: Vec<Errors> = run.iter().map(|place| self.tests[*place].errors).collect();
            let setting = settings[run[0]];
            let is_of_grid = is_of_grid(grid, setting);
            let summary = Summary { tests: errors.len(), errors: Errors::mean(&errors)? };
            Some(SettingSummary { setting, is_of_grid, summary, places: run.to_vec() })
        };
        let found: Vec<SettingSummary> = runs.filter_map(of).collect();
        self.settings = found;
    }

    /// Returns the errors of the validated model in the format of the models of the literature.
    pub fn as_against(&self) -> Against {
        let test = |t: &TestValidation| AgainstTest {
            name: t.name.clone(),
            used_in_fit: t.used_in_fit,
            errors: t.errors.model,
        };
        Against::from_tests("MODEL", "the model that is validated", self.tests.iter().map(test).collect())
    }
}

/// Computes the figures of every test, and summarizes the tests.
///
/// # Errors
/// [`ValidationError`] for the first test that cannot be validated, or if there are no tests.
pub fn validate(compared: &[Compared<'_>]) -> Result<Validation, ValidationError> {
    compared.iter().try_for_each(Compared::check)?;
    let tests: Vec<TestValidation> = compared.iter().map(TestValidation::from_compared).collect();
    let summary = |wanted: &dyn Fn(&TestValidation) -> bool| {
        let errors: Vec<Errors> = tests.iter().filter(|test| wanted(test)).map(|test| test.errors).collect();
        Errors::mean(&errors).map(|mean| Summary { tests: errors.len(), errors: mean })
    };
    Ok(Validation {
        overall: summary(&|_| true).ok_or(ValidationError::NoTests)?,
        used_in_fit: summary(&|test| test.used_in_fit),
        left_out: summary(&|test| !test.used_in_fit),
        matrix: ErrorMatrix::from_tests(&tests),
        region_boundary_m_s: REGION_BOUNDARY,
        settings: Vec::new(),
        changing: None,
        step_responses: Vec::new(),
        setting_doubts: Vec::new(),
        against: Vec::new(),
        limits: None,
        as_the_fit_saw: None,
        unusable: Vec::new(),
        tests,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use dashpot_records::Record;

    fn record(name: &str, scale: f64) -> Record {
        let velocity = vec![0.1, 0.9, -0.1, -0.9];
        Record {
            name: name.into(),
            time: vec![0.0, 1.0, 2.0, 3.0],
            displacement: vec![0.0; 4],
            force: velocity.iter().map(|v| scale * v).collect(),
            velocity,
            peak_velocity: 0.9,
            ..Record::default()
        }
    }

    fn shifted<'a>(record: &'a Record, model: f64, fv_only: f64, used_in_fit: bool) -> Compared<'a> {
        let by = |offset: f64| record.force.iter().map(|force| force + offset).collect();
        Compared { record, model: by(model), fv_only: by(fv_only), used_in_fit }
    }

    #[test]
    fn fitted_and_left_out_tests_are_told_apart() {
        let (a, b) = (record("a", 1000.0), record("b", 2000.0));
        let got = validate(&[shifted(&a, 9.0, 18.0, true), shifted(&b, -36.0, 54.0, false)]).unwrap();
        let figures = |summary: &Summary| (summary.tests, summary.errors.model.mean_error_n.round());
        assert_eq!(figures(&got.overall), (2, 23.0));
        assert_eq!(figures(got.used_in_fit.as_ref().unwrap()), (1, 9.0));
        assert_eq!(figures(got.left_out.as_ref().unwrap()), (1, 36.0));
        assert!((got.overall.errors.model.error_percent - 1.5).abs() < 1e-12, "mean of 1 % and 2 %");
        assert!((got.overall.errors.fv_only.error_percent - 2.5).abs() < 1e-12, "mean of 2 % and 3 %");
        assert!(validate(&[shifted(&a, 1.0, 1.0, true)]).unwrap().left_out.is_none());
    }

    #[test]
    fn the_written_keys_are_the_promised_ones() {
        // Scripts read these keys. A changed key breaks them.
        const ERRORS: [&str; 5] = ["mean_error_n", "error_percent", "region1_n", "region2_n", "rmse_n"];
        let a = record("a", 1000.0);
        let validation = validate(&[shifted(&a, 9.0, 18.0, true)]).unwrap();
        let written = toml::Value::try_from(&validation).unwrap();
        let (test, overall) = (&written["tests"][0], &written["overall"]);
        for key in ["name", "amplitude_m", "frequency_hz", "peak_velocity_m_s", "max_force_n"] {
            assert!(test.get(key).is_some(), "{key}");
        }
        for key in ERRORS {
            assert!(test.get(key).is_some_and(toml::Value::is_float), "{key}");
            assert!(overall.get(key).is_some_and(toml::Value::is_float), "{key}");
        }
        for key in ["mean_error_n", "error_percent", "rmse_n"] {
            assert!(test["fv_only"].get(key).is_some(), "{key}");
            assert!(overall["fv_only"].get(key).is_some(), "{key}");
        }
    }

    #[test]
    fn tests_are_summarized_by_their_setting() {
        let (a, b, c) = (record("a", 1000.0), record("b", 2000.0), record("c", 2000.0));
        let all = [shifted(&a, 9.0, 18.0, true), shifted(&b, 36.0, 54.0, false), shifted(&c, 18.0, 54.0, false)];
        let mut got = validate(&all).unwrap();
        got.summarize_settings(&[Some(1.6), Some(0.4), Some(0.4)], &[0.0, 1.6]);
        let told: Vec<(f64, bool, usize, f64)> = got
            .settings
            .iter()
            .map(|s| (s.setting, s.is_of_grid, s.summary.tests, s.summary.errors.model.mean_error_n.round()))
            .collect();
        assert_eq!(told, [(0.4, false, 2, 27.0), (1.6, true, 1, 9.0)]);
        assert_eq!(got.settings[0].places, [1, 2]);
    }

    #[test]
    fn nothing_to_compare_is_an_error() {
        assert_eq!(validate(&[]), Err(ValidationError::NoTests));
    }
}
