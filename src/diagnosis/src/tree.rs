//! Tree of all probabilities, with the levels path (location in the force path), family, effect and form.

use super::effects::CARDS;
use dashpot_estimation::structure::search::{StructureSearch, Temperatures};
use serde::Serialize;

/// Branch of the tree, with its probability and its subdivision.
#[derive(Debug, Clone, Serialize)]
pub struct Branch {
    /// Name of the path, family, effect or form.
    pub name: String,
    /// `path`, `family`, `effect` or `form`.
    pub level: &'static str,
    /// Probability that the damper has at least one effect of the branch.
    pub probability: f64,
    /// Subdivisions, most probable first.
    pub branches: Vec<Branch>,
}

fn sorted(mut branches: Vec<Branch>) -> Vec<Branch> {
    branches.sort_by(|a, b| b.probability.total_cmp(&a.probability).then(a.name.cmp(&b.name)));
    branches
}

/// Returns the tree of a search, with its paths as the first level. `at` contains the divisors of the log posteriors.
pub fn tree(search: &StructureSearch, at: Temperatures) -> Vec<Branch> {
    let distinct = |names: Vec<&'static str>| {
        let mut all: Vec<&'static str> = Vec::new();
        names.into_iter().for_each(|name| {
            if !all.contains(&name) {
                all.push(name);
            }
        });
        all
    };
    let forms = |effect: &'static str| {
        let mut names: Vec<&'static str> =
            search.table.keys().flatten().filter(|form| form.0 == effect).map(|form| form.1).collect();
        names.sort_unstable();
        names.dedup();
        let branch = |form: &'static str| Branch {
            name: form.to_owned(),
            level: "form",
            probability: search.probability_of(at, &|own| *own == (effect, form)),
            branches: Vec::new(),
        };
        sorted(names.into_iter().map(branch).collect())
    };
    let effect = |name: &'static str| {
        let probability = search.probability_of(at, &|own| own.0 == name);
        (probability > 0.0).then(|| Branch {
            name: name.to_owned(),
            level: "effect",
            probability,
            branches: forms(name),
        })
    };
    let of = |names: &[&'static str]| search.probability_of(at, &|own| names.contains(&own.0));
    let family = |family: &'static str| {
        let names: Vec<&'static str> = CARDS.iter().filter(|c| c.family == family).map(|c| c.name).collect();
        let branches = sorted(names.iter().filter_map(|name| effect(name)).collect());
        Branch { name: family.to_owned(), level: "family", probability: of(&names), branches }
    };
    let path = |path: &'static str| {
        let cards = || CARDS.iter().filter(|c| c.path == path);
        let names: Vec<&'static str> = cards().map(|c| c.name).collect();
        let families = distinct(cards().map(|c| c.family).collect());
        let branches = sorted(families.into_iter().map(family).collect());
        Branch { name: path.to_owned(), level: "path", probability: of(&names), branches }
    };
    sorted(distinct(CARDS.iter().map(|c| c.path).collect()).into_iter().map(path).collect())
}
