//! Areas of rod and piston.

use std::f64::consts::FRAC_PI_4;

/// Computes the area of a circle, m², from its diameter, m.
pub fn area(diameter: f64) -> f64 {
    FRAC_PI_4 * diameter * diameter
}

/// Computes the area of the piston on the rod's side, m², from the diameters of bore and rod, m.
pub fn annulus(bore: f64, rod: f64) -> f64 {
    area(bore) - area(rod)
}
