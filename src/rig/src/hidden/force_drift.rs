//! Injected measurement error: the load cell's zero drifts over the campaign.

use super::{DamperEffect, Recipe};
use crate::neutral::Here;

const FORMS: &[&str] = &["linear", "warm_up"];

struct Drift {
    form: usize,
    /// Total drift over the campaign, N.
    drift_n: f64,
    campaign_s: f64,
    /// Time constant of the warm-up, as a fraction of the campaign's duration.
    warm_up: f64,
}

impl DamperEffect for Drift {
    fn cell_n(&self, force_n: f64, here: &Here, _states: &[f64]) -> f64 {
        let share = here.line.clock_s / self.campaign_s;
        force_n + self.drift_n * if self.form == 0 { share } else { 1.0 - libm::exp(-share / self.warm_up) }
    }
}

pub(super) fn draw(recipe: &mut Recipe) -> Box<dyn DamperEffect> {
    let form = recipe.form(FORMS);
    let campaign_s = recipe.campaign_s;
    let draw = &mut recipe.draw;
    let size_n = recipe.strength * draw.between("drift_n", 30.0, 80.0);
    let sign = if draw.between("sign", -1.0, 1.0) < 0.0 { -1.0 } else { 1.0 };
    Box::new(Drift { form, drift_n: sign * size_n, campaign_s, warm_up: draw.between("warm_up_share", 0.1, 0.3) })
}
