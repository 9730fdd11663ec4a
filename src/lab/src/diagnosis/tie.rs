//! Effects that explain the same part of a disagreement of which much is left: the one beside which the next effect leaves
//! least comes first.

use super::hypothesis::Hypothesis;
use super::refit::Refit;
use super::round::{Ground, Round, Tried, look};
use super::search::{Added, Explained, with};

/// Share of the best one's standing within which another explains as much.
const AS_MUCH: f64 = 0.97;
/// Share of the excess from which an effect explains so much that nothing has to be looked ahead for.
const ENOUGH: f64 = 0.6;
/// Most effects that are followed.
const FOLLOWED: usize = 3;

/// Puts the effect first that leads furthest, where several of a round would be named and explain as much as each other:
/// that effect added.
pub fn look_ahead(
    round: &mut Round,
    ground: &Ground,
    last: &(Hypothesis, Refit),
    added: &[Added],
) -> Option<Explained> {
    // What fits a little of everything leads anywhere.
    let may = |t: &Tried| t.convinces() && !t.evidence.sponge;
    let best = round.tried.first().filter(|t| may(t) && t.evidence.share < ENOUGH)?;
    let as_much = |t: &Tried| may(t) && t.evidence.standing() >= AS_MUCH * best.evidence.standing();
    let tied: Vec<usize> = (0..round.tried.len()).filter(|k| as_much(&round.tried[*k])).take(FOLLOWED).collect();
    if tied.len() < 2 {
        return None;
    }
    let follow = |k: usize| {
        let (one, with_one) = with(&round.tried[k], &last.0, added, ground.tests)?;
        let next = look(ground, &one, &with_one, &|_| ())?;
        let left = next.tried.iter().filter(|t| t.convinces()).map(|t| t.refit.cost).fold(one.1.cost, f64::min);
        Some((k, left, (one, with_one)))
    };
    let (first, _, explained) = tied.into_iter().filter_map(follow).min_by(|a, b| a.1.total_cmp(&b.1))?;
    let chosen = round.tried.remove(first);
    round.tried.insert(0, chosen);
    Some(explained)
}
