//! Inventory of a structure: each effect with its force and its probability, compared with another structure.

use super::component::Component;
use super::context::Structure;
use crate::gap::{rms, rms_of_tests};
use crate::hypothesis::Hypothesis;
use crate::samples::Test;
use crate::sensitivity::Accuracy;
use serde::Serialize;

/// Change of an effect from the given model (the user's) to the most probable model of the search.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Status {
    /// The effect is in both models.
    Kept,
    /// The effect is only in the most probable model.
    Added,
    /// The effect is only in the given model. An added effect of the most probable model gives a similar force instead.
    Replaced,
    /// The effect is only in the given model, and no added effect of the most probable model gives a similar force.
    Removed,
}

/// One effect of an inventory.
#[derive(Debug, Clone, Serialize)]
pub struct InventoryItem {
    /// Name of the effect.
    pub effect: &'static str,
    /// Form of the effect. Empty if the effect has only one form, or if the given model does not state the form.
    pub form: &'static str,
    /// Force of the effect, N rms over all fitted tests: the change of the force if only this effect is removed. If the
    /// model without the effect gives no finite force, this value is infinite for an effect of the most probable model.
    /// For an effect that is only in the given model, it is then 0.
    pub force_n_rms: f64,
    /// Ratio of the force of the effect to the root mean square of the measured force. The JSON key is `share`, because
    /// scripts depend on this name.
    #[serde(rename = "share")]
    pub fraction: f64,
    /// The force in each fitted test, N rms, in the order of the tests. Empty if the model with the effect removed
    /// gives no finite force.
    #[serde(skip)]
    pub test_forces_n: Vec<f64>,
    /// Probability that the damper has the effect.
    pub probability: f64,
    /// Change from the given model to the most probable model.
    pub status: Status,
    /// Effect of the given model that this effect replaces.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub replaces: Option<&'static str>,
    /// Another effect that may explain the records, if this effect is kept with a probability below one half.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub or_instead: Option<Instead>,
}

/// An effect that may explain the records instead of another effect.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Instead {
    /// Name of the effect.
    pub effect: &'static str,
    /// Probability that the damper has the effect.
    pub probability: f64,
}

/// Computes the forces of a hypothesis, N, with the parameters `theta`: one list for each test. The low-accuracy
/// integration is accurate enough for an inventory.
fn forces(of: &Hypothesis, tests: &[Test], theta: &[f64]) -> Option<Vec<Vec<f64>>> {
    of.forces_by(&of.model_by(Accuracy::Single, theta)?, tests, theta)
}

/// Computes the correlation of the forces of two components, one list for each test, without subtraction of their
/// means. Each test has the same weight.
fn alikeness(a: &[Vec<f64>], b: &[Vec<f64>]) -> f64 {
    let dot = |x: &[Vec<f64>], y: &[Vec<f64>]| -> f64 {
        x.iter().zip(y).map(|(x, y)| x.iter().zip(y).map(|(x, y)| x * y).sum::<f64>() / x.len().max(1) as f64).sum()
    };
    dot(a, b) / (dot(a, a) * dot(b, b)).sqrt().max(1e-300)
}

/// Computes the force of a component in each test, N, as the change due to its removal; `whole` contains the forces
/// with it. Returns `None` if the model with the component removed gives no finite force.
fn force_of(structure: &Structure, component: &Component, tests: &[Test], whole: &[Vec<f64>]) -> Option<Vec<Vec<f64>>> {
    let without = component.remove(&structure.hypothesis, &structure.refit.theta);
    let less = forces(&without, tests, &without.start())?;
    Some(whole.iter().zip(&less).map(|(a, b)| a.iter().zip(b).map(|(a, b)| a - b).collect()).collect())
}

/// Smallest correlation of the forces of two effects at which one effect counts as the replacement of the other.
const REPLACES: f64 = 0.5;

/// Makes the inventory of `best`, which states for each effect its change from a given model. Without a given model,
/// every effect counts as added. The inventory is empty if `best` gives no finite force. `probability` returns the
/// probability of an effect.
pub fn inventory(
    best: &Structure,
    given: Option<&Structure>,
    tests: &[Test],
    probability: &dyn Fn(&str) -> f64,
) -> Vec<InventoryItem> {
    let measured = rms_of_tests(&tests.iter().map(|t| t.forces().to_vec()).collect::<Vec<_>>());
    let whole_of = |structure: &Structure| forces(&structure.hypothesis, tests, &structure.refit.theta);
    let Some(whole) = whole_of(best) else { return Vec::new() };
    let is_in = |structure: &Structure, effect: &str| structure.components.iter().any(|c| c.effect == effect);
    // If the model with an effect removed gives no finite force, the list of test forces stays empty.
    let item = |component: &Component, force: Option<&[Vec<f64>]>, without: f64, status: Status| {
        let size = force.map_or(without, rms_of_tests);
        InventoryItem {
            effect: component.effect,
            form: component.form,
            force_n_rms: size,
            fraction: size / measured.max(1e-9),
            test_forces_n: force.map_or_else(Vec::new, |force| force.iter().map(|f| rms(f)).collect()),
            probability: probability(component.effect),
            status,
            replaces: None,
            or_instead: None,
        }
    };
    let of_best: Vec<Option<Vec<Vec<f64>>>> =
        best.components.iter().map(|component| force_of(best, component, tests, &whole)).collect();
    let mut all: Vec<InventoryItem> = best
        .components
        .iter()
        .zip(&of_best)
        .map(|(component, force)| {
            let is_new = given.is_none_or(|given| !is_in(given, component.effect));
            item(component, force.as_deref(), f64::INFINITY, if is_new { Status::Added } else { Status::Kept })
        })
        .collect();
    if let Some(given) = given {
        let whole = whole_of(given);
        for component in given.components.iter().filter(|component| !is_in(best, component.effect)) {
            let force = whole.as_ref().and_then(|whole| force_of(given, component, tests, whole));
            let place = force.as_ref().and_then(|force| {
                let added = of_best.iter().enumerate().filter(|(k, _)| all[*k].status == Status::Added);
                let likeness = added.filter_map(|(k, other)| Some((k, alikeness(force, other.as_ref()?))));
                likeness.filter(|(_, alike)| *alike > REPLACES).max_by(|a, b| a.1.total_cmp(&b.1))
            });
            if let Some((k, _)) = place {
                all[k].replaces = Some(component.effect);
            }
            let status = if place.is_some() { Status::Replaced } else { Status::Removed };
            all.push(item(component, force.as_deref(), 0.0, status));
        }
    }
    all.sort_by(|a, b| b.force_n_rms.total_cmp(&a.force_n_rms));
    all
}
