//! Injected unknown effect: after a standstill, the force of the damper is reduced over an initial travel.

use super::{DamperEffect, Recipe};
use crate::neutral::{Here, Rest};

const FORMS: &[&str] = &["travel"];

struct StartUp {
    missing: f64,
    travel_m: f64,
}

impl DamperEffect for StartUp {
    fn tolerances(&self) -> &[f64] {
        // The state is the distance traveled since the start of the test, m.
        &[1e-5]
    }

    fn begin(&self, _rest: &Rest, states: &mut [f64]) {
        states.fill(0.0);
    }

    fn rates(&self, here: &Here, _states: &[f64], rates: &mut [f64]) {
        rates[0] = here.line.velocity_m_s.abs();
    }

    fn resistance(&self, _here: &Here, states: &[f64]) -> f64 {
        1.0 / (1.0 + self.missing * libm::exp(-states[0] / self.travel_m))
    }
}

pub(super) fn draw(recipe: &mut Recipe) -> Box<dyn DamperEffect> {
    recipe.form(FORMS);
    let strength = recipe.strength;
    let draw = &mut recipe.draw;
    Box::new(StartUp {
        missing: strength * draw.between("missing", 0.4, 0.8),
        travel_m: draw.ratio("travel_m", 0.15, 0.6),
    })
}
