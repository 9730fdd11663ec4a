//! State of a damper between steps, and its output.

use crate::element::ForceComponent;

/// Largest number of internal states of a model.
pub const MAX_INTERNAL: usize = 8;

/// State of one damper: plain numbers, which the host owns and copies. Hysteresis is always a continuous state, never a
/// stored reversal point. To repeat a rejected step or save a run, the host therefore only copies the state.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct State {
    /// Displacement of the moving end, m (given by the host, or integrated from the initial position).
    pub displacement: f64,
    /// Velocity of the moving end at the end of the last step, m/s.
    pub velocity: f64,
    /// Displacement of the internal mass, m.
    pub mass_displacement: f64,
    /// Velocity of the internal mass, m/s.
    pub mass_velocity: f64,
    /// Internal states of the elements that are on, consecutive from index 0, each in its own unit.
    pub internal: [f64; 8],
    /// Layout of the internal states: a number for the set of elements that have one (see [`crate::layout`]); 0 if not
    /// set.
    pub layout: f64,
    /// Always 0. With this number, the state has seven pairs of numbers, which processors load pair by pair.
    pub reserved: f64,
}

const _: () = assert!(MAX_INTERNAL == 8);

impl State {
    /// All zero.
    pub const ZERO: State = State {
        displacement: 0.0,
        velocity: 0.0,
        mass_displacement: 0.0,
        mass_velocity: 0.0,
        internal: [0.0; 8],
        layout: 0.0,
        reserved: 0.0,
    };

    /// Returns whether displacements, velocities and internal states are finite.
    #[inline(always)]
    pub fn is_finite(&self) -> bool {
        let mut sum = (self.displacement + self.velocity) + (self.mass_displacement + self.mass_velocity);
        for z in self.internal {
            sum += z;
        }
        sum * 0.0 == 0.0
    }
}

/// Output at one instant.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Output {
    /// Damper force, N, tension positive.
    pub force: f64,
    /// Derivative of the force with respect to the input's displacement, N/m. An evaluation at an instant returns the
    /// derivative at constant states, a step returns the total derivative.
    pub d_force_d_displacement: f64,
    /// Derivative of the force with respect to the input's velocity, N s/m. An evaluation at an instant returns the
    /// derivative at constant states, a step returns the total derivative.
    pub d_force_d_velocity: f64,
    /// Hydraulic force, N: that of the primary damper (FV curve), with the effects of oil and valves.
    pub primary_force: f64,
    /// Force of the springs on the internal mass, N.
    pub spring_force: f64,
    /// Friction including presliding friction, N.
    pub friction_force: f64,
    /// Gas force including the gas spring, N; negative if it pushes the rod out.
    pub gas_force: f64,
    /// Deflection of the series compliance, m.
    pub series_deflection: f64,
    /// Force of the stops at the ends of the stroke, N.
    pub stop_force: f64,
    /// Temperature of the oil at which the forces are computed, °C.
    pub oil_temperature: f64,
}

impl Output {
    /// All zero.
    pub const ZERO: Output = Output {
        force: 0.0,
        d_force_d_displacement: 0.0,
        d_force_d_velocity: 0.0,
        primary_force: 0.0,
        spring_force: 0.0,
        friction_force: 0.0,
        gas_force: 0.0,
        series_deflection: 0.0,
        stop_force: 0.0,
        oil_temperature: 0.0,
    };

    /// Returns whether every number is finite.
    #[inline(always)]
    pub fn is_finite(&self) -> bool {
        let forces = (self.force + self.d_force_d_displacement) + (self.d_force_d_velocity + self.primary_force);
        let parts = (self.spring_force + self.friction_force) + (self.gas_force + self.series_deflection);
        (forces + parts + (self.stop_force + self.oil_temperature)) * 0.0 == 0.0
    }
}

impl Output {
    /// Adds the force of an element, N, to the friction or gas force, as `component` says. The total force does not
    /// change.
    pub(crate) fn count(&mut self, component: ForceComponent, force: f64) {
        match component {
            ForceComponent::Total => {}
            ForceComponent::Friction => self.friction_force += force,
            ForceComponent::Gas => self.gas_force += force,
        }
    }
}
