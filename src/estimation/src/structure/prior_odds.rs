//! Prior log odds of an effect: its frequency in dampers and rigs, without any record.

use crate::prior_set::PriorSet;
use dashpot_core::number;
use dashpot_core::parameter::Number;

/// Log odds of an effect that nearly every damper has: seven of eight.
const COMMON: f64 = 2.0;
/// Log odds of an effect that every second damper has.
const EVEN: f64 = 0.0;
/// Log odds of an effect that one damper in twenty has, as a fault or by design.
const RARE: f64 = -3.0;
/// Parameters of the beta distribution of the rate of measurement faults, which differs from rig to rig. The log odds
/// of the first fault are thus −3.5, lower than those of a fault of the damper, because rigs are checked more often. If
/// a rig has one fault, another fault is more probable.
const FAULTS: [f64; 2] = [0.3, 10.0];

/// Effects that are more frequent than [`RARE`], with their log odds. Every damper has friction, gas and a soft series
/// path. Monotubes have gas columns and springs. The oil of every damper is compressible, but in every second damper,
/// the series path represents this compressibility. Effects outside this table are faults or rare designs.
const FREQUENT: [(&str, f64); 11] = [
    ("series_compliance", COMMON),
    ("gas_preload", COMMON),
    ("presliding_friction", COMMON),
    ("coulomb_friction", EVEN),
    ("oil_compressibility", EVEN),
    ("stribeck_friction", -1.0),
    ("parallel_spring", -1.5),
    ("gas_spring", -1.5),
    ("gas_warming", -1.5),
    ("side_force_friction", -1.0),
    ("viscous_friction", -2.0),
];

/// Frequent changes relative to a reference damper, with their log odds: adjustments, wear and leaks. Any other
/// parameter changes rarely, with the log odds [`CHANGE`].
const CHANGES: [(&str, f64); 13] = [
    ("fv_curve", -1.0),
    ("gas_force", -0.7),
    ("coulomb_force", -0.7),
    ("presliding_force", -0.7),
    ("stribeck_coulomb_force", -0.7),
    ("rebound_curve", -1.0),
    ("compression_curve", -1.0),
    ("rebound_low_speed", -1.5),
    ("compression_low_speed", -1.5),
    ("rebound_high_speed", -2.0),
    ("compression_high_speed", -2.0),
    ("series_stiffness", -1.5),
    ("spring_linear", -1.5),
];
const CHANGE: f64 = -3.0;

/// Returns the prior log odds of a change relative to a reference damper.
fn log_prior_odds_of_change(name: &str) -> f64 {
    CHANGES.iter().find(|(known, _)| *known == name).map_or(CHANGE, |(_, odds)| *odds)
}

/// Returns the prior log odds of an effect of the damper, or of a change.
///
/// In a comparison with a reference damper, effects that at least every second damper has count as rare. The reference
/// already had them, or they were too weak for the records. With ordinary odds, such an effect would be reported
/// instead of a changed parameter of the reference.
fn log_prior_odds(effect: &str, form: &str, priors: &PriorSet) -> f64 {
    if form == "changed" {
        return log_prior_odds_of_change(effect);
    }
    let usual = FREQUENT.iter().find(|(name, _)| *name == effect).map_or(RARE, |(_, odds)| *odds);
    if priors.is_against_reference() && usual >= EVEN { RARE } else { usual }
}

/// Computes the prior log odds of a number of measurement faults (Pólya's urn: each fault makes the next more
/// probable).
fn log_prior_odds_of_faults(count: usize) -> f64 {
    let [with, without] = FAULTS;
    (0..count).map(|k| k as f64).map(|k| libm::log((with + k) / (without - k).max(1.0))).sum()
}

/// Effects that count as common if a prior of this damper states the parameter on which they depend. The parameters are
/// the stiffness of the oil column and that of the gas.
const CERTAIN: [(&str, Number); 2] =
    [("oil_compressibility", number!("oil_stiffness")), ("gas_spring", number!("gas_stiffness"))];

/// Returns the increase of an effect's log odds due to known facts about this damper.
fn gain_of_knowledge(effect: &str, form: &str, priors: &PriorSet) -> f64 {
    let is_known = |(name, number): &(&str, Number)| *name == effect && priors.find(*number).is_some();
    let is_certain = form != "changed" && !priors.is_against_reference() && CERTAIN.iter().any(is_known);
    if is_certain { COMMON - log_prior_odds(effect, form, priors) } else { 0.0 }
}

/// Returns whether an effect is a fault or a rare design.
pub fn is_rare(effect: &str, form: &str, priors: &PriorSet) -> bool {
    form != "changed" && log_prior_odds(effect, form, priors) + gain_of_knowledge(effect, form, priors) <= RARE
}

/// Groups of effects of which a damper usually has one. A second effect of a group is as rare as a fault.
const ALTERNATIVES: [&[&str]; 2] =
    [&["coulomb_friction", "presliding_friction", "stribeck_friction"], &["parallel_spring", "gas_spring"]];

/// Returns whether two effects are alternatives: a damper has one or the other.
pub fn are_alternatives(effect: &str, other: &str) -> bool {
    ALTERNATIVES.iter().any(|group| group.contains(&effect) && group.contains(&other))
}

/// Computes the log prior odds of a damper's effects: each with its name, its form and a flag for a measurement error.
pub fn log_prior(effects: &[(&'static str, &'static str, bool)], priors: &PriorSet) -> f64 {
    let known: f64 = effects.iter().map(|(effect, form, _)| gain_of_knowledge(effect, form, priors)).sum();
    known + log_prior_of_all(effects, priors)
}

/// Computes the log prior odds of a set of effects of a damper, without known facts about their parameters.
fn log_prior_of_all(effects: &[(&'static str, &'static str, bool)], priors: &PriorSet) -> f64 {
    let is_fault = |(_, form, fault): &&(&str, &str, bool)| *fault && *form != "changed";
    let faults = log_prior_odds_of_faults(effects.iter().filter(is_fault).count());
    let each: f64 =
        effects.iter().filter(|e| !is_fault(e)).map(|(effect, form, _)| log_prior_odds(effect, form, priors)).sum();
    let further = |group: &&[&str]| {
        let own: Vec<f64> = effects
            .iter()
            .filter(|(effect, form, _)| group.contains(effect) && *form != "changed")
            .map(|(effect, form, _)| log_prior_odds(effect, form, priors))
            .collect();
        let best = own.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        if own.len() < 2 { 0.0 } else { RARE * (own.len() - 1) as f64 - (own.iter().sum::<f64>() - best) }
    };
    faults + each + ALTERNATIVES.iter().map(further).sum::<f64>()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn alone(effects: &[(&'static str, &'static str, bool)]) -> f64 {
        log_prior_of_all(effects, &PriorSet::default())
    }

    #[test]
    fn what_every_damper_has_comes_new_to_none() {
        let beside = PriorSet::default().against_reference();
        for (effect, _) in FREQUENT {
            let of = |priors: &PriorSet| log_prior(&[(effect, "", false)], priors);
            let is_common = of(&PriorSet::default()) >= EVEN;
            assert_eq!(of(&beside), if is_common { RARE } else { of(&PriorSet::default()) }, "{effect}");
        }
        assert!(is_rare("oil_compressibility", "", &beside) && !is_rare("series_stiffness", "changed", &beside));
    }

    #[test]
    fn a_fault_of_the_rig_is_rarer_than_one_of_the_damper_and_the_next_less_so() {
        let of = |count: usize| {
            alone(&[("channel_delay", "", true), ("force_drift", "", true), ("gain_drift", "", true)][..count])
        };
        assert!(of(1) < RARE && of(1) > RARE - 1.0);
        assert!(of(2) < of(1) - 1.0 && of(3) < of(2) - 0.5 && of(2) - of(1) > of(1));
    }

    #[test]
    fn a_second_friction_is_rare_and_a_first_one_common() {
        let one = alone(&[("presliding_friction", "", false)]);
        let two = alone(&[("presliding_friction", "", false), ("coulomb_friction", "", false)]);
        assert!(one > 0.0 && (two - one - RARE).abs() < 1e-12);
        let apart = alone(&[("presliding_friction", "", false), ("bump_stop", "", false)]);
        assert!((apart - one - RARE).abs() < 1e-12);
    }

    #[test]
    fn an_oil_column_of_known_dimensions_is_certain() {
        use crate::distribution::Distribution;
        use crate::prior_set::DamperPrior;
        let effects = [("oil_compressibility", "both chambers", false)];
        let row = DamperPrior {
            number: number!("oil_stiffness"),
            expected: Distribution::Size(9e6, 1.3),
            source: String::new(),
        };
        let (unknown, known) = (PriorSet::default(), PriorSet::new(vec![row]));
        assert_eq!(log_prior(&effects, &unknown), EVEN);
        assert_eq!(log_prior(&effects, &known), COMMON);
        assert!(!is_rare("oil_compressibility", "", &unknown) && is_rare("aeration", "", &known));
    }
}
