//! A refitted family with its effects and its log posterior.

use super::pattern::{Site, log_prior as log_prior_of_pattern, numbers, varies, varying_sites};
use super::problem::{FamilyHypothesis, FamilyRefit, SettingTests};
use crate::hypothesis::Residual;
use crate::refit::Effort;
use crate::scale::Scale;
use crate::structure::component::Component;
use crate::structure::evidence::{self, Evidence};
use crate::structure::prior_odds::log_prior;

/// A refitted family.
#[derive(Clone)]
pub struct FamilyStructure {
    /// Free parameters of the family. Their start values are the result of the refit.
    pub hypothesis: FamilyHypothesis,
    /// Effects of the family.
    pub components: Vec<Component>,
    /// Result of the refit.
    pub refit: FamilyRefit,
    /// Evidence from the residuals.
    pub evidence: Evidence,
    /// Log posterior, up to a constant that all families of a search share.
    pub log_posterior: f64,
}

/// Computes the evidence of a family from its residuals. The negative log prior of the evidence is that of the least
/// plausible setting.
pub fn evidence(
    hypothesis: &FamilyHypothesis,
    theta: &[f64],
    residuals: &[Residual],
    settings: &[SettingTests],
) -> Evidence {
    let count = numbers(&hypothesis.template, &hypothesis.varies, settings.len());
    let mut all = Evidence {
        mean_squares: Vec::new(),
        weights: Vec::new(),
        numbers: count,
        negative_log_prior: 0.0,
        relief: 0.0,
    };
    for (setting, (of, residual)) in settings.iter().zip(residuals).enumerate() {
        let own = Evidence::new(&hypothesis.template, &hypothesis.theta_at(theta, setting), residual, &of.tests, 0.0);
        all.mean_squares.extend(own.mean_squares);
        all.weights.extend(own.weights);
        all.negative_log_prior = all.negative_log_prior.max(own.negative_log_prior);
    }
    all.relief = relief(hypothesis, all.per_number());
    all
}

/// Computes the log prior of a family: the log prior of its effects plus that of its dependence on the setting.
pub fn log_prior_of(hypothesis: &FamilyHypothesis, components: &[Component]) -> f64 {
    let effects: Vec<_> = components.iter().map(|c| (c.effect, c.form, c.is_of_measurement())).collect();
    log_prior(&effects, &hypothesis.template.priors) + log_prior_of_pattern(&hypothesis.template, &hypothesis.varies)
}

/// Computes the reduction of the cost of the free parameters by known facts about this damper, in log odds. A varying
/// parameter counts once for each setting.
fn relief(hypothesis: &FamilyHypothesis, per_number: f64) -> f64 {
    let FamilyHypothesis { template, varies, .. } = hypothesis;
    let scale = Scale::from_params(&template.base);
    let each = template.numbers.iter().zip(varies).map(|(number, varies)| {
        let times = if *varies { hypothesis.settings() as f64 } else { 1.0 };
        times * evidence::relief(number, &template.priors, scale, per_number)
    });
    each.sum()
}

impl FamilyStructure {
    /// Refits a family from the start values of its hypothesis. Returns `None` if the family gives no finite force.
    pub fn fit(
        hypothesis: FamilyHypothesis,
        components: Vec<Component>,
        settings: &[SettingTests],
        effort: Effort,
    ) -> Option<FamilyStructure> {
        let refit = hypothesis.refit(settings, effort)?;
        let hypothesis = hypothesis.starting_at(&refit.theta);
        let evidence = evidence(&hypothesis, &refit.theta, &refit.residuals, settings);
        let log_posterior = evidence.log_evidence() + log_prior_of(&hypothesis, &components);
        Some(FamilyStructure { hypothesis, components, refit, evidence, log_posterior })
    }

    /// Returns the sites that depend on the setting.
    pub fn varying(&self) -> Vec<Site> {
        varying_sites(&self.hypothesis.template, &self.hypothesis.varies)
    }

    /// Removes the effect with the index `place` from the family and refits. Returns `None` if the family gives no
    /// finite force.
    pub fn without(&self, place: usize, settings: &[SettingTests], effort: Effort) -> Option<FamilyStructure> {
        let varying = self.varying();
        let from = &self.hypothesis;
        let component = &self.components[place];
        let at = |setting: usize| component.remove(&from.template, &from.theta_at(&self.refit.theta, setting));
        let template = at(0);
        let starts = (0..from.settings()).map(|setting| at(setting).start()).collect();
        let mut components = self.components.clone();
        components.remove(place);
        let hypothesis = FamilyHypothesis { varies: varies(&template, &varying), template, starts };
        FamilyStructure::fit(hypothesis, components, settings, effort)
    }
}
