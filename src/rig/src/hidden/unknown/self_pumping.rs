//! Injected unknown effect: like a leveling damper, the damper builds up pressure in motion and loses it at standstill.

use super::{DamperEffect, Recipe};
use crate::neutral::{Here, Rest};

const FORMS: &[&str] = &["levelling"];

struct Pumping {
    force_n: f64,
    travel_m: f64,
    sinking_s: f64,
}

impl DamperEffect for Pumping {
    fn tolerances(&self) -> &[f64] {
        // The state is the pressure that motion has built up, as a fraction of the full pressure.
        &[1e-5]
    }

    fn begin(&self, _rest: &Rest, _states: &mut [f64]) {}

    fn pause(&self, seconds: f64, states: &mut [f64]) {
        states[0] *= libm::exp(-seconds / self.sinking_s);
    }

    fn rates(&self, here: &Here, states: &[f64], rates: &mut [f64]) {
        let pumped = here.line.velocity_m_s.max(0.0) / self.travel_m;
        rates[0] = pumped * (1.0 - states[0]) - states[0] / self.sinking_s;
    }

    fn parallel_force_n(&self, _here: &Here, states: &[f64]) -> f64 {
        -self.force_n * states[0]
    }
}

pub(super) fn draw(recipe: &mut Recipe) -> Box<dyn DamperEffect> {
    recipe.form(FORMS);
    let strength = recipe.strength;
    let draw = &mut recipe.draw;
    Box::new(Pumping {
        force_n: strength * draw.between("force_n", 80.0, 200.0),
        travel_m: draw.ratio("travel_m", 0.15, 0.5),
        sinking_s: draw.ratio("sinking_s", 2.0, 10.0),
    })
}
