//! The virtual rig: simulation of a physical damper on a test rig, and of the measured campaigns.
//!
//! The virtual rig is an independent reference for identification and diagnosis, so its equations differ from those of
//! the identified model. Its damper has compressible oil chambers instead of a spring, and valves instead of a
//! force-velocity table. Its seal friction is a bristle model instead of a friction curve.
//!
//! A second, *neutral* damper has the topology of the identified model and allows the injection of physical effects for
//! a diagnosis: [`InjectedCase`].
//!
//! All values are in SI units; extension (rebound) and tension are positive.
//!
//! `tests/first_use.rs` shows both dampers.

pub mod campaign;
pub mod damper;
mod draw;
mod drive;
mod error;
mod files;
mod heat;
mod hidden;
mod hidden_case;
pub mod matrix;
mod neutral;
mod plan;
mod sensors;
mod solver;

pub use campaign::{Campaign, Options, Record};
pub use damper::Damper;
pub use error::RigError;
pub use hidden::{EFFECTS, NOTHING, UNKNOWN_EFFECTS};
pub use hidden_case::{
    CLEAN_FORCE_FILE, InjectedCampaign, InjectedCase, InjectedEffect, SEALED_FOLDER, TRUTH_FILE, Truth,
};
pub use matrix::{Matrix, MatrixOptions, TestPoint};
pub use plan::{CHECK_PREFIX, PLANS, Plan};
