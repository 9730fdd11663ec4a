//! Estimation problem that fit, validation and diagnosis share.
//!
//! The problem consists of observations from records, a model with free parameters and priors, least squares, and the
//! uncertainty of the parameters.
//!
//! | module | contents |
//! |---|---|
//! | [`segment`] | the parts of a record that a fit uses |
//! | [`samples`] | the samples of every test, as a rule its mean cycle, and their allowed errors |
//! | [`unknowns`] | free parameters of the model, and the parameter set for a vector of their values |
//! | [`sensitivity`], [`curve_weights`] | forces of a model and their derivatives with respect to the free parameters, with few simulations |
//! | [`hypothesis`] | a model with free parameters, and the measurement errors of the rig |
//! | [`priors`] | prior of each parameter over all dampers |
//! | [`prior_set`] | priors of one damper |
//! | [`prior_range`] | range of each parameter over dampers and rigs |
//! | [`measurement`] | measurement errors that the rig adds to a record |
//! | [`heating`] | temperature of the damper in each test |
//! | [`solve`], [`refit`] | bounded, robust least squares for any residuals; refits of a hypothesis |
//! | [`family`] | a damper at several settings as one problem |
//! | [`structure`], [`vocabulary`] | search for the most probable effects of a model; the effects that it may add |
//! | [`first_guess`], [`situation`] | quantities of tests and model from which start values follow |
//! | [`deviations`] | uncertainty of the parameters |
//! | [`curve_form`] | error of the curve between its points |
//! | [`spring_end`] | excess force at the end of a lookup spring, due to a stop that the spring represents |
//! | [`campaign_clock`] | whether the records share one clock |
//! | [`warmth`] | range of temperatures of the records |
//! | [`cancel`] | cancellation of long work |
//! | [`gap`] | errors; the fraction by which the final model reduces the difference between the first model's error and the noise |

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
pub mod prior_range;
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
