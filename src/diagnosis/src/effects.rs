//! One card an effect: where it acts, what it is, what records must show of it, and the test that shows it best.

use super::situation::Situation;
use dashpot_core::elements::GROUPS;

/// What is known of an effect apart from its equations, which are the kernel's, and the starts of its search, which are in the
/// vocabulary.
pub struct Card {
    /// Name.
    pub name: &'static str,
    /// Where in the way of the force it acts.
    pub path: &'static str,
    /// Effects of one family act in the same place and are the hardest to tell apart.
    pub family: &'static str,
    /// The test that shows it best.
    pub remedy: &'static str,
    /// Why records cannot show it, from their channels and ranges alone; `None` where they may.
    pub missing: fn(&Situation) -> Option<String>,
}

fn nothing(_: &Situation) -> Option<String> {
    None
}

/// Side force span, N, from which friction under side force can be told from friction.
const SIDE_FORCE: f64 = 50.0;
/// Span of the places that tests pass at speed, m, and ratio of the frequencies, from which a place and a frequency can be told from
/// anything else: of two tests at one speed one must go to where the other does not.
const PLACES: f64 = 0.008;
const FREQUENCIES: f64 = 3.0;
/// Span of the heat that tests bring in, J, below which nothing warms.
const HEAT: f64 = 500.0;
/// Displacement within which a stop of a car may lie, m.
const STOPS: f64 = 0.04;

const SLOW: &str = "slow triangles at 0.5 to 30 mm/s, two strokes, two temperatures";
const SPRING: &str = "stroke the whole travel slowly, and once at 1 Hz, at two mean positions";
const MOUNT: &str = "0.05 to 0.5 mm sines at 1 to 30 Hz";
const ZERO: &str = "read the force at rest, with and without the damper hooked in";

fn behind_series(s: &Situation) -> Option<String> {
    (!s.base.is_on("series_compliance"))
        .then(|| "it is part of the series path: the model needs series_compliance first".to_owned())
}

/// All cards, in the order of the way that the force takes.
pub const CARDS: &[Card] = &[
    Card { name: "gas_preload", path: "gas and springs", family: "constant force", remedy: ZERO, missing: nothing },
    Card { name: "gas_spring", path: "gas and springs", family: "spring", remedy: SPRING, missing: nothing },
    Card { name: "coulomb_friction", path: "friction", family: "dry friction", remedy: SLOW, missing: nothing },
    Card { name: "stribeck_friction", path: "friction", family: "dry friction", remedy: SLOW, missing: nothing },
    Card {
        name: "presliding_friction",
        path: "friction",
        family: "dry friction",
        remedy: "strokes of 0.1 to 2 mm at 0.1 and 1 Hz: equal loops speak for it",
        missing: nothing,
    },
    Card {
        name: "viscous_friction",
        path: "friction",
        family: "viscous friction",
        remedy: SLOW,
        missing: |s| {
            (!s.base.is_on("viscous_friction"))
                .then(|| "a free FV curve takes a v² term up: it needs the curve fixed by a specification".to_owned())
        },
    },
    Card {
        name: "side_force_friction",
        path: "friction",
        family: "friction under load",
        remedy: "the same sine at 0, 500 and 1000 N side force",
        missing: |s| {
            (s.side_force_span < SIDE_FORCE).then(|| {
                "the side force does not vary: run the same sine under two or more side forces, with the channel recorded"
                    .to_owned()
            })
        },
    },
    Card { name: "series_compliance", path: "series", family: "mount", remedy: MOUNT, missing: nothing },
    Card { name: "bushing", path: "series", family: "mount", remedy: MOUNT, missing: behind_series },
    Card { name: "parallel_spring", path: "gas and springs", family: "spring", remedy: SPRING, missing: nothing },
    Card {
        name: "oil_compressibility",
        path: "hydraulic",
        family: "oil column",
        remedy: "one peak velocity at several strokes and frequencies, at two mean positions",
        missing: nothing,
    },
    Card {
        name: "aeration",
        path: "hydraulic",
        family: "oil column",
        remedy: "one test after a night's rest and after 200 cycles",
        missing: nothing,
    },
    Card {
        name: "cavitation",
        path: "hydraulic",
        family: "void",
        remedy: "one peak velocity at several strokes, with the gas pressure raised",
        missing: nothing,
    },
    Card {
        name: "temperature_fade",
        path: "hydraulic",
        family: "oil temperature",
        remedy: "a reference test repeated cold and hot, in shuffled order, with the temperature recorded",
        missing: |s| {
            (!s.temperature_measured && s.heat_span < HEAT).then(|| {
                "no temperature channel varies, and the records' clocks show no heating: record the oil or tube temperature, or \
                 repeat one test cold and after hard work"
                    .to_owned()
            })
        },
    },
    Card {
        name: "position_dependent_damping",
        path: "hydraulic",
        family: "valves",
        remedy: "5 to 10 mm sines at five or more mean positions",
        missing: |s| {
            (s.places_span < PLACES).then(|| {
                "all tests pass the same places at the same speeds: run one small sine at five or more mean positions, or one \
                 peak velocity at several strokes"
                    .to_owned()
            })
        },
    },
    Card {
        name: "bump_stop",
        path: "gas and springs",
        family: "stop",
        remedy: "push slowly into the stop, then at two speeds",
        missing: |s| {
            (s.reach.0 > -STOPS).then(|| {
                format!(
                    "only within the {:.0} mm of compression that the tests reach: push slowly further to see a stop beyond",
                    1e3 * s.reach.0.abs()
                )
            })
        },
    },
    Card {
        name: "rebound_stop",
        path: "gas and springs",
        family: "stop",
        remedy: "pull slowly into the stop, then at two speeds",
        missing: |s| {
            (s.reach.1 < STOPS).then(|| {
                format!(
                    "only within the {:.0} mm of extension that the tests reach: pull slowly further to see a stop beyond",
                    1e3 * s.reach.1.abs()
                )
            })
        },
    },
    Card {
        name: "free_play",
        path: "series",
        family: "mount",
        remedy: "small strokes with a preload that keeps the force from crossing zero, and without",
        missing: behind_series,
    },
    Card {
        name: "frequency_selective_damping",
        path: "hydraulic",
        family: "valves",
        remedy: "one peak velocity at 0.5, 1, 2, 5 and 10 Hz",
        missing: |s| {
            (s.frequency_ratio < FREQUENCIES).then(|| {
                "the tests' frequencies are nearly the same: run one peak velocity at 0.5, 1, 2, 5 and 10 Hz".to_owned()
            })
        },
    },
    Card {
        name: "valve_hysteresis",
        path: "hydraulic",
        family: "valves",
        remedy: "slow ramps of velocity through the knee, up and down",
        missing: nothing,
    },
    Card {
        name: "moving_mass",
        path: "rig",
        family: "mass",
        remedy: "run the rig without the damper",
        missing: nothing,
    },
    Card {
        name: "channel_delay",
        path: "rig",
        family: "timing",
        remedy: "run a spring in place of the damper: its loop must close",
        missing: nothing,
    },
    Card {
        name: "force_offset",
        path: "rig",
        family: "load cell",
        remedy: ZERO,
        missing: |s| {
            (s.base.is_on("gas_preload") && s.pauses.is_empty()).then(|| {
                "a zero error of the load cell and the gas force are the same constant: read the load cell with the damper \
                 unhooked, before and after"
                    .to_owned()
            })
        },
    },
    Card {
        name: "force_drift",
        path: "rig",
        family: "load cell",
        remedy: "repeat a reference test at the start, middle and end",
        missing: |s| {
            (s.clock_span <= 1.0).then(|| {
                "every record starts its clock anew: keep one clock through the campaign and repeat a reference test".to_owned()
            })
        },
    },
];

/// Names of the effects that can be told, in the order of their cards.
pub const EFFECTS: &[&str] = &{
    let mut names = [""; CARDS.len()];
    let mut k = 0;
    while k < CARDS.len() {
        names[k] = CARDS[k].name;
        k += 1;
    }
    names
};

/// The card of an effect.
pub fn card(name: &str) -> Option<&'static Card> {
    CARDS.iter().find(|c| c.name == name)
}

/// The test that shows an effect best.
pub fn remedy(effect: &str) -> &'static str {
    card(effect).map_or("more amplitudes and frequencies", |c| c.remedy)
}

/// Whether tests as they are looked at can show an effect at all; stops are looked for as far as the tests reach.
pub fn can_be_shown(effect: &str, s: &Situation) -> bool {
    card(effect).is_none_or(|c| c.family == "stop" || (c.missing)(s).is_none())
}

/// What an effect is, in one line.
pub fn meaning(effect: &str) -> String {
    match effect {
        "channel_delay" => "the force channel lags the motion channels (rig)".to_owned(),
        "force_offset" => "the load cell does not read zero without load (rig)".to_owned(),
        "force_drift" => "the zero of the load cell moves with time (rig)".to_owned(),
        _ => GROUPS.iter().find(|g| g.name == effect).map_or_else(String::new, |g| g.meaning.to_owned()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_effect_has_one_card_and_a_meaning() {
        for (k, card) in CARDS.iter().enumerate() {
            assert!(!meaning(card.name).is_empty(), "{}", card.name);
            assert!(CARDS[..k].iter().all(|c| c.name != card.name), "{}", card.name);
            // A family lies in one path.
            assert!(CARDS.iter().all(|c| c.family != card.family || c.path == card.path), "{}", card.family);
        }
        assert_eq!(EFFECTS.len(), CARDS.len());
    }
}
