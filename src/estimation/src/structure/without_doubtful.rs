//! The model that a search proposes instead of a given model: the most probable structure, without doubtful additions.

use super::budget::Budget;
use super::context::{SearchContext, Structure};
use super::expansion::expand;
use crate::refit::Effort;

/// Returns `best` without the effects that it adds to the given model and for which `is_certain` is false.
///
/// An added effect often replaces an effect of the given model. If the addition is doubtful, so is the replacement: the
/// effects of the given model return, as far as each raises the log posterior. Otherwise the proposed model would lack both
/// effects, and be worse than the given model.
pub fn without_doubtful(
    context: &SearchContext,
    given: &Structure,
    best: Structure,
    is_certain: &dyn Fn(&str) -> bool,
) -> Structure {
    let is_own = |effect: &str| given.components.iter().any(|own| own.effect == effect);
    let mut less = best;
    let before = less.components.len();
    while let Some(place) = less.components.iter().position(|c| !is_own(c.effect) && !is_certain(c.effect)) {
        // A structure without finite forces cannot be proposed, so the doubtful effect stays.
        let Some(without) = less.without(place, context.tests, Effort::FINE) else { break };
        less = without;
    }
    if less.components.len() == before {
        return less;
    }
    let proposed = restored(context, given, less);
    let adds_nothing = proposed.components.iter().all(|c| is_own(c.effect));
    if adds_nothing && given.log_posterior > proposed.log_posterior { given.clone() } else { proposed }
}

/// Returns a structure with those effects of the given model that raise its log posterior, the most probable first.
fn restored(context: &SearchContext, given: &Structure, from: Structure) -> Structure {
    let is_missing = |effect: &str| from.components.iter().all(|own| own.effect != effect);
    let missing: Vec<&str> = given.components.iter().map(|c| c.effect).filter(|effect| is_missing(effect)).collect();
    let mut restored = from;
    // Each iteration restores one effect.
    for _ in 0..missing.len() {
        let trial = expand(context, &restored, &|c| c.unnamed.is_none() && missing.contains(&c.effect), Budget::RIVALS)
            .and_then(|expansion| expansion.trials.into_iter().next())
            .and_then(|trial| trial.structure.refitted(context.tests, Effort::FINE));
        match trial.filter(|trial| trial.log_posterior > restored.log_posterior) {
            Some(more) => restored = more,
            None => break,
        }
    }
    restored
}

#[cfg(test)]
mod tests {
    use super::super::component::Component;
    use super::*;
    use crate::hypothesis::Hypothesis;
    use crate::prior_set::PriorSet;
    use crate::sines::measured;
    use crate::vocabulary::base_numbers;
    use dashpot_core::{Params, element, number};
    use dashpot_records::Record;

    /// The given damper has Coulomb friction, and a search has exchanged it for Stribeck friction.
    #[test]
    fn a_doubtful_exchange_returns_the_effect_of_the_given_model() {
        let mut base = Params::new();
        base.disable_all();
        for element in [element!("fv_curve"), element!("gas_preload"), element!("coulomb_friction")] {
            base.enable(element, true);
        }
        base.set(number!("coulomb_force"), 60.0).unwrap();
        let of = Hypothesis { base, numbers: base_numbers(&base), heating: None, priors: PriorSet::default() };
        let tests = measured(&of, &[(0.001, 20.0), (0.01, 0.02), (0.02, 2.0), (0.03, 4.0)]);
        // The heat input needs only the times of the record. The samples are in the tests.
        let record = Record { time: vec![0.0, 1.0], velocity: vec![0.0; 2], force: vec![0.0; 2], ..Record::default() };
        let context = SearchContext {
            records: &[&record],
            tests: &tests,
            is_allowed: &|_, _| true,
            changes: &[],
            priors: &PriorSet::default(),
            most: 3,
            progress: &|_| (),
        };
        let given = Structure::fit(of.clone(), Component::of_model(&of), &tests, Effort::FINE).unwrap();
        let place = |of: &Structure, effect: &str| of.components.iter().position(|c| c.effect == effect);
        let without = given.without(place(&given, "coulomb_friction").unwrap(), &tests, Effort::JUDGE).unwrap();
        let is_tried = |c: &crate::vocabulary::Candidate| c.effect == "stribeck_friction";
        let exchanged = expand(&context, &without, &is_tried, Budget::RIVALS).unwrap().trials.remove(0).structure;
        let certain = without_doubtful(&context, &given, exchanged.clone(), &|_| true);
        assert_eq!(certain.key(), exchanged.key());
        let doubtful = without_doubtful(&context, &given, exchanged, &|_| false);
        assert!(place(&doubtful, "coulomb_friction").is_some(), "{:?}", doubtful.key());
        assert!(place(&doubtful, "stribeck_friction").is_none(), "{:?}", doubtful.key());
        assert!(
            doubtful.log_posterior >= given.log_posterior - 0.1,
            "{}, {}",
            doubtful.log_posterior,
            given.log_posterior
        );
    }
}
