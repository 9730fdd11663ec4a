//! Prior of each parameter over all dampers.
//!
//! If the records determine a parameter, its prior has little influence. Otherwise, the prior keeps the parameter at a
//! typical value, away from its bounds. A parameter value that is rare among dampers reduces the log odds of its
//! hypothesis. The reduction grows slowly with the distance from typical values, as for Student's distribution with
//! four degrees of freedom, because unusual dampers exist.

pub use crate::distribution::Distribution;
use crate::scale::Scale;
use crate::unknowns::Unknown;
use dashpot_core::number;
use dashpot_core::parameter::Number;

/// Prior of one parameter over all dampers, with its source.
#[derive(Debug, Clone, Copy)]
pub struct Prior {
    /// Parameter to which the prior applies.
    pub number: Number,
    /// Prior distribution of the parameter, in the unit of the parameter.
    pub distribution: Distribution,
    /// Source of the distribution.
    pub source: &'static str,
}

impl Prior {
    /// Returns the publication in the source of the prior, without the preceding description.
    pub fn citation(&self) -> &'static str {
        self.source.rsplit_once(": ").map_or(self.source, |(_, citation)| citation)
    }
}

const fn row(number: Number, distribution: Distribution, source: &'static str) -> Prior {
    Prior { number, distribution, source }
}

use Distribution::{Place, Size, Skewed, Strength};

const SEALS: &str =
    "seals and guides of passenger-car dampers: Deubel & Prokop, J. Automob. Eng. 2023; thesis, chapter 4";
const OIL: &str = "β 1.2 to 1.7 GPa, less with air, columns of 8 to 50 cm: Duym & Reybrouck 1998; Segel & Lang 1981";
const RUBBER: &str = "eyes and top mounts: García Tárrago 2007; Sjöberg, KTH 2002";
const EYE: &str = "weight of 1 to 3 kg on an eye, and residual clamping force";
const GAS: &str = "monotube 20 to 30 bar on rods of 11 to 14 mm, twin tube 3 to 8 bar: Dixon 2007, chapter 7";
const WARM_GAS: &str = "0.34 % of 80 to 400 N per kelvin (Gay-Lussac), up to three times that where expanding oil compresses the gas: Dixon 2007, chapter 5";
const VALVES: &str = "shim and spring valves of passenger-car dampers: Talbott & Starkey 2002; Dixon 2007, chapter 6";
const STOPS: &str = "stops of cars at 20 to 80 mm from standing height: Dixon 2007, chapter 2";
const RIG: &str = "clamps, eyes and adapters of hydraulic rigs";
const THESIS: &str = "Jonnalagadda & Vyas, KTH 2020, chapters 3 and 4";

/// Table of all priors. A parameter without a row has no prior.
pub const PRIORS: &[Prior] = &[
    row(number!("series_stiffness"), Size(2.5e6, 3.0), OIL),
    row(number!("series_damping"), Strength(200.0, 3.0), THESIS),
    row(number!("internal_mass"), Size(0.4, 1.8), THESIS),
    row(number!("free_play_gap"), Size(1.5e-4, 3.0), RUBBER),
    row(number!("free_play_force"), Size(8.0, 2.5), RUBBER),
    row(number!("free_play_load"), Place(0.0, 60.0), EYE),
    row(number!("bushing_hardening"), Size(2e-3, 4.0), RUBBER),
    row(number!("bushing_loss_stiffness"), Strength(0.4, 3.0), RUBBER),
    row(number!("bushing_loss_time"), Size(1e-2, 4.0), RUBBER),
    row(number!("bushing_slip"), Size(1e-4, 4.0), RUBBER),
    row(number!("bushing_stop"), Size(1e-3, 5.0), RUBBER),
    row(number!("bushing_stop_stiffness"), Strength(3.0, 4.0), RUBBER),
    row(number!("bushing_slow_stiffness"), Strength(0.4, 3.0), RUBBER),
    row(number!("bushing_slow_time"), Size(0.1, 4.0), RUBBER),
    row(number!("oil_stiffness"), Size(3e6, 3.0), OIL),
    row(number!("oil_shortening"), Place(6.0, 5.0), OIL),
    row(number!("oil_compression"), Size(1.0, 4.0), OIL),
    row(number!("aeration_stroke"), Size(3e-4, 3.0), OIL),
    row(number!("aeration_force"), Size(200.0, 2.5), OIL),
    row(number!("aeration_compression"), Size(1.0, 2.5), OIL),
    row(number!("cavitation_force"), Size(1200.0, 2.5), VALVES),
    row(number!("cavitation_onset"), Place(0.8, 0.3), VALVES),
    row(number!("cavitation_expansion"), Size(5e-4, 4.0), VALVES),
    row(number!("cavitation_velocity"), Size(0.3, 2.0), VALVES),
    row(number!("cavitation_unfilled"), Size(0.05, 3.0), VALVES),
    row(number!("bypass_share"), Place(0.2, 0.4), VALVES),
    row(number!("bypass_flow"), Strength(0.1, 3.0), VALVES),
    row(number!("bypass_centre"), Place(0.0, 0.04), VALVES),
    row(number!("bypass_half_width"), Size(0.02, 2.0), VALVES),
    row(number!("bypass_blend"), Size(5e-3, 2.0), VALVES),
    row(number!("fade_coefficient"), Place(0.005, 0.01), "Vogel's law for damper oils, 0.2 to 3 % per kelvin"),
    row(number!("fade_laminar_force"), Size(5e3, 8.0), VALVES),
    row(number!("heat_capacity"), Size(600.0, 2.0), "0.3 to 0.6 kg of oil and 1 to 2 kg of steel"),
    row(number!("fsd_share"), Strength(0.25, 1.7), VALVES),
    row(number!("fsd_flow"), Strength(0.1, 3.0), VALVES),
    row(number!("fsd_time"), Size(0.04, 2.5), VALVES),
    row(number!("fsd_force"), Size(100.0, 3.0), VALVES),
    row(number!("fsd_laminar_force"), Size(150.0, 5.0), VALVES),
    row(number!("valve_hysteresis_share"), Strength(0.15, 2.0), VALVES),
    row(number!("valve_opening_force"), Size(500.0, 3.0), VALVES),
    row(number!("valve_closing_ratio"), Place(0.8, 0.15), VALVES),
    row(number!("valve_width"), Size(150.0, 4.0), VALVES),
    row(number!("valve_time"), Size(2e-3, 3.5), VALVES),
    row(number!("valve_play"), Size(50.0, 3.0), VALVES),
    row(number!("valve_damping"), Size(0.7, 2.0), VALVES),
    row(number!("spring_linear"), Place(500.0, 2000.0), THESIS),
    row(number!("spring_quadratic"), Place(0.0, 5e4), THESIS),
    row(number!("spring_cubic"), Place(0.0, 1e6), THESIS),
    row(number!("spring_quartic"), Place(0.0, 2e7), THESIS),
    row(number!("coulomb_force"), Strength(40.0, 3.0), SEALS),
    row(number!("coulomb_steepness"), Size(1000.0, 2.5), SEALS),
    row(number!("stribeck_coulomb_force"), Strength(40.0, 3.0), SEALS),
    row(number!("stribeck_breakaway_force"), Strength(20.0, 3.0), SEALS),
    row(number!("stribeck_breakaway_velocity"), Size(5e-3, 2.0), SEALS),
    row(number!("stribeck_velocity"), Size(0.012, 2.0), SEALS),
    row(number!("stribeck_fall"), Size(1.6, 1.4), SEALS),
    row(number!("presliding_force"), Strength(40.0, 3.0), SEALS),
    row(number!("presliding_length"), Size(3e-4, 3.0), SEALS),
    row(number!("presliding_power"), Size(1.5, 2.0), SEALS),
    row(number!("presliding_creep"), Size(1e-4, 4.0), SEALS),
    row(number!("viscous_coefficient"), Place(0.0, 50.0), THESIS),
    row(number!("side_force_coefficient"), Strength(0.05, 2.0), SEALS),
    // Gas pushes the rod out. A negative value means a zero offset of the load cell of some tens of newtons.
    row(number!("gas_force"), Skewed(100.0, 80.0, 400.0), GAS),
    row(number!("gas_warming_rate"), Strength(0.8, 2.5), WARM_GAS),
    row(number!("gas_stiffness"), Strength(1000.0, 3.0), GAS),
    row(number!("gas_length"), Size(0.25, 2.2), GAS),
    row(number!("gas_thermal_time"), Size(2.0, 3.0), GAS),
    row(number!("bump_stop_clearance"), Place(0.04, 0.03), STOPS),
    row(number!("bump_stop_stiffness"), Size(2e4, 4.0), STOPS),
    row(number!("bump_stop_damping"), Size(2e3, 5.0), STOPS),
    row(number!("bump_stop_progression"), Size(0.02, 3.0), STOPS),
    row(number!("rebound_stop_clearance"), Place(0.04, 0.03), STOPS),
    row(number!("rebound_stop_stiffness"), Size(4e4, 4.0), STOPS),
    row(number!("rebound_stop_damping"), Size(2e3, 5.0), STOPS),
    row(number!("rebound_stop_progression"), Size(0.02, 3.0), STOPS),
    row(number!("moving_mass"), Strength(2.0, 2.5), RIG),
    row(number!("lag_slow"), Size(5e-3, 3.0), THESIS),
    row(number!("lag_fast"), Size(1e-3, 3.0), THESIS),
];

/// Returns the prior distribution of a parameter of a damper of size `scale`. Returns `None` if the parameter has no
/// prior.
pub fn distribution(number: Number, scale: Scale) -> Option<Distribution> {
    PRIORS.iter().find(|p| p.number == number).map(|p| scale.scale_distribution(number, p.distribution))
}

/// Returns whether a parameter is the force of an effect, so that the effect is absent at zero. A damping, in contrast,
/// may be zero although its element is present.
pub fn is_force_of_effect(number: Number) -> bool {
    let is_strength = PRIORS.iter().any(|p| p.number == number && matches!(p.distribution, Strength(..)));
    is_strength && number.parameter().unit == "N"
}

/// Degrees of freedom of the Student's t-distribution that gives the cost of a rare parameter value.
///
/// With four degrees of freedom, a distance of five standard deviations reduces the log odds by five. With a normal
/// distribution, the reduction is twelve.
const FREEDOM: f64 = 4.0;

/// Computes the decrease of the log odds due to a parameter at a distance of `score` standard deviations from its
/// prior.
pub fn log_cost(score: f64) -> f64 {
    0.5 * (FREEDOM + 1.0) * libm::log1p(score * score / FREEDOM)
}

/// Returns mean and standard deviation of the prior of a free parameter in its search coordinate. Returns `None` if the
/// parameter has no prior.
pub fn in_search(unknown: &Unknown, scale: Scale) -> Option<(f64, f64)> {
    match unknown {
        Unknown::Log(number) => distribution(*number, scale).map(|usual| usual.in_search(true)),
        Unknown::Linear(number) => distribution(*number, scale).map(|usual| usual.in_search(false)),
        // The parameter is the excess over the Coulomb force, as a fraction of this force. For seals, it is 0.1 to 0.6.
        Unknown::Above(..) => Some((0.2, 0.5)),
        Unknown::Rise { .. } | Unknown::Entry(..) => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_row_lies_inside_its_bounds_and_stands_once() {
        for (k, prior) in PRIORS.iter().enumerate() {
            let at = prior.distribution.center();
            assert_eq!(prior.number.inside(at), at, "{} is outside {:?}", prior.number, prior.number.bounds());
            assert!(PRIORS[..k].iter().all(|other| other.number != prior.number), "{} stands twice", prior.number);
            assert!(!prior.source.is_empty());
        }
    }

    #[test]
    fn the_usual_costs_nothing_and_the_strange_something_but_never_all() {
        assert_eq!(log_cost(0.0), 0.0);
        assert!(log_cost(1.0) < 0.6 && log_cost(5.0) > 4.0 && log_cost(100.0) < 25.0);
        assert_eq!(Distribution::Strength(40.0, 3.0).standard_score(5.0), 0.0);
        assert!((Distribution::Strength(40.0, 3.0).standard_score(360.0) - 2.0).abs() < 1e-12);
        assert!((Distribution::Size(2e6, 2.0).standard_score(5e5) + 2.0).abs() < 1e-12);
    }
}
