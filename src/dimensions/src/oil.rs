//! Stiffness of the oil column with the tube around it and the air in it.
//!
//! The chamber under pressure has the volume V and the piston area A. Its stiffness is K A²/V. The effective modulus K
//! follows from the moduli of oil, tube and air: 1/K = 1/K_oil + 1/K_tube + 1/K_air (Merritt, Hydraulic Control
//! Systems, 1967, chapter 2).

use crate::dimensions::Design;
use crate::geometry::{annulus, area};

/// Poisson's ratio of steel and aluminum.
const POISSON: f64 = 0.3;
/// Atmospheric pressure, Pa.
pub const ATMOSPHERE: f64 = 101_325.0;
/// Polytropic exponent of air bubbles in motion, between isothermal (1) and adiabatic (1.4): Merritt 1967; Dixon 2007,
/// chapter 5. The compliance of the air is inversely proportional to the exponent.
pub const BUBBLES: f64 = 1.2;

/// Computes the relative increase of a tube's inner volume per pressure, 1/Pa, for Lamé's thick wall without axial
/// force. For a thin wall, it is D/(E t), with the bore D, m, the wall thickness t, m, and Young's modulus E, Pa.
pub fn tube_compliance(bore: f64, wall: f64, modulus: f64) -> f64 {
    let (inner, outer) = (0.25 * bore * bore, (0.5 * bore + wall) * (0.5 * bore + wall));
    2.0 / modulus * ((outer + inner) / (outer - inner) + POISSON)
}

/// Computes the compliance of free air, 1/Pa, at the absolute pressure `pressure`, Pa. `air` is its volume fraction at
/// atmospheric pressure.
pub fn air_compliance(air: f64, pressure: f64) -> f64 {
    air * ATMOSPHERE / (BUBBLES * pressure * pressure)
}

/// Computes the stiffness in rebound, N/m, of the oil column in the rod-side chamber. The modulus is in Pa; the
/// diameters of bore and rod and the length of the chamber are in m.
pub fn rebound_stiffness(modulus: f64, bore: f64, rod: f64, length: f64) -> f64 {
    modulus * annulus(bore, rod) / length
}

/// Computes the bulk modulus, Pa, at which the oil column has the given stiffness in rebound, N/m. The diameters of
/// bore and rod and the length of the chamber are in m.
pub fn modulus_of_rebound(stiffness: f64, bore: f64, rod: f64, length: f64) -> f64 {
    stiffness * length / annulus(bore, rod)
}

/// Computes the ratio of the stiffness in compression to that in rebound. In a monotube, the rod-side chamber is
/// compliant in both directions. In a twin tube, the rod compresses both chambers together. The diameters of bore and
/// rod and the lengths of both chambers are in m.
pub fn compression_ratio(design: Design, bore: f64, rod: f64, [rebound, compression]: [f64; 2]) -> f64 {
    match design {
        Design::Monotube => 1.0,
        Design::TwinTube => {
            let ring = annulus(bore, rod);
            let volume = ring * rebound + area(bore) * compression;
            area(rod) * area(rod) / volume * (rebound / ring)
        }
    }
}

/// Computes the largest stroke by compression of free air, m, and the force at half of that stroke, N.
///
/// For bubbles, the product of volume and pressure is constant. Under the force F on the area A, they deflect by g F /
/// (F + p A). Here g is the largest stroke, and p the absolute pressure without force, `pressure`, Pa. The element
/// `aeration` has this law. `air` is the volume fraction at atmospheric pressure; lengths are in m.
pub fn air_stroke(air: f64, pressure: f64, bore: f64, rod: f64, length: f64) -> (f64, f64) {
    (air * length * ATMOSPHERE / (BUBBLES * pressure), pressure * annulus(bore, rod))
}

/// Computes the volume fraction of free air at atmospheric pressure from the largest stroke due to its compression, m.
/// `pressure` is absolute, Pa, and `length` that of the chamber, m.
pub fn air_of_stroke(stroke: f64, pressure: f64, length: f64) -> f64 {
    stroke * BUBBLES * pressure / (length * ATMOSPHERE)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_thin_wall_is_the_textbooks() {
        let (thick, thin) = (tube_compliance(0.04, 1e-4, 206e9), 0.04 / (206e9 * 1e-4));
        assert!((thick / thin - 1.0).abs() < 0.01, "{thick} {thin}");
        assert!(tube_compliance(0.04, 2e-3, 206e9) < thin);
        // A steel wall of 2 mm on a 40 mm bore has a modulus near 10 GPa.
        assert!((9e9..11e9).contains(&(1.0 / tube_compliance(0.04, 2e-3, 206e9))));
    }

    #[test]
    fn a_twin_tube_is_far_softer_in_compression_and_a_monotube_is_not() {
        assert_eq!(compression_ratio(Design::Monotube, 0.04, 0.012, [0.13, 0.15]), 1.0);
        let ratio = compression_ratio(Design::TwinTube, 0.03, 0.016, [0.13, 0.16]);
        assert!((0.03..0.1).contains(&ratio), "{ratio}");
    }

    #[test]
    fn air_and_modulus_come_back() {
        let (stroke, force) = air_stroke(0.01, 6e5, 0.03, 0.012, 0.13);
        assert!((air_of_stroke(stroke, 6e5, 0.13) - 0.01).abs() < 1e-12 && force > 0.0);
        let k = rebound_stiffness(1.2e9, 0.04, 0.012, 0.13);
        assert!((modulus_of_rebound(k, 0.04, 0.012, 0.13) / 1.2e9 - 1.0).abs() < 1e-12);
        // The slope of the air's deflection over force at zero force is the compliance of the air in the column.
        let slope = air_stroke(0.01, 6e5, 0.03, 0.012, 0.13);
        let of_modulus = 1.0 / rebound_stiffness(1.0 / air_compliance(0.01, 6e5), 0.03, 0.012, 0.13);
        assert!((slope.0 / slope.1 / of_modulus - 1.0).abs() < 1e-12);
    }
}
