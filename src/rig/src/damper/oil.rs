//! Compressible oil with entrained air.
//!
//! The model conserves the oil mass by construction. The specific volume is an explicit function of pressure. The bulk
//! modulus follows from its exact derivative (mixture law of Merritt, *Hydraulic Control Systems*, 1967).

use super::ATMOSPHERE_PA;

/// Damper oil.
#[derive(Debug, Clone, PartialEq)]
pub struct Oil {
    /// Density at atmospheric pressure, kg/m³.
    pub density_kg_m3: f64,
    /// Bulk modulus of the oil without air, Pa.
    pub bulk_modulus_pa: f64,
    /// Fraction of the volume of the mixture that is free air at atmospheric pressure.
    pub air_fraction: f64,
    /// Polytropic exponent of the air bubbles.
    pub air_exponent: f64,
}

impl Default for Oil {
    fn default() -> Self {
        Self { density_kg_m3: 850.0, bulk_modulus_pa: 1.4e9, air_fraction: 0.015, air_exponent: 1.3 }
    }
}

/// Specific volume and bulk modulus of the mixture of oil and air at a pressure.
#[derive(Debug, Clone, Copy)]
pub struct Compression {
    /// Specific volume of the mixture relative to that at atmospheric pressure.
    pub volume: f64,
    /// Bulk modulus of the mixture, Pa.
    pub modulus_pa: f64,
}

impl Oil {
    /// Computes the state of the mixture of oil and air at an absolute pressure, Pa. The bulk modulus approaches zero
    /// at zero pressure, so that no chamber reaches a vacuum.
    pub fn compress(&self, pressure_pa: f64) -> Compression {
        // The solver may evaluate negative pressures. They are treated as 1 Pa.
        let pressure = pressure_pa.max(1.0);
        let oil = (1.0 - self.air_fraction) * libm::exp(-(pressure - ATMOSPHERE_PA) / self.bulk_modulus_pa);
        let air = self.air_fraction * libm::pow(ATMOSPHERE_PA / pressure, 1.0 / self.air_exponent);
        let volume = oil + air;
        Compression { volume, modulus_pa: volume / (oil / self.bulk_modulus_pa + air / (self.air_exponent * pressure)) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn modulus_is_the_slope_of_volume() {
        let oil = Oil::default();
        for pressure in [2e4, 1e5, 5e5, 2e6, 8e6] {
            let h = 1e-4 * pressure;
            let slope = (oil.compress(pressure + h).volume - oil.compress(pressure - h).volume) / (2.0 * h);
            let state = oil.compress(pressure);
            assert!((-state.volume / slope / state.modulus_pa - 1.0).abs() < 1e-5);
        }
        assert!((oil.compress(ATMOSPHERE_PA).volume - 1.0).abs() < 1e-12);
    }

    #[test]
    fn air_softens_at_low_pressure_only() {
        let oil = Oil::default();
        let clean = Oil { air_fraction: 0.0, ..Oil::default() };
        assert!((clean.compress(1e5).modulus_pa / oil.bulk_modulus_pa - 1.0).abs() < 1e-12);
        assert!(oil.compress(1e5).modulus_pa < 0.02 * oil.bulk_modulus_pa);
        assert!(oil.compress(1e7).modulus_pa > 0.9 * oil.bulk_modulus_pa);
    }
}
