//! Injected effect of an additional compliance of oil or hoses: nonlinear, or with creep.

use super::{Effect, EffectModel, Here, Make};
use crate::draw::Draw;
use crate::plant::Scale;

pub(super) const EFFECT: Effect =
    Effect { name: "oil_compressibility", laws: &[("tait", tait as Make), ("creeping_hose", creeping_hose)] };

/// Oil that stiffens with pressure (Tait 1888; Dymond & Malhotra, Int. J. Thermophys. 9, 1988).
struct Tait {
    compliance: f64,
    force: f64,
}

impl EffectModel for Tait {
    fn column(&self, here: &Here, _: &[f64]) -> f64 {
        self.compliance / (1.0 + here.hydraulic.abs() / self.force)
    }
}

/// Draws the compliance of an oil column, m/N: 0.35 to 0.9 mm at the sum of the damper's forces at 0.5 m/s.
fn soft(scale: &Scale, d: &mut Draw) -> f64 {
    d.between(0.35, 0.9) * 1e-3 / (scale.rebound_n + scale.compression_n)
}

fn tait(strength: f64, scale: &Scale, d: &mut Draw) -> Box<dyn EffectModel> {
    Box::new(Tait { compliance: strength * soft(scale, d), force: d.between(2.0, 4.0) * scale.rebound_n })
}

/// A hose or plastic part with an immediate deflection and creep (Kelvin & Voigt; Johnston et al., Proc. IMechE I 224,
/// 2010, for hose walls).
struct CreepingHose {
    at_once: f64,
    later: f64,
    time: f64,
}

impl CreepingHose {
    fn creep(&self, here: &Here, s: &[f64]) -> f64 {
        (self.later * here.hydraulic - s[0]) / self.time
    }
}

impl EffectModel for CreepingHose {
    fn tolerances(&self) -> &[f64] {
        &[1e-7]
    }
    fn rates(&self, here: &Here, s: &[f64], r: &mut [f64]) {
        r[0] = self.creep(here, s);
    }
    fn column(&self, _: &Here, _: &[f64]) -> f64 {
        self.at_once
    }
    fn taken(&self, here: &Here, s: &[f64]) -> f64 {
        self.creep(here, s)
    }
}

fn creeping_hose(strength: f64, scale: &Scale, d: &mut Draw) -> Box<dyn EffectModel> {
    let all = strength * soft(scale, d);
    let later = d.between(0.2, 0.4);
    Box::new(CreepingHose { at_once: (1.0 - later) * all, later: later * all, time: d.scale(3e-3, 1.5e-2) })
}
