//! Two effects at once: where neither stands out alone because the other one hides its share, each is judged with the
//! other already in.

use super::hypothesis::Hypothesis;
use super::refit::Refit;
use super::round::{Ground, Round, Tried, look};
use super::search::{Added, is_worth_a_later_name, leave, with};

/// Effects of a round that are tried as one of two.
const TRIED: usize = 2;
/// Least share of the excess of one of two.
const SHARE: f64 = 0.2;
/// Share of what was left that two must explain together.
const TOGETHER: f64 = 0.75;
/// The same while the first is still in the form that it had alone.
const SO_FAR: f64 = 0.5;

/// Two effects that were added together.
pub struct Pair {
    /// The explanation with both.
    pub last: (Hypothesis, Refit),
    /// All that it has added.
    pub added: Vec<Added>,
    /// The rounds in which each was judged beside the other.
    pub rounds: Vec<Round>,
}

/// Looks for two effects of which each is convincing once the other is in; `round` is the look at `last` in which none
/// was.
pub fn two_at_once(ground: &Ground, last: &(Hypothesis, Refit), added: &[Added], round: &Round) -> Option<Pair> {
    let left = round.before - ground.floor;
    let may_be_one = |t: &&Tried| {
        let settled = !(t.evidence.sponge && t.evidence.unsettled);
        // What remembers from test to test takes extreme numbers as long as the other's share is laid to it.
        let likely = t.evidence.plausible >= if t.candidate.remembers { 0.5 } else { 1.0 };
        settled && likely && t.evidence.share >= SHARE && t.evidence.bic_fall > 10.0
    };
    round.named().filter(may_be_one).take(TRIED).find_map(|first| {
        let (one, with_first) = with(first, &last.0, added, ground.tests)?;
        let beside_first = look(ground, &one, &with_first, &|_| ())?;
        let second = beside_first.tried.first().filter(|t| t.convinces())?;
        let (both, with_both) = with(second, &one.0, &with_first, ground.tests)?;
        if round.before - both.1.chi2 < SO_FAR * left {
            return None;
        }
        let (other, with_second) = leave(&both, &with_both, added.len(), ground.tests)?;
        // The first, or whatever takes its place, must stand beside the second.
        let likely =
            |effect: &str| (ground.allowed)(effect) && round.tried.iter().any(|t| t.candidate.effect == effect);
        let beside_second = look(&Ground { allowed: &likely, ..*ground }, &other, &with_second, &|_| ())?;
        let stands = beside_second.tried.first().filter(|t| t.convinces())?;
        if !is_worth_a_later_name(stands, beside_second.before - ground.floor) {
            return None;
        }
        let (last, mut added_both) = with(stands, &other.0, &with_second, ground.tests)?;
        if round.before - last.1.chi2 < TOGETHER * left {
            return None;
        }
        // The one that explains more comes first.
        added_both[added.len()..].sort_by(|a, b| b.evidence.bic_fall.total_cmp(&a.evidence.bic_fall));
        Some(Pair { last, added: added_both, rounds: vec![beside_first, beside_second] })
    })
}
