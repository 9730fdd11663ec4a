//! Injected unknown effect: the rig's frame vibrates after every sudden change of force.

use super::{DamperEffect, Recipe};
use crate::neutral::{Here, Rest};

const FORMS: &[&str] = &["frame"];

struct Resonance {
    share: f64,
    omega: f64,
    damping: f64,
}

impl DamperEffect for Resonance {
    fn tolerances(&self) -> &[f64] {
        // The states are the force carried by the frame, N, and its rate, N/s.
        &[1e-2, 1.0]
    }

    fn begin(&self, _rest: &Rest, states: &mut [f64]) {
        states.fill(0.0);
    }

    fn rates(&self, here: &Here, states: &[f64], rates: &mut [f64]) {
        // Only the oil force, which is zero at the start of a test, excites the frame. The preload does not excite it.
        rates[0] = states[1];
        rates[1] = self.omega * (self.omega * (here.oil_n - states[0]) - 2.0 * self.damping * states[1]);
    }

    fn cell_n(&self, force_n: f64, here: &Here, states: &[f64]) -> f64 {
        force_n + self.share * (states[0] - here.oil_n)
    }
}

pub(super) fn draw(recipe: &mut Recipe) -> Box<dyn DamperEffect> {
    recipe.form(FORMS);
    let strength = recipe.strength;
    let draw = &mut recipe.draw;
    Box::new(Resonance {
        share: strength * draw.between("share", 0.06, 0.15),
        omega: std::f64::consts::TAU * draw.between("frequency_hz", 28.0, 60.0),
        damping: draw.between("damping", 0.03, 0.08),
    })
}
