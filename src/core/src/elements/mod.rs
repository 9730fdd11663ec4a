//! The physical effects, one file each: equation, parameters, states and partial derivatives.
//!
//! [`mod@crate::list`] defines the position of each effect in the model.

pub(crate) mod aeration;
pub(crate) mod bump_stop;
pub(crate) mod bushing;
pub(crate) mod cavitation;
pub(crate) mod coulomb_friction;
pub(crate) mod end_stop;
pub(crate) mod free_play;
pub(crate) mod frequency_selective_damping;
pub mod fv_curve;
pub(crate) mod gas_preload;
pub(crate) mod gas_spring;
pub(crate) mod gas_warming;
pub(crate) mod lagged_polynomial;
pub(crate) mod moving_mass;
pub(crate) mod oil_compressibility;
pub(crate) mod parallel_spring;
pub(crate) mod passage;
pub(crate) mod position_dependent_damping;
pub(crate) mod presliding_friction;
pub(crate) mod rebound_stop;
pub(crate) mod series_compliance;
pub(crate) mod side_force_friction;
pub(crate) mod soft_gap;
pub(crate) mod stribeck_friction;
pub(crate) mod temperature_fade;
pub(crate) mod valve_hysteresis;
pub(crate) mod viscous_friction;
