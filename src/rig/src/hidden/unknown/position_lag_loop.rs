//! Injected unknown effect: a force that depends on the lag behind position and saturates, such as that of eddy
//! currents in a nearby part.

use super::{DamperEffect, Recipe};
use crate::neutral::{Here, Rest};

const FORMS: &[&str] = &["saturating_lag"];

struct LagLoop {
    force_n: f64,
    time_s: f64,
    width_m: f64,
}

impl DamperEffect for LagLoop {
    fn tolerances(&self) -> &[f64] {
        // The state is the lagged position, m.
        &[1e-6]
    }

    fn begin(&self, rest: &Rest, states: &mut [f64]) {
        states[0] = rest.displacement_m;
    }

    fn rates(&self, here: &Here, states: &[f64], rates: &mut [f64]) {
        rates[0] = (here.line.displacement_m - states[0]) / self.time_s;
    }

    fn parallel_force_n(&self, here: &Here, states: &[f64]) -> f64 {
        // If position and lagged position differ by more than `width_m`, the coupling of the field weakens, and the
        // force decreases again.
        let trail = (here.line.displacement_m - states[0]) / self.width_m;
        self.force_n * 2.0 * trail / (1.0 + trail * trail)
    }
}

pub(super) fn draw(recipe: &mut Recipe) -> Box<dyn DamperEffect> {
    recipe.form(FORMS);
    let strength = recipe.strength;
    let draw = &mut recipe.draw;
    Box::new(LagLoop {
        force_n: strength * draw.between("force_n", 60.0, 150.0),
        time_s: draw.ratio("time_s", 0.02, 0.2),
        width_m: draw.ratio("width_m", 2e-3, 8e-3),
    })
}
