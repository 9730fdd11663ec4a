//! Formulas of the gas: force, stiffness, length of the column, effect of temperature, and cavitation.

use crate::geometry::{annulus, area};
use crate::oil::ATMOSPHERE;

/// Zero of the Celsius scale, K.
pub const KELVIN: f64 = 273.15;
/// Thermal expansion of oil, 1/K (Dixon, The Shock Absorber Handbook, 2007, chapter 5).
pub const OIL_EXPANSION: f64 = 7.5e-4;

/// Computes the force that pushes the rod out, N, from the gauge pressure, Pa, and the rod diameter, m.
pub fn force(pressure: f64, rod: f64) -> f64 {
    pressure * area(rod)
}

/// Computes the gauge pressure, Pa, from the force that pushes the rod out, N, and the rod diameter, m.
pub fn pressure(force: f64, rod: f64) -> f64 {
    force / area(rod)
}

/// Computes the length of the gas column, m: the volume, m³, divided by the area of the rod, which displaces the gas.
/// `rod` is the diameter of the rod, m.
pub fn length(volume: f64, rod: f64) -> f64 {
    volume / area(rod)
}

/// Computes the slow (isothermal) stiffness of the gas, N/m, from gauge pressure, Pa, volume, m³, and rod diameter, m.
pub fn stiffness(pressure: f64, volume: f64, rod: f64) -> f64 {
    (pressure + ATMOSPHERE) * area(rod) * area(rod) / volume
}

/// Computes the volume of gas, m³, from gauge pressure, Pa, slow stiffness, N/m, and rod diameter, m.
pub fn volume(pressure: f64, stiffness: f64, rod: f64) -> f64 {
    (pressure + ATMOSPHERE) * area(rod) * area(rod) / stiffness
}

/// Computes the increase of the gas force per kelvin, N/K, due to the gas itself (Gay-Lussac) and to the expansion of
/// the oil. `pressure` is the gauge pressure, Pa, at `temperature`, °C, and `rod` the diameter of the rod, m.
/// `oil_per_gas` is the ratio of the oil volume to the gas volume.
pub fn warming(pressure: f64, temperature: f64, rod: f64, oil_per_gas: f64) -> f64 {
    (pressure + ATMOSPHERE) * area(rod) * (1.0 / (temperature + KELVIN) + OIL_EXPANSION * oil_per_gas)
}

/// Computes the hydraulic force in compression, N, at which the absolute pressure in the rod-side chamber of a monotube
/// is zero. The gauge pressure of the gas is in Pa, bore and rod diameter in m.
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
        // The gas force grows by 0.34 % per kelvin without oil, and by about twice that with four volumes of oil per
        // volume of gas.
        let force = (p + ATMOSPHERE) * area(rod);
        assert!((warming(p, 20.0, rod, 0.0) / force - 0.0034).abs() < 1e-4);
        assert!((warming(p, 20.0, rod, 4.0) / force - 0.0064).abs() < 1e-4);
    }
}
