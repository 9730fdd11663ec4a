//! Injected unknown effect: oil with additives that gels at standstill.
//!
//! After a standstill, the damper is firmer over some travel, so the effect is larger in small strokes.

use super::{Draw, Effect, EffectModel, Here, Make, Scale};

pub(super) const EFFECT: Effect = Effect { name: "resting_gel", laws: &[("moore", moore as Make)] };

/// A structure that breaks down under shear and recovers at standstill (Moore, Trans. Brit. Ceram. Soc. 58, 1959;
/// Barnes, J. Non-Newton. Fluid Mech. 70, 1997).
struct Moore {
    stiffer: f64,
    breaks: f64,
    restores: f64,
}

impl EffectModel for Moore {
    fn tolerances(&self) -> &[f64] {
        &[1e-3]
    }
    fn rates(&self, here: &Here, s: &[f64], r: &mut [f64]) {
        // The state is the broken fraction of the gel structure: 0 at the start of a record.
        r[0] = (1.0 - s[0]) * here.v.abs() / self.breaks - s[0] / self.restores;
    }
    fn gain(&self, _: &Here, s: &[f64]) -> f64 {
        1.0 / (1.0 + self.stiffer * (1.0 - s[0]))
    }
}

fn moore(strength: f64, _: &Scale, d: &mut Draw) -> Box<dyn EffectModel> {
    Box::new(Moore {
        stiffer: strength * d.between(0.4, 0.9),
        breaks: d.scale(0.05, 0.25),
        restores: d.scale(0.4, 2.0),
    })
}
