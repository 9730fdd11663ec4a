//! One look at what is left: everything refitted with each effect, each from several starts, and what each then leaves.

use super::decisions::{NOTHING, NOTHING_MORE, WITH_NAME, WITHOUT_NAME};
use super::evidence::{Weighed, log_mean_exp};
use super::nearby::Nearby;
use super::race::{Course, Started, race};
use super::screening::{Projection, Screened, screen};
use super::situation::Situation;
use super::vocabulary::{Candidate, candidates};
use dashpot_estimation::cancel;
use dashpot_estimation::hypothesis::Hypothesis;
use dashpot_estimation::implausibility::implausibility;
use dashpot_estimation::refit::Refit;
use dashpot_estimation::samples::{Test, Thin};
use dashpot_estimation::sensitivity::Accuracy;
use dashpot_records::Record;
use rayon::prelude::*;
use std::collections::{BTreeMap, BTreeSet};

/// What is looked at, and what may be tried.
pub struct Ground<'a> {
    /// The records.
    pub records: &'a [&'a Record],
    /// Their tests.
    pub tests: &'a [Test],
    /// Whether an effect may be tried.
    pub allowed: &'a (dyn Fn(&str) -> bool + Sync),
    /// Mean square that the base leaves; `None` for the base itself.
    pub base: Option<f64>,
    /// Forms that are tried; all where `None`.
    pub forms: Option<&'a BTreeSet<Form>>,
}

/// A form of an effect by its names.
pub type Form = (&'static str, &'static str);

/// A form of an effect that was tried by a full refit.
#[derive(Clone)]
pub struct Tried {
    /// The form tried.
    pub candidate: Candidate,
    /// The explanation with it.
    pub hypothesis: Hypothesis,
    /// Where the refit ended.
    pub refit: Refit,
    /// What it leaves and what it costs.
    pub weighed: Weighed,
}

/// One look.
pub struct Round {
    /// What the explanation leaves to which effects were added.
    pub before: Weighed,
    /// Mean square that the names in it explain already.
    pub named_so_far: f64,
    /// Whether it has names already: another is then less likely beforehand.
    pub is_later: bool,
    /// All forms that were refitted, best first.
    pub tried: Vec<Tried>,
    /// Effects that leave no trace in these tests, with what is left of their response, in σ².
    pub invisible: Vec<(&'static str, f64)>,
    /// How many effects might have been named: they share the odds that one of them is missing.
    pub choice: usize,
}

/// Probabilities of what a look may mean.
#[derive(Debug, Clone)]
pub struct Odds {
    /// Nothing is missing.
    pub nothing: f64,
    /// Something without a name is.
    pub without_name: f64,
    /// The effects.
    pub effects: BTreeMap<&'static str, f64>,
}

impl Round {
    /// The best two forms of every effect: what is worth trying beside another effect.
    pub fn promising(&self) -> BTreeSet<Form> {
        let mut counts: BTreeMap<&str, usize> = BTreeMap::new();
        let mut forms = BTreeSet::new();
        for tried in &self.tried {
            let count = counts.entry(tried.candidate.effect).or_default();
            *count += 1;
            if *count <= FORMS_BESIDE {
                forms.insert((tried.candidate.effect, tried.candidate.form));
            }
        }
        forms
    }

    /// The best form of each effect that has a name, best first.
    pub fn named(&self) -> Vec<&Tried> {
        let mut best: Vec<&Tried> = Vec::new();
        for tried in self.tried.iter().filter(|t| t.candidate.unnamed.is_none()) {
            if best.iter().all(|b| b.candidate.effect != tried.candidate.effect) {
                best.push(tried);
            }
        }
        best
    }

    /// Probabilities where each test counts as `samples` independent ones. The forms of an effect share its odds, tried or not. A name with
    /// which the records are no likelier than without it is none: it would live on the odds that something is missing alone, the more the
    /// fewer names may be given.
    pub fn odds(&self, samples: f64) -> Odds {
        let mut forms: BTreeMap<&'static str, Vec<f64>> = BTreeMap::new();
        let mut nameless = vec![self.before.log_evidence(samples)];
        for tried in &self.tried {
            let log = tried.weighed.log_evidence(samples);
            match tried.candidate.unnamed {
                None => forms.entry(tried.candidate.effect).or_default().push(log),
                Some(_) => nameless.push(log),
            }
        }
        let without_any = self.before.log_evidence(samples);
        forms.retain(|_, logs| logs.iter().any(|log| *log > without_any));
        let (nothing, with_name) =
            if self.is_later { (NOTHING_MORE, 1.0 - NOTHING_MORE - WITHOUT_NAME) } else { (NOTHING, WITH_NAME) };
        let nothing = libm::log(nothing) + self.before.log_evidence_of_nothing(samples, self.named_so_far);
        let without_name = libm::log(WITHOUT_NAME) + log_mean_exp(&nameless);
        let each = libm::log(with_name / self.choice.max(1) as f64);
        let logs: Vec<(&'static str, f64)> =
            forms.iter().map(|(effect, logs)| (*effect, each + log_mean_exp(logs))).collect();
        let most = logs.iter().map(|l| l.1).fold(nothing.max(without_name), f64::max);
        let sum = libm::exp(nothing - most)
            + libm::exp(without_name - most)
            + logs.iter().map(|(_, log)| libm::exp(log - most)).sum::<f64>();
        let share = |log: f64| libm::exp(log - most) / sum;
        Odds {
            nothing: share(nothing),
            without_name: share(without_name),
            effects: logs.into_iter().map(|(effect, log)| (effect, share(log))).collect(),
        }
    }
}

/// One round of screening, refitting and weighing; `None` where the explanation makes no finite force.
pub fn look(ground: &Ground, last: &(Hypothesis, Refit), without: &[&str]) -> Option<Round> {
    let tests = ground.tests;
    let (hypothesis, at) = last;
    let at = match hypothesis.jacobian(Accuracy::Cheap, tests, &at.theta) {
        Some(jacobian) => Refit { jacobian, ..at.clone() },
        None => at.clone(),
    };
    let nearby = Nearby::new(hypothesis, &at, tests)?;
    let thin = Thin::new(tests);
    let at_thin = Refit::at(
        hypothesis,
        at.theta.clone(),
        at.residual.select_rows(&thin.rows),
        at.jacobian.select_rows(&thin.rows),
    );
    let projection = Projection::new(hypothesis, &at_thin);
    let situation = Situation::new(&hypothesis.params(&at.theta), ground.records, tests);
    let list: Vec<Candidate> = candidates(&situation)
        .into_iter()
        .filter(|c| (c.unnamed.is_some() || (ground.allowed)(c.effect)) && !without.contains(&c.effect))
        .filter(|c| ground.forms.is_none_or(|forms| forms.contains(&(c.effect, c.form))))
        .collect();
    let roughly = Nearby::new(hypothesis, &at_thin, &thin.tests)?;
    let screened = screen(hypothesis, &at_thin, &projection, &list, &thin.tests, &roughly);
    let started: Vec<Started> = choose(&screened, &list)
        .par_iter()
        .filter_map(|place| {
            if cancel::asked() {
                return None;
            }
            let s = &screened[*place];
            let residual_at = |theta: &[f64]| roughly.residual(&s.hypothesis, &thin.tests, theta);
            let (mut start, mut residual) = (s.start.clone(), residual_at(&s.start)?);
            if !s.moved && residual.norm_squared() > at_thin.residual.norm_squared() {
                // The base gave way to first order, which may be further than it goes: then it had better stay.
                let still = s.hypothesis.start();
                let there = residual_at(&still)?;
                if there.norm_squared() < residual.norm_squared() {
                    (start, residual) = (still, there);
                }
            }
            let jacobian = roughly.jacobian(&s.hypothesis, &thin.tests, &start, &residual)?;
            Some(Started { place: *place, start, jacobian })
        })
        .collect();
    let strangeness = implausibility(hypothesis, &at.theta);
    let course = Course {
        screened: &screened,
        list: &list,
        tests,
        strangeness,
        nearby: &nearby,
        thin: &thin,
        roughly: &roughly,
    };
    let mut tried: Vec<Tried> = race(started, &course)
        .into_iter()
        .map(|(place, refit)| {
            let s = &screened[place];
            let candidate = &list[s.candidate];
            let weighed = Weighed::new(&s.hypothesis, &refit, tests, candidate.numbers(), strangeness);
            Tried { candidate: candidate.clone(), hypothesis: s.hypothesis.clone(), refit, weighed }
        })
        .collect();
    let log = |t: &Tried| t.weighed.log_evidence(super::decisions::SUSPECTED);
    tried.sort_by(|a, b| log(b).total_cmp(&log(a)));
    let mut invisible: Vec<(&'static str, f64)> = Vec::new();
    for candidate in list.iter().filter(|c| c.unnamed.is_none()) {
        let seen = screened
            .iter()
            .filter(|s| list[s.candidate].effect == candidate.effect)
            .map(|s| thin.share * s.visible)
            .fold(0.0, f64::max);
        if !invisible.iter().any(|(name, _)| *name == candidate.effect) {
            invisible.push((candidate.effect, seen));
        }
    }
    let choice = invisible.len();
    let before = Weighed::new(hypothesis, &at, tests, 0.0, strangeness);
    let named_so_far = ground.base.map_or(0.0, |base| base - before.mean());
    Some(Round { before, named_so_far, is_later: !without.is_empty(), tried, invisible, choice })
}

/// Forms of an effect that are tried again beside another effect.
const FORMS_BESIDE: usize = 2;

/// Starts of each form that are tried: the best by what they promise to first order, and as many of those that moved the base as well,
/// whose answer to first order says little of where they end.
const PROMISING: usize = 2;
const MOVED: usize = 4;

fn choose(screened: &[Screened], list: &[Candidate]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..screened.len()).collect();
    order.sort_by(|a, b| screened[*b].gain.total_cmp(&screened[*a].gain));
    let mut counts: BTreeMap<(Form, bool), usize> = BTreeMap::new();
    order.retain(|place| {
        let s = &screened[*place];
        let candidate = &list[s.candidate];
        let count = counts.entry(((candidate.effect, candidate.form), s.moved)).or_default();
        *count += 1;
        *count <= if s.moved { MOVED } else { PROMISING }
    });
    order
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use dashpot_core::Params;
    use dashpot_core::element;
    use nalgebra::{DMatrix, DVector};

    /// Tests of a campaign, as many as a small one has.
    const TESTS: usize = 20;

    fn weighed(mean_square: f64, numbers: f64) -> Weighed {
        Weighed { mean_squares: vec![mean_square; TESTS], numbers, implausibility: 0.0 }
    }

    /// A form that leaves so much.
    pub fn tried(effect: &'static str, form: &'static str, leaves: f64) -> Tried {
        let hypothesis = Hypothesis { base: Params::new(), numbers: Vec::new(), heating: None };
        let refit = Refit::at(&hypothesis, Vec::new(), DVector::zeros(0), DMatrix::zeros(0, 0));
        let candidate = Candidate {
            effect,
            form,
            elements: &[element!("gas_spring")],
            fixed: Vec::new(),
            fresh: Vec::new(),
            starts: Vec::new(),
            jumps: false,
            unnamed: None,
        };
        Tried { candidate, hypothesis, refit, weighed: weighed(leaves, 2.0) }
    }

    /// A first look at a base that leaves so much, with these forms tried.
    pub fn round(before: f64, mut tried: Vec<Tried>) -> Round {
        let log = |t: &Tried| t.weighed.log_evidence(2.0);
        tried.sort_by(|a, b| log(b).total_cmp(&log(a)));
        Round {
            before: weighed(before, 0.0),
            named_so_far: 0.0,
            is_later: false,
            tried,
            invisible: Vec::new(),
            choice: 18,
        }
    }

    fn sum(odds: &Odds) -> f64 {
        odds.nothing + odds.without_name + odds.effects.values().sum::<f64>()
    }

    #[test]
    fn the_odds_are_probabilities_and_follow_what_is_left() {
        let quiet = round(1.0, vec![tried("aeration", "", 0.99)]).odds(2.0);
        assert!((sum(&quiet) - 1.0).abs() < 1e-12 && quiet.nothing > 0.8, "{quiet:?}");
        let loud = round(9.0, vec![tried("aeration", "", 1.05), tried("free_play", "", 5.0)]).odds(2.0);
        assert!((sum(&loud) - 1.0).abs() < 1e-12 && loud.effects["aeration"] > 0.9, "{loud:?}");
        // Nothing explains it: it has no name.
        let strange = round(9.0, vec![tried("aeration", "", 8.5)]).odds(2.0);
        assert!(strange.without_name > 0.5 && strange.nothing < 1e-3, "{strange:?}");
        // Fewer independent samples make every answer less sure.
        let rather = round(3.0, vec![tried("aeration", "", 1.2)]);
        assert!(rather.odds(1.0).effects["aeration"] < rather.odds(2.0).effects["aeration"]);
    }

    #[test]
    fn a_name_with_which_the_records_are_no_likelier_is_none() {
        let odds = round(4.0, vec![tried("aeration", "", 3.99)]).odds(2.0);
        assert!(odds.effects.is_empty(), "{odds:?}");
    }

    #[test]
    fn forms_share_the_odds_of_their_effect() {
        let one = round(4.0, vec![tried("aeration", "a", 1.2), tried("free_play", "", 1.2)]).odds(2.0);
        assert!((one.effects["aeration"] - one.effects["free_play"]).abs() < 1e-12);
        let many = ["b", "c", "d"].map(|form| tried("aeration", form, 3.9));
        let mut list = vec![tried("aeration", "a", 1.2), tried("free_play", "", 1.2)];
        list.extend(many);
        let two = round(4.0, list);
        // Forms that were tried in vain cost the effect; two good ones gain it nothing.
        let odds = two.odds(2.0);
        assert!(odds.effects["aeration"] < 0.5 * odds.effects["free_play"], "{odds:?}");
        assert_eq!(two.named().len(), 2);
        assert_eq!(two.promising().len(), 3);
        let same =
            round(4.0, vec![tried("aeration", "a", 1.2), tried("aeration", "b", 1.2), tried("free_play", "", 1.2)]);
        let odds = same.odds(2.0);
        assert!((odds.effects["aeration"] - odds.effects["free_play"]).abs() < 1e-9, "{odds:?}");
    }

    #[test]
    fn after_a_name_another_is_less_likely_beforehand() {
        let first = round(1.6, vec![tried("aeration", "", 1.1)]);
        let later = Round { is_later: true, named_so_far: 4.0, ..round(1.6, vec![tried("aeration", "", 1.1)]) };
        assert!(later.odds(2.0).nothing > first.odds(2.0).nothing);
    }
}
