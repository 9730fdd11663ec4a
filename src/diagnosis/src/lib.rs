//! Diagnosis: where a model and the records of its damper disagree, which physical effect is missing, and what is left
//! when it is added.
//!
//! | file | step |
//! |---|---|
//! | [`effects`] | one card an effect: where it acts, what shows it |
//! | [`vocabulary`] | the forms of each effect, with their numbers and starts |
//! | [`screening`], [`race`] | every form of every effect refitted from several starts, in heats |
//! | [`edges`], [`unbent`], [`extend`], [`nearby`] | what those refits need |
//! | [`finer_curve`] | more points on the FV curve, where that is all that is missing |
//! | [`evidence`], [`decisions`] | how strongly the records speak for an explanation, and every number that decides |
//! | [`round`] | one look at what is left |
//! | [`search`] | adding, pairs, weighing each name with the others in |
//! | [`calibration`] | what a probability of that rule is worth |
//! | [`tree`] | all probabilities: path, family, effect, form |
//! | [`answer`], [`outcome`] | the answer in words and figures |
//! | [`phrases`] | every text that it says, in English |
//! | [`regions`] | where model and records disagree |
//! | [`reference`] | what changed against the same tests on a good damper |
//! | [`untestable`], [`next_test`] | what these records cannot show, and which test would |

mod answer;
mod calibration;
mod changes;
mod decisions;
mod edges;
mod effects;
mod evidence;
mod extend;
mod finer_curve;
mod hold_out;
mod improved;
mod nearby;
mod next_matrix;
mod next_test;
mod outcome;
mod phrases;
mod race;
mod reference;
mod regions;
mod round;
mod screening;
mod search;
mod situation;
mod texts;
mod tree;
mod unbent;
mod untestable;
mod vocabulary;
mod warmer;

pub use changes::{Change, CurveMoved, MovedBy};
pub use effects::{CARDS, Card, EFFECTS, meaning};
pub use hold_out::choose as choose_held_out;
pub use outcome::*;
pub use phrases::templates;
pub use texts::texts;
pub use tree::Branch;

use answer::{explained, judge, rivals};
use changes::Changes;
use dashpot_core::Params;
use dashpot_core::number;
use dashpot_estimation::deviations::deviations;
use dashpot_estimation::gap::{errors, gap_closed, in_noise, noise_alone, rms, rms_of_tests};
use dashpot_estimation::heating::Heating;
use dashpot_estimation::hypothesis::{Free, Hypothesis};
use dashpot_estimation::refit;
use dashpot_estimation::samples::{self, Test};
use dashpot_estimation::sensitivity::Accuracy;
use dashpot_estimation::unknowns::Unknown;
use dashpot_records::sentence::Template;
use dashpot_records::{Record, Sentence};
use decisions::{SURE, SUSPECTED};
use search::{Limits, Search, physical, search};
use situation::Situation;
use std::collections::BTreeMap;
use std::sync::Arc;

/// What a diagnosis may do.
#[derive(Debug, Clone)]
pub struct Options {
    /// Most effects to add.
    pub max_effects: usize,
    /// Effects that may be named; all where `None`.
    pub candidates: Option<Vec<String>>,
    /// Records of the same tests on a damper that is known to be good: what changed is then asked, not what is missing. Empty: none.
    pub reference: Vec<Record>,
}

impl Default for Options {
    fn default() -> Self {
        Options { max_effects: 3, candidates: None, reference: Vec::new() }
    }
}

/// Why there is no diagnosis.
#[derive(Debug, thiserror::Error)]
#[error("{}", self.sentence())]
pub enum DiagnosisError {
    /// Nothing to look at.
    NoTests,
    /// An unknown effect name.
    UnknownEffect {
        /// The name given.
        name: String,
    },
    /// The reference campaign has none of the tests.
    NothingToCompare,
    /// The model gives no finite force.
    NotFinite,
}

impl DiagnosisError {
    /// What is wrong and what to do, to be said in any language.
    pub fn sentence(&self) -> Sentence {
        match self {
            DiagnosisError::NoTests => phrases::NO_TESTS.into(),
            DiagnosisError::UnknownEffect { name } => Sentence::from(phrases::UNKNOWN_NAME)
                .with("name", format!("{name:?}"))
                .with_names("known", EFFECTS, phrases::COMMA),
            DiagnosisError::NothingToCompare => phrases::NOTHING_TO_COMPARE.into(),
            DiagnosisError::NotFinite => phrases::NOT_FINITE.into(),
        }
    }
}

/// What a diagnosis looks at.
struct Prepared {
    fitted: Vec<Test>,
    left: Vec<Test>,
    base: Hypothesis,
    situation: Situation,
}

fn prepare(records: &[&Record], held_out: &[bool], params: &Params) -> Prepared {
    let all = samples::as_long_as_remembered(samples::tests(records), params);
    let out = |test: &Test| held_out.get(test.record).copied().unwrap_or(false);
    let (left, fitted): (Vec<Test>, Vec<Test>) = all.into_iter().partition(out);
    let heating = Heating::new(records, &fitted);
    let situation = Situation::new(params, records, &fitted);
    let base =
        Hypothesis { base: *params, numbers: vocabulary::base_numbers(params), heating: Some(Arc::new(heating)) };
    Prepared { fitted, left, base, situation }
}

/// The model as the reference damper has it.
struct Against {
    /// Explanation and refit.
    base: (Hypothesis, refit::Refit),
    /// Tests that the reference campaign does not have.
    missing: Vec<String>,
}

impl Prepared {
    /// Takes what the model leaves of the same tests on the reference out of the comparison, and starts from the model fitted to it.
    fn against(&mut self, reference: &[Record], params: &Params) -> Result<Against, DiagnosisError> {
        let records: Vec<&Record> = reference.iter().collect();
        let mut own = prepare(&records, &[], params);
        own.base.heating = None;
        let start = own.base.start();
        let fine = refit::refit(&own.base, &own.fitted, &start, None, refit::Effort::FINE);
        let fine = fine.ok_or(DiagnosisError::NotFinite)?;
        // By the integration of the refits: where it is not exact, it is off by the same on both dampers, and with another one the numbers
        // of a damper would move against themselves.
        let residual = errors(Accuracy::Single, &own.base, &fine.theta, &records, &own.fitted);
        let residual = residual.ok_or(DiagnosisError::NotFinite)?;
        let correct = |tests: &mut Vec<Test>| {
            let (kept, missing) = reference::without_shared_error(std::mem::take(tests), &own.fitted, &residual);
            *tests = kept;
            missing
        };
        let mut missing = correct(&mut self.fitted);
        missing.extend(correct(&mut self.left));
        if self.fitted.is_empty() {
            return Err(DiagnosisError::NothingToCompare);
        }
        // What a test was heated by is counted by its place among the tests.
        if let Some(heating) = &mut self.base.heating {
            *heating = Arc::new(heating.of_tests(&self.fitted));
        }
        self.base = self.base.clone().starting_at(&fine.theta);
        let base = (own.base.starting_at(&fine.theta), fine);
        Ok(Against { base, missing })
    }
}

/// Diagnoses a model against records; `held_out` marks those that neither refit nor choice may see.
///
/// # Errors
/// No test to look at, an unknown name, a model without finite forces.
pub fn diagnose(
    records: &[&Record],
    held_out: &[bool],
    params: &Params,
    options: &Options,
    progress: &(dyn Fn(f64, Template) + Sync),
) -> Result<Diagnosis, DiagnosisError> {
    if let Some(name) = options.candidates.iter().flatten().find(|n| !EFFECTS.contains(&n.as_str())) {
        return Err(DiagnosisError::UnknownEffect { name: name.clone() });
    }
    progress(0.0, phrases::PREPARING);
    let mut prepared = prepare(records, held_out, params);
    if prepared.fitted.is_empty() {
        return Err(DiagnosisError::NoTests);
    }
    let reference = if options.reference.is_empty() {
        None
    } else {
        progress(0.02, phrases::FITTING_REFERENCE);
        Some(prepared.against(&options.reference, params)?)
    };
    let Prepared { fitted, left, base, situation } = prepared;
    let may = |effect: &str| {
        options.candidates.as_ref().is_none_or(|list| list.iter().any(|n| n == effect))
            && effects::can_be_shown(effect, &situation)
    };
    let limits = Limits { effects: options.max_effects, allowed: &may };
    let found = search(base, records, &fitted, &limits, progress).ok_or(DiagnosisError::NotFinite)?;
    progress(0.95, phrases::WHAT_IS_LEFT);
    let confidence = found.found.added.iter().map(|a| {
        let of = |samples| found.probability(a, samples);
        calibration::confidence(of(SUSPECTED), of(SURE), reference.is_some())
    });
    let confidence = confidence.collect();
    let warmer = warmer::warmer(records, &options.reference);
    let answer = Answer {
        warmer,
        records,
        fitted: &fitted,
        left: &left,
        found: &found,
        situation: &situation,
        confidence,
        reference,
    };
    let diagnosis = answer.diagnosis();
    progress(1.0, phrases::DONE);
    Ok(diagnosis)
}

/// What the answer is made from.
struct Answer<'a> {
    /// That the reference was not as warm, where that is so.
    warmer: Option<Sentence>,
    records: &'a [&'a Record],
    fitted: &'a [Test],
    left: &'a [Test],
    found: &'a Search,
    situation: &'a Situation,
    /// Of each name, in the order in which they were added.
    confidence: Vec<f64>,
    /// The model as the reference damper has it, where there is one.
    reference: Option<Against>,
}

impl Answer<'_> {
    /// What a drift of the load cell's zero may as well be where no temperature tells.
    fn or_warm_gas(&self, names: &[&str]) -> Option<Sentence> {
        (names.contains(&"force_drift") && !self.situation.temperature_measured).then(|| phrases::OR_WARM_GAS.into())
    }

    fn diagnosis(&self) -> Diagnosis {
        let found = self.found;
        let (base, first) = &found.base;
        let (last, end) = &found.found.last;
        let of = |h: &Hypothesis, theta: &[f64], tests: &[Test]| {
            errors(self.accuracy(), h, theta, self.records, tests).unwrap_or_else(|| vec![vec![f64::NAN]; tests.len()])
        };
        let (fitted_before, left_before) = (of(base, &first.theta, self.fitted), of(base, &first.theta, self.left));
        let (fitted_after, left_after) = (of(last, &end.theta, self.fitted), of(last, &end.theta, self.left));
        let judged = judge(found, self.fitted, &self.confidence);
        let noise_of = |tests: &[Test]| rms(&tests.iter().map(|t| t.mean_noise).collect::<Vec<_>>());
        let noise = noise_of(self.fitted);
        let left_noise = (!self.left.is_empty()).then(|| noise_of(self.left));
        let figures = |fitted: &[Vec<f64>], left: &[Vec<f64>]| {
            let every: Vec<f64> = self
                .fitted
                .iter()
                .zip(fitted)
                .chain(self.left.iter().zip(left))
                .map(|(t, e)| {
                    100.0 * e.iter().map(|x| x.abs()).sum::<f64>() / e.len().max(1) as f64 / t.segment.top.max(1e-9)
                })
                .collect();
            Figures {
                rmse_n: rms_of_tests(fitted),
                error_percent: every.iter().sum::<f64>() / every.len().max(1) as f64,
                held_out_rmse_n: (!left.is_empty()).then(|| rms_of_tests(left)),
                noise_n: noise,
                held_out_noise_n: left_noise,
            }
        };
        let gap = if self.left.is_empty() {
            gap_closed(self.fitted, &fitted_before, &fitted_after)
        } else {
            gap_closed(self.left, &left_before, &left_after)
        };
        let after = deviations(last, end);
        let names: Vec<&str> = found.found.added.iter().map(|a| a.candidate.effect).collect();
        let first_round = &found.rounds[0];
        let could_not_test = untestable::list(self.situation, &first_round.invisible, &names);
        let changed = self.changed();
        let (verdict, summary) = match judged.verdict {
            Verdict::NothingMissing => {
                changed_instead(self.with_limits(judged.summary.clone(), &could_not_test), &changed)
            }
            other => (other, changed_besides(judged.summary.clone(), &changed)),
        };
        let about_the_reference = self.about_the_reference();
        let mut diagnosis = Diagnosis {
            verdict,
            summary,
            findings: self.findings(),
            suspects: judged.suspects.clone(),
            regions: regions::regions(self.fitted, &fitted_before),
            before: figures(&fitted_before, &left_before),
            after: figures(&fitted_after, &left_after),
            gap_closed: gap.filter(|_| !names.is_empty()),
            unexplained_share: 1.0
                - explained(first_round.before.mean(), found.found.weighed(self.fitted).mean()).clamp(0.0, 1.0),
            tree: tree::tree(first_round, SURE),
            next_tests: self.next_tests(&judged),
            could_not_test,
            shifts: self.shifts(),
            changed: changed.numbers,
            curve_moved: changed.curve,
            notes: judged
                .notes
                .iter()
                .chain(&about_the_reference)
                .chain(&self.warmer)
                .cloned()
                .chain(self.or_warm_gas(&names))
                .collect(),
            about_the_reference,
            tests: Vec::new(),
            rounds: found.rounds.iter().map(|round| self.tried(round)).collect(),
            base: base.params(&first.theta),
            improved: last.params(&end.theta),
            reference: self.reference.as_ref().map(|Against { base: (there, refit), .. }| there.params(&refit.theta)),
            corrections: self.corrections(),
            estimates: improved::estimates(found, &after),
            measured: improved::measured(found, &after),
        };
        for (held_out, tests, before, after) in
            [(false, self.fitted, &fitted_before, &fitted_after), (true, self.left, &left_before, &left_after)]
        {
            for (k, test) in tests.iter().enumerate() {
                let measured = test.forces().to_vec();
                let less = |e: &[f64]| measured.iter().zip(e).map(|(m, e)| m - e).collect();
                diagnosis.tests.push(TestOutcome {
                    test: test.segment.name.clone(),
                    held_out,
                    before_rmse_n: rms(&before[k]),
                    after_rmse_n: rms(&after[k]),
                    noise_n: test.mean_noise,
                    allowed_n: test.segment.scale,
                    curves: Curves {
                        displacement: test.inputs().iter().map(|i| i.displacement.unwrap_or(0.0)).collect(),
                        velocity: test.inputs().iter().map(|i| i.velocity).collect(),
                        before: less(&before[k]),
                        after: less(&after[k]),
                        measured,
                        frequency: test.frequency,
                    },
                });
            }
        }
        diagnosis
    }

    /// All forms that a look tried, best first.
    fn tried(&self, round: &round::Round) -> Vec<Tried> {
        let odds = round.odds(SURE);
        let before = &round.before;
        let base = before.log_evidence(SURE);
        round
            .tried
            .iter()
            .map(|t| {
                let after = &t.weighed;
                let better = before.mean_squares.iter().zip(&after.mean_squares).filter(|(b, a)| a < b).count();
                Tried {
                    effect: t.candidate.effect,
                    form: t.candidate.form,
                    confidence: odds.effects.get(t.candidate.effect).copied().unwrap_or(0.0),
                    evidence: Evidence {
                        share: explained(before.mean(), after.mean()),
                        mean_square_before: before.mean(),
                        mean_square_after: after.mean(),
                        log_odds: after.log_evidence(SURE) - base,
                        numbers: after.numbers,
                        implausibility: after.implausibility - before.implausibility,
                        tests_better: better as f64 / self.fitted.len().max(1) as f64,
                    },
                }
            })
            .collect()
    }

    fn findings(&self) -> Vec<Finding> {
        let found = self.found;
        let (last, end) = &found.found.last;
        let deviations = deviations(last, end);
        let whole = found.found.weighed(self.fitted).mean();
        let before = found.rounds[0].before.mean();
        let one = |(place, added): (usize, &search::Added)| {
            let round = &found.rounds[added.look];
            let effect = added.candidate.effect;
            let mut parameters = BTreeMap::new();
            for (fresh, number) in added.candidate.fresh.iter().zip(added.numbers.clone()) {
                let (value, deviation) = (end.theta[number], deviations[number]);
                let at = |t: f64| physical(&fresh.free, t);
                let (name, unit) = name_of(&fresh.free);
                let v = at(value);
                parameters.insert(
                    name,
                    Value {
                        value: v,
                        low: at(value - 1.96 * deviation),
                        high: at(value + 1.96 * deviation),
                        unit,
                        plausible: (fresh.plausible.0..=fresh.plausible.1).contains(&v),
                    },
                );
            }
            let without = found.found.leave(place, self.fitted).map_or(before, |less| less.weighed(self.fitted).mean());
            let card = effects::card(effect);
            let tried = self.tried(round);
            Finding {
                effect,
                form: added.candidate.form,
                meaning: meaning(effect),
                path: card.map_or("", |c| c.path),
                family: card.map_or("", |c| c.family),
                confidence: self.confidence[place],
                rule: [found.probability(added, SUSPECTED), found.probability(added, SURE)],
                family_confidence: {
                    let of = |samples| tree::of_family(&tree::tree(round, samples), effect);
                    calibration::confidence(of(SUSPECTED), of(SURE), self.reference.is_some())
                        .max(self.confidence[place])
                },
                share: ((without - whole) / (before - 1.0).max(1e-9)).clamp(0.0, 1.0),
                of_the_rig: added.candidate.is_artefact(),
                parameters,
                gap_closed: self.gap_of(added),
                evidence: tried.iter().find(|t| t.effect == effect).map_or_else(Evidence::default, |t| t.evidence),
                rivals: rivals(round, Some(effect)),
            }
        };
        found.found.added.iter().enumerate().map(one).collect()
    }

    /// Share of the gap that opens again without one effect.
    fn gap_of(&self, added: &search::Added) -> Option<f64> {
        let (last, end) = &self.found.found.last;
        let (base, first) = &self.found.base;
        let tests = if self.left.is_empty() { self.fitted } else { self.left };
        let without = search::without(last, &end.theta, added);
        let refitted = refit::refit(&without, self.fitted, &without.start(), None, refit::Effort::COMPARE)?;
        let noise = noise_alone(tests);
        let of = |h: &Hypothesis, theta: &[f64]| {
            errors(self.accuracy(), h, theta, self.records, tests).map(|e| in_noise(tests, &e))
        };
        let before = of(base, &first.theta)?;
        let (with, less) = (of(last, &end.theta)?, of(&without, &refitted.theta)?);
        (before > 1.02 * noise).then(|| ((less - with) / (before - noise)).clamp(-1.0, 1.0))
    }

    /// How exactly errors are found: as the model's own steps give them, or as what the reference leaves was found.
    fn accuracy(&self) -> Accuracy {
        if self.reference.is_some() { Accuracy::Single } else { Accuracy::Full }
    }

    fn corrections(&self) -> BTreeMap<&'static str, f64> {
        let (last, end) = &self.found.found.last;
        last.numbers
            .iter()
            .zip(&end.theta)
            .filter_map(|(n, value)| match n.free {
                Free::Rig(artefact) => Some((artefact.name(), *value)),
                _ => None,
            })
            .collect()
    }

    /// "Nothing is missing", with what that does not cover.
    fn with_limits(&self, nothing: Sentence, could_not_test: &[CouldNotTest]) -> Sentence {
        let names = could_not_test.iter().map(|c| c.effect);
        let not_seen = (!could_not_test.is_empty())
            .then(|| Sentence::from(phrases::CANNOT_SHOW).with_names("effects", names, phrases::COMMA));
        let not_confirmed = self.left.is_empty().then(|| phrases::NOT_CONFIRMED.into());
        nothing.with_any("not_seen", not_seen).with_any("not_confirmed", not_confirmed)
    }

    /// What there is to say of how the comparison was made.
    fn about_the_reference(&self) -> Option<Sentence> {
        let Some(reference) = &self.reference else {
            return (!self.found.found.added.is_empty()).then(|| phrases::WITHOUT_REFERENCE.into());
        };
        let missing = &reference.missing;
        let aside = (!missing.is_empty())
            .then(|| Sentence::from(phrases::WITHOUT_COUNTERPART).with_names("tests", missing, phrases::COMMA));
        Some(Sentence::from(phrases::AGAINST_REFERENCE).with_any("aside", aside))
    }

    /// What is another on the reference damper.
    fn changed(&self) -> Changes {
        let Some(Against { base: (reference, there), .. }) = &self.reference else { return Changes::default() };
        let (last, end) = &self.found.found.last;
        changes::changes((reference, there), (last, end), self.fitted)
    }

    /// Scalars of the base that moved by more than three of their deviations.
    fn shifts(&self) -> Vec<Shift> {
        let (base, first) = &self.found.base;
        let (last, end) = &self.found.found.last;
        if self.found.found.added.is_empty() {
            return Vec::new();
        }
        let deviations = deviations(base, first);
        base.numbers
            .iter()
            .enumerate()
            .filter_map(|(k, n)| {
                let Free::Model(Unknown::Log(number) | Unknown::Linear(number)) = n.free else { return None };
                let after = end.theta[last.place_of(&n.free)?];
                ((after - first.theta[k]).abs() > 3.0 * deviations[k]).then(|| Shift {
                    parameter: number.name(),
                    before: physical(&n.free, first.theta[k]),
                    after: physical(&n.free, after),
                    unit: number.parameter().unit,
                })
            })
            .collect()
    }

    /// Tests that would tell apart what is undecided; none where nothing is.
    fn next_tests(&self, judged: &answer::Judged) -> Vec<NextTest> {
        let found = self.found;
        let unsure = found.found.added.iter().find(|added| found.probability(added, SURE) < DECIDED);
        let round = match (judged.verdict, unsure) {
            (Verdict::NothingMissing, _) => return Vec::new(),
            (_, Some(added)) => &found.rounds[added.look],
            (Verdict::Named, None) if judged.suspects.is_empty() => return Vec::new(),
            (Verdict::Named, None) => match found.last_look {
                Some(place) => &found.rounds[place],
                None => return Vec::new(),
            },
            _ => &found.rounds[0],
        };
        let odds = round.odds(SUSPECTED);
        let rivals: Vec<next_test::Rival> = round
            .named()
            .into_iter()
            .take(UNDECIDED)
            .map(|t| next_test::Rival {
                effect: t.candidate.effect,
                hypothesis: &t.hypothesis,
                theta: &t.refit.theta,
                confidence: odds.effects.get(t.candidate.effect).copied().unwrap_or(0.0),
            })
            .collect();
        next_test::propose(&rivals, &next_test::Rig::of(self.fitted))
    }
}

/// Most numbers that the answer names.
const TOLD: usize = 3;

/// No effect is missing, but what there is has other numbers than on the reference: that is the answer then.
fn changed_instead(nothing: Sentence, changed: &Changes) -> (Verdict, Sentence) {
    match with_the_numbers(phrases::CHANGED, changed) {
        Some(summary) => (Verdict::Changed, summary.with_said("besides", nothing)),
        None => (Verdict::NothingMissing, nothing),
    }
}

/// The same beside another answer: gas or a valve may be worn while something has no name.
fn changed_besides(answer: Sentence, changed: &Changes) -> Sentence {
    match with_the_numbers(phrases::BESIDES_CHANGED, changed) {
        Some(summary) => summary.with_said("answer", answer),
        None => answer,
    }
}

/// A sentence about the numbers that stand in the answer; nothing where none does.
fn with_the_numbers(said: Template, changed: &Changes) -> Option<Sentence> {
    let material = changes::told(changed);
    let more = material.len().saturating_sub(TOLD);
    let told: Vec<Sentence> = material.into_iter().take(TOLD).collect();
    (!told.is_empty()).then(|| {
        Sentence::from(said)
            .with_list("numbers", told, phrases::COMMA)
            .with_any("more", (more > 0).then(|| Sentence::from(phrases::MORE_NUMBERS).with("count", more)))
    })
}

/// Probability, each test counted as one sample, from which a name needs no further test.
const DECIDED: f64 = 0.9;
/// Most names that a test is sought to tell apart.
const UNDECIDED: usize = 3;

/// A form of an effect as the first look found it, for whoever studies how forms are to be weighed.
#[derive(Debug, Clone, serde::Serialize)]
pub struct Looked {
    /// Effect; empty for the model as it came.
    pub effect: &'static str,
    /// Form.
    pub form: &'static str,
    /// Whether it is a detector of something without a name.
    pub nameless: bool,
    /// Numbers beyond the base's, those near what is usual counted half.
    pub numbers: f64,
    /// Price of values that dampers do not show.
    pub implausibility: f64,
    /// Mean square left of each test, in units of what noise and curves leave.
    pub mean_squares: Vec<f64>,
}

/// The first look of a diagnosis.
pub fn first_look(records: &[&Record], held_out: &[bool], params: &Params) -> Option<Vec<Looked>> {
    let all = samples::as_long_as_remembered(samples::tests(records), params);
    let out = |test: &Test| held_out.get(test.record).copied().unwrap_or(false);
    let fitted: Vec<Test> = all.iter().filter(|t| !out(t)).cloned().collect();
    let heating = Heating::new(records, &fitted);
    let base =
        Hypothesis { base: *params, numbers: vocabulary::base_numbers(params), heating: Some(Arc::new(heating)) };
    let limits = Limits { effects: 0, allowed: &|_| true };
    let found = search(base, records, &fitted, &limits, &|_, _| ())?;
    let round = found.rounds.first()?;
    let of = |effect, form, nameless, w: &evidence::Weighed| Looked {
        effect,
        form,
        nameless,
        numbers: w.numbers,
        implausibility: w.implausibility,
        mean_squares: w.mean_squares.clone(),
    };
    let mut list = vec![of("", "", false, &round.before)];
    list.extend(
        round.tried.iter().map(|t| of(t.candidate.effect, t.candidate.form, t.candidate.unnamed.is_some(), &t.weighed)),
    );
    Some(list)
}

fn name_of(free: &Free) -> (&'static str, &'static str) {
    match free {
        Free::Model(Unknown::Log(number) | Unknown::Linear(number) | Unknown::Above(number, _)) => {
            (number.name(), number.parameter().unit)
        }
        Free::Model(Unknown::Entry(list, _)) => (list.name(), list.parameter().unit),
        Free::Model(Unknown::Rise { curve, .. }) => (curve.forces().name(), "N"),
        Free::Rig(artefact) => (artefact.parameter(), artefact.unit()),
        Free::Cooling => ("cooling_rate", "1/s"),
        Free::HeatCapacity => {
            let number = number!("heat_capacity");
            (number.name(), number.parameter().unit)
        }
    }
}

/// A model refitted to noise-free records, and what it leaves of every sample in units of the noise stated for each record.
/// `None` where the model gives no finite force.
pub fn refitted(records: &[&Record], noise: &[f64], params: &Params) -> Option<(Params, Vec<f64>)> {
    let mut tests = samples::as_long_as_remembered(samples::tests(records), params);
    for test in &mut tests {
        let noise = noise[test.record];
        test.allowed.iter_mut().for_each(|a| *a = noise);
    }
    let base = Hypothesis { base: *params, numbers: vocabulary::base_numbers(params), heating: None };
    let found = refit::refit(&base, &tests, &base.start(), None, refit::Effort::FINE)?;
    Some((base.params(&found.theta), found.residual.as_slice().to_vec()))
}

/// The mean cycle's force of every record, by name, at the samples that a diagnosis looks at.
pub fn mean_cycles(records: &[&Record]) -> Vec<(String, Vec<f64>)> {
    samples::tests(records).iter().map(|t| (t.segment.name.clone(), t.forces().to_vec())).collect()
}
