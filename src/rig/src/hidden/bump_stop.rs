//! Injected effect of a stop at the end of compression: exponentially stiffening polyurethane, or a closing hydraulic
//! gap.

use super::{DamperEffect, Recipe, stop};

pub(super) fn draw(recipe: &mut Recipe) -> Box<dyn DamperEffect> {
    stop::draw(-1.0, recipe)
}
