//! Composition of the outcome: verdict, inventory, findings, changes, errors before and after, next tests.

use super::advice::Advice;
use super::calibration::confidence;
use super::changes::{Change, changes};
use super::decisions::{MATERIAL, NAMED};
use super::effects::{self, meaning};
use super::name_of::name_of;
use super::outcome::*;
use super::plausible::is_plausible;
use super::prepared::Against;
use super::rivals::{Open, explained};
use super::verdict::{Judged, VerdictContext};
use super::wording::physical;
use super::{improved, phrases, proposed_test, regions, tree, untestable};
use dashpot_estimation::deviations::sandwich;
use dashpot_estimation::gap::{errors, gap_closed, in_noise, noise_alone, rms, rms_of_tests};
use dashpot_estimation::hypothesis::Free;
use dashpot_estimation::refit::Effort;
use dashpot_estimation::samples::Test;
use dashpot_estimation::sensitivity::Accuracy;
use dashpot_estimation::situation::Situation;
use dashpot_estimation::structure::alternatives::{alternatives, interval_ends};
use dashpot_estimation::structure::component::{Component, element_of};
use dashpot_estimation::structure::context::Structure;
use dashpot_estimation::structure::inventory::{Instead, InventoryItem, Status, inventory};
use dashpot_estimation::structure::search::{StructureSearch, Temperatures};
use dashpot_estimation::unknowns::Unknown;
use dashpot_identification::describe_priors;
use dashpot_messages::Sentence;
use dashpot_messages::Template;
use dashpot_records::Record;
use std::collections::BTreeMap;

/// Ending of the names of those cavitation forms in which the damper has no force at the beginning of a stroke.
const LOST_STROKE: &str = "begins with a lost stroke";

/// Smallest confidence at which no further test is proposed to confirm the name of an effect.
const DECIDED: f64 = 0.9;
/// Largest number of competing effects among which the proposed tests distinguish.
const UNDECIDED: usize = 3;
/// Records, tests and structures from which the outcome of a diagnosis is composed.
pub(super) struct Composed<'a> {
    /// Remarks about a reference that contains measurements of the diagnosed campaign, has the opposite positive
    /// direction, or was measured at another temperature.
    pub reference_remarks: Vec<Sentence>,
    pub records: &'a [&'a Record],
    pub fitted: Vec<Test>,
    pub left: Vec<Test>,
    pub search: StructureSearch,
    /// The given model, or the model that was fitted to the reference, after a refit.
    pub start: Structure,
    /// The most probable structure, after a refit.
    pub best: Structure,
    pub situation: Situation,
    /// The reference damper, if there is one.
    pub against: Option<Against>,
    /// Effects to which the user limited the search. `None` means all effects.
    pub asked: Option<&'a [String]>,
}

fn is_change(component: &Component) -> bool {
    component.form == "changed"
}

/// Residuals of a model in the samples of each test, N.
struct Residuals {
    fitted: Vec<Vec<f64>>,
    left: Vec<Vec<f64>>,
}

/// Residuals of the given model and of the best structure.
struct BeforeAndAfter {
    before: Residuals,
    after: Residuals,
}

impl Composed<'_> {
    /// Returns the probable effects that are not in the given model, most probable first. The first list contains the
    /// effects to name, the second list the effects whose force is too small to name them.
    fn named<'c>(
        &'c self,
        items: &[InventoryItem],
        probability: &dyn Fn(&str) -> f64,
    ) -> (Vec<&'c Component>, Vec<&'c Component>) {
        let is_new = |c: &&Component| !is_change(c) && self.start.components.iter().all(|own| own.effect != c.effect);
        let mut all: Vec<&Component> =
            self.best.components.iter().filter(is_new).filter(|c| probability(c.effect) >= NAMED).collect();
        // Among names of equal confidence, the name with the larger force comes first.
        let force = |c: &Component| items.iter().find(|i| i.effect == c.effect).map_or(0.0, |item| item.force_n_rms);
        let order = |c: &Component| (probability(c.effect), force(c));
        all.sort_by(|a, b| order(b).0.total_cmp(&order(a).0).then(order(b).1.total_cmp(&order(a).1)));
        let is_material =
            |c: &&Component| items.iter().find(|i| i.effect == c.effect).is_none_or(|item| self.is_material(item));
        all.into_iter().partition(is_material)
    }

    /// Returns whether the force of an effect is large enough to name it.
    ///
    /// In at least one test, the force must exceed the noise of a sample and the fraction [`MATERIAL`] of the measured
    /// force. An effect whose force is unknown counts as large enough.
    fn is_material(&self, item: &InventoryItem) -> bool {
        let mut tests = item.test_forces_n.iter().zip(&self.fitted);
        let exceeds = |(force, test): (&f64, &Test)| {
            let noise = self.records.get(test.record).map_or(test.mean_noise, |record| record.noise.force_rms);
            *force > noise.max(MATERIAL * rms(test.forces()))
        };
        item.test_forces_n.is_empty() || tests.any(exceeds)
    }

    /// Composes the diagnosis.
    pub fn diagnosis(self) -> Diagnosis {
        let is_against = self.against.is_some();
        let at = if is_against { Temperatures::AGAINST_REFERENCE } else { Temperatures::WITHOUT_REFERENCE };
        let probabilities = self.search.probabilities(at);
        let probability = |effect: &str| confidence(probabilities.get(effect).copied().unwrap_or(0.0), is_against);
        let tree = tree::tree(&self.search, at);
        let residuals = self.residuals();
        let items = self.items(&probabilities, &probability);
        let force = |effect: &str| items.iter().find(|i| i.effect == effect).map_or(0.0, |i| i.force_n_rms);
        let others = alternatives(&self.search, &self.best, at, &self.fitted);
        let known = interval_ends(&self.best, &others, &self.fitted);
        let bounds = || self.best.hypothesis.numbers.iter().map(|number| number.bounds.into()).collect();
        let ends: Vec<[f64; 2]> = known.clone().unwrap_or_else(bounds);
        let changed = match &known {
            Some(ends) if is_against => changes(&self.best, ends, &probability, &force),
            _ => Vec::new(),
        };
        let (changed_items, inventory): (Vec<InventoryItem>, Vec<InventoryItem>) =
            items.iter().cloned().partition(|item| item.form == "changed");
        let material = self.material_changes(&changed, &changed_items);
        let (names, immaterial) = self.named(&inventory, &probability);
        let judged = VerdictContext {
            start: &self.start,
            best: &self.best,
            search: &self.search,
            fitted: &self.fitted,
            is_against,
            asked: self.asked,
            names: &names,
            changed: &material,
            has_small_changes: changed.len() > material.len(),
            items: &inventory,
            suspects: self.open(&probability).suspects(),
            probability: &probability,
        }
        .judge();
        let effects: Vec<&str> = names.iter().map(|c| c.effect).collect();
        let could_not_test = untestable::list(&self.situation, &self.search.visible, &effects, &self.advice());
        let summary = match judged.verdict {
            Verdict::NothingMissing => self.with_limits(judged.summary.clone(), &could_not_test),
            _ => judged.summary.clone(),
        };
        let (before, after) = (self.start.evidence.mean(), self.best.evidence.mean());
        let findings = self.findings(&names, &inventory, &tree, &probability, &ends, &judged.suspects);
        let estimates = improved::estimates(&self.best, known.as_deref());
        let of_priors = describe_priors(&self.best.hypothesis.priors, &estimates);
        let about_the_reference = self.about_the_reference(&names);
        let about_names = self.about_names(&names, &immaterial);
        let next_tests = self.next_tests(&judged, &names, &probability);
        let notes = judged.notes.into_iter().chain(about_the_reference.clone());
        let notes = notes.chain(self.reference_remarks.iter().cloned()).chain(about_names).chain(of_priors).collect();
        let params = |structure: &Structure| structure.hypothesis.params(&structure.refit.theta);
        Diagnosis {
            verdict: judged.verdict,
            summary,
            findings,
            inventory,
            suspects: judged.suspects,
            regions: regions::regions(&self.fitted, &residuals.before.fitted),
            before: self.figures(&residuals.before),
            after: self.figures(&residuals.after),
            gap_closed: self.gap_closed(&residuals).filter(|_| self.best.key() != self.start.key()),
            unexplained_fraction: 1.0 - explained(before, after).clamp(0.0, 1.0),
            tree,
            next_tests,
            could_not_test,
            shifts: self.shifts(),
            notes,
            about_the_reference,
            tests: self.test_outcomes(&residuals),
            iterations: vec![self.tried(&probability)],
            base: params(&self.start),
            improved: params(&self.best),
            reference: self.against.as_ref().map(|against| params(&against.structure)),
            priors: self.best.hypothesis.priors.clone(),
            corrections: self.corrections(),
            estimates,
            measured: improved::measured(&self.best, &ends),
            changes: changed,
        }
    }

    /// Computes the residuals of the given model and of the best structure.
    fn residuals(&self) -> BeforeAndAfter {
        let of = |structure: &Structure, tests: &[Test]| {
            errors(self.accuracy(), &structure.hypothesis, &structure.refit.theta, self.records, tests)
                .unwrap_or_else(|| vec![vec![f64::NAN]; tests.len()])
        };
        let both =
            |structure: &Structure| Residuals { fitted: of(structure, &self.fitted), left: of(structure, &self.left) };
        BeforeAndAfter { before: both(&self.start), after: both(&self.best) }
    }

    /// Returns the inventory of the best structure and its changes.
    fn items(
        &self,
        probabilities: &BTreeMap<&'static str, f64>,
        probability: &dyn Fn(&str) -> f64,
    ) -> Vec<InventoryItem> {
        let mut items = inventory(&self.best, Some(&self.start), &self.fitted, &probability);
        // The calibration applies only to added effects. Effects of the given model that the best structure also has
        // keep the probability that the search computed.
        for item in items.iter_mut().filter(|item| item.status == Status::Kept) {
            item.probability = probabilities.get(item.effect).copied().unwrap_or(0.0);
            if item.probability < 0.5 {
                item.or_instead = self.instead_of(item.effect, probabilities);
            }
        }
        items
    }

    /// Returns the changes whose force is large enough to name them.
    fn material_changes<'c>(&self, changed: &'c [Change], items: &[InventoryItem]) -> Vec<&'c Change> {
        let measured_rms = rms_of_tests(&self.fitted.iter().map(|t| t.forces().to_vec()).collect::<Vec<_>>());
        let is_material = |change: &&Change| {
            items.iter().any(|i| i.effect == change.name) && change.force_n_rms > MATERIAL * measured_rms
        };
        changed.iter().filter(is_material).collect()
    }

    /// Summarizes residuals of a model.
    fn figures(&self, residuals: &Residuals) -> Figures {
        let noise_of = |tests: &[Test]| rms(&tests.iter().map(|t| t.mean_noise).collect::<Vec<_>>());
        let fitted = self.fitted.iter().zip(&residuals.fitted);
        let every: Vec<f64> = fitted
            .chain(self.left.iter().zip(&residuals.left))
            .map(|(t, e)| {
                100.0 * e.iter().map(|x| x.abs()).sum::<f64>() / e.len().max(1) as f64 / t.segment.top.max(1e-9)
            })
            .collect();
        Figures {
            rmse_n: rms_of_tests(&residuals.fitted),
            error_percent: every.iter().sum::<f64>() / every.len().max(1) as f64,
            left_out_rmse_n: (!residuals.left.is_empty()).then(|| rms_of_tests(&residuals.left)),
            noise_n: noise_of(&self.fitted),
            left_out_noise_n: (!self.left.is_empty()).then(|| noise_of(&self.left)),
        }
    }

    /// Returns the fraction of the given model's error above the noise that the best structure removes. Uses the
    /// left-out tests if there are any.
    fn gap_closed(&self, BeforeAndAfter { before, after }: &BeforeAndAfter) -> Option<f64> {
        if self.left.is_empty() {
            gap_closed(&self.fitted, &before.fitted, &after.fitted)
        } else {
            gap_closed(&self.left, &before.left, &after.left)
        }
    }

    /// Returns the errors and curves of all tests. The fitted tests come first, then the left-out tests.
    fn test_outcomes(&self, BeforeAndAfter { before, after }: &BeforeAndAfter) -> Vec<TestOutcome> {
        let outcome = |left_out: bool, test: &Test, before: &[f64], after: &[f64]| {
            let measured = test.forces().to_vec();
            let less = |e: &[f64]| measured.iter().zip(e).map(|(m, e)| m - e).collect();
            TestOutcome {
                test: test.segment.name.clone(),
                left_out,
                before_rmse_n: rms(before),
                after_rmse_n: rms(after),
                noise_n: test.mean_noise,
                allowed_n: test.segment.scale,
                curves: Curves {
                    displacement: test.inputs().iter().map(|i| i.displacement.unwrap_or(0.0)).collect(),
                    velocity: test.inputs().iter().map(|i| i.velocity).collect(),
                    before: less(before),
                    after: less(after),
                    measured,
                    frequency: test.frequency,
                },
            }
        };
        let fitted = self.fitted.iter().enumerate();
        let left = self.left.iter().enumerate();
        fitted
            .map(|(k, test)| outcome(false, test, &before.fitted[k], &after.fitted[k]))
            .chain(left.map(|(k, test)| outcome(true, test, &before.left[k], &after.left[k])))
            .collect()
    }

    /// Returns notes about named effects, and about effects whose force is too small to name them.
    fn about_names(&self, names: &[&Component], immaterial: &[&Component]) -> Vec<Sentence> {
        let has_drift = names.iter().any(|c| c.effect == "force_drift");
        let or_warm_gas =
            (has_drift && !self.situation.temperature_measured).then(|| Sentence::from(phrases::OR_WARM_GAS));
        let too_small = (!immaterial.is_empty()).then(|| {
            let effects = immaterial.iter().map(|c| c.effect);
            Sentence::from(phrases::IMMATERIAL).with_names("effects", effects, phrases::COMMA)
        });
        or_warm_gas.into_iter().chain(too_small).collect()
    }

    /// Returns an effect that may explain the records instead of `effect`. It is an effect of the most probable visited
    /// structure without `effect`, and is not in the best structure. Returns `None` if the search visited no structure
    /// without `effect`, or if that structure has no such effect.
    fn instead_of(&self, effect: &str, probabilities: &BTreeMap<&'static str, f64>) -> Option<Instead> {
        let without = self.search.table.iter().filter(|(key, _)| key.iter().all(|form| form.0 != effect));
        let (key, _) = without.max_by(|(_, a), (_, b)| a.log_posterior.total_cmp(&b.log_posterior))?;
        let is_new = |form: &&(&'static str, &'static str)| self.best.components.iter().all(|c| c.effect != form.0);
        let effect = key.iter().find(is_new)?.0;
        Some(Instead { effect, probability: probabilities.get(effect).copied().unwrap_or(0.0) })
    }

    fn open<'a>(&'a self, probability: &'a dyn Fn(&str) -> f64) -> Open<'a> {
        Open { search: &self.search, start: &self.start, best: &self.best, probability }
    }

    /// Returns the trials, most probable first. Each trial adds one form of an effect to the best structure.
    fn tried(&self, probability: &dyn Fn(&str) -> f64) -> Vec<Trial> {
        let before = &self.search.best.evidence;
        let of = |t: &dashpot_estimation::structure::expansion::Trial| {
            let after = &t.structure.evidence;
            let better = before.mean_squares.iter().zip(&after.mean_squares).filter(|(b, a)| a < b).count();
            Trial {
                effect: t.form.0,
                form: t.form.1,
                confidence: probability(t.form.0),
                evidence: Evidence {
                    fraction: explained(before.mean(), after.mean()),
                    mean_square_before: before.mean(),
                    mean_square_after: after.mean(),
                    log_odds: t.structure.log_posterior - self.search.best.log_posterior,
                    numbers: after.numbers - before.numbers,
                    negative_log_prior: after.negative_log_prior - before.negative_log_prior,
                    tests_better: better as f64 / before.mean_squares.len().max(1) as f64,
                },
            }
        };
        self.search.last.iter().map(of).collect()
    }

    fn findings(
        &self,
        names: &[&Component],
        items: &[InventoryItem],
        tree: &[tree::Branch],
        probability: &dyn Fn(&str) -> f64,
        ends: &[[f64; 2]],
        suspects: &[Rival],
    ) -> Vec<Finding> {
        let (hypothesis, theta) = (&self.best.hypothesis, &self.best.refit.theta);
        let (whole, before) = (self.best.evidence.mean(), self.start.evidence.mean());
        let one = |component: &&Component| {
            let effect = component.effect;
            let mut parameters = BTreeMap::new();
            for (k, number) in hypothesis.numbers.iter().enumerate() {
                let is_own = component.frees.contains(&number.free)
                    || element_of(&number.free).is_some_and(|element| component.elements.contains(&element));
                if !is_own {
                    continue;
                }
                let at = |t: f64| physical(&number.free, t);
                let (name, unit) = name_of(&number.free);
                let value = at(theta[k]);
                let [low, high] = ends[k].map(at);
                parameters
                    .insert(name, Value { value, low, high, unit, plausible: is_plausible(hypothesis, k, theta) });
            }
            if let Some(lost) = self.lost_stroke(component.form, &parameters) {
                parameters.insert("lost_stroke", lost);
            }
            let place = self.best.components.iter().position(|c| c.effect == effect);
            let less = place.and_then(|place| self.best.without(place, &self.fitted, Effort::COMPARE));
            let without = less.as_ref().map_or(before, |less| less.evidence.mean());
            let other = less.as_ref().unwrap_or(&self.start);
            let squares = self.best.evidence.mean_squares.iter().zip(&other.evidence.mean_squares);
            let better = squares.filter(|(own, other)| own < other).count();
            let card = effects::card(effect);
            let item = items.iter().find(|i| i.effect == effect);
            let family = card.map_or("", |c| c.family);
            let of_family = tree.iter().flat_map(|path| &path.branches).filter(|branch| branch.name == family);
            let family_confidence =
                of_family.map(|branch| confidence(branch.probability, self.against.is_some())).sum::<f64>();
            Finding {
                effect,
                form: component.form,
                meaning: meaning(effect),
                path: card.map_or("", |c| c.path),
                family,
                confidence: probability(effect),
                family_confidence: family_confidence.max(probability(effect)).min(1.0),
                // The structure without the effect may fit worse than the given model, because other elements were
                // adapted to the effect. Therefore, the residual without the effect counts at most as much as that of
                // the given model.
                fraction: ((without.min(before) - whole) / (before - 1.0).max(1e-9)).clamp(0.0, 1.0),
                force_n_rms: item.map_or(0.0, |i| i.force_n_rms),
                of_the_rig: component.is_of_measurement(),
                parameters,
                gap_closed: less.as_ref().and_then(|less| self.gap_without(less)),
                evidence: Evidence {
                    fraction: explained(without, whole),
                    mean_square_before: without,
                    mean_square_after: whole,
                    log_odds: self.best.log_posterior - other.log_posterior,
                    numbers: component.numbers,
                    negative_log_prior: self.best.evidence.negative_log_prior - other.evidence.negative_log_prior,
                    tests_better: better as f64 / self.fitted.len().max(1) as f64,
                },
                // A suspect may be missing in addition to the named effect, not instead of it.
                rivals: self
                    .open(probability)
                    .rivals(effect)
                    .into_iter()
                    .filter(|rival| suspects.iter().all(|suspect| suspect.effect != rival.effect))
                    .collect(),
            }
        };
        names.iter().map(one).collect()
    }

    /// Returns the length of the lost stroke, m: the unfilled fraction times the longest stroke of the fitted tests,
    /// twice their largest amplitude. Returns `None` if the form has no lost stroke.
    fn lost_stroke(&self, form: &str, parameters: &BTreeMap<&'static str, Value>) -> Option<Value> {
        let unfilled = parameters.get("cavitation_unfilled").filter(|_| form.ends_with(LOST_STROKE))?;
        let stroke = 2.0 * self.fitted.iter().map(|t| t.segment.amplitude).fold(0.0, f64::max);
        Some(Value {
            value: stroke * unfilled.value,
            low: stroke * unfilled.low,
            high: stroke * unfilled.high,
            unit: "m",
            plausible: unfilled.plausible,
        })
    }

    /// Returns the fraction of the given model's error above the noise that returns if one effect is removed. `less` is
    /// the best structure without this effect. Uses the left-out tests if there are any.
    ///
    /// Returns `None` if the error above the noise is at most 2 % of the noise, or if a model gives no finite force.
    fn gap_without(&self, less: &Structure) -> Option<f64> {
        let tests = if self.left.is_empty() { &self.fitted } else { &self.left };
        let noise = noise_alone(tests);
        let of = |structure: &Structure| {
            let theta = &structure.refit.theta;
            errors(self.accuracy(), &structure.hypothesis, theta, self.records, tests).map(|e| in_noise(tests, &e))
        };
        let (before, with, less) = (of(&self.start)?, of(&self.best)?, of(less)?);
        // The structure without the effect may fit worse than the given model. Its error counts at most as much as that
        // of the given model. If the error with the effect is larger, the fraction is 0.
        (before > 1.02 * noise).then(|| ((less.min(before) - with) / (before - noise)).clamp(0.0, 1.0))
    }

    /// Returns the accuracy of the integration that computes the residuals. A comparison with a reference uses the low
    /// accuracy of the refits, because the form error of the reference was computed with this accuracy.
    fn accuracy(&self) -> Accuracy {
        if self.against.is_some() { Accuracy::Single } else { Accuracy::Full }
    }

    fn corrections(&self) -> BTreeMap<&'static str, f64> {
        let numbers = self.best.hypothesis.numbers.iter().zip(&self.best.refit.theta);
        numbers
            .filter_map(|(n, value)| match n.free {
                Free::Rig(artefact) => Some((artefact.name(), *value)),
                _ => None,
            })
            .collect()
    }

    /// Adds two limits of the records to the sentence that no effect is missing. The first limit is the list of
    /// effects that the records cannot show. The second is a lack of left-out tests, which could confirm the sentence.
    fn with_limits(&self, nothing: Sentence, could_not_test: &[CouldNotTest]) -> Sentence {
        let names = could_not_test.iter().map(|c| c.effect);
        let not_seen = (!could_not_test.is_empty())
            .then(|| Sentence::from(phrases::CANNOT_SHOW).with_names("effects", names, phrases::COMMA));
        let not_confirmed = self.left.is_empty().then(|| phrases::NOT_CONFIRMED.into());
        nothing.with_any("not_seen", not_seen).with_any("not_confirmed", not_confirmed)
    }

    /// Formats the remarks on the comparison with the reference. Without a reference, formats the limits of the effect
    /// names, or returns `None` if no effect is named.
    fn about_the_reference(&self, names: &[&Component]) -> Option<Sentence> {
        let Some(against) = &self.against else {
            return (!names.is_empty()).then(|| phrases::WITHOUT_REFERENCE.into());
        };
        let list = |said: Template, tests: &[String]| {
            (!tests.is_empty()).then(|| Sentence::from(said).with_names("tests", tests, phrases::COMMA))
        };
        let aside = list(phrases::WITHOUT_COUNTERPART, &against.missing);
        let nearest = list(phrases::BY_NEAREST_MOTION, &against.shifted);
        Some(Sentence::from(phrases::AGAINST_REFERENCE).with_any("aside", aside).with_any("nearest", nearest))
    }

    /// Returns the scalar parameters of the given model that changed by more than three standard deviations of their
    /// estimates in that model. The list is empty in a comparison with a reference, if the best structure has the
    /// effects of the given model, or without a covariance.
    fn shifts(&self) -> Vec<Shift> {
        let (start, best) = (&self.start, &self.best);
        if start.key() == best.key() || self.against.is_some() {
            return Vec::new();
        }
        let Some((covariance, _)) = sandwich(&start.hypothesis, &start.refit, &self.fitted) else { return Vec::new() };
        start
            .hypothesis
            .numbers
            .iter()
            .enumerate()
            .filter_map(|(k, n)| {
                let Free::Model(Unknown::Log(number) | Unknown::Linear(number)) = n.free else { return None };
                let (before, after) = (start.refit.theta[k], best.refit.theta[best.hypothesis.position(&n.free)?]);
                ((after - before).abs() > 3.0 * covariance[(k, k)].max(0.0).sqrt()).then(|| Shift {
                    parameter: number.name(),
                    before: physical(&n.free, before),
                    after: physical(&n.free, after),
                    unit: number.parameter().unit,
                })
            })
            .collect()
    }

    /// Proposes tests that distinguish undecided effect names. The list is empty if nothing is missing, or if all names
    /// are decided and no other effect is suspected.
    fn next_tests(&self, judged: &Judged, names: &[&Component], probability: &dyn Fn(&str) -> f64) -> Vec<NextTest> {
        let is_sure = names.iter().all(|c| probability(c.effect) >= DECIDED);
        if judged.verdict.nothing_is_missing()
            || judged.verdict == Verdict::Named && is_sure && judged.suspects.is_empty()
        {
            return Vec::new();
        }
        let mut rivals: Vec<proposed_test::Rival> = Vec::new();
        if let Some(first) = names.first() {
            let structure = &self.search.best;
            rivals.push(proposed_test::Rival {
                effect: first.effect,
                hypothesis: &structure.hypothesis,
                theta: &structure.refit.theta,
                confidence: probability(first.effect),
            });
        }
        // Suspects come first, because the verdict names them.
        let rank = |effect: &str| judged.suspects.iter().position(|s| s.effect == effect).unwrap_or(usize::MAX);
        let mut trials: Vec<_> = self.search.rivals.iter().chain(&self.search.last).collect();
        trials.sort_by_key(|trial| rank(trial.form.0));
        for trial in trials {
            let effect = trial.form.0;
            if rivals.len() < UNDECIDED && trial.unnamed.is_none() && rivals.iter().all(|r| r.effect != effect) {
                rivals.push(proposed_test::Rival {
                    effect,
                    hypothesis: &trial.structure.hypothesis,
                    theta: &trial.structure.refit.theta,
                    confidence: probability(effect),
                });
            }
        }
        proposed_test::propose(&rivals, &proposed_test::Rig::from_tests(&self.fitted), &self.advice())
    }

    fn advice(&self) -> Advice {
        Advice::new(self.records, &self.situation)
    }
}
