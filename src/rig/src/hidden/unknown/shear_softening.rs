//! Injected unknown effect: continuous shear reduces the viscosity of the oil, which recovers at standstill within
//! seconds.

use super::{DamperEffect, Recipe};
use crate::neutral::{Here, Rest};

const FORMS: &[&str] = &["thixotropy"];

struct Softening {
    depth: f64,
    time_s: f64,
    half_m_s: f64,
}

impl DamperEffect for Softening {
    fn tolerances(&self) -> &[f64] {
        // The state is the low-pass filtered magnitude of the velocity, m/s.
        &[1e-5]
    }

    fn begin(&self, _rest: &Rest, _states: &mut [f64]) {}

    fn pause(&self, seconds: f64, states: &mut [f64]) {
        states[0] *= libm::exp(-seconds / self.time_s);
    }

    fn rates(&self, here: &Here, states: &[f64], rates: &mut [f64]) {
        rates[0] = (here.velocity_m_s.abs() - states[0]) / self.time_s;
    }

    fn resistance(&self, _here: &Here, states: &[f64]) -> f64 {
        let share = states[0] / (states[0] + self.half_m_s);
        1.0 / (1.0 + self.depth * share)
    }
}

pub(super) fn draw(recipe: &mut Recipe) -> Box<dyn DamperEffect> {
    recipe.form(FORMS);
    let strength = recipe.strength;
    let draw = &mut recipe.draw;
    Box::new(Softening {
        depth: strength * draw.between("depth", 0.3, 0.6),
        time_s: draw.ratio("time_s", 0.4, 3.0),
        half_m_s: draw.ratio("half_m_s", 0.1, 0.3),
    })
}
