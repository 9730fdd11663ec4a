//! Rig records: reading files of every usual kind, cleaning them, and saying what was done.
//!
//! [`load`] is the way in. After it everything is SI, rebound (extension) and tension positive.

mod campaign;
mod channel;
mod cleaning;
mod consistency;
mod csv;
mod derive;
mod error;
#[cfg(test)]
mod fixtures;
mod mat;
mod motion;
mod noise;
mod options;
mod plausibility;
pub mod record;
mod samples;
mod sign;
mod table;
mod xlsx;

pub use campaign::{Campaign, Progress, load};
pub use channel::{Channel, Dimension, Unit, assignment};
pub use error::{Place, RecordError};
pub use motion::{MotionRecord, read_motion};
pub use options::{Options, Positive};
pub use record::{Noise, NoiseSource, Note, Record};
pub use sign::SignFinding;
