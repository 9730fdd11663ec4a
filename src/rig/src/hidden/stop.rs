//! Common code of bump stop and rebound stop: compressed rubber, or an oil gap that closes.

use super::{DamperEffect, Recipe};
use crate::neutral::{Here, Rest};

const FORMS: &[&str] = &["rubber", "hydraulic"];

pub(super) struct Stop {
    form: usize,
    /// +1 at full extension, -1 at full compression.
    side: f64,
    /// Displacement toward the stop at which it makes contact, m.
    touched_m: f64,
    /// F1 of the rubber force `F1 (exp(d / d1) - 1)`, N, at the depth d beyond the contact, m. `growth_m` is d1, m.
    force_n: f64,
    growth_m: f64,
    /// Ratio of the relaxing force to the static force of the rubber, and relaxation time constant (s): a Maxwell
    /// element in parallel (Zener model).
    relaxing: f64,
    relaxation_s: f64,
    /// Hydraulic stop: force at 1 m/s in the fully covered but still open gap (N), and length over which the gap closes
    /// (m).
    resistance_n: f64,
    closing_m: f64,
}

impl Stop {
    fn depth(&self, here: &Here) -> f64 {
        (self.side * here.line.displacement_m - self.touched_m).max(0.0)
    }

    fn rubber_n(&self, depth: f64) -> f64 {
        self.force_n * libm::expm1(depth / self.growth_m)
    }
}

impl DamperEffect for Stop {
    fn tolerances(&self) -> &[f64] {
        // The state is the relaxed part of the Maxwell element's compression, m.
        if self.form == 0 { &[1e-7] } else { &[] }
    }

    fn begin(&self, rest: &Rest, states: &mut [f64]) {
        for state in states {
            *state = (self.side * rest.displacement_m - self.touched_m).max(0.0);
        }
    }

    fn rates(&self, here: &Here, states: &[f64], rates: &mut [f64]) {
        if self.form == 0 {
            rates[0] = (self.depth(here) - states[0]) / self.relaxation_s;
        }
    }

    fn parallel_force_n(&self, here: &Here, states: &[f64]) -> f64 {
        let depth = self.depth(here);
        if depth == 0.0 {
            return 0.0;
        }
        let force = if self.form == 0 {
            // The Maxwell element has the force curve of the rubber, scaled by `relaxing`. Rubber can push but not
            // pull.
            (self.rubber_n(depth) + self.relaxing * (self.rubber_n(depth) - self.rubber_n(states[0]))).max(0.0)
        } else {
            let speed = (self.side * here.line.velocity_m_s).max(0.0);
            let left = (1.0 - depth / self.closing_m).max(0.12);
            // The laminar part of the force is inversely proportional to the cube of the gap, the orifice part to its
            // square. Both parts increase with the covered length.
            let covered = depth / (depth + 2e-3);
            self.resistance_n * covered * (0.3 * speed / left.powi(3) + 0.7 * speed * speed / left.powi(2))
        };
        self.side * force
    }
}

pub(super) fn draw(side: f64, recipe: &mut Recipe) -> Box<dyn DamperEffect> {
    let form = recipe.form(FORMS);
    let strength = recipe.strength;
    let draw = &mut recipe.draw;
    Box::new(Stop {
        form,
        side,
        touched_m: draw.between("touched_m", 26e-3, 38e-3),
        force_n: strength * draw.ratio("force_n", 80.0, 200.0),
        growth_m: draw.between("growth_m", 6e-3, 11e-3),
        relaxing: draw.between("relaxing_share", 0.1, 0.35),
        relaxation_s: draw.ratio("relaxation_s", 0.01, 0.2),
        resistance_n: strength * draw.ratio("resistance_n", 500.0, 1200.0),
        closing_m: draw.between("closing_m", 30e-3, 45e-3),
    })
}
