//! Injected effect of a stop at the end of rebound: a rubber ring on the rod, or a ring that closes an oil gap.

use super::{DamperEffect, Recipe, stop};

pub(super) fn draw(recipe: &mut Recipe) -> Box<dyn DamperEffect> {
    stop::draw(1.0, recipe)
}
