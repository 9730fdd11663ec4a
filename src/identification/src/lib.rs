//! Identification of a damper: makes a parameter set with intervals from rig records.
//!
//! The default model is after the thesis of Jonnalagadda & Vyas (*Modelling of Automotive Suspension Damper*, KTH 2020). The fit obtains a
//! first FV curve from the peak-velocity points, and first values of friction and gas force from the slow tests. Then a search fits all
//! numbers together, and decides on effects such as friction and springs by their posterior probability.

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
mod rare_values;
pub mod remarks;
pub mod setting_energy;
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
