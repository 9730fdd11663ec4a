//! One estimation problem for fit, validation and diagnosis.
//!
//! It has observations made from records, a model with free numbers and their priors, least squares, and the uncertainty of the numbers.
//!
//! | module | what |
//! |---|---|
//! | [`segment`] | the stretches of record that a fit works on |
//! | [`samples`] | the mean cycle of every test and the error that noise allows it |
//! | [`unknowns`] | which numbers are free, and the parameter set that a vector of them stands for |
//! | [`sensitivity`], [`curve_weights`] | forces of a model and their derivatives over the free numbers, in one run |
//! | [`as_read`] | the same as the rig read them: late, with a zero and a gain of its own |
//! | [`hypothesis`] | an explanation: a model with free numbers, and what the rig added |
//! | [`priors`] | what dampers show of each number before any record is seen |
//! | [`prior_set`] | what is known of one damper of each number |
//! | [`measurement`] | what the rig adds to a record that the damper did not do |
//! | [`heating`] | how warm the damper is in each test |
//! | [`least_squares`], [`refit`] | bounded, robust least squares |
//! | [`solve`] | bounded, robust least squares for any residuals |
//! | [`family`] | a damper at several settings as one problem |
//! | [`deviations`] | how far the records leave numbers open |
//! | [`curve_form`] | how far the curve between its points misses the records |
//! | [`spring_end`] | what the end of a lookup spring has beyond its middle: a stop that it has taken up |
//! | [`campaign_clock`] | whether the records were measured on one clock |
//! | [`warmth`] | between which temperatures they were measured |
//! | [`cancel`] | how long work is told to stop |
//! | [`gap`] | errors, and how much of the gap between model and noise is closed |

mod bleed;
pub mod campaign_clock;
pub mod cancel;
pub mod curve_form;
pub mod curve_part;
pub mod curve_weights;
pub mod deviations;
pub mod distribution;
pub mod family;
pub mod first_guess;
pub mod gap;
pub mod gram;
pub mod heating;
pub mod hypothesis;
pub mod log_prior;
pub mod measurement;
pub mod prior_set;
pub mod priors;
pub mod refit;
pub mod samples;
pub mod scale;
pub mod segment;
pub mod sensitivity;
#[cfg(test)]
mod sines;
pub mod situation;
pub mod solve;
pub mod spring_end;
pub mod step_at_rest;
pub mod structure;
pub mod unknowns;
pub mod vocabulary;
pub mod warmth;
