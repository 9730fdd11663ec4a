//! The search for what is missing: the likeliest effect is added where it is likely enough, then the next beside it; pairs that hide each
//! other are tried beside that; each name is weighed once more with all the others in.

use super::calibration::before_limit;
use super::decisions::{NAMED, NOTHING_MORE, SURE, SUSPECTED, WITH_NAME, WITHOUT_NAME};
use super::evidence::{Weighed, noise_chi2};
use super::finer_curve::with_enough_points;
use super::phrases;
use super::round::{Ground, Round, Tried, look};
use super::unbent::{is_bent, unbent};
use super::vocabulary::Candidate;
use dashpot_estimation::hypothesis::{Free, Hypothesis};
use dashpot_estimation::implausibility::implausibility;
use dashpot_estimation::refit::{Effort, Refit, refit};
use dashpot_estimation::samples::Test;
use dashpot_estimation::unknowns::Unknown;
use dashpot_records::Record;
use dashpot_records::sentence::Template;
use std::collections::BTreeSet;

/// Effects of the first look of which each is tried as one of two.
const PAIRED: usize = 4;

/// An effect in the explanation.
#[derive(Clone)]
pub struct Added {
    /// Which.
    pub candidate: Candidate,
    /// Places of its numbers.
    pub numbers: std::ops::Range<usize>,
    /// The look that weighs it against everything else, all other names given: its place among the looks.
    pub look: usize,
}

/// An explanation with what was added to it.
#[derive(Clone)]
pub struct Explained {
    /// The explanation and its refit.
    pub last: (Hypothesis, Refit),
    /// What was added.
    pub added: Vec<Added>,
    /// Price of the values of the base explanation that dampers do not show.
    strangeness: f64,
}

/// The whole search.
pub struct Search {
    /// The base explanation and its refit.
    pub base: (Hypothesis, Refit),
    /// The last explanation.
    pub found: Explained,
    /// All looks, in the order in which they were taken.
    pub rounds: Vec<Round>,
    /// Place of the look at what the last explanation leaves; `None` where there was none any more.
    pub last_look: Option<usize>,
}

/// What a search may do.
pub struct Limits<'a> {
    /// Most effects.
    pub effects: usize,
    /// Whether an effect may be tried.
    pub allowed: &'a (dyn Fn(&str) -> bool + Sync),
}

impl Explained {
    fn nothing_added(base: &(Hypothesis, Refit)) -> Explained {
        let strangeness = implausibility(&base.0, &base.1.theta);
        Explained { last: base.clone(), added: Vec::new(), strangeness }
    }

    fn names(&self) -> Vec<&'static str> {
        self.added.iter().map(|a| a.candidate.effect).collect()
    }

    /// The names in alphabetical order.
    fn set(&self) -> Vec<&'static str> {
        let mut names = self.names();
        names.sort_unstable();
        names
    }

    /// What the explanation leaves, with all its names paid for.
    pub fn weighed(&self, tests: &[Test]) -> Weighed {
        let numbers = self.added.iter().map(|a| a.candidate.numbers()).sum();
        Weighed::new(&self.last.0, &self.last.1, tests, numbers, self.strangeness)
    }

    /// With one more effect, refitted to the end.
    fn with(&self, best: &Tried, tests: &[Test], look: usize) -> Option<Explained> {
        let fine = refit(&best.hypothesis, tests, &best.refit.theta, None, Effort::FINE)?;
        let fine =
            if is_bent(&best.hypothesis, tests, &fine.theta) { unbent(&best.hypothesis, tests, fine) } else { fine };
        let numbers = self.last.0.numbers.len()..best.hypothesis.numbers.len();
        let mut added = self.added.clone();
        added.push(Added { candidate: best.candidate.clone(), numbers, look });
        let last = (best.hypothesis.clone().starting_at(&fine.theta), fine);
        let mut explained = Explained { last, added, strangeness: self.strangeness };
        explained.refine_curve(tests);
        Some(explained)
    }

    /// More points on the FV curve where what is left is of its form.
    fn refine_curve(&mut self, tests: &[Test]) {
        let numbers = self.last.0.numbers.len();
        self.last = with_enough_points(self.last.clone(), tests, noise_chi2(tests));
        let more = self.last.0.numbers.len() - numbers;
        for added in &mut self.added {
            added.numbers = added.numbers.start + more..added.numbers.end + more;
        }
    }

    /// With one of the effects left out, everything refitted.
    pub fn leave(&self, place: usize, tests: &[Test]) -> Option<Explained> {
        let less = without(&self.last.0, &self.last.1.theta, &self.added[place]);
        let refitted = refit(&less, tests, &less.start(), None, Effort::JUDGE)?;
        let mut added = self.added.clone();
        let gone = added.remove(place);
        for other in &mut added {
            if other.numbers.start >= gone.numbers.end {
                let length = gone.numbers.len();
                other.numbers = other.numbers.start - length..other.numbers.end - length;
            }
        }
        let last = (less.starting_at(&refitted.theta), refitted);
        Some(Explained { last, added, strangeness: self.strangeness })
    }
}

/// The likeliest effect of a look where it is likely enough to be added.
fn likely(round: &Round) -> Option<&Tried> {
    // What is left beside a name is partly of that name's form, which is alike in all tests: whether anything more is missing is asked with
    // few independent samples, which of the names it is with as many as ever.
    let as_sure = round.odds(SURE).effects;
    if round.is_later && as_sure.values().sum::<f64>() < NAMED {
        return None;
    }
    let odds = round.odds(SUSPECTED);
    let (effect, suspected) = odds.effects.iter().filter(|(_, p)| **p >= NAMED).max_by(|a, b| a.1.total_cmp(b.1))?;
    // What hangs on each test counting twice is a suspect, not a name.
    let sure = as_sure.get(effect).copied().unwrap_or(0.0);
    if before_limit(*suspected, sure) < NAMED {
        return None;
    }
    round.tried.iter().find(|t| t.candidate.effect == *effect)
}

/// Runs the search from a base explanation.
pub fn search(
    base: Hypothesis,
    records: &[&Record],
    tests: &[Test],
    limits: &Limits,
    progress: &(dyn Fn(f64, Template) + Sync),
) -> Option<Search> {
    progress(0.05, phrases::REFITTING);
    let start = base.start();
    let first = refit(&base, tests, &start, None, Effort::FINE)?;
    let base = base.starting_at(&first.theta);
    let base = with_enough_points((base, first), tests, noise_chi2(tests));
    let leaves = Explained::nothing_added(&base).weighed(tests).mean();
    let ground = Ground { records, tests, allowed: limits.allowed, base: Some(leaves), forms: None };
    let mut search = Search { found: Explained::nothing_added(&base), base, rounds: Vec::new(), last_look: None };
    search.greedy(&ground, limits, progress)?;
    if limits.effects >= 2 && search.found.added.is_empty() && search.leaves_something() {
        progress(0.6, phrases::TWO_EFFECTS);
        search.pairs(&ground);
    }
    if search.found.added.len() >= 2 {
        progress(0.8, phrases::WEIGHING);
        search.weigh_each(&ground);
    }
    Some(search)
}

impl Search {
    fn look(&mut self, ground: &Ground, at: &Explained) -> Option<usize> {
        let round = look(ground, &at.last, &at.names())?;
        self.rounds.push(round);
        Some(self.rounds.len() - 1)
    }

    /// Adds the likeliest effect as long as one is likely enough and leads to names that were not held together before: what made the
    /// search leave those would make it leave them again, without end.
    fn greedy(&mut self, ground: &Ground, limits: &Limits, progress: &(dyn Fn(f64, Template) + Sync)) -> Option<()> {
        let mut held = BTreeSet::from([self.found.set()]);
        loop {
            progress(0.1 + 0.25 * self.found.added.len() as f64, phrases::EACH_EFFECT);
            let forms = self.rounds.first().map(Round::promising);
            let place = self.look(&Ground { forms: forms.as_ref(), ..*ground }, &self.found.clone())?;
            self.last_look = Some(place);
            if self.found.added.len() >= limits.effects {
                return Some(());
            }
            let Some(best) = likely(&self.rounds[place]) else { return Some(()) };
            let Some(next) = self.found.with(best, ground.tests, place) else { return Some(()) };
            let before = std::mem::replace(&mut self.found, next);
            self.drop_needless(ground.tests);
            if !held.insert(self.found.set()) {
                self.found = before;
                return Some(());
            }
        }
    }

    /// Whether the explanation leaves more than noise and the form of curves.
    fn leaves_something(&self) -> bool {
        self.last_look.is_none_or(|place| self.rounds[place].odds(SUSPECTED).nothing < NAMED)
    }

    /// Takes effects out that those after them have made needless: without them the evidence is no less.
    fn drop_needless(&mut self, tests: &[Test]) {
        let mut place = 0;
        while place + 1 < self.found.added.len() {
            let with = self.found.weighed(tests).log_evidence(SUSPECTED);
            match self.found.leave(place, tests) {
                Some(less) if less.weighed(tests).log_evidence(SUSPECTED) >= with => self.found = less,
                _ => place += 1,
            }
        }
    }

    /// Two effects that hide each other's share: each of the likeliest is put in, and the best of the others beside it; the pair that
    /// explains most takes the place of what was found where it is likelier by what a second name costs.
    fn pairs(&mut self, ground: &Ground) {
        let first: Vec<Tried> = self.rounds[0].named().into_iter().take(PAIRED).cloned().collect();
        let names: Vec<&str> = first.iter().map(|t| t.candidate.effect).collect();
        let among = |effect: &str| names.contains(&effect) && (ground.allowed)(effect);
        let forms = self.rounds[0].promising();
        let ground_of_pairs = Ground { allowed: &among, forms: Some(&forms), ..*ground };
        let base = Explained::nothing_added(&self.base);
        let choice = self.rounds[0].choice.max(1) as f64;
        let (first_name, second_name) =
            (libm::log(WITH_NAME / choice), libm::log((1.0 - NOTHING_MORE - WITHOUT_NAME) / choice));
        let mut best: Option<(f64, Explained)> = None;
        for one in &first {
            let Some(with_one) = base.with(one, ground.tests, 0) else { continue };
            let Some(round) = look(&ground_of_pairs, &with_one.last, &with_one.names()) else { continue };
            let Some(second) = round.named().first().copied().cloned() else { continue };
            let Some(both) = with_one.with(&second, ground.tests, 0) else { continue };
            let log = both.weighed(ground.tests).log_evidence(SUSPECTED);
            if best.as_ref().is_none_or(|(most, _)| log > *most) {
                best = Some((log, both));
            }
        }
        let Some((log, both)) = best else { return };
        let round = &self.rounds[0];
        let single = round.named().first().map_or(f64::NEG_INFINITY, |t| t.weighed.log_evidence(SUSPECTED));
        let nameless = round.before.log_evidence(SUSPECTED) + libm::log(WITHOUT_NAME);
        if log + first_name + second_name > nameless.max(single + first_name) {
            self.found = both;
            self.last_look = None;
        }
    }

    /// Weighs each of several names against everything else with all the others in: one that is not the likeliest there gives way to what
    /// is, or goes.
    fn weigh_each(&mut self, ground: &Ground) {
        let mut place = 0;
        // Whoever was likely in any look, and what is in already.
        let mut names: Vec<&str> = self.found.names();
        for round in &self.rounds {
            names.extend(round.named().iter().take(PAIRED).map(|t| t.candidate.effect));
        }
        let forms = self.rounds[0].promising();
        let among = |effect: &str| names.contains(&effect) && (ground.allowed)(effect);
        let ground = &Ground { allowed: &among, forms: Some(&forms), ..*ground };
        let mut held = BTreeSet::from([self.found.set()]);
        while place < self.found.added.len() && self.found.added.len() >= 2 {
            let Some(less) = self.found.leave(place, ground.tests) else { break };
            let Some(look) = self.look(ground, &less) else { break };
            let effect = self.found.added[place].candidate.effect;
            let best = likely(&self.rounds[look]).cloned();
            match best {
                Some(best) if best.candidate.effect == effect => {
                    self.found.added[place].look = look;
                    place += 1;
                }
                Some(best) => match less.with(&best, ground.tests, look) {
                    // Names that were held together before would only give way again: which of the two it is stays open.
                    Some(other) if !held.insert(other.set()) => {
                        self.found = less;
                        self.last_look = Some(look);
                    }
                    Some(other) => {
                        self.found = other;
                        self.last_look = None;
                        // It stands last now and was weighed here.
                        if place + 1 == self.found.added.len() {
                            place += 1;
                        }
                    }
                    None => break,
                },
                None => {
                    // Without it nothing is likely enough: its look is what is left.
                    self.found = less;
                    self.last_look = Some(look);
                }
            }
        }
        let [only] = &mut self.found.added[..] else { return };
        // Alone again, it is what the first look says of it.
        only.look = 0;
        let effect = only.candidate.effect;
        if likely(&self.rounds[0]).is_none_or(|best| best.candidate.effect != effect) {
            self.found = Explained::nothing_added(&self.base);
            self.last_look = Some(0);
        }
    }

    /// Probability of a name against everything else, each test counted as `samples` independent ones.
    pub fn probability(&self, added: &Added, samples: f64) -> f64 {
        self.rounds[added.look].odds(samples).effects.get(added.candidate.effect).copied().unwrap_or(0.0)
    }
}

/// A number in the unit that people use.
pub fn physical(free: &Free, value: f64) -> f64 {
    match free {
        Free::Model(Unknown::Log(_)) | Free::Cooling | Free::HeatCapacity => libm::exp(value),
        _ => value,
    }
}

/// An explanation without one of its effects.
pub fn without(from: &Hypothesis, theta: &[f64], added: &Added) -> Hypothesis {
    let mut to = from.clone().starting_at(theta);
    for element in added.candidate.elements {
        to.base.enable(*element, false);
    }
    // What it fixed elsewhere was for it alone.
    for (number, _) in &added.candidate.fixed {
        let _ = to.base.set(*number, number.default());
    }
    to.numbers.drain(added.numbers.clone());
    to
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::extend::extend;
    use crate::situation::Situation;
    use crate::vocabulary::{base_numbers, candidates};
    use dashpot_core::parameter::{Shape, table};
    use dashpot_core::{Model, Params};
    use dashpot_core::{element, number};

    #[test]
    fn a_name_is_looked_for_only_where_something_is_missing_for_sure() {
        use crate::round::tests::{round, tried};
        let of = |before: f64, after: f64| {
            let look = round(before, vec![tried("aeration", "", after), tried("bushing", "", before)]);
            likely(&look).map(|t| t.candidate.effect)
        };
        assert_eq!(of(9.0, 1.1), Some("aeration"));
        // Little is missing, and little is gained.
        assert_eq!(of(1.2, 1.1), None);
        // Something is missing that the effect does not explain.
        assert_eq!(of(9.0, 8.0), None);
    }

    #[test]
    fn an_effect_that_is_taken_out_leaves_the_damper_as_it_was() {
        let mut params = Params::new();
        params.enable(element!("stribeck_friction"), false);
        params.enable(element!("coulomb_friction"), true);
        let base = Hypothesis { base: params, numbers: base_numbers(&params), heating: None };
        let theta = base.start();
        let all = candidates(&Situation::new(&params, &[], &[]));
        assert!(all.iter().any(|c| c.fixed.contains(&(number!("series_load"), 1.0))));
        for candidate in all {
            let to = extend(&base, &theta, &candidate, &candidate.starts[0]);
            assert!(Model::new(&to.base).is_ok(), "{} {}", candidate.effect, candidate.form);
            let numbers = base.numbers.len()..to.numbers.len();
            let added = Added { candidate: candidate.clone(), numbers, look: 0 };
            let back = without(&to, &to.start(), &added);
            assert_eq!(back.numbers.len(), base.numbers.len());
            for row in table() {
                let (name, Some(element)) = (row.parameter.name, row.element()) else { continue };
                assert_eq!(back.base.is_on(element), params.is_on(element), "{element} after {}", candidate.effect);
                if params.is_on(element) && !matches!(row.parameter.shape, Shape::List(_)) {
                    assert_eq!(back.base.get(&row), params.get(&row), "{name} after {}", candidate.effect);
                }
            }
        }
    }
}
