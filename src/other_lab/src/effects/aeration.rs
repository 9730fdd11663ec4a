//! Injected effect of air in the oil.

use super::{Effect, EffectModel, Here, Make};
use crate::draw::Draw;
use crate::plant::Scale;

pub(super) const EFFECT: Effect = Effect { name: "aeration", laws: &[("henry", henry as Make), ("pocket", pocket)] };

/// Air bubbles that are compressed and, by Henry's law, dissolve under pressure with time constants.
///
/// Release of air is fast and dissolution is slow (Yu, Chen & Lu, Fluid power transm. 1994; Kim & Murrenhoff, Int. J.
/// Fluid Power 13, 2012).
struct Henry {
    stroke: f64,
    force: f64,
    dissolved: f64,
    out: f64,
    back: f64,
}

impl EffectModel for Henry {
    fn tolerances(&self) -> &[f64] {
        &[1e-3]
    }
    fn rates(&self, here: &Here, s: &[f64], r: &mut [f64]) {
        // The state is the dissolved fraction of the bubbles: 0 in equilibrium without hydraulic force.
        let target = libm::tanh(here.hydraulic.abs() / self.dissolved);
        let short = target - s[0];
        let quick = 0.5 * (1.0 + libm::tanh(short / 0.05));
        r[0] = short * (quick / self.back + (1.0 - quick) / self.out);
    }
    fn column(&self, here: &Here, s: &[f64]) -> f64 {
        let r = here.hydraulic.abs() / self.force;
        self.stroke / self.force * (1.0 - s[0]).max(0.0) * libm::pow(1.0 + r, -1.0 - 1.0 / 1.3)
    }
}

fn henry(strength: f64, scale: &Scale, d: &mut Draw) -> Box<dyn EffectModel> {
    Box::new(Henry {
        stroke: strength * d.between(0.6e-3, 1.4e-3),
        force: d.between(0.05, 0.15) * scale.rebound_n,
        dissolved: d.between(0.6, 1.5) * scale.rebound_n,
        out: d.scale(1e-2, 4e-2),
        back: d.scale(8e-2, 4e-1),
    })
}

/// An air pocket, mostly in one chamber.
///
/// The bubbles have all sizes, so the pocket closes exponentially with pressure (Hayward, Brit. Hydromech. Res. Ass.
/// 1961).
struct Pocket {
    stroke: f64,
    force: f64,
    /// Relative sizes of the air pocket in the rebound and the compression chamber; the larger one is 1.
    sides: [f64; 2],
}

impl EffectModel for Pocket {
    fn column(&self, here: &Here, _: &[f64]) -> f64 {
        let side = 0.5 * (1.0 + libm::tanh(here.hydraulic / 10.0));
        let share = side * self.sides[0] + (1.0 - side) * self.sides[1];
        share * self.stroke / self.force * libm::exp(-here.hydraulic.abs() / self.force)
    }
}

fn pocket(strength: f64, scale: &Scale, d: &mut Draw) -> Box<dyn EffectModel> {
    let less = d.between(0.1, 0.4);
    Box::new(Pocket {
        stroke: strength * d.between(0.6e-3, 1.4e-3),
        force: d.between(0.1, 0.3) * scale.compression_n,
        sides: if d.choice(2) == 0 { [1.0, less] } else { [less, 1.0] },
    })
}
