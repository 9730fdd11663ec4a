//! A damper measured at several settings, as one estimation problem.
//!
//! At every setting, the family is an ordinary damper, so each setting has the residuals of an ordinary
//! [`crate::hypothesis::Hypothesis`]. A free parameter either has one value for all settings, or one value at each
//! setting. The structure of the family includes this choice.
//!
//! | module | contents |
//! |---|---|
//! | [`problem`] | the hypothesis of a family, its residuals and its refit |
//! | [`pattern`] | parameters that may depend on the setting, and the prior odds of such a dependence |
//! | [`structure`] | a refitted family with its effects and its log posterior |
//! | [`prediction`] | first-order estimate of a family in which other parameters depend on the setting, without a refit |
//! | [`template`] | a family made from a structure that was found at one setting |
//! | [`search`] | the search for effects and for parameters that depend on the setting |
//! | [`alternatives`] | families that remain probable in addition to the most probable one |
//! | [`command_time`] | the instant within a sample at which a command changes |
//! | [`response`] | simulation of the damper under a changing setting |
//! | [`actuator`] | the estimation problem of the actuator that moves the valve of an adjustable damper |
//! | [`actuator_search`] | the search for the most probable parts of the actuator: lag, dead time, rate limit, hysteresis |

pub mod actuator;
pub mod actuator_search;
pub mod alternatives;
pub mod command_time;
pub mod pattern;
pub mod prediction;
pub mod problem;
pub mod response;
pub mod search;
pub mod structure;
pub mod template;
