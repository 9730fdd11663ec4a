//! The inventory of a structure: each effect with the force it carries and its probability, beside another structure.

use super::component::Component;
use super::context::Structure;
use crate::hypothesis::Hypothesis;
use crate::samples::Test;
use crate::sensitivity::Accuracy;
use serde::Serialize;

/// What became of an effect.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Status {
    /// In the given model and in the most probable one.
    Kept,
    /// In the most probable model alone.
    Added,
    /// In the given model; another effect of the most probable one carries its force.
    Replaced,
    /// In the given model; the records do not ask for it.
    Removed,
}

/// One effect of an inventory.
#[derive(Debug, Clone, Serialize)]
pub struct InventoryItem {
    /// Name of the effect.
    pub effect: &'static str,
    /// Its form; empty where there is one, or where the given model does not say.
    pub form: &'static str,
    /// Force that it carries: root mean square over all fitted tests of what its removal changes, everything else kept, N.
    pub force_n_rms: f64,
    /// That force over the root mean square of the measured force.
    pub share: f64,
    /// The force in each fitted test, N rms, in the order of the tests; empty where the model gives none without the effect.
    #[serde(skip)]
    pub force_by_test_n: Vec<f64>,
    /// Probability that the damper has it.
    pub probability: f64,
    /// What became of it.
    pub status: Status,
    /// Effect of the given model in whose place it stands.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub replaces: Option<&'static str>,
}

/// Root mean square over tests of each test's root mean square.
fn rms(of_tests: impl Iterator<Item = f64>) -> f64 {
    let (sum, count) = of_tests.fold((0.0, 0), |(sum, count), square| (sum + square, count + 1));
    (sum / f64::from(count.max(1))).sqrt()
}

fn mean_square(values: impl Iterator<Item = f64>) -> f64 {
    let (sum, count) = values.fold((0.0, 0usize), |(sum, count), v| (sum + v * v, count + 1));
    sum / count.max(1) as f64
}

/// Forces of a hypothesis at `theta`, the cheap integration being exact enough for an account.
fn forces(of: &Hypothesis, tests: &[Test], theta: &[f64]) -> Option<Vec<Vec<f64>>> {
    of.forces_by(&of.model_by(Accuracy::Single, theta)?, tests, theta)
}

/// Mean square of the force that a component carries in each test, N²; `None` where the model gives no force without it.
fn carried(structure: &Structure, component: &Component, tests: &[Test], whole: &[Vec<f64>]) -> Option<Vec<f64>> {
    let without = component.remove(&structure.hypothesis, &structure.refit.theta);
    let less = forces(&without, tests, &without.start())?;
    Some(whole.iter().zip(&less).map(|(a, b)| mean_square(a.iter().zip(b).map(|(a, b)| a - b))).collect())
}

/// Root of each mean square.
fn roots(squares: &[f64]) -> Vec<f64> {
    squares.iter().map(|square| square.sqrt()).collect()
}

/// How much of the force of one component another carries: what both leave where the model stands, by correlation of their forces.
fn alikeness(a: &[Vec<f64>], b: &[Vec<f64>]) -> f64 {
    let dot = |x: &[Vec<f64>], y: &[Vec<f64>]| -> f64 {
        x.iter().zip(y).map(|(x, y)| x.iter().zip(y).map(|(x, y)| x * y).sum::<f64>() / x.len().max(1) as f64).sum()
    };
    dot(a, b) / (dot(a, a) * dot(b, b)).sqrt().max(1e-300)
}

fn force_of(structure: &Structure, component: &Component, tests: &[Test]) -> Option<Vec<Vec<f64>>> {
    let whole = forces(&structure.hypothesis, tests, &structure.refit.theta)?;
    let without = component.remove(&structure.hypothesis, &structure.refit.theta);
    let less = forces(&without, tests, &without.start())?;
    Some(whole.iter().zip(&less).map(|(a, b)| a.iter().zip(b).map(|(a, b)| a - b).collect()).collect())
}

/// Correlation of the forces of two effects from which one is said to replace the other.
const REPLACES: f64 = 0.5;

/// The inventory of `best` beside a given model; without one, every effect counts as added.
pub fn inventory(
    best: &Structure,
    given: Option<&Structure>,
    tests: &[Test],
    probability: &dyn Fn(&str) -> f64,
) -> Vec<InventoryItem> {
    let measured = rms(tests.iter().map(|t| mean_square(t.forces().iter().copied())));
    let Some(whole) = forces(&best.hypothesis, tests, &best.refit.theta) else { return Vec::new() };
    let is_in = |structure: &Structure, effect: &str| structure.components.iter().any(|c| c.effect == effect);
    let gone: Vec<&Component> =
        given.iter().flat_map(|given| &given.components).filter(|component| !is_in(best, component.effect)).collect();
    let mut all: Vec<InventoryItem> = best
        .components
        .iter()
        .map(|component| {
            let squares = carried(best, component, tests, &whole);
            let force = squares.as_ref().map_or(f64::INFINITY, |squares| rms(squares.iter().copied()));
            let is_new = given.is_none_or(|given| !is_in(given, component.effect));
            InventoryItem {
                effect: component.effect,
                form: component.form,
                force_n_rms: force,
                share: force / measured.max(1e-9),
                force_by_test_n: squares.as_deref().map_or_else(Vec::new, roots),
                probability: probability(component.effect),
                status: if is_new { Status::Added } else { Status::Kept },
                replaces: None,
            }
        })
        .collect();
    if let Some(given) = given {
        let added: Vec<(usize, Vec<Vec<f64>>)> = best
            .components
            .iter()
            .enumerate()
            .filter(|(k, _)| all[*k].status == Status::Added)
            .filter_map(|(k, component)| Some((k, force_of(best, component, tests)?)))
            .collect();
        for component in gone {
            let force = force_of(given, component, tests);
            let squares: Option<Vec<f64>> =
                force.as_ref().map(|force| force.iter().map(|f| mean_square(f.iter().copied())).collect());
            let size = squares.as_ref().map_or(0.0, |squares| rms(squares.iter().copied()));
            let place = force.as_ref().and_then(|force| {
                let likeness = added.iter().map(|(k, other)| (*k, alikeness(force, other)));
                likeness.filter(|(_, alike)| *alike > REPLACES).max_by(|a, b| a.1.total_cmp(&b.1))
            });
            if let Some((k, _)) = place {
                all[k].replaces = Some(component.effect);
            }
            all.push(InventoryItem {
                effect: component.effect,
                form: component.form,
                force_n_rms: size,
                share: size / measured.max(1e-9),
                force_by_test_n: squares.as_deref().map_or_else(Vec::new, roots),
                probability: probability(component.effect),
                status: if place.is_some() { Status::Replaced } else { Status::Removed },
                replaces: None,
            });
        }
    }
    all.sort_by(|a, b| b.force_n_rms.total_cmp(&a.force_n_rms));
    all
}
