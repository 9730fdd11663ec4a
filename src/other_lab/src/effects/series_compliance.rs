//! Injected effect of a nonlinear compliance in series with the damper.

use super::{Effect, EffectModel, Here, Make};
use crate::draw::Draw;
use crate::plant::Scale;

pub(super) const EFFECT: Effect =
    Effect { name: "series_compliance", laws: &[("hertz_eye", hertz_eye as Make), ("one_sided", one_sided)] };

/// An eye of the damper on a curved pin. Its deflection is proportional to the power 2/3 of the force (Hertz 1882).
struct HertzEye {
    /// Deflection, m, at the force `force`, N.
    deflection: f64,
    force: f64,
}

impl EffectModel for HertzEye {
    fn series(&self, here: &Here, _: &[f64]) -> f64 {
        let r = here.mount / self.force;
        2.0 / 3.0 * self.deflection / self.force * libm::pow(r * r + 3e-3, -1.0 / 6.0)
    }
}

fn hertz_eye(strength: f64, scale: &Scale, d: &mut Draw) -> Box<dyn EffectModel> {
    let force = 0.5 * (scale.rebound_n + scale.compression_n);
    Box::new(HertzEye { deflection: strength * force / scale.series_n_m.min(2e6) * d.between(1.0, 2.5), force })
}

/// A bracket supported on one side only, with a larger deflection under tension than under compression (Timoshenko's
/// beam on one-sided support).
struct OneSided {
    pull: f64,
    push: f64,
    within: f64,
}

impl EffectModel for OneSided {
    fn series(&self, here: &Here, _: &[f64]) -> f64 {
        let side = (2.0 / std::f64::consts::PI) * libm::atan(here.mount / self.within);
        0.5 * (self.pull + self.push + (self.pull - self.push) * side)
    }
}

fn one_sided(strength: f64, scale: &Scale, d: &mut Draw) -> Box<dyn EffectModel> {
    let pull = strength * d.between(1.2, 3.0) / scale.series_n_m.min(2e6);
    Box::new(OneSided { pull, push: pull * d.between(0.05, 0.3), within: d.scale(30.0, 120.0) })
}
