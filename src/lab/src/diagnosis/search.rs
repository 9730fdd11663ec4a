//! Adding effects one after the other: screen, refit, judge, add, look again, and try to take each out again.

use super::evidence::{Evidence, effective_count, noise_chi2, noise_chi2_deviation, share_beyond_form};
use super::far_fetched::plausibility;
use super::finer_curve::with_enough_points;
use super::hypothesis::{Free, Hypothesis};
use super::pair::two_at_once;
use super::refit::{Effort, Refit, refit};
use super::round::{Ground, Round, Tried, look};
use super::samples::Test;
use super::tie::look_ahead;
use super::unbent::unbent;
use super::vocabulary::Candidate;
use crate::identification::unknowns::Unknown;
use crate::records::Record;
use dashpot_core::parameter::find;

/// Mean excess per independent sample, in σ², below which nothing is missing that matters.
pub const QUIET: f64 = 0.1;
/// Standard deviations of the noise floor beyond that.
const SURE: f64 = 2.0;
/// Shares of the remaining excess (larger for those that fit a little of everything) and of the original one that a later
/// effect must explain: what is left after a right name is often only the form of that effect, which another name would
/// soak up.
const LATER_REMAINING: f64 = 0.25;
const LATER_SPONGE: f64 = 0.5;
const LATER_ORIGINAL: f64 = 0.03;
/// Share of the original excess that something without a name must explain beside a single name to put it in doubt, counted
/// by how much of what the name explained it explained alone; and shares of what the name left and of that.
const BESIDE: f64 = 0.045;
const BESIDE_LEFT: f64 = 0.3;
const ALONE: f64 = 0.4;
/// The same share from which the two are one to these records.
const AS_MUCH: f64 = 0.85;
/// Share of the excess that the name leaves, counted the same way, from which what has no name may be what it stands for: two
/// that explain nearly as much, and neither of them all.
const INSTEAD: f64 = 0.075;
/// Most independent samples a χ² difference may lose for an effect to be taken out again.
const REMOVABLE: f64 = 6.0;

/// An effect in the explanation.
#[derive(Clone)]
pub struct Added {
    /// Which.
    pub candidate: Candidate,
    /// Evidence when it was added.
    pub evidence: Evidence,
    /// Confidence when it was added.
    pub confidence: f64,
    /// Places of its numbers.
    pub numbers: std::ops::Range<usize>,
}

/// The whole search.
pub struct Search {
    /// The base explanation and its refit.
    pub base: (Hypothesis, Refit),
    /// The last explanation and its refit.
    pub last: (Hypothesis, Refit),
    /// What it has added.
    pub added: Vec<Added>,
    /// Fall of χ² by further points on the FV curve once effects had been added: what was left was the curve's form.
    pub by_points: f64,
    /// All rounds; the last one added nothing.
    pub rounds: Vec<Round>,
    /// Expected χ² of noise.
    pub floor: f64,
    /// Mean excess per independent sample, in σ², below which nothing is missing that matters.
    pub quiet: f64,
    /// Names that were taken back in the end, since together they explain too little.
    pub taken_back: Vec<&'static str>,
}

/// What a search may do.
pub struct Limits<'a> {
    /// Most effects.
    pub effects: usize,
    /// Whether an effect may be tried.
    pub allowed: &'a (dyn Fn(&str) -> bool + Sync),
}

/// What is looked at, from a base explanation that is refitted.
fn ground<'a>(
    base: &Refit,
    floor: f64,
    records: &'a [&'a Record],
    tests: &'a [Test],
    limits: &Limits<'a>,
) -> Ground<'a> {
    Ground { records, tests, floor, original: base.chi2 - floor, allowed: limits.allowed }
}

/// Runs the search from a base explanation.
pub fn search(
    base: Hypothesis,
    records: &[&Record],
    tests: &[Test],
    limits: &Limits,
    progress: &(dyn Fn(f64, &str) + Sync),
) -> Option<Search> {
    progress(0.05, "refitting the model as it is");
    let start = base.start();
    let first = refit(&base, tests, &start, None, Effort::FINE)?;
    let base = base.starting_at(&first.theta);
    let floor = noise_chi2(tests);
    let quiet = QUIET + SURE * noise_chi2_deviation(tests) / effective_count(tests);
    let (base, first) = with_enough_points((base, first), tests, floor);
    let ground = ground(&first, floor, records, tests, limits);
    let mut found = Search {
        base: (base.clone(), first.clone()),
        last: (base, first),
        added: Vec::new(),
        by_points: 0.0,
        rounds: Vec::new(),
        floor,
        quiet,
        taken_back: Vec::new(),
    };
    loop {
        if !found.added.is_empty() {
            found.refine_curve(tests);
        }
        let left = (found.last.1.chi2 - floor) / effective_count(tests);
        let little = LATER_ORIGINAL * ground.original / effective_count(tests);
        if !found.added.is_empty() && (left < quiet || left < little) {
            break;
        }
        let done = 0.1 + 0.8 * found.added.len() as f64 / limits.effects.max(1) as f64;
        progress(done, "screening effects");
        let mut round = look(&ground, &found.last, &found.added, &|text| progress(done + 0.1, text))?;
        let may_lead_on = found.added.len() + 1 < limits.effects && left >= quiet;
        let ahead = may_lead_on.then(|| look_ahead(&mut round, &ground, &found.last, &found.added)).flatten();
        found.rounds.push(round);
        let round = &found.rounds[found.rounds.len() - 1];
        if found.added.len() >= limits.effects {
            break;
        }
        let convinces = |best: &&Tried| best.convinces() && (left >= quiet || best.evidence.is_sure());
        if let Some(best) = round.tried.first().filter(convinces) {
            if !found.added.is_empty() && !is_worth_a_later_name(best, round.before - floor) {
                break;
            }
            (found.last, found.added) = ahead.or_else(|| with(best, &found.last.0, &found.added, tests))?;
            // The one just added is needed.
            let old = found.added.len() - 1;
            take_out_what_is_not_needed(&mut found.last, &mut found.added, old, tests);
            continue;
        }
        if left < quiet || found.added.len() + 2 > limits.effects {
            break;
        }
        progress(done + 0.15, "looking for two effects at once");
        let Some(pair) = two_at_once(&ground, &found.last, &found.added, round) else { break };
        (found.last, found.added) = (pair.last, pair.added);
        found.rounds.extend(pair.rounds);
        let both = found.added.len();
        take_out_what_is_not_needed(&mut found.last, &mut found.added, both, tests);
    }
    Some(found)
}

/// Whether a later effect explains enough of what was left, and of what there was to begin with.
pub fn is_worth_a_later_name(best: &Tried, left: f64) -> bool {
    let remaining = if best.evidence.sponge { LATER_SPONGE } else { LATER_REMAINING };
    best.evidence.chi2_fall >= remaining * left && best.evidence.of_all >= LATER_ORIGINAL
}

/// An explanation with what was added to it.
pub type Explained = ((Hypothesis, Refit), Vec<Added>);

/// The explanation that an effect was tried in, refitted to the end, with the effect among the added.
pub fn with(best: &Tried, from: &Hypothesis, added: &[Added], tests: &[Test]) -> Option<Explained> {
    let fine = refit(&best.hypothesis, tests, &best.refit.theta, Some(best.refit.jacobian.clone()), Effort::FINE)?;
    let fine = unbent(&best.hypothesis, tests, fine);
    let mut added = added.to_vec();
    added.push(Added {
        candidate: best.candidate.clone(),
        evidence: best.evidence,
        confidence: best.confidence,
        numbers: from.numbers.len()..best.hypothesis.numbers.len(),
    });
    Some(((best.hypothesis.clone().starting_at(&fine.theta), fine), added))
}

impl Search {
    /// More points on the FV curve where what is left is of its form.
    fn refine_curve(&mut self, tests: &[Test]) {
        let (numbers, chi2) = (self.last.0.numbers.len(), self.last.1.chi2);
        self.last = with_enough_points(self.last.clone(), tests, self.floor);
        let more = self.last.0.numbers.len() - numbers;
        self.by_points += chi2 - self.last.1.chi2;
        for added in &mut self.added {
            added.numbers = added.numbers.start + more..added.numbers.end + more;
        }
    }

    /// Share of the excess, beyond what the form of right names leaves, that all names together explain.
    pub fn together(&self, tests: &[Test]) -> f64 {
        let per = 1.0 / effective_count(tests);
        share_beyond_form(
            per * (self.base.1.chi2 - self.by_points - self.last.1.chi2),
            per * (self.base.1.chi2 - self.floor),
        )
    }

    /// Whether something without a name may be what a single name stands for: at first it explained nearly as much; or nearly
    /// half as much or more, and it explains more than any effect of what the name left, or the name leaves much.
    pub fn may_have_no_name(&self, tests: &[Test]) -> bool {
        // Beside several names it is one more part of what is missing.
        let ([first, later @ ..], [named]) = (&self.rounds[..], &self.added[..]) else { return false };
        let left = later.last().and_then(|round| round.tried.first());
        let unexplained = 1.0 - self.together(tests);
        first.tried.iter().filter(|t| t.candidate.unnamed.is_some()).any(|nameless| {
            let alone = nameless.evidence.share / named.evidence.share;
            let beside = left
                .filter(|left| left.candidate.effect == nameless.candidate.effect)
                .is_some_and(|left| left.evidence.of_all * alone >= BESIDE && left.evidence.share >= BESIDE_LEFT);
            alone >= AS_MUCH || alone >= ALONE && (beside || unexplained * alone >= INSTEAD)
        })
    }

    /// Whether a single effect has, refitted to the end, a number that tells that it is another.
    pub fn ended_contrary(&self) -> bool {
        let ([only], (last, end)) = (&self.added[..], &self.last) else { return false };
        plausibility(&only.candidate, only.numbers.start, last, end).contrary
    }

    /// Whether a single effect that does not stand does so in another form, which then takes its place.
    pub fn stands_in_another_form(&mut self, tests: &[Test], stands: &dyn Fn(&Search) -> bool) -> bool {
        let [only] = &self.added[..] else { return false };
        let others: Vec<Tried> = self.rounds[0]
            .other_forms
            .iter()
            .filter(|t| t.candidate.effect == only.candidate.effect && t.evidence.is_admissible())
            .map(|t| Tried { confidence: only.confidence, ..t.clone() })
            .collect();
        others.iter().any(|other| {
            with(other, &self.base.0, &[], tests).is_some_and(|explained| self.stands_instead(explained, tests, stands))
        })
    }

    /// Whether other names stand, which then take the place of those there are.
    fn stands_instead(&mut self, explained: Explained, tests: &[Test], stands: &dyn Fn(&Search) -> bool) -> bool {
        let before = (self.last.clone(), self.added.clone(), self.by_points);
        (self.last, self.added) = explained;
        self.by_points = 0.0;
        self.refine_curve(tests);
        let do_stand = stands(self);
        if !do_stand {
            (self.last, self.added, self.by_points) = before;
        }
        do_stand
    }

    /// Place of the look in which an effect was found.
    pub fn found_in(&self, effect: &str) -> Option<usize> {
        self.rounds.iter().position(|r| r.tried.first().is_some_and(|t| t.candidate.effect == effect))
    }

    /// Takes the last of several names back, with the look at what it left; false where there is one name or none.
    pub fn without_the_last_name(&mut self, tests: &[Test]) -> bool {
        let last = self.added.len().saturating_sub(1);
        if last == 0 {
            return false;
        }
        let Some(explained) = leave(&self.last, &self.added, last, tests) else { return false };
        let gone = self.added[last].candidate.effect;
        (self.last, self.added) = explained;
        // The look in which it was found is then the last.
        if let Some(place) = self.found_in(gone) {
            self.rounds.truncate(place + 1);
        }
        true
    }

    /// Whether, where a single name does not stand, two at once do, which then take its place.
    pub fn stands_as_two(
        &mut self,
        records: &[&Record],
        tests: &[Test],
        limits: &Limits,
        stands: &dyn Fn(&Search) -> bool,
    ) -> bool {
        if self.added.len() != 1 || limits.effects < 2 {
            return false;
        }
        let ground = ground(&self.base.1, self.floor, records, tests, limits);
        let Some(pair) = two_at_once(&ground, &self.base, &[], &self.rounds[0]) else { return false };
        let do_stand = self.stands_instead((pair.last, pair.added), tests, stands);
        if do_stand {
            self.rounds.truncate(1);
            self.rounds.extend(pair.rounds);
        }
        do_stand
    }

    /// Takes all names back.
    pub fn take_back(&mut self) {
        self.taken_back = self.added.drain(..).map(|a| a.candidate.effect).collect();
        self.last = self.base.clone();
    }
}

/// A number in the unit that people use.
pub fn physical(free: &Free, value: f64) -> f64 {
    match free {
        Free::Model(Unknown::Log(_)) | Free::Cooling | Free::HeatCapacity => value.exp(),
        _ => value,
    }
}

/// Takes those of the first effects out that others have made superfluous.
fn take_out_what_is_not_needed(
    last: &mut (Hypothesis, Refit),
    added: &mut Vec<Added>,
    mut first: usize,
    tests: &[Test],
) {
    let mut place = 0;
    while place < first && added.len() > 1 {
        let numbers = added[place].candidate.fresh.len() as f64;
        match leave(last, added, place, tests) {
            Some((less, rest)) if less.1.cost - last.1.cost < REMOVABLE * numbers => {
                (*last, *added) = (less, rest);
                first -= 1;
            }
            _ => place += 1,
        }
    }
}

/// Everything refitted with one of the effects left out.
pub fn leave(last: &(Hypothesis, Refit), added: &[Added], place: usize, tests: &[Test]) -> Option<Explained> {
    let less = without(&last.0, &last.1.theta, &added[place]);
    let refitted = refit(&less, tests, &less.start(), None, Effort::JUDGE)?;
    let mut rest = added.to_vec();
    let gone = rest.remove(place);
    for other in &mut rest {
        if other.numbers.start >= gone.numbers.end {
            let length = gone.numbers.len();
            other.numbers = other.numbers.start - length..other.numbers.end - length;
        }
    }
    Some(((less.starting_at(&refitted.theta), refitted), rest))
}

/// An explanation without one of its effects.
pub fn without(from: &Hypothesis, theta: &[f64], added: &Added) -> Hypothesis {
    let mut to = from.clone().starting_at(theta);
    for element in added.candidate.elements {
        let _ = to.base.enable(element, false);
    }
    // What it fixed elsewhere was for it alone.
    for row in added.candidate.fixed.iter().filter_map(|(name, _)| find(name)) {
        if let [usual] = row.parameter.default {
            let _ = to.base.set(row.parameter.name, *usual);
        }
    }
    to.numbers.drain(added.numbers.clone());
    to
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnosis::extend::extend;
    use crate::diagnosis::situation::Situation;
    use crate::diagnosis::vocabulary::{base_numbers, candidates};
    use dashpot_core::elements::GROUPS;
    use dashpot_core::parameter::{Shape, table};
    use dashpot_core::{Model, Params};

    #[test]
    fn an_effect_that_is_taken_out_leaves_the_damper_as_it_was() {
        let mut params = Params::new();
        params.enable("stribeck_friction", false).unwrap();
        params.enable("coulomb_friction", true).unwrap();
        let base = Hypothesis { base: params, numbers: base_numbers(&params), heating: None };
        let theta = base.start();
        let all = candidates(&Situation::new(&params, &[], &[]));
        assert!(all.iter().any(|c| c.fixed.contains(&("series_load", 1.0))));
        for candidate in all {
            let to = extend(&base, &theta, &candidate, &candidate.starts[0]);
            assert!(Model::new(&to.base).is_ok(), "{} {}", candidate.effect, candidate.form);
            let evidence = Evidence::default();
            let numbers = base.numbers.len()..to.numbers.len();
            let added = Added { candidate: candidate.clone(), evidence, confidence: 1.0, numbers };
            let back = without(&to, &to.start(), &added);
            assert_eq!(back.numbers.len(), base.numbers.len());
            for row in table() {
                let (name, group) = (row.parameter.name, GROUPS[row.group].name);
                assert_eq!(back.base.is_on(group), params.is_on(group), "{group} after {}", candidate.effect);
                if params.is_on(group) && !matches!(row.parameter.shape, Shape::List(_)) {
                    assert_eq!(back.base.scalar(name), params.scalar(name), "{name} after {}", candidate.effect);
                }
            }
        }
    }
}
