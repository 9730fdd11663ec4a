//! Injected effect of presliding: friction reverses over a distance after each reversal of motion, because seal lips
//! and guide bands deflect before they slide.

use super::{DamperEffect, Recipe};
use crate::neutral::Here;

const FORMS: &[&str] = &["elasto_plastic", "maxwell_slip"];
const ELEMENTS: usize = 5;
/// Coefficient with which the strength of the effect reduces the creep of the friction force at standstill.
///
/// The smoothing velocity of the neutral friction is divided by `1 + CREEP_FADES * strength`.
const CREEP_FADES: f64 = 4.0;

struct Presliding {
    /// Length over which the friction force of each element builds up (m), and the element's fraction of the total
    /// friction force. The form `elasto_plastic` has one element.
    elements: Vec<(f64, f64)>,
    /// Fraction of the full load below which an element is purely elastic (Dupont's break-away ratio).
    elastic: f64,
    /// Velocity scale of the transition from creeping to sliding, m/s.
    smooth_m_s: f64,
    tolerances: Vec<f64>,
}

impl DamperEffect for Presliding {
    fn tolerances(&self) -> &[f64] {
        &self.tolerances
    }

    /// Computes the rates of the elements' loads, each from -1 to 1.
    ///
    /// In long motion, the load of even a soft element approaches the smooth sign of the velocity, `v / sqrt(v² +
    /// smooth_m_s²)`. At standstill, the load creeps with the velocity `smooth_m_s`.
    fn rates(&self, here: &Here, states: &[f64], rates: &mut [f64]) {
        let v = here.line.velocity_m_s;
        let speed = libm::hypot(v, self.smooth_m_s);
        let end = v / speed;
        for (index, (length, _)) in self.elements.iter().enumerate() {
            let load = states[index];
            // Sliding begins between the elastic fraction and the full load, and only in the direction of the load.
            let reached = load * end / (end * end + 1e-12);
            let sliding = if reached < 0.0 && end.abs() > 1e-3 {
                0.0
            } else {
                let share = ((reached.abs() - self.elastic) / (1.0 - self.elastic)).clamp(0.0, 1.0);
                share * share * (3.0 - 2.0 * share)
            };
            // An element does not slide against the direction of its load. Near standstill, only creep reduces the
            // load.
            let creep = (self.smooth_m_s / speed).powi(2);
            rates[index] = speed * (end - load * sliding.max(creep)) / length;
        }
    }

    fn friction_direction(&self, _here: &Here, states: &[f64]) -> Option<f64> {
        Some(self.elements.iter().zip(states).map(|((_, share), load)| share * load).sum())
    }
}

pub(super) fn draw(recipe: &mut Recipe) -> Box<dyn DamperEffect> {
    let form = recipe.form(FORMS);
    let strength = recipe.strength;
    let draw = &mut recipe.draw;
    let length = strength * draw.ratio("length_m", 0.15e-3, 0.5e-3);
    let (elements, elastic): (Vec<_>, f64) = if form == 0 {
        (vec![(length, 1.0)], draw.between("elastic_share", 0.2, 0.6))
    } else {
        let spread = draw.ratio("length_spread", 1.5, 2.2);
        let middle = (ELEMENTS / 2) as i32;
        let elements = (0..ELEMENTS)
            .map(|i| (length * spread.powi(i as i32 - middle), draw.between("share", 0.1, 0.3)))
            .collect::<Vec<_>>();
        let total: f64 = elements.iter().map(|(_, share)| share).sum();
        (elements.into_iter().map(|(length, share)| (length, share / total)).collect(), 0.9)
    };
    let tolerances = vec![1e-5; elements.len()];
    let smooth_m_s = recipe.neutral.friction.smooth_m_s / (1.0 + CREEP_FADES * strength);
    Box::new(Presliding { elements, elastic, smooth_m_s, tolerances })
}
