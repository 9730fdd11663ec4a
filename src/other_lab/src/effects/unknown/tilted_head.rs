//! Injected unknown effect: a tilted crosshead of the rig converts a part of the axial force to friction in the
//! damper's guides.

use super::{Draw, Effect, EffectModel, Here, Make, Scale, soft_sign};

pub(super) const EFFECT: Effect = Effect { name: "tilted_head", laws: &[("wedge", wedge as Make)] };

/// Wedge friction, proportional to the hydraulic force. Extension lengthens the lever arm and thus increases the
/// friction (Deubel & Prokop 2023).
struct Wedge {
    share: f64,
    lever: f64,
}

impl EffectModel for Wedge {
    fn parallel(&self, here: &Here, _: &[f64]) -> f64 {
        let load = (here.hydraulic * here.hydraulic + 900.0).sqrt() - 30.0;
        self.share * (1.0 + self.lever * here.x) * load * soft_sign(here.v, 2e-3)
    }
}

fn wedge(strength: f64, _: &Scale, d: &mut Draw) -> Box<dyn EffectModel> {
    Box::new(Wedge { share: strength * d.between(0.06, 0.12), lever: d.between(3.0, 8.0) })
}
