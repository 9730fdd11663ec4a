//! Injected effect of a spring in parallel with the damper. The spring is dissipative, because a fitted table of force
//! over displacement would represent a lossless spring completely.

use super::{Effect, EffectModel, Here, Make};
use crate::draw::Draw;
use crate::plant::Scale;

pub(super) const EFFECT: Effect =
    Effect { name: "parallel_spring", laws: &[("lossy", lossy as Make), ("relaxing", relaxing)] };

/// A spring with a loss force proportional to its elastic force (structural damping; Caughey, J. Appl. Mech. 27, 1960).
/// After a reversal of motion, the loss force reverses within millimeters.
struct Lossy {
    stiffness: f64,
    loss: f64,
    length: f64,
}

impl EffectModel for Lossy {
    fn tolerances(&self) -> &[f64] {
        &[1e-3]
    }
    fn rates(&self, here: &Here, s: &[f64], r: &mut [f64]) {
        r[0] = (here.v - here.v.abs() * s[0]) / self.length;
    }
    fn parallel(&self, here: &Here, s: &[f64]) -> f64 {
        self.stiffness * (here.x + self.loss * s[0] * (here.x * here.x + 4.0 * self.length * self.length).sqrt())
    }
}

fn lossy(strength: f64, scale: &Scale, d: &mut Draw) -> Box<dyn EffectModel> {
    let stiffness = strength * d.between(3.0, 8.0) * scale.rebound_n;
    Box::new(Lossy { stiffness, loss: d.between(0.08, 0.2), length: d.scale(1e-3, 4e-3) })
}

/// A polymer sleeve or boot: a spring in parallel with a Maxwell element that relaxes within about a second (Zener
/// 1948).
struct Relaxing {
    stiffness: f64,
    share: f64,
    time: f64,
}

impl EffectModel for Relaxing {
    fn tolerances(&self) -> &[f64] {
        &[2e-6]
    }
    fn rates(&self, here: &Here, s: &[f64], r: &mut [f64]) {
        r[0] = here.v - s[0] / self.time;
    }
    fn parallel(&self, here: &Here, s: &[f64]) -> f64 {
        self.stiffness * (here.x + self.share * s[0])
    }
}

fn relaxing(strength: f64, scale: &Scale, d: &mut Draw) -> Box<dyn EffectModel> {
    let stiffness = strength * d.between(3.0, 8.0) * scale.rebound_n;
    Box::new(Relaxing { stiffness, share: d.between(0.3, 0.7), time: d.scale(0.3, 2.0) })
}
