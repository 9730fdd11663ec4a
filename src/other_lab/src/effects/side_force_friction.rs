//! Injected effect of friction from side force in rod guide and piston.

use super::{Effect, EffectModel, Here, Make, soft_sign};
use crate::draw::Draw;
use crate::plant::Scale;

pub(super) const EFFECT: Effect = Effect {
    name: "side_force_friction",
    laws: &[("sintered_bush", sintered_bush as Make), ("edge_contact", edge_contact)],
};

/// Friction of a PTFE bush, less than proportional to the side force, with contacts that deflect before they slide.
///
/// (Bowden & Tabor 1950; Deubel & Prokop 2023.)
struct SinteredBush {
    coefficient: f64,
    power: f64,
    length: f64,
}

impl EffectModel for SinteredBush {
    fn tolerances(&self) -> &[f64] {
        &[1e-3]
    }
    fn rates(&self, here: &Here, s: &[f64], r: &mut [f64]) {
        r[0] = (here.v - here.v.abs() * s[0] * s[0].abs()) / self.length;
    }
    fn parallel(&self, here: &Here, s: &[f64]) -> f64 {
        self.coefficient * 300.0 * libm::pow(here.side.abs() / 300.0, self.power) * s[0]
    }
}

fn sintered_bush(strength: f64, _: &Scale, d: &mut Draw) -> Box<dyn EffectModel> {
    let coefficient = strength * d.between(0.06, 0.12);
    Box::new(SinteredBush { coefficient, power: d.between(0.75, 0.9), length: d.scale(5e-5, 2e-4) })
}

/// Edge contact of a guide bush. Beyond the side force `edge`, N, the bush tilts on its edge and wipes off its oil film
/// (Hertz 1882; Stribeck 1902).
struct EdgeContact {
    coefficient: f64,
    edge: f64,
    steeper: f64,
    stribeck: f64,
}

impl EffectModel for EdgeContact {
    fn parallel(&self, here: &Here, _: &[f64]) -> f64 {
        let load = here.side.abs();
        let on_edge = (load - self.edge).max(0.0);
        let normal = load + self.steeper * on_edge * libm::cbrt(on_edge / self.edge);
        let film = 1.0 + 0.5 / (1.0 + (here.v / self.stribeck).abs());
        self.coefficient * normal * film * soft_sign(here.v, 8e-4)
    }
}

fn edge_contact(strength: f64, _: &Scale, d: &mut Draw) -> Box<dyn EffectModel> {
    Box::new(EdgeContact {
        coefficient: strength * d.between(0.04, 0.08),
        edge: d.between(200.0, 450.0),
        steeper: d.between(0.5, 1.2),
        stribeck: d.scale(2e-2, 8e-2),
    })
}
