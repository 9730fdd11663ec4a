//! The virtual rig: a physical damper on a test bench, and the campaigns measured on it.
//!
//! It is the independent reality that identification and diagnosis are tried on, so it shares nothing with the model being
//! identified: chambers with compressible oil instead of a spring, valves instead of a force-velocity table, a bristle seal
//! instead of a friction curve.
//!
//! For a diagnosis there is a second, *neutral* damper of the model's own topology, in which physical effects can be hidden:
//! [`InjectedCase`].
//!
//! SI units; extension (rebound) displacement and velocity positive, tension force positive.
//!
//! `tests/first_use.rs` shows both at work.

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
