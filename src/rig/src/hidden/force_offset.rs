//! Injected measurement error: the load cell's zero is wrong. A constant error is indistinguishable from gas preload,
//! but a change at a re-zeroing is distinguishable.

use super::{DamperEffect, Recipe};
use crate::neutral::Here;

const FORMS: &[&str] = &["constant", "step_at_re_zeroing"];

struct Offset {
    before_n: f64,
    after_n: f64,
    at_s: f64,
}

impl DamperEffect for Offset {
    fn cell_n(&self, force_n: f64, here: &Here, _states: &[f64]) -> f64 {
        force_n + if here.line.clock_s < self.at_s { self.before_n } else { self.after_n }
    }
}

pub(super) fn draw(recipe: &mut Recipe) -> Box<dyn DamperEffect> {
    let form = recipe.form(FORMS);
    let draw = &mut recipe.draw;
    let size_n = recipe.strength * draw.between("offset_n", 20.0, 50.0);
    let sign = if draw.between("sign", -1.0, 1.0) < 0.0 { -1.0 } else { 1.0 };
    let at_s = recipe.campaign_s * draw.between("at_share", 0.3, 0.7);
    let after_n = sign * size_n;
    Box::new(Offset { before_n: if form == 0 { after_n } else { 0.0 }, after_n, at_s })
}
