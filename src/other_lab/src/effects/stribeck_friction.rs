//! Injected effect of friction with a peak near standstill.

use super::{Effect, EffectModel, Here, Make, soft_sign};
use crate::draw::Draw;
use crate::plant::Scale;

pub(super) const EFFECT: Effect =
    Effect { name: "stribeck_friction", laws: &[("makkar", makkar as Make), ("film_lag", film_lag)] };

/// Friction as a difference of two hyperbolic tangents of the velocity (Makkar, Dixon, Sawyer & Hu, AIM 2005).
struct Makkar {
    force: f64,
    rises: f64,
    falls: f64,
}

impl EffectModel for Makkar {
    fn parallel(&self, here: &Here, _: &[f64]) -> f64 {
        self.force * (libm::tanh(here.v / self.rises) - libm::tanh(here.v / self.falls))
    }
}

fn makkar(strength: f64, scale: &Scale, d: &mut Draw) -> Box<dyn EffectModel> {
    Box::new(Makkar {
        force: strength * scale.friction_n.max(25.0) * d.between(1.2, 2.2),
        rises: d.scale(8e-4, 2.5e-3),
        falls: d.scale(1.5e-2, 4e-2),
    })
}

/// Friction with a lag of the oil film, which builds up and is squeezed out with a delay.
///
/// The friction therefore depends on an earlier velocity (Hess & Soom, J. Tribology 112, 1990; frictional memory in
/// Armstrong-Hélouvry et al., Automatica 30, 1994).
struct FilmLag {
    force: f64,
    stribeck: f64,
    within: f64,
    time: f64,
}

impl EffectModel for FilmLag {
    fn tolerances(&self) -> &[f64] {
        &[1e-4]
    }
    fn rates(&self, here: &Here, s: &[f64], r: &mut [f64]) {
        r[0] = (libm::hypot(here.v, 1e-4) - s[0]) / self.time;
    }
    fn parallel(&self, here: &Here, s: &[f64]) -> f64 {
        self.force * soft_sign(here.v, self.within) / (1.0 + libm::pow((s[0] / self.stribeck).abs(), 1.5))
    }
}

fn film_lag(strength: f64, scale: &Scale, d: &mut Draw) -> Box<dyn EffectModel> {
    Box::new(FilmLag {
        force: strength * scale.friction_n.max(25.0) * d.between(1.0, 2.0),
        stribeck: d.scale(1e-2, 3e-2),
        within: d.scale(5e-4, 1.5e-3),
        time: d.scale(4e-3, 2e-2),
    })
}
