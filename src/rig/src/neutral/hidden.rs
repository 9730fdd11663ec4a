//! Interface of effects that can be injected into the neutral damper. The effects themselves are in [`crate::hidden`].

use super::instant::{Here, Rest};
use super::{Mount, ValveLaw};

/// An injected effect. The default methods do not change the neutral damper. An effect overrides the methods for the
/// quantities that it changes.
pub(crate) trait DamperEffect: Send + Sync {
    /// Returns the error tolerance of each state per step, in the unit of the state.
    fn tolerances(&self) -> &[f64] {
        &[]
    }
    /// Initializes the states before a test. Before the call, the states have their values from the end of the
    /// preceding test, or zero before the first test.
    fn begin(&self, _rest: &Rest, states: &mut [f64]) {
        states.fill(0.0);
    }
    /// Advances the states of the effect over a pause of a number of seconds between tests.
    fn pause(&self, _seconds: f64, _states: &mut [f64]) {}
    /// Computes the time derivatives of the effect's states.
    fn rates(&self, _here: &Here, _states: &[f64], _rates: &mut [f64]) {}

    /// Returns the magnitude of additional friction, N.
    fn friction_n(&self, _here: &Here, _states: &[f64]) -> f64 {
        0.0
    }
    /// Returns the friction force relative to its magnitude, -1..1, or `None` to keep the smooth sign of the velocity.
    fn friction_direction(&self, _here: &Here, _states: &[f64]) -> Option<f64> {
        None
    }
    /// Returns an additional force between moving end and ground, in parallel with the damper, N.
    fn parallel_force_n(&self, _here: &Here, _states: &[f64]) -> f64 {
        0.0
    }
    /// Returns the deflection of the series spring beyond its play, m, and the engaged fraction, 0..1, of the series
    /// damper. `None` means no play.
    fn gap(&self, _deflection_m: f64) -> Option<(f64, f64)> {
        None
    }
    /// Returns a force, N, that replaces that of the linear series spring, or `None` to keep the spring.
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
    /// Returns the flow that bypasses the valves, as a piston velocity, m/s.
    fn bypass_m_s(&self, _here: &Here, _states: &[f64]) -> f64 {
        0.0
    }
    /// Returns the flow through the valves as a piston velocity, m/s, at the oil force `force_n`, N, or `None` to keep
    /// the valve law.
    fn valve_flow_m_s(&self, _valves: &ValveLaw, _force_n: f64, _states: &[f64]) -> Option<f64> {
        None
    }
    /// Returns the mass, kg, that is added to the mass between series spring and valves.
    fn inertance_kg(&self, _here: &Here) -> f64 {
        0.0
    }
    /// Returns the delay of the force channel, s.
    fn delay_s(&self) -> f64 {
        0.0
    }
    /// Returns the force, N, that the load cell shows at the force `force_n`, N.
    fn cell_n(&self, force_n: f64, _here: &Here, _states: &[f64]) -> f64 {
        force_n
    }
}
