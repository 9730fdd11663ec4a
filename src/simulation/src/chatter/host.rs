//! Properties of a host that determine chatter.

/// Step and mass of a host: a program that simulates a vehicle and computes the damper force in each of its steps.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Host {
    /// Step of the host, s.
    pub step: f64,
    /// Lightest mass that the damper moves, kg.
    pub mass: f64,
}

impl Host {
    /// Real-time host with a step of 1 ms and the lightest mass that a car damper moves.
    ///
    /// The mass consists of wheel, hub and half the links of a small car's front corner.
    pub const TYPICAL: Host = Host { step: 1e-3, mass: 40.0 };
}
