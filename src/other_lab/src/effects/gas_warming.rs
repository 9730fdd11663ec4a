//! Injected effect of a gas force that increases with the damper's temperature.

use super::{Effect, EffectModel, Here, Make};
use crate::draw::Draw;
use crate::plant::Scale;

pub(super) const EFFECT: Effect = Effect {
    name: "gas_warming",
    laws: &[("room_taken_by_oil", room_taken_by_oil as Make), ("gas_leaves_the_oil", gas_leaves_the_oil)],
};

/// Temperature at which the effect vanishes, °C.
const REFERENCE_C: f64 = 25.0;
const KELVIN: f64 = 273.15;
/// Volumetric thermal expansion of mineral oil, 1/K.
const EXPANSION: f64 = 8e-4;

/// An ideal gas behind a floating piston.
///
/// The gas pressure increases with the absolute temperature. It also increases because expanding oil reduces the gas
/// volume (Dixon, The Shock Absorber Handbook, 2007, ch. 5). The increase is larger in compression, where the gas
/// volume is smaller.
struct RoomTakenByOil {
    force: f64,
    /// Ratio of oil volume to gas volume.
    oil: f64,
    length: f64,
}

impl EffectModel for RoomTakenByOil {
    fn parallel(&self, here: &Here, _: &[f64]) -> f64 {
        let room = (1.0 + here.x / self.length).max(0.3);
        let taken = (EXPANSION * self.oil * (here.oil_c - REFERENCE_C)).min(0.7 * room);
        let hotter = (here.oil_c + KELVIN) / (REFERENCE_C + KELVIN);
        -self.force * (hotter / (room - taken) - 1.0 / room)
    }
}

fn room_taken_by_oil(strength: f64, scale: &Scale, d: &mut Draw) -> Box<dyn EffectModel> {
    Box::new(RoomTakenByOil {
        force: strength * d.between(0.6, 1.4) * scale.gas_n.max(150.0),
        oil: d.between(2.0, 5.0),
        length: d.between(0.25, 0.5),
    })
}

/// Low-pressure gas above the oil of a twin tube.
///
/// With rising temperature, dissolved gas leaves the oil by van 't Hoff's exponential, up to the total amount.
struct GasLeavesTheOil {
    force: f64,
    kelvin: f64,
}

impl EffectModel for GasLeavesTheOil {
    fn parallel(&self, here: &Here, _: &[f64]) -> f64 {
        let warmer = here.oil_c - REFERENCE_C;
        -self.force * (warmer / (KELVIN + REFERENCE_C) + 1.0 - libm::exp(-warmer / self.kelvin))
    }
}

fn gas_leaves_the_oil(strength: f64, scale: &Scale, d: &mut Draw) -> Box<dyn EffectModel> {
    Box::new(GasLeavesTheOil {
        force: strength * d.between(0.4, 0.9) * scale.gas_n.max(150.0),
        kelvin: d.between(40.0, 80.0),
    })
}
