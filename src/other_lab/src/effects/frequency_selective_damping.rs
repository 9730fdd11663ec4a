//! Injected effect of frequency-selective damping: reduced damping for short, fast strokes.

use super::{Effect, EffectModel, Here, Make};
use crate::draw::Draw;
use crate::plant::Scale;

pub(super) const EFFECT: Effect = Effect {
    name: "frequency_selective_damping",
    laws: &[("travelling_piston", travelling_piston as Make), ("pilot_chamber", pilot_chamber)],
};

/// A small free piston in a bypass passage through the rod.
///
/// In short strokes of the damper, the small piston moves freely. In long strokes, it reaches its stop and closes the
/// passage (amplitude-selective damping; Gołdasz, Acta Mech. Autom. 2012; Yao et al., SAE 2002-01-2811).
struct TravellingPiston {
    /// Stroke of the damper, m, that moves the small piston from its center to its stop, if all oil flows through the
    /// passage.
    travel: f64,
    /// Laminar resistance of the passage, N s/m. Its value in N is also the force at which the flow becomes turbulent.
    resistance: f64,
    end: f64,
}

impl TravellingPiston {
    fn moves(&self, here: &Here, s: &[f64]) -> f64 {
        // The state is the position of the small piston between its stops, from about -1 to 1.
        let driven = here.hydraulic - self.end * s[0].powi(7);
        driven / (self.resistance * (1.0 + (driven.abs() / self.resistance)).sqrt())
    }
}

impl EffectModel for TravellingPiston {
    fn tolerances(&self) -> &[f64] {
        &[1e-3]
    }
    fn rates(&self, here: &Here, s: &[f64], r: &mut [f64]) {
        r[0] = self.moves(here, s) / self.travel;
    }
    fn taken(&self, here: &Here, s: &[f64]) -> f64 {
        // `moves` returns the flow that the small piston displaces, as a piston velocity of the damper, m/s.
        self.moves(here, s)
    }
}

fn travelling_piston(strength: f64, scale: &Scale, d: &mut Draw) -> Box<dyn EffectModel> {
    let h = 0.5 * (scale.rebound_n + scale.compression_n);
    // A stronger effect has a larger small piston, with more stroke and less resistance. At strength 0, this piston has
    // nearly no stroke.
    let strength = strength.max(1e-6);
    Box::new(TravellingPiston {
        travel: strength * d.between(1.5e-3, 4e-3),
        resistance: h / (0.5 * strength) * d.between(0.8, 1.6),
        end: d.between(0.8, 1.5) * h,
    })
}

/// A pilot chamber behind the valve of the damper's piston. Its pressure follows the main pressure through a small
/// orifice.
///
/// While the pilot pressure lags, the valve opens further (Küçük, Yang, et al., SAE 2009; KONI FSD patent EP 1442227).
struct PilotChamber {
    opens: f64,
    force: f64,
    fills: f64,
    empties: f64,
}

impl PilotChamber {
    fn ahead(&self, here: &Here, s: &[f64]) -> f64 {
        let by = here.hydraulic.abs() - s[0];
        0.5 * (by + (by * by + 0.01 * self.force * self.force).sqrt()) - 0.05 * self.force
    }
}

impl EffectModel for PilotChamber {
    fn tolerances(&self) -> &[f64] {
        &[0.2]
    }
    fn rates(&self, here: &Here, s: &[f64], r: &mut [f64]) {
        let by = here.hydraulic.abs() - s[0];
        let filling = 0.5 * (1.0 + libm::tanh(by / (0.05 * self.force)));
        r[0] = by * (filling / self.fills + (1.0 - filling) / self.empties);
    }
    fn gain(&self, here: &Here, s: &[f64]) -> f64 {
        let ahead = self.ahead(here, s).max(0.0);
        1.0 + self.opens * ahead / (ahead + s[0].max(0.0) + 0.3 * self.force)
    }
}

fn pilot_chamber(strength: f64, scale: &Scale, d: &mut Draw) -> Box<dyn EffectModel> {
    Box::new(PilotChamber {
        opens: strength * d.between(0.8, 1.8),
        force: 0.3 * scale.compression_n,
        fills: d.scale(0.04, 0.15),
        empties: d.scale(5e-3, 2e-2),
    })
}
