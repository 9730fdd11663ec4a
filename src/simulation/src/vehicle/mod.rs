//! A vehicle on four dampers, stepped as a real-time simulator steps.
//!
//! The damper forces of one step are held through the next, and the dampers answer the motion that results.
//!
//! Small on purpose: it shows what a damper model changes in a vehicle, it does not predict one.

mod car;
mod manoeuvre;
mod run;
mod too_fast;

pub use car::{Body, Car, CarError, CarValue};
pub use manoeuvre::{Manoeuvre, Road};
pub use run::{CORNERS, Corner, Dampers, Quiet, Run, SLOW, Sample, VehicleError, run, run_with, without_chatter};
pub use too_fast::{Blame, TooFast};
