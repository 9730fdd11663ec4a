//! The virtual rig: a physical damper on a test rig, and the measured campaigns.
//!
//! It is an independent reference for identification and diagnosis, so its equations differ from those of the
//! identified model. It has compressible oil chambers instead of a spring, valves instead of a force-velocity table,
//! and a bristle seal instead of a friction curve.
//!
//! A second, *neutral* damper with the model's own topology allows the injection of physical effects for a diagnosis:
//! [`InjectedCase`].
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
