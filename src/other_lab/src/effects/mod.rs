//! What may be hidden in a damper or on its rig: one file an effect, every law with its source.
//!
//! A law's strength 0 is neutral and its effect grows steadily with strength; 1 is a plain case of it.

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

/// What an effect knows of the instant.
#[derive(Debug, Clone, Copy)]
pub struct Here {
    /// Time in the record, s.
    pub t: f64,
    /// Time in the campaign, s.
    pub clock: f64,
    /// Share of the campaign's time that has passed.
    pub progress: f64,
    /// Displacement, velocity and acceleration of the driven end.
    pub input: crate::jet::Jet,
    /// Displacement of the part of the damper where friction and springs act, m.
    pub x: f64,
    /// Its velocity, m/s.
    pub v: f64,
    /// Hydraulic force, N.
    pub hydraulic: f64,
    /// Elastic force of the mount, N.
    pub mount: f64,
    /// Rate of the mount's own deflection, m/s.
    pub mount_rate: f64,
    /// Side force, N.
    pub side: f64,
    /// Temperature of the oil, °C.
    pub oil_c: f64,
}

/// What a sensor reads at a sample.
#[derive(Debug, Clone, Copy)]
pub struct Reading {
    /// Time in the record, s.
    pub t: f64,
    /// Time in the campaign, s.
    pub clock: f64,
    /// Share of the campaign's time that has passed.
    pub progress: f64,
    /// Motion of the driven end.
    pub input: crate::jet::Jet,
    /// Force so far, N.
    pub force: f64,
    /// Temperature of the oil, °C.
    pub oil_c: f64,
    /// Largest force of the test, N.
    pub peak: f64,
}

/// An effect. It says where it acts by the functions that it replaces.
pub trait EffectModel: Send + Sync {
    /// Tolerances of its states, as many as there are.
    fn tolerances(&self) -> &[f64] {
        &[]
    }
    /// Rates of its states.
    fn rates(&self, _: &Here, _states: &[f64], _rates: &mut [f64]) {}
    /// Force parallel to the damper, N.
    fn parallel(&self, _: &Here, _states: &[f64]) -> f64 {
        0.0
    }
    /// Compliance in line with the mount, m/N.
    fn series(&self, _: &Here, _states: &[f64]) -> f64 {
        0.0
    }
    /// Force beside the mount, N.
    fn parallel_to_mount(&self, _: &Here, _states: &[f64]) -> f64 {
        0.0
    }
    /// Compliance of the oil column, m/N.
    fn column(&self, _: &Here, _states: &[f64]) -> f64 {
        0.0
    }
    /// Velocity that does not reach the valves, m/s.
    fn taken(&self, _: &Here, _states: &[f64]) -> f64 {
        0.0
    }
    /// Factor on what the valves pass.
    fn gain(&self, _: &Here, _states: &[f64]) -> f64 {
        1.0
    }
    /// Factor on the viscosity that the valves feel.
    fn viscosity(&self, _: &Here, _states: &[f64]) -> f64 {
        1.0
    }
    /// What the force channel reads more, N.
    fn reads(&self, _: &Reading) -> f64 {
        0.0
    }
    /// What becomes of the force over time in the channel: `force` at the instants `time`.
    fn channel(&self, _test: u64, _time: &[f64], _force: &mut Vec<f64>) {}
    /// What the displacement channel reads of a displacement, m.
    fn displacement(&self, x: f64) -> f64 {
        x
    }
}

/// Makes an effect of a strength that suits a damper.
pub type Make = fn(f64, &Scale, &mut Draw) -> Box<dyn EffectModel>;

/// An effect's name and laws.
pub struct Effect {
    /// Its name.
    pub name: &'static str,
    /// Names of its laws, and what makes them.
    pub laws: &'static [(&'static str, Make)],
}

/// Something that is in no list of damper models.
pub struct Unknown {
    /// Its name and laws.
    pub effect: Effect,
    /// Whether the diagnosis of this project has a detector for such a thing, which says so without a name for it.
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

/// Effects that a diagnosis should not give a name of the others.
pub const UNKNOWN: &[Unknown] = unknown::ALL;

/// An effect by name, known or not.
pub fn find(name: &str) -> Option<&'static Effect> {
    KNOWN.iter().chain(UNKNOWN.iter().map(|u| &u.effect)).find(|e| e.name == name)
}

/// A smooth sign that turns over within a speed, without an exponential.
fn soft_sign(v: f64, within: f64) -> f64 {
    v / (v * v + within * within).sqrt()
}

/// All names.
pub fn names() -> impl Iterator<Item = &'static str> {
    KNOWN.iter().chain(UNKNOWN.iter().map(|u| &u.effect)).map(|e| e.name)
}
