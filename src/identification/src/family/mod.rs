//! Identification of one damper family from records at several settings.
//!
//! | module | what |
//! |---|---|
//! | [`settings`] | records sorted by their setting; reasons why no family can be fitted |
//! | [`actuator`] | response of the valve, from tests with a changing setting |
//! | [`at_setting()`] | ordinary damper at a setting, with its intervals |
//! | [`actuator_numbers()`] | nonzero parameters of the actuator in a model file, with their intervals where known |
//! | [`interpolation_error`] | bound on the error between two settings |
//! | [`FamilyFigures`] | figures of a fit as JSON |
//! | [`fit`] | fit of structure, numbers and their dependence on the setting |
//! | [`left_out`] | prediction of a setting from the other settings |
//! | [`setting_labels`] | check of the stated settings against the forces |
//! | [`model_file`] | model file of a family |

mod actuator;
mod actuator_numbers;
mod at_setting;
mod figures;
mod fit;
mod interpolation_error;
mod left_out;
pub mod model_file;
mod selection;
pub(crate) mod setting_labels;
mod settings;

pub use actuator::{ActuatorDecision, ActuatorFit};
pub use actuator_numbers::{ActuatorNumber, actuator_numbers};
pub use at_setting::{at_setting, interpolated_between, is_of_grid};
pub use figures::FamilyFigures;
pub use fit::{FamilyEstimate, FamilyFit, FamilyItem, ForceAtSetting, SettingDependence, fit_family};
pub use left_out::{SettingError, SettingReport, WorstLeftOut};
pub use setting_labels::LABEL_DOUBT_RATIO;
pub use settings::{FamilyError, SettingAxis, SettingRecords};

/// Divisor of the log odds of a family's part before their conversion to a probability. The form errors of different tests are correlated,
/// so the tests contain less information than their number suggests.
const TEMPERATURE: f64 = 2.0;
