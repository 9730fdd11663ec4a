//! Result of the diagnosis in one case, compared with the truth.

use crate::EvaluationError;
use dashpot_core::parameter::Element;
use dashpot_diagnosis::{Diagnosis, Evidence, NextTest, Options, Status, Verdict, diagnose};
use dashpot_records::Record;
use dashpot_rig::TestPoint;
use dashpot_severity::case::{Case, Measured};
use serde::Serialize;

/// One scored case.
#[derive(Debug, Clone, Serialize)]
pub struct Outcome {
    /// Block of the suite to which the case belongs.
    pub block: &'static str,
    /// Seed of the case.
    pub seed: u64,
    /// Injected effects with their severities.
    pub injected: Vec<(String, f64)>,
    /// Physical forms that the rig selected for the injected effects.
    pub forms: Vec<String>,
    /// Verdict of the diagnosis.
    pub verdict: Verdict,
    /// Named effects with their confidences, most probable first.
    pub named: Vec<(String, f64)>,
    /// Whether the fit has found all injected effects, as elements of the model or as measurement errors.
    ///
    /// In that case the diagnosis should name no effect.
    pub in_the_model: bool,
    /// Injected effects that the diagnosis names, or that the fit has found and the diagnosis has kept.
    pub found: Vec<String>,
    /// Effects with a visible change of force if they are removed from the simulator. `None` if the laboratory does not
    /// state them.
    pub true_set: Option<Vec<String>>,
    /// Whether there was a reference campaign.
    pub against_reference: bool,
    /// Effects that the diagnosis suspects but does not name.
    pub suspects: Vec<String>,
    /// Root mean square difference between the starting model and the noise-free force of the left-out tests, N.
    pub clean_before: f64,
    /// Root mean square difference between the improved model and the noise-free force of the left-out tests, N.
    pub clean_after: f64,
    /// Fraction of the error above the noise that the improved model removes, from the diagnosis.
    pub gap_closed: Option<f64>,
    /// Duration of the diagnosis, s.
    pub seconds: f64,
    /// Trial effects of every iteration, most probable first, with the evidence of each.
    pub evidence: Vec<Vec<(String, f64, Evidence)>>,
    /// Effects that these records cannot show, from the diagnosis.
    pub could_not_test: Vec<String>,
    /// First effect that is named after the first proposed test was added, for cases with a poor plan in which no
    /// effect was named before. Empty if the second diagnosis names none either. `None` if there was no proposed test,
    /// or if the rig cannot run it.
    pub with_proposed: Option<String>,
    /// First effect that is named after all proposed sines were added, under the conditions of `with_proposed`.
    pub with_all_proposed: Option<String>,
}

impl Outcome {
    /// Returns the first injected effect, without its form.
    pub fn truth(&self) -> Option<&str> {
        self.injected.first().map(|(name, _)| plain(name))
    }

    /// Returns whether the damper has an effect: injected or, without a reference, in the true set.
    pub fn is_true(&self, name: &str) -> bool {
        self.is_injected(name) || !self.against_reference && self.true_set.iter().flatten().any(|effect| effect == name)
    }

    /// Returns whether an effect with this name was injected.
    pub fn is_injected(&self, name: &str) -> bool {
        self.injected.iter().any(|(hidden, _)| plain(hidden) == name)
    }
}

/// Returns the name of an effect without its form, the part after the colon.
pub fn plain(name: &str) -> &str {
    name.split(':').next().unwrap_or(name)
}

/// Runs and scores one case.
///
/// # Errors
/// Returns the errors of the rig, the reader, the fit and the diagnosis.
pub fn run(block: &'static str, case: &Case) -> Result<(Outcome, Measured, Diagnosis), EvaluationError> {
    let measured = case.measure()?;
    let (mut outcome, found) = judged(block, case.options.seed, &case.effects, &measured, &Options::default())?;
    if block == "poor" && found.findings.is_empty() {
        (outcome.with_proposed, outcome.with_all_proposed) = proposed(case, &measured, &found);
    }
    Ok((outcome, measured, found))
}

/// Diagnoses and scores a measured case.
///
/// # Errors
/// Returns the errors of the diagnosis.
pub fn judged(
    block: &'static str,
    seed: u64,
    hidden: &[(String, f64)],
    measured: &Measured,
    options: &Options,
) -> Result<(Outcome, Diagnosis), EvaluationError> {
    let records: Vec<&Record> = measured.records.iter().collect();
    let start = std::time::Instant::now();
    let found = diagnose(&records, &measured.left_out, &measured.base, options, &|_, _| ())?;
    let seconds = start.elapsed().as_secs_f64();
    let (clean_before, clean_after) = against_clean(measured, &found);
    let is_in_the_model = |name: &str| {
        Element::find(name).is_ok_and(|element| measured.base.is_on(element)) || measured.taken_out.contains(&name)
    };
    let outcome = Outcome {
        block,
        seed,
        injected: hidden.to_vec(),
        forms: measured.truth.effects.iter().map(|e| e.form.clone()).collect(),
        verdict: found.verdict,
        named: found.findings.iter().map(|f| (f.effect.to_owned(), f.confidence)).collect(),
        in_the_model: hidden.iter().all(|(name, _)| is_in_the_model(plain(name))) && !hidden.is_empty(),
        found: hidden
            .iter()
            .map(|(name, _)| plain(name))
            .filter(|name| {
                found.findings.iter().any(|f| f.effect == *name)
                    || is_in_the_model(name)
                        && !found.inventory.iter().any(|item| {
                            item.effect == *name && matches!(item.status, Status::Removed | Status::Replaced)
                        })
            })
            .map(str::to_owned)
            .collect(),
        true_set: measured.true_set.clone(),
        against_reference: !options.reference.is_empty(),
        suspects: found.suspects.iter().map(|s| s.effect.to_owned()).collect(),
        clean_before,
        clean_after,
        gap_closed: found.gap_closed,
        seconds,
        evidence: found
            .iterations
            .iter()
            .map(|round| round.iter().map(|t| (t.effect.to_owned(), t.confidence, t.evidence)).collect())
            .collect(),
        could_not_test: found.could_not_test.iter().map(|c| c.effect.to_owned()).collect(),
        with_proposed: None,
        with_all_proposed: None,
    };
    Ok((outcome, found))
}

/// Smallest amplitude, m, and largest speed, m/s, of the rig.
const DRIVES: (f64, f64) = (2e-4, 1.6);

/// Returns the first effect that is named after the first proposed sine was added, and after all proposed sines were
/// added. Sines beyond the limits [`DRIVES`] are omitted.
fn proposed(case: &Case, measured: &Measured, found: &Diagnosis) -> (Option<String>, Option<String>) {
    let point = |k: usize, (amplitude, frequency): (f64, f64), test: &NextTest| {
        let speed = std::f64::consts::TAU * amplitude * frequency;
        (amplitude >= DRIVES.0 && speed <= DRIVES.1).then(|| TestPoint {
            mean_displacement_m: test.mean_displacement_m.unwrap_or(0.0),
            side_force_n: test.side_force_n.unwrap_or(0.0),
            cycles: 3,
            ..TestPoint::at_peak_velocity(format!("proposed_{}", k + 1), amplitude, speed)
        })
    };
    let sines = found.next_tests.iter().filter_map(|t| Some((t.amplitude_m?, t.frequency_hz?)).map(|sine| (sine, t)));
    let points: Vec<Option<TestPoint>> = sines.enumerate().map(|(k, (sine, test))| point(k, sine, test)).collect();
    let first: Vec<TestPoint> = points.first().cloned().flatten().into_iter().collect();
    let all: Vec<TestPoint> = points.into_iter().flatten().collect();
    let with_first = name_with(case, measured, &first);
    let with_all = if all.len() == first.len() { with_first.clone() } else { name_with(case, measured, &all) };
    (with_first, with_all)
}

/// Returns the first effect that is named after tests beyond the plan were added, or an empty text if no effect is
/// named. Returns `None` if there are no such tests, or if measurement or diagnosis fails.
fn name_with(case: &Case, measured: &Measured, more: &[TestPoint]) -> Option<String> {
    if more.is_empty() {
        return None;
    }
    let again = case.measure_at(measured.strengths.clone(), more).ok()?;
    let records: Vec<&Record> = again.records.iter().collect();
    let found = diagnose(&records, &again.left_out, &again.base, &Options::default(), &|_, _| ()).ok()?;
    Some(found.findings.first().map_or(String::new(), |f| f.effect.to_owned()))
}

/// Computes the root mean square difference between model and noise-free force over the left-out tests, N, before and
/// after the diagnosis.
fn against_clean(measured: &Measured, found: &Diagnosis) -> (f64, f64) {
    let records: Vec<&Record> = measured.clean.iter().collect();
    let clean = dashpot_diagnosis::mean_cycles(&records);
    let (mut before, mut after, mut count) = (0.0, 0.0, 0.0);
    for test in found.tests.iter().filter(|t| t.left_out) {
        let Some((_, forces)) =
            clean.iter().find(|(name, f)| *name == test.test && f.len() == test.curves.before.len())
        else {
            continue;
        };
        let mean = |model: &[f64]| {
            model.iter().zip(forces).map(|(m, c)| (m - c).powi(2)).sum::<f64>() / forces.len().max(1) as f64
        };
        before += mean(&test.curves.before);
        after += mean(&test.curves.after);
        count += 1.0;
    }
    let count = f64::max(count, 1.0);
    ((before / count).sqrt(), (after / count).sqrt())
}
