//! Injected effect of viscous friction in sheared oil films.

use super::{Effect, EffectModel, Here, Make};
use crate::draw::Draw;
use crate::plant::Scale;

pub(super) const EFFECT: Effect =
    Effect { name: "viscous_friction", laws: &[("cross_film", cross_film as Make), ("blasius_drag", blasius_drag)] };

/// Friction of a shear-thinning oil film (Cross, J. Colloid Sci. 20, 1965).
struct CrossFilm {
    per_speed: f64,
    speed: f64,
    power: f64,
}

impl EffectModel for CrossFilm {
    fn parallel(&self, here: &Here, _: &[f64]) -> f64 {
        self.per_speed * here.v / (1.0 + libm::pow(here.v.abs() / self.speed, self.power))
    }
}

fn cross_film(strength: f64, scale: &Scale, d: &mut Draw) -> Box<dyn EffectModel> {
    let per_speed = strength * d.between(0.3, 0.8) * (scale.rebound_n + scale.compression_n);
    Box::new(CrossFilm { per_speed, speed: d.scale(0.1, 0.5), power: d.between(0.6, 0.9) })
}

/// Drag in a long smooth gap, proportional to |v|^1.75 with the velocity v (Blasius 1913).
struct BlasiusDrag {
    factor: f64,
}

impl EffectModel for BlasiusDrag {
    fn parallel(&self, here: &Here, _: &[f64]) -> f64 {
        self.factor * here.v * libm::pow(here.v * here.v + 1e-6, 0.375)
    }
}

fn blasius_drag(strength: f64, scale: &Scale, d: &mut Draw) -> Box<dyn EffectModel> {
    Box::new(BlasiusDrag { factor: strength * d.between(0.3, 0.8) * (scale.rebound_n + scale.compression_n) })
}
