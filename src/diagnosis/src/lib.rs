//! Diagnosis: where a model and the records of its damper disagree, which physical effect is missing, and what is left
//! when it is added.
//!
//! | file | step |
//! |---|---|
//! | [`mod@diagnose`] | all of it, from end to end |
//! | [`prepared`] | records made ready |
//! | [`effects`] | one card an effect: where it acts, what shows it |
//! | [`composed`], [`outcome`] | the answer in words and figures |
//! | [`rivals`] | what got no name but explains a part |
//! | [`decisions`], [`calibration`] | every number that decides, and what a probability is worth |
//! | [`tree`] | all probabilities: path, family, effect, form |
//! | [`phrases`] | every text that it says, in English |
//! | [`regions`] | where model and records disagree |
//! | [`reference`], [`changes`] | the form error that two dampers share, and what changed between them |
//! | [`groups`] | many dampers, each against the same reference |
//! | [`settings`] | one damper at several settings: what all of them show, and what only some do |
//! | [`opposite`], [`warmer`] | how the two campaigns differ beside the damper |
//! | [`untestable`], [`next_test`] | what these records cannot show, and which test would |
//! | [`mod@refitted`] | for those who calibrate and evaluate |
//!
//! The search itself, its vocabulary and its evidence are those of a fit: `dashpot_estimation::structure`.

mod calibration;
mod changes;
mod composed;
mod decisions;
mod diagnose;
mod effects;
pub mod groups;
mod hold_out;
mod identical;
mod improved;
mod name_of;
mod next_matrix;
mod next_test;
mod opposite;
mod options;
mod outcome;
mod phrases;
mod prepared;
mod reference;
mod refitted;
mod regions;
mod rivals;
pub mod settings;
mod texts;
mod tree;
mod untestable;
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
