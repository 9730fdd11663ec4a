//! Kinds of model that `dashpot fit` and Python select by name.

use crate::fit::Family;

/// Kind of model that `dashpot fit` and Python can fit.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// A model file, which every command and host can run.
    Model(Family),
    /// A file of a model of the literature, with the name of the model. The file serves for comparison only, because the kernel cannot run
    /// the model.
    Comparison(&'static str),
}

/// All kinds with their names.
pub const KINDS: [(&str, Kind); 10] = [
    ("thesis", Kind::Model(Family::Thesis)),
    ("fv", Kind::Model(Family::Fv)),
    ("piecewise", Kind::Model(Family::Piecewise)),
    ("lag", Kind::Model(Family::Lag)),
    ("surface", Kind::Comparison("surface")),
    ("dahl", Kind::Comparison("dahl")),
    ("bouc-wen", Kind::Comparison("bouc-wen")),
    ("spencer", Kind::Comparison("spencer")),
    ("kwok", Kind::Comparison("kwok")),
    ("network", Kind::Comparison("network")),
];

impl Kind {
    /// Returns the kind with this name, or `None` if the name is unknown.
    pub fn named(name: &str) -> Option<Kind> {
        KINDS.iter().find(|known| known.0 == name).map(|known| known.1)
    }

    /// Returns the names of the kinds that produce a model file if `of_models` is true. Otherwise returns the names of all other kinds.
    pub fn names(of_models: bool) -> Vec<&'static str> {
        let is_asked = |kind: Kind| matches!(kind, Kind::Model(_)) == of_models;
        KINDS.iter().filter(|known| is_asked(known.1)).map(|known| known.0).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::literature::MODELS;

    #[test]
    fn every_model_of_the_literature_is_a_kind_and_bears_one_name() {
        for (name, _) in MODELS {
            match Kind::named(name) {
                Some(Kind::Comparison(called)) => assert_eq!(called, name),
                Some(Kind::Model(family)) => assert_ne!(family, Family::Thesis),
                None => panic!("{name} cannot be asked for"),
            }
        }
        assert_eq!(Kind::names(true), ["thesis", "fv", "piecewise", "lag"]);
        assert_eq!(KINDS.len(), MODELS.len() + 1);
    }
}
