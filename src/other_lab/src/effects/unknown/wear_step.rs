//! Injected unknown effect: a valve disc cracks during the campaign. After that, the damper is softer in one direction.

use super::{Draw, Effect, EffectModel, Here, Make, Scale};

pub(super) const EFFECT: Effect = Effect { name: "wear_step", laws: &[("cracked_disc", cracked_disc as Make)] };

/// Increased flow through the valves of one direction, from a random time of the campaign on.
struct CrackedDisc {
    more: f64,
    from: f64,
    side: f64,
}

impl EffectModel for CrackedDisc {
    fn gain(&self, here: &Here, _: &[f64]) -> f64 {
        if here.progress < self.from {
            return 1.0;
        }
        1.0 + self.more * 0.5 * (1.0 + libm::tanh(self.side * here.hydraulic / 20.0))
    }
}

fn cracked_disc(strength: f64, _: &Scale, d: &mut Draw) -> Box<dyn EffectModel> {
    Box::new(CrackedDisc { more: strength * d.between(0.25, 0.6), from: d.between(0.3, 0.7), side: d.sign() })
}
