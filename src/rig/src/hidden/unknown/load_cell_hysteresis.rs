//! Injected unknown effect: the load cell shows a larger force at rising load than at falling load.

use super::{DamperEffect, Recipe};
use crate::neutral::{Here, Rest};

const FORMS: &[&str] = &["rate_independent_loop"];

struct CellHysteresis {
    share: f64,
    width_n: f64,
}

impl DamperEffect for CellHysteresis {
    fn tolerances(&self) -> &[f64] {
        // The state is the center of the play operator that computes the hysteresis, N.
        &[1e-1]
    }

    fn begin(&self, _rest: &Rest, states: &mut [f64]) {
        states.fill(0.0);
    }

    fn rates(&self, here: &Here, states: &[f64], rates: &mut [f64]) {
        let lag = here.oil_n - states[0];
        rates[0] = (lag.abs() - self.width_n).max(0.0).copysign(lag) / 0.5e-3;
    }

    fn cell_n(&self, force_n: f64, here: &Here, states: &[f64]) -> f64 {
        let way = ((here.oil_n - states[0]) / self.width_n).clamp(-1.2, 1.2);
        force_n + self.share * here.oil_n.abs() * way
    }
}

pub(super) fn draw(recipe: &mut Recipe) -> Box<dyn DamperEffect> {
    recipe.form(FORMS);
    let strength = recipe.strength;
    let draw = &mut recipe.draw;
    Box::new(CellHysteresis {
        share: strength * draw.between("share", 0.02, 0.05),
        width_n: draw.between("width_n", 60.0, 200.0),
    })
}
