//! Injected effect of additional friction near standstill, which falls with velocity.

use super::{DamperEffect, Recipe};
use crate::neutral::Here;

const FORMS: &[&str] = &["hess_soom", "tustin"];

struct Stribeck {
    form: usize,
    excess_n: f64,
    velocity_m_s: f64,
}

impl DamperEffect for Stribeck {
    fn friction_n(&self, here: &Here, _states: &[f64]) -> f64 {
        let share = here.line.velocity_m_s.abs() / self.velocity_m_s;
        self.excess_n * if self.form == 0 { 1.0 / (1.0 + share * share) } else { libm::exp(-share) }
    }
}

pub(super) fn draw(recipe: &mut Recipe) -> Box<dyn DamperEffect> {
    let form = recipe.form(FORMS);
    let sliding = recipe.neutral.friction.sliding_n;
    Box::new(Stribeck {
        form,
        excess_n: recipe.strength * sliding * recipe.draw.between("excess_share", 0.5, 0.9),
        velocity_m_s: recipe.draw.ratio("velocity_m_s", 6e-3, 25e-3),
    })
}
