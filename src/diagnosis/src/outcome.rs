//! What a diagnosis says: the contract that scripts read, and the curves that its report draws.

use super::changes::Change;
use super::tree::Branch;
use dashpot_core::Params;
use dashpot_estimation::prior_set::PriorSet;
use dashpot_estimation::structure::inventory::InventoryItem;
use dashpot_messages::Sentence;
use serde::Serialize;
use std::collections::BTreeMap;

/// The answer in one word.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Verdict {
    /// At least one effect was named and added.
    Named,
    /// What is left is noise, or no larger than the form of the curves allows.
    NothingMissing,
    /// Nothing is missing, but the numbers differ from those of the reference damper: see [`Diagnosis::changes`].
    Changed,
    /// Something is missing, and more than one effect explains it as well.
    #[serde(rename = "cannot_tell")]
    Ambiguous,
    /// Something is missing that no known effect explains.
    UnknownEffect,
}

impl Verdict {
    /// Whether no effect is missing: the numbers of the model may be others than on a reference.
    pub fn nothing_is_missing(self) -> bool {
        matches!(self, Verdict::NothingMissing | Verdict::Changed)
    }
}

/// Everything a diagnosis found.
#[derive(Debug, Clone, Serialize)]
pub struct Diagnosis {
    /// The answer in one word.
    pub verdict: Verdict,
    /// The answer in sentences.
    pub summary: Sentence,
    /// Effects in the order in which they were added.
    pub findings: Vec<Finding>,
    /// Every effect of the given and of the most probable model, with the force it carries and its probability.
    pub inventory: Vec<InventoryItem>,
    /// Against a reference: the sparse set of changes that explains the difference, the largest force first.
    pub changes: Vec<Change>,
    /// What explains about as well as each other a disagreement, or the rest of one, that got no name; likeliest first.
    pub suspects: Vec<Rival>,
    /// Where model and records disagree before anything is added, worst first.
    #[serde(rename = "where")]
    pub regions: Vec<Region>,
    /// The model as it came, refitted.
    pub before: Figures,
    /// The model with all findings.
    pub after: Figures,
    /// Share of the gap between model and noise that is closed, on left-out tests (on fitted ones where none is left out).
    pub gap_closed: Option<f64>,
    /// Fraction of the disagreement that the findings leave, in mean squares beyond the noise.
    pub unexplained_fraction: f64,
    /// All probabilities of the first look, as they were before anything was added: path, family, effect, form.
    pub tree: Vec<Branch>,
    /// Tests that would tell more.
    pub next_tests: Vec<NextTest>,
    /// Effects that these records cannot show.
    pub could_not_test: Vec<CouldNotTest>,
    /// Numbers of the base model that moved far when an effect was added.
    pub shifts: Vec<Shift>,
    /// Remarks.
    pub notes: Vec<Sentence>,
    /// The remark among them that says what a name without a reference may stand for, or how the reference was compared with.
    #[serde(skip)]
    pub about_the_reference: Option<Sentence>,
    /// Each test before and after.
    pub tests: Vec<TestOutcome>,
    /// Every effect that was refitted in full, by iteration of the search.
    pub iterations: Vec<Vec<Trial>>,
    /// The model as it came, refitted.
    #[serde(skip)]
    pub base: Params,
    /// The model with the findings that belong to the damper.
    #[serde(skip)]
    pub improved: Params,
    /// Against a reference: the same model fitted to the reference damper.
    #[serde(skip)]
    pub reference: Option<Params>,
    /// What is known of the improved model's numbers.
    #[serde(skip)]
    pub estimates: Vec<dashpot_identification::Estimate>,
    /// What the improved model's file says of the measurement, so that its readers take it out of the same records again.
    #[serde(skip)]
    pub measured: Vec<dashpot_identification::Measured>,
    /// What was known of the damper beside its records.
    #[serde(skip)]
    pub priors: PriorSet,
    /// What the rig added, by name: taken out of the comparison only.
    pub corrections: BTreeMap<&'static str, f64>,
}

/// A named effect.
#[derive(Debug, Clone, Serialize)]
pub struct Finding {
    /// Its name.
    pub effect: &'static str,
    /// Which form of it fits best; empty where there is one.
    pub form: &'static str,
    /// What it is, in one line.
    pub meaning: &'static str,
    /// Where in the way of the force it acts.
    pub path: &'static str,
    /// Its family: effects that act in the same place.
    pub family: &'static str,
    /// Probability that the name is right: of names given so, that many are.
    pub confidence: f64,
    /// Probability that the family is right.
    pub family_confidence: f64,
    /// Fraction of the disagreement that it explains, in mean squares beyond the noise: what opens again without it.
    pub fraction: f64,
    /// Force that it carries, N rms.
    pub force_n_rms: f64,
    /// Whether it is of the rig: then it is corrected in the comparison and not put into the model.
    pub of_the_rig: bool,
    /// Its numbers.
    pub parameters: BTreeMap<&'static str, Value>,
    /// Share of the gap closed by this effect on left-out tests.
    pub gap_closed: Option<f64>,
    /// Figures behind the confidence.
    pub evidence: Evidence,
    /// Names that explain less.
    pub rivals: Vec<Rival>,
}

/// A number with its 95 % interval.
#[derive(Debug, Clone, Copy, Serialize)]
pub struct Value {
    /// Best value.
    pub value: f64,
    /// Lower end.
    pub low: f64,
    /// Upper end.
    pub high: f64,
    /// Unit.
    pub unit: &'static str,
    /// Whether dampers (or rigs) show such values.
    pub plausible: bool,
}

/// Another name for the same disagreement.
#[derive(Debug, Clone, Serialize)]
pub struct Rival {
    /// Its name.
    pub effect: &'static str,
    /// Probability that it is the right one.
    pub confidence: f64,
    /// Fraction of the excess that it explains.
    pub fraction: f64,
    /// Why it lost.
    pub why: Sentence,
}

/// A region where model and records disagree.
#[derive(Debug, Clone, Serialize)]
pub struct Region {
    /// A test, or "all" where it is of every test that goes there.
    pub test: String,
    /// Velocities, m/s.
    pub velocity_m_s: [f64; 2],
    /// Displacements, m.
    pub displacement_m: [f64; 2],
    /// `rebound`, `compression` or `both`.
    pub direction: &'static str,
    /// `speeding_up`, `slowing_down` or `both`.
    pub acceleration: &'static str,
    /// Root mean square of measured less computed force there, N.
    pub rmse_n: f64,
    /// Mean of measured less computed force there, N.
    pub mean_n: f64,
    /// What noise makes there, N.
    pub noise_n: f64,
    /// Description of the region in a sentence.
    pub text: Sentence,
}

/// How far a model is off.
#[derive(Debug, Clone, Copy, Serialize)]
pub struct Figures {
    /// Root mean square over the fitted tests, N.
    pub rmse_n: f64,
    /// Mean absolute error over the largest force of the test, mean over all tests, percent.
    pub error_percent: f64,
    /// Root mean square over the left-out tests, N.
    pub left_out_rmse_n: Option<f64>,
    /// What noise alone makes of the fitted tests, N.
    pub noise_n: f64,
    /// What noise alone makes of the left-out tests, N.
    pub left_out_noise_n: Option<f64>,
}

/// A rig test worth running.
#[derive(Debug, Clone, Serialize)]
pub struct NextTest {
    /// What to do and what it would show.
    pub text: Sentence,
    /// Amplitude, m.
    pub amplitude_m: Option<f64>,
    /// Frequency, Hz.
    pub frequency_hz: Option<f64>,
    /// Mean displacement, m, in the direction and from the zero that the files count.
    pub mean_displacement_m: Option<f64>,
    /// Side force, N.
    pub side_force_n: Option<f64>,
    /// Root mean square by which the rivals' predictions differ there, N.
    pub difference_n: Option<f64>,
    /// The names it separates.
    pub separates: Vec<&'static str>,
}

/// An effect that these records cannot show.
#[derive(Debug, Clone, Serialize)]
pub struct CouldNotTest {
    /// Its name.
    pub effect: &'static str,
    /// Why, and what test would show it.
    pub why: Sentence,
}

/// A number of the base model that moved when effects were added.
#[derive(Debug, Clone, Serialize)]
pub struct Shift {
    /// Parameter.
    pub parameter: &'static str,
    /// Before.
    pub before: f64,
    /// After.
    pub after: f64,
    /// Unit.
    pub unit: &'static str,
}

/// One test before and after.
#[derive(Debug, Clone, Serialize)]
pub struct TestOutcome {
    /// Name.
    pub test: String,
    /// Whether it was left out.
    pub left_out: bool,
    /// Root mean square error before, N.
    pub before_rmse_n: f64,
    /// After.
    pub after_rmse_n: f64,
    /// What noise makes, N.
    pub noise_n: f64,
    /// Error that noise and the form of the curves allow, N: the unit in which the gap counts this test.
    pub allowed_n: f64,
    /// The curves.
    #[serde(skip)]
    pub curves: Curves,
}

/// A mean cycle: motion, measured force, both models.
#[derive(Debug, Clone, Default)]
pub struct Curves {
    /// m.
    pub displacement: Vec<f64>,
    /// m/s.
    pub velocity: Vec<f64>,
    /// N.
    pub measured: Vec<f64>,
    /// N.
    pub before: Vec<f64>,
    /// N.
    pub after: Vec<f64>,
    /// Frequency, Hz; 0 without cycles.
    pub frequency: f64,
}

/// An effect that was tried by refitting everything with it.
#[derive(Debug, Clone, Serialize)]
pub struct Trial {
    /// Its name.
    pub effect: &'static str,
    /// Its form.
    pub form: &'static str,
    /// Probability that it is the right name.
    pub confidence: f64,
    /// Figures behind it.
    pub evidence: Evidence,
}

/// What a refit with an effect brought.
#[derive(Debug, Clone, Copy, Default, Serialize)]
pub struct Evidence {
    /// Fraction of the disagreement that it explains, in mean squares beyond the noise.
    pub fraction: f64,
    /// Mean square residual of a test before it, in units of what noise and curves leave.
    pub mean_square_before: f64,
    /// Mean square residual of a test with it, in units of what noise and curves leave.
    pub mean_square_after: f64,
    /// Natural logarithm of the posterior odds of the records with the effect against those without it.
    ///
    /// Each test counts as one independent sample; the effect's numbers are penalized.
    pub log_odds: f64,
    /// How many numbers it adds; those that stay near their prior count half.
    pub numbers: f64,
    /// Negative log prior of its values, in the units of `log_odds`.
    pub negative_log_prior: f64,
    /// Share of the tests of which it leaves less.
    pub tests_better: f64,
}
