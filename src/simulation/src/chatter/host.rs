//! A host as far as chatter goes.

/// A host as far as chatter goes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Host {
    /// Its step, s.
    pub step: f64,
    /// The lightest mass that the damper moves, kg.
    pub mass: f64,
}

impl Host {
    /// A real-time host with the lightest mass that a damper of a car moves.
    ///
    /// Wheel, hub and half the links of a small car's front corner.
    pub const TYPICAL: Host = Host { step: 1e-3, mass: 40.0 };
}
