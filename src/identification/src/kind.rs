//! What a model that is asked for by its name becomes: for the command and for Python.

use crate::fit::Family;

/// What a kind of model becomes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// A model file, which every verb and host runs.
    Model(Family),
    /// A file of a model of the literature, by its name there: to be compared with alone, for the kernel cannot run it.
    Comparison(&'static str),
}

/// Every kind by its name.
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
    /// The kind of this name.
    pub fn named(name: &str) -> Option<Kind> {
        KINDS.iter().find(|known| known.0 == name).map(|known| known.1)
    }

    /// Names of what becomes a model file, or of what does not.
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
