//! Verdict of a diagnosis: what the most probable structure says about the given model.

use super::changes::Change;
use super::decisions::{MISSED, NAMED, QUIET, UNEXPLAINED};
use super::detection_limit;
use super::outcome::{Rival, Verdict};
use super::phrases;
use super::rivals::{LISTED, explained};
use super::wording::percent;
use dashpot_estimation::samples::Test;
use dashpot_estimation::structure::component::Component;
use dashpot_estimation::structure::context::Structure;
use dashpot_estimation::structure::inventory::{InventoryItem, Status};
use dashpot_estimation::structure::search::StructureSearch;
use dashpot_estimation::vocabulary::Unnamed;
use dashpot_messages::{Sentence, Template};
use std::collections::BTreeSet;

/// Gain of the log posterior over the best structure above which the summary describes the residual as an unnamed
/// error. Unnamed errors are tilted guides, load cell hysteresis and a resonance. The threshold represents the prior
/// odds of such an error.
const UNNAMED: f64 = 1.0;

/// Smallest ratio of what a suspect explains to what the first one explains at which the two count as rivals.
///
/// The summary says that the records do not tell rivals apart. Other suspects are listed with the part that they explain.
const COMPARABLE: f64 = 0.25;

/// Largest number of changes that the summary lists.
const TOLD: usize = 3;

/// Verdict of a diagnosis with its summary, suspects and notes.
pub(super) struct Judged {
    pub verdict: Verdict,
    pub summary: Sentence,
    pub suspects: Vec<Rival>,
    pub notes: Vec<Sentence>,
}

/// Structures, names and changes from which the verdict follows.
pub(super) struct VerdictContext<'a> {
    /// The given model, refitted.
    pub start: &'a Structure,
    /// The most probable structure, refitted.
    pub best: &'a Structure,
    pub search: &'a StructureSearch,
    pub fitted: &'a [Test],
    /// Whether the diagnosis compares with a reference.
    pub is_against: bool,
    /// Effects to which the user limited the search. `None` means all effects.
    pub asked: Option<&'a [String]>,
    /// Effects to name, most probable first.
    pub names: &'a [&'a Component],
    /// Changes whose force is large enough to name them.
    pub changed: &'a [&'a Change],
    /// Whether there are changes with a smaller force.
    pub has_small_changes: bool,
    pub items: &'a [InventoryItem],
    pub suspects: Vec<Rival>,
    pub probability: &'a dyn Fn(&str) -> f64,
}

/// Formats a root mean square residual as a multiple of the noise.
fn times(mean_square: f64) -> Sentence {
    Sentence::from(phrases::TIMES).with("times", format!("{:.2}", mean_square.sqrt()))
}

/// Summarizes that no effect is missing. `mean_square` is the residual of the best structure over the noise, and
/// `likeliest` the most probable effect outside of it.
///
/// The sentence has no probability of its own, because no known effect explains the residual above 1. It states the
/// unexplained fraction instead, and the probability of the likeliest effect.
fn summarize_nothing_missing(
    is_against: bool,
    asked: Option<&[String]>,
    mean_square: f64,
    likeliest: Option<&Rival>,
) -> Sentence {
    let nothing = match (is_against, asked) {
        (false, None) => phrases::NOTHING_MISSING.into(),
        (true, None) => phrases::UNCHANGED.into(),
        (false, Some(asked)) => Sentence::from(phrases::NONE_OF_ASKED).with_names("effects", asked, phrases::COMMA),
        (true, Some(asked)) => Sentence::from(phrases::UNCHANGED_OF_ASKED).with_names("effects", asked, phrases::COMMA),
    };
    let unexplained = 1.0 - 1.0 / mean_square;
    let rest = (unexplained > UNEXPLAINED)
        .then(|| Sentence::from(phrases::WITHOUT_CAUSE).with("percent", percent(unexplained)));
    let likeliest = likeliest
        .map(|of| Sentence::from(phrases::LIKELIEST).with("effect", of.effect).with("percent", percent(of.confidence)));
    nothing.with_sentence("times", times(mean_square)).with_any("rest", rest).with_any("likeliest", likeliest)
}

impl VerdictContext<'_> {
    /// Returns the verdict with its summary.
    pub fn judge(self) -> Judged {
        if !self.names.is_empty() {
            return self.judge_names();
        }
        if !self.changed.is_empty() {
            return self.judge_changes();
        }
        let is_gone = |i: &&InventoryItem| matches!(i.status, Status::Removed | Status::Replaced);
        let gone: Vec<&InventoryItem> = self.items.iter().filter(is_gone).collect();
        let unnamed = self.search.unnamed.iter().max_by(|a, b| a.1.total_cmp(&b.1));
        let looks_like =
            unnamed.filter(|(_, log)| *log > self.search.best.log_posterior + UNNAMED).map(|(like, _)| *like);
        let is_quiet = self.after().sqrt() <= QUIET;
        if is_quiet && self.suspects.iter().all(|r| r.confidence < 0.5 * NAMED) && gone.is_empty() {
            return self.judge_nothing_missing();
        }
        let open: f64 = self.suspects.iter().map(|r| r.confidence).sum();
        if open >= NAMED && looks_like.is_none() {
            return self.judge_ambiguous();
        }
        if !gone.is_empty() && is_quiet {
            let names = gone.iter().map(|i| i.effect);
            let summary = Sentence::from(phrases::NEEDLESS).with_names("effects", names, phrases::COMMA);
            return Judged { verdict: Verdict::NothingMissing, summary, suspects: self.suspects, notes: Vec::new() };
        }
        self.judge_unknown(looks_like)
    }

    /// Returns the mean square residual of the given model over the noise.
    fn before(&self) -> f64 {
        self.start.evidence.mean()
    }

    /// Returns the mean square residual of the best structure over the noise.
    fn after(&self) -> f64 {
        self.best.evidence.mean()
    }

    /// Returns the verdict that names effects.
    fn judge_names(self) -> Judged {
        let (before, after) = (self.before(), self.after());
        let mut notes = Vec::new();
        let left = 1.0 - explained(before, after);
        if left > UNEXPLAINED && after.sqrt() > QUIET {
            notes.push(Sentence::from(phrases::NOT_EXPLAINED).with("percent", percent(left.min(1.0))));
        }
        let names = self.names.iter().map(|c| self.describe_name(c.effect)).collect();
        let also: Vec<Sentence> = self.changed.iter().take(TOLD).map(|c| c.sentence()).collect();
        let also = (!also.is_empty())
            .then(|| Sentence::from(phrases::ALSO_CHANGED).with_list("changes", also, phrases::COMMA));
        // The mean over tests may be at the level of the noise although the model misses one test clearly.
        let missed = self.missed_tests();
        let is_complete = after.sqrt() <= QUIET && missed.is_none();
        notes.extend(missed);
        let rest = if is_complete { phrases::LEAVES_NOTHING } else { phrases::LEAVES_A_PART };
        let is_smaller = after < before;
        let [before, after] = [before, after].map(|mean_square| format!("{:.2}", mean_square.sqrt()));
        // The most probable structure may have fewer or other parameters, so its residual is not always smaller.
        let falls = is_smaller && before != after;
        let residual = Sentence::from(if falls { phrases::RESIDUAL_FALLS } else { phrases::RESIDUAL_STAYS })
            .with("before", before)
            .with("after", after);
        let summary = Sentence::from(if self.is_against { phrases::NEW_EFFECT } else { phrases::HAS_EFFECT })
            .with_list("names", names, phrases::COMMA)
            .with_sentence("residual", residual)
            .with_sentence("rest", Sentence::from(rest))
            .with_any("also", also);
        Judged { verdict: Verdict::Named, summary, suspects: self.suspects, notes }
    }

    /// Formats the name of an effect with its probability and with the effect that it replaces.
    fn describe_name(&self, effect: &'static str) -> Sentence {
        let replaces = self.items.iter().find(|i| i.effect == effect).and_then(|i| i.replaces);
        let instead = replaces.map(|old| Sentence::from(phrases::INSTEAD_OF).with("effect", old));
        Sentence::from(phrases::NAME_AND_SURE)
            .with("effect", effect)
            .with("percent", percent((self.probability)(effect)))
            .with_any("instead", instead)
    }

    /// Returns the verdict that the numbers of the given model changed.
    fn judge_changes(self) -> Judged {
        let changes: Vec<Sentence> = self.changed.iter().take(TOLD).map(|c| c.sentence()).collect();
        let more = self.changed.len().saturating_sub(TOLD);
        let more = (more > 0).then(|| Sentence::from(phrases::MORE_NUMBERS).with("count", more));
        // A residual above `QUIET` is mainly form error of the model, which may conceal further changes. The summary
        // then states that more may have changed.
        let rest = if self.after().sqrt() <= QUIET {
            if self.has_small_changes { phrases::NOTHING_ELSE_LARGE } else { phrases::NOTHING_ELSE }.into()
        } else {
            Sentence::from(phrases::MORE_MAY_HAVE_CHANGED).with_sentence("times", times(self.after()))
        };
        let summary = Sentence::from(phrases::CHANGED)
            .with_list("numbers", changes, phrases::COMMA)
            .with_sentence("more", more.unwrap_or(rest));
        Judged { verdict: Verdict::Changed, summary, suspects: self.suspects, notes: Vec::new() }
    }

    /// Returns the verdict that the records show no missing effect.
    fn judge_nothing_missing(self) -> Judged {
        let limit = detection_limit::note(self.fitted, &self.best.evidence.mean_squares);
        let notes = self.missed_tests().into_iter().chain(limit).collect();
        let summary = summarize_nothing_missing(self.is_against, self.asked, self.after(), self.suspects.first());
        Judged { verdict: Verdict::NothingMissing, summary, suspects: Vec::new(), notes }
    }

    /// Returns the verdict that the records do not distinguish the suspects.
    fn judge_ambiguous(self) -> Judged {
        // A suspect that explains little of what another one explains does not replace it.
        let most = self.suspects.iter().map(|suspect| suspect.fraction).fold(0.0, f64::max);
        let is_rival = |suspect: &&Rival| suspect.fraction >= COMPARABLE * most;
        let effects: Vec<&str> = self.suspects.iter().filter(is_rival).map(|s| s.effect).collect();
        let why = match effects[..] {
            [one] => Sentence::from(phrases::TOO_FEW_TESTS).with("effect", one),
            _ => Sentence::from(phrases::NOT_APART).with_names("effects", effects, phrases::AND),
        };
        let times = times(self.before());
        let summary = Sentence::from(phrases::CANNOT_TELL).with_sentence("times", times).with_sentence("why", why);
        Judged { verdict: Verdict::Ambiguous, summary, suspects: self.suspects, notes: Vec::new() }
    }

    /// Returns the verdict that an unknown effect is missing, with the unnamed error that it looks like, if any.
    fn judge_unknown(self, looks_like: Option<Unnamed>) -> Judged {
        let nearest = match (looks_like, self.suspects.first()) {
            (Some(unnamed), _) => Some(Sentence::from(phrases::LOOKS_LIKE).with_sentence("what", looks(unnamed))),
            (None, Some(first)) => Some(
                Sentence::from(phrases::NEAREST).with("effect", first.effect).with("percent", percent(first.fraction)),
            ),
            (None, None) => None,
        };
        let times = times(self.before());
        let summary =
            Sentence::from(phrases::UNKNOWN_EFFECT).with_sentence("times", times).with_any("nearest", nearest);
        Judged { verdict: Verdict::UnknownEffect, summary, suspects: self.suspects, notes: Vec::new() }
    }

    /// Names the tests in which the residual of the best structure exceeds [`MISSED`]. Returns `None` if there is none.
    fn missed_tests(&self) -> Option<Sentence> {
        let mut loud: Vec<(&Test, f64)> = self
            .fitted
            .iter()
            .zip(&self.best.evidence.mean_squares)
            .filter(|(_, square)| **square > MISSED * MISSED)
            .map(|(test, square)| (test, square.sqrt()))
            .collect();
        loud.sort_by(|a, b| b.1.total_cmp(&a.1));
        // A record may be divided into sections, each of which is a test. The note names such a record once, with its
        // worst section.
        let mut named = BTreeSet::new();
        loud.retain(|(test, _)| named.insert(test.record));
        let told = |(t, times): &(&Test, f64)| {
            Sentence::from(phrases::TEST_AND_TIMES).with("test", &t.segment.name).with("times", format!("{times:.1}"))
        };
        let tests: Vec<Sentence> = loud.iter().take(LISTED).map(told).collect();
        (!tests.is_empty()).then(|| Sentence::from(phrases::STILL_MISSED).with_list("tests", tests, phrases::COMMA))
    }
}

fn looks(unnamed: Unnamed) -> Template {
    match unnamed {
        Unnamed::Guides => phrases::LIKE_GUIDES,
        Unnamed::LoadCell => phrases::LIKE_LOAD_CELL,
        Unnamed::Resonance => phrases::LIKE_RESONANCE,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn that_nothing_is_missing_has_no_certainty_but_what_is_unexplained_and_what_was_asked_for() {
        let said = |asked: Option<&[String]>, rms: f64, likeliest: Option<&Rival>| {
            summarize_nothing_missing(false, asked, rms * rms, likeliest).to_string()
        };
        // The residual of a model at the level of the noise has no part without a cause.
        let quiet = said(None, 1.02, None);
        assert!(quiet.starts_with("no known effect is missing") && !quiet.contains('%'), "{quiet}");
        let off = said(None, 1.48, None);
        assert!(off.contains("1.48 times") && off.contains("54 % of the mean square error has no known"), "{off}");
        assert!(!off.contains("sure"), "{off}");
        // The only certainty is that of an effect.
        let friction = Rival {
            effect: "coulomb_friction",
            confidence: 0.12,
            fraction: 0.3,
            why: Sentence::from(phrases::EXPLAINS).with("percent", percent(0.3)),
        };
        let open = said(None, 1.48, Some(&friction));
        assert!(open.contains("coulomb_friction (12 % sure)"), "{open}");
        // A search among few effects reports nothing about the others.
        let asked = said(Some(&["bump_stop".to_owned()]), 1.34, None);
        assert!(asked.starts_with("none of the effects asked for (bump_stop) is missing"), "{asked}");
        let against = summarize_nothing_missing(true, Some(&["bump_stop".to_owned()]), 1.0, None).to_string();
        assert!(
            against.starts_with("no number has changed and none of the effects asked for (bump_stop)"),
            "{against}"
        );
    }
}
