//! Injected unknown effect: a tilted crosshead of the rig converts a part of the axial force to side force on the
//! damper's guides.

use super::{DamperEffect, Recipe};
use crate::neutral::Here;

const FORMS: &[&str] = &["tilt"];

struct Tilt {
    share: f64,
}

impl DamperEffect for Tilt {
    fn friction_n(&self, here: &Here, _states: &[f64]) -> f64 {
        // The axial force without friction acts as side force. It is smoothed around zero over 20 N.
        self.share * (libm::hypot(here.oil_n, 20.0) - 20.0) * (1.0 + here.line.displacement_m / 0.12)
    }
}

pub(super) fn draw(recipe: &mut Recipe) -> Box<dyn DamperEffect> {
    recipe.form(FORMS);
    Box::new(Tilt { share: recipe.strength * recipe.draw.between("share", 0.04, 0.10) })
}
