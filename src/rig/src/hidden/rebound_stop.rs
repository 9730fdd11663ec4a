//! Injected effect of a stop at the end of rebound: a rubber ring on the rod, or a ring that closes an oil gap.

use super::{Hidden, Recipe, stop};

pub(super) fn draw(recipe: &mut Recipe) -> Box<dyn Hidden> {
    stop::draw(1.0, recipe)
}
