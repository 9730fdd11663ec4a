//! Injected effect of a gas spring: a gas force that increases in compression.

use super::{Effect, EffectModel, Here, Make};
use crate::draw::Draw;
use crate::plant::Scale;

pub(super) const EFFECT: Effect =
    Effect { name: "gas_spring", laws: &[("two_columns", two_columns as Make), ("redlich_kwong", redlich_kwong)] };

/// Two gas volumes that the rod compresses together: one thin-walled (slow, isothermal) and one well insulated
/// (adiabatic).
///
/// An example is a gas bag next to a free oil surface (Dixon, The Shock Absorber Handbook, 2007, ch. 5).
struct TwoColumns {
    force: f64,
    share: f64,
    lengths: [f64; 2],
}

impl EffectModel for TwoColumns {
    fn parallel(&self, here: &Here, _: &[f64]) -> f64 {
        let at = |length: f64, n: f64| libm::pow((1.0 + here.x / length).max(0.15), -n) - 1.0;
        -self.force * (self.share * at(self.lengths[0], 1.0) + (1.0 - self.share) * at(self.lengths[1], 1.4))
    }
}

fn two_columns(strength: f64, scale: &Scale, d: &mut Draw) -> Box<dyn EffectModel> {
    Box::new(TwoColumns {
        force: strength * d.between(0.4, 0.9) * scale.gas_n.max(150.0),
        share: d.between(0.3, 0.6),
        lengths: [d.between(0.3, 0.6), d.between(0.09, 0.14)],
    })
}

/// Isothermal real gas with the law of Redlich and Kwong (Chem. Rev. 44, 1949), which includes the finite volume of the
/// molecules at high pressure.
struct RedlichKwong {
    force: f64,
    length: f64,
    molecules: f64,
    attraction: f64,
}

impl RedlichKwong {
    fn pressure(&self, volume: f64) -> f64 {
        (1.0 + self.attraction) / (volume - self.molecules) - self.attraction / (volume * (volume + self.molecules))
    }
}

impl EffectModel for RedlichKwong {
    fn parallel(&self, here: &Here, _: &[f64]) -> f64 {
        let volume = (1.0 + here.x / self.length).max(self.molecules + 0.1);
        -self.force * (self.pressure(volume) - self.pressure(1.0))
    }
}

fn redlich_kwong(strength: f64, scale: &Scale, d: &mut Draw) -> Box<dyn EffectModel> {
    Box::new(RedlichKwong {
        force: strength * d.between(0.4, 0.9) * scale.gas_n.max(150.0),
        length: d.between(0.1, 0.18),
        molecules: d.between(0.05, 0.12),
        attraction: d.between(0.05, 0.2),
    })
}
