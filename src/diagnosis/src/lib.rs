//! Diagnosis: regions where a model and the records of its damper disagree, the missing physical effect, and the
//! residual after the effect is added.
//!
//! | file | step |
//! |---|---|
//! | [`mod@diagnose`] | the whole diagnosis |
//! | [`prepared`] | preparation of records |
//! | [`effects`] | description of each effect: location, and records that show it |
//! | [`composed`], [`outcome`] | the outcome in sentences and figures |
//! | [`rivals`] | effects that are not named but explain a part of the disagreement |
//! | [`decisions`], [`calibration`] | thresholds, and calibration of probabilities |
//! | [`tree`] | all probabilities: path, family, effect, form |
//! | [`detection_limit`] | size of effects that a diagnosis without a finding cannot exclude |
//! | [`phrases`] | English templates of all sentences |
//! | [`regions`] | regions where model and records disagree |
//! | [`mod@reference`], [`changes`] | form error shared by two dampers, and changes between them |
//! | [`groups`] | many dampers, each against one reference |
//! | [`settings`] | one damper at several settings: effects at all settings and at some settings |
//! | [`opposite`], [`warmer`] | differences between two campaigns that are not due to the damper |
//! | [`untestable`], [`proposed_test`] | effects that these records cannot show, and the tests that would show them |
//! | [`mod@refitted`] | functions for calibration and evaluation |
//!
//! The search, its vocabulary and its evidence are shared with a fit: `dashpot_estimation::structure`.

mod advice;
mod calibration;
mod changes;
mod composed;
mod decisions;
mod detection_limit;
mod diagnose;
mod effects;
pub mod groups;
mod hold_out;
mod identical;
mod improved;
mod name_of;
mod next_matrix;
mod opposite;
mod options;
mod outcome;
mod phrases;
mod plausible;
mod prepared;
mod proposed_test;
mod reference;
mod refitted;
mod regions;
mod rivals;
pub mod settings;
mod texts;
mod tree;
mod untestable;
mod verdict;
mod warmer;
mod wording;

pub use changes::Change;
pub use dashpot_estimation::structure::inventory::{InventoryItem, Status};
pub use diagnose::diagnose;
pub use effects::{CARDS, Card, EFFECTS, meaning};
pub use hold_out::choose as choose_left_out;
pub use options::{DiagnosisError, Options};
pub use outcome::*;
pub use refitted::{mean_cycles, refitted};
pub use texts::{templates, words};
pub use tree::Branch;
