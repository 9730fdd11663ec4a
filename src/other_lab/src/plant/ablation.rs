//! Ablation: a damper without one part of its physics.

use super::Plant;

/// A part of a damper's physics that a diagnosis may report as an effect.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Part {
    /// Presliding: deflection over which friction reverses.
    Presliding,
    /// Peak of the friction at low velocity.
    Stribeck,
    /// Hardening and damping of the mount.
    Bushing,
    /// Compliance of the oil column, including its air.
    OilCompressibility,
    /// Air in the oil at pressures above atmospheric pressure.
    Aeration,
    /// Additional compliance of oil with air and vapor below atmospheric pressure.
    Cavitation,
    /// Rise of the gas force in compression.
    GasSpring,
    /// Valves with different flow on the two sides of mid-stroke.
    PositionDependence,
    /// Viscosity that decreases with the oil temperature.
    Warmth,
    /// Moving mass on the damper's side of the load cell.
    Mass,
}

impl Part {
    /// All parts that can be removed.
    pub const ALL: [Part; 10] = [
        Part::Presliding,
        Part::Stribeck,
        Part::Bushing,
        Part::OilCompressibility,
        Part::Aeration,
        Part::Cavitation,
        Part::GasSpring,
        Part::PositionDependence,
        Part::Warmth,
        Part::Mass,
    ];

    /// Returns the name of the effect that a diagnosis should report.
    pub fn effect(self) -> &'static str {
        match self {
            Part::Presliding => "presliding_friction",
            Part::Stribeck => "stribeck_friction",
            Part::Bushing => "bushing",
            Part::OilCompressibility => "oil_compressibility",
            Part::Aeration => "aeration",
            Part::Cavitation => "cavitation",
            Part::GasSpring => "gas_spring",
            Part::PositionDependence => "position_dependent_damping",
            Part::Warmth => "temperature_fade",
            Part::Mass => "moving_mass",
        }
    }
}

/// Factor that removes a compliance by multiplying its stiffness. With a smaller factor, the compliance would remain
/// visible in the force. A larger factor would only require shorter steps.
pub(super) const STIFFER: f64 = 100.0;

impl Plant {
    /// Returns the damper without a part of its physics.
    #[must_use]
    pub fn without(mut self, part: Part) -> Plant {
        match part {
            Part::Presliding => {
                self.seal.stiffness *= STIFFER;
                self.seal.damping *= STIFFER;
            }
            Part::Stribeck => self.seal.breakaway = self.seal.sliding,
            Part::Bushing => {
                self.mount.hardens = f64::INFINITY;
                self.mount.damping = 0.0;
            }
            Part::GasSpring => self.slight.gas[0] = 0.0,
            Part::PositionDependence => self.slight.position = 0.0,
            Part::Warmth => self.slight.warmth = 0.0,
            Part::Mass => self.slight.laden_kg = 0.0,
            Part::OilCompressibility | Part::Aeration | Part::Cavitation => {}
        }
        self.oil.remove(part);
        self
    }
}
