//! Validation of a model against the rig: error figures, the error matrix and hysteresis.
//!
//! The input is one [`Compared`] for each test. It contains the measured record, and two simulated forces at its samples: those of the full
//! model and of the force–velocity curve alone. Every figure is given for both simulated forces. The effort of a full model is justified
//! only if its error is smaller than that of the curve.
//!
//! | file | measure |
//! |---|---|
//! | [`Against`] | errors of the models of the literature on the same tests |
//! | [`deviation`] | mean absolute error, error percent, speed regions, root mean square |
//! | [`hysteresis`] | force gap between rising and falling velocity, loop area, energy per cycle |
//! | [`ResponseTimes`] | times of the force response to a step of the setting |
//! | [`matrix`] | mean errors by amplitude, by peak velocity and for the slow friction tests |
//!
//! The definitions follow Jonnalagadda & Vyas, *Modelling of Automotive Suspension Damper*, KTH 2020, chapter 5. Thus, the figures are
//! comparable with those published there.

mod against;
mod campaign;
mod compared;
pub mod deviation;
pub mod hysteresis;
pub mod matrix;
mod of_test;
mod response;
mod setting_doubt;

pub use against::{Against, AgainstSummary, AgainstTest};
pub use campaign::{ChangingSummary, SettingSummary, Summary, Validation, validate};
pub use compared::{Compared, ValidationError};
pub use deviation::{Deviation, Errors, REGION_BOUNDARY};
pub use hysteresis::{GapBin, Hysteresis, OfEach};
pub use matrix::{ErrorMatrix, MatrixCell, MatrixRow, SLOW_PEAK_VELOCITY};
pub use of_test::{PeakForce, TestValidation};
pub use response::{ResponseTimes, SHORTEST_LEVEL, StepGroup, StepResponse, TimeUncertainty, measured_times};
pub use setting_doubt::SettingDoubt;
