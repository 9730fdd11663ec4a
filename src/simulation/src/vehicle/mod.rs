//! Simulation of a vehicle on four dampers, with the fixed step of a real-time simulator.
//!
//! The damper forces are constant over the next step of the vehicle (zero-order hold). The dampers then respond to the resulting motion.
//!
//! The model is deliberately small. It shows the effect of a damper model on a vehicle, and does not predict a real vehicle.

mod car;
mod manoeuvre;
mod run;
mod too_fast;

pub use car::{Body, Car, CarError, CarValue};
pub use manoeuvre::{Manoeuvre, Road};
pub use run::{CORNERS, Corner, Dampers, Quiet, Run, SLOW, Sample, VehicleError, run, run_with, without_chatter};
pub use too_fast::{Blame, TooFast};
