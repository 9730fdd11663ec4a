//! The oil column: its stiffness with the tube around it and the air in it.
//!
//! The chamber under pressure has the volume V and pushes on the area A; its stiffness is K A²/V with the effective modulus K:
//! 1/K = 1/K_oil + 1/K_tube + 1/K_air (Merritt, Hydraulic Control Systems, 1967, chapter 2).

use crate::dimensions::Design;
use crate::geometry::{annulus, area};

/// Poisson's number of steel and aluminum.
const POISSON: f64 = 0.3;
/// Pressure of the air, Pa.
pub const ATMOSPHERE: f64 = 101_325.0;
/// Exponent of air bubbles in motion, between constant temperature (1) and no heat at all (1.4): Merritt 1967; Dixon 2007, chapter 5.
/// The compliance of the air goes with its inverse.
pub const BUBBLES: f64 = 1.2;

/// Growth of a tube's inner volume per pressure, 1/Pa: Lamé's thick wall without axial force, which is D/(E t) where the wall is thin.
pub fn tube_compliance(bore: f64, wall: f64, modulus: f64) -> f64 {
    let (inner, outer) = (0.25 * bore * bore, (0.5 * bore + wall) * (0.5 * bore + wall));
    2.0 / modulus * ((outer + inner) / (outer - inner) + POISSON)
}

/// Compliance of free air, 1/Pa, of the fraction `air` at the pressure of the air, under the absolute pressure `pressure`.
pub fn air_compliance(air: f64, pressure: f64) -> f64 {
    air * ATMOSPHERE / (BUBBLES * pressure * pressure)
}

/// Stiffness of the column in rebound, N/m: the chamber on the rod's side yields.
pub fn rebound_stiffness(modulus: f64, bore: f64, rod: f64, length: f64) -> f64 {
    modulus * annulus(bore, rod) / length
}

/// Modulus that gives the column in rebound a stiffness, Pa.
pub fn modulus_of_rebound(stiffness: f64, bore: f64, rod: f64, length: f64) -> f64 {
    stiffness * length / annulus(bore, rod)
}

/// Stiffness in compression over that in rebound. In a monotube the chamber on the rod's side yields in both directions. In a twin tube
/// both chambers yield together, by the volume of the rod.
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

/// Stroke that free air yields at most, m, and the force at which half of it is used, N.
///
/// Bubbles under p follow V p = constant; with the force F on the area A they give g F / (F + p A), as the element `aeration` does.
pub fn air_stroke(air: f64, pressure: f64, bore: f64, rod: f64, length: f64) -> (f64, f64) {
    (air * length * ATMOSPHERE / (BUBBLES * pressure), pressure * annulus(bore, rod))
}

/// Free air at the pressure of the air that yields a stroke.
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
        // 2 mm of steel about 40 mm: a modulus near 10 GPa.
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
        // The slope of the stroke at no force is the compliance of the air in the column.
        let slope = air_stroke(0.01, 6e5, 0.03, 0.012, 0.13);
        let of_modulus = 1.0 / rebound_stiffness(1.0 / air_compliance(0.01, 6e5), 0.03, 0.012, 0.13);
        assert!((slope.0 / slope.1 / of_modulus - 1.0).abs() < 1e-12);
    }
}
