//! Injected effect of dry friction in addition to that of the damper's seal.

use super::{Effect, EffectModel, Here, Make, soft_sign};
use crate::draw::Draw;
use crate::plant::Scale;

pub(super) const EFFECT: Effect =
    Effect { name: "coulomb_friction", laws: &[("lip", lip as Make), ("logarithmic", logarithmic)] };

/// A lip seal with different friction in rebound and in compression (Müller & Nau, Fluid Sealing Technology, 1998).
struct Lip {
    out: f64,
    back: f64,
    within: f64,
}

impl EffectModel for Lip {
    fn parallel(&self, here: &Here, _: &[f64]) -> f64 {
        let sign = soft_sign(here.v, self.within);
        0.5 * ((self.out + self.back) * sign + (self.out - self.back) * sign * sign)
    }
}

fn lip(strength: f64, scale: &Scale, d: &mut Draw) -> Box<dyn EffectModel> {
    let out = strength * scale.friction_n.max(25.0) * d.between(1.0, 2.5);
    Box::new(Lip { out, back: out * d.between(0.5, 0.8), within: d.scale(4e-4, 2e-3) })
}

/// Friction that grows with the logarithm of speed, regularized at standstill (Rice, Lapusta & Ranjith, J. Mech. Phys.
/// Solids 49, 2001).
struct Logarithmic {
    force: f64,
    share: f64,
    speed: f64,
}

impl EffectModel for Logarithmic {
    fn parallel(&self, here: &Here, _: &[f64]) -> f64 {
        self.force * self.share * libm::asinh(0.5 * here.v / self.speed * libm::exp(1.0 / self.share))
    }
}

fn logarithmic(strength: f64, scale: &Scale, d: &mut Draw) -> Box<dyn EffectModel> {
    let force = strength * scale.friction_n.max(25.0) * d.between(1.0, 2.0);
    Box::new(Logarithmic { force, share: d.between(0.1, 0.18), speed: d.scale(5e-3, 2e-2) })
}
