//! Injected effect of a stop at the end of compression: exponentially stiffening polyurethane, or a closing hydraulic
//! gap.

use super::{Hidden, Recipe, stop};

pub(super) fn draw(recipe: &mut Recipe) -> Box<dyn Hidden> {
    stop::draw(-1.0, recipe)
}
