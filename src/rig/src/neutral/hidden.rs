//! Interface of effects that can be injected into the neutral damper. The effects themselves are in [`crate::hidden`].

use super::instant::{Here, Rest};
use super::{Mount, ValveLaw};

/// An injected effect. The default methods have no influence. An effect overrides the methods for the quantities that
/// it changes.
pub(crate) trait Hidden: Send + Sync {
    /// Returns the error tolerance of each state per step, in the unit of the state.
    fn tolerances(&self) -> &[f64] {
        &[]
    }
    /// Initializes the states before a test. Before the call, the states have their values from the end of the
    /// preceding test, or zero before the first test.
    fn begin(&self, _rest: &Rest, states: &mut [f64]) {
        states.fill(0.0);
    }
    /// Advances the lasting states over a pause between tests.
    fn pause(&self, _seconds: f64, _states: &mut [f64]) {}
    /// Computes the rates of the effect's states.
    fn rates(&self, _here: &Here, _states: &[f64], _rates: &mut [f64]) {}

    /// Returns additional friction, N.
    fn friction_n(&self, _here: &Here, _states: &[f64]) -> f64 {
        0.0
    }
    /// Returns a replacement of the smooth sign of friction, -1..1, or `None` to keep the smooth sign.
    fn friction_direction(&self, _here: &Here, _states: &[f64]) -> Option<f64> {
        None
    }
    /// Returns an additional force in parallel with the damper, from the moving end to ground, N.
    fn beside_n(&self, _here: &Here, _states: &[f64]) -> f64 {
        0.0
    }
    /// Returns the deflection of the series element without its play, m, and the engaged fraction of its damper. `None`
    /// means no play.
    fn gap(&self, _deflection_m: f64) -> Option<(f64, f64)> {
        None
    }
    /// Returns a replacement of the series spring's force, N, or `None` to keep the series spring.
    fn mount_n(&self, _mount: &Mount, _deflection_m: f64, _here: &Here, _states: &[f64]) -> Option<f64> {
        None
    }
    /// Returns the additional compliance of the oil column, m/N.
    fn compliance_m_n(&self, _here: &Here, _states: &[f64]) -> f64 {
        0.0
    }
    /// Returns the ratio of the force at a given valve flow to the force of the neutral damper at this flow.
    fn resistance(&self, _here: &Here, _states: &[f64]) -> f64 {
        1.0
    }
    /// Returns the flow that bypasses the valves, as a velocity, m/s.
    fn bypass_m_s(&self, _here: &Here, _states: &[f64]) -> f64 {
        0.0
    }
    /// Returns a replacement of the flow through the valves, m/s, or `None` to keep the valve law.
    fn valve_flow_m_s(&self, _valves: &ValveLaw, _force_n: f64, _states: &[f64]) -> Option<f64> {
        None
    }
    /// Returns the additional mass in series with the mount, kg.
    fn inertance_kg(&self, _here: &Here) -> f64 {
        0.0
    }
    /// Returns the delay of the force channel, s.
    fn delay_s(&self) -> f64 {
        0.0
    }
    /// Returns the load cell's reading of a force, N.
    fn cell_n(&self, force_n: f64, _here: &Here, _states: &[f64]) -> f64 {
        force_n
    }
}
