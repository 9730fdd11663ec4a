//! Identification of a damper, from rig records to a parameter set with intervals.
//!
//! The fit follows chapter 4 of the thesis. It obtains the FV curve from the peak-velocity points, and friction and gas force from the slow
//! tests. Then it refines all numbers together on the stitched records. Tests that the fit did not use decide between variants of friction
//! and spring.

mod as_the_fit_saw;
mod edited;
mod expected;
pub mod family;
mod fit;
mod fit_tables;
mod intervals;
mod inventory_text;
mod kind;
pub mod limits;
pub mod literature;
pub mod model_file;
pub mod of_peaks;
mod of_the_rig;
pub mod peaks;
mod phrases;
pub mod remarks;
pub mod setting_units;
mod short;
mod texts;
pub mod validation;

pub use as_the_fit_saw::AS_THE_FIT_SAW;
pub use dashpot_estimation::structure::inventory::InventoryItem;
pub use expected::describe_priors;
pub use fit::{Family, Fit, FitError, FitOptions, Stage, describe_roads, fit, select_tests};
pub use intervals::{Estimate, Standing};
pub use inventory_text::describe_item;
pub use kind::{KINDS, Kind};
pub use of_the_rig::{Measured, to_measurement_error};
pub use texts::{templates, words};
