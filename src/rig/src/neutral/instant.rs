//! Quantities at one instant, and in the equilibrium before a test.

/// Motion, side force, time and temperature that the rig imposes on the damper at one instant.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Line {
    /// Extension of the moving end from mid-stroke (m), its velocity (m/s) and acceleration (m/s²).
    pub displacement_m: f64,
    pub velocity_m_s: f64,
    pub acceleration_m_s2: f64,
    pub side_force_n: f64,
    /// Time since the start of the campaign, s.
    pub clock_s: f64,
    /// Peak velocity of the test, m/s.
    pub peak_velocity_m_s: f64,
    /// Temperature of the oil, °C.
    pub oil_c: f64,
}

/// Quantities available to an injected effect at one instant.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Here {
    pub line: Line,
    /// Position (m) and velocity (m/s) of the mass between series spring and valves.
    pub position_m: f64,
    pub velocity_m_s: f64,
    /// Deflection of the series spring (m) and its rate (m/s).
    pub deflection_m: f64,
    pub deflection_m_s: f64,
    /// Force of the oil on the mass, N.
    pub oil_n: f64,
    /// Force on the rod at the moving end, N. It is zero in the methods of [`super::DamperEffect`] for mount, friction and
    /// parallel forces, because it is computed from their results.
    pub rod_n: f64,
}

/// The damper in equilibrium before a test.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Rest {
    pub displacement_m: f64,
    /// Force on the rod of the neutral damper in this equilibrium, N.
    pub rod_n: f64,
}
