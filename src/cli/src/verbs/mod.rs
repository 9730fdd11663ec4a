//! Verbs of the command, with one file each.

pub mod bench;
pub mod check;
pub mod completions;
mod data;
pub mod demo;
pub mod diagnose;
mod diagnose_args;
mod diagnose_settings;
mod diagnosed;
mod dimensions;
pub mod explain;
pub mod export;
mod family;
pub mod fit;
mod groups;
mod host_step;
pub mod import;
pub mod import_profile;
pub mod man;
pub mod manoeuvre;
pub mod matrix;
mod model;
pub mod open;
mod record_notes;
pub mod rig;
pub mod setting;
pub mod simulate;
mod simulate_setting;
pub mod validate;
mod verdict;

pub use verdict::Verdict;
