//! Diagnosis: where a model and the records of its damper disagree, which physical effect is missing, and what is left
//! when it is added.
//!
//! | file | step |
//! |---|---|
//! | [`mod@diagnose`] | all of it, from end to end |
//! | [`prepared`], [`situation`] | records and model made ready, and what the tests show |
//! | [`effects`] | one card an effect: where it acts, what shows it |
//! | [`vocabulary`] | the forms of each effect, with their numbers and starts |
//! | [`screening`], [`race`] | every form of every effect refitted from several starts, in heats |
//! | [`edges`], [`unbent`], [`extend`], [`nearby`] | what those refits need |
//! | [`finer_curve`] | more points on the FV curve, where that is all that is missing |
//! | [`evidence`], [`decisions`] | how strongly the records speak for an explanation, and every number that decides |
//! | [`round`] | one look at what is left |
//! | [`search`] | adding, pairs, weighing each name with the others in |
//! | [`calibration`] | what a probability of that rule is worth |
//! | [`tree`] | all probabilities: path, family, effect, form |
//! | [`answer`], [`composed`], [`outcome`] | the answer in words and figures |
//! | [`phrases`] | every text that it says, in English |
//! | [`regions`] | where model and records disagree |
//! | [`reference`] | what changed against the same tests on a good damper |
//! | [`groups`] | many dampers, each against the same reference |
//! | [`opposite`], [`warmer`] | how the two campaigns differ beside the damper |
//! | [`untestable`], [`next_test`] | what these records cannot show, and which test would |
//! | [`mod@first_look`], [`mod@refitted`] | for those who calibrate and prove |

mod answer;
mod calibration;
mod changes;
mod composed;
mod decisions;
mod diagnose;
mod edges;
mod effects;
mod evidence;
mod extend;
mod finer_curve;
mod first_look;
pub mod groups;
mod hold_out;
mod improved;
mod name_of;
mod nearby;
mod next_matrix;
mod next_test;
mod opposite;
mod options;
mod outcome;
mod phrases;
mod prepared;
mod race;
mod reference;
mod refitted;
mod regions;
mod round;
mod screening;
mod search;
mod situation;
mod texts;
mod tree;
mod unbent;
mod untestable;
mod vocabulary;
mod warmer;

pub use changes::{Change, CurveMoved, MovedBy};
pub use diagnose::diagnose;
pub use effects::{CARDS, Card, EFFECTS, meaning};
pub use first_look::{Looked, first_look};
pub use hold_out::choose as choose_held_out;
pub use options::{DiagnosisError, Options};
pub use outcome::*;
pub use phrases::templates;
pub use refitted::{mean_cycles, refitted};
pub use texts::texts;
pub use tree::Branch;
