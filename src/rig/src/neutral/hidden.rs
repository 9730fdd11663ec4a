//! Where an effect can be hidden in the neutral damper. The effects themselves stand in [`crate::hidden`].

use super::instant::{Here, Rest};
use super::{Mount, ValveLaw};

/// One effect at work. The defaults do nothing; an effect overrides the places where it acts.
pub(crate) trait Hidden: Send + Sync {
    /// One per state: the change that counts as an error in a step, in the unit of the state.
    fn tolerances(&self) -> &[f64] {
        &[]
    }
    /// At rest before a test. The states come as the last test left them, zero before the first.
    fn begin(&self, _rest: &Rest, states: &mut [f64]) {
        states.fill(0.0);
    }
    /// A pause between tests, for states that last longer than a test.
    fn pause(&self, _seconds: f64, _states: &mut [f64]) {}
    /// Rates of the states.
    fn rates(&self, _here: &Here, _states: &[f64], _rates: &mut [f64]) {}

    /// Added to the level of friction, N.
    fn friction_n(&self, _here: &Here, _states: &[f64]) -> f64 {
        0.0
    }
    /// Replaces the smooth sign of friction, -1..1.
    fn friction_direction(&self, _here: &Here, _states: &[f64]) -> Option<f64> {
        None
    }
    /// Force beside the damper, from driven end to ground, N.
    fn beside_n(&self, _here: &Here, _states: &[f64]) -> f64 {
        0.0
    }
    /// Deflection left for the series element, m, and the share of its damper that is engaged.
    fn gap(&self, _deflection_m: f64) -> Option<(f64, f64)> {
        None
    }
    /// Replaces the spring of the series element, N.
    fn mount_n(&self, _mount: &Mount, _deflection_m: f64, _here: &Here, _states: &[f64]) -> Option<f64> {
        None
    }
    /// Compliance added to the oil column, m/N.
    fn compliance_m_n(&self, _here: &Here, _states: &[f64]) -> f64 {
        0.0
    }
    /// Force at a given flow, relative to the neutral damper.
    fn resistance(&self, _here: &Here, _states: &[f64]) -> f64 {
        1.0
    }
    /// Flow past the valves, as a velocity, m/s.
    fn bypass_m_s(&self, _here: &Here, _states: &[f64]) -> f64 {
        0.0
    }
    /// Replaces the flow through the valves, m/s.
    fn valve_flow_m_s(&self, _valves: &ValveLaw, _force_n: f64, _states: &[f64]) -> Option<f64> {
        None
    }
    /// Mass added behind the series element, kg.
    fn inertance_kg(&self, _here: &Here) -> f64 {
        0.0
    }
    /// By how much the force channel is late, s.
    fn delay_s(&self) -> f64 {
        0.0
    }
    /// What the load cell makes of a force, N.
    fn cell_n(&self, force_n: f64, _here: &Here, _states: &[f64]) -> f64 {
        force_n
    }
}
