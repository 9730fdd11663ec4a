//! Injected unknown effect: a valve shim cracks during the campaign. After that, the damper has less force in one
//! direction.

use super::{DamperEffect, Recipe};
use crate::neutral::Here;

const FORMS: &[&str] = &["cracked_shim"];

struct Wear {
    missing: f64,
    /// Direction with less force: +1 rebound, -1 compression.
    side: f64,
    at_s: f64,
}

impl DamperEffect for Wear {
    fn resistance(&self, here: &Here, _states: &[f64]) -> f64 {
        if here.line.clock_s < self.at_s {
            return 1.0;
        }
        let force = self.side * here.oil_n;
        // In the direction opposite to `side`, the force is intact. The transition at zero force is smooth.
        let worn = 0.5 * (1.0 + force / libm::hypot(force, 60.0));
        1.0 / (1.0 + self.missing * worn)
    }
}

pub(super) fn draw(recipe: &mut Recipe) -> Box<dyn DamperEffect> {
    recipe.form(FORMS);
    let (strength, campaign_s) = (recipe.strength, recipe.campaign_s);
    let draw = &mut recipe.draw;
    Box::new(Wear {
        missing: strength * draw.between("missing", 0.10, 0.25),
        side: if draw.between("side", -1.0, 1.0) < 0.0 { -1.0 } else { 1.0 },
        at_s: campaign_s * draw.between("at_share", 0.3, 0.7),
    })
}
