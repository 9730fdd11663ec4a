//! Bore, rod and the two oil chambers.

use std::f64::consts::FRAC_PI_4;

/// Dimensions of the tube and its chambers.
#[derive(Debug, Clone, PartialEq)]
pub struct Tube {
    /// Inner diameter of the tube, m.
    pub bore_m: f64,
    /// Diameter of the rod, m.
    pub rod_m: f64,
    /// Length of the rebound chamber at mid-stroke, m.
    pub rebound_length_m: f64,
    /// Length of the compression chamber at mid-stroke, m.
    pub compression_length_m: f64,
    /// Stiffness of the tube wall as a bulk modulus, Pa: pressure divided by the relative increase of volume. For a
    /// thin wall, it is `E t / (D (5/4 - nu))` with Young's modulus E, wall thickness t, diameter D and Poisson's ratio
    /// nu.
    pub wall_modulus_pa: f64,
}

impl Default for Tube {
    fn default() -> Self {
        Self {
            bore_m: 0.046,
            rod_m: 0.011,
            rebound_length_m: 0.110,
            compression_length_m: 0.120,
            wall_modulus_pa: 8.0e9,
        }
    }
}

impl Tube {
    /// Returns the area of the piston on the compression side, m².
    pub fn piston_m2(&self) -> f64 {
        FRAC_PI_4 * self.bore_m * self.bore_m
    }

    /// Returns the area of the rod, m².
    pub fn rod_area_m2(&self) -> f64 {
        FRAC_PI_4 * self.rod_m * self.rod_m
    }

    /// Returns the area of the piston on the rebound side, m².
    pub fn annulus_m2(&self) -> f64 {
        self.piston_m2() - self.rod_area_m2()
    }
}
