//! Injected unknown effect: the current of the rig's servo valve couples into the force channel at three times the
//! frequency of the motion.

use super::{DamperEffect, Recipe};
use crate::neutral::Here;

const FORMS: &[&str] = &["crosstalk"];

struct Crosstalk {
    per_m_s_n: f64,
}

impl DamperEffect for Crosstalk {
    fn cell_n(&self, force_n: f64, here: &Here, _states: &[f64]) -> f64 {
        // cos 3a = 4 cos³ a - 3 cos a, where the velocity relative to its peak is cos a.
        let peak = here.line.peak_velocity_m_s;
        let cos = (here.line.velocity_m_s / peak).clamp(-1.2, 1.2);
        force_n + self.per_m_s_n * peak * (4.0 * cos * cos * cos - 3.0 * cos)
    }
}

pub(super) fn draw(recipe: &mut Recipe) -> Box<dyn DamperEffect> {
    recipe.form(FORMS);
    Box::new(Crosstalk { per_m_s_n: recipe.strength * recipe.draw.between("per_m_s_n", 60.0, 150.0) })
}
