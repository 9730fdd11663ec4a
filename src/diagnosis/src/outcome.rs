//! Outcome of a diagnosis: the JSON output for scripts, and the curves for the report.

use super::changes::Change;
use super::tree::Branch;
use dashpot_core::Params;
use dashpot_estimation::prior_set::PriorSet;
use dashpot_estimation::structure::inventory::InventoryItem;
use dashpot_messages::Sentence;
use serde::Serialize;
use std::collections::BTreeMap;

/// Verdict of a diagnosis.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Verdict {
    /// At least one effect was named and added.
    Named,
    /// The residual is at the level of the noise, or within the form error of the curves.
    NothingMissing,
    /// No effect is missing, but parameters differ from those of the reference damper: see [`Diagnosis::changes`].
    Changed,
    /// An effect is missing, and several effects explain the disagreement of model and records equally well.
    #[serde(rename = "cannot_tell")]
    Ambiguous,
    /// An effect is missing, and no known effect explains the disagreement of model and records.
    UnknownEffect,
}

impl Verdict {
    /// Returns whether no effect is missing. The parameters of the model may differ from those of a reference.
    pub fn nothing_is_missing(self) -> bool {
        matches!(self, Verdict::NothingMissing | Verdict::Changed)
    }
}

/// All results of a diagnosis.
#[derive(Debug, Clone, Serialize)]
pub struct Diagnosis {
    /// Verdict of the diagnosis.
    pub verdict: Verdict,
    /// Summary in sentences.
    pub summary: Sentence,
    /// Named effects, most probable first.
    pub findings: Vec<Finding>,
    /// Every effect of the given and of the most probable model, with its force and its probability.
    pub inventory: Vec<InventoryItem>,
    /// Smallest set of changes that explains the difference from a reference, largest force first.
    pub changes: Vec<Change>,
    /// Effects that are not named but may explain the disagreement of model and records, or its remainder. Most
    /// probable first.
    pub suspects: Vec<Rival>,
    /// Regions where model and records disagree before any effect is added, worst first.
    #[serde(rename = "where")]
    pub regions: Vec<Region>,
    /// Errors of the given model after a refit.
    pub before: Figures,
    /// Errors of the model with all findings.
    pub after: Figures,
    /// Fraction of the given model's error above the noise that the improved model removes. It is computed on the
    /// left-out tests, or on the fitted tests if none is left out. `None` if the error above the noise is at most 2 %
    /// of the noise, or if the best structure is that of the given model.
    pub gap_closed: Option<f64>,
    /// Fraction of the disagreement that the improved model does not explain. The disagreement is the mean square
    /// residual in excess of noise.
    pub unexplained_fraction: f64,
    /// All probabilities of the search as a tree with the levels path, family, effect and form.
    pub tree: Vec<Branch>,
    /// Proposed tests that give more information.
    pub next_tests: Vec<NextTest>,
    /// Effects that these records cannot show.
    pub could_not_test: Vec<CouldNotTest>,
    /// Parameters of the given model that changed by more than three standard deviations when effects were added.
    pub shifts: Vec<Shift>,
    /// Remarks on the records, the reference, the named effects and the priors.
    pub notes: Vec<Sentence>,
    /// Note about the limits of a name without a reference, or about the method of comparison with a reference. It is
    /// one of `notes`.
    #[serde(skip)]
    pub about_the_reference: Option<Sentence>,
    /// Errors of each test with the given and the improved model.
    pub tests: Vec<TestOutcome>,
    /// Effects that were tried in addition to the best structure, most probable first. The outer list has one element,
    /// for the last iteration of the search.
    pub iterations: Vec<Vec<Trial>>,
    /// The given model after a refit.
    #[serde(skip)]
    pub base: Params,
    /// The model with the findings that belong to the damper.
    #[serde(skip)]
    pub improved: Params,
    /// The given model fitted to the reference damper, if there is a reference.
    #[serde(skip)]
    pub reference: Option<Params>,
    /// Estimates of the improved model's parameters.
    #[serde(skip)]
    pub estimates: Vec<dashpot_identification::Estimate>,
    /// Measurement errors that the file of the improved model states. They are used to correct these records when they
    /// are read again with that model.
    #[serde(skip)]
    pub measured: Vec<dashpot_identification::Measured>,
    /// Prior knowledge of the damper, in addition to its records.
    #[serde(skip)]
    pub priors: PriorSet,
    /// Estimated measurement errors of the rig in the best structure, in SI units, by name. They are corrected only in
    /// the comparison of forces; the improved model does not contain them.
    pub corrections: BTreeMap<&'static str, f64>,
}

/// A named effect.
#[derive(Debug, Clone, Serialize)]
pub struct Finding {
    /// Name of the effect.
    pub effect: &'static str,
    /// Form with the best fit. Empty if the effect has only one form.
    pub form: &'static str,
    /// Description in one line.
    pub meaning: &'static str,
    /// Location in the force path.
    pub path: &'static str,
    /// Family of the effect: similar effects at the same location.
    pub family: &'static str,
    /// Calibrated probability that the name is correct: the fraction of correct names among names with such a
    /// probability.
    pub confidence: f64,
    /// Probability that the family is correct.
    pub family_confidence: f64,
    /// Fraction of the disagreement that reopens if the effect is removed. The disagreement is the mean square residual
    /// in excess of noise.
    pub fraction: f64,
    /// Force of the effect, N rms.
    pub force_n_rms: f64,
    /// Whether the effect belongs to the rig. The comparison then corrects it, and the model does not contain it.
    pub of_the_rig: bool,
    /// Parameters of the effect.
    pub parameters: BTreeMap<&'static str, Value>,
    /// Fraction of the given model's error above the noise that this effect removes. It is computed on the left-out
    /// tests, or on the fitted tests if none is left out.
    pub gap_closed: Option<f64>,
    /// Statistics that support the confidence.
    pub evidence: Evidence,
    /// Alternative names, most probable first.
    pub rivals: Vec<Rival>,
}

/// A parameter value with its 95 % interval.
#[derive(Debug, Clone, Copy, Serialize)]
pub struct Value {
    /// Best value.
    pub value: f64,
    /// Lower end of the interval.
    pub low: f64,
    /// Upper end of the interval.
    pub high: f64,
    /// Unit of value and interval.
    pub unit: &'static str,
    /// Whether the value is typical of dampers, or of rigs for a measurement error.
    pub plausible: bool,
}

/// Effect that may explain a disagreement of model and records, in addition to the named effects or instead of one.
#[derive(Debug, Clone, Serialize)]
pub struct Rival {
    /// Name of the effect.
    pub effect: &'static str,
    /// Probability that this name is correct.
    pub confidence: f64,
    /// Fraction of the disagreement of model and records that the effect explains. The disagreement is the mean square
    /// residual in excess of noise.
    pub fraction: f64,
    /// Reason why the effect was not named.
    pub why: Sentence,
}

/// A region where model and records disagree.
#[derive(Debug, Clone, Serialize)]
pub struct Region {
    /// Name of a test, or "all" if the region comes from all tests.
    pub test: String,
    /// Range of velocities, m/s, rebound positive.
    pub velocity_m_s: [f64; 2],
    /// Range of displacements, m.
    pub displacement_m: [f64; 2],
    /// `rebound` or `compression`: direction of the velocity.
    pub direction: &'static str,
    /// `speeding_up`, `slowing_down` or `both`: change of the speed.
    pub acceleration: &'static str,
    /// Root mean square of measured minus computed force in the region, N.
    pub rmse_n: f64,
    /// Mean of measured minus computed force in the region, N.
    pub mean_n: f64,
    /// Root mean square noise of the mean cycles in the region, N.
    pub noise_n: f64,
    /// Description of the region in a sentence.
    pub text: Sentence,
}

/// Errors of a model.
#[derive(Debug, Clone, Copy, Serialize)]
pub struct Figures {
    /// Root mean square error over the fitted tests, N.
    pub rmse_n: f64,
    /// Mean absolute error relative to the largest force of the test, averaged over all tests, percent.
    pub error_percent: f64,
    /// Root mean square error over the left-out tests, N.
    pub left_out_rmse_n: Option<f64>,
    /// Root mean square noise of the fitted tests' mean cycles, N: the residual of a perfect model.
    pub noise_n: f64,
    /// Root mean square noise of the left-out tests' mean cycles, N: the residual of a perfect model.
    pub left_out_noise_n: Option<f64>,
}

/// Proposed rig test.
#[derive(Debug, Clone, Serialize)]
pub struct NextTest {
    /// Instruction for the rig, and the information that the test is expected to give.
    pub text: Sentence,
    /// Amplitude, m.
    pub amplitude_m: Option<f64>,
    /// Frequency, Hz.
    pub frequency_hz: Option<f64>,
    /// Mean displacement, m, in the direction and from the zero of the campaign's files.
    pub mean_displacement_m: Option<f64>,
    /// Side force, N.
    pub side_force_n: Option<f64>,
    /// Root mean square difference between the forces that the two effects in `separates` predict for this test, N.
    pub difference_n: Option<f64>,
    /// Names of the effects that the test distinguishes.
    pub separates: Vec<&'static str>,
}

/// An effect that these records cannot show.
#[derive(Debug, Clone, Serialize)]
pub struct CouldNotTest {
    /// Name of the effect.
    pub effect: &'static str,
    /// Reason, and the test that would show the effect.
    pub why: Sentence,
}

/// Parameter of the given model that changed when effects were added.
#[derive(Debug, Clone, Serialize)]
pub struct Shift {
    /// Name of the parameter.
    pub parameter: &'static str,
    /// Value in the given model.
    pub before: f64,
    /// Value in the improved model.
    pub after: f64,
    /// Unit.
    pub unit: &'static str,
}

/// Errors of one test with the given and the improved model.
#[derive(Debug, Clone, Serialize)]
pub struct TestOutcome {
    /// Name of the test.
    pub test: String,
    /// Whether the test was left out of all refits, so that it checks the improved model.
    pub left_out: bool,
    /// Root mean square error of the given model, N.
    pub before_rmse_n: f64,
    /// Root mean square error of the improved model, N.
    pub after_rmse_n: f64,
    /// Standard deviation of the noise of one sample of the mean cycle, N.
    pub noise_n: f64,
    /// Error that noise and the form of curves are expected to cause, N. [`Diagnosis::gap_closed`] measures the errors
    /// of this test in units of this value.
    pub allowed_n: f64,
    /// Curves of the mean cycle.
    #[serde(skip)]
    pub curves: Curves,
}

impl TestOutcome {
    /// Returns whether the improved model misses the test: its error is more than twice the expected error.
    pub fn is_missed(&self) -> bool {
        self.after_rmse_n > super::decisions::MISSED * self.allowed_n
    }
}

/// Mean cycle of a test: motion, measured force, and the forces of the given and the improved model.
#[derive(Debug, Clone, Default)]
pub struct Curves {
    /// Displacement, m.
    pub displacement: Vec<f64>,
    /// Velocity, m/s.
    pub velocity: Vec<f64>,
    /// Measured force, N.
    pub measured: Vec<f64>,
    /// Force of the given model, N.
    pub before: Vec<f64>,
    /// Force of the improved model, N.
    pub after: Vec<f64>,
    /// Frequency of the test, Hz, or 0 if the test has no cycles.
    pub frequency: f64,
}

/// Effect that was tried in addition to the best structure.
#[derive(Debug, Clone, Serialize)]
pub struct Trial {
    /// Name of the effect.
    pub effect: &'static str,
    /// Form of the effect.
    pub form: &'static str,
    /// Probability that this name is correct.
    pub confidence: f64,
    /// Statistics that support the probability.
    pub evidence: Evidence,
}

/// Statistics of a refit with an effect.
#[derive(Debug, Clone, Copy, Default, Serialize)]
pub struct Evidence {
    /// Fraction of the disagreement of model and records that the effect explains, as a ratio of mean squares in excess
    /// of noise.
    pub fraction: f64,
    /// Mean square residual of a test without the effect, in units of the squared error expected from noise and from
    /// the FV curve's form.
    pub mean_square_before: f64,
    /// Mean square residual of a test with the effect, in units of the squared error expected from noise and from the
    /// FV curve's form.
    pub mean_square_after: f64,
    /// Natural logarithm of the posterior odds with the effect relative to without the effect.
    ///
    /// Each test counts as 1.5 independent observations. The parameters of the effect are penalized.
    pub log_odds: f64,
    /// Number of parameters that the effect adds. Parameters that stay near their prior count half.
    pub numbers: f64,
    /// Negative log prior of the effect's values, in the unit of `log_odds`.
    pub negative_log_prior: f64,
    /// Fraction of the tests in which the effect reduces the residual.
    pub tests_better: f64,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_test_that_the_model_misses_is_named_although_the_mean_is_small() {
        let of = |after_rmse_n: f64| TestOutcome {
            test: "t".into(),
            left_out: false,
            before_rmse_n: 350.0,
            after_rmse_n,
            noise_n: 20.0,
            allowed_n: 22.0,
            curves: Curves::default(),
        };
        assert!(of(348.0).is_missed() && of(45.0).is_missed());
        assert!(!of(22.0).is_missed() && !of(43.0).is_missed());
    }
}
