//! The outcome put together: verdict, findings, errors before and after, what to do next.

use super::answer::{explained, judge, rivals};
use super::changes::Changes;
use super::decisions::{SURE, SUSPECTED};
use super::effects::meaning;
use super::name_of::name_of;
use super::outcome::*;
use super::prepared::Against;
use super::search::{self, Search, physical};
use super::situation::Situation;
use super::{answer, calibration, changes, effects, improved, next_test, phrases, regions, round, tree, untestable};
use dashpot_estimation::deviations::deviations;
use dashpot_estimation::gap::{errors, gap_closed, in_noise, noise_alone, rms, rms_of_tests};
use dashpot_estimation::hypothesis::{Free, Hypothesis};
use dashpot_estimation::refit;
use dashpot_estimation::samples::Test;
use dashpot_estimation::sensitivity::Accuracy;
use dashpot_estimation::unknowns::Unknown;
use dashpot_records::sentence::Template;
use dashpot_records::{Record, Sentence};
use std::collections::BTreeMap;

/// Probability, each test counted as one sample, from which a name needs no further test.
const DECIDED: f64 = 0.9;
/// Most names that a test is sought to tell apart.
const UNDECIDED: usize = 3;

/// What the answer is made from.
pub(super) struct Composed<'a> {
    /// That the reference was read to count the other way, and that it was not as warm, where that is so.
    pub beside: [Option<Sentence>; 2],
    pub records: &'a [&'a Record],
    pub fitted: &'a [Test],
    pub left: &'a [Test],
    pub found: &'a Search,
    pub situation: &'a Situation,
    /// Of each name, in the order in which they were added.
    pub confidence: Vec<f64>,
    /// The model as the reference damper has it, where there is one.
    pub reference: Option<Against>,
}

impl Composed<'_> {
    /// What a drift of the load cell's zero may as well be where no temperature tells.
    fn or_warm_gas(&self, names: &[&str]) -> Option<Sentence> {
        (names.contains(&"force_drift") && !self.situation.temperature_measured).then(|| phrases::OR_WARM_GAS.into())
    }

    /// All of it.
    pub fn diagnosis(&self) -> Diagnosis {
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
                .chain(self.beside.iter().flatten())
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
