//! A damper measured at several settings, as one estimation problem.
//!
//! At every setting the family is an ordinary damper, so each setting has the residuals of an ordinary [`crate::hypothesis::Hypothesis`]. A
//! free number is either shared by all settings or has a value at each of them; which of the two is part of the structure.
//!
//! | module | what |
//! |---|---|
//! | [`problem`] | the hypothesis of a family, its residuals and its refit |
//! | [`pattern`] | which numbers may depend on the setting, and how probable that is beforehand |
//! | [`structure`] | a refitted family with its effects and its log posterior |
//! | [`prediction`] | first-order estimate of a family with other shared numbers |
//! | [`template`] | a family made of a structure that was found at one setting |
//! | [`search`] | the search for effects and for numbers that depend on the setting |
//! | [`command_time`] | when within a sample a command changes |
//! | [`response`] | the damper under a setting that changes |
//! | [`actuator`] | its actuator as an estimation problem |
//! | [`actuator_search`] | the search for the parts of the actuator |

pub mod actuator;
pub mod actuator_search;
pub mod command_time;
pub mod pattern;
pub mod prediction;
pub mod problem;
pub mod response;
pub mod search;
pub mod structure;
pub mod template;
