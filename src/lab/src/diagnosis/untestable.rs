//! Effects that these records cannot show, and the test that would.

use super::outcome::CouldNotTest;
use super::situation::Situation;
use dashpot_core::elements;

/// Side force span, N, from which friction under side force can be told from friction.
const SIDE_FORCE: f64 = 50.0;
/// Span of the mean displacements, m, and ratio of the frequencies, from which a place and a frequency can be told from
/// anything else.
const MEANS: f64 = 0.008;
const FREQUENCIES: f64 = 3.0;
/// What is left of an effect's response, in σ² over all tests, below which it leaves no trace at typical strength.
const TRACE: f64 = 20.0;

/// Why an effect could not be tested, from channels and ranges alone.
pub fn by_range(s: &Situation, effect: &'static str, heat_span: f64) -> Option<String> {
    let mm = |x: f64| format!("{:.0} mm", 1e3 * x.abs());
    match effect {
        "side_force_friction" if s.side_force_span < SIDE_FORCE => Some(
            "the side force does not vary: run the same sine at 0, 500 and 1000 N side force with its channel recorded"
                .to_owned(),
        ),
        "temperature_fade" if !s.temperature_measured && heat_span < 500.0 => Some(
            "no temperature channel varies, and the records' clocks show no heating: record the oil or tube temperature, or \
             repeat one test cold and after hard work"
                .to_owned(),
        ),
        "force_offset" if s.base.is_on("gas_preload") && s.pauses.is_empty() => Some(
            "a zero error of the load cell and the gas force are the same constant: read the load cell with the damper \
             unhooked, before and after"
                .to_owned(),
        ),
        "position_dependent_damping" if s.means_span < MEANS => Some(
            "all tests have nearly the same mean displacement: run one small sine at five or more mean positions".to_owned(),
        ),
        "frequency_selective_damping" if s.frequency_ratio < FREQUENCIES => Some(
            "the tests' frequencies are nearly the same: run one peak velocity at 0.5, 1, 2, 5 and 10 Hz".to_owned(),
        ),
        "force_drift" if s.clock_span <= 1.0 => Some(
            "every record starts its clock anew: keep one clock through the campaign and repeat a reference test".to_owned(),
        ),
        "viscous_friction" if !s.base.is_on("viscous_friction") => {
            Some("a free FV curve takes a v² term up: it needs the curve fixed by a specification".to_owned())
        }
        "bump_stop" => Some(format!(
            "only within the {} of compression that the tests reach: push slowly further to see a stop beyond",
            mm(s.reach.0)
        ))
        .filter(|_| s.reach.0 > -0.04),
        "rebound_stop" => Some(format!(
            "only within the {} of extension that the tests reach: pull slowly further to see a stop beyond",
            mm(s.reach.1)
        ))
        .filter(|_| s.reach.1 < 0.04),
        "cylinder_expansion" => Some(
            "the tube widens in proportion to pressure like the oil column yields: a rig shows their sum, which \
             oil_compressibility stands for"
                .to_owned(),
        ),
        "free_play" | "bushing" if !s.base.is_on("series_compliance") => {
            Some("it is part of the series path: the model needs series_compliance first".to_owned())
        }
        _ => None,
    }
}

/// Names of effects that are looked for, in the order of the vocabulary.
pub const EFFECTS: &[&str] = &[
    "gas_preload",
    "gas_spring",
    "coulomb_friction",
    "stribeck_friction",
    "presliding_friction",
    "viscous_friction",
    "side_force_friction",
    "series_compliance",
    "bushing",
    "parallel_spring",
    "oil_compressibility",
    "aeration",
    "cavitation",
    "temperature_fade",
    "position_dependent_damping",
    "bump_stop",
    "rebound_stop",
    "free_play",
    "frequency_selective_damping",
    "valve_hysteresis",
    "moving_mass",
    "channel_delay",
    "force_offset",
    "force_drift",
];

/// All that could not be tested: by channels and ranges, and by the trace that a typical strength would leave.
pub fn list(s: &Situation, invisible: &[(&'static str, f64)], found: &[&str], heat_span: f64) -> Vec<CouldNotTest> {
    let mut all: Vec<CouldNotTest> = Vec::new();
    for effect in EFFECTS.iter().copied().chain(["cylinder_expansion"]) {
        if s.base.is_on(effect) || found.contains(&effect) {
            continue;
        }
        let known = elements::names().any(|n| n == effect)
            || ["channel_delay", "force_offset", "force_drift", "cylinder_expansion"].contains(&effect);
        if !known {
            continue;
        }
        if let Some(why) = by_range(s, effect, heat_span) {
            all.push(CouldNotTest { effect, why });
        } else if invisible.iter().any(|(name, seen)| *name == effect && *seen < TRACE) {
            all.push(CouldNotTest {
                effect,
                why: format!("at a usual strength it would leave no trace in these tests: {}", remedy(effect)),
            });
        }
    }
    all
}

/// The test that shows an effect best.
pub fn remedy(effect: &str) -> &'static str {
    match effect {
        "gas_preload" | "force_offset" => "read the force at rest, with and without the damper hooked in",
        "gas_spring" | "parallel_spring" => "stroke the whole travel slowly, and once at 1 Hz, at two mean positions",
        "coulomb_friction" | "stribeck_friction" | "viscous_friction" => {
            "slow triangles at 0.5 to 30 mm/s, two strokes, two temperatures"
        }
        "presliding_friction" => "strokes of 0.1 to 2 mm at 0.1 and 1 Hz: equal loops speak for it",
        "side_force_friction" => "the same sine at 0, 500 and 1000 N side force",
        "series_compliance" | "bushing" => "0.05 to 0.5 mm sines at 1 to 30 Hz",
        "oil_compressibility" => "one peak velocity at several strokes and frequencies, at two mean positions",
        "aeration" => "one test after a night's rest and after 200 cycles",
        "cavitation" => "one peak velocity at several strokes, with the gas pressure raised",
        "temperature_fade" => {
            "a reference test repeated cold and hot, in shuffled order, with the temperature recorded"
        }
        "position_dependent_damping" => "5 to 10 mm sines at five or more mean positions",
        "bump_stop" => "push slowly into the stop, then at two speeds",
        "rebound_stop" => "pull slowly into the stop, then at two speeds",
        "free_play" => "small strokes with a preload that keeps the force from crossing zero, and without",
        "frequency_selective_damping" => "one peak velocity at 0.5, 1, 2, 5 and 10 Hz",
        "valve_hysteresis" => "slow ramps of velocity through the knee, up and down",
        "moving_mass" => "run the rig without the damper",
        "channel_delay" => "run a spring in place of the damper: its loop must close",
        "force_drift" => "repeat a reference test at the start, middle and end",
        _ => "more amplitudes and frequencies",
    }
}
