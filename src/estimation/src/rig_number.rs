//! A number of the rig in a fit: what the measurement is off by.

use crate::measurement::Artefact;

/// A number of the rig in a fit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RigNumber {
    /// What it is.
    pub artefact: Artefact,
    /// Where it starts.
    pub start: f64,
    /// What is usual of a rig: mean and standard deviation.
    pub usual: (f64, f64),
}

/// Standard deviations that a number may be from what is usual.
const FARTHEST: f64 = 5.0;
impl RigNumber {
    /// Bounds.
    pub fn bounds(&self) -> (f64, f64) {
        (self.usual.0 - FARTHEST * self.usual.1, self.usual.0 + FARTHEST * self.usual.1)
    }
}
