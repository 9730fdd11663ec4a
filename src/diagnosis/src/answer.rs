//! The answer in one word, and in sentences.

use super::decisions::{NAMED, SUSPECTED};
use super::outcome::{Rival, Verdict};
use super::round::{Round, Tried};
use super::search::Search;
use super::tree::{decided, tree};
use dashpot_estimation::samples::Test;

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
    pub summary: String,
    /// What may be missing, or still be missing, without being likely enough to be named; likeliest first.
    pub suspects: Vec<Rival>,
    /// Remarks.
    pub notes: Vec<String>,
}

fn percent(x: f64) -> String {
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
    let times =
        |mean_square: f64| format!("{:.2} times the error that noise and the form of curves leave", mean_square.sqrt());
    let last = found.last_look.map(|place| &found.rounds[place]);
    let mut notes = Vec::new();
    if !found.found.added.is_empty() {
        let names: Vec<String> = found
            .found
            .added
            .iter()
            .zip(confidence)
            .map(|(a, c)| format!("{} ({} sure)", a.candidate.effect, percent(*c)))
            .collect();
        let left = 1.0 - explained(before, after);
        let suspects = last.map_or(Vec::new(), |round| suspects(round));
        if left > UNEXPLAINED {
            notes.push(format!(
                "{} of the disagreement is not explained by what was named: another form of it, or something else",
                percent(left)
            ));
        }
        return Judged {
            verdict: Verdict::Named,
            summary: format!(
                "missing: {}; what is left falls from {} to {:.2} times",
                names.join(", "),
                times(before),
                after.sqrt()
            ),
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
            let words: Vec<String> =
                loud.iter().take(TOLD).map(|(t, times)| format!("{} ({times:.1} times)", t.segment.name)).collect();
            notes.push(format!("too rare or too small to be named, but these tests are missed: {}", words.join(", ")));
        }
        return Judged {
            verdict: Verdict::NothingMissing,
            summary: format!(
                "nothing is missing that these records can show ({} sure): the model is off by {}",
                percent(odds.nothing),
                times(before)
            ),
            suspects: Vec::new(),
            notes,
        };
    }
    let tree = tree(first, SUSPECTED);
    let way = decided(&tree);
    let named: f64 = odds.effects.values().sum();
    if named >= NAMED {
        let names: Vec<&str> = suspects.iter().map(|s| s.effect).collect();
        let place = match way.last() {
            Some(branch) => format!("; it acts in the path {:?} ({})", branch.name, percent(branch.probability)),
            None => String::new(),
        };
        let why = match names[..] {
            [one] => format!("{one} is the likeliest name, but too few tests speak for it to give it"),
            _ => format!("these records cannot tell {} apart", names.join(" and ")),
        };
        return Judged {
            verdict: Verdict::CannotTell,
            summary: format!("something is missing: the model is off by {}, and {why}{place}", times(before)),
            suspects,
            notes,
        };
    }
    let nearest = match (looks_like(first), first.named().first()) {
        (Some((what, t)), _) => {
            format!("; it looks like {what}, which explains {}", percent(explained(before, t.weighed.mean())))
        }
        (None, Some(t)) => format!(
            "; the nearest, {}, explains {}",
            t.candidate.effect,
            percent(explained(before, t.weighed.mean()).max(0.0))
        ),
        (None, None) => String::new(),
    };
    Judged {
        verdict: Verdict::UnknownEffect,
        summary: format!(
            "the model is off by {}, and none of the known effects is likely enough to explain that{nearest}",
            times(before)
        ),
        suspects,
        notes,
    }
}

/// Share of the disagreement left from which that is told beside the names.
const UNEXPLAINED: f64 = 0.25;

/// What a disagreement without a name looks like, where that is likelier than any name.
fn looks_like(round: &Round) -> Option<(&'static str, &Tried)> {
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

fn why(tried: &Tried, before: &super::evidence::Weighed, share: f64) -> String {
    let says = format!("explains {} of the disagreement", percent(share.max(0.0)));
    if tried.weighed.implausibility - before.implausibility > STRANGE {
        format!("{says}, with numbers that dampers hardly show")
    } else {
        says
    }
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
        assert!(all[0].confidence > all[1].confidence && all[0].why.contains("94 %"), "{all:?}");
        // What is hardly possible is no suspect.
        assert!(suspects(&look).iter().all(|r| r.confidence >= LISTED));
    }

    #[test]
    fn numbers_that_dampers_hardly_show_are_told_as_the_reason() {
        let mut strange = tried("bushing", "", 1.2);
        strange.weighed.implausibility = 2.0 * STRANGE;
        let all = rivals(&round(9.0, vec![tried("aeration", "", 1.2), strange]), Some("aeration"));
        assert!(all[0].why.contains("hardly show"), "{all:?}");
    }
}
