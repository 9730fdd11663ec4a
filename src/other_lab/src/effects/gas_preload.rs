//! Injected effect of an additional gas force that varies over the campaign or over the stroke.

use super::{Effect, EffectModel, Here, Make};
use crate::draw::Draw;
use crate::plant::Scale;

pub(super) const EFFECT: Effect =
    Effect { name: "gas_preload", laws: &[("leaking", leaking as Make), ("sticking_piston", sticking_piston)] };

/// A seal that leaks gas through an orifice: a part of the gas force decays exponentially over the campaign (choked
/// flow; Shigley, compressed-gas tables).
struct Leaking {
    force: f64,
    share: f64,
    per_campaign: f64,
}

impl EffectModel for Leaking {
    fn parallel(&self, here: &Here, _: &[f64]) -> f64 {
        -self.force * (1.0 - self.share + self.share * libm::exp(-self.per_campaign * here.progress))
    }
}

fn leaking(strength: f64, scale: &Scale, d: &mut Draw) -> Box<dyn EffectModel> {
    let force = strength * scale.gas_n.max(60.0) * d.between(0.5, 1.0);
    Box::new(Leaking { force, share: d.between(0.3, 0.6), per_campaign: d.between(1.0, 3.0) })
}

/// Friction of the O-ring of a floating piston. The friction maintains a pressure difference between gas and oil, which
/// reverses with the stroke.
///
/// The friction of the O-ring is 0.1 to 0.3 of the gas force (Karaszewski, Hydraulic seals).
struct StickingPiston {
    force: f64,
    stick: f64,
    length: f64,
}

impl EffectModel for StickingPiston {
    fn tolerances(&self) -> &[f64] {
        &[1e-3]
    }
    fn rates(&self, here: &Here, s: &[f64], r: &mut [f64]) {
        // After a reversal, the O-ring first rolls and then slides. The state is the friction relative to its largest
        // value.
        r[0] = (here.v - here.v.abs() * s[0].powi(3)) / self.length;
    }
    fn parallel(&self, _: &Here, s: &[f64]) -> f64 {
        self.force * (self.stick * s[0] - 1.0)
    }
}

fn sticking_piston(strength: f64, scale: &Scale, d: &mut Draw) -> Box<dyn EffectModel> {
    let force = strength * scale.gas_n.max(60.0) * d.between(0.4, 0.8);
    Box::new(StickingPiston { force, stick: d.between(0.1, 0.3), length: d.scale(4e-3, 1.2e-2) })
}
