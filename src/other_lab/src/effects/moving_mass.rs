//! Injected effect of a mass that moves with the damper's end and whose inertia force reaches the load cell.

use super::{Effect, EffectModel, Here, Make};
use crate::draw::Draw;
use crate::plant::Scale;

pub(super) const EFFECT: Effect =
    Effect { name: "moving_mass", laws: &[("fluid_inerter", fluid_inerter as Make), ("sprung_clamp", sprung_clamp)] };

/// Inertia of oil in a long passage.
///
/// The effective length of the passage changes with the displacement x, so the force follows Lagrange's equation with a
/// mass M(x) (Swift et al., Proc. R. Soc. A 469, 2013).
struct FluidInerter {
    mass: f64,
    per_length: f64,
}

impl EffectModel for FluidInerter {
    fn parallel(&self, here: &Here, _: &[f64]) -> f64 {
        let motion = here.input;
        let share = (1.0 + motion.x * self.per_length).max(0.1);
        self.mass * (share * motion.a + 0.5 * self.per_length * motion.v * motion.v)
    }
}

fn fluid_inerter(strength: f64, _: &Scale, d: &mut Draw) -> Box<dyn EffectModel> {
    Box::new(FluidInerter { mass: strength * d.between(3.0, 8.0), per_length: d.sign() * d.between(2.0, 6.0) })
}

/// A clamp with an elastic joint to the moving end of the damper (Ewins, Modal Testing, 2000).
///
/// At low frequency, the clamp acts as a mass. Toward its resonance at 80 to 160 Hz, the apparent mass increases.
struct SprungClamp {
    mass: f64,
    omega: f64,
    damping: f64,
}

impl SprungClamp {
    /// Computes the force of the joint per mass, m/s². The states are the deflection of the joint, m, and its rate,
    /// m/s.
    fn pull(&self, s: &[f64]) -> f64 {
        self.omega * self.omega * s[0] + 2.0 * self.damping * self.omega * s[1]
    }
}

impl EffectModel for SprungClamp {
    fn tolerances(&self) -> &[f64] {
        &[2e-8, 1e-5]
    }
    fn rates(&self, here: &Here, s: &[f64], r: &mut [f64]) {
        r[0] = s[1];
        r[1] = here.input.a - self.pull(s);
    }
    fn parallel(&self, _: &Here, s: &[f64]) -> f64 {
        self.mass * self.pull(s)
    }
}

fn sprung_clamp(strength: f64, _: &Scale, d: &mut Draw) -> Box<dyn EffectModel> {
    Box::new(SprungClamp {
        mass: strength * d.between(3.0, 8.0),
        omega: std::f64::consts::TAU * d.scale(80.0, 160.0),
        damping: d.between(0.05, 0.2),
    })
}
