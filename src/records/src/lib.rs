//! Rig records: reading files of every usual kind, cleaning them, and saying what was done.
//!
//! [`load`] is the way in. After it everything is SI, rebound (extension) and tension positive.

mod about;
mod at_speed;
mod beside;
mod campaign;
mod channel;
mod cleaning;
pub mod clock;
mod consistency;
mod csv;
mod delay;
pub mod delimiter;
mod derive;
mod error;
mod file_units;
#[cfg(test)]
mod fixtures;
pub mod glob;
mod heading;
pub mod hold_out;
mod lvm;
mod mat;
mod mdf;
mod motion;
mod noise;
mod not_read;
mod off_the_others;
mod one_clock;
mod options;
mod peak_table;
mod phrases;
mod plausibility;
pub mod profile;
pub mod record;
mod rpc;
mod samples;
pub mod sentence;
mod sign;
mod slips;
pub mod smoothing;
mod swapped;
mod table;
pub mod taken_out;
mod tdms;
mod torn;
mod unit;
mod unusable;
mod xlsx;

pub use about::About;
pub use campaign::{Campaign, ENDINGS, Progress, is_record_name, load};
pub use channel::{Channel, assignment};
pub use delay::Delay;
pub use error::{FilesUnit, Place, RecordError};
pub use motion::{MotionRecord, read_motion};
pub use one_clock::apart;
pub use options::{Options, Positive};
pub use peak_table::{PeakPoint, read_peaks};
pub use phrases::texts;
pub use profile::Profile;
pub use record::{Noise, NoiseSource, Note, Record};
pub use sentence::Sentence;
pub use sign::SignFinding;
pub use unit::{Dimension, Unit};
pub use unusable::Unusable;
