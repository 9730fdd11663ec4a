//! Injected effect of a stop at the end of the compression stroke; [`super::stop`] contains its laws.

use super::{Effect, EffectModel, Make, stop};
use crate::draw::Draw;
use crate::plant::Scale;

pub(super) const EFFECT: Effect = Effect { name: "bump_stop", laws: &[("foam", foam as Make), ("holes", holes)] };

fn foam(strength: f64, scale: &Scale, d: &mut Draw) -> Box<dyn EffectModel> {
    stop::foam(strength, scale, d, -1.0)
}

fn holes(strength: f64, scale: &Scale, d: &mut Draw) -> Box<dyn EffectModel> {
    stop::holes(strength, scale, d, -1.0)
}
