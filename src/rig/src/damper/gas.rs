//! Gas behind the floating piston.

/// Gas chamber behind the floating piston. The floating piston is light and free, so the gas has the pressure of the
/// compression chamber.
#[derive(Debug, Clone, PartialEq)]
pub struct GasChamber {
    /// Absolute gas pressure at mid-stroke in equilibrium, Pa.
    pub pressure_pa: f64,
    /// Gas volume at mid-stroke in equilibrium, m³.
    pub volume_m3: f64,
    /// Polytropic exponent of the gas: 1 isothermal, 1.4 adiabatic.
    pub exponent: f64,
}

impl Default for GasChamber {
    fn default() -> Self {
        Self { pressure_pa: 1.7e6, volume_m3: 8.0e-5, exponent: 1.25 }
    }
}

impl GasChamber {
    /// Returns the gas volume, m³, at an absolute pressure, Pa.
    pub fn volume_at(&self, pressure_pa: f64) -> f64 {
        self.volume_m3 * libm::pow(self.pressure_pa / pressure_pa.max(1.0), 1.0 / self.exponent)
    }

    /// Returns the decrease of the gas volume per increase of pressure, m³/Pa, at an absolute pressure and the gas
    /// volume at this pressure.
    pub fn compliance(&self, pressure_pa: f64, volume_m3: f64) -> f64 {
        volume_m3 / (self.exponent * pressure_pa.max(1.0))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pressure_and_volume_follow_the_polytropic_law() {
        let gas = GasChamber::default();
        let constant = gas.pressure_pa * libm::pow(gas.volume_m3, gas.exponent);
        for pressure in [8e5, 1.7e6, 4e6] {
            let volume = gas.volume_at(pressure);
            assert!((pressure * volume.powf(gas.exponent) / constant - 1.0).abs() < 1e-12);
            let h = 1e-5 * pressure;
            let slope = (gas.volume_at(pressure + h) - gas.volume_at(pressure - h)) / (2.0 * h);
            assert!((slope + gas.compliance(pressure, volume)).abs() < 1e-8 * slope.abs());
        }
    }
}
