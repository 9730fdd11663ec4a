//! The gas: force, stiffness, column, and what warmth and a starved chamber do.

use crate::geometry::{annulus, area};
use crate::oil::ATMOSPHERE;

/// Zero of the Celsius scale, K.
pub const KELVIN: f64 = 273.15;
/// Volume that oil grows by per kelvin (Dixon, The Shock Absorber Handbook, 2007, chapter 5).
pub const OIL_EXPANSION: f64 = 7.5e-4;

/// Force that pushes the rod out, N, at a gauge pressure.
pub fn force(pressure: f64, rod: f64) -> f64 {
    pressure * area(rod)
}

/// Gauge pressure, Pa, that pushes the rod out with a force.
pub fn pressure(force: f64, rod: f64) -> f64 {
    force / area(rod)
}

/// Length of the gas column, m: volume over the area of the rod, which changes it.
pub fn length(volume: f64, rod: f64) -> f64 {
    volume / area(rod)
}

/// Slow (isothermal) stiffness of the gas, N/m, at a gauge pressure.
pub fn stiffness(pressure: f64, volume: f64, rod: f64) -> f64 {
    (pressure + ATMOSPHERE) * area(rod) * area(rod) / volume
}

/// Volume of gas, m³, that has a slow stiffness.
pub fn volume(pressure: f64, stiffness: f64, rod: f64) -> f64 {
    (pressure + ATMOSPHERE) * area(rod) * area(rod) / stiffness
}

/// Growth of the gas force per kelvin, N/K: the gas's own (Gay-Lussac), and that by oil that expands into its volume.
pub fn warming(pressure: f64, temperature: f64, rod: f64, oil_per_gas: f64) -> f64 {
    (pressure + ATMOSPHERE) * area(rod) * (1.0 / (temperature + KELVIN) + OIL_EXPANSION * oil_per_gas)
}

/// Hydraulic force in compression, N, at which the chamber on the rod's side of a monotube has no pressure left.
pub fn cavitation_force(pressure: f64, bore: f64, rod: f64) -> f64 {
    (pressure + ATMOSPHERE) * annulus(bore, rod)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fifteen_bar_on_eleven_millimetres_are_143_newtons() {
        assert!((force(15e5, 0.011) - 142.55).abs() < 0.01);
        assert!((pressure(force(15e5, 0.011), 0.011) / 15e5 - 1.0).abs() < 1e-12);
    }

    #[test]
    fn stiffness_and_length_are_those_of_one_gas() {
        let (p, v, rod) = (25e5, 9e-5, 0.0125);
        let product = stiffness(p, v, rod) * length(v, rod);
        assert!((product / ((p + ATMOSPHERE) * area(rod)) - 1.0).abs() < 1e-12);
        assert!((volume(p, stiffness(p, v, rod), rod) / v - 1.0).abs() < 1e-12);
        // 0.34 % a kelvin without oil, about twice that with three volumes of it.
        let force = (p + ATMOSPHERE) * area(rod);
        assert!((warming(p, 20.0, rod, 0.0) / force - 0.0034).abs() < 1e-4);
        assert!((warming(p, 20.0, rod, 4.0) / force - 0.0064).abs() < 1e-4);
    }
}
