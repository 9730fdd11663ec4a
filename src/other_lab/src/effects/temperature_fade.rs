//! Injected effect of temperature fade: oil whose viscosity decreases with temperature.

use super::{Effect, EffectModel, Here, Make};
use crate::draw::Draw;
use crate::plant::Scale;

pub(super) const EFFECT: Effect = Effect {
    name: "temperature_fade",
    laws: &[("andrade", andrade as Make), ("growing_clearance", growing_clearance)],
};

/// Temperature at which the effect vanishes, °C.
const REFERENCE_C: f64 = 25.0;

/// Viscosity μ by Andrade (Nature 125, 1930): ln μ = B/T + constant, with the coefficient B and the temperature T, both
/// in K. It acts in the viscosity-dependent passages of the valves.
struct Andrade {
    kelvin: f64,
}

impl EffectModel for Andrade {
    fn viscosity(&self, here: &Here, _: &[f64]) -> f64 {
        libm::exp(self.kelvin * (1.0 / (here.oil_c + 273.15) - 1.0 / (REFERENCE_C + 273.15)))
    }
}

fn andrade(strength: f64, _: &Scale, d: &mut Draw) -> Box<dyn EffectModel> {
    Box::new(Andrade { kelvin: strength * d.between(3500.0, 6500.0) })
}

/// A leak of oil past the piston, through a gap that widens by the thermal expansion of aluminum (Poiseuille; Merritt
/// 1967).
///
/// The flow is proportional to the cube of the gap and inversely proportional to the viscosity. The effect is the
/// change of this leak, which is zero at the reference temperature.
struct GrowingClearance {
    per_force: f64,
    widens: f64,
    thins: f64,
}

impl EffectModel for GrowingClearance {
    fn taken(&self, here: &Here, _: &[f64]) -> f64 {
        let warmer = here.oil_c - REFERENCE_C;
        let gap = (1.0 + self.widens * warmer).max(0.1);
        let leak = gap.powi(3) * (1.0 + self.thins * warmer).max(0.1) - 1.0;
        // The damper already contains the leak at the reference temperature. In a colder damper, the change is
        // negative.
        self.per_force * leak.max(-1.0) * here.hydraulic
    }
}

fn growing_clearance(strength: f64, scale: &Scale, d: &mut Draw) -> Box<dyn EffectModel> {
    Box::new(GrowingClearance {
        per_force: strength * d.between(0.04, 0.08) / scale.rebound_n,
        widens: d.between(6e-3, 1.2e-2),
        thins: d.between(0.02, 0.035),
    })
}
