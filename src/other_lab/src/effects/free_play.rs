//! Injected effect of free play: an eye or mount of the damper with a gap.

use super::{Effect, EffectModel, Here, Make};
use crate::draw::Draw;
use crate::plant::Scale;

pub(super) const EFFECT: Effect =
    Effect { name: "free_play", laws: &[("worn_eye", worn_eye as Make), ("offset_gap", offset_gap)] };

/// A gap that closes gradually: its deflection at the force F, N, is g tanh(F/F_0). Here, g is half the play, m, and
/// F_0 the force scale of the closing, N.
///
/// (Kogan, free-play smoothing; Kim, Rook & Singh, J. Sound Vib. 263, 2003, on smoothened clearances.)
struct WornEye {
    gap: f64,
    force: f64,
}

impl EffectModel for WornEye {
    fn series(&self, here: &Here, _: &[f64]) -> f64 {
        let t = libm::tanh(here.mount / self.force);
        self.gap / self.force * (1.0 - t * t)
    }
}

fn worn_eye(strength: f64, _: &Scale, d: &mut Draw) -> Box<dyn EffectModel> {
    Box::new(WornEye { gap: strength * d.between(1.5e-4, 3.5e-4), force: d.scale(15.0, 50.0) })
}

/// A gap that weight or clamping shifts, so that it opens at a nonzero force.
///
/// The contact law is that of a distribution of surface asperities (Greenwood & Williamson, Proc. R. Soc. A 295, 1966).
struct OffsetGap {
    gap: f64,
    at: f64,
    force: f64,
}

impl EffectModel for OffsetGap {
    fn series(&self, here: &Here, _: &[f64]) -> f64 {
        let r = (here.mount - self.at) / self.force;
        2.0 * self.gap / (self.force * std::f64::consts::PI.sqrt()) * libm::exp(-r * r)
    }
}

fn offset_gap(strength: f64, scale: &Scale, d: &mut Draw) -> Box<dyn EffectModel> {
    Box::new(OffsetGap {
        gap: strength * d.between(1.5e-4, 3.5e-4),
        at: d.sign() * d.between(0.02, 0.06) * scale.rebound_n,
        force: d.scale(15.0, 50.0),
    })
}
