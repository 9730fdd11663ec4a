//! Families that remain probable in addition to the most probable one.
//!
//! An interval within one family ignores the others. For example, records at low speed may be explained by friction, or
//! by a steeper FV curve at one setting. Therefore, the interval of a parameter is that of the
//! [average over the alternatives](crate::structure::alternatives).

use super::pattern::{Site, varying_sites};
use super::problem::{FamilyHypothesis, SettingTests};
use super::structure::FamilyStructure;
use crate::refit::Effort;
use crate::structure::alternatives::{LEAST, MOST};
use crate::structure::component::Component;
use crate::structure::context::Form;
use dashpot_core::curve::Interpolation;
use dashpot_core::elements::fv_curve::fv_interpolation;
use rayon::prelude::*;

/// A family that a search refitted, without its derivatives.
#[derive(Clone)]
pub struct Rival {
    hypothesis: FamilyHypothesis,
    components: Vec<Component>,
    /// Log posterior, up to a constant that all families of a search share.
    pub log_posterior: f64,
}

impl From<&FamilyStructure> for Rival {
    fn from(of: &FamilyStructure) -> Rival {
        Rival { hypothesis: of.hypothesis.clone(), components: of.components.clone(), log_posterior: of.log_posterior }
    }
}

/// Returns what distinguishes two families: their effects, the quantities that vary with the setting, and the form of
/// the FV curve at zero velocity.
fn key(hypothesis: &FamilyHypothesis, components: &[Component]) -> (Vec<Form>, Vec<Site>, Interpolation) {
    let mut forms: Vec<Form> = components.iter().map(|c| (c.effect, c.form)).collect();
    forms.sort_unstable();
    let mut sites = varying_sites(&hypothesis.template, &hypothesis.varies);
    sites.sort_by_key(|site| match site {
        Site::Curve => "",
        Site::Number(number) => number.name(),
    });
    (forms, sites, fv_interpolation(&hypothesis.template.base))
}

/// Returns the rivals that differ from the most probable family and from each other, the most probable first.
pub(super) fn distinct_rivals(mut rivals: Vec<Rival>, best: &FamilyStructure) -> Vec<Rival> {
    rivals.sort_by(|a, b| b.log_posterior.total_cmp(&a.log_posterior));
    let mut known = vec![key(&best.hypothesis, &best.components)];
    rivals.retain(|rival| {
        let own = key(&rival.hypothesis, &rival.components);
        let is_new = !known.contains(&own);
        known.push(own);
        is_new
    });
    rivals
}

/// A family that remains probable in addition to the most probable one.
pub struct FamilyAlternative {
    /// The family, refitted.
    pub family: FamilyStructure,
    /// Weight of the family, relative to a weight of 1 for the most probable family.
    pub weight: f64,
}

/// Refits the rivals of a family that the records do not rule out, at most [`MOST`] of them. Each has a probability of
/// at least 5 % if only the rival and the family are compared. `temperature` divides the log odds.
pub fn alternatives(
    best: &FamilyStructure,
    rivals: &[Rival],
    settings: &[SettingTests],
    temperature: f64,
) -> Vec<FamilyAlternative> {
    let weight = |of: f64| libm::exp((of - best.log_posterior) / temperature);
    let is_open = |rival: &&Rival| weight(rival.log_posterior) >= LEAST / (1.0 - LEAST);
    let open: Vec<&Rival> = rivals.iter().filter(is_open).take(MOST).collect();
    open.into_par_iter()
        .filter_map(|rival| {
            let Rival { hypothesis, components, log_posterior } = rival.clone();
            let family = FamilyStructure::fit(hypothesis, components, settings, Effort::JUDGE)?;
            Some(FamilyAlternative { weight: weight(log_posterior), family })
        })
        .collect()
}
