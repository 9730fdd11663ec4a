//! Diagnosis: where a model and the records of its damper disagree, which physical effect is missing, and what is left
//! when it is added.
//!
//! | file | step |
//! |---|---|
//! | [`samples`] | the mean cycle of every test and the error that noise allows it |
//! | [`hypothesis`] | an explanation: a model with free numbers, and what the rig added |
//! | [`refit`] | everything refitted |
//! | [`finer_curve`] | more points on the FV curve, where that is all that is missing |
//! | [`vocabulary`] | the effects that can be named, with their starts |
//! | [`screening`] | which of them are worth a refit |
//! | [`race`] | refits in heats |
//! | [`edges`] | numbers that say where the force jumps |
//! | [`nearby`] | cheap residuals beside an explanation that is known exactly |
//! | [`unbent`] | a series element that the base bent is tried straight |
//! | [`spring_end`] | a stop that a lookup spring has taken up |
//! | [`evidence`] | how strongly the records speak for one, and the confidence that deserves |
//! | [`deviations`] | how far the records leave numbers open |
//! | [`far_fetched`] | whether the numbers of an effect are such as dampers show |
//! | [`round`] | one look at what is left |
//! | [`tie`] | which of several that explain the same leads furthest |
//! | [`pair`] | two effects that hide each other's share |
//! | [`search`] | adding, looking again, taking out |
//! | [`stands`], [`gap`] | whether the names found stand, and the gap that they close |
//! | [`regions`] | where, in words and figures |
//! | [`untestable`], [`next_test`] | what these records cannot show, and which test would |
//! | [`outcome`] | the answer |

mod deviations;
mod edges;
mod evidence;
mod extend;
mod far_fetched;
mod finer_curve;
mod gap;
mod heating;
mod hold_out;
mod hypothesis;
mod improved;
mod measurement;
mod nearby;
mod next_test;
mod outcome;
mod pair;
mod race;
mod refit;
mod regions;
mod round;
mod samples;
mod screening;
mod search;
mod situation;
mod spring_end;
mod stands;
mod tie;
mod unbent;
mod untestable;
mod verdict;
mod vocabulary;

pub use evidence::{Evidence, FEATURES};
pub use hold_out::choose as choose_held_out;
pub use outcome::*;
pub use untestable::EFFECTS;

use crate::identification::unknowns::Unknown;
use crate::records::Record;
use dashpot_core::Params;
use dashpot_core::elements::GROUPS;
use dashpot_core::parameter::find;
use deviations::deviations;
use gap::{errors, gap_closed, in_noise, noise_alone, rms, rms_of_tests};
use heating::Heating;
use hypothesis::{Free, Hypothesis};
use samples::Test;
use search::{Limits, Search, physical, search};
use situation::Situation;
use stands::holds;
use std::collections::BTreeMap;
use std::sync::Arc;

/// What a diagnosis may do.
#[derive(Debug, Clone)]
pub struct Options {
    /// Most effects to add.
    pub max_effects: usize,
    /// Effects that may be named; all where `None`.
    pub candidates: Option<Vec<String>>,
}

impl Default for Options {
    fn default() -> Self {
        Options { max_effects: 3, candidates: None }
    }
}

/// Why there is no diagnosis.
#[derive(Debug, thiserror::Error)]
pub enum DiagnosisError {
    /// Nothing to look at.
    #[error("there is no test to diagnose: give a folder or files with at least one record, and leave some of them in")]
    NoTests,
    /// An unknown effect name.
    #[error("there is no effect called {name:?}; the effects are {}", EFFECTS.join(", "))]
    UnknownEffect {
        /// The name given.
        name: String,
    },
    /// The model gives no finite force.
    #[error("the model gives no finite force for these records: run dashpot validate to see where")]
    NotFinite,
}

/// Diagnoses a model against records; `held_out` marks those that no refit may see.
///
/// # Errors
/// No test to look at, an unknown name, a model without finite forces.
pub fn diagnose(
    records: &[&Record],
    held_out: &[bool],
    params: &Params,
    options: &Options,
    progress: &(dyn Fn(f64, &str) + Sync),
) -> Result<Diagnosis, DiagnosisError> {
    if let Some(name) = options.candidates.iter().flatten().find(|n| !EFFECTS.contains(&n.as_str())) {
        return Err(DiagnosisError::UnknownEffect { name: name.clone() });
    }
    progress(0.0, "preparing records");
    let all = samples::as_long_as_remembered(samples::tests(records), params);
    let out = |test: &Test| held_out.get(test.record).copied().unwrap_or(false);
    let fitted: Vec<Test> = all.iter().filter(|t| !out(t)).cloned().collect();
    let left: Vec<Test> = all.iter().filter(|t| out(t)).cloned().collect();
    if fitted.is_empty() {
        return Err(DiagnosisError::NoTests);
    }
    let heating = Heating::new(records, &fitted);
    let situation = Situation::new(params, records, &fitted);
    let heat_span = heating.span();
    let base =
        Hypothesis { base: *params, numbers: vocabulary::base_numbers(params), heating: Some(Arc::new(heating)) };
    let may = |effect: &str| {
        options.candidates.as_ref().is_none_or(|list| list.iter().any(|n| n == effect))
            && EFFECTS
                .iter()
                .find(|e| **e == effect)
                .is_none_or(|e| untestable::by_range(&situation, e, heat_span).is_none() || is_stop(e))
    };
    let limits = Limits { effects: options.max_effects, allowed: &may };
    let mut found = search(base, records, &fitted, &limits, progress).ok_or(DiagnosisError::NotFinite)?;
    let stands = |found: &Search| holds(found, records, &fitted, &left);
    let as_it_is = |found: &mut Search| {
        !found.ended_contrary() && (stands(found) || found.stands_in_another_form(&fitted, &stands))
    };
    let mut do_stand = as_it_is(&mut found);
    while !do_stand && found.without_the_last_name(&fitted) {
        do_stand = as_it_is(&mut found);
    }
    if !do_stand {
        progress(0.9, "looking for two effects at once");
        if !found.stands_as_two(records, &fitted, &limits, &stands) {
            found.take_back();
        }
    }
    progress(0.92, "looking at what is left");
    let answer = Answer {
        records,
        fitted: &fitted,
        left: &left,
        found: &found,
        situation: &situation,
        heat_span,
        most_effects: options.max_effects,
    };
    let diagnosis = answer.diagnosis();
    progress(1.0, "done");
    Ok(diagnosis)
}

/// Stops are looked for as far as the tests reach, and what lies beyond is told.
fn is_stop(effect: &str) -> bool {
    matches!(effect, "bump_stop" | "rebound_stop")
}

/// What the answer is made from.
struct Answer<'a> {
    records: &'a [&'a Record],
    fitted: &'a [Test],
    left: &'a [Test],
    found: &'a Search,
    situation: &'a Situation,
    heat_span: f64,
    most_effects: usize,
}

/// Times its allowed error from which one test is missed where all together are not, and most such tests told.
const LOUD: f64 = 1.8;
const LOUDEST: usize = 4;

/// Times its allowed error from which a fitted test is missed by so much that something is missing, rare as it may be.
const MISSED: f64 = 2.2;

/// What to say of single tests that are missed where little is missing all in all.
fn loud(mut tests: Vec<(&Test, f64)>) -> Option<String> {
    tests.retain(|(test, error)| *error > LOUD * test.segment.scale);
    tests.sort_by(|a, b| (b.1 / b.0.segment.scale).total_cmp(&(a.1 / a.0.segment.scale)));
    let words: Vec<String> = tests
        .iter()
        .take(LOUDEST)
        .map(|(test, error)| format!("{} ({error:.1} N, allowed {:.1} N)", test.segment.name, test.segment.scale))
        .collect();
    (!words.is_empty()).then(|| {
        format!("too rare or too small all in all to be named, but these tests are missed: {}", words.join(", "))
    })
}

impl Answer<'_> {
    fn diagnosis(&self) -> Diagnosis {
        let found = self.found;
        let (base, first) = &found.base;
        let (last, end) = &found.last;
        let of = |h: &Hypothesis, theta: &[f64], tests: &[Test]| {
            errors(h, theta, self.records, tests).unwrap_or_else(|| vec![vec![f64::NAN]; tests.len()])
        };
        let (fitted_before, left_before) = (of(base, &first.theta, self.fitted), of(base, &first.theta, self.left));
        let (fitted_after, left_after) = (of(last, &end.theta, self.fitted), of(last, &end.theta, self.left));
        let is_missed = |(test, errors): (&Test, &Vec<f64>)| rms(errors) > MISSED * test.segment.scale;
        let missed = self.fitted.iter().zip(&fitted_before).any(is_missed);
        let judged = verdict::judge(found, self.fitted, self.most_effects, missed);
        let noise_of = |tests: &[Test]| rms(&tests.iter().map(|t| t.mean_noise).collect::<Vec<_>>());
        let noise = noise_of(self.fitted);
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
            }
        };
        let gap = if self.left.is_empty() {
            gap_closed(self.fitted, &fitted_before, &fitted_after)
        } else {
            gap_closed(self.left, &left_before, &left_after)
        };
        let names: Vec<&str> = found.added.iter().map(|a| a.candidate.effect).collect();
        let invisible = found.rounds.first().map_or(&[][..], |r| &r.invisible);
        let mut notes = judged.notes.clone();
        if judged.is_quiet {
            let all = self.fitted.iter().zip(&fitted_before).chain(self.left.iter().zip(&left_before));
            notes.extend(loud(all.map(|(test, errors)| (test, rms(errors))).collect()));
        }
        let mut diagnosis = Diagnosis {
            verdict: judged.verdict,
            summary: judged.summary.clone(),
            findings: self.findings(),
            suspects: judged.suspects.clone(),
            regions: regions::regions(self.fitted, &fitted_before),
            before: figures(&fitted_before, &left_before),
            after: figures(&fitted_after, &left_after),
            gap_closed: gap.filter(|_| !found.added.is_empty()),
            next_tests: self.next_tests(&judged),
            could_not_test: untestable::list(self.situation, invisible, &names, self.heat_span),
            shifts: self.shifts(),
            notes,
            tests: Vec::new(),
            rounds: found
                .rounds
                .iter()
                .map(|round| {
                    round
                        .tried
                        .iter()
                        .map(|t| Tried {
                            effect: t.candidate.effect,
                            form: t.candidate.form,
                            confidence: t.confidence,
                            evidence: t.evidence,
                        })
                        .collect()
                })
                .collect(),
            base: base.params(&first.theta),
            improved: last.params(&end.theta),
            corrections: self.corrections(),
            estimates: improved::estimates(found),
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

    fn findings(&self) -> Vec<Finding> {
        let found = self.found;
        let (last, end) = &found.last;
        let deviations = deviations(last, end);
        found
            .added
            .iter()
            .map(|added| {
                let round = found.found_in(added.candidate.effect).map(|place| &found.rounds[place]);
                let mut parameters = BTreeMap::new();
                for (fresh, place) in added.candidate.fresh.iter().zip(added.numbers.clone()) {
                    let (value, deviation) = (end.theta[place], deviations[place]);
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
                Finding {
                    effect: added.candidate.effect,
                    form: added.candidate.form,
                    meaning: meaning(added.candidate.effect),
                    confidence: added.confidence,
                    of_the_rig: added.candidate.is_artefact(),
                    parameters,
                    gap_closed: self.gap_of(added),
                    evidence: added.evidence,
                    rivals: round.map_or(Vec::new(), verdict::rivals),
                }
            })
            .collect()
    }

    /// Share of the gap that opens again without one effect.
    fn gap_of(&self, added: &search::Added) -> Option<f64> {
        let (last, end) = &self.found.last;
        let (base, first) = &self.found.base;
        let tests = if self.left.is_empty() { self.fitted } else { self.left };
        let without = search::without(last, &end.theta, added);
        let refitted = refit::refit(&without, self.fitted, &without.start(), None, refit::Effort::COMPARE)?;
        let noise = noise_alone(tests);
        let of = |h: &Hypothesis, theta: &[f64]| errors(h, theta, self.records, tests).map(|e| in_noise(tests, &e));
        let before = of(base, &first.theta)?;
        let (with, less) = (of(last, &end.theta)?, of(&without, &refitted.theta)?);
        (before > 1.02 * noise).then(|| (less - with) / (before - noise))
    }

    fn corrections(&self) -> BTreeMap<&'static str, f64> {
        let (last, end) = &self.found.last;
        last.numbers
            .iter()
            .zip(&end.theta)
            .filter_map(|(n, value)| match n.free {
                Free::Rig(artefact) => Some((artefact.name(), *value)),
                _ => None,
            })
            .collect()
    }

    /// Scalars of the base that moved by more than three of their deviations.
    fn shifts(&self) -> Vec<Shift> {
        let (base, first) = &self.found.base;
        let (last, end) = &self.found.last;
        if self.found.added.is_empty() {
            return Vec::new();
        }
        let deviations = deviations(base, first);
        base.numbers
            .iter()
            .enumerate()
            .filter_map(|(k, n)| {
                let Free::Model(Unknown::Log(name) | Unknown::Linear(name)) = &n.free else { return None };
                let after = end.theta[last.place_of(&n.free)?];
                ((after - first.theta[k]).abs() > 3.0 * deviations[k]).then(|| Shift {
                    parameter: name,
                    before: physical(&n.free, first.theta[k]),
                    after: physical(&n.free, after),
                    unit: find(name).map_or("", |row| row.parameter.unit),
                })
            })
            .collect()
    }

    fn next_tests(&self, judged: &verdict::Judged) -> Vec<NextTest> {
        if judged.verdict == Verdict::NothingMissing {
            return Vec::new();
        }
        let Some(round) = (if judged.verdict == Verdict::Named && judged.suspects.is_empty() {
            self.found.rounds.first()
        } else {
            self.found.rounds.last()
        }) else {
            return Vec::new();
        };
        let rivals: Vec<next_test::Rival> = round
            .named()
            .take(3)
            .filter(|t| t.evidence.bic_fall > 0.0 && t.evidence.share > verdict::LISTED)
            .map(|t| next_test::Rival {
                effect: t.candidate.effect,
                hypothesis: &t.hypothesis,
                theta: &t.refit.theta,
                confidence: t.confidence,
            })
            .collect();
        next_test::propose(&rivals, &next_test::Rig::of(self.fitted))
    }
}

fn name_of(free: &Free) -> (&'static str, &'static str) {
    match free {
        Free::Model(Unknown::Log(name) | Unknown::Linear(name) | Unknown::Above(name, _) | Unknown::Entry(name, _)) => {
            (name, find(name).map_or("", |row| row.parameter.unit))
        }
        Free::Model(Unknown::Rise { curve, .. }) => (curve.forces(), "N"),
        Free::Rig(artefact) => (artefact.parameter(), artefact.unit()),
        Free::Cooling => ("cooling_rate", "1/s"),
        Free::HeatCapacity => ("heat_capacity", "J/K"),
    }
}

/// What an effect is, in one line.
pub fn meaning(effect: &str) -> String {
    match effect {
        "channel_delay" => "the force channel lags the motion channels (rig)".to_owned(),
        "force_offset" => "the load cell does not read zero without load (rig)".to_owned(),
        "force_drift" => "the zero of the load cell moves with time (rig)".to_owned(),
        _ => GROUPS.iter().find(|g| g.name == effect).map_or_else(String::new, |g| g.meaning.to_owned()),
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
