//! The answer in one word, and in sentences.

use super::decisions::{NAMED, SUSPECTED};
use super::outcome::{Rival, Verdict};
use super::phrases;
use super::round::{Round, Tried};
use super::search::Search;
use super::tree::{decided, tree};
use dashpot_estimation::samples::Test;
use dashpot_records::sentence::{Sentence, Template};

/// Most suspects and rivals told.
const TOLD: usize = 4;
/// Probability below which an effect is no suspect: the list would be one of everything.
const LISTED: f64 = 0.02;
/// Mean square of a single test, in units of what noise and curves leave, from which it is told where all in all nothing is missing.
const LOUD: f64 = 4.0;

/// An answer with its reasons.
pub struct Judged {
    /// The word.
    pub verdict: Verdict,
    /// The sentences.
    pub summary: Sentence,
    /// What may be missing, or still be missing, without being likely enough to be named; likeliest first.
    pub suspects: Vec<Rival>,
    /// Remarks.
    pub notes: Vec<Sentence>,
}

pub fn percent(x: f64) -> String {
    format!("{:.0} %", 100.0 * x)
}

/// Share of what is beyond the noise that is explained: of mean squares in units of what noise and curves leave.
pub fn explained(before: f64, after: f64) -> f64 {
    if before > 1.0 { ((before - after) / (before - 1.0)).clamp(-1.0, 1.0) } else { 0.0 }
}

/// Judges a finished search; `confidence` of each name that was added, in their order.
pub fn judge(found: &Search, fitted: &[Test], confidence: &[f64]) -> Judged {
    let before = found.rounds[0].before.mean();
    let after = found.found.weighed(fitted).mean();
    let times = |mean_square: f64| Sentence::from(phrases::TIMES).with("times", format!("{:.2}", mean_square.sqrt()));
    let last = found.last_look.map(|place| &found.rounds[place]);
    let mut notes = Vec::new();
    if !found.found.added.is_empty() {
        let name = |(a, c): (&super::search::Added, &f64)| {
            Sentence::from(phrases::NAME_AND_SURE).with("effect", a.candidate.effect).with("percent", percent(*c))
        };
        let names: Vec<Sentence> = found.found.added.iter().zip(confidence).map(name).collect();
        let left = 1.0 - explained(before, after);
        let suspects = last.map_or(Vec::new(), suspects);
        if left > UNEXPLAINED {
            notes.push(Sentence::from(phrases::NOT_EXPLAINED).with("percent", percent(left)));
        }
        return Judged {
            verdict: Verdict::Named,
            summary: Sentence::from(phrases::MISSING)
                .with_list("names", names, phrases::COMMA)
                .with_said("before", times(before))
                .with("after", format!("{:.2}", after.sqrt())),
            suspects,
            notes,
        };
    }
    let first = &found.rounds[0];
    let odds = first.odds(SUSPECTED);
    let suspects = suspects(first);
    if odds.nothing >= NAMED {
        let mut loud: Vec<(&Test, f64)> = fitted
            .iter()
            .zip(&first.before.mean_squares)
            .filter(|(_, square)| **square > LOUD)
            .map(|(test, square)| (test, square.sqrt()))
            .collect();
        loud.sort_by(|a, b| b.1.total_cmp(&a.1));
        if !loud.is_empty() {
            let told = |(t, times): &(&Test, f64)| {
                Sentence::from(phrases::TEST_AND_TIMES)
                    .with("test", &t.segment.name)
                    .with("times", format!("{times:.1}"))
            };
            let tests = loud.iter().take(TOLD).map(told).collect();
            notes.push(Sentence::from(phrases::STILL_MISSED).with_list("tests", tests, phrases::COMMA));
        }
        return Judged {
            verdict: Verdict::NothingMissing,
            summary: Sentence::from(phrases::NOTHING_MISSING)
                .with("percent", percent(odds.nothing))
                .with_said("times", times(before)),
            suspects: Vec::new(),
            notes,
        };
    }
    let tree = tree(first, SUSPECTED);
    let way = decided(&tree);
    let named: f64 = odds.effects.values().sum();
    if named >= NAMED {
        let names: Vec<&str> = suspects.iter().map(|s| s.effect).collect();
        // What no path is known for has none to tell.
        let place = way.last().filter(|branch| !branch.name.is_empty()).map(|branch| {
            Sentence::from(phrases::IN_PATH)
                .with_word("path", &branch.name)
                .with("percent", percent(branch.probability))
        });
        let why = match names[..] {
            [one] => Sentence::from(phrases::TOO_FEW_TESTS).with("effect", one),
            _ => Sentence::from(phrases::NOT_APART).with_names("effects", names, phrases::AND),
        };
        return Judged {
            verdict: Verdict::CannotTell,
            summary: Sentence::from(phrases::CANNOT_TELL)
                .with_said("times", times(before))
                .with_said("why", why)
                .with_any("place", place),
            suspects,
            notes,
        };
    }
    let nearest = match (looks_like(first), first.named().first()) {
        (Some((what, t)), _) => Some(
            Sentence::from(phrases::LOOKS_LIKE)
                .with_said("what", what)
                .with("percent", percent(explained(before, t.weighed.mean()))),
        ),
        (None, Some(t)) => Some(
            Sentence::from(phrases::NEAREST)
                .with("effect", t.candidate.effect)
                .with("percent", percent(explained(before, t.weighed.mean()).max(0.0))),
        ),
        (None, None) => None,
    };
    Judged {
        verdict: Verdict::UnknownEffect,
        summary: Sentence::from(phrases::UNKNOWN_EFFECT).with_said("times", times(before)).with_any("nearest", nearest),
        suspects,
        notes,
    }
}

/// Share of the disagreement left from which that is told beside the names.
const UNEXPLAINED: f64 = 0.25;

/// What a disagreement without a name looks like, where that is likelier than any name.
fn looks_like(round: &Round) -> Option<(Template, &Tried)> {
    let best = round.tried.first()?;
    best.candidate.unnamed.map(|what| (what, best))
}

/// The effects that may be missing, likeliest first.
fn suspects(round: &Round) -> Vec<Rival> {
    rivals(round, None).into_iter().filter(|r| r.confidence >= LISTED).collect()
}

/// The effects of a look but one, likeliest first, and why they lost.
pub fn rivals(round: &Round, winner: Option<&str>) -> Vec<Rival> {
    let odds = round.odds(SUSPECTED);
    let before = round.before.mean();
    let mut all: Vec<Rival> = round
        .named()
        .into_iter()
        .filter(|t| Some(t.candidate.effect) != winner)
        .map(|t| {
            let share = explained(before, t.weighed.mean());
            Rival {
                effect: t.candidate.effect,
                confidence: odds.effects.get(t.candidate.effect).copied().unwrap_or(0.0),
                share,
                why: why(t, &round.before, share),
            }
        })
        .collect();
    all.sort_by(|a, b| b.confidence.total_cmp(&a.confidence).then(b.share.total_cmp(&a.share)));
    all.truncate(TOLD);
    all
}

/// Price of strange values, beyond the base's, from which it is told as the reason.
const STRANGE: f64 = 3.0;

fn why(tried: &Tried, before: &super::evidence::Weighed, share: f64) -> Sentence {
    let is_strange = tried.weighed.implausibility - before.implausibility > STRANGE;
    let says = if is_strange { phrases::EXPLAINS_STRANGELY } else { phrases::EXPLAINS };
    Sentence::from(says).with("percent", percent(share.max(0.0)))
}

#[cfg(test)]
mod tests {
    use super::super::round::tests::{round, tried};
    use super::*;

    #[test]
    fn what_is_explained_is_a_share_of_what_is_beyond_the_noise() {
        assert_eq!(explained(9.0, 1.0), 1.0);
        assert_eq!(explained(9.0, 5.0), 0.5);
        assert_eq!(explained(9.0, 17.0), -1.0);
        // Nothing was to be explained.
        assert_eq!(explained(0.8, 0.5), 0.0);
    }

    #[test]
    fn rivals_come_likeliest_first_without_the_winner_and_say_what_they_explain() {
        let look = round(9.0, vec![tried("aeration", "", 1.2), tried("free_play", "", 1.5), tried("bushing", "", 6.0)]);
        let all = rivals(&look, Some("aeration"));
        assert_eq!(all.iter().map(|r| r.effect).collect::<Vec<_>>(), ["free_play", "bushing"]);
        assert!(all[0].confidence > all[1].confidence && all[0].why.to_string().contains("94 %"), "{all:?}");
        // What is hardly possible is no suspect.
        assert!(suspects(&look).iter().all(|r| r.confidence >= LISTED));
    }

    #[test]
    fn numbers_that_dampers_hardly_show_are_told_as_the_reason() {
        let mut strange = tried("bushing", "", 1.2);
        strange.weighed.implausibility = 2.0 * STRANGE;
        let all = rivals(&round(9.0, vec![tried("aeration", "", 1.2), strange]), Some("aeration"));
        assert!(all[0].why.to_string().contains("hardly show"), "{all:?}");
    }
}
