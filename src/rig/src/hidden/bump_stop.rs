//! A stop at the end of compression: polyurethane that stiffens exponentially, or a closing hydraulic gap.

use super::{Hidden, Recipe, stop};

pub(super) fn draw(recipe: &mut Recipe) -> Box<dyn Hidden> {
    stop::draw(-1.0, recipe)
}
