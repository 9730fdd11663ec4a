//! All probabilities of a look: path, family, effect, form; and the deepest level that the records decide.

use super::decisions::NAMED;
use super::effects::{CARDS, card};
use super::phrases::{NOTHING, SOMETHING_ELSE};
use super::round::Round;
use serde::Serialize;

/// A branch: everything below it has its probability together.
#[derive(Debug, Clone, Serialize)]
pub struct Branch {
    /// Path, family, effect or form; `nothing` and `something else` stand beside the paths.
    pub name: String,
    /// `path`, `family`, `effect` or `form`.
    pub level: &'static str,
    /// Probability.
    pub probability: f64,
    /// What it divides into, likeliest first.
    pub branches: Vec<Branch>,
}

fn sorted(mut branches: Vec<Branch>) -> Vec<Branch> {
    branches.sort_by(|a, b| b.probability.total_cmp(&a.probability).then(a.name.cmp(&b.name)));
    branches
}

fn joined(name: &str, level: &'static str, branches: Vec<Branch>) -> Branch {
    let probability = branches.iter().map(|b| b.probability).sum();
    Branch { name: name.to_owned(), level, probability, branches: sorted(branches) }
}

/// Names in the order in which they come first.
fn distinct(names: impl Iterator<Item = &'static str>) -> Vec<&'static str> {
    let mut all = Vec::new();
    for name in names {
        if !all.contains(&name) {
            all.push(name);
        }
    }
    all
}

/// The tree of a look, each test counted as `samples` independent ones.
pub fn tree(round: &Round, samples: f64) -> Vec<Branch> {
    let odds = round.odds(samples);
    let forms = |effect: &str, whole: f64| {
        let of: Vec<_> = round.tried.iter().filter(|t| t.candidate.effect == effect).collect();
        let logs: Vec<f64> = of.iter().map(|t| t.weighed.log_evidence(samples)).collect();
        let most = logs.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let sum: f64 = logs.iter().map(|l| libm::exp(l - most)).sum();
        let branch = |(t, log): (&&super::round::Tried, &f64)| Branch {
            name: t.candidate.form.to_owned(),
            level: "form",
            probability: whole * libm::exp(log - most) / sum,
            branches: Vec::new(),
        };
        sorted(of.iter().zip(&logs).map(branch).collect())
    };
    let effect = |name: &'static str| {
        let probability = odds.effects.get(name).copied()?;
        Some(Branch { name: name.to_owned(), level: "effect", probability, branches: forms(name, probability) })
    };
    let mut all: Vec<Branch> = distinct(CARDS.iter().map(|c| c.path))
        .into_iter()
        .map(|path| {
            let families = distinct(CARDS.iter().filter(|c| c.path == path).map(|c| c.family));
            let family = |family: &str| {
                let effects = CARDS.iter().filter(|c| c.family == family).filter_map(|c| effect(c.name)).collect();
                joined(family, "family", effects)
            };
            joined(path, "path", families.into_iter().map(family).collect())
        })
        .collect();
    for (name, probability) in [(NOTHING, odds.nothing), (SOMETHING_ELSE, odds.without_name)] {
        all.push(Branch { name: name.to_owned(), level: "path", probability, branches: Vec::new() });
    }
    sorted(all)
}

/// Probability of the family of an effect.
pub fn of_family(tree: &[Branch], effect: &str) -> f64 {
    let Some(card) = card(effect) else { return 0.0 };
    let families = tree.iter().flat_map(|path| &path.branches);
    families.filter(|family| family.name == card.family).map(|family| family.probability).sum()
}

/// The deepest branch that is likely enough, as the words that lead to it; empty where none is.
pub fn decided(tree: &[Branch]) -> Vec<&Branch> {
    let (mut way, mut level) = (Vec::new(), tree);
    while let Some(best) = level.first().filter(|b| b.probability >= NAMED) {
        way.push(best);
        level = &best.branches;
    }
    way
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_answer_stops_at_the_deepest_level_that_is_decided() {
        let leaf =
            |name: &str, level, probability| Branch { name: name.to_owned(), level, probability, branches: Vec::new() };
        let family = joined("mount", "family", vec![leaf("bushing", "effect", 0.4), leaf("free_play", "effect", 0.35)]);
        let tree = vec![joined("series", "path", vec![family]), leaf("something else", "path", 0.25)];
        let way: Vec<&str> = decided(&tree).iter().map(|b| b.name.as_str()).collect();
        assert_eq!(way, ["series", "mount"]);
        assert!((of_family(&tree, "free_play") - 0.75).abs() < 1e-12);
    }
}
