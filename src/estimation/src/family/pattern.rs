//! Parameters of a damper that may depend on its setting, and the prior odds of such a dependence.

use crate::hypothesis::{Free, Hypothesis};
use crate::structure::component::weight;
use crate::unknowns::{CurveName, Unknown};
use dashpot_core::family::Axis;
use dashpot_core::parameter::Number;

/// Prior log odds that the FV curve depends on the setting: changing the curve is the purpose of an adjuster or a
/// valve.
const CURVE: f64 = 2.0;
/// Prior log odds that a parameter of a dissipative effect depends on the setting. An example is the friction of a
/// magneto-rheological valve.
const DISSIPATED: f64 = -1.5;
/// Prior log odds that a parameter of an energy store depends on the setting. Gas, springs and oil are outside the
/// valve.
const STORED: f64 = -3.0;
/// Number of free parameters as which the FV curve counts at each setting after the first. Curves of one valve differ
/// by little more than one factor for each stroke.
const FURTHER_CURVE: f64 = 2.0;

/// Quantity of the model that depends on the setting as a whole or not at all.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Site {
    /// The forces of the FV curve.
    Curve,
    /// A scalar parameter, with the parameters that are relative to it.
    Number(Number),
}

/// Returns the site of a free parameter; `None` if the parameter cannot depend on the setting.
pub fn site_of(free: &Free) -> Option<Site> {
    match free {
        Free::Model(Unknown::Rise { curve: CurveName::Fv, .. }) => Some(Site::Curve),
        Free::Model(Unknown::Log(number) | Unknown::Linear(number)) => {
            stores_energy(*number).is_some().then_some(Site::Number(*number))
        }
        // The parameter is relative to `below`. If it were shared while `below` varies, its value would vary too.
        Free::Model(Unknown::Above(number, below)) => stores_energy(*number).is_some().then_some(Site::Number(*below)),
        _ => None,
    }
}

/// Returns whether a parameter belongs to an energy store. Returns `None` if the parameter cannot depend on a setting.
fn stores_energy(number: Number) -> Option<bool> {
    let mut axis = Axis::NONE;
    axis.set_grid(&[0.0, 1.0]).ok()?;
    axis.set_values(number, &[number.default(); 2]).ok()?;
    let stores = axis.stores_energy().next().is_some();
    Some(stores)
}

/// Returns the sites of a hypothesis without duplicates, in the order of its parameters.
pub fn sites(template: &Hypothesis) -> Vec<Site> {
    let mut all = Vec::new();
    for site in template.numbers.iter().filter_map(|number| site_of(&number.free)) {
        if !all.contains(&site) {
            all.push(site);
        }
    }
    all
}

/// Returns for each parameter of a hypothesis whether it varies with the setting, given the sites that vary.
pub fn varies(template: &Hypothesis, sites: &[Site]) -> Vec<bool> {
    template.numbers.iter().map(|number| site_of(&number.free).is_some_and(|site| sites.contains(&site))).collect()
}

/// Returns the sites that vary under a pattern. The pattern states for each parameter whether it varies with the
/// setting.
pub fn varying_sites(template: &Hypothesis, varies: &[bool]) -> Vec<Site> {
    let is_varying = |site: &Site| {
        template.numbers.iter().zip(varies).any(|(number, varies)| *varies && site_of(&number.free) == Some(*site))
    };
    sites(template).into_iter().filter(is_varying).collect()
}

/// Computes the log prior odds of a pattern: the sum over its varying sites.
pub fn log_prior(template: &Hypothesis, varies: &[bool]) -> f64 {
    let odds = |site: &Site| match site {
        Site::Curve => CURVE,
        Site::Number(number) if stores_energy(*number) == Some(false) => DISSIPATED,
        Site::Number(_) => STORED,
    };
    varying_sites(template, varies).iter().map(odds).sum()
}

/// Counts the free parameters of a family. Weakly determined parameters count half. If the FV curve varies, it counts
/// as two parameters for each setting after the first.
pub fn numbers(template: &Hypothesis, varies: &[bool], settings: usize) -> f64 {
    let further = settings.saturating_sub(1) as f64;
    let of_curve = if varying_sites(template, varies).contains(&Site::Curve) { FURTHER_CURVE * further } else { 0.0 };
    let each = template.numbers.iter().zip(varies).map(|(number, varies)| {
        let again = *varies && site_of(&number.free) != Some(Site::Curve);
        weight(&number.free) * (1.0 + if again { further } else { 0.0 })
    });
    each.sum::<f64>() + of_curve
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::prior_set::PriorSet;
    use crate::vocabulary::base_numbers;
    use dashpot_core::{Params, number};

    #[test]
    fn a_curve_is_one_site_and_gas_is_less_probable_than_friction() {
        let base = Params::new();
        let template = Hypothesis { base, numbers: base_numbers(&base), heating: None, priors: PriorSet::default() };
        let all = sites(&template);
        assert_eq!(all.iter().filter(|site| **site == Site::Curve).count(), 1);
        let of = |site: Site| log_prior(&template, &varies(&template, &[site]));
        assert!(of(Site::Curve) > of(Site::Number(number!("stribeck_coulomb_force"))));
        assert!(of(Site::Number(number!("stribeck_coulomb_force"))) > of(Site::Number(number!("gas_force"))));
        assert_eq!(varying_sites(&template, &varies(&template, &all)), all);
    }

    #[test]
    fn breakaway_force_and_friction_level_vary_together() {
        let base = Params::new();
        let template = Hypothesis { base, numbers: base_numbers(&base), heating: None, priors: PriorSet::default() };
        let free = |name: &str| {
            let is_own = |free: &Free| match free {
                Free::Model(Unknown::Log(n) | Unknown::Linear(n) | Unknown::Above(n, _)) => n.name() == name,
                _ => false,
            };
            site_of(&template.numbers.iter().find(|number| is_own(&number.free)).unwrap().free).unwrap()
        };
        assert_eq!(free("stribeck_breakaway_force"), free("stribeck_coulomb_force"));
    }

    #[test]
    fn numbers_that_vary_cost_more() {
        let base = Params::new();
        let template = Hypothesis { base, numbers: base_numbers(&base), heating: None, priors: PriorSet::default() };
        let count = |sites: &[Site], settings| numbers(&template, &varies(&template, sites), settings);
        assert_eq!(count(&[], 2), count(&[], 5));
        let gas = [Site::Number(number!("gas_force"))];
        assert_eq!(count(&gas, 4), count(&[], 4) + 3.0);
    }
}
