//! From records at several settings to one damper over the setting.
//!
//! | module | what |
//! |---|---|
//! | [`settings`] | the records sorted by their setting, and what is wrong with them |
//! | [`actuator`] | the response of the valve, from tests whose setting changes |
//! | [`at_setting()`] | the ordinary damper at a setting, with its intervals |
//! | [`actuator_numbers()`] | the numbers of the valve that a model file has |
//! | [`interpolation_error`] | how far a damper between two settings may be off |
//! | [`FamilyFigures`] | the figures of a fit as JSON |
//! | [`fit`] | the fit: structure, numbers, what depends on the setting |
//! | [`left_out`] | how well a setting is predicted by the others |
//! | [`setting_labels`] | whether the settings that tests state fit their forces |
//! | [`model_file`] | the model file of a family |

mod actuator;
mod actuator_numbers;
mod at_setting;
mod figures;
mod fit;
mod interpolation_error;
mod left_out;
pub mod model_file;
mod selection;
mod setting_labels;
mod settings;

pub use actuator::{ActuatorDecision, ActuatorFit};
pub use actuator_numbers::{ActuatorNumber, actuator_numbers};
pub use at_setting::at_setting;
pub use figures::FamilyFigures;
pub use fit::{FamilyEstimate, FamilyFit, FamilyItem, ForceAtSetting, SettingDependence, fit_family};
pub use left_out::{SettingError, SettingReport, WorstLeftOut};
pub use settings::{FamilyError, SettingAxis, SettingRecords};

/// Temperature by which log odds of a part of a family are divided before they become probabilities: the form error is correlated between
/// tests.
const TEMPERATURE: f64 = 2.0;
