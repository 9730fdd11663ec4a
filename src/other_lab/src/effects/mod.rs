//! Effects that can be injected into a damper or its rig: one file per effect, which contains its laws (alternative
//! equations) with their sources.
//!
//! At strength 0, a law has no influence. Its influence increases monotonically with the strength, and 1 is a typical
//! case.

mod aeration;
mod bump_stop;
mod bushing;
mod cavitation;
mod channel_delay;
mod coulomb_friction;
mod force_drift;
mod force_offset;
mod free_play;
mod frequency_selective_damping;
mod gas_preload;
mod gas_spring;
mod gas_warming;
mod moving_mass;
mod oil_compressibility;
mod parallel_spring;
mod position_dependent_damping;
mod presliding_friction;
mod rebound_stop;
mod series_compliance;
mod side_force_friction;
mod stop;
mod stribeck_friction;
mod temperature_fade;
mod unknown;
mod valve_hysteresis;
mod viscous_friction;

use crate::draw::Draw;
use crate::plant::Scale;

/// Quantities available to an effect at one instant.
#[derive(Debug, Clone, Copy)]
pub struct Here {
    /// Time since the start of the record, s.
    pub t: f64,
    /// Time since the start of the campaign, s.
    pub clock: f64,
    /// Elapsed fraction of the campaign.
    pub progress: f64,
    /// Displacement, m, velocity, m/s, and acceleration, m/s², of the moving end.
    pub input: crate::jet::Jet,
    /// Displacement of the part of the damper with friction and springs, m.
    pub x: f64,
    /// Velocity of the part of the damper with friction and springs, m/s.
    pub v: f64,
    /// Hydraulic force from the pressure differences across the valves, N, positive in rebound.
    pub hydraulic: f64,
    /// Elastic force of the mount, N.
    pub mount: f64,
    /// Rate of the mount's deflection without the injected effects in series with it, m/s.
    pub mount_rate: f64,
    /// Side force on the rod, N.
    pub side: f64,
    /// Temperature of the oil, °C.
    pub oil_c: f64,
}

/// Quantities available to a sensor at a sample.
#[derive(Debug, Clone, Copy)]
pub struct Reading {
    /// Time since the start of the record, s.
    pub t: f64,
    /// Time since the start of the campaign, s.
    pub clock: f64,
    /// Elapsed fraction of the campaign.
    pub progress: f64,
    /// Displacement, m, velocity, m/s, and acceleration, m/s², of the moving end.
    pub input: crate::jet::Jet,
    /// Force in the force channel before this effect is added, N.
    pub force: f64,
    /// Temperature of the oil, °C.
    pub oil_c: f64,
    /// Largest force of the test, N.
    pub peak: f64,
}

/// A law of an effect that can be injected. It overrides the functions of the quantities that it influences.
pub trait EffectModel: Send + Sync {
    /// Returns the error tolerances of the effect's states, one per state.
    fn tolerances(&self) -> &[f64] {
        &[]
    }
    /// Computes the time derivatives of the effect's states.
    fn rates(&self, _: &Here, _states: &[f64], _rates: &mut [f64]) {}
    /// Returns an additional force in parallel with the damper, N.
    fn parallel(&self, _: &Here, _states: &[f64]) -> f64 {
        0.0
    }
    /// Returns an additional compliance in series with the mount, m/N.
    fn series(&self, _: &Here, _states: &[f64]) -> f64 {
        0.0
    }
    /// Returns an additional force in parallel with the mount, N.
    fn parallel_to_mount(&self, _: &Here, _states: &[f64]) -> f64 {
        0.0
    }
    /// Returns an additional compliance of the oil column, m/N.
    fn column(&self, _: &Here, _states: &[f64]) -> f64 {
        0.0
    }
    /// Returns an additional flow that bypasses the valves, as a piston velocity, m/s.
    fn taken(&self, _: &Here, _states: &[f64]) -> f64 {
        0.0
    }
    /// Returns the factor by which the flow through the valves is multiplied.
    fn gain(&self, _: &Here, _states: &[f64]) -> f64 {
        1.0
    }
    /// Returns the factor by which the effective viscosity in the valves is multiplied.
    fn viscosity(&self, _: &Here, _states: &[f64]) -> f64 {
        1.0
    }
    /// Returns the force that the force channel shows in addition to the true force, N.
    fn reads(&self, _: &Reading) -> f64 {
        0.0
    }
    /// Transforms the force of a whole test in the force channel; `time` contains the times of `force`, s. The number
    /// of the test selects the values that are random from test to test.
    fn channel(&self, _test: u64, _time: &[f64], _force: &mut Vec<f64>) {}
    /// Returns the displacement that the displacement channel shows, m, at the true displacement `x`, m.
    fn displacement(&self, x: f64) -> f64 {
        x
    }
}

/// Function that makes a law with a strength. The other parameters of the law are drawn at random and scaled to the
/// damper.
pub type Make = fn(f64, &Scale, &mut Draw) -> Box<dyn EffectModel>;

/// An effect's name and laws.
pub struct Effect {
    /// Name of the effect.
    pub name: &'static str,
    /// Names of the laws, and the functions that make them.
    pub laws: &'static [(&'static str, Make)],
}

/// An effect in no catalog of damper models, to which a diagnosis should give no known name.
pub struct Unknown {
    /// Name and laws.
    pub effect: Effect,
    /// Whether the diagnosis of this project detects such an effect as unnamed.
    pub has_detector: bool,
}

/// Effects that a diagnosis should name.
pub const KNOWN: &[Effect] = &[
    gas_preload::EFFECT,
    gas_spring::EFFECT,
    coulomb_friction::EFFECT,
    stribeck_friction::EFFECT,
    presliding_friction::EFFECT,
    viscous_friction::EFFECT,
    side_force_friction::EFFECT,
    series_compliance::EFFECT,
    bushing::EFFECT,
    parallel_spring::EFFECT,
    oil_compressibility::EFFECT,
    aeration::EFFECT,
    cavitation::EFFECT,
    temperature_fade::EFFECT,
    position_dependent_damping::EFFECT,
    bump_stop::EFFECT,
    rebound_stop::EFFECT,
    free_play::EFFECT,
    frequency_selective_damping::EFFECT,
    valve_hysteresis::EFFECT,
    moving_mass::EFFECT,
    channel_delay::EFFECT,
    force_offset::EFFECT,
    force_drift::EFFECT,
    gas_warming::EFFECT,
];

/// Injected effects in no catalog of damper models, to which a diagnosis should give no known name.
pub const UNKNOWN: &[Unknown] = unknown::ALL;

/// Finds an effect by name, known or unknown. Returns `None` for any other name.
pub fn find(name: &str) -> Option<&'static Effect> {
    KNOWN.iter().chain(UNKNOWN.iter().map(|u| &u.effect)).find(|e| e.name == name)
}

/// Computes a smooth, algebraic sign function of the velocity `v`, which changes over the velocity `within`, m/s.
fn soft_sign(v: f64, within: f64) -> f64 {
    v / (v * v + within * within).sqrt()
}

/// Returns the names of all effects, known and unknown.
pub fn names() -> impl Iterator<Item = &'static str> {
    KNOWN.iter().chain(UNKNOWN.iter().map(|u| &u.effect)).map(|e| e.name)
}
