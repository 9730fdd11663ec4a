//! What the user may say about his records.

use std::collections::{BTreeMap, BTreeSet};
use std::str::FromStr;

use serde::Serialize;

use super::channel::{Channel, Unit};

/// The direction in which displacement, velocity and force of a file are counted positive.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Positive {
    /// Extension and tension positive, the convention inside.
    Rebound,
    /// Compression positive.
    Compression,
}

impl FromStr for Positive {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match text.trim().to_ascii_lowercase().as_str() {
            "rebound" | "extension" | "tension" => Ok(Positive::Rebound),
            "compression" | "bump" | "jounce" => Ok(Positive::Compression),
            _ => Err(format!("'{text}' should be rebound or compression")),
        }
    }
}

/// How to read a campaign; the default leaves everything to the files.
#[derive(Debug, Clone, Default)]
pub struct Options {
    /// Units given by the user; they win over the header (`--unit force=kN`).
    pub units: BTreeMap<Channel, Unit>,
    /// Column headings given by the user (`--column force="Load Cell 1"`).
    pub columns: BTreeMap<Channel, String>,
    /// Channels not to be read even if there is a column for them (`--ignore velocity`).
    pub ignore: BTreeSet<Channel>,
    /// Direction counted positive in the files, after the flips below; worked out from the data if not given.
    pub positive: Option<Positive>,
    /// Turn the sign of the force (`--flip force`).
    pub flip_force: bool,
    /// Turn the sign of displacement and velocity (`--flip motion`).
    pub flip_motion: bool,
    /// Displacement at the first sample, m, in the file's direction. Used where only a velocity was recorded.
    pub initial_position: f64,
}
