//! Description of each effect: location, meaning, required records, and the test that shows the effect best.

use super::advice::Advice;
use super::phrases;
use dashpot_core::element;
use dashpot_core::parameter::GROUPS;
use dashpot_estimation::situation::Situation;
use dashpot_messages::{Sentence, Template};

/// Description of an effect. The equations of the effect are in `dashpot_core`, its start values in
/// `dashpot_estimation::vocabulary`.
pub struct Card {
    /// Name of the effect.
    pub name: &'static str,
    /// Location of the effect in the force path.
    pub path: &'static str,
    /// Name of the family: a group of effects at one location that are hardest to distinguish from each other.
    pub family: &'static str,
    /// Test that shows the effect best.
    pub remedy: Template,
    /// Returns the reason why the records cannot show the effect with their channels and ranges, or `None` if they can.
    pub missing: fn(&Situation, &Advice) -> Option<Sentence>,
}

fn nothing(_: &Situation, _: &Advice) -> Option<Sentence> {
    None
}

/// Smallest range of side forces, N, at which tests of a car damper can distinguish side-force friction from other
/// friction. Heavier dampers need a range that is larger in proportion to their force.
const SIDE_FORCE: f64 = 50.0;
/// Smallest range of displacements at one speed, m, at which tests can show position-dependent damping. If tests pass
/// each displacement at only one speed, an effect of position cannot be separated from an effect of speed.
///
/// [`FREQUENCIES`] is the smallest ratio of the highest to the lowest frequency at which tests can show
/// frequency-selective damping.
const PLACES: f64 = 0.008;
const FREQUENCIES: f64 = 3.0;
/// Smallest range of accumulated heat over the tests, J, at which the temperature of a car damper changes noticeably.
/// Heavier dampers need a range that is larger in proportion to their force.
const HEAT: f64 = 500.0;
/// Smallest distance from zero displacement, m, that tests must reach to show a stop of a damper.
const STOPS: f64 = 0.04;

fn behind_series(s: &Situation, _: &Advice) -> Option<Sentence> {
    (!s.base.is_on(element!("series_compliance"))).then(|| phrases::NEEDS_SERIES.into())
}

/// Descriptions of all effects: those of the model's elements, then the measurement errors of the rig.
pub const CARDS: &[Card] = &[
    Card {
        name: element!("gas_preload").name(),
        path: "gas and springs",
        family: "constant force",
        remedy: phrases::SHOW_ZERO,
        missing: nothing,
    },
    Card {
        name: element!("gas_spring").name(),
        path: "gas and springs",
        family: "spring",
        remedy: phrases::SHOW_SPRING,
        missing: nothing,
    },
    Card {
        name: element!("gas_warming").name(),
        path: "gas and springs",
        family: "gas temperature",
        remedy: phrases::SHOW_GAS_WARMING,
        missing: |s, _| (!s.temperature_measured).then(|| phrases::NEEDS_MEASURED_TEMPERATURE.into()),
    },
    Card {
        name: element!("coulomb_friction").name(),
        path: "friction",
        family: "dry friction",
        remedy: phrases::SHOW_SLOW,
        missing: nothing,
    },
    Card {
        name: element!("stribeck_friction").name(),
        path: "friction",
        family: "dry friction",
        remedy: phrases::SHOW_SLOW,
        missing: nothing,
    },
    Card {
        name: element!("presliding_friction").name(),
        path: "friction",
        family: "dry friction",
        remedy: phrases::SHOW_PRESLIDING,
        missing: nothing,
    },
    Card {
        name: element!("viscous_friction").name(),
        path: "friction",
        family: "viscous friction",
        remedy: phrases::SHOW_SLOW,
        missing: |s, _| (!s.base.is_on(element!("viscous_friction"))).then(|| phrases::NEEDS_FIXED_CURVE.into()),
    },
    Card {
        name: element!("side_force_friction").name(),
        path: "friction",
        family: "friction under load",
        remedy: phrases::SHOW_SIDE_FORCE,
        missing: |s, _| (s.side_force_span < SIDE_FORCE * s.scale.force()).then(|| phrases::NEEDS_SIDE_FORCE.into()),
    },
    Card {
        name: element!("series_compliance").name(),
        path: "series",
        family: "mount",
        remedy: phrases::SHOW_MOUNT,
        missing: nothing,
    },
    Card {
        name: element!("bushing").name(),
        path: "series",
        family: "mount",
        remedy: phrases::SHOW_MOUNT,
        missing: behind_series,
    },
    Card {
        name: element!("parallel_spring").name(),
        path: "gas and springs",
        family: "spring",
        remedy: phrases::SHOW_SPRING,
        missing: nothing,
    },
    Card {
        name: element!("oil_compressibility").name(),
        path: "hydraulic",
        family: "oil column",
        remedy: phrases::SHOW_OIL,
        missing: nothing,
    },
    Card {
        name: element!("aeration").name(),
        path: "hydraulic",
        family: "oil column",
        remedy: phrases::SHOW_AERATION,
        missing: nothing,
    },
    Card {
        name: element!("cavitation").name(),
        path: "hydraulic",
        family: "void",
        remedy: phrases::SHOW_CAVITATION,
        missing: nothing,
    },
    Card {
        name: element!("temperature_fade").name(),
        path: "hydraulic",
        family: "oil temperature",
        remedy: phrases::SHOW_FADE,
        missing: |s, _| {
            (!s.temperature_measured && s.heat_span < HEAT * s.scale.force()).then(|| phrases::NEEDS_TEMPERATURE.into())
        },
    },
    Card {
        name: element!("position_dependent_damping").name(),
        path: "hydraulic",
        family: "valves",
        remedy: phrases::SHOW_POSITION,
        missing: |s, _| (s.places_span < PLACES).then(|| phrases::NEEDS_PLACES.into()),
    },
    Card {
        name: element!("bump_stop").name(),
        path: "gas and springs",
        family: "stop",
        remedy: phrases::SHOW_BUMP_STOP,
        missing: |s, advice| (s.reach.0 > -STOPS).then(|| advice.sentence(phrases::ONLY_WITHIN_COMPRESSION)),
    },
    Card {
        name: element!("rebound_stop").name(),
        path: "gas and springs",
        family: "stop",
        remedy: phrases::SHOW_REBOUND_STOP,
        missing: |s, advice| (s.reach.1 < STOPS).then(|| advice.sentence(phrases::ONLY_WITHIN_EXTENSION)),
    },
    Card {
        name: element!("free_play").name(),
        path: "series",
        family: "mount",
        remedy: phrases::SHOW_FREE_PLAY,
        missing: behind_series,
    },
    Card {
        name: element!("frequency_selective_damping").name(),
        path: "hydraulic",
        family: "valves",
        remedy: phrases::SHOW_FREQUENCY,
        missing: |s, advice| (s.frequency_ratio < FREQUENCIES).then(|| advice.sentence(phrases::NEEDS_FREQUENCIES)),
    },
    Card {
        name: element!("valve_hysteresis").name(),
        path: "hydraulic",
        family: "valves",
        remedy: phrases::SHOW_VALVE,
        missing: nothing,
    },
    Card {
        name: element!("moving_mass").name(),
        path: "rig",
        family: "mass",
        remedy: phrases::SHOW_MASS,
        missing: nothing,
    },
    Card { name: "channel_delay", path: "rig", family: "timing", remedy: phrases::SHOW_DELAY, missing: nothing },
    Card {
        name: "force_offset",
        path: "rig",
        family: "load cell",
        remedy: phrases::SHOW_ZERO,
        missing: |s, _| {
            (s.base.is_on(element!("gas_preload")) && s.pauses.is_empty()).then(|| phrases::NEEDS_ZERO.into())
        },
    },
    Card {
        name: "force_drift",
        path: "rig",
        family: "load cell",
        remedy: phrases::SHOW_DRIFT,
        missing: |s, _| (s.clock_span <= 1.0).then(|| phrases::NEEDS_ONE_CLOCK.into()),
    },
];

/// Names of all effects, in the order of their descriptions.
pub const EFFECTS: &[&str] = &{
    let mut names = [""; CARDS.len()];
    let mut k = 0;
    while k < CARDS.len() {
        names[k] = CARDS[k].name;
        k += 1;
    }
    names
};

/// Returns the description of an effect.
pub fn card(name: &str) -> Option<&'static Card> {
    CARDS.iter().find(|c| c.name == name)
}

/// Describes the test that shows an effect best.
pub fn remedy(effect: &str, advice: &Advice) -> Sentence {
    advice.sentence(card(effect).map_or(phrases::SHOW_MORE, |c| c.remedy))
}

/// Returns whether the given tests can show an effect at all. A stop always counts as shown, because the search looks
/// for stops within the range of the tests.
pub fn can_be_shown(effect: &str, s: &Situation) -> bool {
    card(effect).is_none_or(|c| c.family == "stop" || (c.missing)(s, &Advice::default()).is_none())
}

/// Describes an effect in one line.
pub fn meaning(effect: &str) -> &'static str {
    match effect {
        "channel_delay" => "the force channel lags the motion channels (rig)",
        "force_offset" => "the load cell does not read zero without load (rig)",
        "force_drift" => "the zero of the load cell moves with time (rig)",
        _ => GROUPS.iter().find(|g| g.name == effect).map_or("", |g| g.meaning),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use dashpot_estimation::prior_set::PriorSet;

    #[test]
    fn every_effect_has_one_card_and_a_meaning() {
        for (k, card) in CARDS.iter().enumerate() {
            assert!(!meaning(card.name).is_empty(), "{}", card.name);
            assert!(CARDS[..k].iter().all(|c| c.name != card.name), "{}", card.name);
            // All effects of a family are at one location.
            assert!(CARDS.iter().all(|c| c.family != card.family || c.path == card.path), "{}", card.family);
        }
        assert_eq!(EFFECTS.len(), CARDS.len());
    }

    use dashpot_core::parameter::Element;
    use dashpot_core::{Params, element};
    use dashpot_estimation::hypothesis::Hypothesis;
    use dashpot_estimation::situation::Situation;
    use dashpot_estimation::vocabulary::candidates;
    use dashpot_estimation::vocabulary::changes;
    use std::collections::BTreeSet;

    fn situation(preload: bool, measured: bool) -> Situation {
        let mut base = Params::new();
        base.enable(element!("stribeck_friction"), false);
        base.enable(element!("gas_preload"), preload);
        base.enable(element!("parallel_spring"), false);
        let mut situation = Situation::new(&base, &[], &[]);
        (situation.reach, situation.clock_span, situation.pauses) = ((-0.05, 0.05), 100.0, vec![50]);
        situation.temperature_measured = measured;
        situation
    }

    #[test]
    fn every_candidate_has_a_card_or_no_name() {
        let situation = situation(false, true);
        let all = candidates(&situation);
        // Only a fit, not a diagnosis, searches for a gain drift.
        for c in all.iter().filter(|c| c.effect != "gain_drift") {
            assert_eq!(EFFECTS.contains(&c.effect), c.unnamed.is_none(), "{}", c.effect);
        }
        let missing: Vec<&str> = EFFECTS.iter().copied().filter(|e| all.iter().all(|c| c.effect != *e)).collect();
        // All other effects without a candidate are effects of the base model, and effects that no rig can separate.
        let is_on = |effect: &str| Element::find(effect).is_ok_and(|element| situation.base.is_on(element));
        assert!(
            missing.iter().all(|e| is_on(e) || ["viscous_friction", "cylinder_expansion"].contains(e)),
            "{missing:?}"
        );
    }

    #[test]
    fn the_list_of_texts_has_every_form_and_no_other() {
        let reference =
            Hypothesis { base: Params::new(), numbers: Vec::new(), heating: None, priors: PriorSet::default() };
        let mut forms: BTreeSet<&str> = changes(&reference).iter().map(|c| c.form).collect();
        for preload in [false, true] {
            for measured in [false, true] {
                let all = candidates(&situation(preload, measured));
                forms.extend(all.iter().map(|c| c.form).filter(|form| !form.is_empty()));
            }
        }
        // A base model with friction and no mount also has the form in which the friction acts behind the mount.
        let mut base = Params::new();
        base.enable(element!("series_compliance"), false);
        base.enable(element!("presliding_friction"), true);
        let all = candidates(&Situation::new(&base, &[], &[]));
        forms.extend(all.iter().filter(|c| c.effect == "series_compliance" && !c.form.is_empty()).map(|c| c.form));
        assert_eq!(forms, crate::phrases::FORMS.iter().copied().collect());
    }
}
