//! The elastic mount between piston and load cell: the elasticity of rod, rod end and fixture.

/// Elastic mount. The rig moves the tube, so the rod moves only by the deflection of the mount.
#[derive(Debug, Clone, PartialEq)]
pub struct Mount {
    /// Stiffness, N/m.
    pub stiffness_n_m: f64,
    /// Damping, N s/m.
    pub damping_n_s_m: f64,
    /// Mass of rod and piston, kg.
    pub rod_mass_kg: f64,
}

impl Default for Mount {
    fn default() -> Self {
        Self { stiffness_n_m: 9.0e6, damping_n_s_m: 600.0, rod_mass_kg: 0.5 }
    }
}

impl Mount {
    /// Computes the force of the mount on the load cell, N, from its deflection, m, and the rate of deflection, m/s.
    pub fn force_n(&self, deflection_m: f64, rate_m_s: f64) -> f64 {
        self.stiffness_n_m * deflection_m + self.damping_n_s_m * rate_m_s
    }
}
