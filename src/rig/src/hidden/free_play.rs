//! Injected effect of play in the series spring (the mount): a range of deflection without force.

use super::{DamperEffect, Recipe};

const FORMS: &[&str] = &["hard", "hertz"];

struct FreePlay {
    form: usize,
    /// Half of the play, m.
    half_m: f64,
    /// Penetration over which the series damper engages after contact, m.
    engaging_m: f64,
    /// Penetration over which the contact stiffness approaches the full stiffness of the series spring, m (form
    /// `hertz`).
    contact_m: f64,
}

impl DamperEffect for FreePlay {
    fn gap(&self, deflection_m: f64) -> Option<(f64, f64)> {
        let depth = (deflection_m.abs() - self.half_m).max(0.0);
        let engaged = depth / (depth + self.engaging_m);
        let past = if self.form == 0 { depth } else { depth * (depth / (depth + self.contact_m)).sqrt() };
        Some((past.copysign(deflection_m), engaged))
    }
}

pub(super) fn draw(recipe: &mut Recipe) -> Box<dyn DamperEffect> {
    let form = recipe.form(FORMS);
    let half_m = recipe.strength * recipe.draw.ratio("half_play_m", 0.06e-3, 0.18e-3);
    let contact = recipe.draw.between("contact_share", 0.2, 0.8);
    Box::new(FreePlay { form, half_m, engaging_m: 0.1 * half_m, contact_m: contact * half_m })
}
