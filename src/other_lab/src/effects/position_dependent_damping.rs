//! Injected effect of position-dependent damping: passages or valves whose flow depends on the position in the stroke.

use super::{Effect, EffectModel, Here, Make};
use crate::draw::Draw;
use crate::plant::{Scale, flow::passage};

pub(super) const EFFECT: Effect = Effect {
    name: "position_dependent_damping",
    laws: &[("tapered_groove", tapered_groove as Make), ("needle", needle)],
};

/// A bypass groove in the tube whose depth decreases linearly from its center, with laminar and turbulent flow.
///
/// (Lee & Moon, Mech. Syst. Signal Process. 20, 2006, displacement-sensitive shock absorber.)
struct TaperedGroove {
    area: f64,
    centre: f64,
    half: f64,
    laminar: f64,
    turbulent: f64,
}

impl EffectModel for TaperedGroove {
    fn taken(&self, here: &Here, _: &[f64]) -> f64 {
        let depth = 1.0 - ((here.x - self.centre).powi(2) + 1e-6).sqrt() / self.half;
        if depth <= 0.0 {
            return 0.0;
        }
        let passes = passage(here.hydraulic.abs(), self.laminar, self.turbulent).copysign(here.hydraulic);
        self.area * depth * depth.sqrt() * passes
    }
}

fn tapered_groove(strength: f64, scale: &Scale, d: &mut Draw) -> Box<dyn EffectModel> {
    // At the deepest point of the groove and the mean of the damper's forces at 0.5 m/s, the flow is about `area` times
    // 0.5 m/s.
    let h = 0.5 * (scale.rebound_n + scale.compression_n);
    Box::new(TaperedGroove {
        area: strength * d.between(0.5, 1.1),
        centre: d.between(-0.012, 0.012),
        half: d.between(0.02, 0.04),
        laminar: 0.3 * h / 0.5,
        turbulent: 0.7 * h / 0.25,
    })
}

/// A metering needle, with which the flow of the valves varies with displacement, as a parabola (Konieczny, Shock and
/// Vibration 2016).
struct Needle {
    slope: f64,
    curve: f64,
}

impl EffectModel for Needle {
    fn gain(&self, here: &Here, _: &[f64]) -> f64 {
        let bent = self.slope * here.x + self.curve * here.x * here.x;
        // The factor on the flow is 1 plus the parabola if the parabola is positive, and its exponential otherwise, so
        // it stays positive.
        if bent < 0.0 { libm::exp(bent) } else { 1.0 + bent }
    }
}

fn needle(strength: f64, _: &Scale, d: &mut Draw) -> Box<dyn EffectModel> {
    Box::new(Needle {
        slope: strength * d.sign() * d.between(4.0, 12.0),
        curve: strength * d.sign() * d.between(100.0, 300.0),
    })
}
